"""Who may write on a topic of a run, and who is named because he may not; the graph is played."""

from pathlib import Path
from types import SimpleNamespace

import pytest

from rvd_dynamics.diagram.identity import new_run
from rvd_dynamics.diagram.ros.writers import (
    LATE_S, NAMED_S, NAMELESS_S, OTHER_RUN_S, UNKNOWN_NODE, Writers)
from rvd_dynamics.diagram.roster import ALSO_WRITES, listed, SECOND_WRITER
from rvd_dynamics.diagram.scenario import load, parse

SCENARIOS = Path(__file__).resolve().parents[4] / 'scenarios'
RUN = new_run()


class Graph:
    """What DDS tells of writers and nodes, and the wall time."""

    def __init__(self, roster, processes=None):
        self.writers, self.nodes, self.now, self.asked, self.crowd = {}, [], 100.0, 0, 0.0
        self.roster, self._process = roster, {}
        for process in roster.processes:
            for node in process.nodes:
                self.come(node, *sorted(roster.writes(node)), process=process.name)
            self.come(process.nodes[0], '/run/ready', '/run/events', '/diagnostics',
                      process=process.name, enclave=None)

    def come(self, node, *topics, process=None, enclave=RUN):
        """Let a node announce writers; return their ids."""
        name = process or f'alone {len(self._process)}'
        prefix = self._process.setdefault(name, bytes([1 + len(self._process)])*12)
        if enclave is not None and node:
            self.nodes.append((node, '/', enclave))
        made = []
        for topic in topics:
            made.append(prefix + len(self.writers.setdefault(topic, {})).to_bytes(2, 'big')
                        + bytes(2))
            self.writers[topic][made[-1]] = node or UNKNOWN_NODE
        return made

    def go(self, topic, gid):
        del self.writers[topic][gid]

    def __enter__(self):
        """Be held while in use, as the handle of a node; it is its own."""

    def __exit__(self, *_):
        pass

    @property
    def handle(self):
        return self

    def get_count_publishers(self, topic):
        return len(self.writers.get(topic, {}))

    def get_publishers_info_by_topic(self, topic):
        self.asked += 1
        return [SimpleNamespace(node_name=node, node_namespace='/', endpoint_gid=list(gid))
                for gid, node in self.writers.get(topic, {}).items()]

    def get_node_names_and_namespaces_with_enclaves(self):
        return self.nodes


@pytest.fixture
def roster():
    return listed(load(SCENARIOS / 'paper.yaml'), headless=True)


@pytest.fixture
def graph(roster):
    return Graph(roster)


@pytest.fixture
def look(roster, graph):
    """Return a look at the graph some time later, at which the run has begun."""
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)

    def at(seconds=0.125, begun=True):
        graph.now += seconds
        return writers.look(begun)
    return at


def told(strangers):
    return [(s.topic, s.node) for s in strangers]


@pytest.mark.parametrize('path', sorted(SCENARIOS.glob('*.yaml')), ids=lambda path: path.stem)
@pytest.mark.parametrize('processes', ['blocks', 'segments', 'one'])
def test_nobody_of_a_run_is_a_stranger(path, processes):
    scenario = load(path).with_values('/**', processes=processes)
    roster = listed(scenario, headless=False, console=True)
    graph = Graph(roster)
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    for _ in range(80):                         # longer than any patience
        graph.now += 0.25
        assert writers.look(True) == []


def test_a_second_writer_is_named_on_every_topic_at_the_next_look(roster, graph, look):
    assert look() == []
    for topic in roster.topics:
        gid, = graph.come('forger', topic, enclave='/')
        found, = look()
        assert (found.topic, found.node) == (topic, 'forger')
        assert found.code == (ALSO_WRITES if topic == '/diagnostics' else SECOND_WRITER)
        assert topic in found.words and 'node forger' in found.words
        assert look() == []                     # once
        graph.go(topic, gid)
        assert look() == []


