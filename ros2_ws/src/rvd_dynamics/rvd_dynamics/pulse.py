"""
Signs of life of the processes of a run, on a page of memory that they share.

Whoever starts a run makes the page and hands it on with the environment: it has no name, needs no
disk and no middleware, and goes with the last process that has it. A process notes the time at
each turn of its loop and at each firing, so that one that is stopped, hangs or computes falls
silent. The plant notes how far the run has come; the recorder counts by that what it never heard,
and notes what it has given up for want of disk, which the bag may have no room to say.
Who started the run notes in words what it sees of the processes, and the recorder puts that into
the bag, even what was said while it stood still itself.
A process that compiles a loop notes that, too: it may take a minute, and nobody is to give it up.
Each process marks topics on which it found a trace of a second writer; the monitor says so. And
each counts what it writes where several may and seldom do: who reads more than that all of them
have written reads a stranger.

Source  memfd_create(2); CLOCK_MONOTONIC is one clock for all processes of a machine.
"""

import fcntl
import mmap
import os

PAGE = 'RVD_PULSE'              # environment: descriptor of the page
NAME = 'rvd_pulse'              # of the page in /proc/PID/maps
BEAT_S = 0.5                    # [s] wall time after which a process that has nothing to do beats
# Words: newest step, last step, bytes that were said, messages given up, and the first of the
# processes: when each has beaten, when each has compiled, then COUNTS of each. Text follows.
FLOWN, FINAL, SAID, LOST, FIRST = 0, 1, 2, 3, 4
WORD = 8                        # [bytes] int64, which the processor stores in one go
TEXT = 1 << 16                  # [bytes] of all that is said in a run: some hundred sentences
MARKS = 512                     # [bytes] before it, one for each topic of the run
COUNTS = 3                      # topics on which messages are counted
NO_STEP = -1
LEFT, LEFT_EARLY = 0, -1         # instead of the time of a beat


class Pulse:
    """
    The page: what each process has noted, by its place in the list of processes.

    Attributes
    ----------
    file : int
        Descriptor of the page; -1 where no other process can have it.
    """

    def __init__(self, file: int = -1, places: int = 1) -> None:
        size = _size(places)
        self.file, self.inherits = file, file >= 0
        self._page, self._places = mmap.mmap(file, size), places
        self._words = memoryview(self._page).cast('q')
        self._marks = memoryview(self._page)[-TEXT - MARKS:-TEXT]
        if file < 0:
            self.flown = self.final = NO_STEP

    @classmethod
    def shared(cls, places: int) -> 'Pulse':
        """Make a page for so many processes, which they inherit by its descriptor."""
        file = os.memfd_create(NAME, os.MFD_CLOEXEC | os.MFD_ALLOW_SEALING)
        os.ftruncate(file, _size(places))
        fcntl.fcntl(file, fcntl.F_ADD_SEALS, fcntl.F_SEAL_SHRINK | fcntl.F_SEAL_GROW)
        made = cls(file, places)
        made.flown = made.final = NO_STEP
        return made

    @classmethod
    def inherited(cls) -> 'Pulse':
        """Return the page of this run; without one, as in a node started by hand, one's own."""
        try:
            file = int(os.environ.get(PAGE, ''))
            if f'/memfd:{NAME} ' in os.readlink(f'/proc/self/fd/{file}'):
                return cls(file, _places(os.fstat(file).st_size))
        except (ValueError, OSError):
            pass
        return cls()

    # -- of a process -----------------------------------------------------------------------

    def beat(self, place: int, now_ns: int) -> None:
        """Note that a process lives at `now_ns` of `time.monotonic_ns`."""
        self._words[FIRST + place] = now_ns

    def leave(self, place: int, early: bool = False) -> None:
        """
        Note that a process goes: what it does from now on is nobody's concern.

        `early`: it was told to, and has not done all of its work.
        """
        self._words[FIRST + place] = LEFT_EARLY if early else LEFT

    def left_early(self, place: int) -> bool:
        """Say whether a process has gone before its work was done."""
        return self._words[FIRST + place] == LEFT_EARLY

    def beaten_s(self, place: int) -> float | None:
        """Return when a process has beaten last [s, time.monotonic]; None before and after."""
        return max(self._words[FIRST + place], 0) / 1e9 or None

    def write(self, place: int, count: int) -> None:
        """Note, before it is sent, that a process writes a message on a topic that is counted."""
        self._words[FIRST + 2*len(self) + COUNTS*place + count] += 1

    def compile(self, place: int, begins: bool, now_ns: int) -> None:
        """Note that a process begins to compile, or has done so."""
        self._words[FIRST + len(self) + place] = now_ns if begins else -now_ns

    def compiled_s(self, place: int) -> tuple[bool, float]:
        """Return whether a process compiles, and since or until when [s]; 0: it never did."""
        word = self._words[FIRST + len(self) + place]
        return word > 0, abs(word) / 1e9

    # -- of the run -------------------------------------------------------------------------

    def written(self, count: int) -> int:
        """Return how many messages all processes have written on a topic that is counted."""
        first = FIRST + 2*len(self)
        return sum(self._words[first + count:first + COUNTS*len(self):COUNTS])

    def mark(self, topic: int) -> bool:
        """Mark a topic, by its place; return whether another process can see that."""
        if not self.inherits or topic >= MARKS:
            return False
        self._marks[topic] = 1
        return True

    @property
    def marked(self) -> list[int]:
        """The places of the topics that any process has marked."""
        marks = bytes(self._marks)
        return [i for i, mark in enumerate(marks) if mark] if any(marks) else []

    @property
    def flown(self) -> int:
        """The newest step of the run that is made; -1 before the first."""
        return self._words[FLOWN]

    @flown.setter
    def flown(self, step: int) -> None:
        self._words[FLOWN] = step

    @property
    def final(self) -> int:
        """The last step of the run; -1 before it is known."""
        return self._words[FINAL]

    @final.setter
    def final(self, step: int) -> None:
        self._words[FINAL] = step

    @property
    def lost(self) -> int:
        """How many messages the recorder has given up for want of disk."""
        return self._words[LOST]

    @lost.setter
    def lost(self, messages: int) -> None:
        self._words[LOST] = messages

    def say(self, code: str, step: int, words: str) -> None:
        """Note what was seen of the processes at `step`; who started the run alone does."""
        line = f'{code} {step} {" ".join(words.split())}\n'.encode()
        begin = len(self._page) - TEXT + self._words[SAID]
        if begin + len(line) <= len(self._page):
            self._page[begin:begin + len(line)] = line
            self._words[SAID] += len(line)      # now it is there

    def heard(self, known: int) -> tuple[list[tuple[str, int, str]], int]:
        """Return what was said beyond the first `known` bytes, and how many there are now."""
        begin, end = len(self._page) - TEXT, self._words[SAID]
        lines = self._page[begin + known:begin + end].decode().splitlines()
        return [(code, int(step), words) for code, step, words in
                (line.split(' ', 2) for line in lines)], end

    def __len__(self) -> int:
        return self._places

    def handed_on(self) -> None:
        """Close the descriptor, which others have inherited by now; the page stays."""
        if self.file >= 0:
            os.close(self.file)
            self.file = -1


def _size(places: int) -> int:
    """Return the size of a page for so many processes [bytes]."""
    return WORD * (FIRST + (2 + COUNTS) * places) + MARKS + TEXT


def _places(size: int) -> int:
    """Return for how many processes a page of `size` [bytes] is."""
    return ((size - TEXT - MARKS) // WORD - FIRST) // (2 + COUNTS)
