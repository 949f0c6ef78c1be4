"""
Settings of the console as a node started by hand; `./rvd fly` has options for them.
"""

from rvd_dynamics.diagram.params import param, settings
from rvd_groundstation.console.access import check_bind


@settings
class ConsoleParams:
    """Where the console listens."""

    bind: str = param(
        '127.0.0.1', 'Address to listen on, which needs TLS unless it is the loopback address.')
    port: int = param(
        8480, 'Port to listen on, where 0 takes any free one.', low=0, high=65535)
    tls_cert: str = param('', 'File of the TLS certificate.')
    tls_key: str = param('', 'File of the private key of the TLS certificate.')

    def __post_init__(self) -> None:
        check_bind(self.bind, self.tls_cert, self.tls_key)
