"""`propagate` with many bodies: refused bodies, NaN, blocks, times of bodies, and memory."""

import math
import tracemalloc
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rigidsym import InputError, TorqueFreeMotion, propagate
from rigidsym import _inputs as inputs
from rigidsym._engines import batches
from rigidsym.generated import torque_free

BODY, RATES = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)
FLAT, IMPOSSIBLE = (1, 2, 3.0000000000000004), (1, 1, 5)


@pytest.mark.parametrize(
    ("moments", "exists"),
    [
        ((0.1, 0.2, 0.1 + 0.2), True),
        (FLAT, True),
        ((1, 2, 3.000000000000003), False),
        (IMPOSSIBLE, False),
        ((1e-30, 1, 1), True),
        ((1e-30, 1, 1 + 2**-52), False),
        ((1e-3, 1, 1 + 1e-3), True),
        ((1.2e-16, 1, 1 + 2**-52), True),
        ((5e-324, 5e-324, 1e-323), True),
        ((5e-324, 5e-324, 1.5e-323), False),
        ((1.7e308, 1.7e308, 1e308), True),
        ((1e307, 1e308, 1.5e308), False),
    ],
)
def test_which_bodies_can_exist(moments, exists, engine):
    """The rule is the same for one body and for batches, in any order of axes."""
    for order in ([0, 1, 2], [1, 2, 0], [2, 1, 0]):
        one = [moments[k] for k in order]
        if exists:
            TorqueFreeMotion(one, (0, 0, 0))
            batches.possible(np.array([BODY, one], float), False)
        else:
            with pytest.raises(InputError, match=r"^inertia = .*larger than the sum"):
                TorqueFreeMotion(one, (0, 0, 0))
            with pytest.raises(InputError, match=r"^inertia\[2\] = .*larger than the sum"):
                propagate([BODY, FLAT, one, one], (0, 0, 0), 1.0, engine=engine)


moments = st.floats(1e-300, 1e300)
ulps = st.integers(-9, 9)


@settings(max_examples=500, deadline=None)
@given(moments, st.floats(0, 60), ulps)
def test_the_rule_for_many_is_the_exact_one(middle, octaves, steps):
    low = middle * 2.0**-octaves
    high = middle + low
    for _ in range(abs(steps)):
        high = math.nextafter(high, math.copysign(math.inf, steps))
    exists = inputs.can_exist(*sorted(map(Fraction, (high, middle, low)), reverse=True))
    assert batches._are_impossible(np.array([[high, low, middle]])).tolist() == [not exists]


def test_arrays_of_many_bodies_are_not_listed():
    """To see that they are not one body, `step` made lists of all their numbers."""
    many = np.ones((100_000, 3))
    tracemalloc.start()
    found = batches.floats(many, 3), batches.floats(many[:3], 3), batches.moments(many)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert found == (None,) * 3
    assert peak < 10_000
    assert batches.floats(many[0], 3) == (1.0, 1.0, 1.0)


def test_errors_as_nan_leave_the_others_as_they_are(engine):
    inertia = np.tile(BODY, (8, 1))
    omega0, attitude0 = np.tile(RATES, (8, 1)), np.tile((1.0, 0, 0, 0), (8, 1))
    inertia[1], inertia[2, 0], inertia[3, 1] = IMPOSSIBLE, -1, math.nan
    attitude0[4] = 0
    omega0[5], inertia[5] = (1e-200, 1, 1e-200), (1, 2, 2.5)
    omega0[6] = 1e300
    t = np.array([0.0, 1.0, math.inf, 5000.0])
    q, omega = propagate(inertia, omega0, t, attitude0, engine=engine, errors="nan")
    seen = np.isfinite(q).all(axis=-1)
    np.testing.assert_array_equal(seen, np.isfinite(omega).all(axis=-1))
    np.testing.assert_array_equal(seen, ~np.isnan(q).any(axis=-1))
    near, none = [True, True, False, True], [False] * 4
    assert seen.tolist() == [
        near, none, none, none, none, [True, True, False, False],
        [True, False, False, False] if seen[6, 0] else none, near,
    ]  # fmt: skip
    for k in (0, 5, 7):
        at = np.flatnonzero(seen[k])
        one = TorqueFreeMotion(inertia[k], omega0[k], engine=engine)
        np.testing.assert_allclose(q[k, at], one(t[at])[0], rtol=0, atol=1e-15)
        alone = one(t, errors="nan")[0]
        np.testing.assert_array_equal(np.isnan(alone[:, 0]), ~seen[k])
    assert np.isnan(one(1e300, errors="nan")[0]).all()
    with pytest.raises(InputError, match=r"^inertia\[2, 0\] = -1.0|^inertia\[3, 1\] = nan"):
        propagate(inertia, omega0, t[:2], attitude0, engine=engine)
    with pytest.raises(InputError, match=r"^errors = drop: must be 'raise' or 'nan'"):
        propagate(BODY, RATES, t, engine=engine, errors="drop")
    with pytest.raises(InputError, match=r"^errors = 7: must be 'raise' or 'nan'"):
        one(1.0, errors=7)


