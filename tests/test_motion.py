"""The public class and `propagate`: states on both engines, inputs of every kind, and errors."""

import copy
import math
import pickle
import subprocess
import sys
import tracemalloc
from decimal import Decimal
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from textbook import conjugate, multiply

import rigidsym
from rigidsym import InputError, Regime, TorqueFreeMotion, generate, plan, propagate
from rigidsym.generated import torque_free
from rigidsym.io.cases import parse_case
from rigidsym.manoeuvre._manoeuvre import parse
from rigidsym.solution._polhode import classify
from rigidsym.validate.strata import STRATA, count, draw

BODY, RATES = (0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)
MOTION = TorqueFreeMotion(BODY, RATES)
DECIMALS, DEGREES, TURNED = ("0.0109", "0.04", "0.0506"), ("3", "2", "-1"), math.pi / 180


@pytest.mark.parametrize(
    ("t", "shape"),
    [(1, ()), (1.0, ()), (np.float64(2), ()), (np.array(3.0), ()), ([], (0,)), ([1], (1,)),
     (range(5), (5,)), (np.linspace(0, 1, 20_001), (20_001,))],
)  # fmt: skip
def test_shapes_follow_the_times(t, shape):
    q, omega = MOTION(t)
    assert q.shape == (*shape, 4)
    assert omega.shape == (*shape, 3)
    assert q.dtype == omega.dtype == np.float64


def test_blocks_do_not_show():
    t = np.linspace(-300, 300, 20_001)
    q, omega = MOTION(t)
    for k in (0, 8191, 8192, 12_345, 20_000):
        one_q, one_omega = MOTION(t[k])
        np.testing.assert_allclose(q[k], one_q, rtol=0, atol=1e-15)
        np.testing.assert_allclose(omega[k], one_omega, rtol=0, atol=1e-17)


@pytest.mark.parametrize(
    ("start", "step", "count"), [(0.0, 0.5, 361), (2, -1, 3), (1.5, 0, 2), (7.0, 1.0, 0)]
)
def test_a_grid_is_the_states_at_its_times(engine, start, step, count):
    motion = TorqueFreeMotion(BODY, RATES, engine=engine)
    expected = motion(start + step * np.arange(count))
    out = np.empty((count, 4)), np.empty((count, 3))
    for states in (motion.grid(start, step, count), motion.grid(start, step, np.int32(count), out)):
        for got, wanted in zip(states, expected, strict=True):
            np.testing.assert_allclose(got, wanted, rtol=0, atol=2e-15)
    assert states[0] is out[0]
    assert states[1] is out[1]


def test_neighbouring_times_are_on_one_sheet_of_the_double_cover():
    q, _ = TorqueFreeMotion((1.0, 2.0, 2.5), (1.0, 2.0, 3.0))(np.linspace(0, 60, 6001))
    assert np.max(np.linalg.norm(np.diff(q, axis=0), axis=1)) < 0.03


def test_propagate_is_the_same_as_one_motion_at_a_time():
    # At scales of their own, two seconds are no time or too much of it.
    names = [name for name in STRATA if name not in ("scales", "extreme scales")]
    drawn = [draw(name, k, seed=3) for name in names for k in range(count(name, 3))]
    inertia, omega, attitude = (
        np.array([getattr(s, field) for s in drawn], dtype=float)
        for field in ("inertia", "omega0", "attitude0")
    )
    t = np.array([0.0, 0.5, -2.0])
    q, w = propagate(inertia, omega, t, attitude, allow_nonphysical=True)
    assert q.shape == (len(drawn), 3, 4)
    for k in range(len(drawn)):
        one = TorqueFreeMotion(inertia[k], omega[k], attitude[k], allow_nonphysical=True)(t)
        np.testing.assert_allclose(q[k], one[0], rtol=0, atol=1e-13)
        np.testing.assert_allclose(w[k], one[1], rtol=1e-13, atol=1e-13 * np.max(np.abs(omega[k])))


def test_propagate_broadcasts():
    q, w = propagate(BODY, [RATES, (0, 0, 0)], 1.0)
    assert q.shape == (2, 4)
    np.testing.assert_array_equal(q[1], [1, 0, 0, 0])
    assert propagate(np.empty((0, 3)), np.empty((0, 3)), [1.0])[0].shape == (0, 1, 4)
    assert propagate(BODY, RATES, [])[1].shape == (0, 3)
    assert not w[1].any()


