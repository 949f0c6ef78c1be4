"""What every command form keeps, run over the table FORMS."""

from dataclasses import is_dataclass
from itertools import product

import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.commands.form import FORMS
from rvd_dynamics.link.frame import Command, pack_command, unpack_command

# Forms whose commands are numbers of a finite alphabet say so; of the others a sample is tried.
SAMPLE = 2000


@pytest.fixture(params=FORMS.values(), ids=FORMS.keys())
def form(request):
    return request.param()


def width(form):
    return len(form.neutral)


def commands(form):
    """Return commands (N, n): all there are of a finite alphabet, else effects made commands."""
    alphabet = getattr(form, 'alphabet', None)
    if alphabet is not None:
        return np.array(list(product(alphabet, repeat=width(form))), dtype=form.neutral.dtype)
    return form.quantise(np.random.default_rng(1).normal(size=(SAMPLE, width(form))))


def wanted(form, rows, seed=2):
    """Return wishes (rows, n) about as large as what commands do, and some far beyond."""
    size = np.abs(form.effect(commands(form))).max(axis=0)
    scale = np.random.default_rng(seed).choice([0.3, 1.0, 10.0], size=(rows, 1))
    return np.random.default_rng(seed + 1).normal(size=(rows, len(size))) * size * scale


def same_bits(one, other):
    one, other = np.asarray(one), np.asarray(other)
    return (one.shape, one.dtype, one.tobytes()) == (other.shape, other.dtype, other.tobytes())


def test_is_a_frozen_dataclass_that_can_be_compared(form):
    assert is_dataclass(form) and form.__dataclass_params__.frozen
    assert form == type(form)() and hash(form) == hash(type(form)())


def test_quantising_what_a_command_does_gives_the_command(form):
    every = commands(form)
    again = form.quantise(form.effect(every))
    assert len(every) > 100 and again.dtype == form.neutral.dtype
    assert_array_equal(again, every)


def test_what_is_wanted_becomes_a_legal_command(form):
    got = form.quantise(wanted(form, SAMPLE))
    assert all(form.legal(command) for command in got.tolist())


def test_what_is_not_known_becomes_nothing(form):
    for unknown in (np.nan, np.inf, -np.inf):
        assert_array_equal(form.quantise(np.full((4, width(form)), unknown)),
                           np.broadcast_to(form.neutral, (4, width(form))))
    one = wanted(form, 1)[0]
    spoiled = np.stack([one, one, one])
    spoiled[1, 0] = np.nan
    got = form.quantise(spoiled)
    assert_array_equal(got[[0, 2]], form.quantise(np.stack([one, one])))    # no other row minds
    assert form.legal(got[1].tolist()) and got[1, 0] == form.neutral[0]


def test_every_command_comes_back_from_the_wire_as_it_went(form):
    for i, command in enumerate(commands(form).tolist()):
        assert form.wire.unpack(form.wire.pack(*command)) == tuple(command)
        back = unpack_command(pack_command(i + 1, i, command, form=form), form)
        assert back == Command(i + 1, i, 0, tuple(command))
    assert form.wire.format.startswith('<')             # the same bytes on every machine


def test_neutral_and_retreat_are_commands(form):
    for command in (form.neutral, form.retreat):
        assert command.shape == (width(form),) and form.legal(command.tolist())
        assert command.dtype == form.neutral.dtype
    assert not np.any(form.effect(form.neutral))
    assert form.effect(form.retreat)[0] < 0.0           # away from the target


def test_what_is_no_command_is_not_legal(form):
    for wrong in (np.nan, np.inf, -np.inf, 1e9, -1e9):
        for axis in range(width(form)):
            command = form.neutral.tolist()
            command[axis] = wrong
            assert not form.legal(command), command
            with pytest.raises(ValueError, match='command must be a command of'):
                pack_command(1, 0, command, form=form)
    for length in (width(form) - 1, width(form) + 1):
        with pytest.raises(ValueError, match='command must be a command of'):
            pack_command(1, 0, [0] * length, form=form)


def test_levels_between_two_whole_ones_are_none():
    form = FORMS['levels']()
    assert form.legal((3, -3, 0)) and not form.legal((1.5, 0, 0)) and not form.legal((4, 0, 0))


@pytest.mark.parametrize('batch', [(), (1,), (7,), (1000,), (4, 3), (0,)])
def test_a_row_of_a_batch_is_the_single_command_to_the_bit(form, batch):
    rows = int(np.prod(batch, dtype=int))
    rng, every = np.random.default_rng(3), commands(form)
    wish, command = wanted(form, max(rows, 1))[:rows], every[rng.integers(len(every), size=rows)]
    for call, given in ((form.quantise, wish), (form.effect, command)):
        whole = call(given.reshape(*batch, -1) if rows else given.reshape(0, width(form)))
        assert whole.shape[:-1] == batch
        for i in range(rows):
            assert same_bits(whole.reshape(rows, -1)[i], call(given[i]))


def test_memory_layout_does_not_matter_and_arguments_are_left_alone(form):
    every = commands(form)
    for call, given in ((form.quantise, wanted(form, 60)), (form.effect, every[:60])):
        kept, expected = given.copy(), call(given)
        for same in (np.asfortranarray(given), np.repeat(given, 2, axis=0)[::2],
                     np.repeat(given, 2, axis=1)[:, ::2]):
            assert same_bits(call(same), expected)
        assert same_bits(call(given.reshape(3, 20, -1)).reshape(expected.shape), expected)
        assert same_bits(given, kept)
