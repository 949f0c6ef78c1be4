"""
What the lunar approach adds to the table of its campaigns, and the paper's condition 1.

Columns     place and time of failure, state at the docking plane, who decided how many steps.
            They come before, between and after the measures, in the order of `ORDER`; where and
            when a run left the corridor stands in the columns of failure, not in the measures'.
Source      Zhang, Li, Tang, J. Astronautics 35(3), 2014, Table 3.
"""

import numpy as np

from rvd_campaign.campaign.results import Layout, Table
from rvd_campaign.loop import Flight

ORDER = (
    'run', 'success', 'reason', 'duration_s',
    'failed_at_s', 'failed_x_m', 'failed_y_m', 'failed_z_m',    # NaN where a run succeeded
    'x_rate_m_s', 'offset_m', 'lateral_rate_m_s',
    'y_m', 'z_m', 'y_rate_m_s', 'z_rate_m_s',                   # at the docking plane, or NaN
    'min_corridor_margin_m', 'delta_v_m_s',
    'steps', 'steps_nobody', 'steps_pilot', 'steps_auto', 'steps_blend', 'steps_changed')

# Condition 1 of the paper (manual), to which pilots are fitted: successes, means over them.
PAPER_RUNS, PAPER_SUCCESSES = 100, 76
PAPER_MEANS = {'offset_m': 0.1444, 'lateral_rate_m_s': 0.0182}


def columns(flight: Flight) -> Table:
    """Return the columns (N,) that are no measures of the judge."""
    success, end = flight.verdict.success, flight.terminal
    values = flight.verdict.values
    exit_time = values['exit_time_s']
    exit_position = np.stack([values[f'exit_{axis}_m'] for axis in 'xyz'], axis=-1)
    left = ~np.isnan(exit_time)
    place = np.where(left[:, None], exit_position, end[:, :3])
    place = np.where(success[:, None], np.nan, place)
    failed_at = np.where(success, np.nan, np.where(left, exit_time, flight.verdict.duration))
    nobody, pilot, auto, blend = flight.decided_steps.T
    return {
        'failed_at_s': failed_at,
        'failed_x_m': place[:, 0], 'failed_y_m': place[:, 1], 'failed_z_m': place[:, 2],
        'y_m': end[:, 1], 'z_m': end[:, 2], 'y_rate_m_s': end[:, 4], 'z_rate_m_s': end[:, 5],
        'steps': flight.end_step, 'steps_nobody': nobody, 'steps_pilot': pilot,
        'steps_auto': auto, 'steps_blend': blend, 'steps_changed': flight.changed_steps}


LAYOUT = Layout(columns, ORDER)
