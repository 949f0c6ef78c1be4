"""One DDS domain for each run: who holds it, and locks that nobody else can reach."""

import multiprocessing
import os
import socket

import pytest

from rvd_campaign.exits import CannotRun
from rvd_campaign.flight import domain as domains
from rvd_campaign.flight.domain import reserved_domain

AS_ROOT = pytest.mark.skipif(os.getuid() != 0, reason='only root can give away')


@pytest.fixture(autouse=True)
def runtime(tmp_path, monkeypatch):
    """Return a runtime folder of this test's own."""
    folder = tmp_path / 'runtime'
    folder.mkdir(mode=0o700)
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(folder))
    monkeypatch.setenv('TMPDIR', str(tmp_path))
    monkeypatch.setattr(domains.tempfile, 'tempdir', None)
    monkeypatch.delenv('ROS_DOMAIN_ID', raising=False)
    return folder


@pytest.mark.parametrize('number', ['0', '7', '232'])
def test_a_second_run_in_a_domain_of_the_users_own_says_who_holds_it(monkeypatch, number):
    monkeypatch.setenv('ROS_DOMAIN_ID', number)
    with reserved_domain() as domain:
        assert domain == int(number)
        domain.held_for('/data/runs/first')
        with pytest.raises(CannotRun, match=rf'ROS_DOMAIN_ID={number} is held by another run '
                           rf'\(process {os.getpid()}, /data/runs/first, since \d{{4}}-.*unset'):
            reserved_domain().__enter__()
    with reserved_domain():
        pass


def test_the_lock_goes_with_the_process_that_held_it(monkeypatch):
    monkeypatch.setenv('ROS_DOMAIN_ID', '9')
    fork = multiprocessing.get_context('fork')
    held = fork.Event()

    def hold():
        with reserved_domain():
            held.set()
            fork.Event().wait()
    child = fork.Process(target=hold)
    child.start()
    assert held.wait(10.0)
    with pytest.raises(CannotRun, match=f'process {child.pid}'):
        reserved_domain().__enter__()
    child.kill()
    child.join()
    with reserved_domain() as domain:
        assert domain == 9


def test_a_chosen_domain_is_one_that_nobody_holds(monkeypatch):
    monkeypatch.setattr(domains, 'IDS', range(3, 5))
    monkeypatch.setattr(domains, '_busy', set)
    with reserved_domain() as first, reserved_domain() as second:
        assert {first, second} == {3, 4}
        with pytest.raises(CannotRun, match='every DDS domain id'):
            reserved_domain().__enter__()


def test_a_domain_is_not_chosen_where_somebody_uses_its_ports(monkeypatch):
    monkeypatch.setattr(domains, 'IDS', range(97, 99))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(('127.0.0.1', 7400 + 250 * 97 + 11))     # discovery of a participant there
        for _ in range(8):
            with reserved_domain() as domain:
                assert domain == 98


@pytest.mark.parametrize('given', ['233', '-1', '1e1', '²', 'five', ' 5'])
def test_what_is_no_domain_id_is_refused(monkeypatch, given):
    monkeypatch.setenv('ROS_DOMAIN_ID', given)
    with pytest.raises(CannotRun, match='ROS_DOMAIN_ID must be a whole number from 0 to 232'):
        reserved_domain().__enter__()


# -- the folder of the locks ---------------------------------------------------------------------

def test_locks_stand_in_the_users_runtime_folder_for_nobody_else(runtime):
    with reserved_domain() as domain:
        folder = runtime / 'rvd-domains'
        assert folder.stat().st_mode & 0o777 == 0o700
        assert (folder / str(domain)).stat().st_mode & 0o777 == 0o600


def test_without_a_runtime_folder_of_the_users_own_they_stand_in_the_temporary_one(
        runtime, tmp_path, monkeypatch):
    runtime.chmod(0o777)
    for given in (str(runtime), str(tmp_path / 'none'), ''):
        monkeypatch.setenv('XDG_RUNTIME_DIR', given)
        with reserved_domain() as domain:
            assert (tmp_path / f'rvd-domains-{os.getuid()}' / str(domain)).exists()
    assert not list(runtime.iterdir())


