"""Enclosures of motions: they hold the true values and are as small as asked for."""

import json
import multiprocessing
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from fractions import Fraction
from itertools import combinations, product
from pathlib import Path

import flint
import mpmath
import numpy as np
import pytest
from boxes import ATTITUDE, BODY, PAPER, contain, distance, holds_points, numbers, overlap
from flint import arb, fmpq

from rigidsym import InputError, TorqueFreeMotion
from rigidsym._inputs import Uncertain, exact
from rigidsym.errors import PrecisionError
from rigidsym.precise import _functions as functions
from rigidsym.precise._balls import ball, has_digits, is_within, working
from rigidsym.precise._functions import METHODS, amplitude, quarter_period
from rigidsym.precise._taylor import integrate
from rigidsym.validate.strata import STRATA, draw

SHARED = Path(__file__).parents[3] / "shared" / "reference"
needs_reference = pytest.mark.skipif(
    not SHARED.exists(), reason="shared reference data is not here"
)
DIGITS = 25
TINY, LESS = Fraction(1, 10**300), Fraction(1, 10**12)
EDGES = {
    "above the separatrix": ((4, 5, 9), (3 * (1 + TINY), 1, -1)),
    "below the separatrix": ((4, 5, 9), (-3 * (1 - TINY), 1, 1)),
    "separatrix of decimals": (("0.9", "0.4", "0.5"), ("0.1", "-0.3", "0.7")),
    "separatrix, no middle rate": ((4, 5, 9), (3, 0, 1)),
    "tilted from the largest": ((1, 2, "2.5"), ("1e-100", 0, 1)),
    "tilted from the smallest": (("2.5", 1, 2), (0, -1, "1e-12")),
    "tilted from the middle": ((1, 2, "2.5"), ("1e-12", 1, "-1e-100")),
    "tilted from the middle, one way": ((1, 2, "2.5"), (0, -1, "1e-100")),
    "nearly symmetric": ((1, 1 + TINY, "1.5"), (1, 2, "1e-3")),
    "nearly symmetric, prolate": ((1 + LESS, "0.5", 1), ("1e-3", 2, -1)),
    "nearly a sphere": ((1 + LESS, 1, 1 + 3 * LESS), ("0.1", "0.2", "-0.3")),
    "symmetric of decimals": (("0.1", "0.15", "0.1"), (1, -2, 3)),
    "symmetric, hardly about the axis": ((1, 1, "1.5"), (1, 2, "1e-100")),
    "sphere": (("0.1", "0.1", "0.1"), (1, -2, 3)),
    "spin about the first": ((1, 2, "2.5"), (-1, 0, 0)),
    "spin about the middle": ((1, 2, "2.5"), (0, -1, 0)),
    "spin about the last": ((1, 2, "2.5"), (0, 0, 1)),
    "rest": ((1, 2, "2.5"), (0, 0, 0)),
    "needle": (("1e-9", "1e3", "1e3"), ("1", "1e-12", "1e-3")),
    "mixed": (("1e-9", 1, "1.0000000005"), ("1", "1e-12", "1e-3")),
}


def hold(found, expected, slack):
    """Return True if balls hold the numbers of an oracle, up to its error."""
    return contain([x + arb(0, slack) for x in found], [ball(exact("", x)) for x in expected])


def by_all_methods(motion, time):
    """Return the balls of each method, which have the digits asked for and overlap."""
    found = [numbers(motion.enclose(time, DIGITS, method=method)) for method in METHODS]
    assert all(is_within(value, DIGITS) for values in found for value in values)
    assert all(overlap(*pair) for pair in combinations(found, 2))
    return found


def check(motion, turned):
    """Check that all methods hold the Taylor series after a turn by `turned` radians."""
    time = Fraction(turned) / (max(map(abs, motion.omega0)) or Fraction(1))
    expected = numbers(integrate(*motion.exact.values(), time))
    with working(400), mpmath.workdps(60):
        slack = arb(float(max(1, *map(abs, expected)))) * arb(1e-36)
        assert all(hold(values, expected, slack) for values in by_all_methods(motion, time))


