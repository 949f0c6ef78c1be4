"""
What a block has to say to people besides its outputs.

A block that now and then has something to say has a method `news`, without arguments. Its node asks
it after each step, and puts what it returns, (code, text), on `/run/events`: that is in the bag, in
the terminal and in the console. Where whole batches are computed in one process, nobody asks.
"""

News = list[tuple[str, str]]            # (code, text) of an event
OUTLIERS = 'OUTLIERS'


def begun_anew(what: str, patience: int) -> tuple[str, str]:
    """Return the event of a filter whose gate has left out so many samples of `what` in a row."""
    return OUTLIERS, (f'{what}: {patience} in a row were outliers and left out; the filter takes '
                      'the next one for true and begins anew')
