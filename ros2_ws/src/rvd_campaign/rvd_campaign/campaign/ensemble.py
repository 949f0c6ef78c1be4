"""
What the points of a campaign's sample say: bands, those that agree with a reference, indices.

Output      success rate of each condition, and difference of each pair that the campaign compares,
            at each point: all points fly the same runs with the same draws.
Accepted    points of the Latin hypercube whose condition agrees with the reference in its success
            rate and in each mean that it gives, within so many standard errors of the reference:
            sqrt(p (1 - p)/runs), and the point's own deviation over the root of its successes.
Indices     first-order and total, by SALib with 95 % bootstrap intervals; A. Saltelli et al.,
            Comput. Phys. Commun. 181, 2010, 259-270.
Limits      a rate at a point is that of its runs: bands hold their noise, and the indices count it
            as interaction.
"""

from math import sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_campaign.campaign.checked import Campaign
from rvd_dynamics.diagram import streams

RESAMPLES = 500                         # of the bootstrap


def of_points(campaign: Campaign, rows: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """
    Return the summary of a sample.

    Parameters
    ----------
    campaign : Campaign
        With a sample.
    rows : dict
        Summaries of all conditions by name, those at points too.
    """
    sample = campaign.sample
    names = [c.name for c in campaign.conditions if c.point is None]
    at = {(c.base, c.point): rows[c.name] for c in campaign.conditions if c.point is not None}
    rates = {name: np.array([at[name, k]['success_rate'] for k in range(sample.count)])
             for name in names}
    outputs = {name: (rates[name], rows[name]['success_rate']) for name in names}
    for a, b in campaign.compare:
        outputs[f'{a} minus {b}'] = (
            rates[a] - rates[b], rows[a]['success_rate'] - rows[b]['success_rate'])
    accepted = accepted_points(campaign, at)
    cube = slice(0, sample.latin_hypercube)
    made = {
        **sample.as_dict(), 'groups': list(sample.groups),
        'points': [{'values': {n.name: c.changes[n.section][n.key] for n in sample.numbers},
                    'outputs': {name: float(found[c.point]) for name, (found, _) in
                                outputs.items()}}
                   for c in campaign.conditions if c.point is not None and c.base == names[0]],
        'accepted': None if accepted is None else {
            **campaign.accept, 'points': [int(k) for k in np.flatnonzero(accepted)]},
        'bands': [band(name, found[cube], accepted, fit) for name, (found, fit) in outputs.items()]
        if sample.latin_hypercube else [],
        'indices': []}
    if sample.sobol:
        made['indices'] = [index for name, (found, _) in outputs.items() for index in
                           indices(campaign, name, found[sample.latin_hypercube:])]
    return made


def accepted_points(campaign: Campaign, at: dict[tuple[str, int], dict[str, Any]]
                    ) -> NDArray[np.bool_] | None:
    """Return which points of the Latin hypercube agree with the reference; None: none is named."""
    if not campaign.accept:
        return None
    reference = campaign.reference[campaign.accept['reference']]
    limit, name = campaign.accept['standard_errors'], reference['condition']
    return np.array([misfit(at[name, k], reference) <= limit
                     for k in range(campaign.sample.latin_hypercube)], dtype=bool)


def misfit(row: dict[str, Any], reference: dict[str, Any]) -> float:
    """Return the largest difference of a condition from a reference [its standard errors]."""
    runs, successes = reference['runs'], reference['successes']
    p = successes / runs
    worst = abs(row['success_rate'] - p) / sqrt(p*(1.0 - p)/runs)
    for name, mean in reference.get('means', {}).items():
        deviation = row['standard_errors'][name] * sqrt(row['successes'])
        worst = max(worst, abs(row['means'][name] - mean) / (deviation/sqrt(successes)))
    return worst if np.isfinite(worst) else float('inf')        # NaN: too few successes


def band(name: str, found: NDArray, accepted: NDArray | None, fit: float) -> dict[str, Any]:
    """Return lowest, middle and highest of an output over all points and the accepted ones."""
    def extent(values: NDArray) -> list[float] | None:
        return [float(v) for v in np.quantile(values, [0.0, 0.5, 1.0])] if len(values) else None
    return {'output': name, 'fit': float(fit), 'all': extent(found),
            'accepted': None if accepted is None else extent(found[accepted])}


def indices(campaign: Campaign, name: str, found: NDArray) -> list[dict[str, Any]]:
    """Return the indices of an output, one for each group; unknown where it does not vary."""
    from SALib.analyze import sobol
    sample = campaign.sample
    if np.ptp(found) == 0.0:
        return [{'output': name, 'group': group, 'first': None, 'first95': None, 'total': None,
                 'total95': None} for group in sample.groups]
    seed = int(streams.generator(campaign.seed, 0, 'campaign/ensemble/bootstrap').integers(2**31))
    made = sobol.analyze(sample.problem, found, calc_second_order=False, num_resamples=RESAMPLES,
                         seed=seed)
    return [{'output': name, 'group': group, 'first': float(made['S1'][i]),
             'first95': float(made['S1_conf'][i]), 'total': float(made['ST'][i]),
             'total95': float(made['ST_conf'][i])} for i, group in enumerate(sample.groups)]


NUMBER = (int, float, type(None))
SHAPE: dict[str, Any] = {               # of what the report reads
    'latin_hypercube': int, 'sobol': int, 'groups': [str], 'numbers': [{'section': str}],
    'points': [{'outputs': {'': NUMBER}}],
    'bands': [{'output': str, 'fit': NUMBER}],
    'indices': [{'output': str, 'group': str, 'first': NUMBER, 'first95': NUMBER,
                 'total': NUMBER, 'total95': NUMBER}]}


def in_words(made: dict[str, Any]) -> list[str]:
    """Return the bands and indices as lines of text."""
    lines = []
    if made['bands']:
        chosen = made['accepted']
        width = max(len(b['output']) for b in made['bands'])
        within = '' if chosen is None else (
            f'; {len(chosen["points"])} of them agree with {chosen["reference"]} within '
            f'{chosen["standard_errors"]:g} standard errors')
        lines.append(f'{made["latin_hypercube"]} points of the sample{within}')
        lines.append(f'{"":<{width}}      fit  all points        those that agree')
        lines += [f'{b["output"]:<{width}}  {b["fit"]:7.4f}  {_extent(b["all"])}  '
                  f'{_extent(b["accepted"])}'.rstrip() for b in made['bands']]
    if made['indices']:
        lines.append('Sobol indices, first order and total, with 95 % intervals')
        width = max(len(i['group']) for i in made['indices'])
        for output in dict.fromkeys(i['output'] for i in made['indices']):
            lines.append(f'  {output}')
            lines += [f'    {i["group"]:<{width}}  {_index(i, "first")}  {_index(i, "total")}'
                      for i in made['indices'] if i['output'] == output]
    return lines


def _extent(values: list[float] | None) -> str:
    return '' if values is None else f'{values[0]:.4f} to {values[2]:.4f}'


def _index(index: dict[str, Any], which: str) -> str:
    value = index[which]
    return '-' if value is None else f'{value:6.3f} +- {index[which + "95"]:.3f}'
