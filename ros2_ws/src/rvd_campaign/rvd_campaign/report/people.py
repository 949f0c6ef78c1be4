"""
`./rvd report SESSION`: success and measures of real people's flights, and what they felt.

Reads the folders that the console's experiment desk leaves: `session.json`, and for each
volunteer and flight `verdict.json` and `ratings.json`. Training flights do not count. A flight
that was flown and not rated, or broken off, is counted as such and left out of the table, and so
is one whose condition was broken, which stands in `flights.csv` with the reason.
"""

import csv
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from statistics import mean, median, stdev
from typing import Any

from rvd_campaign.campaign.stats import clustered
from rvd_campaign.report import people_figures
from rvd_campaign.report.page import render
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import judge_of
from rvd_dynamics.diagram.judge import declared
from rvd_dynamics.diagram.mission import find, installed
from rvd_dynamics.diagram.run import DEFAULT_MISSION
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.given import object_of
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.worded import worded
from rvd_groundstation.console.desk import RATINGS, WEIGHTS

SESSION = 'session.json'
BEFORE = ('volunteer', 'number', 'condition', 'mode', 'training', 'seed', 'reason', 'success',
          'duration_s')                 # columns of a flight, then its measures, then these
AFTER = ('cooper_harper', 'tlx', 'tlx_weighted', 'counted', 'why')
MODES = {'manual': 'manual control', 'shared': 'shared control', 'auto': 'automatic control'}


@dataclass(frozen=True)
class Condition:
    """What the flights of one condition came to."""

    name: str
    flights: int
    successes: int
    interval: tuple[float, float] | None        # 95 % over volunteers; None for a single one
    means: dict[str, float]             # over successes, of the measures known in any
    cooper_harper: tuple                # median, lowest, highest
    tlx: tuple                          # mean, standard deviation (None for one flight)
    tlx_weighted: tuple | None          # likewise; None where weights were not asked for


def write_session_report(folder: Path) -> Path:
    """
    Write `flights.csv` and `report.html` of a session; return the latter's path.

    Raises
    ------
    ValueError
        If no rated flight is in it.
    """
    session = _object(folder / SESSION)
    if not isinstance(session.get('conditions'), dict) or 'title' not in session:
        raise BadInput(f'{folder / SESSION} is damaged: it has no title or no conditions')
    flights, left_out = read_flights(folder)
    if not any(not flight['training'] for flight in flights):
        raise BadInput(f'session {folder} has no rated flight yet')
    rows = StringIO()
    writer = csv.DictWriter(rows, [*BEFORE, *_measures(flights), *AFTER], lineterminator='\r\n')
    writer.writeheader()
    broken = not_counted(folder)
    writer.writerows([{'counted': not flight['training'], **flight} for flight in flights]
                     + [{name: row.get(name) for name in writer.fieldnames} for row in broken])
    whole.save(folder / 'flights.csv', rows.getvalue())
    table = conditions(flights, list(session['conditions']))
    return whole.save(folder / 'report.html',
                _page(session, table, flights, left_out, _known(folder), broken))


def read_flights(folder: Path) -> tuple[list[dict[str, Any]], int]:
    """Return a row per rated flight, training too, and how many flights are not rated."""
    rows, left_out = [], 0
    for file in sorted(folder.glob('P*/*/verdict.json')):
        verdict = _object(file)
        ratings_file = file.with_name(RATINGS)
        if not ratings_file.is_file():
            left_out += 1
            continue
        ratings = _object(ratings_file)
        if ratings.get('why'):                  # it has no rating, but a reason
            continue
        try:
            rows.append(_flown(file, verdict, ratings))
        except (KeyError, TypeError) as error:
            raise _damaged(file, error) from None
    return rows, left_out