@pytest.mark.parametrize("stratum", [name for name in STRATA if name != "long times"])
@pytest.mark.parametrize("index", [0, 4])
def test_all_methods_hold_the_oracle_over_the_strata(stratum, index):
    sample = draw(stratum, index, seed=11)
    check(TorqueFreeMotion(sample.inertia, sample.omega0, sample.attitude0), "-8/3")


@pytest.mark.parametrize("edge", EDGES)
def test_all_methods_hold_the_oracle_at_the_edges(edge):
    check(TorqueFreeMotion(*EDGES[edge], ATTITUDE), "7/3")


@pytest.mark.parametrize(
    "order", [(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)]
)
def test_every_order_of_axes_and_every_sign(order):
    body, time = [2, 3, 4], Fraction(3, 10)
    for rates in ((1, Fraction(1, 2), Fraction(1, 3)), (Fraction(1, 3), Fraction(1, 2), 1)):
        for signs in product((-1, 1), repeat=3):
            omega = [s * w for s, w in zip(signs, rates, strict=True)]
            motion = TorqueFreeMotion([body[k] for k in order], [omega[k] for k in order], ATTITUDE)
            expected = numbers(integrate(*motion.exact.values(), time, 30))
            with working(300), mpmath.workdps(50):
                for method in ("theta", "landen"):
                    found = numbers(motion.enclose(time, DIGITS, method=method))
                    assert hold(found, expected, arb(1e-26))


@pytest.mark.parametrize("case", ["paper", *EDGES])
@pytest.mark.parametrize("time", ["-1e15", pytest.param("12345.678", marks=pytest.mark.slow)])
def test_methods_agree_at_long_times(case, time):
    by_all_methods(TorqueFreeMotion(*EDGES.get(case, PAPER), ATTITUDE), time)


@pytest.mark.parametrize("stratum", STRATA)
@pytest.mark.parametrize("index", range(3))
def test_thirty_digits_are_the_first_thirty_of_sixty(stratum, index):
    sample = draw(stratum, index, seed=3)
    motion = TorqueFreeMotion(sample.inertia, sample.omega0, sample.attitude0)
    few, more = (np.hstack(motion.precise(sample.times, digits)) for digits in (30, 60))
    with mpmath.workdps(80):
        unit = mpmath.mpf(10) ** -30
        assert all(abs(a - b) <= abs(b) * unit for a, b in zip(few.flat, more.flat, strict=True))


@pytest.mark.parametrize(("method", "digits"), [*((m, 300) for m in METHODS), ("theta", 10_000)])
def test_many_digits_and_few(method, digits):
    motion = TorqueFreeMotion(*PAPER)
    one, many = (numbers(motion.enclose(100, d, method=method)) for d in (1, digits))
    with working(4 * digits + 100):
        assert all(is_within(value, digits) for value in many)
        assert overlap(one, many)


def test_zeros_are_as_small_as_asked_for():
    """Components that are zero, but not known to be, are small enough beyond 2^-4000 too."""
    q, omega = TorqueFreeMotion((1, 1, "1.5"), (3, 0, 1)).enclose("1/3", 1500)
    with working(6000):
        assert all(is_within(value, 1500) for value in (*q, *omega))


@needs_reference
def test_reference_motions_by_every_method_and_in_digits():
    cases = json.loads((SHARED / "reference_cases.json").read_text())["cases"]
    assert len(cases) == 31
    for case in cases:
        given = (case["inertia"], case["omega0"], case["q0"])
        motion = TorqueFreeMotion(*given, allow_nonphysical=True)
        times = [row["t"] for row in case["hp"]]
        for method in METHODS:
            for *state, row in zip(
                *motion.enclose(times, 30, method=method), case["hp"], strict=True
            ):
                expected = list(map(Fraction, (*row["q"], *row["omega"])))
                assert hold(numbers(state), expected, arb(3e-26)), case["id"]
        for *state, row in zip(*motion.precise(times, 30), case["hp"], strict=True):
            with mpmath.workdps(40):
                expected = map(mpmath.mpf, (*row["q"], *row["omega"]))
                assert distance(numbers(state), expected) < 3e-26, case["id"]


