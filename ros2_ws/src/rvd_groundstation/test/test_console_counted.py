"""Which flights of a session count: those flown as their condition says, by the record."""

import asyncio
import json

import pytest
from test_console_desk import flown, GOOD, SESSION, tell

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.console.counted import why_not
from rvd_groundstation.console.desk import Desk
from rvd_groundstation.console.hub import Hub
from rvd_groundstation.console.provider import display_of

DISPLAY = display_of(parse('/**: {ros__parameters: {}}', 'test'))
MOSTLY_AUTO = {'manual': 0.12, 'auto': 0.88}


@pytest.mark.parametrize('said, why', [
    ({'modes': {'manual': 1.0}}, ''),
    ({'modes': {'manual': 0.9, 'abort': 0.1}, 'aborted': True}, 'ABORT was pressed'),
    ({'modes': MOSTLY_AUTO}, 'the mode was changed: 88 % of the steps in mode auto, not manual'),
    ({'modes': {'manual': 0.9999, 'auto': 0.0001}},
     'the mode was changed: less than 1 % of the steps in mode auto, not manual'),
    ({'modes': {'auto': 1.0}}, 'the mode was changed: 100 % of the steps in mode auto, not manual'),
    ({'modes': {'manual': 1.0}, 'pauses': 1}, 'it was paused'),
    ({'modes': {'manual': 1.0}, 'pauses': 3}, 'it was paused 3 times'),
    ({}, 'it is not known what was flown')])
def test_a_flight_counts_if_it_was_flown_as_its_condition_says(said, why):
    assert why_not({'flown': said}, 'manual') == why
    assert why_not({'flown': said, 'trusted': True}, 'manual') == why


def test_what_is_not_to_be_trusted_or_not_known_does_not_count():
    assert why_not({'flown': {'modes': {'auto': 1.0}}, 'trusted': False}, 'auto') == (
        'its verdict is not to be trusted')
    for nothing in ({}, {'flown': None}, {'flown': {'modes': None}}, {'flown': 3}):
        assert why_not(nothing, 'auto') == 'it is not known what was flown'


def counted_flight(tmp_path):
    """Return a desk before the first flight that counts."""
    desk = Desk(SESSION, tmp_path)
    desk.do({'act': 'begin', 'volunteer': 1})
    flown(desk, tmp_path)
    desk.do({'act': 'rate', **GOOD})
    assert desk.view()['stage'] == 'ready' and not desk.view()['training']
    return desk


def test_a_flight_in_another_mode_is_kept_with_the_reason_and_flown_again(tmp_path):
    desk = counted_flight(tmp_path)
    number, mode = desk.view()['number'], desk.view()['mode']
    run = flown(desk, tmp_path, modes={mode: 0.12, 'auto': 0.88})
    view = desk.view()
    assert view['stage'] == 'broken' and '88 % of the steps in mode auto' in view['why']
    made = json.loads((run / 'ratings.json').read_text())
    assert made['counted'] is False and made['why'] == view['why']
    assert made['cooper_harper'] is None and made['mode'] == mode
    with pytest.raises(BadInput, match='STAGE'):
        desk.do({'act': 'rate', **GOOD})
    desk.do({'act': 'go_on'})
    assert desk.view()['stage'] == 'ready' and desk.view()['number'] == number
    again = flown(desk, tmp_path)
    assert again.name == run.name + '.2'
    desk.do({'act': 'rate', **GOOD})
    good = json.loads((again / 'ratings.json').read_text())
    assert good['counted'] and good['seed'] == made['seed'] and good['why'] == ''
    assert desk.view()['stage'] == 'rest'


def test_a_session_that_is_taken_up_again_flies_what_did_not_count(tmp_path):
    desk = counted_flight(tmp_path)
    flown(desk, tmp_path, pauses=1)
    again = Desk(SESSION, tmp_path)
    again.do({'act': 'begin', 'volunteer': 1})
    assert again.view()['number'] == 2 and again.view()['stage'] == 'ready'


def test_an_aborted_flight_is_said_so_at_once_and_waits_for_its_folder(tmp_path):
    desk = counted_flight(tmp_path)
    order = desk.do({'act': 'fly'})
    (tmp_path / order['out']).mkdir()
    desk.flown({'reason': 'aborted', 'words': 'aborted', 'success': False})
    assert desk.view()['stage'] == 'broken' and desk.view()['why'] == 'ABORT was pressed'
    for act in ('go_on', 'fly', 'leave'):
        with pytest.raises(BadInput, match='CLOSING'):
            desk.do({'act': act})
    tell(tmp_path / order['out'], {order['mode']: 0.5, 'abort': 0.5}, aborted=True)
    desk.ended(order['out'])
    assert not desk.view()['closing'] and desk.view()['stage'] == 'broken'
    assert not json.loads((tmp_path / order['out'] / 'ratings.json').read_text())['counted']