@pytest.mark.parametrize("stratum", list(STRATA))
def test_the_generated_module_sees_the_regime_that_exact_arithmetic_sees(stratum):
    for index in range(count(stratum, 30)):
        sample = draw(stratum, index, seed=11)
        values = (sample.inertia, sample.omega0, sample.attitude0)
        inertia, omega0, attitude0 = (list(map(float, x)) for x in values)
        prepared = torque_free.prepare(inertia, omega0, attitude0)
        negligible = torque_free.NEGLIGIBLE * max(map(abs, omega0))
        told = [x if abs(x) >= negligible else 0.0 for x in omega0]
        exact = classify(*(list(map(Fraction, x)) for x in (inertia, told)))
        ((branch, _, _),) = prepared["groups"]
        assert (branch == "steady") == exact.regime.steady
        if not exact.regime.steady:
            assert inertia[prepared["axes"][0, 0]] == inertia[exact.axes[0]]


def test_exact_decision_survives_total_cancellation():
    """One ulp on either side of the separatrix changes the axis of circulation."""
    for omega, axis in ((1.0, 2), (math.nextafter(1.0, 2), 2), (math.nextafter(1.0, 0), 0)):
        prepared = torque_free.prepare((1.0, 2.0, 2.25), (0.75, 0.5, omega))
        assert prepared["axes"][0, 0] == axis
    exact = Fraction(math.nextafter(1.0, 0))
    motion = TorqueFreeMotion((1.0, 2.0, 2.25), (0.75, 0.5, float(exact)))
    q, _ = motion([40.0, 100.0])
    precise = motion.precise([40, 100], 20)[0]
    np.testing.assert_allclose(q, precise.astype(float), rtol=0, atol=1e-13)


rates = st.floats(-1, 1).map(lambda x: round(x, 6))
halves = st.tuples(*[st.floats(0.01, 10)] * 3)
spans = st.floats(-5, 5)


@settings(max_examples=200, deadline=None)
@given(halves, st.tuples(rates, rates, rates), spans, spans)
def test_motion_from_a_later_state_is_the_rest_of_the_motion(halves, omega, first, second):
    x, y, z = halves
    body = (y + z, z + x, x + y)
    motion = TorqueFreeMotion(body, omega)
    q, w = motion(first)
    later = TorqueFreeMotion(body, w, q)(second)[0]
    direct = motion(first + second)[0]
    # Rounding the later state moves it off its polhode; near the middle axis that grows like
    # exp(lambda t) with lambda at most |omega|.
    tolerance = 1e-13 * math.exp(math.hypot(*omega) * (abs(first) + abs(second)))
    assert tolerance < 1e-5
    assert np.linalg.norm(later - direct) < tolerance
    assert abs(np.linalg.norm(q) - 1) < 1e-15
    c = np.array(body)
    if any(omega):
        assert abs(c @ (w * w) / (c @ np.square(omega)) - 1) < 1e-14


@settings(max_examples=60, deadline=None)
@given(halves, st.tuples(rates, rates, rates), st.permutations(range(3)))
def test_relabelling_the_axes_cyclically_relabels_the_motion(halves, omega, order):
    x, y, z = halves
    body = np.array((y + z, z + x, x + y))
    order = list(order)
    q, w = TorqueFreeMotion(body, omega)(1.5)
    moved_q, moved_w = TorqueFreeMotion(body[order], np.array(omega)[order])(1.5)
    even = order in ([0, 1, 2], [1, 2, 0], [2, 0, 1])
    if even:
        np.testing.assert_allclose(moved_q[1:], q[1:][order], atol=1e-13)
        np.testing.assert_allclose(moved_w, w[order], atol=1e-12)
    else:  # a reflection runs the motion backwards
        back_q, back_w = TorqueFreeMotion(body, omega)(-1.5)
        np.testing.assert_allclose(moved_q[0], back_q[0], atol=1e-13)
        np.testing.assert_allclose(moved_q[1:], -back_q[1:][order], atol=1e-13)
        np.testing.assert_allclose(moved_w, back_w[order], atol=1e-12)


@pytest.mark.parametrize("power", [-60, -3, 5, 40])
def test_scaling_rates_scales_time_exactly(power):
    factor = 2.0**power
    q, omega = MOTION([1.0, 50.0])
    fast = TorqueFreeMotion(BODY, np.array(RATES) * factor)
    scaled_q, scaled_omega = fast(np.array([1.0, 50.0]) / factor)
    np.testing.assert_array_equal(scaled_q, q)
    np.testing.assert_array_equal(scaled_omega, omega * factor)


