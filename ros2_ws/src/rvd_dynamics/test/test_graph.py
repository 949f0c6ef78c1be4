"""The table of the graph: closed, without a cycle inside one step, and able to name who owes."""

import itertools

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rvd_dynamics.diagram.ros import graph

OPERATORS = [('model', 'stepped'), ('replay', 'stepped'), ('none', 'stepped'), ('joy', 'held')]


@pytest.mark.parametrize('name', graph.NODES)
def test_every_topic_of_a_node_is_in_the_table_of_topics(name):
    spec = graph.NODES[name]
    assert (spec.reads | spec.publishes) <= set(graph.TOPICS)


@pytest.mark.parametrize('operator, joy_input', OPERATORS)
def test_ring_topics_have_one_writer_among_the_nodes_of_a_run(operator, joy_input):
    for topic in {t for name in graph.ring(operator) for t in graph.NODES[name].emits}:
        assert graph.expected(topic, graph.ring(operator), operator, joy_input)[0] == 1, topic


@pytest.mark.parametrize('operator, joy_input', OPERATORS)
def test_every_input_of_the_ring_is_emitted_by_the_ring(operator, joy_input):
    names = graph.ring(operator)
    emitted = {t for name in names for t in graph.NODES[name].emits}
    for name in names:
        for topic, _ in graph.spec_of(name, operator, joy_input).fires_on:
            assert topic in emitted, (name, topic)


@pytest.mark.parametrize('operator, joy_input', OPERATORS)
@pytest.mark.parametrize('uses_stick', [False, True])
def test_ring_fires_every_node_once_per_step_without_a_deadlock(operator, joy_input,
                                                               uses_stick):
    assert fired(operator, joy_input, uses_stick, steps=5) == {
        name: 5 for name in graph.ring(operator)}


def test_nothing_but_the_guard_writes_thrust_and_no_ground_node_reads_truth():
    writers = [n for n, s in graph.NODES.items() if '/onboard/thruster_command' in s.publishes]
    assert writers == ['onboard_guard']
    ground = ['state_predictor', 'operator_model', 'joystick_replay', 'auto_controller',
              'command_blender']
    for name in ground:
        reads = graph.NODES[name].reads
        assert not any(t.startswith(('/truth', '/onboard')) for t in reads), name


def test_unknown_node_is_refused_by_name():
    with pytest.raises(ValueError, match='no node named .frobnicator.'):
        graph.spec_of('frobnicator', 'model', 'stepped')


@given(st.sampled_from(OPERATORS), st.booleans(), st.data())
def test_a_node_that_stops_is_the_one_that_owes(pilot, uses_stick, data):
    operator, joy_input = pilot
    dead = data.draw(st.sampled_from(graph.ring(operator)))
    until = data.draw(st.integers(0, 20))
    last = last_steps(operator, joy_input, uses_stick, dead, until)
    owing = graph.who_owes(last, graph.ring(operator), operator, joy_input, uses_stick)
    assert owing == [dead]


def test_a_recorder_that_is_far_behind_owes():
    names = (*graph.ring('model'), 'bag_recorder')
    last = {topic: 80 for name in names for topic in graph.NODES[name].emits}
    last['/run/recorded_step'] = 16
    assert 'bag_recorder' in graph.who_owes(last, names, 'model', 'stepped')
    last['/run/recorded_step'] = 17
    assert 'bag_recorder' not in graph.who_owes(last, names, 'model', 'stepped')


def fired(operator, joy_input, uses_stick, steps, dead=None, dead_from=0):
    """Play the data flow by hand: how often each node has fired when nothing moves any more."""
    names = graph.ring(operator)
    count = dict.fromkeys(names, 0)
    writer = {t: n for n in names for t in graph.NODES[n].emits}

    def may_fire(name):
        k = count[name]
        return k < steps and not (name == dead and k >= dead_from) and all(
            k < lag or count[writer[topic]] > k - lag
            for topic, lag in graph.spec_of(
                name, operator, joy_input, uses_stick).fires_on)

    while ready := [n for n in names if may_fire(n)]:
        count[ready[0]] += 1
    return count


def last_steps(operator, joy_input, uses_stick, dead, until):
    count = fired(operator, joy_input, uses_stick, until + 30, dead, until)
    return {topic: count[name] - 1 for name in count
            for topic in itertools.chain(graph.NODES[name].emits)}
