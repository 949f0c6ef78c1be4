"""
A diagram as a picture: the text of a Mermaid flow chart, which GitHub and most editors draw.
"""

from rvd_dynamics.diagram.block import SEGMENTS
from rvd_dynamics.diagram.diagram import Diagram

TITLES = {'world': 'world', 'onboard': 'on board', 'link': 'link', 'ground': 'ground',
          'watch': 'watch'}


def flow_chart(diagram: Diagram) -> str:
    """Return the nodes of a diagram by segment, and the topics that they exchange."""
    lines = ['flowchart LR']
    nodes = [block for block in diagram.blocks if block.in_graph]
    for segment in SEGMENTS:
        of_segment = [block.name for block in nodes if block.segment == segment]
        if of_segment:
            lines += [f'  subgraph {TITLES[segment]}', *(f'    {name}' for name in of_segment),
                      '  end']
    for block in nodes:
        for read in block.reads.values():
            writer = diagram.writer_of.get(read.signal.name)
            if writer is not None:
                late = f', {read.delay} step before' if read.delay else ''
                arrow = '-.->' if read.delay else '-->'
                lines.append(f'  {writer.name} {arrow}|"{read.signal.name}{late}"| {block.name}')
    return '\n'.join(lines) + '\n'