def test_rotation_is_body_to_inertial():
    _, omega = MOTION([10.0, 20.0])
    momentum = np.array(BODY) * omega
    turned = MOTION.rotation([10.0, 20.0]).apply(momentum)
    np.testing.assert_allclose(turned, [np.array(BODY) * RATES] * 2, atol=1e-17)


def test_momentum_stays_where_it_was_by_quaternion_products():
    q, omega = TorqueFreeMotion(BODY, RATES, (0.1, 0.2, -0.3, 0.4))(77.0)
    start = np.array((0.1, 0.2, -0.3, 0.4)) / np.linalg.norm((0.1, 0.2, -0.3, 0.4))

    def inertial(q, omega):
        return np.array(multiply(multiply(q, [0, *(np.array(BODY) * omega)]), conjugate(q)))

    np.testing.assert_allclose(inertial(q, omega), inertial(start, np.array(RATES)), atol=1e-17)


@pytest.mark.parametrize("kind", [str, Fraction, Decimal, mpmath.mpf, float, np.float32])
def test_numbers_of_every_kind(kind):
    motion = TorqueFreeMotion([kind("1.5")] * 2 + [kind("0.75")], [kind("0.25")] * 3)
    assert motion.inertia == (Fraction(3, 2), Fraction(3, 2), Fraction(3, 4))


@pytest.mark.parametrize("whole", [3, 2**53, 2**53 + 1, 2**62], ids=str)
@pytest.mark.parametrize("given", [tuple, list, np.array, np.float64], ids=lambda x: x.__name__)
def test_whole_numbers_and_arrays_are_what_they_say(given, whole):
    """Whole numbers beyond 2^53 are exact, too."""
    numbers = [given(values) for values in ((whole, whole, 2), (1, -2, 0), (0, 3, 0, 4))]
    motion = TorqueFreeMotion(*numbers)
    exact = [[Fraction(int(x)) for x in values] for values in numbers]
    assert motion == TorqueFreeMotion(*exact)
    assert motion.inertia[0] == (float(whole) if given is np.float64 else whole)