def angle(x, y):
    cosine = x @ y / np.linalg.norm(x) / np.linalg.norm(y)
    return np.degrees(np.arccos(np.clip(cosine, -1, 1)))


@needs_reference
def test_toutatis_as_it_was_observed():
    """Predicted minus observed values are those of the publication."""
    rotation = pytest.importorskip("scipy.spatial.transform").Rotation
    data = json.loads((SHARED / "reference_cases.json").read_text())["toutatis"]

    def matrix(zxz):
        # Body axes 1, 2, 3 are z, x, y of the observers.
        return rotation.from_euler("ZXZ", zxz, degrees=True).as_matrix()[:, [2, 0, 1]]

    start = matrix([145.498, 65.865, 241.524])
    rates = np.radians(data["omega0_deg_per_day_123"]) / 86400
    attitude = np.roll(rotation.from_matrix(start).as_quat(), 1)
    motion = TorqueFreeMotion(data["inertia"], rates.tolist(), attitude.tolist())
    times = [row["t_seconds"] for row in data["observations"]]
    q, omega = (values.astype(float) for values in motion.precise(times, 20))
    checked = 0
    for k, row in enumerate(data["observations"]):
        if "recomputed_errors" not in row:
            continue
        body = rotation.from_quat(np.roll(q[k], -1)).as_matrix()
        seen = matrix(row["euler_zxz_deg_takahashi"])
        predicted = np.degrees(omega[k]) * 86400
        rate = np.array(row["omega_takahashi_xyz_deg_per_day"])[[2, 0, 1]]
        size = abs(1 - np.linalg.norm(predicted) / np.linalg.norm(rate))
        found = [size, angle(predicted, rate)]
        found += [angle(body[:, j], seen[:, j]) for j in range(3)]
        assert found == pytest.approx(row["recomputed_errors"], rel=3e-3, abs=2e-3), row["utc"]
        checked += 1
    assert checked


def table(name):
    data = json.loads((SHARED / "elliptic_reference_principia.json").read_text())
    return data["tables"][name]["rows"]


def agrees(value, text):
    """Return True for agreement to three units in the last printed digit, or to 4e-19."""
    mantissa, _, exponent = text.partition("e")
    places = len(mantissa.partition(".")[2]) - int(exponent or 0)
    error = max(3 * Fraction(10) ** -places, Fraction(4, 10**19))
    return abs(value - ball(Fraction(text))) < ball(error)


def first_kind(phi, mc):
    """Return the integral F of the first kind for any amplitude."""
    turns = int((phi / arb.pi()).mid().floor().unique_fmpz())
    rest = phi - turns * arb.pi()
    if 2 * rest > arb.pi():
        turns, rest = turns + 1, rest - arb.pi()
    return 2 * turns * quarter_period(mc) + functions.first_kind(rest, mc)[0]


@needs_reference
@pytest.mark.parametrize("method", METHODS)
def test_jacobi_functions_of_the_reference_tables(method):
    jacobi = METHODS[method]().jacobi
    with working(160):
        for u, m, *expected in table("elliptic_functions"):
            mc = ball(1 - Fraction(m))
            found = [*jacobi(ball(Fraction(u)), mc), amplitude(ball(Fraction(u)), mc)]
            assert all(map(agrees, found, expected)), (u, m)


@needs_reference
@pytest.mark.parametrize("method", ["carlson", "landen", "quadrature"])
def test_integrals_of_the_reference_tables(method):
    functions, checked = METHODS[method](), 0
    with working(160):
        for phi, m, *_, first in table("bivariate_elliptic_integrals"):
            if Fraction(m) < 1:
                assert agrees(first_kind(ball(Fraction(phi)), ball(1 - Fraction(m))), first)
        for row in table("trivariate_elliptic_integrals"):
            phi, n, m = map(Fraction, row[:3])
            if not (m < 1 and n < 1) or (method == "landen" and not 0 < m < (n if n > 0 else 1)):
                continue  # motions have 0 < m < 1, and n < 0 or m < n < 1
            u = first_kind(ball(phi), ball(1 - m))
            j = functions.elliptic_j(u, ball(n), ball(1 - m))
            assert agrees(j, row[3]), row
            assert agrees(u + ball(n) * j, row[4]), row
            checked += 1
    assert checked > 100


