"""
Reports of finished runs for the page: addresses that open one report each, for a while.

A report is a page of its own in a tab of its own, which cannot show the token as the console's
page does: the address of a tab is all that is sent for it. So who has the token asks for a ticket,
a path that nobody can guess, which opens that one report. What a report holds comes from a bag,
which may be anybody's: it is shown without scripts, as a stranger to the console's own origin.
"""

from pathlib import Path

from rvd_dynamics.given import opened
from rvd_groundstation.console.access import new_token

NAME = 'report.html'
TICKET_S = 600.0                # [s] for which an address opens a report
MOST_TICKETS = 200              # of them; the oldest goes first
MAX_BYTES = 64 << 20            # [B] of a report: usually one megabyte
POLICY = ("default-src 'none'; style-src 'unsafe-inline'; img-src data:; font-src data:; "
          "base-uri 'none'; form-action 'none'; frame-ancestors 'none'; sandbox")


class Reports:
    """Hands out tickets for the reports below a folder; no clock of its own, instants are [s]."""

    def __init__(self, runs: Path | None) -> None:
        self._runs = runs
        self._tickets: dict[str, tuple[Path, float]] = {}       # report, until when; oldest first

    def ticket(self, name: str, now: float) -> str:
        """
        Return a ticket for the report of a finished run.

        Raises
        ------
        FileNotFoundError
            If there is no such run below the folder, or it has no report.
        """
        report = report_of(self._runs, name)
        if report is None:
            raise FileNotFoundError(name)
        while len(self._tickets) >= MOST_TICKETS:
            del self._tickets[next(iter(self._tickets))]
        made = new_token()
        self._tickets[made] = report, now + TICKET_S
        return made

    def read(self, ticket: str, now: float) -> bytes | None:
        """Return the report that a ticket opens, None if it opens none (any more)."""
        report, until = self._tickets.get(ticket, (None, now))
        if report is None or now >= until:
            self._tickets.pop(ticket, None)
            return None
        try:
            with opened(report) as file:
                return file.read(MAX_BYTES)
        except (OSError, ValueError):           # removed meanwhile, or something else by now
            return None


def report_of(runs: Path | None, name: str) -> Path | None:
    """Return the report of a finished run below `runs`; nothing that points out of there."""
    if runs is None or '\0' in name:
        return None
    root = runs.resolve()
    report = (root / name / NAME).resolve()
    if root not in report.parents or not (root / name / 'verdict.json').is_file():
        return None
    return report if report.is_file() else None
