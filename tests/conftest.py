"""Flights that several tests look at; each is flown once per session."""

from pathlib import Path

import pytest
from console_page import chromium, FLAGS, playwright, web_sources
from runs import end, rvd, start_rvd


class Flown:
    """A run that has ended: its folder, exit code and output."""

    def __init__(self, run: Path, *args: str) -> None:
        done = rvd('fly', *args, '--out', str(run), cwd=run.parent)
        self.run, self.code = run, done.returncode
        self.out, self.err = done.stdout, done.stderr


@pytest.fixture(scope='session')
def flight(tmp_path_factory) -> Flown:
    """The default scenario in lock step, seed 3."""
    return Flown(tmp_path_factory.mktemp('flight') / 'run', '--pace', 'lockstep', '--seed', '3')


@pytest.fixture(scope='session')
def rough_flight(tmp_path_factory) -> Flown:
    """Every fault of the link switched on, two-body truth left alone, in lock step."""
    return Flown(tmp_path_factory.mktemp('rough') / 'run', 'rough_link', '--pace', 'lockstep',
                 '--seed', '11', '--headless')


@pytest.fixture
def start(tmp_path):
    """Return a starter of `rvd ARGS` in the folder of the test; what is left is ended by pid."""
    started = []

    def start_one(*args):
        started.append(start_rvd(*args, cwd=tmp_path))
        return started[-1]
    yield start_one
    for process in started:
        end(process)


@pytest.fixture(scope='module')
def play():
    """Playwright, while the tests of a file run: its loop must not be there in others."""
    with playwright()() as made:
        yield made


@pytest.fixture(scope='module')
def browser(play):
    """A headless Chromium for the tests of a file."""
    made = play.chromium.launch(executable_path=chromium(), args=FLAGS)
    yield made
    made.close()


@pytest.fixture(scope='session')
def console_web(tmp_path_factory) -> Path:
    """The sources of the console's page with their packages, installed once."""
    return web_sources(tmp_path_factory.mktemp('web'))
