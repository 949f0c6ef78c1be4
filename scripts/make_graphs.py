"""
Draw the graph of each mission into its page in docs/missions again, from its diagram.

    ./rvd shell python scripts/make_graphs.py
"""

from pathlib import Path
import re

from rvd_dynamics.diagram.drawn import flow_chart
from rvd_dynamics.diagram.scenario import parse

PAGES = Path(__file__).resolve().parents[1] / 'docs' / 'missions'
CHART = re.compile(r'(?<=```mermaid\n).*?(?=```)', re.S)


def page(path: Path) -> str:
    """Return the text of a mission's page with its graph as the diagram of the defaults has it."""
    scenario = parse(f'/**: {{ros__parameters: {{mission: {path.stem}}}}}', path.stem)
    chart = flow_chart(scenario.diagram)
    return CHART.sub(lambda _: chart, path.read_text(encoding='utf-8'))


if __name__ == '__main__':
    for page_path in sorted(PAGES.glob('*.md')):
        page_path.write_text(page(page_path), encoding='utf-8')
