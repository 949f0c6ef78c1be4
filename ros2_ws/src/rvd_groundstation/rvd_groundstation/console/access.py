"""
Who may talk to the console: token, Host, Origin, and how often.

Host is checked against DNS rebinding, Origin against pages of other sites that open sockets
here, the tokens against everybody else on this machine: the pilot's, and the watchers', which
only lets look. These come first, and who fails them takes nothing from who does not: `Throttle`
refuses, `Pace` lets wait. No clock of its own: instants are given [s].
"""

import hmac
import secrets
from dataclasses import dataclass

from rvd_dynamics.bad_input import BadInput

LOOPBACK = ('127.0.0.1', 'localhost', '[::1]')
TOKEN_BYTES = 16                # 128 bits
SUBPROTOCOL = 'rvd.console.1'
TOKEN_PREFIX = 'token.'         # the token travels as a second subprotocol of the handshake

# What is not named is forbidden. A picture or a video of the page's own is a blob.
CONTENT_POLICY = ("default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; "
                  "worker-src 'self'; img-src 'self' blob:; media-src 'self' blob:; "
                  "base-uri 'none'; form-action 'none'; frame-ancestors 'none'")
HEADERS = {
    'Content-Security-Policy': CONTENT_POLICY,
    'X-Content-Type-Options': 'nosniff',
    'X-Frame-Options': 'DENY',
    'Referrer-Policy': 'no-referrer',
    'Cross-Origin-Opener-Policy': 'same-origin',
    'Cross-Origin-Resource-Policy': 'same-origin',
}


def new_token() -> str:
    """Return a fresh token of 128 bits, fit for a URL."""
    return secrets.token_urlsafe(TOKEN_BYTES)


def check_bind(bind: str, certificate: str, key: str) -> None:
    """
    Refuse an address that strangers can reach without TLS.

    Raises
    ------
    ValueError
        If `bind` is not a loopback address and certificate or key is missing, or if it stands
        for every address: Host could not be checked then.
    """
    if bind in ('', '0.0.0.0', '::'):
        raise BadInput(f'the console cannot bind to {bind or "nothing"}: give the one address '
                       'or name that pages will open, and TLS (--tls-cert, --tls-key)')
    if bind in ('127.0.0.1', '::1', 'localhost'):
        return
    if not (certificate and key):
        raise BadInput(f'the console binds to 127.0.0.1 only: {bind} can be reached by others '
                       'and needs TLS, give a certificate and a key (--tls-cert, --tls-key)')


@dataclass(frozen=True)
class Access:
    """The rules for one server."""

    token: str
    bind: str
    port: int
    secure: bool = False
    watch_token: str = ''       # empty: nobody may only watch

    @property
    def hosts(self) -> frozenset[str]:
        """Values of the Host header that are ours."""
        return frozenset(f'{name}:{self.port}' for name in {*LOOPBACK, self._host})

    @property
    def _host(self) -> str:
        return f'[{self.bind}]' if ':' in self.bind else self.bind

    @property
    def url(self) -> str:
        """The address to open; the token is in the fragment, which no request carries."""
        return self._address(self.token)

    @property
    def watch_url(self) -> str:
        """The address for those who only watch."""
        return self._address(self.watch_token)

    def _address(self, token: str) -> str:
        scheme = 'https' if self.secure else 'http'
        return f'{scheme}://{self._host}:{self.port}/#{token}'

    def refusal(self, host: str | None, origin: str | None, must_have_origin: bool) -> str | None:
        """Return why a request with these headers is refused, None when it is not."""
        if host not in self.hosts:
            return 'HOST'
        if origin is None:
            return 'ORIGIN' if must_have_origin else None
        scheme = 'https' if self.secure else 'http'
        return None if origin in {f'{scheme}://{ours}' for ours in self.hosts} else 'ORIGIN'

    def knows(self, token: str | None) -> bool:
        """Say whether this is the pilot's token, in a time that does not depend on it."""
        return _same(token, self.token)

    def watches(self, token: str | None) -> bool:
        """Say whether this is the token of those who only watch, likewise."""
        return _same(token, self.watch_token)

    def proofs(self, host: str, nonce: str) -> list[str]:
        """
        Return what only a server can say that has the tokens of a page, for each of them.

        A page that comes back asks for it before it shows its token: another program may have
        taken the place of a server that has ended.
        """
        words = f'{host} {nonce}'.encode()
        return [hmac.new(token.encode(), words, 'sha256').hexdigest()
                for token in (self.token, self.watch_token) if token]


def _same(token: str | None, ours: str) -> bool:
    # what is no UTF-8 in a header comes as lone surrogates
    return token is not None and ours != '' and hmac.compare_digest(
        token.encode('utf-8', 'surrogatepass'), ours.encode())


def token_of(subprotocols: list[str]) -> str | None:
    """Return the token among the subprotocols of a handshake."""
    for word in subprotocols:
        if word.startswith(TOKEN_PREFIX):
            return word[len(TOKEN_PREFIX):]
    return None


class Throttle:
    """So many per second on average, and a burst of at most `burst`."""

    def __init__(self, rate: float, burst: float) -> None:
        self._rate, self._burst = rate, burst
        self._left, self._at = burst, 0.0

    def allow(self, now: float) -> bool:
        """Take one, if there is one."""
        self._left = min(self._burst, self._left + max(now - self._at, 0.0) * self._rate)
        self._at = now
        if self._left < 1.0:
            return False
        self._left -= 1.0
        return True


class Pace:
    """So much per second on average, and at most `burst` at once; what is too much waits."""

    def __init__(self, rate: float, burst: float) -> None:
        self._rate, self._burst = rate, burst
        self._free_at = 0.0                     # when all that was let through has been paid for

    def wait_s(self, now: float, cost: float = 1.0) -> float:
        """Take `cost`; return for how long to wait before using it [s]."""
        self._free_at = max(self._free_at, now - self._burst / self._rate) + cost / self._rate
        return max(self._free_at - now, 0.0)