def not_counted(folder: Path) -> list[dict[str, Any]]:
    """Return a row per flight whose condition was broken: what is known of it, and why."""
    rows = []
    for file in sorted(folder.glob(f'P*/*/{RATINGS}')):
        ratings, verdict_file = _object(file), file.with_name('verdict.json')
        if not ratings.get('why') or not verdict_file.is_file():
            continue
        try:
            rows.append({**_known_of(_object(verdict_file), ratings), 'counted': False,
                         'why': ratings['why']})
        except (KeyError, TypeError) as error:
            raise _damaged(file, error) from None
    return rows


def _damaged(file: Path, error: Exception) -> BadInput:
    return BadInput(f'{file.parent}: verdict.json or {RATINGS} is damaged: {error!r}: mend '
                    'it, or move the folder out of the session')


def _object(file: Path) -> dict[str, Any]:
    """Return what a JSON file of a session holds, or refuse it by its name."""
    return object_of(file, 'part of a session')


def _flown(file: Path, verdict: dict[str, Any], ratings: dict[str, Any]) -> dict[str, Any]:
    return {
        **_known_of(verdict, ratings),
        'cooper_harper': ratings['cooper_harper']['rating'], 'tlx': ratings['tlx']['mean'],
        'tlx_weighted': _weighted(ratings, file.parent.parent)}


def _known_of(verdict: dict[str, Any], ratings: dict[str, Any]) -> dict[str, Any]:
    """Return what is known of a flight whether it counts or not."""
    return {
        **{key: ratings[key] for key in ('volunteer', 'number', 'condition', 'mode',
                                         'training', 'seed')},
        'reason': verdict['reason'], 'success': verdict['success'],
        'duration_s': verdict.get('duration_s'),
        **{name: m['value'] for name, m in verdict.get('measures', {}).items()}}


def _known(folder: Path) -> dict[str, dict[str, Any]]:
    """Return words, unit and digits of the measures of those missions flown that are installed."""
    missions = {_object(file).get('mission', DEFAULT_MISSION)
                for file in folder.glob('P*/*/verdict.json')}
    return {name: said for mission in sorted(missions & set(installed())) for name, said in
            declared(judge_of(Scenario(mission, find(mission), {})).measures).items()}


def _measures(flights: list[dict[str, Any]]) -> list[str]:
    """Return the names of all measures, in the order of the verdicts."""
    return list(dict.fromkeys(key for flight in flights for key in flight
                              if key not in (*BEFORE, *AFTER)))


def _weighted(ratings: dict[str, Any], volunteer: Path) -> float | None:
    """Return the weighted workload of a flight; None where the pairs were not asked for."""
    file = volunteer / WEIGHTS
    asked = _object(file) if file.is_file() else {}
    weights = asked.get(ratings['condition'])
    if weights is None:
        return None
    return sum(weights[scale] * ratings['tlx'][scale] for scale in weights) / sum(weights.values())


def conditions(flights: list[dict[str, Any]], names: list[str]) -> list[Condition]:
    """Return the table: one entry per condition that has flights that count."""
    made = []
    for name in names:
        rows = [f for f in flights if f['condition'] == name and not f['training']]
        if not rows:
            continue
        good = [f for f in rows if f['success']]
        ratings = [f['cooper_harper'] for f in rows]
        made.append(Condition(
            name, len(rows), len(good), clustered(_counts(rows)), _means(good),
            (median(ratings), min(ratings), max(ratings)),
            _spread([f['tlx'] for f in rows]),
            _spread([f['tlx_weighted'] for f in rows if f['tlx_weighted'] is not None])))
    return made


def _counts(rows: list[dict[str, Any]]) -> list[tuple[int, int]]:
    """Return successes and flights of each volunteer."""
    who = sorted({f['volunteer'] for f in rows})
    own = [[f['success'] for f in rows if f['volunteer'] == name] for name in who]
    return [(sum(flown), len(flown)) for flown in own]


def _in_words(session: dict[str, Any]) -> dict[str, str]:
    """Return the words for each condition: its name, and its mode where that is another one."""
    said = {}
    for name, mode in session['conditions'].items():
        flown = MODES.get(str(mode), worded(str(mode)))
        alike = flown.startswith(worded(name))          # 'automatic' of automatic control
        said[name] = flown if alike else f'{worded(name)} ({flown})'
    return said