def settings():
    return flint.ctx.prec, flint.ctx.threads, mpmath.mp.prec


@pytest.mark.parametrize("prec", [53, 777])
def test_precisions_are_left_alone_after_errors_too(prec):
    motion = TorqueFreeMotion(*PAPER)
    with flint.ctx.workprec(prec), mpmath.workprec(prec + 1):
        before = settings()
        ball_before = motion.enclose(3, 40)[0][0]
        with pytest.raises(PrecisionError):
            motion.enclose(3, 100_000, max_seconds=1e-9)
        with pytest.raises(InputError):
            TorqueFreeMotion(PAPER[0], ("0 +/- 1", 0, 0)).enclose(1, method="theta")
        TorqueFreeMotion(PAPER[0], ("0 +/- 1", 0, 0)).enclose(1)
        motion.precise(3, 40)
        assert settings() == before
        assert is_within(ball_before, 14)


def enclosed(digits):
    q, omega = TorqueFreeMotion(*PAPER).enclose(17, digits)
    with working(4 * digits + 64):
        return digits, [x.str(digits + 10, more=True) for x in (*q, *omega)]


DEMANDS = [10, 200, 15, 400, 30, 100, 20, 300]


def test_threads_with_different_digits_do_not_mix():
    alone = list(map(enclosed, DEMANDS))
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(enclosed, DEMANDS * 3)) == alone * 3


@pytest.mark.parametrize("start", ["spawn", "fork"])
@pytest.mark.filterwarnings("ignore:This process:DeprecationWarning")
def test_processes(start):
    context = multiprocessing.get_context(start)
    with ProcessPoolExecutor(2, mp_context=context) as pool:
        assert list(pool.map(enclosed, DEMANDS)) == list(map(enclosed, DEMANDS))


def test_shapes():
    motion = TorqueFreeMotion(*PAPER)
    for times, shape in (([], (0,)), ([1], (1,)), (np.array([1.0, -2.0]), (2,)), ("1/3", ())):
        q, omega = motion.enclose(times, 12)
        assert (q.shape, omega.shape) == ((*shape, 4), (*shape, 3))


UNCERTAIN = {
    "rates": (BODY, ("0.05 +/- 1e-6", "0.03 +/- 1e-6", "-0.02 +/- 1e-6"), (1, 0, 0, 0)),
    "inertia": (("0.0109 +/- 1e-6", "0.04 +/- 1e-5", "0.0506"), PAPER[1], (1, 0, 0, 0)),
    "all": (
        ("0.0109 +/- 1e-7", "0.04 +/- 1e-7", "0.0506 +/- 1e-7"),
        ("0.01 +/- 1e-6", "0.03 +/- 1e-6", "-0.05 +/- 1e-6"),
        ("1 +/- 1e-3", "0 +/- 1e-3", "-0.5 +/- 1e-3", "0.2"),
    ),
    "middle rate about zero": ((1, 2, "2.5"), ("0.3", "0 +/- 1e-4", 1), ATTITUDE),
    "last rate about zero": ((1, 2, "2.5"), ("0 +/- 1e-4", "-0.2", 1), ATTITUDE),
    "last rate near zero": ((1, 2, "2.5"), ("1e-5 +/- 1e-4", "-0.2 +/- 1e-4", -1), ATTITUDE),
    "symmetric": ((1, "1.5", 1), ("0.5 +/- 1e-5", "-1 +/- 1e-5", "0.3"), ATTITUDE),
    "symmetric of decimals": (("0.1", "0.1", "0.15"), (1, 2, "3 +/- 1e-5"), ATTITUDE),
    "separatrix": (("0.4", "0.5", "0.9"), ("0.3", "1 +/- 1e-5", "0.1"), ATTITUDE),
    "sphere": (("0.1", "0.1", "0.1"), ("1 +/- 1e-3", "0 +/- 1e-3", 0), ATTITUDE),
    "spin": ((1, 2, "2.5"), (0, "1 +/- 1e-3", 0), ATTITUDE),
    "attitude": ((1, 2, "2.5"), (0, 0, 0), ("1 +/- 1e-3", 0, 0, "0 +/- 1e-3")),
}


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("case", UNCERTAIN)
@pytest.mark.parametrize("time", ["10", "-150"])
def test_uncertain_inputs_are_held_point_by_point(case, method, time):
    if method == "landen" and case in ("all", "last rate near zero"):
        pytest.skip("1 - m/n of balls that wide is beyond Gauss's transformation")
    motion = TorqueFreeMotion(*UNCERTAIN[case])
    found = numbers(motion.enclose(time, 20, method=method))
    assert all(value.is_finite() for value in found)
    assert holds_points(found, motion, time)


