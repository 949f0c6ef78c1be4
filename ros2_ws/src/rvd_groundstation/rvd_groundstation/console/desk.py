"""
The experiment desk: leads a volunteer through training, flights, ratings and breaks.

A session file says which conditions are compared, how many flights each and when to rest. The
order of the conditions follows a balanced Latin square (each condition comes as often before
as after each other one), its rows dealt out by the session's seed; flight j of a volunteer has
the same seed in every condition, so that conditions are compared in pairs.

Ratings after each flight: Cooper-Harper (G. E. Cooper, R. P. Harper, NASA TN D-5153, 1969: the
decision tree gives the range, the pilot picks in it) and NASA-TLX (S. G. Hart, L. E. Staveland,
1988: six scales of 0 to 100 in steps of 5). Their mean is raw; with `tlx: weighted` a volunteer
also says, once for each condition, which scale of each of the 15 pairs counted more, and the
times a scale was chosen are its weight. All is written under a pseudonym, ratings beside the
bag, weights in the volunteer's folder; no name is ever asked.

Which flights count is said by what was flown, as `verdict.json` has it of the bag, and not by what
was asked for: a flight in another mode than its condition's, one that was paused or aborted, or
whose verdict is not to be trusted, is kept with the reason (`ratings.json`: counted, why) and flown
again, with the same start.
"""

import json
import time
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from random import Random
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.display import MODES
from rvd_dynamics.diagram.judge import ABORTED
from rvd_dynamics.given import mapping_of, object_of, text_of
from rvd_dynamics.recording import whole
from rvd_groundstation.console.counted import why_not

TLX = ('mental', 'physical', 'temporal', 'performance', 'effort', 'frustration')
TLX_KINDS = ('raw', 'weighted')
KEYS = ('title', 'seed', 'conditions', 'training', 'flights', 'break_after', 'break_s', 'tlx',
        'note')
MAX_VOLUNTEERS = 999
RATINGS, WEIGHTS = 'ratings.json', 'tlx_weights.json'
MAX_VERDICT_BYTES = 1 << 20      # [B] of a verdict.json: a few kilobytes
BROKEN_OFF = 'The last flight was broken off: it is flown again.'


@dataclass(frozen=True)
class Session:
    """A checked session file."""

    title: str
    seed: int
    conditions: dict[str, str]          # name: mode
    training: int                       # flights per condition before those that count
    flights: int                        # per condition
    break_after: int                    # flights between two breaks; 0: none
    break_s: float                      # [s] wall time
    tlx: str = 'raw'                    # one of TLX_KINDS
    note: str = ''                      # printed below the table of the report


@dataclass(frozen=True)
class Flight:
    """One flight of a volunteer's plan."""

    number: int                         # within the plan, from 1
    condition: str
    mode: str
    training: bool
    seed: int

    @property
    def folder(self) -> str:
        """Name of its run folder."""
        return f'{self.number:02d}-{self.condition}' + ('-training' if self.training else '')


def read_session(path: Path) -> Session:
    """
    Read a session file.

    Raises
    ------
    ValueError
        With one line that names the file and what is wrong.
    """
    tree = mapping_of(text_of(path, 'session'), f'session {path}')
    unknown = [key for key in tree if key not in KEYS]
    if unknown:
        raise BadInput(f'session {path}: unknown key {unknown[0]}; known: {", ".join(KEYS)}')
    conditions = tree.get('conditions')
    if not isinstance(conditions, dict) or not conditions:
        raise BadInput(f'session {path}: conditions must map names to {{mode: ...}}')
    modes = {}
    for name, body in conditions.items():
        mode = body.get('mode') if isinstance(body, dict) and set(body) == {'mode'} else None
        if not str(name).isidentifier() or mode not in MODES:
            raise BadInput(f'session {path}: condition {name!r} must be a plain word with '
                           f'mode: {", ".join(MODES)}')
        modes[str(name)] = mode
    tlx = tree.get('tlx', 'raw')
    if tlx not in TLX_KINDS:
        raise BadInput(f'session {path}: tlx must be {" or ".join(TLX_KINDS)}, got {tlx!r}')
    return Session(str(tree.get('title', path.stem)), _whole(path, tree, 'seed', 0, 1 << 30),
                   modes, _whole(path, tree, 'training', 1, 50),
                   _whole(path, tree, 'flights', 10, 200),
                   _whole(path, tree, 'break_after', 10, 1000),
                   float(_whole(path, tree, 'break_s', 60, 3600)), tlx,
                   str(tree.get('note', '')))