def _spread(load: list[float]) -> tuple | None:
    """Return mean and standard deviation of workloads; None where there is none."""
    if not load:
        return None
    return mean(load), stdev(load) if len(load) > 1 else None


def pairs(flights: list[dict[str, Any]], first: str, second: str) -> tuple[int, int, int, int]:
    """
    Return how flights of one volunteer with one seed went in two conditions.

    The numbers are: both succeeded, only the first, only the second, neither.
    """
    of = {name: {(f['volunteer'], f['seed']): f['success'] for f in flights
                 if f['condition'] == name and not f['training']} for name in (first, second)}
    both = [(of[first][key], of[second][key]) for key in of[first].keys() & of[second].keys()]
    return (both.count((True, True)), both.count((True, False)), both.count((False, True)),
            both.count((False, False)))


def _means(rows: list[dict[str, Any]]) -> dict[str, float]:
    """Return the mean of each measure that is known in any of the flights."""
    known = {name: [row[name] for row in rows if row.get(name) is not None]
             for name in _measures(rows)}
    return {name: mean(values) for name, values in known.items() if values}


def _number(value: float | None, digits: int) -> str:
    return '–' if value is None else f'{value:.{digits}f}'


def _row(c: Condition, words: str, measures: dict[str, dict[str, Any]], weighted: bool
         ) -> list[str | tuple[str, str]]:
    interval = '' if c.interval is None else f'[{c.interval[0]:.2f}, {c.interval[1]:.2f}]'
    cells = [words, str(c.flights), (f'{c.successes / c.flights:.2f}', interval),
             *(_number(c.means.get(name), m['digits']) for name, m in measures.items()),
             f'{c.cooper_harper[0]:g} ({c.cooper_harper[1]}–{c.cooper_harper[2]})', _load(c.tlx)]
    return [*cells, _load(c.tlx_weighted or (None, None))] if weighted else cells


def _tabled(table: list[Condition], known: dict[str, dict[str, Any]]
            ) -> dict[str, dict[str, Any]]:
    """Return words, unit and digits of each measure that the table has means of."""
    names = dict.fromkeys(name for condition in table for name in condition.means)
    return {name: known.get(name, {'words': name, 'unit': '', 'digits': 4}) for name in names}


def _load(spread: tuple) -> str:
    return _number(spread[0], 1) + ('' if spread[1] is None else f' ± {spread[1]:.1f}')


def _page(session: dict[str, Any], table: list[Condition], flights: list[dict[str, Any]],
          left_out: int, known: dict[str, dict[str, Any]], broken: list[dict[str, Any]]) -> str:
    compared, words = None, _in_words(session)
    if len(table) == 2:
        first, second = table[0].name, table[1].name
        both, only_first, only_second, neither = pairs(flights, first, second)
        compared = {'first': words[first], 'second': words[second], 'both': both,
                    'only_first': only_first, 'only_second': only_second, 'neither': neither}
    weighted = any(c.tlx_weighted is not None for c in table)
    measures = _tabled(table, known)
    return render(
        'people.html.j2', title=session['title'], note=session.get('note', ''),
        volunteers=len({f['volunteer'] for f in flights}), flights=len(flights),
        left_out=left_out, weighted=weighted, pairs=compared, broken=[
            (f['volunteer'], str(f['number']), words.get(f['condition'], f['condition']), f['why'])
            for f in broken],
        heads=['condition', 'flights', ('success', '95 %'),
               *((m['words'], m['unit']) for m in measures.values()), 'Cooper-Harper', 'NASA-TLX',
               *(['NASA-TLX, weighted'] if weighted else [])],
        summary=[(words[c.name], c.successes, c.flights) for c in table],
        figures=people_figures.drawn(flights, words),
        rows=[_row(c, words[c.name], measures, weighted) for c in table])
