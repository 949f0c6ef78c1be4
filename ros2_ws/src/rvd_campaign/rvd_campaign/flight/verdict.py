"""
The verdict of a run as people read it and as `verdict.json` keeps it.
"""

import json
import math
from pathlib import Path
from typing import Any

from rvd_dynamics.link.channel import LINK_COUNTS
from rvd_dynamics.mission import Mission
from rvd_dynamics.recording import whole

WORDS = {
    'docked': 'docked',
    'left_corridor': 'failed: left the corridor',
    'closing_rate': 'failed: closing rate out of limits at the docking plane',
    'offset': 'failed: lateral offset out of limits at the docking plane',
    'lateral_rate': 'failed: lateral rate out of limits at the docking plane',
    'timeout': 'failed: did not reach the docking plane in time',
    'invalid': 'failed: the true state became invalid',
    'interrupted': 'interrupted',
}
LINK_DELAYS = ('delay_p50', 'delay_p99', 'delay_max')


def as_dict(verdict: Any, links: dict[str, Any], mission: Mission, scenario: str,
            interrupted: bool = False) -> dict[str, Any]:
    """
    Return the content of `verdict.json`.

    Parameters
    ----------
    verdict : Verdict or None
        The last message on /run/verdict.
    links : dict
        The last LinkStatus of 'forward' and 'back'; one that never came is None.
    """
    made = {
        'success': bool(verdict is not None and verdict.final and verdict.success),
        'reason': 'interrupted' if interrupted or verdict is None else verdict.reason,
        'mode': mission.mode, 'operator': mission.operator, 'seed': mission.seed,
        'run': mission.run, 'scenario': scenario,
    }
    if verdict is not None:
        place = verdict.exit_position
        made.update({
            'duration_s': verdict.duration,
            'terminal': {'x_rate_m_s': verdict.x_rate, 'offset_m': verdict.offset,
                         'lateral_rate_m_s': verdict.lateral_rate},
            'min_corridor_margin_m': verdict.min_corridor_margin,
            'delta_v_m_s': verdict.delta_v,
            'exit': {'time_s': verdict.exit_time, 'position_m': [place.x, place.y, place.z]},
        })
    made['link'] = {name: link_dict(status) for name, status in links.items()}
    return unknown_as_none(made)


def link_dict(status: Any) -> dict[str, Any]:
    """Return the counts and delays of one LinkStatus."""
    if status is None:
        return {}
    made = {name: getattr(status, name) for name in LINK_COUNTS}
    made.update({f'{name}_s': getattr(status, name) for name in LINK_DELAYS})
    return made


def unknown_as_none(value: Any) -> Any:
    """Return nested data with NaN, which JSON does not know, as null."""
    if isinstance(value, dict):
        return {key: unknown_as_none(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [unknown_as_none(inner) for inner in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def write(path: Path, content: dict[str, Any]) -> None:
    """Write `verdict.json` whole or not at all."""
    whole.write_text(path, json.dumps(content, indent=2) + '\n')


def read(path: Path) -> dict[str, Any]:
    """Read `verdict.json`."""
    return json.loads(path.read_text(encoding='utf-8'))


def in_words(content: dict[str, Any], mission: Mission) -> str:
    """Return the verdict in a few lines."""
    words = WORDS.get(content['reason'], content['reason'])
    if content.get('duration_s') is None:
        return words
    lines = [f'{words} after {content["duration_s"]:.1f} s']
    end, limits = content['terminal'], mission.docking
    if end['x_rate_m_s'] is not None:
        lines.append(
            f'  at the docking plane: closing rate {end["x_rate_m_s"]:.4f} m/s '
            f'(limit {limits.max_closing_rate_m_s:g}), offset {end["offset_m"]:.3f} m '
            f'(limit {mission.corridor.docking_radius_m:g}), lateral rate '
            f'{end["lateral_rate_m_s"]:.4f} m/s (limit {limits.max_lateral_rate_m_s:g})')
    if content['exit']['time_s'] is not None:
        x, y, z = content['exit']['position_m']
        lines.append(f'  left the corridor at {content["exit"]["time_s"]:.1f} s, '
                     f'x = {x:.2f}, y = {y:.2f}, z = {z:.2f} m')
    margin, effort = content['min_corridor_margin_m'], content['delta_v_m_s']
    if margin is not None and effort is not None:
        lines.append(f'  least corridor margin {margin:.3f} m, delta-v {effort:.3f} m/s')
    return '\n'.join(lines)
