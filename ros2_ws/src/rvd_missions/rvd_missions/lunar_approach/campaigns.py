"""
What campaigns of the approach know besides runs and columns: the paper's numbers, the word
`pilot`, and what is said beside every table.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, Table 3.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import flatten
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_groundstation.operators.pilot import FIRST, keys_of, PERSONS

# Condition 1 of the paper (manual), to which pilots are fitted: successes, means over them.
PAPER_RUNS, PAPER_SUCCESSES = 100, 76
PAPER_MEANS = {'offset_m': 0.1444, 'lateral_rate_m_s': 0.0182}


def pilot(value: Any, folder: Path) -> dict[str, dict[str, Any]]:
    """
    Return the changes, by section, that a pilot's name or file means.

    A file is looked for in `folder`, that of the campaign file, then where the command runs.

    Raises
    ------
    ValueError
        If there is neither such a pilot nor such a file, or the file cannot be read.
    """
    if isinstance(value, str) and value in PERSONS:
        return {'operator_model': keys_of(PERSONS[value])}
    for path in (folder / str(value), Path(str(value))):
        if path.is_file():
            return {'operator_model': flatten(load(path).settings('operator_model'))}
    raise BadInput(f'no pilot {value!r}: give a file or one of {", ".join(PERSONS)}')


def notes(scenarios: Sequence[Scenario]) -> list[str]:
    """Say where the numbers of the model pilot come from, if he flies in any of the scenarios."""
    forms = {scenario.settings('operator_model').form for scenario in scenarios
             if scenario.part('operation').operator == 'model'}
    if not forms:
        return []
    model = ('a model with 28 parameters' if forms == {FIRST} else
             f'a model ({", ".join(sorted(forms))})')
    return [f'The pilot is {model}. Those that were fitted were fitted to three '
            'statistics of the paper\u2019s condition 1 (manual) and to nothing else; agreement '
            'elsewhere supports the paper but does not prove it.']
