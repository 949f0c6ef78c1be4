"""
Settings of the console as a node started by hand; `./rvd fly` has options for them.
"""

from dataclasses import dataclass

from rvd_dynamics.diagram.params import param
from rvd_groundstation.console.access import check_bind


@dataclass(frozen=True)
class ConsoleParams:
    """Where the console listens."""

    bind: str = param('127.0.0.1', 'Address to listen on; any other one needs TLS.')
    port: int = param(8480, 'Port to listen on; 0: any free one.')
    tls_cert: str = param('', 'File of the TLS certificate.')
    tls_key: str = param('', 'File of its key.')

    def __post_init__(self) -> None:
        check_bind(self.bind, self.tls_cert, self.tls_key)