def test_one_that_was_aborted_and_ended_has_no_verdict_and_does_not_count(tmp_path):
    desk = counted_flight(tmp_path)
    order = desk.do({'act': 'fly'})
    (tmp_path / order['out']).mkdir()
    tell(tmp_path / order['out'], {order['mode']: 0.5, 'abort': 0.5}, aborted=True)
    desk.ended(order['out'])
    assert desk.view()['stage'] == 'broken' and desk.view()['why'] == 'ABORT was pressed'


def test_a_training_flight_is_rated_whatever_was_flown(tmp_path):
    desk = Desk(SESSION, tmp_path)
    desk.do({'act': 'begin', 'volunteer': 1})
    run = flown(desk, tmp_path, pauses=2)
    desk.do({'act': 'rate', **GOOD})
    made = json.loads((run / 'ratings.json').read_text())
    assert made['training'] and not made['counted'] and made['cooper_harper']['rating'] == 4


def test_what_is_rated_before_the_folder_is_whole_is_written_when_it_is(tmp_path):
    desk = counted_flight(tmp_path)
    order = desk.do({'act': 'fly'})
    run = tmp_path / order['out']
    run.mkdir()
    desk.flown({'reason': 'docked', 'words': 'docked', 'success': True})
    desk.do({'act': 'rate', **GOOD})
    assert desk.view()['stage'] == 'closing' and not (run / 'ratings.json').exists()
    tell(run, order['mode'])
    desk.ended(order['out'])
    assert json.loads((run / 'ratings.json').read_text())['counted']
    assert desk.view()['stage'] == 'rest'


def test_a_rating_of_a_flight_that_turns_out_not_to_count_is_left_out(tmp_path):
    desk = counted_flight(tmp_path)
    order = desk.do({'act': 'fly'})
    run = tmp_path / order['out']
    run.mkdir()
    desk.flown({'reason': 'docked', 'words': 'docked', 'success': True})
    desk.do({'act': 'rate', **GOOD})
    tell(run, MOSTLY_AUTO)
    desk.ended(order['out'])
    assert desk.view()['stage'] == 'broken'
    assert json.loads((run / 'ratings.json').read_text())['cooper_harper'] is None


# -- who may steer ----------------------------------------------------------------------------

class Graph:
    """Stands for the running graph: obeys whatever is asked."""

    def __init__(self):
        self.asked = []

    def joy(self, stick):
        return [0, 0, 0]

    def control(self, action, mode, reply):
        self.asked.append(action)
        reply(True, action)

    def event(self, code, text):
        pass


def steered(desk, *wishes, events=()):
    """Return what a pilot's requests led to while a run is flown: codes of refusals, or ''."""
    async def work():
        orders, graph = [], Graph()
        hub = Hub(orders.append, desk)
        hub.begin('run', DISPLAY, graph)
        pilot = hub.join()
        hub.request(pilot, json.dumps({'do': 'take', 'id': 1}))
        for event in events:
            hub.post('event', {'t': 1.0, 'node': 'command_blender', 'code': event, 'text': ''})
        hub._drain()
        told = []
        for number, wish in enumerate(wishes, 10):
            hub.request(pilot, json.dumps({'id': number, **wish}))
            replies = []
            while (text := pilot.outbox.take()) is not None:
                message = json.loads(text)
                if message['type'] == 'reply' and message['id'] == number:
                    replies.append(message)
            told.append('' if replies[-1]['ok'] else replies[-1]['code'])
        return told, graph.asked, [order['do'] for order in orders]
    return asyncio.run(work())


MODE, PAUSE, FLY, STOP, QUIT, ABORT = (
    {'do': 'mode', 'mode': 'auto'}, {'do': 'pause'}, {'do': 'fly', 'mode': 'auto'}, {'do': 'stop'},
    {'do': 'quit'}, {'do': 'abort'})


def test_in_a_session_mode_pause_restart_and_end_are_the_session_s(tmp_path):
    desk = counted_flight(tmp_path)
    desk.do({'act': 'fly'})
    told, asked, orders = steered(desk, MODE, MODE, PAUSE, FLY, STOP, QUIT, ABORT)
    assert told == ['SESSION_MODE', 'SESSION_MODE', 'SESSION_PAUSE', 'DESK', 'SESSION_STOP',
                    'SESSION_STOP', '']
    assert asked == ['abort'] and orders == []


def test_what_was_aborted_may_be_ended(tmp_path):
    desk = counted_flight(tmp_path)
    desk.do({'act': 'fly'})
    told, _, orders = steered(desk, STOP, events=['ABORT'])
    assert told == [''] and orders == ['stop']


def test_without_a_session_they_are_the_pilot_s():
    """The negative twin."""
    told, asked, orders = steered(None, MODE, PAUSE, ABORT, STOP, FLY)
    assert told == [''] * 5
    assert asked == ['mode', 'pause', 'abort'] and orders == ['stop', 'fly']