def planted_link(place, tmp_path):
    (tmp_path / 'elsewhere').mkdir()
    place.symlink_to(tmp_path / 'elsewhere')


def planted_file(place, tmp_path):
    place.write_text('')


def writable_by_all(place, tmp_path):
    place.mkdir()
    place.chmod(0o777)


def of_somebody_else(place, tmp_path):
    place.mkdir()
    os.chown(place, 12345, -1)


@pytest.mark.parametrize('plant', [planted_link, planted_file, writable_by_all, pytest.param(
    of_somebody_else, marks=AS_ROOT)])
def test_a_folder_that_another_user_may_have_planted_is_refused(tmp_path, monkeypatch, plant):
    monkeypatch.setenv('XDG_RUNTIME_DIR', '')
    plant(tmp_path / f'rvd-domains-{os.getuid()}', tmp_path)
    with pytest.raises(CannotRun, match=r'rvd-domains-\d+ must be a folder of your own'):
        reserved_domain().__enter__()
    assert not list((tmp_path / 'elsewhere').glob('*'))


def test_a_planted_link_is_not_written_through(runtime, tmp_path, monkeypatch):
    monkeypatch.setenv('ROS_DOMAIN_ID', '5')
    precious = tmp_path / 'precious'
    precious.write_text('years of work')
    (runtime / 'rvd-domains').mkdir(mode=0o700)
    (runtime / 'rvd-domains' / '5').symlink_to(precious)
    with pytest.raises(CannotRun, match='cannot lock'):
        reserved_domain().__enter__()
    assert precious.read_text() == 'years of work'


def planted_hard_link(place, precious):
    os.link(precious, place)


def planted_pipe(place, precious):
    os.mkfifo(place)


def of_another_owner(place, precious):
    place.write_text('')
    os.chown(place, 12345, -1)


@pytest.mark.parametrize('plant', [planted_hard_link, planted_pipe, pytest.param(
    of_another_owner, marks=AS_ROOT)])
def test_a_lock_that_was_planted_is_refused_and_left_alone(runtime, tmp_path, monkeypatch, plant):
    """As when the folder could be written to by others before: a second name is not followed."""
    monkeypatch.setenv('ROS_DOMAIN_ID', '5')
    precious = tmp_path / 'precious'
    precious.write_text('years of work')
    (runtime / 'rvd-domains').mkdir(mode=0o700)
    plant(runtime / 'rvd-domains' / '5', precious)
    with pytest.raises(CannotRun, match='5: it is no file of your own alone: remove it'):
        reserved_domain().__enter__()
    assert precious.read_text() == 'years of work'
    assert domains._who_holds(runtime / 'rvd-domains' / '5') == ''


def test_a_plain_lock_writes_through_a_hard_link(tmp_path):
    """The negative twin: not to follow links is not enough."""
    precious = tmp_path / 'precious'
    precious.write_text('years of work')
    planted_hard_link(tmp_path / '5', precious)
    file = os.open(tmp_path / '5', os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW)
    os.ftruncate(file, 0)
    os.close(file)
    assert precious.read_text() == ''


@pytest.mark.skipif(os.getuid() != 0, reason='only root can become another user')
def test_another_user_cannot_have_our_files_emptied(runtime, tmp_path, monkeypatch):
    """A folder in /tmp that somebody else made before, with links to a file of ours inside."""
    monkeypatch.setenv('XDG_RUNTIME_DIR', '')
    monkeypatch.setenv('ROS_DOMAIN_ID', '5')
    precious = tmp_path / 'precious'
    precious.write_text('years of work')
    for folder in (tmp_path, *tmp_path.parents):
        if str(folder).startswith('/tmp/'):
            folder.chmod(folder.stat().st_mode | 0o055)
    tmp_path.chmod(0o1777)

    def other() -> None:
        os.setgid(65534)
        os.setuid(65534)
        place = tmp_path / 'rvd-domains-0'
        place.mkdir()
        (place / '5').symlink_to(precious)
        place.chmod(0o700)
    child = multiprocessing.get_context('fork').Process(target=other)
    child.start()
    child.join()
    assert child.exitcode == 0
    with pytest.raises(CannotRun, match='rvd-domains-0 must be a folder of your own'):
        reserved_domain().__enter__()
    assert precious.read_text() == 'years of work'