# Moments and rates that a motion refuses, with the error.
REFUSED_BODIES = [
    ((1, 2, -0.05), RATES, r"inertia\[2\] = -0.05: principal moments must be positive"),
    ((1, 0, 1), RATES, r"inertia\[1\] = 0: principal moments must be positive"),
    ((1, 2, math.inf), RATES, r"inertia\[2\] = inf: must be finite"),
    ((1, 2), RATES, r"inertia = \[1, 2\]: must have 3 numbers, not 2"),
    ((1, 2, 5), RATES, r"inertia = .*larger than the sum.*allow_nonphysical"),
    (("1", "x", "2"), RATES, r"inertia\[1\] = 'x': must be a finite decimal number"),
    (("1", "1e999999999", "2"), RATES, r"inertia\[1\] = .*exponents go up to"),
    (7, RATES, r"inertia = 7: must be a list of numbers"),
    ([[2, 0.1, 0], [0.1, 3, 0], [0, 0, 4]], RATES, r"inertia = .*principal_axes\(tensor\)"),
    (BODY, (1, math.nan, 2), r"omega0\[1\] = nan: must be finite"),
    (BODY, (1, None, 2), r"omega0\[1\] = None: must be a number"),
    (BODY, (1, 1j, 2), r"omega0\[1\] = 1j: must be a number"),
    (BODY, (True, 1, 2), r"omega0\[0\] = True: must be a number"),
    (("1", "2", "2.5e-4999"), (1, 2, 3), r"inertia = \[1, 2, 2.5E-4999\]: no body"),
]
# Times that a motion refuses.
REFUSED_TIMES = [
    (math.nan, "t = nan: must be finite"),
    ([0, math.inf], r"t\[1\] = inf: must be finite"),
    ([0, 1e300], r"t\[1\] = 1e[+]300: beyond"),
    ([[0.0]], "t = an array of shape .*must be one-dimensional"),
    ("soon", "t = 'soon': must be an array of numbers"),
    (None, "t = None: must be an array of numbers"),
    (True, "t = True: must be an array of numbers"),
    (np.datetime64("2020-01-01"), "t = 2020-01-01: dates count from the first of a"),
    (1j, "t = 1j: must be an array of numbers"),
    (10**400, "t = 1000.*must be an array of numbers"),
    (1e300, "t = 1e[+]300: beyond .omega. t = 2.46 rad"),
]
# Starts, steps and counts of grids that are refused.
REFUSED_GRIDS = [
    ("soon", 1, 2, "start = 'soon': must be an array of numbers"),
    (0, [1.0], 2, r"step = an array of shape \(1,\): must be one number"),
    (math.nan, 1, 2, "start = nan: must be finite"),
    (0, math.inf, 2, "step = inf: must be finite"),
    (0, None, 2, "step = None: must be an array of numbers"),
    (0, 1, -1, r"count = -1: must be a whole number from 0 to 2\^53"),
    (0, 1, 2.0, r"count = 2.0: must be a whole number from 0 to 2\^53"),
    (0, 1, True, r"count = True: must be a whole number from 0 to 2\^53"),
    (0, 1, 2**53 + 1, rf"count = {2**53 + 1}: must be a whole number from 0 to 2\^53"),
    (0, 1e16, 3, r"t\[1\] = 1e\+16: beyond \|omega\| t = 2\^46 rad the angle is lost in binary64"),
]
REFUSED_DECIMALS = [
    (("1.1", "1.1", "1e-70"), ("1", "1", "1"), "inertia = .*differ by more than binary64"),
    (("1.1", "1.2", "1.3"), ("1e-330", "0", "1e-330"), "omega0 = .*beyond the range"),
    (("1.1", "1.2", "1.3"), ("1e309", "0", "1"), "omega0 = .*beyond the range"),
]
REFUSED_BATCHES = [
    ([BODY, (1, 2, 9)], RATES, "inertia.*larger than the sum"),
    ([BODY, (1, -2, 2)], RATES, r"inertia\[1, 1\] = -2.0: .*positive"),
    ([BODY] * 2, [RATES] * 3, "omega0, attitude0 = .*must broadcast"),
    ([BODY], [(1, math.nan, 1)], r"omega0\[0, 1\] = nan: must be finite"),
    ([1e308, 1e307, 1.7e308], RATES, "inertia.*larger than the sum"),
    ([1, 2], RATES, "inertia = .*last axis must have 3 numbers"),
    ("body", RATES, "inertia = 'body'"),
]
SWITCH = "degrees = .*: must be true or false$"
REFUSED = [
    *((lambda _, x=x: TorqueFreeMotion(*x[:2]), x[2]) for x in REFUSED_BODIES),
    (lambda _: TorqueFreeMotion(BODY, RATES, (0, 0, 0, 0)), "attitude0 = .*must not be zero"),
    (lambda _: TorqueFreeMotion(BODY, RATES, (1, 0, 0)), "attitude0 = .*must have 4 numbers"),
    *((lambda e, x=x: MOTION.replace(engine=e)(x[0]), x[1]) for x in REFUSED_TIMES),
    *((lambda e, x=x: MOTION.replace(engine=e).grid(*x[:3]), f"{x[3]}$") for x in REFUSED_GRIDS),
    (lambda e: MOTION.replace(engine=e).grid(0, 1, 5, (np.empty((5, 4)), np.empty((4, 3)))),
     r"out = as given: omega is float64 of shape \(4, 3\)"),
    *((lambda e, x=x: TorqueFreeMotion(*x[:2], engine=e)(1.0), x[2]) for x in REFUSED_DECIMALS),
    *((lambda e, x=x: propagate(*x[:2], [0.0], engine=e), x[2]) for x in REFUSED_BATCHES),
    *((lambda _, x=x: TorqueFreeMotion(BODY, RATES, degrees=x), SWITCH) for x in (1, None, "deg")),
    *((lambda _, x=x: propagate(BODY, RATES, 1.0, degrees=x), SWITCH) for x in (1, None, "deg")),
    (lambda _: MOTION.replace(degrees=True),
     "degrees = True: is about omega0, which is not given$"),
    (lambda _: TorqueFreeMotion(BODY, RATES, engine="fortran"),
     "engine = 'fortran': must be one of: auto, numpy, c"),
    (lambda _: propagate(BODY, RATES, 1.0, engine="fortran"), "engine = 'fortran': must be one of"),
    (lambda _: generate(["c"]), r"target = \['c'\]: must be one of: numpy, c"),
]  # fmt: skip


@pytest.mark.parametrize(("call", "message"), REFUSED, ids=[x[1] for x in REFUSED])
def test_bad_input_is_one_line_with_field_value_and_rule(engine, call, message):
    with pytest.raises(InputError, match=f"^{message}") as caught:
        call(engine)
    assert "\n" not in str(caught.value)
    assert isinstance(caught.value, ValueError)


