"""
What filters of the relative motion assume: settings.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import param, settings

Array = NDArray[np.float64]
FLOOR_STEP_S = 0.5                      # [s] step to which `process_variance_floor` refers


@settings
class FilterParams:
    """Process and measurement noise assumed by the filter."""

    process_noise_m_s2: float = param(
        3e-4, 'Standard deviation of the unknown acceleration, which is constant within a step '
        '[m/s^2].', low=0.0)
    process_variance_floor: float = param(
        1e-10, 'Variance added to each position and velocity component per 0.5 s '
        '[m^2, m^2/s^2].', low=0.0)
    measurement_fraction: float = param(
        0.01, 'Standard deviation of the measurement noise of a component, as a fraction of its '
        'value.', above=0.0)
    position_floor_m: tuple = param(
        (0.25, 0.3, 0.3), 'Distance along x, y and z below which the measurement noise no longer '
        'shrinks with it [m].', low=0.0, length=3)
    velocity_floor_m_s: tuple = param(
        (0.25, 0.02, 0.02), 'Speed along x, y and z below which the measurement noise no longer '
        'shrinks with it [m/s].', low=0.0, length=3)
    position_sigma_m: float = param(
        1e-4, 'Standard deviation of the part of the position noise that does not depend on the '
        'position [m].', above=0.0)
    velocity_sigma_m_s: float = param(
        1e-5, 'Standard deviation of the part of the velocity noise that does not depend on the '
        'velocity [m/s].', above=0.0)
    execution_fraction: float = param(
        0.05, 'Standard deviation of the thrust, as a fraction of it; of the learned filter.',
        low=0.0, high=1.0)
    unmodelled_m_s2: float = param(
        3e-8, 'Standard deviation of the acceleration that the learned filter does not know of '
        'besides, which is constant within a step [m/s^2].', low=0.0)
    noise_weight: float = param(
        3.0, 'Number of innovations that the noise assumed counts for while the learned filter '
        'learns how noisy the sensor is.', above=0.0)
    start_position_sigma_m: tuple = param(
        (0.3, 0.5, 0.5), 'Standard deviations of the start position along x, y and z [m].',
        low=0.0, length=3)
    start_velocity_sigma_m_s: tuple = param(
        (0.01, 0.02, 0.02), 'Standard deviations of the start velocity along x, y and z [m/s].',
        low=0.0, length=3)
    gate_nis: float = param(
        1e3, 'Normalised innovation squared above which a sample is an outlier and left out.',
        above=0.0)
    gate_position_m: float = param(
        0.25, 'Standard deviation of what the gate allows for besides, such as commands that were '
        'lost: position [m].', low=0.0)
    gate_velocity_m_s: float = param(
        0.1, 'The same: velocity [m/s].', low=0.0)
    gate_patience: int = param(
        10, 'Outliers in a row after which the filter begins anew at the next sample.', low=1)

    def measurement_variance(self, state: Array) -> Array:
        """Return the diagonal of R (..., 6) at `state` (..., 6)."""
        floor = np.array(self.position_floor_m + self.velocity_floor_m_s)
        sigma = np.repeat([self.position_sigma_m, self.velocity_sigma_m_s], 3)
        share = self.measurement_fraction * np.maximum(np.abs(state), floor)
        return share*share + sigma*sigma

    def start_covariance(self) -> Array:
        """Return P0 (6, 6)."""
        sigma = np.array(self.start_position_sigma_m + self.start_velocity_sigma_m_s)
        return np.diag(sigma*sigma)

    def process_covariance(self, gamma: Array, step_s: float) -> Array:
        """Return Q (6, 6) of one step with the input matrix `gamma` (6, 3)."""
        floor = self.process_variance_floor * step_s / FLOOR_STEP_S
        variance = self.process_noise_m_s2 * self.process_noise_m_s2
        return variance * (gamma @ gamma.T) + floor * np.eye(6)
