"""
What an ABORT makes the craft do: the procedure that ground and guard have agreed.
"""

from rvd_dynamics.diagram.params import param, settings


@settings
class GuardParams:
    """Settings of the guard."""

    abort_burn_s: float = param(
        16.0, 'Time for which an ABORT thrusts along -x at full level before it coasts [s].',
        low=0.0, high=3600.0)
