"""
Columns of a campaign's table: what the judge measures, where a run failed, and who decided.

Where and when a run left the corridor stands in the columns of failure, not in the measures'.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.codes import BY_AUTO, BY_BLEND, BY_NOBODY, BY_PILOT
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.judge import Measure
from rvd_dynamics.diagram.run import Legs
from rvd_groundstation.prediction.consistency import Consistency

ORDER = (
    'run', 'success', 'reason', 'duration_s',
    'failed_at_s', 'failed_x_m', 'failed_y_m', 'failed_z_m',    # NaN where a run succeeded
    'x_rate_m_s', 'offset_m', 'lateral_rate_m_s',
    'y_m', 'z_m', 'y_rate_m_s', 'z_rate_m_s',                   # at the docking plane, or NaN
    'min_corridor_margin_m', 'delta_v_m_s', 'clearance_m?', 'start_room_m?',
    'prediction_nees?', 'prediction_coverage_2sigma?',
    'steps', 'steps_nobody', 'steps_pilot', 'steps_auto', 'steps_blend', 'steps_changed')

COLUMNS = {                             # those that are no measures: type
    'failed_at_s': 'f8', 'failed_x_m': 'f8', 'failed_y_m': 'f8', 'failed_z_m': 'f8',
    'y_m': 'f8', 'z_m': 'f8', 'y_rate_m_s': 'f8', 'z_rate_m_s': 'f8',
    'steps': 'i8', 'steps_nobody': 'i8', 'steps_pilot': 'i8', 'steps_auto': 'i8',
    'steps_blend': 'i8', 'steps_changed': 'i8'}
MEASURES = (                            # of predictions, where they are asked for
    Measure('prediction_nees', '', 'normalised error squared of the prediction, 6 if it is as '
            'good as it says', digits=2, of_all=True),
    Measure('prediction_coverage_2sigma', '', 'share of the prediction within two deviations',
            of_all=True))
DECIDERS = np.array([[BY_NOBODY], [BY_PILOT], [BY_AUTO], [BY_BLEND]], dtype=np.uint8)


class Columns:
    """
    Counts, in the runs under way, who decided and how often the pilot was overruled.

    Where it reads predictions, it holds them against the truth.
    """

    def __init__(self, block: Block, legs: Legs, batch: tuple) -> None:
        self._consistency = (Consistency(legs.forward, batch) if 'prediction' in block.reads
                             else None)
        self._ended = np.zeros(batch, dtype=bool)
        self._decided = np.zeros((len(DECIDERS), *batch), dtype=np.int32)
        self._changed = np.zeros(batch, dtype=np.int32)

    def step(self, k: int, truth: Any, command: Any, stick: Any = None, prediction: Any = None
             ) -> dict[str, Any]:
        """Count step k."""
        if prediction is not None:
            self._consistency.follow(prediction.state, prediction.covariance, truth.state,
                                     ~self._ended)
        self._ended |= truth.final
        live = ~self._ended
        self._decided += (command.decided_by == DECIDERS) & live
        differs = command.command != (0 if stick is None else stick.command)
        self._changed += live & (differs[:, 0] | differs[:, 1] | differs[:, 2])
        return {}

    def table(self, judge: Any, end_step: NDArray[np.int64]) -> dict[str, NDArray]:
        """Return the columns of N runs."""
        verdict, end = judge.verdict(), judge.terminal
        exit_time = verdict.values['exit_time_s']
        exit_position = np.stack([verdict.values[f'exit_{axis}_m'] for axis in 'xyz'], axis=-1)
        left = ~np.isnan(exit_time)
        place = np.where(left[:, None], exit_position, end[:, :3])
        place = np.where(verdict.success[:, None], np.nan, place)
        failed_at = np.where(verdict.success, np.nan,
                             np.where(left, exit_time, verdict.duration))
        values = (failed_at, *place.T, end[:, 1], end[:, 2], end[:, 4], end[:, 5], end_step,
                  *self._decided, self._changed)
        made = {name: np.asarray(value, dtype=kind)
                for (name, kind), value in zip(COLUMNS.items(), values, strict=True)}
        if self._consistency is not None:
            found = self._consistency.mean_nees, self._consistency.coverage
            made |= {m.name: value for m, value in zip(MEASURES, found, strict=True)}
        return made
