"""
One pilot at a time: the lease on the stick.

No clock: instants are given [s]. A holder that is silent for `SILENT_S` has lost the lease,
because its page hangs or its network is gone; a closed connection loses it at once.
"""

SILENT_S = 3.0                  # [s] wall time


class Lease:
    """Who holds the stick; clients are known by any hashable name."""

    def __init__(self, silent_s: float = SILENT_S) -> None:
        self.holder: object = None
        self._silent_s = silent_s
        self._heard = 0.0

    def take(self, client: object, now: float) -> bool:
        """Give the lease to `client` if it is free or its own already."""
        self.expire(now)
        if self.holder is not None and self.holder != client:
            return False
        self.holder, self._heard = client, now
        return True

    def heard(self, client: object, now: float) -> bool:
        """Note that `client` has sent a stick; say whether it counts."""
        if self.holder is None or self.holder != client:
            return False
        self._heard = now
        return True

    def drop(self, client: object) -> bool:
        """Take the lease from `client`; say whether it held it."""
        if self.holder is None or self.holder != client:
            return False
        self.holder = None
        return True

    def expire(self, now: float) -> bool:
        """Take the lease from a silent holder; say whether that happened."""
        if self.holder is None or now - self._heard <= self._silent_s:
            return False
        self.holder = None
        return True
