"""The page of a run, on which its processes give signs of life; and the line to who started it."""

import os
import signal
import subprocess
import sys
import time

import pytest

from rvd_dynamics import lifeline, pulse
from rvd_dynamics.diagram.roster import COUNTED
from rvd_dynamics.pulse import Pulse


def test_what_a_process_notes_the_one_that_made_the_page_sees():
    page = Pulse.shared(3)
    assert (page.flown, page.final, len(page)) == (-1, -1, 3)
    assert [page.beaten_s(place) for place in range(3)] == [None]*3
    code = ('import time; from rvd_dynamics import pulse; page = pulse.Pulse.inherited();'
            'page.beat(1, time.monotonic_ns()); page.beat(2, 5); page.leave(2); page.flown = 7;'
            'page.final = 9; print(len(page), page.mark(7), page.mark(pulse.MARKS))')
    begun = time.monotonic()
    done = subprocess.run([sys.executable, '-c', code], pass_fds=(page.file,), text=True,
                          env={**os.environ, pulse.PAGE: str(page.file)}, capture_output=True)
    assert done.stdout == '3 True False\n', done.stderr
    assert page.marked == [7]
    assert begun < page.beaten_s(1) < time.monotonic()          # one clock for all
    assert (page.beaten_s(0), page.beaten_s(2), page.flown, page.final) == (None, None, 7, 9)
    assert not any(page.left_early(place) for place in range(3))
    page.leave(1, early=True)
    assert page.beaten_s(1) is None and page.left_early(1)
    with pytest.raises(PermissionError):        # nobody can take it from under the others
        os.ftruncate(page.file, 0)
    page.handed_on()


def test_what_each_process_counts_is_added_up_for_each_topic():
    page = Pulse.shared(3)
    code = ('from rvd_dynamics import pulse; page = pulse.Pulse.inherited();'
            '[page.write(2, 1) for _ in range(5)]; page.write(0, 0); page.beat(2, 1)')
    subprocess.run([sys.executable, '-c', code], check=True, pass_fds=(page.file,),
                   env={**os.environ, pulse.PAGE: str(page.file)})
    page.write(1, 1)
    page.mark(0)
    for place, begins in ((0, True), (1, False)):
        page.compile(place, begins, 7_000_000_000)
    assert [page.compiled_s(place) for place in range(3)] == [
        (True, 7.0), (False, 7.0), (False, 0.0)]
    page.say('SILENT', 1, 'law')
    assert [page.written(count) for count in range(pulse.COUNTS)] == [1, 6, 0]
    assert (page.flown, page.final, page.lost, page.beaten_s(1)) == (-1, -1, 0, None)
    assert COUNTED and len(COUNTED) <= pulse.COUNTS
    page.handed_on()


def test_what_is_said_on_the_page_is_heard_once_and_never_beyond_its_end():
    page = Pulse.shared(2)
    assert page.heard(0) == ([], 0)
    page.say('SILENT', 3, 'law has given\nno sign')
    page.say('GIVEN_UP', 4, 'the end \u2713')
    said, known = page.heard(0)
    assert said == [('SILENT', 3, 'law has given no sign'), ('GIVEN_UP', 4, 'the end \u2713')]
    assert page.heard(known) == ([], known)
    for k in range(1000):
        page.say('SILENT', k, 'x'*100)
    said, known = page.heard(known)
    assert known <= pulse.TEXT < known + 200
    assert [step for _, step, _ in said] == list(range(len(said)))
    assert page.beaten_s(0) is None and page.beaten_s(1) is None and page.flown == -1
    page.handed_on()


@pytest.mark.parametrize('given', ['', 'x', '-1', '77777', '1e3', 'another file'])
def test_without_a_page_a_process_has_one_of_its_own(given, monkeypatch, tmp_path):
    with (tmp_path / 'file').open('w+b') as other:
        other.write(bytes(64))
        other.flush()
        monkeypatch.setenv(pulse.PAGE, str(other.fileno()) if given == 'another file' else given)
        page = Pulse.inherited()
        page.beat(0, 3_000_000_000)
        assert (page.file, len(page), page.beaten_s(0), page.flown) == (-1, 1, 3.0, -1)
        assert not page.mark(0) and page.marked == []           # nobody else sees it
        assert (tmp_path / 'file').read_bytes() == bytes(64)


# What a node does under a bring-up: it looks at the line now and then.
NODE = """
import sys, time
from rvd_dynamics import lifeline
lifeline.PATIENCE_S = 1.0
while True:
    lifeline.look(time.monotonic())
    time.sleep(0.05)
"""
BRING_UP = f"""
import os, subprocess, sys, time
os.environ['RVD_PARENT'] = str(os.getpid())
child = subprocess.Popen([sys.executable, '-c', {NODE!r}], close_fds=False)
print(child.pid, flush=True)
time.sleep(60)
"""


def state(pid):
    try:
        with open(f'/proc/{pid}/stat') as stat:
            return stat.read().rsplit(')', 1)[1].split()[0]
    except OSError:
        return ''


@pytest.mark.parametrize('cut', [True, False])
def test_a_node_lets_a_stopped_bring_up_go_on_when_the_command_has_gone(cut):
    """And ends it, if it does not end; not while the command is there."""
    line, ours = os.pipe()
    os.set_inheritable(line, True)
    bring_up = subprocess.Popen([sys.executable, '-c', BRING_UP], pass_fds=(line,), text=True,
                                stdout=subprocess.PIPE, env={**os.environ,
                                                             lifeline.LINE: str(line)})
    os.close(line)
    node = int(bring_up.stdout.readline())
    try:
        os.kill(bring_up.pid, signal.SIGSTOP)
        deadline = time.monotonic() + 20.0
        if not cut:
            time.sleep(0.6)
            assert state(bring_up.pid) == 'T'
            return
        os.close(ours)
        while state(bring_up.pid) == 'T':
            assert time.monotonic() < deadline
            time.sleep(0.02)
        assert bring_up.wait(20.0) == -signal.SIGKILL
    finally:
        os.kill(node, signal.SIGKILL)
        bring_up.kill()
        bring_up.wait()
        bring_up.stdout.close()
        if not cut:
            os.close(ours)
