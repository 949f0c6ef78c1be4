"""
The identity of a run: which of the nodes in a DDS domain are its own.

Two runs may meet in one domain: of two users, or of two machines. Node names and topics are the
same in both, so every process of a run is started in an enclave of the run's own (`--enclave
/rvd/HOST/run_UUID`): a name that ROS gives to each process and shows to all others, and that costs
no message a byte. A process does not begin, and fires nothing, while a node of another run is
there, and says on `/run/ready` in which run it is ready. Nodes that are started by hand are in
no run in particular; they belong together.

It imports no ROS.
"""

from collections.abc import Collection, Iterable
import os
import re
import socket
import uuid

AREA = '/rvd/'
READY = re.compile(r'[A-Za-z0-9_]{1,255}( /rvd/[A-Za-z0-9_]{1,255}/run_[0-9a-f]{32})?')
LARGEST_DOMAIN = 232            # a larger ROS_DOMAIN_ID has no ports (DDSI-RTPS 9.6.1.4)


def new_run() -> str:
    """Return the enclave of a new run, which no other run of any machine has."""
    host = re.sub('[^A-Za-z0-9_]', '_', socket.gethostname()) or 'host'
    return f'{AREA}{host}/run_{uuid.uuid4().hex}'


def own_run(arguments: list[str]) -> str:
    """Return the enclave in which ROS puts a process with these arguments."""
    given = [word for flag, word in zip(arguments, arguments[1:]) if flag in ('-e', '--enclave')]
    return os.environ.get('ROS_SECURITY_ENCLAVE_OVERRIDE', '') or (given[-1] if given else '/')


def in_words(run: str) -> str:
    """Return what a person is told of a run: its id, and the machine it was started on."""
    if not run.startswith(AREA):
        return 'a node started by hand, or of another version'
    _, _, host, name = run.split('/', 3)
    return f'run {name.removeprefix("run_")} of machine {host}'


def ready_words(node: str, run: str) -> str:
    """Return what a node of a run says on /run/ready."""
    return f'{node} {run}' if run.startswith(AREA) else node


def is_ready_words(words: str) -> bool:
    """Say whether that is what a node says on /run/ready: its name, and its run if any."""
    return READY.fullmatch(words) is not None


def who_is_ready(words: str, run: str) -> tuple[str, str]:
    """Return which node is ready, and in which run: `run` where it does not say."""
    node, _, said = words.partition(' ')
    return node, said or run


def foreign(nodes: Iterable[tuple[str, str, str]], names: Collection[str], run: str) -> str:
    """
    Return in words a node of another run; empty where there is none.

    Parameters
    ----------
    nodes : iterable of (name, namespace, enclave)
        Every node in the domain.
    names : collection of str
        The nodes of this run, by name: only they can be taken for one another.
    run : str
        Enclave of this run.
    """
    for name, namespace, enclave in nodes:
        if name in names and namespace == '/' and enclave != run:
            return f'{name} of {in_words(enclave)}'
    return ''
