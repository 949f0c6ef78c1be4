"""
Files that are there whole or not at all.
"""

import os
import signal
import subprocess
import sys

import pytest

from rvd_dynamics.recording import whole


def test_the_file_appears_when_its_content_is_whole(tmp_path):
    path = tmp_path / 'a.json'
    with whole.draft(path) as file:
        file.write(b'one')
        file.flush()
        assert not path.exists()
    assert path.read_bytes() == b'one' and os.listdir(tmp_path) == ['a.json']


def test_an_error_leaves_what_was_there_before_and_no_draft(tmp_path):
    path = tmp_path / 'a.json'
    whole.write_text(path, 'old \u00e9')
    for error in (OSError(28, 'No space left on device'), KeyboardInterrupt()):
        with pytest.raises(type(error)), whole.draft(path) as file:
            file.write(b'half')
            raise error
        assert path.read_text(encoding='utf-8') == 'old \u00e9'
        assert os.listdir(tmp_path) == ['a.json']


def test_a_killed_process_leaves_what_was_there_before(tmp_path):
    path = tmp_path / 'a.txt'
    whole.write_text(path, 'old')
    done = subprocess.run([sys.executable, '-c', f"""
import os, signal
from pathlib import Path
from rvd_dynamics.recording import whole
with whole.draft(Path({str(path)!r})) as file:
    file.write(b'half')
    file.flush()
    os.kill(os.getpid(), signal.SIGKILL)
"""])
    assert done.returncode == -signal.SIGKILL and path.read_text() == 'old'


def test_a_folder_that_does_not_exist_is_an_error(tmp_path):
    with pytest.raises(FileNotFoundError):
        whole.write_text(tmp_path / 'none' / 'a.txt', 'text')


def test_text_is_written_as_it_is_opened(tmp_path):
    with whole.draft(tmp_path / 'a.csv', 'w', newline='', encoding='utf-8') as file:
        file.write('a\r\n')
    assert (tmp_path / 'a.csv').read_bytes() == b'a\r\n'
