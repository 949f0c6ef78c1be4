"""
Before a run in real time, each process flies the beginning of it by itself.

What is loaded, compiled or built at a first use (compiled loops, solvers, OpenCV) is then there
when the clock starts; else a second of steps is late. All of the diagram is flown, since the blocks
of one process live on what the others give.
"""

from collections.abc import Callable

from rvd_dynamics.diagram.in_process import draw, Loop
from rvd_dynamics.diagram.scenario import Scenario

REHEARSED_S = 3.0               # [s] simulation time


def rehearse(scenario: Scenario, goes_on: Callable[[], bool] = lambda: True) -> int:
    """
    Fly the first seconds of the scenario's next run, and forget them.

    Not of its own: the process of a controller is never to hold the truth or the chance that it
    will meet.

    A block that fails ends the rehearsal and nothing else: the process that runs it will say so.
    What comes from outside of the run, as a stick's messages, is missing throughout. It ends early
    when `goes_on()`, asked before each step, says no.

    Returns
    -------
    int
        How many steps were flown.
    """
    run, runs = scenario.run, [scenario.run.run + 1]
    steps = min(run.last_step + 1, max(1, round(REHEARSED_S/run.step_s)))
    flown = 0
    try:
        loop = Loop(scenario, runs, draw(scenario, runs, whole=True), False, ())
        while flown < steps and not loop.ended.all() and goes_on():
            loop.advance(flown)
            flown += 1
    except Exception:               # noqa: B902 - see above
        pass
    return flown
