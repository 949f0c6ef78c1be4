"""Files that people write: whatever lies there, reading it ends soon and is refused in one line."""

import json
import os
from pathlib import Path
import socket
import threading

import pytest
import yaml

from rvd_dynamics import given
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import coerce
from rvd_dynamics.given import bytes_of, json_in, mapping_of, object_of, rows_of, text_of, value_of
from rvd_dynamics.link.models import read_transits


def refusal(read, *args):
    """Return what is refused, which is one line."""
    with pytest.raises(BadInput) as refused:
        read(*args)
    assert str(refused.value).isprintable() and len(str(refused.value)) < 2100
    return str(refused.value)


# -- what lies at a path ---------------------------------------------------------------------------

def fifo(path: Path) -> None:
    os.mkfifo(path)


def device(path: Path) -> None:
    path.symlink_to('/dev/zero')


def socket_of(path: Path) -> None:
    folder = os.open(path.parent, os.O_RDONLY)          # its name may be too long for a socket
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(f'/proc/self/fd/{folder}/{path.name}')
    os.close(folder)


@pytest.mark.parametrize('make, said', [
    (fifo, 'pipe or a device'), (device, 'pipe or a device'), (socket_of, 'cannot read'),
    (lambda path: path.mkdir(), 'cannot read'), (lambda path: path.symlink_to(path), 'cannot read'),
    (lambda path: path.symlink_to('nowhere'), 'cannot read')])
@pytest.mark.parametrize('read', [
    lambda path: text_of(path, 'scenario'), lambda path: object_of(path, 'summary'),
    lambda path: read_transits(str(path))])
def test_what_is_no_regular_file_is_refused_at_once(tmp_path, make, said, read):
    make(tmp_path / 'given')
    assert said in refusal(read, tmp_path / 'given')


def test_a_reader_without_this_waits_for_ever_at_a_pipe(tmp_path):
    """The negative twin: what `open` does there."""
    os.mkfifo(tmp_path / 'pipe')
    waiting = threading.Thread(target=lambda: (tmp_path / 'pipe').read_bytes(), daemon=True)
    waiting.start()
    waiting.join(0.3)
    assert waiting.is_alive()
    with (tmp_path / 'pipe').open('wb'):            # lets it go
        pass
    waiting.join()


def test_a_file_without_an_end_costs_no_memory(tmp_path):
    with (tmp_path / 'sparse').open('wb') as file:
        file.truncate(1 << 40)
    assert 'larger than 512 KiB' in refusal(text_of, tmp_path / 'sparse', 'scenario')
    assert 'larger than 3 KiB' in refusal(bytes_of, tmp_path / 'sparse', 'tape', 3 << 10)


# -- YAML ------------------------------------------------------------------------------------------

BOMB = 'a: &a [x, x, x, x]\n' + ''.join(
    f'{chr(98 + i)}: &{chr(98 + i)} [{", ".join(["*" + chr(97 + i)] * 4)}]\n' for i in range(9))


@pytest.mark.parametrize('text, said', [
    (BOMB, 'aliases are not allowed'), ('a: &a 1', 'aliases are not allowed'),
    ('a: !!timestamp x', 'tags such as'), ('a: !!set {b}', 'tags such as'),
    ('seed: 1\n' * 40_000, 'more than 10000'), ('a: 1\n' * 50, 'given twice: a'),
    ('a: ' + '[' * 30 + ']' * 30, 'deeper than 20'), ('a: ' + '[' * 200_000, 'deeper than 20'),
    ('a: 1' + '0' * 5000, '400 are the most'), ('a: 0x' + 'f' * 5000, '400 are the most'),
    ('a: 1' + ':59' * 50_000, '400 are the most'), ('a: 1' + ':5' * 180 + '.5', 'too large'),
    ('x' * (1 << 20), 'larger than 512 KiB'), ('? [a, b]\n: 1', 'not valid YAML')])
def test_yaml_that_a_file_of_ours_never_needs_is_refused(text, said):
    assert said in refusal(mapping_of, text, 'scenario x')


def test_a_plain_loader_takes_it():
    """The negative twin: an alias bomb and keys given twice are YAML."""
    made = yaml.safe_load(BOMB)
    assert made['j'][3][3][3][0] is made['j'][0][0][0][0]
    assert yaml.safe_load('a: 1\na: 2') == {'a': 2}


def test_what_people_write_is_read_as_it_was():
    text = 'a: {b: [1, 2.5, x], c: ~, "d": true}\ne: 2026-11-28\nf: {}\n'
    assert mapping_of(text, 'x') == yaml.safe_load(text)
    assert value_of('[1, 2e-4]') == [1, '2e-4']


def test_a_whole_number_that_no_float_holds_is_refused_by_its_key():
    assert 'timeout_s must be within' in refusal(coerce, 'timeout_s', 10**309, 1.0)
    assert coerce('timeout_s', 10**300, 1.0) == 1e300


# -- JSON and tables -------------------------------------------------------------------------------

@pytest.mark.parametrize('text, said', [
    ('[' * 100_000, 'nested too deeply'), ('{"a": 1, "b": 2, "a": 3}', 'given twice: a'),
    ('{"a": ' + '9' * 5000 + '}', 'damaged'), ('{', 'damaged'), ('', 'damaged')])
def test_json_that_is_none_is_refused(text, said):
    assert said in refusal(json_in, text, 'summary.json')


def test_json_is_read_as_it_is(tmp_path):
    content = {'a': [1, {'b': None}], 'c': 'x'}
    (tmp_path / 'x.json').write_text(json.dumps(content))
    assert object_of(tmp_path / 'x.json', 'summary') == content
    (tmp_path / 'x.json').write_text('[1]')
    assert 'holds no object' in refusal(object_of, tmp_path / 'x.json', 'summary')


def test_a_cell_without_an_end_is_refused_by_its_line():
    assert 'x.csv, line 2: not CSV' in refusal(
        lambda: list(rows_of('a,b\n"' + 'x' * 200_000, 'x.csv')))
    assert list(rows_of('a,b\n1,"2\n3"\n', 'x.csv')) == [(1, ['a', 'b']), (3, ['1', '2\n3'])]


def test_limits_leave_room_for_what_is_written_here():
    root = Path(given.__file__).resolve().parents[4]
    for path in (*root.glob('scenarios/*.yaml'), *root.glob('campaigns/*.yaml')):
        assert path.stat().st_size < given.MAX_BYTES / 20
