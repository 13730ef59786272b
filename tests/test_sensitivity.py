"""Sensitivities agree with differences of many digits in all strata; shapes and frames."""

from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from itertools import combinations

import numpy as np
import pytest
from sensitivity_oracle import differences, errors

from rigidsym import InputError, TorqueFreeMotion, propagate
from rigidsym._engines import ENGINES, arrays
from rigidsym.validate.strata import STRATA, draw

PAPER = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)
# As documented, of a column.
BOUND = 1e-13
# Whose differences leave binary64.
_BEYOND = ("scales", "extreme scales")


def motion(sample, engine="numpy"):
    given = sample.inertia, sample.omega0, sample.attitude0
    return TorqueFreeMotion(*given, engine=engine, allow_nonphysical=True)


@pytest.mark.parametrize("stratum", [name for name in STRATA if name not in _BEYOND])
def test_columns_are_those_of_differences(stratum):
    sample = draw(stratum, 0, 1)
    inertia, omega0, attitude0 = sample.exact
    times = [Fraction(t) for t in sample.times[:2]]
    trues = differences(inertia, omega0, attitude0, times, 340, 730)
    for t, true in zip(times, trues[..., :6], strict=True):
        for engine in ENGINES:
            found = motion(sample, engine).sensitivity(float(t))[2]
            assert max(errors(found, true, inertia, omega0, t)) < BOUND, engine


# Each moment as that of the spin, the middle one last; rates across as parts of that of the spin.
SPINS = [(0.73, 1.21, 1.58), (1.58, 0.73, 1.21), (1.21, 1.58, 0.73)]


@pytest.mark.parametrize("across", [1e-3, 4.6e-13, 1e-40, 1e-85])
@pytest.mark.parametrize("inertia", SPINS)
def test_columns_by_the_moments_keep_their_digits_near_a_spin(inertia, across, engine):
    """These columns are small sums of larger numbers."""
    omega0 = (1.3, -1.3 * across, -1.4 * across)
    one, times = TorqueFreeMotion(inertia, omega0, (2, -1, 3, 1), engine=engine), (-3.0, 10.0, 40.0)
    _, _, found = one.sensitivity(times)
    for k, t in enumerate(times):
        true = one.precise(t, 220, sensitivity=True)[2]
        columns = np.concatenate([true.attitude, true.rates])[:, 6:]
        seen = np.concatenate([found.attitude[k], found.rates[k]])[:, 6:]
        apart = np.max(np.abs(seen - columns), axis=0)
        assert np.all(apart < BOUND * np.max(np.abs(columns), axis=0))


@pytest.mark.parametrize("inertia", SPINS)
def test_columns_by_the_moments_are_zero_at_a_spin(inertia, engine):
    one = TorqueFreeMotion(inertia, (1.3, 0, 0), (2, -1, 3, 1), engine=engine)
    _, _, found = one.sensitivity([-3.0, 10.0, 40.0])
    assert not found.rates[..., 6:].any()
    assert not found.attitude[..., 6:].any()


def test_at_the_start_changes_are_those_given(engine):
    for stratum in ("paper", "separatrix", "sphere", "spin", "rest", "symmetric"):
        _, _, found = motion(draw(stratum, 0, 1), engine).sensitivity([0.0, -0.0])
        for part in (0, 1):
            assert np.array_equal(found.transition[part], np.eye(6))
            assert not found.attitude[part, :, 6:].any()
            assert not found.rates[part, :, 6:].any()


def test_states_are_those_of_a_call(engine):
    one = TorqueFreeMotion(*PAPER, engine=engine)
    times = np.linspace(-50, 300, 37)
    q, omega, found = one.sensitivity(times)
    assert np.array_equal(q, one(times)[0])
    assert np.array_equal(omega, one(times)[1])
    assert found.attitude.shape == found.rates.shape == (37, 3, 9)
    assert found.attitude_t.shape == found.rates_t.shape == (37, 3)


def test_the_columns_of_the_time_are_the_equations_of_motion():
    inertia, omega0 = PAPER
    one = TorqueFreeMotion(inertia, omega0, (2, -1, 3, 1))
    _, omega, found = one.sensitivity(7.0)
    momentum = np.array(inertia) * omega
    torque = np.cross(momentum, omega) / inertia
    assert np.allclose(found.rates_t, torque, rtol=1e-14, atol=0)
    assert np.allclose(found.attitude_t, one.rotation(7.0).as_matrix() @ omega, rtol=1e-14, atol=0)


