"""
What other campaigns say of the same conditions, kept in a file and shown beside a campaign's own.

    ./rvd shell python -m rvd_campaign.campaign.beside FOLDER --out beside/pilots.yaml

keeps, of a finished campaign: with a sample, the bands of its results (`ensemble`); with
replicates, the design effect of each condition, by how much flights in clusters of so many of the
same person are worth less than independent ones. A campaign file then says

    beside:
      beside/pilots.yaml: {A manual: manual, A shared: shared}      # condition here: there

A row of `reference` whose condition is named there, and that has no `design_effect` of its own,
takes the one in the file. Every number so shown keeps the result hash that it comes from.
"""

import argparse
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from rvd_campaign.campaign import stats
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.scenario import nearest
from rvd_dynamics.given import has_shape, mapping_of, object_of, text_of
from rvd_dynamics.recording import whole

REAL = (int, float)
OF_A_FILE = {'campaign': str, 'result_hash': str, 'words': str, 'bands?': {'': [REAL, 3]},
             'design_effect?': {'': REAL}}
SHAPE = [{'campaign': str, 'result_hash': str, 'words': str, 'bands?': {'': [REAL, 3]},
          'design_effect?': {'': REAL}, 'conditions': {'': str}}]   # names here
OF_A_CONDITION = {'runs_per_person?': int, 'clustered95?': [REAL, 2], 'band?': [REAL, 3]}
OF_A_SUMMARY: dict[str, Any] = {
    'reference?': {'': {'wilson95': [REAL, 2], 'clustered95?': [REAL, 2],
                        'design_effect?': REAL}},
    'beside?': [{'campaign': str, 'result_hash': str, 'words': str, 'bands': bool}]}
READ = {                                # of a summary
    'campaign': str, 'result_hash': str,
    'ensemble?': {'latin_hypercube': int, 'bands': [{'output': str, 'all': [REAL, 3]}],
                  'accepted': (dict, type(None))},
    'replicates?': {'count': int, 'operators': int, 'runs': int, 'design_effect?': dict}}
DIGITS = 6


def parsed(given: Any, folder: Path, names: Iterable[str]) -> list[dict[str, Any]]:
    """
    Return what `beside:` of a campaign file names, read and by the names of this campaign.

    Parameters
    ----------
    given : Any
        As it was read; None is nothing.
    folder : Path
        In which the campaign file lies.
    names : iterable of str
        Conditions of the campaign.

    Raises
    ------
    ValueError
        If a file is none of ours, or a condition is unknown here or there; one line.
    """
    if given is None:
        return []
    if not isinstance(given, dict) or not all(
            isinstance(file, str) and isinstance(pairs, dict) and pairs
            and all(isinstance(name, str) for name in (*pairs, *pairs.values()))
            for file, pairs in given.items()):
        raise BadInput('beside must map files to {condition here: condition there}, '
                       f'got {given!r}')
    return [_of(folder / file, pairs, list(names)) for file, pairs in given.items()]


def _of(path: Path, pairs: Mapping[str, str], names: list[str]) -> dict[str, Any]:
    kept = mapping_of(text_of(path, 'file of results'), f'beside {path.name}')
    if not has_shape(kept, OF_A_FILE):
        raise BadInput(f'beside: {path.name} holds no results that '
                       'python -m rvd_campaign.campaign.beside kept')
    bands, effects = kept.get('bands', {}), kept.get('design_effect', {})
    for here, there in pairs.items():
        if here not in names:
            raise BadInput(f'beside: no condition {here!r}' + nearest(here, names))
        if there not in bands and there not in effects:
            raise BadInput(f'beside: {path.name} has no {there!r}'
                           + nearest(there, [*bands, *effects]))
    return {**kept, 'conditions': dict(pairs)}


def band(kept: Sequence[dict[str, Any]], a: str, b: str = '') -> list[float] | None:
    """Return lowest, middle and highest of the success rate of a, or of a minus b, if known."""
    for one in kept:
        there = one['conditions']
        if a in there and (not b or b in there):
            name = f'{there[a]} minus {there[b]}' if b else there[a]
            if name in one.get('bands', {}):
                return list(one['bands'][name])
    return None


def design_effect(kept: Sequence[dict[str, Any]], name: str) -> float | None:
    """Return the design effect of the condition's flights, if known."""
    for one in kept:
        found = one.get('design_effect', {}).get(one['conditions'].get(name))
        if found is not None:
            return max(float(found), 1.0)
    return None


def with_design_effects(reference: dict[str, dict], kept: Sequence[dict[str, Any]]
                        ) -> dict[str, dict]:
    """Return the rows of people's data, each with the design effect of its condition if known."""
    made = {}
    for label, row in reference.items():
        effect = design_effect(kept, row.get('condition', ''))
        made[label] = {'design_effect': effect, **row} if effect is not None else row
    return made