@pytest.mark.parametrize("scale", [1e-308, 5e-324, 1e300, 1.7e308])
def test_rates_at_the_ends_of_binary64(scale):
    motion = TorqueFreeMotion((1, 2, 2.5), (scale, 0, 0))
    t = 1 / scale if scale > 1e-307 else 1e307
    q, omega = motion(t)
    assert q[0] == pytest.approx(math.cos(scale * t / 2))
    assert omega[0] == scale
    with pytest.raises(InputError, match="the angle is lost in binary64"):
        TorqueFreeMotion((1, 2, 2.5), (1e290, 1e290, 0))([0.0, 1e290])


def test_what_binary64_cannot_follow_is_refused_and_precise_follows_it():
    motion = TorqueFreeMotion((1.0, 2.0, 2.5), (1e-200, 1.0, 1e-200))
    assert motion(1.0)[1].tolist() == [1e-200, 1.0, 1e-200]
    with pytest.raises(InputError, match="nearer to the separatrix than binary64 can follow"):
        motion(1000.0)
    _, omega = motion.precise(800, 10)
    assert 1e-50 < abs(omega[0]) < 1e-40  # it has left the middle axis by e^(lambda t)


@pytest.mark.parametrize("t", [0.0, [0.0, 1.0], np.array([2.0, 0.0])])
def test_at_t_0_the_state_is_the_given_one_to_the_bit(t):
    q, omega = MOTION(t)
    at = np.flatnonzero(np.asarray(t) == 0)[0] if np.ndim(t) else ()
    assert q[at].tolist() == [1, 0, 0, 0]
    assert omega[at].tolist() == list(RATES)


@pytest.mark.parametrize(
    ("inertia", "omega"),
    [
        (("0.4", "0.5", "0.9"), ("0.3", "0.05", "0.1")),
        (("0.4", "0.5", "0.9"), ("0.3", "0.05", "0.10000000000000000001")),
        (("0.4", "0.5", "0.9"), ("0.3", "0.05", "0.09999999999999999999")),
        (("0.9", "0.5", "0.4"), ("-0.1", "0.3", "0.3")),
    ],
)
def test_decimals_on_the_separatrix_stay_on_it(inertia, omega):
    """Rounded to doubles, these motions would be wrong by radians after a thousand seconds."""
    motion = TorqueFreeMotion(inertia, omega)
    times = [1.0, 100.0, -1000.0, 3000.0]
    q, w = motion(times)
    precise_q, precise_w = motion.precise(times, 20)
    np.testing.assert_allclose(q, precise_q.astype(float), rtol=0, atol=1e-12)
    np.testing.assert_allclose(w, precise_w.astype(float), rtol=0, atol=1e-13)


@pytest.mark.parametrize(
    ("inertia", "omega"),
    [
        (("1", "1.00000000000000000001", "0.5"), ("0.3", "0.2", "0.1")),
        (("1", "1.00000000000000000001", "0.5"), ("0.3", "0.2", "1e-30")),
        (("1", "1.00000000000000000001", "1.7"), ("0.3", "0.2", "0.1")),
        (("1", "1.00000000000000000001", "1.00000000000000000002"), ("0.3", "0.2", "0.1")),
        (("1000.001", "1000.002", "1000.003"), ("0.1", "0.2", "0.3")),
        (("1.000000001", "1.000000002", "1.000000004"), ("0.1", "0.2", "0.3")),
        (("0.7000000001", "0.7000000002", "1.2"), ("0.1", "0.2", "1e-6")),
        (("1", "1.0000000000000003", "1.0000000000000006"), ("1", "1", "1")),
        (("1e-140", "2e-140", "2.5e-140"), ("1e-12", "2e-12", "3e-12")),
        (("1e150", "2e150", "2.5e150"), ("0.1", "0.2", "0.3")),
    ],
)
def test_decimals_are_not_rounded_to_another_body(inertia, omega):
    motion = TorqueFreeMotion(inertia, omega)
    q, _ = motion([0.5, 10.0])
    np.testing.assert_allclose(q, motion.precise([0.5, 10], 20)[0].astype(float), atol=1e-14)


