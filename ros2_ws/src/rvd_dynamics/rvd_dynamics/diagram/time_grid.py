"""
The grid of a run: instants are whole numbers of steps, and so are delays.
"""

from rvd_dynamics.bad_input import BadInput



def whole_steps(name: str, duration_s: float, step_s: float) -> int:
    """
    Return how many steps of `step_s` [s] the duration [s] called `name` takes.

    Raises
    ------
    ValueError
        If it is not a whole number of them; names the two nearest.
    """
    steps = round(duration_s / step_s)
    if abs(steps*step_s - duration_s) > 1e-9:       # [s]
        below = int(duration_s / step_s)
        raise BadInput(
            f'{name} must be a whole number of steps of {step_s:g} s, got {duration_s:g}: '
            f'the two nearest are {below*step_s:g} and {(below + 1)*step_s:g}')
    return steps
