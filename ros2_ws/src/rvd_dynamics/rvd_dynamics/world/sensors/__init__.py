"""Sensor models; the table is `SENSORS`."""

from rvd_dynamics.world.sensors.models import Additive, Multiplicative, SENSORS

__all__ = ['Additive', 'Multiplicative', 'SENSORS']
