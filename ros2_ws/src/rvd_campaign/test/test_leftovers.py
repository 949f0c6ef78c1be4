"""Shared memory of dead processes is removed, that of living ones and of others is not."""

import fcntl
import os

import pytest

from rvd_campaign.flight import domain as domains
from rvd_campaign.flight import leftovers
from rvd_campaign.flight.domain import reserved_domain

DEAD, ALIVE, FRESH, BARE = (f'fastrtps_{number:016x}' for number in range(4))
LONG_AGO_S = 3600.0


@pytest.fixture
def shm(tmp_path, monkeypatch):
    """Return a folder with what living and dead processes have in /dev/shm, and the locks held."""
    (tmp_path / 'runtime').mkdir(mode=0o700)
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(tmp_path / 'runtime'))
    monkeypatch.setenv('ROS_DOMAIN_ID', '40')
    monkeypatch.setattr(domains, '_busy', lambda: {42})
    folder = tmp_path / 'shm'
    folder.mkdir()
    for name in (DEAD, f'{DEAD}_el', ALIVE, f'{ALIVE}_el', FRESH, f'{FRESH}_el', BARE, 'mine',
                 *(f'{kind}fastrtps_port{7411 + 250*d}{end}' for d in (40, 41, 42, 43)
                   for kind, end in (('', ''), ('', '_el'), ('sem.', '_mutex')))):
        (folder / name).write_bytes(b'....')
    return folder


def held(path):
    file = os.open(path, os.O_RDONLY)
    fcntl.flock(file, fcntl.LOCK_EX)
    return file


def left(folder):
    return {path.name for path in folder.iterdir()}


def of_port(domain):
    port = f'fastrtps_port{7411 + 250*domain}'
    return {port, f'{port}_el', f'sem.{port}_mutex'}


def test_what_is_dead_goes_and_what_is_alive_stays(shm, monkeypatch):
    """Domain 40 is ours, 41 nobody's, in 42 somebody is, 43 another run of ours holds."""
    monkeypatch.setattr(leftovers, 'SETTLED_S', -1.0)
    files = [held(shm / f'{ALIVE}_el')]
    with reserved_domain() as own:
        monkeypatch.setenv('ROS_DOMAIN_ID', '43')
        with reserved_domain():
            removed = leftovers.remove(own, shm)
    gone = {DEAD, f'{DEAD}_el', FRESH, f'{FRESH}_el', BARE} | of_port(40) | of_port(41)
    assert left(shm) == {ALIVE, f'{ALIVE}_el', 'mine'} | of_port(42) | of_port(43)
    assert removed == (len(gone), 4*len(gone)) and removed.in_words() == ''
    assert leftovers.Removed(1436, 161_000_000).in_words().startswith(
        '1436 files of shared memory (161 MB) that dead processes had left')
    for file in files:
        os.close(file)


def test_the_reader_of_a_port_that_is_alive_keeps_it(shm, monkeypatch):
    monkeypatch.setattr(leftovers, 'SETTLED_S', -1.0)
    file = held(shm / f'fastrtps_port{7411 + 250*41}_el')
    with reserved_domain() as own:
        leftovers.remove(own, shm)
    assert of_port(41) <= left(shm) and not of_port(40) & left(shm)
    os.close(file)


def test_what_is_just_being_made_or_is_no_file_stays(shm, monkeypatch):
    (shm / BARE).unlink()
    (shm / BARE).symlink_to(shm / 'mine')
    before = left(shm)
    with reserved_domain() as own:
        assert leftovers.remove(own, shm) == (0, 0)
        monkeypatch.setattr(leftovers, 'SETTLED_S', -1.0)       # as if all were settled
        leftovers.remove(own, shm)
    assert left(shm) < before and {BARE, 'mine'} <= left(shm)


def test_what_belongs_to_another_user_stays(shm, monkeypatch):
    monkeypatch.setattr(leftovers, 'SETTLED_S', -1.0)
    monkeypatch.setattr(leftovers.os, 'getuid', lambda: os.geteuid() + 1)
    before = left(shm)
    assert leftovers.remove(domains.Domain(40), shm) == (0, 0)
    assert left(shm) == before


def test_a_machine_without_shared_memory_is_none_of_our_business(tmp_path):
    assert leftovers.remove(domains.Domain(40), tmp_path / 'none') == (0, 0)