@pytest.mark.parametrize(
    ("inertia", "omega"),
    [((1, 1, 2), (0, 1, 1e-150)), ((1, 2, 2), (1e-150, 1, 0)), ((1, 1, 2), (1, 0, 1e-150))],
)
def test_symmetric_bodies_have_no_separatrix(inertia, omega):
    q, _ = TorqueFreeMotion(inertia, omega)(3.0)
    assert q[0] == pytest.approx(math.cos(1.5))


@pytest.mark.parametrize("rate", ["1e5000", "1e-5000"])
def test_rates_beyond_binary64(rate):
    motion = TorqueFreeMotion((1, 2, "2.5"), (rate, rate, rate))
    assert "E+5000" in repr(motion) or "E-5000" in repr(motion)
    with pytest.raises(InputError, match="beyond the range of binary64"):
        motion(1.0)
    assert motion.precise(0, 5)[0][0] == 1


def test_moments_too_different_for_binary64_are_refused():
    motion = TorqueFreeMotion((1e-200, 2e-200, 1.0), (1, 2, 3), allow_nonphysical=True)
    with pytest.raises(InputError, match="differ by more than binary64 can follow"):
        motion(1.0)
    assert np.isfinite([float(x) for x in motion.precise(1, 10)[0]]).all()


def test_flat_bodies_pass_and_nonphysical_ones_on_request():
    assert TorqueFreeMotion((0.1, 0.2, 0.1 + 0.2), RATES).inertia
    q, _ = TorqueFreeMotion((1, 2, 9), RATES, allow_nonphysical=True)(1.0)
    assert abs(np.linalg.norm(q) - 1) < 1e-15


@pytest.mark.parametrize(
    ("code", "absent"),
    [
        ("import rigidsym", {"sympy", "numpy", "mpmath", "rich"}),
        ("import rigidsym; rigidsym.TorqueFreeMotion((1, 2, 2.5), (1, 2, 3))(1.0)", {"sympy"}),
        ("import rigidsym; rigidsym.TorqueFreeMotion((1, 2, 2.5), (1, 2, 3)).precise(1)",
         {"sympy"}),
        ("import rigidsym; rigidsym.generate('numpy')", {"sympy"}),
        ("import rigidsym.generated.torque_free", {"sympy", "mpmath"}),
    ],
)  # fmt: skip
def test_what_is_not_imported(code, absent):
    check = f"{code}; import sys; print(*sorted(sys.modules))"
    found = subprocess.run(
        [sys.executable, "-c", check], capture_output=True, text=True, check=True
    )
    assert not absent & set(found.stdout.split())


def test_the_public_names():
    assert set(rigidsym.__all__) <= set(dir(rigidsym))
    assert not {"TYPE_CHECKING", "ModuleType", "import_module", "_HOMES"} & set(dir(rigidsym))
    assert all(getattr(rigidsym, name) for name in rigidsym.__all__)
    with pytest.raises(AttributeError, match="nothing"):
        _ = rigidsym.nothing


def test_a_motion_keeps_its_constants_and_travels_without_them():
    motion = TorqueFreeMotion((1, 2, 2.5), RATES)
    before = motion.enclose(1)[0]
    kept = motion._precise["theta"]
    assert len(kept._kept) == 1
    (evaluation,) = kept._kept.values()
    motion.enclose(2)
    assert [*motion._precise["theta"]._kept.values()] == [evaluation]
    for digits in range(20, 80, 10):
        motion.enclose(1, digits)
    assert len(kept._kept) <= 4
    again = pickle.loads(pickle.dumps(motion)).enclose(1)[0]
    assert [str(x) for x in again] == [str(x) for x in before]


@pytest.mark.parametrize(
    "t", [2, 2.0, np.float64(2), np.float32(2), np.int16(2), np.array(2.0), Fraction(2), "2"]
)
def test_one_time_of_any_kind(t, engine):
    motion = TorqueFreeMotion(BODY, RATES, engine=engine)
    q, omega = motion(t)
    assert (q.shape, omega.shape) == ((4,), (3,))
    exact = motion.precise(2, 25)
    np.testing.assert_allclose(q, exact[0].astype(float), rtol=0, atol=1e-15)
    np.testing.assert_allclose(omega, exact[1].astype(float), rtol=0, atol=1e-16)


def test_memory_beyond_the_output_is_small_for_any_number_of_times(engine):
    motion = TorqueFreeMotion(BODY, RATES, engine=engine)
    t = np.linspace(0, 100, 2_000_000)
    out = np.empty((t.size, 4)), np.empty((t.size, 3))
    motion(0.0)
    tracemalloc.start()
    assert motion(t, out)[0] is out[0]
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 12e6  # less than one more array of times