def _whole(path: Path, tree: dict, key: str, default: int, most: int) -> int:
    value = tree.get(key, default)
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= most:
        raise BadInput(f'session {path}: {key} must be a whole number up to {most}, '
                       f'got {value!r}')
    return value


def latin_square(n: int) -> list[list[int]]:
    """
    Return the rows of a balanced Latin square of order `n` (E. J. Williams, 1949).

    Over the rows each item stands once in each place, and each item comes directly after each
    other one equally often; an odd `n` takes 2 n rows for that.
    """
    first, low, high = [0], 1, n - 1
    while len(first) < n:
        first.append(low if len(first) % 2 else high)
        low, high = (low + 1, high) if first[-1] == low else (low, high - 1)
    rows = [[(item + shift) % n for item in first] for shift in range(n)]
    return rows if n % 2 == 0 else rows + [row[::-1] for row in rows]


def plan(session: Session, volunteer: int) -> list[Flight]:
    """Return the flights of a volunteer (1, 2, ...) in order."""
    names = list(session.conditions)
    rows = latin_square(len(names))
    Random(session.seed).shuffle(rows)
    flights: list[Flight] = []
    base = session.seed + 1000 * volunteer
    for index in rows[(volunteer - 1) % len(rows)]:
        name = names[index]
        for j in range(session.training + session.flights):
            training = j < session.training
            seed = base + (900 + j if training else j - session.training)
            flights.append(Flight(len(flights) + 1, name, session.conditions[name], training,
                                  seed))
    return flights


def cooper_harper_range(controllable: bool, adequate: bool, satisfactory: bool
                        ) -> tuple[int, int]:
    """Return the lowest and highest rating that the answers of the decision tree leave."""
    if not controllable:
        return 10, 10
    if not adequate:
        return 7, 9
    return (1, 3) if satisfactory else (4, 6)


def tlx_pairs(key: str) -> list[list[str]]:
    """Return the 15 pairs of scales in an order, and each pair in one, that hang on `key`."""
    rng = Random(key)
    shown = [rng.sample(pair, 2) for pair in combinations(TLX, 2)]
    rng.shuffle(shown)
    return shown