def test_outputs_that_are_inputs_are_refused(engine):
    rule = r"^out = as given: q and omega must not overlap"
    for name in ("inertia", "omega0"):
        arrays = {"inertia": np.array(BODY), "omega0": np.array(RATES)}
        arrays[name] = memory = np.tile(arrays[name], (40, 1))
        before = memory.copy()
        out = np.empty((40, 1, 4)), memory.reshape(40, 1, 3)
        with pytest.raises(InputError, match=rule):
            propagate(*arrays.values(), [3.0], out=out, engine=engine)
        np.testing.assert_array_equal(memory, before)
    attitudes = np.tile((1.0, 0, 0, 0), (40, 1))
    out = attitudes.reshape(40, 1, 4), np.empty((40, 1, 3))
    with pytest.raises(InputError, match=rule):
        propagate(BODY, RATES, [3.0], attitudes, out=out, engine=engine)


def test_the_generated_module_refuses_outputs_that_it_reads():
    prepared = torque_free.prepare([BODY] * 5, [RATES] * 5)
    t, shared = np.arange(3.0), np.empty(500)
    q, omega = np.empty((5, 3, 4)), np.empty((5, 3, 3))
    shared[10:13] = shared[144:147] = t
    first, second = shared[:60].reshape(5, 3, 4), shared[102:147].reshape(5, 3, 3)
    for times, out in (
        (t, (first, shared[50:95].reshape(5, 3, 3))),
        (shared[10:13], (first, omega)),
        (shared[144:147], (q, second)),
        (1.0, (np.empty((5, 4)), prepared["omega0"])),
    ):
        with pytest.raises(ValueError, match=r"^out: q and omega must not overlap"):
            torque_free.states(prepared, times, out)
    assert torque_free.states(prepared, t, (q, omega))[0] is q


@pytest.mark.parametrize("shape", [(), (1,), (4,)], ids=str)
def test_a_plan_does_not_change_with_what_it_was_made_from(shape):
    given = [np.tile(x, (*shape, 1)).reshape(*shape, -1) for x in (BODY, RATES, (1.0, 0, 0, 0))]
    prepared = torque_free.prepare(*given)
    before = [torque_free.states(prepared, t) for t in (0.0, 1.0)]
    for array in given:
        array[...] = 99
    for t, expected in zip((0.0, 1.0), before, strict=True):
        states = torque_free.states(prepared, t)
        for got, wanted in zip(states, expected, strict=True):
            np.testing.assert_array_equal(got, wanted)
            got[...] = 7
        for got, wanted in zip(torque_free.states(prepared, t), expected, strict=True):
            np.testing.assert_array_equal(got, wanted)


def test_blocks_of_bodies_do_not_show(engine):
    draw = np.random.default_rng(3)
    x, y, z = draw.uniform(0.1, 1, (3, 3, 1600))
    inertia, omega0 = np.stack([y + z, z + x, x + y], -1), draw.normal(size=(1600, 3))
    t = [0.0, 2.0]
    q, omega = propagate(inertia, omega0, t, engine=engine)
    assert q.shape == (3, 1600, 2, 4)
    for k in ((0, 0), (2, 895), (2, 896), (2, 1599)):
        one = TorqueFreeMotion(inertia[k], omega0[k[1]], engine=engine)(t)
        np.testing.assert_allclose(q[k], one[0], rtol=0, atol=2e-15)
        np.testing.assert_allclose(omega[k], one[1], rtol=0, atol=1e-14)
    omega0[1599] = 1e300
    with pytest.raises(
        InputError, match=r"^omega0\[0, 1599\] = .*rates beyond|^t\[1\] = 2.0.*0, 1599"
    ):
        propagate(inertia, omega0, t, engine=engine)


