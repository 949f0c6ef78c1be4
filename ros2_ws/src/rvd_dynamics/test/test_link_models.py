"""Transit models: each law against its distribution, each setting against its limits."""

from dataclasses import fields

import numpy as np
import pytest
from rvd_dynamics.link.models import (
    Constant, Empirical, Gamma, LinkParams, MODELS, read_transits, Uniform)
from rvd_dynamics.diagram.params import build, flatten, leaves
from scipy import stats

HOLD_S = 5.0                    # [s] nT of the paper's legs
MEASURED_S = (3.61, 3.7, 4.2, 5.3)


@pytest.fixture
def transit_file(tmp_path):
    path = tmp_path / 'transits.csv'
    path.write_text('transit_s\n' + '\n'.join(map(str, MEASURED_S)) + '\n')
    return str(path)


@pytest.fixture(params=MODELS)
def model(request, transit_file):
    needs = {'empirical': {'file': transit_file}}       # the one model without a default
    return MODELS[request.param](**needs.get(request.param, {}))


# contract: every entry of MODELS

@pytest.mark.parametrize('size', [(1,), (7,), (401, 2)])
def test_delays_have_the_size_asked_for(model, size):
    delays = model.delays(np.random.default_rng(1), size, HOLD_S)
    assert delays.shape == size and delays.dtype == np.float64


def test_delays_are_causal_or_lost(model):
    d = model.delays(np.random.default_rng(2), (10_000,), HOLD_S)
    assert np.all(((d >= 0) & np.isfinite(d)) | np.isnan(d))


def test_same_generator_same_delays(model):
    twice = [model.delays(np.random.default_rng(3), (50, 2), HOLD_S) for _ in range(2)]
    assert np.array_equal(*twice, equal_nan=True)


def test_a_longer_block_begins_with_the_shorter_one(model):
    long, short = (model.delays(np.random.default_rng(4), (k, 2), HOLD_S) for k in (90, 30))
    assert np.array_equal(long[:30], short, equal_nan=True)


def test_each_model_has_its_settings_in_link_params():
    nested = {f.name: f.default_factory for f in fields(LinkParams) if f.name in MODELS}
    assert nested == MODELS


def test_each_model_can_be_chosen_by_name(transit_file):
    for name in MODELS:
        params = build(LinkParams, {'model': name, 'empirical.file': transit_file})
        assert type(params.delay_model) is MODELS[name]


@pytest.mark.parametrize('name', ['constant', 'uniform', 'gamma'])
def test_transits_scale_with_the_play_out_delay_and_vanish_on_a_direct_link(name):
    model = MODELS[name]()
    one, two, none = (model.delays(np.random.default_rng(5), (20,), hold)
                      for hold in (2.0, 4.0, 0.0))
    np.testing.assert_allclose(two, 2 * one, rtol=1e-14)
    assert np.all(none == 0.0)


# each law

def test_constant_transit_of_one_play_out_delay_is_exactly_that():
    assert np.all(Constant(transit_fraction=1.0).delays(None, (3,), HOLD_S) == HOLD_S)


def test_uniform_is_uniform_between_its_bounds():
    d = Uniform(low_fraction=0.5, high_fraction=0.9).delays(
        np.random.default_rng(6), (20_000,), HOLD_S)
    assert stats.kstest(d, stats.uniform(2.5, 2.0).cdf).pvalue > 0.01


def test_gamma_is_the_distribution_of_the_specification():
    d = Gamma().delays(np.random.default_rng(7), (20_000,), HOLD_S)
    assert stats.kstest(d, stats.gamma(8, loc=3.6, scale=0.0875).cdf).pvalue > 0.01


def test_one_frame_in_a_hundred_misses_its_slot():
    assert stats.gamma(8, loc=3.6, scale=0.0875).sf(5.0) == pytest.approx(0.010, abs=5e-4)
    d = Gamma().delays(np.random.default_rng(8), (200_000,), HOLD_S)
    assert np.mean(d > HOLD_S) == pytest.approx(0.010, abs=1e-3)    # 4.5 standard errors


def test_empirical_draws_each_measured_transit_equally_often(transit_file):
    d = Empirical(file=transit_file).delays(np.random.default_rng(9), (40_000,), HOLD_S)
    values, counts = np.unique(d, return_counts=True)
    assert tuple(values) == MEASURED_S
    assert stats.chisquare(counts).pvalue > 0.01


