"""
Percentiles of the transits that have arrived so far, in memory that does not grow with them.

Every transit that can come stands in the plan of the link, so that an arrival is a count at its
rank there. The counts are kept as a binary indexed tree: to count and to find a percentile takes
as many steps as the plan's length has binary digits.

Source  P. M. Fenwick, Software: Practice and Experience 24(3), 1994, pp. 327-336.
"""

from array import array

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.constants import NS_PER_S


class Transits:
    """
    Transits that have arrived, out of a plan.

    Parameters
    ----------
    planned_ns : ndarray of int64, shape (steps, 2)
        Transit of each frame and of its copy [ns].
    """

    def __init__(self, planned_ns: NDArray[np.int64]) -> None:
        flat = np.ascontiguousarray(planned_ns, dtype=np.int64).ravel()
        order = np.argsort(flat, kind='stable')
        place = np.empty(len(flat), dtype=np.int64)
        place[order] = np.arange(1, len(flat) + 1)
        self._sorted_ns = array('q', flat[order].tobytes())
        self._place = array('q', place.tobytes())       # of each in the tree, from 1
        self._tree = array('q', bytes(8*(len(flat) + 1)))
        self._top = 1 << len(flat).bit_length() - 1
        self._number = 0

    def __len__(self) -> int:
        return self._number

    def add(self, step: int, copy: int) -> None:
        """Count the arrival of the frame sent in `step` (copy 0), or of its copy (1)."""
        tree, place = self._tree, self._place[2*step + copy]
        while place < len(tree):
            tree[place] += 1
            place += place & -place
        self._number += 1

    def percentile_s(self, percent: int) -> float:
        """Return a percentile (nearest rank) of those that have arrived [s]; NaN of none."""
        if not self._number:
            return float('nan')
        tree, left = self._tree, max(-(-percent*self._number // 100), 1)
        place, stride = 0, self._top
        while stride:
            ahead = place + stride
            if ahead < len(tree) and tree[ahead] < left:
                place, left = ahead, left - tree[ahead]
            stride >>= 1
        return self._sorted_ns[place]/NS_PER_S