@pytest.mark.parametrize("shape", [(7,), (2, 3), (0,)], ids=str)
@pytest.mark.parametrize("times", [0, 1, 40, 3000])
def test_each_body_has_times_of_its_own(shape, times, engine):
    draw = np.random.default_rng(4)
    x, y, z = draw.uniform(0.1, 1, (3, *shape))
    inertia, omega0 = np.stack([y + z, z + x, x + y], -1), draw.normal(size=(*shape, 3))
    t = draw.uniform(-9, 9, (*shape, times))
    t[..., : times // 20] = 0
    q, omega = propagate(inertia, omega0, t, engine=engine)
    assert q.shape == (*t.shape, 4)
    for k in np.ndindex(shape):
        alone = TorqueFreeMotion(inertia[k], omega0[k], engine=engine)(t[k])
        for found, expected in zip((q[k], omega[k]), alone, strict=True):
            np.testing.assert_allclose(found, expected, rtol=0, atol=4e-15)
            np.testing.assert_array_equal(found[t[k] == 0], expected[t[k] == 0])


def test_leading_shapes_of_times_broadcast_too(engine):
    t = np.array([[[0.5, -3.0]], [[7.0, 0.0]]])
    q, omega = propagate(BODY, [RATES, (1, 2, 3), (0, 0, 1)], t, engine=engine)
    assert q.shape == (2, 3, 2, 4)
    one_q, one_omega = propagate(BODY, RATES, t[1, 0], engine=engine)
    np.testing.assert_allclose(q[1, 0], one_q, rtol=0, atol=2e-15)
    np.testing.assert_allclose(omega[1, 0], one_omega, rtol=0, atol=2e-15)
    assert propagate(BODY, RATES, np.ones((1, 5)), engine=engine)[0].shape == (1, 5, 4)


def test_a_refused_time_of_a_body_has_both_their_numbers(engine):
    t = np.ones((3, 4))
    t[2, 1] = 1e300
    with pytest.raises(InputError, match=r"^t\[2, 1\] = 1e\+300: beyond"):
        propagate(BODY, [RATES], t, engine=engine)
    q, omega = propagate(BODY, [RATES], t, engine=engine, errors="nan")
    np.testing.assert_array_equal(np.isnan(q[..., 0]), t > 1)
    np.testing.assert_array_equal(np.isnan(omega[..., 0]), t > 1)
    t[1, 3] = math.inf
    with pytest.raises(InputError, match=r"^t\[1, 3\] = inf: must be finite"):
        propagate(BODY, [RATES], t, engine=engine)
    with pytest.raises(InputError, match=r"^t = .*\(3, 4\): .*broadcast with \(2,\)"):
        propagate(BODY, [RATES] * 2, np.ones((3, 4)), engine=engine)


def peak(*given, **options):
    """Return the largest memory that a call of `propagate` allocates, in bytes."""
    tracemalloc.start()
    try:
        propagate(*given, **options)
        return tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def test_times_of_bodies_are_read_where_they_are(engine):
    t = np.linspace(0, 9, 1_000_000).reshape(2, -1)
    out = np.empty((*t.shape, 4)), np.empty((*t.shape, 3))
    propagate(BODY, RATES, t[:, :9], engine=engine)
    assert peak(BODY, RATES, t, engine=engine, out=out) < t.nbytes


def test_memory_beyond_the_output_is_a_row_for_each_body_and_in_numpy_does_not_grow():
    def memory(bodies, engine):
        out = np.empty((bodies, 1, 4)), np.empty((bodies, 1, 3))
        return peak(BODY, np.tile(RATES, (bodies, 1)), [3.0], engine=engine, out=out)

    _, some, many = (memory(bodies, "numpy") for bodies in (10, 10_000, 40_000))
    assert many < 1.1 * some < 64e6
    # C reads whole rows: what all bodies share is repeated, three moments and four numbers of q.
    assert memory(40_000, "c") < 1.1 * 40_000 * 7 * 8


@pytest.mark.parametrize(
    "inertia",
    [np.array(1.0), {1.0, 2.0, 2.5}, {1.0: 0, 2.0: 0, 2.5: 0}, {1: 1}.keys(), b"abc", np.eye(3)],
    ids=str,
)
def test_what_has_no_order_or_one_number_or_rows_is_no_body(inertia):
    with pytest.raises(InputError, match=r"^inertia = .*: must be a list of numbers"):
        TorqueFreeMotion(inertia, RATES)
    if np.ndim(inertia) < 2:
        with pytest.raises(InputError, match=r"^inertia = "):
            propagate(inertia, RATES, 1.0)


def test_generators_have_an_order():
    assert TorqueFreeMotion(iter(BODY), (x for x in RATES)) == TorqueFreeMotion(BODY, RATES)


def test_masked_numbers_are_refused_by_name(engine):
    rates = np.ma.masked_equal([[0.05, 0.03, -0.02], [0.05, 7, -0.02]], 7)
    late, early = (np.ma.masked_equal(x, 7) for x in ([0.0, 7], [7, 0.0]))
    motion = TorqueFreeMotion(BODY, RATES, engine=engine)
    for call, message in (
        (lambda: propagate(BODY, rates, 1.0, engine=engine), r"omega0\[1, 1\] = --: is masked"),
        (
            lambda: propagate(BODY, RATES, late, engine=engine, errors="nan"),
            r"t\[1\] = --: is masked",
        ),
        (lambda: motion(early), r"t\[0\] = --: is masked"),
        (lambda: TorqueFreeMotion(BODY, rates[1]), r"omega0\[1\] = masked"),
        (lambda: motion.precise(early), r"t\[0\] = masked"),
    ):
        with pytest.raises(InputError, match=f"^{message}"):
            call()
    bare = propagate(BODY, np.ma.array([RATES]), 1.0, engine=engine)
    assert not isinstance(bare[0], np.ma.MaskedArray)
