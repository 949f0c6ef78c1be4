"""
Whether a flight of a session counts: by what was flown, as its `verdict.json` has it of the bag.
"""

from typing import Any

BESIDE = ('abort', 'unknown')   # shares of steps that are of no mode


def why_not(verdict: dict[str, Any], mode: str) -> str:
    """
    Return why a flight does not count; empty where it does.

    Parameters
    ----------
    verdict : dict
        Content of its `verdict.json`.
    mode : str
        Of its condition.
    """
    flown = verdict.get('flown')
    if not isinstance(flown, dict) or not isinstance(flown.get('modes'), dict):
        return 'it is not known what was flown'
    if flown.get('aborted'):
        return 'ABORT was pressed'
    others = {name: share for name, share in flown['modes'].items()
              if name != mode and name not in BESIDE}
    if others:
        told = ', '.join(f'{_percent(share)} of the steps in mode {name}'
                         for name, share in others.items())
        return f'the mode was changed: {told}, not {mode}'
    if flown.get('pauses'):
        n = flown['pauses']
        return 'it was paused' if n == 1 else f'it was paused {n} times'
    if verdict.get('trusted') is False:
        return 'its verdict is not to be trusted'
    return ''


def _percent(share: float) -> str:
    """Return a share in words; one that is not 0 is never said to be."""
    return 'less than 1 %' if share < 0.01 else f'{100 * share:.0f} %'