def add(summary: dict[str, Any], kept: Sequence[dict[str, Any]], reference: dict[str, dict]
        ) -> None:
    """Add to a summary what is shown beside its own: bands, people's data, where both come from."""
    for row in (*summary['conditions'], *summary['differences']):
        found = band(kept, row['a'], row['b']) if 'a' in row else band(kept, row['name'])
        if found:
            row['band'] = found
    if reference:
        summary['reference'] = {label: _of_people(row) for label, row in reference.items()}
    if kept:
        summary['beside'] = [{**{key: one[key] for key in ('campaign', 'result_hash', 'words')},
                              'bands': 'bands' in one} for one in kept]


def _of_people(row: dict[str, Any]) -> dict[str, Any]:
    runs, successes, effect = row['runs'], row['successes'], row.get('design_effect')
    made = {'runs': runs, 'successes': successes, 'wilson95': list(stats.wilson(successes, runs))}
    return made if effect is None else {
        **made, 'design_effect': effect,
        'clustered95': list(stats.of_design_effect(successes, runs, effect))}


def in_clusters(summary: Mapping[str, Any]) -> bool:
    """Say whether anybody in the table, of the model or of the data, flies more than once."""
    return any(c.get('runs_per_person', 1) > 1 for c in summary['conditions']) or any(
        'clustered95' in row for row in summary.get('reference', {}).values())


def in_words(summary: Mapping[str, Any]) -> list[str]:
    """Return the intervals over people and the bands as lines of text."""
    rows = [(c['name'], c) for c in summary['conditions']]
    if in_clusters(summary):
        rows += list(summary.get('reference', {}).items())
    rows += [(f'{d["a"]} - {d["b"]}', d) for d in summary['differences'] if 'band' in d]
    shown = [(name, row) for name, row in rows if 'band' in row or (
        in_clusters(summary) and 'clustered95' in row)]
    if not shown:
        return []
    width = max(len(name) for name, _ in shown)
    clusters, extent = '95 %, over people', 'band'
    lines = [f'{"":<{width}}  {clusters:<18}  {extent}'.rstrip()]
    for name, row in shown:
        interval = row.get('clustered95') if in_clusters(summary) else None
        said = f'[{interval[0]:.4f}, {interval[1]:.4f}]' if interval else ''
        found = f'{row["band"][0]:.4f} to {row["band"][2]:.4f}' if 'band' in row else ''
        lines.append(f'{name:<{width}}  {said:<18}  {found}'.rstrip())
    return lines + sources(summary)


def sources(summary: Mapping[str, Any]) -> list[str]:
    """Return where bands and design effects come from, in sentences."""
    return [f'{"Bands, lowest to highest" if one["bands"] else "Design effects"}: campaign '
            f'{one["campaign"]}, {one["words"]} (result hash {one["result_hash"]}).'
            for one in summary.get('beside', ())]


def of_summary(summary: Mapping[str, Any]) -> dict[str, Any]:
    """
    Return what is kept of a campaign's summary.

    Raises
    ------
    ValueError
        If the campaign has neither a sample with bands nor replicates.
    """
    made = {'campaign': summary['campaign'], 'result_hash': summary['result_hash']}
    sampled, repeated = summary.get('ensemble'), summary.get('replicates', {})
    if sampled and sampled['bands']:
        chosen = sampled['accepted']
        which = 'all' if chosen is None else 'accepted'
        made['words'] = f'{sampled["latin_hypercube"]} points of a sample' if chosen is None else (
            f'{len(chosen["points"])} of {sampled["latin_hypercube"]} points of a sample, those '
            f'that agree with {chosen["reference"]} within {chosen["standard_errors"]:g} standard '
            'errors')
        made['bands'] = {b['output']: [round(v, DIGITS) for v in b[which]]
                         for b in sampled['bands'] if b[which]}
    elif repeated.get('design_effect'):
        made['words'] = (f'{repeated["count"]:,} experiments of {repeated["operators"]} people '
                         f'with {repeated["runs"]} flights each')
        made['design_effect'] = {name: round(value, DIGITS) for name, value in
                                 repeated['design_effect'].items() if value is not None}
    else:
        raise BadInput(f'campaign {summary["campaign"]} has neither a sample with a '
                       'latin_hypercube nor replicates: nothing to keep')
    return made


def main(arguments: list[str] | None = None) -> int:
    """Write the file; return the exit code."""
    parser = argparse.ArgumentParser(description='Keep what a campaign says for other campaigns.')
    parser.add_argument('folder', type=Path, help='of a finished campaign')
    parser.add_argument('--out', required=True, type=Path, help='file to write, must not exist yet')
    args = parser.parse_args(arguments)
    try:
        path = args.folder / 'summary.json'
        summary = object_of(path, 'summary of a campaign')
        if not has_shape(summary, READ):
            raise BadInput(f'{path} is no summary of this version: make it again with '
                           f'./rvd campaign --resume {args.folder}')
        text = yaml.safe_dump(of_summary(summary), sort_keys=False, width=90, allow_unicode=True)
        if args.out.exists():
            raise BadInput(f'--out {args.out} exists: nothing is overwritten, give another name')
        print(whole.save(args.out, '# Written by python -m rvd_campaign.campaign.beside.\n' + text))
    except (BadInput, OSError) as error:
        print(f'beside: {error}', file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main())
