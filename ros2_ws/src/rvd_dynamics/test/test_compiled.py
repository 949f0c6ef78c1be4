"""While a loop is compiled, who follows the process is told; not when one is loaded."""

import os
import subprocess
import sys

from rvd_dynamics import compiling

LOOPS = """
from rvd_dynamics.compiled import compiled

@compiled
def inner(x):
    return x + 1.0

@compiled
def outer(x):
    return inner(x)*2.0
"""
CALL = """
from rvd_dynamics import compiling
told = []
compiling.follow(told.append)
import loops
assert told == [], told
assert loops.outer(1.0) == 4.0
first, told[:] = told[:], []
assert loops.outer(2.0) == 6.0 and told == []
print(first)
"""


def test_a_loop_is_told_of_once_with_those_that_it_needs_and_not_when_it_was_kept(tmp_path):
    (tmp_path / 'loops.py').write_text(LOOPS)
    said = [subprocess.run([sys.executable, '-c', CALL], cwd=tmp_path, text=True, check=True,
                           stdout=subprocess.PIPE, env={
                               **os.environ, 'NUMBA_CACHE_DIR': str(tmp_path / 'kept'),
                               'PYTHONPATH': f'{tmp_path}:{os.environ.get("PYTHONPATH", "")}'})
            .stdout for _ in range(2)]
    assert said == ['[True, False]\n', '[]\n']


def test_without_a_follower_nobody_is_told_and_the_depth_holds():
    told = []
    compiling.begin()
    compiling.follow(told.append)
    try:
        compiling.end()
        compiling.begin()
        compiling.begin()
        compiling.end()
        compiling.end()
        assert told == [False, True, False]
    finally:
        compiling.follow(None)
