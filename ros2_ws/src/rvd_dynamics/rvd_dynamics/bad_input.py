"""
What a user gave and the software cannot use: one line that names the value and the remedy.

Commands and nodes print it and end with exit code 2. Every other error is a fault of the software:
it keeps its traceback, and a command ends with exit code 3.
"""

LONGEST = 2000                  # characters of a refusal: what it quotes may be a whole file


def one_line(text: str) -> str:
    """Return a text with its control characters spelled out: what a user gave may hold any."""
    return ''.join(c if c.isprintable() else repr(c)[1:-1] for c in text)


def shortened(text: str) -> str:
    """Return a text without its middle where nobody would read all of it."""
    return text if len(text) <= LONGEST else f'{text[:LONGEST - 300]} ... {text[-200:]}'


class BadInput(ValueError):
    """Input that is refused; the text is all that the user is told."""

    def __str__(self) -> str:
        return shortened(one_line(super().__str__()))