class Desk:
    """
    Where a session stands. `do` takes the requests of the page, `flown` the verdicts.

    Stages: door (which volunteer?), ready, flying, rate, closing, weigh, broken, rest, done.
    A verdict is rated as soon as it is known; what was rated is written, and the next flight can
    be ordered, once the run's folder is whole.
    """

    def __init__(self, session: Session, folder: Path) -> None:
        self.session = session
        self._folder = folder
        self._stage = 'door'
        self._volunteer = 0
        self._plan: list[Flight] = []
        self._at = 0
        self._attempt = ''
        self._reason = ''                       # the judge's, empty before the verdict
        self._verdict: dict[str, Any] = {}      # of it: success and words, for the page
        self._rest_until = 0.0
        self._closing = False                   # there is a verdict, but not yet a whole folder
        self._rated: tuple[dict, dict] | None = None    # meanwhile: Cooper-Harper, TLX
        self._why = ''                          # the last flight does not count
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise BadInput(f'cannot make the folder {folder}: {error.strerror}') from None
        _write(folder / 'session.json', {**session.__dict__, 'scales': TLX})

    @property
    def pseudonym(self) -> str:
        """What the volunteer is called in every file."""
        return f'P{self._volunteer:02d}'

    def view(self) -> dict[str, Any]:
        """Return what the page shows."""
        made: dict[str, Any] = {'type': 'desk', 'stage': self._stage, 'title': self.session.title,
                                'closing': self._closing, 'why': self._why}
        if self._stage != 'door':
            made.update({'who': self.pseudonym, 'of': len(self._plan),
                         'number': min(self._at + 1, len(self._plan))})
        if self._stage in ('ready', 'flying', 'rate', 'closing', 'weigh', 'broken'):
            flight = self._plan[self._at]
            made.update({'condition': flight.condition, 'mode': flight.mode,
                         'training': flight.training, 'verdict': self._verdict})
        if self._stage == 'weigh':
            made['pairs'] = self._pairs()
        if self._stage == 'rest':
            made['rest_s'] = max(0.0, self._rest_until - time.monotonic())
        return made

    def do(self, content: dict[str, Any]) -> dict[str, Any] | None:
        """
        Do what the page asks; return the order for a flight when one is to start.

        Raises
        ------
        BadInput
            With a short code when it does not fit the stage or a rating is incomplete; with a
            sentence when the disk does not take it: the stage is then what it was.
        """
        act = content.get('act')
        if self._closing and act in ('fly', 'leave', 'begin', 'go_on'):
            raise BadInput('CLOSING')
        if act == 'begin' and self._stage in ('door', 'done'):
            self._begin(content.get('volunteer'))
        elif act == 'fly' and self._stage == 'ready':
            return self._order()
        elif act == 'rate' and self._stage == 'rate':
            self._rate(content)
        elif act == 'weigh' and self._stage == 'weigh':
            self._weigh(content)
        elif act == 'go_on' and self._stage in ('rest', 'broken'):
            self._stage, self._why = 'ready', ''
        elif act == 'leave' and self._stage != 'flying':
            self._stage = 'door'
        else:
            raise BadInput('STAGE')
        return None

    def _begin(self, volunteer: Any) -> None:
        if (isinstance(volunteer, bool) or not isinstance(volunteer, int)
                or not 1 <= volunteer <= MAX_VOLUNTEERS):
            raise BadInput('VOLUNTEER')
        self._volunteer, self._plan = volunteer, plan(self.session, volunteer)
        rated = {file.parent.name.split('.')[0]
                 for file in (self._folder / self.pseudonym).glob(f'*/{RATINGS}')
                 if object_of(file, 'rating').get('cooper_harper') is not None}
        self._at = next((i for i, f in enumerate(self._plan) if f.folder not in rated),
                        len(self._plan))
        self._stage = 'ready' if self._at < len(self._plan) else 'done'
        if self._at > 0 and self._has_to_weigh(self._at - 1):
            self._at, self._stage = self._at - 1, 'weigh'       # broken off before its pairs

    def _order(self) -> dict[str, Any]:
        flight = self._plan[self._at]
        out, again = f'{self.pseudonym}/{flight.folder}', 1
        while (self._folder / out).exists():    # a flight that was broken off
            again += 1
            out = f'{self.pseudonym}/{flight.folder}.{again}'
        self._attempt, self._stage, self._reason, self._verdict = out, 'flying', '', {}
        self._why, self._rated = '', None
        return {'mode': flight.mode, 'seed': flight.seed, 'out': out}

    def flown(self, verdict: dict[str, Any]) -> None:
        """Be told that the flight under way has its verdict: it is rated while it is fresh."""
        if self._stage != 'flying':
            return
        self._reason = verdict['reason']
        self._verdict = {key: verdict[key] for key in ('success', 'words')}
        self._stage, self._closing = 'rate', True
        if self._reason == ABORTED and not self._plan[self._at].training:
            self._stage, self._why = 'broken', why_not(
                {'flown': {'modes': {}, 'aborted': True}}, '')

    def ended(self, run: str | None) -> None:
        """
        Be told that a run is over and its folder whole: only now it is known whether it counts.

        One that left no verdict is flown again, as is one that does not count.
        """
        if run != self._attempt or not (self._closing or self._stage == 'flying'):
            return
        flight, rated = self._plan[self._at], self._rated
        self._closing, self._rated = False, None
        try:
            content = object_of(self._folder / run / 'verdict.json', 'verdict', MAX_VERDICT_BYTES)
        except BadInput:
            content = {}
        why = '' if flight.training else why_not(content, flight.mode)
        try:
            if why and (self._reason or content.get('flown', {}).get('aborted')):
                self._stage, self._why = 'broken', why
                self._write(None, None, why)
            elif not self._reason:
                self._stage, self._why = 'ready', BROKEN_OFF
            elif rated is not None:
                self._keep(*rated)
        except BadInput as error:               # of the disk: the rating can be given again
            self._stage, self._why = 'rate', str(error)

    def refuses(self, do: str, aborted: bool) -> str:
        """
        Return the code with which a request that steers a run is refused; empty: it is not.

        What a flight is flown in, and when, is the session's. ABORT is for safety and never
        refused; a flight that was aborted does not count any more and may be ended.
        """
        if do == 'stop':
            return '' if aborted or self._stage != 'flying' else 'SESSION_STOP'
        return {'mode': 'SESSION_MODE', 'pause': 'SESSION_PAUSE', 'fly': 'DESK',
                'quit': 'SESSION_STOP' if self._stage == 'flying' else ''}.get(do, '')

    def _rate(self, content: dict[str, Any]) -> None:
        harper, tlx = content.get('cooper_harper'), content.get('tlx')
        if not isinstance(harper, dict) or not isinstance(tlx, dict):
            raise BadInput('RATING')
        answers = [harper.get(key) for key in ('controllable', 'adequate', 'satisfactory')]
        rating = harper.get('rating')
        if not all(isinstance(answer, bool) for answer in answers):
            raise BadInput('RATING')
        low, high = cooper_harper_range(*answers)
        if isinstance(rating, bool) or not isinstance(rating, int) or not low <= rating <= high:
            raise BadInput('RATING')
        values = [tlx.get(scale) for scale in TLX]
        if not all(isinstance(v, int) and not isinstance(v, bool) and 0 <= v <= 100 and v % 5 == 0
                   for v in values):
            raise BadInput('TLX')
        given = (dict(zip(('controllable', 'adequate', 'satisfactory'), answers)) | {
            'rating': rating}, dict(zip(TLX, values)))
        if self._closing:                       # whether the flight counts is not known yet
            self._stage, self._rated = 'closing', given
        else:
            self._keep(*given)

    def _keep(self, harper: dict, tlx: dict) -> None:
        """Write a rating and go on."""
        self._write(harper, tlx)
        if self._has_to_weigh(self._at):
            self._stage = 'weigh'
        else:
            self._go_on()

    @property
    def _condition(self) -> str:
        return self._plan[self._at].condition

    def _has_to_weigh(self, flight: int) -> bool:
        """Say whether the pairs are still to be asked for the condition of a flight."""
        return (self.session.tlx == 'weighted'
                and self._plan[flight].condition not in self._weights())

    def _pairs(self) -> list[list[str]]:
        return tlx_pairs(f'{self.session.seed} {self.pseudonym} {self._condition}')

    def _weigh(self, content: dict[str, Any]) -> None:
        """Take which scale of each pair counted more; the count of each is its weight."""
        chosen, pairs = content.get('chosen'), self._pairs()
        if not isinstance(chosen, list) or len(chosen) != len(pairs) or not all(
                choice in pair for choice, pair in zip(chosen, pairs)):
            raise BadInput('WEIGHTS')
        weights = {scale: chosen.count(scale) for scale in TLX}
        _write(self._folder / self.pseudonym / WEIGHTS,
               {**self._weights(), self._condition: weights})
        self._go_on()

    def _weights(self) -> dict[str, dict[str, int]]:
        """Return the weights of this volunteer by condition, as far as they were asked."""
        file = self._folder / self.pseudonym / WEIGHTS
        return object_of(file, 'table of weights') if file.is_file() else {}

    def _write(self, harper: dict | None, tlx: dict | None, why: str = '') -> None:
        """Write what is known of a flight; one that does not count has no rating, but a reason."""
        flight = self._plan[self._at]
        made = {'volunteer': self.pseudonym, 'session': self.session.title,
                'number': flight.number, 'condition': flight.condition, 'mode': flight.mode,
                'training': flight.training, 'seed': flight.seed, 'reason': self._reason,
                'counted': not (flight.training or why), 'why': why, 'cooper_harper': harper,
                'tlx': tlx and {**tlx, 'mean': sum(tlx.values()) / len(tlx)}}
        _write(self._folder / self._attempt / RATINGS, made)

    def _go_on(self) -> None:
        self._at += 1
        if self._at >= len(self._plan):
            self._stage = 'done'
        elif self.session.break_after and self._at % self.session.break_after == 0:
            self._stage = 'rest'
            self._rest_until = time.monotonic() + self.session.break_s
        else:
            self._stage = 'ready'


def _write(file: Path, content: dict) -> None:
    whole.save(file, json.dumps(content, indent=2) + '\n')