def test_transitions_compose():
    one = TorqueFreeMotion(*PAPER)
    whole = one.state_transition(0.0, 180.0)
    halves = one.state_transition(90.0, 180.0) @ one.state_transition(0.0, 90.0)
    assert np.allclose(halves, whole, rtol=1e-12)
    back = one.state_transition(180.0, 0.0)
    assert np.allclose(back @ whole, np.eye(6), atol=1e-11)
    assert one.state_transition(5.0, [5.0, 6.0]).shape == (2, 6, 6)
    assert np.array_equal(one.state_transition(5.0, 5.0), np.eye(6))


def test_a_batch_is_its_bodies(engine):
    random = np.random.default_rng(3)
    inertia = random.uniform(2, 3, (4, 3))
    inertia[3] = (2.0, 2.0, 2.0)
    omega0 = random.normal(size=(4, 3))
    omega0[2] = 0.0
    for t in (3.0, np.array([1.0, -2.0]), np.array([[1.0], [2.0], [0.0], [4.0]])):
        found = propagate(inertia, omega0, t, engine=engine, sensitivity=True)
        for k in range(4):
            times = t[k] if np.ndim(t) == 2 else t
            alone = TorqueFreeMotion(inertia[k], omega0[k], engine=engine).sensitivity(times)
            same([part[k] for part in _parts(found)], alone)


def test_one_time_and_many_have_the_same_bits(engine):
    one = TorqueFreeMotion(*PAPER, engine=engine)
    times = np.linspace(-50.0, 300.0, 40_001)
    whole = _parts(one.sensitivity(times))
    for some in (slice(0, 1), slice(7, 9), slice(20_000, 20_100), slice(40_000, None)):
        same([part[some] for part in whole], one.sensitivity(times[some]))
    same([part[9] for part in whole], one.sensitivity(float(times[9])))


def test_a_batch_goes_on_past_what_is_refused(engine):
    inertia = np.array([(3.0, 2.0, 1.0)] * 4)
    omega0 = np.array([(1.0, 0.5, 2.0), (np.nan, 0.0, 1.0), (0.0, 1.0, 0.0), (1.0, 0.0, 1e300)])
    times = np.array([0.0, 2.0, 1e4])
    q, _, found = propagate(inertia, omega0, times, engine=engine, errors="nan", sensitivity=True)
    lost = np.array([[0, 0, 0], [1, 1, 1], [0, 0, 1], [0, 1, 1]], bool)
    for changes in (found.attitude, found.rates, found.attitude_t, found.rates_t):
        assert np.array_equal(np.isnan(changes.reshape(4, 3, -1)).all(axis=-1), lost)
        assert np.isfinite(changes[:3][~lost[:3]]).all()
    # Where changes alone grow beyond binary64 there are states.
    lost[2] = False
    assert np.array_equal(np.isnan(q).all(axis=-1), lost)
    with pytest.raises(InputError, match=r"t\[2\] = 10000\.0: .*squares.*body 1"):
        propagate(inertia[::2], omega0[::2], times, engine=engine, sensitivity=True)


def _parts(found):
    q, omega, S = found
    return q, omega, S.attitude, S.rates, S.attitude_t, S.rates_t


def same(parts, found):
    """Assert that arrays equal states and their sensitivity exactly.

    Both may be NaN.
    """
    for part, true in zip(parts, _parts(found), strict=True):
        np.testing.assert_array_equal(part, true)


def test_what_grows_beyond_binary64_is_refused(engine):
    spin = TorqueFreeMotion((3, 2, 1), (0, 1, 0), engine=engine)
    assert np.isfinite(spin.sensitivity(500.0)[2].rates).all()
    with pytest.raises(InputError, match=r"t\[1\] = 10000\.0: .*squares of changes leave binary64"):
        spin.sensitivity([1.0, 1e4])
    q, _, found = spin.sensitivity([1.0, 1e4], errors="nan")
    assert np.isfinite(q).all()
    assert np.isfinite(found.rates[0]).all()
    assert np.isnan(found.rates[1]).all()
    with pytest.raises(InputError, match="must be finite"):
        spin.sensitivity(np.inf)
    with pytest.raises(InputError, match="out = given: sensitivities have arrays of their own"):
        propagate(*PAPER, 1.0, sensitivity=True, out=(np.empty(4), np.empty(3)))


COLUMNS = ("attitude0", "omega0", "inertia", "t")
SOME = [names for count in range(1, 5) for names in combinations(COLUMNS, count)]


