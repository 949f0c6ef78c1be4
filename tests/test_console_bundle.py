"""The page that ships is the one that its sources make, small, and asks no third party."""

import re
import subprocess
from pathlib import Path

import pytest
from console_page import npm
from runs import ROOT

WEB = ROOT / 'ros2_ws/src/rvd_groundstation/console_web'
SHIPPED = ROOT / 'ros2_ws/src/rvd_groundstation/rvd_groundstation/console/static'
MOST_BYTES = 1_000_000


def files_of(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob('*') if p.is_file()}


@pytest.mark.slow
@pytest.mark.patient
def test_the_shipped_bundle_is_what_the_sources_build(console_web, tmp_path):
    built = tmp_path / 'built'
    done = subprocess.run([npm(), 'run', 'build', '--', '--outDir', str(built)], cwd=console_web,
                          capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    new, shipped = files_of(built), files_of(SHIPPED)
    assert new.keys() == shipped.keys()
    stale = [name for name in new if new[name] != shipped[name]]
    assert stale == [], 'the shipped page is stale: npm run build in console_web and commit'


def test_the_page_is_under_a_megabyte():
    assert sum(map(len, files_of(SHIPPED).values())) < MOST_BYTES


def test_the_page_loads_nothing_from_elsewhere():
    for name, content in files_of(SHIPPED).items():
        if name.endswith(('.html', '.css')):
            text = content.decode()
            assert not re.search(r'(src|href)="(https?:)?//|@import|url\((https?:)?//', text), name
            assert not re.search(r'<script(?![^>]*src=)|\sstyle="|\son\w+="', text), name


def test_the_lock_names_no_registry():
    assert 'resolved' not in (WEB / 'package-lock.json').read_text()


def test_words_of_the_page_stand_in_one_file():
    page = (WEB / 'index.html').read_text()
    words = re.sub(r'<title>.*?</title>|<!.*?>|<[^>]*>|–|\s', '', page, flags=re.DOTALL)
    assert words == ''