def test_empirical_file_is_read_once(transit_file, tmp_path):
    params = LinkParams(model='empirical', empirical=Empirical(file=transit_file))
    (tmp_path / 'transits.csv').unlink()
    assert params.delay_model.delays(np.random.default_rng(1), (3,), HOLD_S).shape == (3,)


# files

@pytest.mark.parametrize('text', ['1\n2.5\n', 'delay_s\n1\n2.5', '# note\n\n1 # a\n 2.5 \n',
                                  '# note\ndelay_s\n1\n\n2.5\n', '1\r\n2.5\r\n'])
def test_header_comments_and_blank_lines_are_allowed(tmp_path, text):
    path = tmp_path / 'd.csv'
    path.write_text(text)
    assert list(read_transits(str(path))) == [1.0, 2.5]


@pytest.mark.parametrize(('text', 'line', 'value'), [
    ('1\n-0.1\n', 2, '-0.1'), ('1\nnan\n', 2, 'nan'), ('nan\n1\n', 1, 'nan'),
    ('1\ninf\n', 2, 'inf'), ('h\n1\n2 3\n', 3, '2 3'), ('h\ng\n1\n', 2, 'g'),
    ('1\nh\n', 2, 'h'), ('1\n2,3\n', 2, '2,3'), ('1e7\n', 1, '1e7')])
def test_a_bad_line_is_named_with_its_file(tmp_path, text, line, value):
    path = tmp_path / 'd.csv'
    path.write_text(text)
    with pytest.raises(ValueError) as refused:
        read_transits(str(path))
    assert f'{path}, line {line}:' in str(refused.value) and repr(value) in str(refused.value)


def test_files_that_hold_no_transits_are_refused_by_name(tmp_path):
    (tmp_path / 'empty.csv').write_text('delay_s\n')
    (tmp_path / 'binary.csv').write_bytes(b'\xff\xfe\x00')
    for name in ('empty.csv', 'binary.csv', 'absent.csv', '.'):
        with pytest.raises(ValueError, match=name):
            read_transits(str(tmp_path / name))


def test_relative_paths_start_at_the_current_directory(transit_file, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert tuple(read_transits('transits.csv')) == MEASURED_S


def test_a_bad_file_is_refused_with_the_settings_but_only_if_it_is_used():
    with pytest.raises(ValueError, match='absent.csv'):
        build(LinkParams, {'model': 'empirical', 'empirical.file': 'absent.csv'})
    with pytest.raises(ValueError, match='empirical.file'):
        LinkParams(model='empirical')
    build(LinkParams, {'empirical.file': 'absent.csv'})


# settings

def test_defaults_survive_the_way_through_a_parameter_file():
    assert build(LinkParams, flatten(LinkParams())) == LinkParams()


def test_no_default_is_a_list_without_a_type():
    for key, f in leaves(LinkParams):
        default = f.default
        assert not isinstance(default, tuple) or len(default) > 0, key


def test_default_outage_window_is_none():
    assert LinkParams().outages_ns == ()
    assert LinkParams(outage_windows_s=()).outages_ns == ()


@pytest.mark.parametrize(('key', 'value'), [
    ('model', 'fibre'), ('loss_fraction', 1.01), ('loss_fraction', float('nan')),
    ('duplicate_fraction', -0.1), ('corrupt_fraction', 2.0), ('reorder_fraction', -1.0),
    ('reorder_delay_s', -1.0), ('reorder_delay_s', float('inf')),
    ('outage_windows_s', [1.0]), ('outage_windows_s', [5.0, 4.0]),
    ('outage_windows_s', [-1.0, 4.0]), ('outage_windows_s', [0.0, float('nan')]),
    ('constant.transit_fraction', float('nan')), ('constant.transit_fraction', -0.1),
    ('uniform.high_fraction', 0.1), ('uniform.low_fraction', float('inf')),
    ('gamma.shape', 0.0), ('gamma.shape', float('nan')), ('gamma.scale_fraction', -1.0),
    ('gamma.offset_fraction', 1e9)])
def test_impossible_settings_are_refused_by_name(key, value):
    with pytest.raises(ValueError, match=key.replace('.', r'\.')):
        build(LinkParams, {key: value})


def test_the_edges_of_the_settings_are_allowed():
    build(LinkParams, {'loss_fraction': 1, 'duplicate_fraction': 0, 'corrupt_fraction': 1.0,
                       'reorder_delay_s': 0.0, 'outage_windows_s': [3.0, 3.0, 4.0, 1e5],
                       'constant.transit_fraction': 0.0, 'uniform.high_fraction': 0.72})