@pytest.mark.parametrize(
    ("inertia", "omega0"),
    [
        (("1.1", "2.2", "2.2"), ("1e-140", "1", "0")),
        (("2.2", "1.1", "2.2"), ("1", "0", "1e-140")),
        (("1.1", "1.1", "1e-50"), ("0.1", "0.2", "0.3")),
        (("1.1e305", "1.5e305", "1.2e305"), ("0.1", "0.2", "0.3")),
        (("1.1e-305", "1.5e-305", "1.2e-305"), ("0.1", "0.2", "0.3")),
        (("1", "2", "2.5"), ("1e-307", "2e-307", "3e-307")),
    ],
)
def test_decimals_anywhere_in_the_range_of_doubles(inertia, omega0, engine):
    motion = TorqueFreeMotion(inertia, omega0, engine=engine)
    times = [0.5, 3.0]
    exact = motion.precise(times, 25)
    np.testing.assert_allclose(motion(times)[0], exact[0].astype(float), rtol=0, atol=1e-15)


def test_a_batch_names_the_body_and_the_time_it_is_refused_for(engine):
    rates = np.tile(RATES, (3, 4, 1))
    rates[1, 2] = (1e-130, 1.0, 1e-135)
    rule = r"nearer to the separatrix than binary64 can follow beyond \d+\.\d+ s \(body 1, 2\)"
    with pytest.raises(InputError, match=rf"^t\[1\] = 5000.0: {rule}$"):
        propagate((1.0, 2.0, 2.5), rates, [1.0, 5e3, 6e3], engine=engine)
    rates[2, 1] = (1e307, 1e306, 1e305)
    with pytest.raises(InputError, match=r"^omega0\[2, 1\] = \[1.*: rates beyond"):
        propagate((1.0, 2.0, 2.5), rates, [0.0], engine=engine)


def test_rates_are_those_in_radians_to_three_hundred_digits():
    motion = TorqueFreeMotion(DECIMALS, DEGREES, degrees=True)
    with mpmath.workdps(320):
        for rate, given in zip(motion.omega0, DEGREES, strict=True):
            exact = mpmath.mpf(rate.numerator) / rate.denominator
            assert abs(exact / mpmath.radians(mpmath.mpf(given)) - 1) < mpmath.mpf(10) ** -300
    radians = motion.replace(omega0=[TURNED * float(x) for x in DEGREES])
    assert np.allclose(motion(100.0)[0], radians(100.0)[0], rtol=0, atol=1e-14)
    assert np.allclose(motion(100.0)[1], radians(100.0)[1], rtol=0, atol=1e-16)


def test_ratios_stay_exact_and_the_regime_with_them():
    body, rates = (4, 5, 9), (3, 1, 1)
    assert 4 * (5 - 4) * rates[0] ** 2 == 9 * (9 - 5) * rates[2] ** 2
    assert TorqueFreeMotion(body, rates, degrees=True).regime == Regime.SEPARATRIX
    assert TorqueFreeMotion(body, np.deg2rad(rates)).regime != Regime.SEPARATRIX


def test_uncertain_rates_keep_their_part():
    motion = TorqueFreeMotion(DECIMALS, ("3 +/- 0.03", 2, 1), degrees=True)
    assert motion.omega0[0].radius * 100 == motion.omega0[0].middle
    middle = motion.replace(omega0=(3, 2, 1), degrees=True).omega0[0]
    assert motion.omega0[0].middle == middle


def test_batches_take_them():
    body = [float(x) for x in DECIMALS]
    q, omega = propagate(body, [3.0, 2.0, -1.0], [0.0, 10.0], degrees=True)
    same = propagate(body, np.deg2rad([3.0, 2.0, -1.0]), [0.0, 10.0])
    assert np.array_equal(q, same[0])
    assert np.array_equal(omega, same[1])


def test_files_take_them():
    text = "inertia = [1, 2, 2.5]\nomega0 = [10, 20, 30]\ntimes = [0]\ndegrees = true\n"
    motion = parse_case(text).motion
    assert motion == TorqueFreeMotion((1, 2, 2.5), (10, 20, 30), degrees=True)
    with pytest.raises(InputError, match=r"^degrees = 'yes': must be true or false$"):
        parse_case(text.replace("true", "'yes'"))