def test_without_the_table_of_writers_nobody_would_be_named(roster, graph, look, monkeypatch):
    """The negative twin: everybody may write everywhere."""
    rule = roster.may_write('/clock')
    monkeypatch.setattr(type(roster), 'may_write', lambda self, topic: rule._replace(
        names=frozenset([*rule.names, 'forger', *roster.names]), shared=False))
    graph.come('forger', '/run/verdict', enclave='/')
    assert look() == []


def test_who_writes_for_one_look_is_named(graph, look):
    look()
    gid, = graph.come('forger', '/run/end', enclave='/')
    found = look()
    graph.go('/run/end', gid)
    assert told(found + look()) == [('/run/end', 'forger')]


@pytest.mark.parametrize('enclave', [RUN, '/'], ids=['of_this_run', 'of_none'])
def test_a_node_with_the_name_of_one_of_the_run_is_another(graph, look, enclave):
    look()
    graph.come('mission_monitor', '/run/verdict', enclave=enclave)
    found, = look()
    assert found.words == 'a second writer on /run/verdict: another node mission_monitor'


def test_a_writer_without_a_node_is_said_to_have_none(graph, look):
    look()
    gid, = graph.come('', '/run/verdict')
    assert look() == []                         # its name may be on its way
    found, = look(NAMELESS_S)
    assert found.words == 'a second writer on /run/verdict: a node without a name'
    graph.go('/run/verdict', gid)
    assert look(1.0) == []


def test_also_if_it_has_gone_before_that_is_sure(graph, look):
    look()
    gid, = graph.come('', '/run/verdict')
    assert look() == []
    graph.go('/run/verdict', gid)
    assert told(look()) == [('/run/verdict', '')]


@pytest.mark.parametrize('others, name', [(['forger'], 'forger'), (['forger', 'another'], '')])
def test_or_has_the_name_of_the_only_node_of_its_process(graph, look, others, name):
    """The name of a new writer comes after the writer, that of its node was there before."""
    look()
    for other in others:
        graph.come(other, '/parameter_events', process='hostile')
    gid, = graph.come('', '/run/verdict', process='hostile')
    found = look()
    graph.go('/run/verdict', gid)
    assert told(found + look()) == [('/run/verdict', name)]
    assert len(found) == bool(name)             # nothing is left to wait for


def test_a_group_that_comes_up_is_not_taken_for_its_first_node():
    """Its second node has writers before it has a name."""
    roster = listed(load(SCENARIOS / 'paper.yaml').with_values('/**', processes='one'), True)
    graph = Graph(roster)
    full, graph.writers = graph.writers, {}
    graph.come('link_back', '/parameter_events', process='one', enclave=None)
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    for topic, of in full.items():
        graph.writers[topic] = dict.fromkeys(of, UNKNOWN_NODE)
        graph.now += 1.0
        assert writers.look(False) == []


def test_whose_name_comes_late_is_told_by_it(graph, look):
    look()
    gid, = graph.come('', '/run/verdict')
    look()
    graph.writers['/run/verdict'][gid] = 'forger'
    assert told(look()) == [('/run/verdict', 'forger')]


def test_a_run_comes_up_node_by_node_and_by_names_that_are_not_known_yet(roster):
    full = Graph(roster)
    graph = Graph(roster)
    graph.writers = {}
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    for topic, of in full.writers.items():
        graph.writers[topic] = dict.fromkeys(of, UNKNOWN_NODE)
        graph.now += 10.0
        assert writers.look(False) == []        # nobody begins before the names are known
    graph.now += 0.125
    assert writers.look(True) == []             # this process may be late to hear them
    for topic, of in full.writers.items():
        graph.now += 0.125
        graph.writers[topic] = of
        assert writers.look(True) == []


def test_a_name_that_never_comes_is_said_in_the_end(graph, look):
    graph.writers['/run/verdict'] = dict.fromkeys(graph.writers['/run/verdict'], UNKNOWN_NODE)
    assert look() == []
    assert look(LATE_S - 0.25) == []
    assert told(look(0.25)) == [('/run/verdict', 'mission_monitor')]


