"""
How late the steps of a run in real time were: percentiles of any number of instants, in few bytes.
"""

from array import array
import math

FINE_S = 1e-5                   # [s] width of a bin up to EDGE_S
EDGE_S = 0.1                    # [s] from here on a bin is so much wider than the one before:
RATIO = 1.01
COARSE = 1200                   # bins beyond the edge: the last one begins at 4 hours


class Lateness:
    """
    Counts of instants by how late they were.

    A percentile is right to 10 microseconds up to 0.1 s and to 1 % beyond; the largest is exact.
    """

    def __init__(self) -> None:
        self._fine = round(EDGE_S/FINE_S)
        self._counts = array('Q', bytes(8*(self._fine + COARSE)))
        self._largest = 0.0
        self._number = 0

    def __len__(self) -> int:
        return self._number

    def add(self, late_s: float) -> None:
        """Count an instant that was `late_s` late [s], not negative."""
        if late_s < EDGE_S:
            place = int(late_s/FINE_S)
        else:
            place = self._fine + min(int(math.log(late_s/EDGE_S, RATIO)), COARSE - 1)
        self._counts[place] += 1
        self._largest = max(self._largest, late_s)
        self._number += 1

    def percentile(self, percent: float) -> float:
        """Return what so many percent do not exceed [s] (nearest rank); NaN of none."""
        if not self._number:
            return math.nan
        left = max(math.ceil(self._number*percent/100.0), 1)
        if left == self._number:
            return self._largest
        for place, count in enumerate(self._counts):
            left -= count
            if left <= 0:
                return self._middle(place)
        raise AssertionError('fewer are counted than were added')

    def _middle(self, place: int) -> float:
        if place < self._fine:
            return (place + 0.5)*FINE_S
        return EDGE_S*RATIO**(place - self._fine + 0.5)
