"""Sensor models; the table is `SENSORS`."""

from rvd_dynamics.world.sensors.models import Multiplicative, SENSORS

__all__ = ['Multiplicative', 'SENSORS']