def test_a_node_that_leaves_is_none_though_its_name_is_taken_first(graph, look):
    look()
    writers = graph.writers['/run/verdict']
    writers.update(dict.fromkeys(writers, UNKNOWN_NODE))
    assert look(LATE_S + 1.0) == []
    writers.clear()
    assert look() == []


@pytest.mark.parametrize('same', [True, False])
def test_one_that_was_taken_for_dead_and_is_found_again_is_the_same(graph, look, same):
    """All of a run stood still: its name comes late then. The negative twin has another id."""
    look()
    writers = graph.writers['/run/verdict']
    gid, = writers
    writers.clear()
    assert look() == []
    writers[gid if same else gid[:-1] + b'x'] = UNKNOWN_NODE
    assert look() == []
    assert [s.topic for s in look(LATE_S + 1.0)] == ([] if same else ['/run/verdict'])


@pytest.mark.parametrize('node, topic', [('link_back', '/link/back/status'),
                                         ('other_mission', '/run/verdict')])
def test_nodes_of_another_run_get_the_time_to_leave(graph, look, node, topic):
    """They write nothing, since they end as soon as they notice this one."""
    look()
    gid, = graph.come(node, topic, enclave=new_run())
    assert look() == [] and look(OTHER_RUN_S - 0.25) == []
    graph.writers[topic][gid] = UNKNOWN_NODE    # it leaves, its name first
    assert look() == []
    graph.go(topic, gid)
    assert look(1.0) == []


def test_their_writers_may_be_seen_long_before_their_names(graph, look):
    """On a machine that has much to do; the names of some are known first."""
    look()
    graph.crowd = 10.0
    writers = [graph.come('', topic)[0] for topic in ('/run/verdict', '/link/back/status')]
    assert look() == [] and look(NAMELESS_S*9) == []
    graph.nodes.append(('link_back', '/', new_run()))
    assert look() == []
    graph.nodes.pop()
    graph.go('/run/verdict', writers[0])
    assert look() == [] and look(OTHER_RUN_S/2) == []
    assert told(look(OTHER_RUN_S)) == [('/link/back/status', '')]


@pytest.mark.parametrize('processes', ['blocks', 'segments', 'one'])
def test_of_two_runs_that_come_up_at_once_neither_is_a_stranger_to_the_other(processes):
    """The other one is seen first, and leaves when it notices this one."""
    roster = listed(load(SCENARIOS / 'paper.yaml').with_values('/**', processes=processes), True)
    graph, ours = Graph(roster), Graph(roster)
    graph.nodes = [(node, place, new_run()) for node, place, _ in graph.nodes]
    others = {topic: set(of) for topic, of in graph.writers.items()}
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    assert writers.look(False) == []
    graph.nodes += ours.nodes
    for topic, of in ours.writers.items():
        graph.now += 0.125
        graph.writers[topic] |= {b'ours' + gid[4:]: node for gid, node in of.items()}
        assert writers.look(False) == []
    for topic, of in others.items():
        graph.now += 0.125
        for gid in of:
            graph.go(topic, gid)
        assert writers.look(False) == []
    graph.nodes = ours.nodes
    for _ in range(200):
        graph.now += 0.125
        assert writers.look(True) == []
    graph.come('mission_monitor', '/run/events', enclave='/')
    graph.now += 0.125
    assert told(writers.look(True)) == [('/run/events', 'mission_monitor')]


@pytest.mark.parametrize('comes', [True, False])
def test_a_node_of_another_run_that_comes_or_leaves_during_a_look_is_one_of_it(
        graph, look, comes, monkeypatch):
    """Nodes and writers are asked for one after the other."""
    look()
    node = ('link_back', '/', new_run())
    topic = '/link/back/status'
    if comes:
        graph.come('other', '/run/verdict', enclave=node[2])
    graph.come('link_back', topic, enclave=None)
    graph.nodes += [] if comes else [node]
    asked = graph.get_publishers_info_by_topic

    def meanwhile(of):
        found = asked(of)
        if of == topic:
            graph.nodes[:] = [n for n in graph.nodes if n != node] + [node]*comes
        return found
    monkeypatch.setattr(graph, 'get_publishers_info_by_topic', meanwhile)
    assert look() == []


