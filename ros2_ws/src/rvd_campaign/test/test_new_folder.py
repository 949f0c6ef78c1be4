"""The name of a run folder: of two commands that want it at the same moment one gets it."""

from concurrent.futures import ThreadPoolExecutor
import multiprocessing
import threading

import numpy as np
import pytest

from rvd_campaign import catalogue
from rvd_campaign.exits import CannotRun, EXIT_CANNOT
from rvd_campaign.flight import run_folder as folders
from rvd_dynamics.diagram.scenario import load

AT_ONCE = 24
TRIES = 100


@pytest.fixture
def here(tmp_path, monkeypatch):
    """Work in a folder of the test's own, in which time stands still."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(folders.time, 'strftime', lambda _: '20260101-000000')
    return tmp_path


def at_once(call):
    """Return what many threads get that make a call at the same moment: results, refusals."""
    gate = threading.Barrier(AT_ONCE)

    def one(_):
        gate.wait()
        try:
            return call()
        except CannotRun as error:
            return error
    with ThreadPoolExecutor(AT_ONCE) as pool:
        found = list(pool.map(one, range(AT_ONCE)))
    refused = [f for f in found if isinstance(f, CannotRun)]
    return [f for f in found if f not in refused], refused


def test_runs_that_begin_in_the_same_second_get_a_folder_each(here):
    made, refused = at_once(lambda: folders.new_folder(None, 'paper'))
    assert len({*made}) == AT_ONCE and not refused
    assert all(folder.is_dir() and not any(folder.iterdir()) for folder in made)


@pytest.mark.parametrize('exists', [False, True], ids=['new', 'empty'])
def test_a_folder_that_many_name_is_taken_by_one_of_them(here, exists):
    if exists:
        (here / 'mine').mkdir()
    scenario = load(catalogue.find('scenarios', 'paper', ('.yaml',)))

    def begin():
        folder = folders.new_folder('mine', 'paper')
        folders.keep_scenario(folder, scenario)
        return folder
    made, refused = at_once(begin)
    assert len(made) == 1 and len(refused) == AT_ONCE - 1
    assert all('--out mine' in str(error) for error in refused)
    assert (here / 'mine' / 'scenario.yaml').read_text() == scenario.dump()


def test_of_two_processes_one_gets_the_folder_in_every_of_many_tries(here):
    fork, scenario = multiprocessing.get_context('fork'), load(
        catalogue.find('scenarios', 'paper', ('.yaml',)))
    gate, codes = fork.Barrier(2), fork.Array('i', 2*TRIES)

    def begin(which):
        for i in range(TRIES):
            gate.wait()
            try:
                folders.keep_scenario(folders.new_folder(f'mine{i}', 'paper'), scenario)
            except CannotRun:
                codes[2*i + which] = EXIT_CANNOT
    both = [fork.Process(target=begin, args=(which,)) for which in range(2)]
    for process in both:
        process.start()
    for process in both:
        process.join()
        assert process.exitcode == 0
    pairs = np.reshape(codes[:], (TRIES, 2))
    assert (pairs.sum(axis=1) == EXIT_CANNOT).all() and len({*map(tuple, pairs)}) <= 2


@pytest.mark.parametrize('plant', [lambda p: p.write_text(''), lambda p: p.symlink_to('/nowhere'),
                                   lambda p: (p / 'bag').mkdir(parents=True)],
                         ids=['file', 'dangling link', 'run'])
def test_what_is_there_is_not_written_into(here, plant):
    plant(here / 'mine')
    with pytest.raises(CannotRun, match='--out mine|run folder mine'):
        folders.new_folder('mine', 'paper')
