"""The docs are true of the code: pages that are made from it, and the files that they point to."""

from pathlib import Path
import re
import runpy

import pytest
from runs import ROOT

GRAPHS = runpy.run_path(str(ROOT / 'scripts' / 'make_graphs.py'))
PAGES = sorted([*ROOT.glob('*.md'), *(ROOT / 'docs').rglob('*.md')])
LINK = re.compile(r'\]\((?!https?:|#)([^)#\s]+)')


@pytest.mark.parametrize('path', sorted(GRAPHS['PAGES'].glob('*.md')), ids=lambda p: p.stem)
def test_the_graph_of_a_mission_is_the_one_in_its_page(path):
    assert path.read_text(encoding='utf-8') == GRAPHS['page'](path), (
        './rvd shell python scripts/make_graphs.py')


@pytest.mark.parametrize('path', PAGES, ids=lambda p: str(p.relative_to(ROOT)))
def test_every_link_of_a_page_leads_somewhere(path):
    text = re.sub(r'```.*?```', '', path.read_text(encoding='utf-8'), flags=re.S)
    missing = [link for link in LINK.findall(text) if not (path.parent / Path(link)).exists()]
    assert not missing


@pytest.mark.parametrize('path', PAGES, ids=lambda p: str(p.relative_to(ROOT)))
def test_every_module_that_a_page_names_exists(path):
    named = re.findall(r'\brvd_(?:dynamics|groundstation|missions|campaign)(?:\.\w+)+',
                       path.read_text(encoding='utf-8'))
    for dotted in named:
        parts = dotted.split('.')
        places = [ROOT / 'ros2_ws' / 'src' / parts[0] / Path(*parts[:n])
                  for n in range(len(parts), 0, -1)]
        # the last word, or the last two, may be a name in the module
        assert any(p.with_suffix('.py').exists() or p.is_dir() for p in places[:3]), dotted