def test_and_who_stays_is_a_stranger(graph, look):
    look()
    graph.come('link_back', '/link/back/status', enclave=new_run())
    look()
    assert told(look(OTHER_RUN_S)) == [('/link/back/status', 'link_back')]


def test_a_stranger_does_not_hide_behind_another_run(graph, look):
    look()
    graph.come('link_back', '/link/back/status', enclave=new_run())
    graph.come('link_back', '/link/back/status', enclave='/')
    assert told(look()) == [('/link/back/status', 'link_back')]


@pytest.mark.parametrize('processes, name', [('blocks', 'forger'), ('blocks', 'link_back'),
                                             ('one', 'forger'), ('one', 'link_back')])
def test_where_all_nodes_write_a_stranger_has_not_their_name_or_not_their_process(processes, name):
    """In a group one node speaks for all, so the name of another is still free."""
    roster = listed(load(SCENARIOS / 'paper.yaml').with_values('/**', processes=processes), True)
    graph = Graph(roster)
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    assert writers.look(True) == []
    graph.come(name, '/run/events', enclave='/')
    graph.now += 0.125
    assert told(writers.look(True)) == [('/run/events', name)]


@pytest.mark.parametrize('driver', ['joy_node', 'external'])
def test_a_driver_of_any_name_has_the_stick_and_a_second_one_is_named(driver):
    scenario = parse(f"""/**: {{ros__parameters: {{operator: joy, joy_input: held, pace: realtime,
                         joy_driver: {driver}}}}}""", 'mine')
    roster = listed(scenario, headless=True)
    graph = Graph(roster)
    graph.writers['/joy'] = {}
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    assert writers.look(True) == []
    first, = graph.come('my_driver', '/joy', enclave='/')
    graph.now += 0.125
    assert writers.look(True) == []
    graph.come('a_second_pilot', '/joy', enclave='/')
    graph.now += 0.125
    assert told(writers.look(True)) == [('/joy', 'a_second_pilot')]


def test_a_driver_that_has_ended_may_be_replaced():
    scenario = parse("""/**: {ros__parameters: {operator: joy, joy_input: held, pace: realtime,
                     joy_driver: external}}""", 'mine')
    roster = listed(scenario, headless=True)
    graph = Graph(roster)
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    graph.writers['/joy'] = {}
    for name in ('first', 'second'):
        gid, = graph.come(name, '/joy', enclave='/')
        for _ in range(10):
            graph.now += 0.125
            assert writers.look(True) == []
        graph.go('/joy', gid)


def test_a_quiet_graph_is_asked_for_numbers_alone(graph, look):
    look()
    look(1.125)
    asked = graph.asked
    for _ in range(3):
        look()
    assert graph.asked == asked


def test_who_has_left_a_trace_alone_is_told_after_a_moment(roster, graph):
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    for later, expected in ((0.125, []), (NAMED_S, [('/run/pause', '')]), (1.0, [])):
        graph.now += later
        assert told(writers.look(True, ['/run/pause'])) == expected


def test_and_by_the_name_that_was_seen_meanwhile(roster, graph):
    writers = Writers(roster, RUN, graph, lambda: graph.now, lambda: graph.crowd)
    assert writers.look(True, ['/run/pause']) == []
    gid, = graph.come('forger', '/run/pause', enclave='/')
    graph.now += 0.125
    assert told(writers.look(True, ['/run/pause'])) == [('/run/pause', 'forger')]
    graph.go('/run/pause', gid)
    graph.now += 1.0
    assert writers.look(True, ['/run/pause']) == []
