"""
What a user gave and the software cannot use: one line that names the value and the remedy.

Commands and nodes print it and end with exit code 2. Every other error is a fault of the software:
it keeps its traceback, and a command ends with exit code 3.
"""


class BadInput(ValueError):
    """Input that is refused; the text is all that the user is told."""
