"""
A second link for the tests: every copy of every frame as events in continuous time.

No slots and no counters: a heap of sendings, arrivals and ticks, one word of state per copy,
and the counts are a census of those words. It shares nothing with the code under test.
"""

from collections import Counter
from heapq import heapify, heappop, heappush
from typing import NamedTuple

SEND, ARRIVE, TICK = range(3)       # the order of events at one instant


class Sending(NamedTuple):
    """What happens to the frame of one step; None in a list of them: nothing is sent."""

    transits: tuple                 # one per copy [ns]; None: that copy is lost
    expedited: bool = False
    outage: bool = False


class Flight(NamedTuple):
    """What came out."""

    released: list                  # per step: (step it was sent in, number of the copy) or None
    census: list                    # per step: Counter of states of all copies
    overtaken: int                  # copies that arrived after a later-sent one


def sendings_of(plan, sent, expedited):
    """Say a `LinkPlan` in the words of this module; `sent`, `expedited` are bools per step."""
    sendings = []
    for k in range(len(plan.duplicated)):
        copies = range(2 if plan.duplicated[k] else 1)
        transits = [None if plan.lost[k, c] else int(plan.transit_ns[k, c]) for c in copies]
        sendings.append(Sending(tuple(transits), bool(expedited[k]), bool(plan.outage[k]))
                        if sent[k] else None)
    return sendings


def fly(sendings, hold, period):
    """Send, let arrive and release; `hold` in steps, `period` in ns."""
    events = [(k * period, TICK, k, 0) for k in range(len(sendings))]
    events += [(k * period, SEND, k, 0) for k, s in enumerate(sendings) if s is not None]
    heapify(events)
    state, waiting, urgent, arrived = {}, {}, [], []
    released, census = [], []
    while events and len(released) < len(sendings):
        time, event, k, copy = heappop(events)
        if event == SEND:
            for c, transit in enumerate(sendings[k].transits):
                state[k, c] = ('outage' if sendings[k].outage else
                               'lost' if transit is None else 'in_flight')
                if state[k, c] == 'in_flight':
                    heappush(events, (time + transit, ARRIVE, k, c))
        elif event == ARRIVE:
            arrived.append(k)
            if sendings[k].expedited:
                urgent.append((k, copy))
                state[k, copy] = 'queued'
            elif time > (k + hold) * period:
                state[k, copy] = 'late'
            elif k in waiting:
                state[k, copy] = 'duplicate_dropped'
            else:
                waiting[k] = copy
                state[k, copy] = 'queued'
        else:
            due = (k - hold, waiting[k - hold]) if k - hold in waiting else None
            if urgent:
                if due is not None:
                    state[due] = 'late'
                due = urgent.pop(0)
            if due is not None:
                state[due] = 'delivered'
            released.append(due)
            census.append(Counter(state.values()))
    overtaken = sum(max(arrived[:i], default=-1) > k for i, k in enumerate(arrived))
    return Flight(released, census, overtaken)