def test_uncertain_inputs_at_many_times_cost_the_same_at_each():
    motion = TorqueFreeMotion(*UNCERTAIN["rates"])
    q, omega = motion.enclose(range(40), 15)
    again, _ = motion.enclose(39, 15)
    assert overlap(q[-1], again)
    assert all(value.rad() < 1e-2 for value in (*q.flat, *omega.flat))


def test_wide_phases_are_held_or_refused():
    """A phase may be uncertain by more than a quarter of a period."""
    given = ((1, 2, "2.5"), ("0.3 +/- 1e-3", "0.4 +/- 1e-3", "1 +/- 1e-3"))
    motion = TorqueFreeMotion(*given)
    for time, method in product((300, 1000, 3000, 10_000), METHODS):
        try:
            found = numbers(motion.enclose(time, 15, method=method))
        except PrecisionError:
            continue
        assert holds_points(found, motion, time)


def test_balls_of_flint_are_uncertain_numbers():
    radius = arb("0.05", 1e-6)
    by_ball = TorqueFreeMotion(PAPER[0], (radius, "0.03", "-0.02")).enclose(10, 20)
    by_text = TorqueFreeMotion(PAPER[0], ("0.05 +/- 1e-6", "0.03", "-0.02")).enclose(10, 20)
    for a, b in zip(numbers(by_ball), numbers(by_text), strict=True):
        assert a.overlaps(b)
        assert a.rad() < 1.01 * b.rad()
    printed = TorqueFreeMotion(PAPER[0], ("[+/- 1.01e-5]", 1, 1)).omega0[0]
    assert (printed.middle, printed.radius) == (0, Fraction("1.01e-5"))


@pytest.mark.parametrize(
    ("inertia", "omega", "message"),
    [
        (("1 +/- 1e-3", 1, "1.5"), (1, 2, 3), r"inertia\[0\] - inertia\[1\].*exact"),
        (("1.01 +/- 0.02", 1, "1.5"), (1, 2, 3), r"inertia\[0\] - inertia\[1\].*2\.\d times narr"),
        (PAPER[0], ("0 +/- 1e-3", 0, 0), r"omega0\[0\], of a body at rest.*exact"),
        ((1, 1, 1), ("0 +/- 1e-3", 0, 0), r"omega0\[0\], of a body at rest.*exact"),
        (PAPER[0], (0, "1e-4 +/- 1e-3", 0), r"omega0 may be zero.*11\.\d times narrower"),
        (PAPER[0], (1, "0 +/- 1e-3", 0), r"torque by omega0\[0\] and omega0\[1\].*exact"),
        ((1, 2, "2.5"), ("1e-12 +/- 1e-10", "0 +/- 1e-10", 1), r"right angles.*110\.\d times"),
        ((4, 5, 9), (3, 1, "1 +/- 1e-9"), "K\\^2 - 2 H c_b.*exact"),
        ((4, 5, 9), (3, 1, "1.001 +/- 0.01"), r"K\^2 - 2 H c_b.*11\.\d times narrower"),
        ((1, 1, "1.5"), (1, 2, "0.1 +/- 0.2"), r"omega0\[2\], about the circ.*2\.\d times narr"),
    ],
)
def test_a_boundary_within_the_inputs_is_named(inertia, omega, message):
    motion = TorqueFreeMotion(inertia, omega)
    for ask in (lambda: motion.enclose(100, 10, method="carlson"), lambda: motion.regime):
        with pytest.raises(InputError, match=message) as error:
            ask()
        assert "\n" not in str(error.value)