def test_plans_take_them_as_doubles():
    ends = DECIMALS, (1, 0, 0, 0), ("0.5", "0.5", "0.5", "0.5"), 100
    limits = {"max_rate": 5, "target_spin": (1, 0, "0.5")}
    found = plan(*ends, **limits, degrees=True, engine="numpy").manoeuvre
    assert found.limits.max_rate == Fraction(5 * TURNED)
    assert np.allclose([float(x) for x in found.target_spin], [TURNED, 0, TURNED / 2], rtol=1e-16)
    tables = {
        "inertia": DECIMALS, "start": ends[1], "target": ends[2], "duration": 100, "degrees": True,
        "spin": {"target": limits["target_spin"]}, "limits": {"max_rate": 5},
    }  # fmt: skip
    assert parse(tables) == found
    assert max(map(len, found.to_data()["spin"]["target"])) < 30


def test_replace_keeps_rates_that_were_given_in_degrees():
    motion = TorqueFreeMotion(DECIMALS, DEGREES, degrees=True)
    assert motion.replace(engine="c").omega0 == motion.omega0


@pytest.mark.parametrize(
    "name", ["inertia", "omega0", "attitude0", "engine", "anything", "_prepared"]
)
def test_nothing_of_a_motion_changes(name):
    motion = TorqueFreeMotion(DECIMALS, RATES)
    before = repr(motion), motion(1.0)[0].tolist()
    rule = rf"^{name}: a motion does not change; motion.replace gives another$"
    with pytest.raises(AttributeError, match=rule):
        setattr(motion, name, (1, 2, 3))
    with pytest.raises(AttributeError, match=rule):
        delattr(motion, name)
    assert (repr(motion), motion(1.0)[0].tolist()) == before


def test_what_it_was_made_from_may_change():
    given = [np.array(x, float) for x in (DECIMALS, RATES, (1, 0, 0, 0))]
    motion = TorqueFreeMotion(*given)
    for array in given:
        array[:] = 99
    assert motion(0.0)[1].tolist() == list(RATES)
    motion(0.0)[1][:] = 7
    motion([0.0])[0][:] = 7
    assert motion(0.0)[1].tolist() == list(RATES)
    assert motion(0.0)[0].tolist() == [1, 0, 0, 0]


def test_equal_numbers_are_equal_motions():
    motion = TorqueFreeMotion(DECIMALS, RATES)
    same = TorqueFreeMotion([Fraction(x) for x in DECIMALS], np.array(RATES))
    motion(1.0)
    assert motion == same
    assert hash(motion) == hash(same)
    assert {motion: 1}[same] == 1
    others = [
        TorqueFreeMotion([float(x) for x in DECIMALS], RATES),
        motion.replace(omega0=(0.05, 0.03, 0.02)),
        motion.replace(attitude0=(1, 0, 0, 1)),
        motion.replace(engine="c"),
    ]
    assert len({motion, *others}) == 5
    assert motion != (DECIMALS, RATES)


def test_replace_keeps_the_rest():
    motion = TorqueFreeMotion((1, 1, 5), RATES, (1, 2, 3, 4), allow_nonphysical=True, engine="c")
    other = motion.replace(omega0=("0.1", 0, 0))
    assert other.engine == "c"
    assert other.inertia == motion.inertia
    assert other.attitude0 == motion.attitude0
    assert other.omega0 == (Fraction(1, 10), 0, 0)
    with pytest.raises(InputError, match=r"^inertia = .*larger than the sum"):
        motion.replace(allow_nonphysical=False)
    with pytest.raises(InputError, match=r"^omega0\[0\] = 'x'"):
        motion.replace(omega0=("x", 1, 2))
    with pytest.raises(TypeError, match="torque"):
        motion.replace(torque=1)


def test_copies_are_the_motion_and_those_sent_elsewhere_equal_it(engine):
    motion = TorqueFreeMotion(DECIMALS, ("0.05 +/- 1e-9", 0.03, -0.02), engine=engine)
    assert pickle.loads(pickle.dumps(motion)) == motion
    assert motion.replace(engine="numpy").replace(engine=engine) == motion
    exact = motion.replace(omega0=RATES)
    expected = exact([1.0, 2.0])
    assert exact._prepared is exact._prepared
    assert copy.copy(exact) is copy.deepcopy([exact])[0] is exact
    again = pickle.loads(pickle.dumps(exact))
    assert again == exact
    for states in (again([1.0, 2.0]), exact([1.0, 2.0])):
        assert all(map(np.array_equal, states, expected))
