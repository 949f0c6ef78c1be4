"""How far the start of a run is reaches every page, and changes nothing else."""

import json

from rvd_groundstation.console.hub import Hub


def statuses(client) -> list[dict]:
    """Return what a page was told of the status, and forget it."""
    told = []
    while (text := client.outbox.take()) is not None:
        message = json.loads(text)
        if message['type'] == 'status':
            told.append(message)
    return told


def test_nodes_are_counted_in_whichever_phase_the_start_is():
    hub = Hub(ask=print)
    page = hub.join()
    statuses(page)
    hub.told('starting', run='one')
    hub.told('progress', '3 of 12 nodes ready', 'one')
    hub.phase = 'flying'                        # our own node is up, and the others are not yet
    hub.told('progress', '7 of 12 nodes ready', 'one')
    hub.told('ended', run='one')
    assert [(s['phase'], s['progress'], s['run']) for s in statuses(page)] == [
        ('starting', '', 'one'), ('starting', '3 of 12 nodes ready', 'one'),
        ('flying', '7 of 12 nodes ready', 'one'), ('ended', '', 'one')]