def test_hopelessly_uncertain_inputs_say_so():
    motion = TorqueFreeMotion(("0.0109 +/- 1e-6", "0.04", "0.0506"), PAPER[1])
    for method in METHODS:
        with pytest.raises(PrecisionError, match="t = 1000000: the inputs are too uncertain"):
            motion.enclose(1e6, 20, method=method)


def test_time_limits_say_what_was_reached():
    motion = TorqueFreeMotion(*PAPER)
    uncertain = TorqueFreeMotion(*UNCERTAIN["rates"])
    for one, t, digits, seconds, message in (
        (motion, 10, 30_000, 0.02, r"t = 10: \d+ of 30000 digits were reached"),
        (motion, range(10_000), 15, 0.05, r"t = \d+: 0 of 15 digits were reached"),
        (uncertain, range(10_000), 15, 0.05, "t = "),
    ):
        with pytest.raises(PrecisionError, match=message):
            one.enclose(t, digits, max_seconds=seconds)
    assert numbers(motion.enclose(10, 50, max_seconds=600))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"digits": 0}, "digits = 0"),
        ({"digits": 1.5}, "digits = 1.5"),
        ({"digits": True}, "digits = True"),
        ({"digits": "20"}, "digits = '20'"),
        ({"method": "jacobi"}, "method = 'jacobi': must be one of: theta, carlson"),
        ({"method": ["theta"]}, "method = "),
        ({"max_seconds": 0}, "max_seconds = 0: must be above zero"),
        ({"max_seconds": float("nan")}, "max_seconds = nan: must be finite"),
        ({"max_seconds": True}, "max_seconds = True: must be a number"),
        ({"t": float("nan")}, "t = nan"),
        ({"t": "1 +/- 0.1"}, "t = "),
        ({"t": arb(1, 0.1)}, "t = "),
    ],
)
def test_wrong_arguments_are_named(arguments, message):
    with pytest.raises(InputError, match=message):
        TorqueFreeMotion(*PAPER).enclose(**{"t": 1, **arguments})


@pytest.mark.parametrize("value", [arb.nan(), arb.pos_inf(), "nan", "1 +/- nan", "1 +/- -1", "+/-"])
def test_wrong_numbers_are_named(value):
    with pytest.raises(InputError, match=r"omega0\[1\] = "):
        TorqueFreeMotion(PAPER[0], (1, value, 0))
    with pytest.raises(InputError, match=r"attitude0 = .*must not be zero"):
        TorqueFreeMotion(*PAPER, (0, "0 +/- 1", 0, 0))


def test_digits_are_only_counted_when_certain():
    with working(100):
        assert is_within(arb(0, 0.99e-10), 10)
        assert not is_within(arb(0, 1.01e-10), 10)
        assert is_within(arb(1000, 1e-8), 10)
        assert not is_within(arb.nan(), 1)
        assert not has_digits(arb(0, 1e-100), 1)
        assert has_digits(arb(0), 50)
        assert not has_digits(arb(1, 1), 1)


def test_the_ball_of_an_uncertain_number_holds_its_ends():
    for bits, (middle, radius) in product((30, 53, 200), ((1, 3), (-7, 11), (10**9, 10**-9))):
        ends = [Fraction(middle, 7) + side * Fraction(radius) / 3 for side in (-1, 1)]
        with working(bits):
            value = ball(Uncertain(Fraction(middle, 7), Fraction(radius) / 3))
            assert all(value.contains(fmpq(x.numerator, x.denominator)) for x in ends)


def test_wide_arguments_are_held_or_refused():
    """J over a ball that reaches beyond K is no number, or holds all its values."""
    with working(100):
        for method, m, radius in product(METHODS, ("0.001", "0.1", "0.9"), (0.5, 1, 2, 4)):
            n, mc = arb("-0.01"), 1 - arb(m)
            for middle in ("0.75", "1.5", "3"):
                wide = METHODS[method]().elliptic_j(arb(middle, radius), n, mc)
                for part in (-0.99, 0.5, 0.99):
                    point = arb(middle) + arb(radius) * arb(part)
                    value = METHODS["carlson"]().elliptic_j(point, n, mc)
                    assert not wide.is_finite() or wide.contains(value)