def _chosen(whole, names):
    """Select the columns by the named inputs from a complete sensitivity result."""
    wanted = [3 * COLUMNS.index(name) + k for name in names if name != "t" for k in range(3)]
    by_t = slice(None) if "t" in names else slice(0)
    q, omega, attitude, rates, attitude_t, rates_t = whole
    some = attitude[..., wanted], rates[..., wanted], attitude_t[..., by_t], rates_t[..., by_t]
    return q, omega, *some


@pytest.mark.parametrize("names", SOME, ids="+".join)
def test_some_columns_have_the_bits_of_all(engine, names):
    times = np.append(np.linspace(-50.0, 300.0, 70), 0.0)
    motions = [(PAPER[0], PAPER[1]), ((3, 2, 1), (0, 1, 0)), ((1, 1, 2), (0, 0, 0))]
    for inertia, omega0 in motions:
        one = TorqueFreeMotion(inertia, omega0, engine=engine)
        found = one.sensitivity(times, columns=names[::-1])
        assert found[2].columns == names
        same(_chosen(_parts(one.sensitivity(times)), names), found)
        same([part[3] for part in _parts(found)], one.sensitivity(times[3], columns=names))
    bodies = np.array([x[0] for x in motions]), np.array([x[1] for x in motions])
    whole = propagate(*bodies, times, engine=engine, sensitivity=True)
    found = propagate(*bodies, times, engine=engine, sensitivity=True, columns=names)
    assert found[2].columns == names
    same(_chosen(_parts(whole), names), found)


def test_columns_of_exact_inputs(engine):
    exact = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"), engine=engine)
    whole = exact.sensitivity([1.0, 9.0])
    for names in SOME:
        same(_chosen(_parts(whole), names), exact.sensitivity([1.0, 9.0], columns=names))


def test_only_columns_that_are_asked_for_are_refused(engine):
    spin = TorqueFreeMotion((3, 2, 1), (0, 1, 0), engine=engine)
    late = [1.0, 1e4]
    for name in COLUMNS[:3]:
        found = spin.sensitivity(late, errors="nan", columns=name)[2]
        lost = np.isnan(found.attitude[1]).any() or np.isnan(found.rates[1]).any()
        assert found.attitude.shape == (2, 3, 3)
        assert np.isfinite(found.attitude[0]).all()
        if lost:
            with pytest.raises(InputError, match=r"t\[1\] = 10000\.0: .*squares"):
                spin.sensitivity(late, columns=[name])
    assert np.isfinite(spin.sensitivity(late, columns=["attitude0", "t"])[2].rates).all()


@pytest.mark.parametrize(
    "bad",
    ["omega", ["omega0", "omega0"], [], ["attitude0", "moments"], 5, [None], "", np.ones((1, 2))],
    ids=str,
)
def test_columns_that_are_none(engine, bad):
    rule = "columns = .*must be some of attitude0, omega0, inertia, t, each once"
    with pytest.raises(InputError, match=rule):
        TorqueFreeMotion(*PAPER, engine=engine).sensitivity(1.0, columns=bad)
    with pytest.raises(InputError, match=rule):
        propagate(*PAPER, 1.0, engine=engine, sensitivity=True, columns=bad)


def test_columns_are_of_sensitivities():
    with pytest.raises(InputError, match=r"columns = .*set sensitivity=True"):
        propagate(*PAPER, 1.0, columns=["t"])
    found = TorqueFreeMotion(*PAPER).sensitivity(1.0, columns=["omega0", "t"])[2]
    with pytest.raises(InputError, match="columns = omega0, t: a transition needs"):
        found.transition  # noqa: B018


def test_memory_is_handed_on_when_nobody_looks_at_it():
    arrays.sensitivities((20_000,))
    one = arrays.sensitivities((20_000,))
    part = one[3][5:]
    two = arrays.sensitivities((20_000,))
    assert not any(np.shares_memory(x, y) for x in one for y in two)
    del one
    assert not np.shares_memory(arrays.sensitivities((20_000,))[3], part)
    del two, part
    assert arrays._kept
    again = arrays.sensitivities((19_000,))
    assert not arrays._kept
    del again
    # Nobody who asks for little, or for very much, holds on to it.
    for size in (9_200, 500_000):
        other = arrays.sensitivities((size,))
        assert not arrays._kept or arrays._kept[0].size <= 60 * 100_000
        del other


def test_threads_that_ask_at_once_are_given_memory_of_their_own():
    arrays.sensitivities((20_000,))
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda _: arrays.sensitivities((20_000,))[3], range(16)))
    assert not any(np.shares_memory(x, y) for x, y in combinations(found, 2))
