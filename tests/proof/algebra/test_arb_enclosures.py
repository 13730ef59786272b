"""The kernel's balls: values against mpmath, and expressions without a value."""

from contextlib import suppress
from fractions import Fraction
from random import Random

import flint
import pytest
from mpmath import mp, workdps

from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._enclosures import BITS, FUNCTIONS, Evaluation, encloses, rational
from rigidsym.proof.algebra._enclosures import agrees as agrees_there
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, replay


def context(reading=None, definitions=None):
    return Context("c", ("x", "y"), {}, definitions=definitions or {}, reading=reading or {})


def ball(text, point=None, **named):
    with flint.ctx.workprec(BITS):
        given = context(**named)
        return Evaluation(given, rational(given, point or {})).value(text)


def agrees(lhs, rhs, *points, **named):
    """Return whether balls agree with an equation at some points."""
    fact = Fact("c.f", "c", "equal", (lhs,), (rhs,), "assumption")
    return all(agree_at(context(**named), fact, point) for point in points)


def agree_at(given, fact, point):
    with flint.ctx.workprec(BITS):
        return agrees_there(Evaluation(given, rational(given, point)), fact)


def incomplete_pi(n, phi, m):
    half_turns = int(mp.nint(phi / mp.pi))
    return 2 * half_turns * mp.ellippi(n, m) + mp.ellippi(n, phi - half_turns * mp.pi, m)


def associate(u, n, m):
    """Return J at a real u, computed from Pi at the amplitude of u."""
    half_turns = int(mp.nint(u / (2 * mp.ellipk(m))))
    sine = (-1) ** half_turns * mp.ellipfun("sn", u, m=m)
    return (incomplete_pi(n, half_turns * mp.pi + mp.asin(sine), m) - u) / n


def epsilon(u, m):
    half_turns = int(mp.nint(mp.re(u) / (2 * mp.ellipk(m))))
    rest = u - 2 * half_turns * mp.ellipk(m)
    return 2 * half_turns * mp.ellipe(m) + mp.ellipe(mp.asin(mp.ellipfun("sn", rest, m=m)), m)


# By the kinds of the arguments: m in (0, 1), n < 1, u and w over several periods; w and z may be
# complex, w nearer to the real line than the poles.
RANGES = {"m": (20, 950), "n": (-5000, 900), "u": (-9000, 9000), "w": (-6000, 6000)}
EXPECTED = {
    "re": ("z", mp.re),
    "im": ("z", mp.im),
    "sqrt": ("z", mp.sqrt),
    "exp": ("z", mp.exp),
    "arcsc": ("xm", lambda x, m: mp.ellipf(mp.atan(x), m)),
    "nome": ("m", lambda m: mp.exp(-mp.pi * mp.ellipk(1 - m) / mp.ellipk(m))),
    "elliptic_k": ("m", mp.ellipk),
    "elliptic_e": ("m", mp.ellipe),
    "elliptic_pi": ("nm", mp.ellippi),
    "elliptic_j": ("unm", associate),
    "jacobi_sn": ("wm", lambda u, m: mp.ellipfun("sn", u, m=m)),
    "jacobi_cn": ("wm", lambda u, m: mp.ellipfun("cn", u, m=m)),
    "jacobi_dn": ("wm", lambda u, m: mp.ellipfun("dn", u, m=m)),
    "jacobi_epsilon": ("wm", epsilon),
    "theta1": ("zm", lambda z, q: mp.jtheta(1, z, q)),
    "theta2": ("zm", lambda z, q: mp.jtheta(2, z, q)),
    "theta3": ("zm", lambda z, q: mp.jtheta(3, z, q)),
    "theta4": ("zm", lambda z, q: mp.jtheta(4, z, q)),
    "dtheta2": ("zm", lambda z, q: mp.jtheta(2, z, q, 1)),
    "dtheta4": ("zm", lambda z, q: mp.jtheta(4, z, q, 1)),
}


def argument(kind, random):
    """Draw a number and return it as a text and for mpmath."""
    real, aside = random.randint(*RANGES.get(kind, (-2000, 2000))), random.randint(-600, 600)
    if kind not in "zw":
        return f"{real}/1000", mp.mpf(real) / 1000
    return f"({real} + I*({aside}))/1000", mp.mpc(real, aside) / 1000


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_has_the_value_that_mpmath_gives(name):
    random = Random(name)
    kinds, expected = EXPECTED[name]
    with workdps(50):
        for _ in range(10):
            texts, values = zip(*(argument(kind, random) for kind in kinds), strict=True)
            found, right = ball(f"{name}({', '.join(texts)})"), mp.mpc(expected(*values))
            for part, exact in ((found.real, right.real), (found.imag, right.imag)):
                assert part.rad() < 1e-40
                near = mp.mpf(part.mid().str(50, radius=False))
                assert abs(near - exact) < 1e-40 * (1 + abs(right))


def test_pi_at_an_angle_winds():
    with workdps(40):
        for angle in (-11, -4, 2, 5, 20):
            found = ball(f"elliptic_pi(-3, {angle}, 1/2)").real
            right = incomplete_pi(-3, mp.mpf(angle), mp.mpf("0.5"))
            assert abs(mp.mpf(found.mid().str(40, radius=False)) - right) < 1e-35


@pytest.mark.parametrize("periods", [-2, 2, 4, 6])
def test_the_amplitude_at_whole_half_periods_is_whole_half_turns(periods):
    assert abs(ball(f"jacobi_sn({periods}*elliptic_k(1/3), 1/3)")) < 1e-50
    sign = (-1) ** (periods // 2)
    assert abs(ball(f"jacobi_cn({periods}*elliptic_k(1/3), 1/3)") - sign) < 1e-50


@pytest.mark.parametrize("quarters", [-5, -3, -1, 1, 3, 7])
def test_at_odd_quarter_periods_the_ball_is_right_if_there_is_one(quarters):
    with suppress(KernelError):
        value = ball(f"jacobi_sn({quarters}*elliptic_k(1/2), 1/2)")
        assert value.contains(1 if quarters % 4 == 1 else -1)
        assert value.rad() < 1e-40


@pytest.mark.parametrize("shift", ["-1/1000", "1/1000"])
def test_beside_an_odd_quarter_period_there_is_a_value(shift):
    near = ball(f"jacobi_sn(3*elliptic_k(1/2) + {shift}, 1/2)")
    assert abs(near + 1) < 1e-6


@pytest.mark.parametrize("u", ["3*I", "2 + 5*I", "-7*I"])
def test_an_argument_past_the_poles_is_refused(u):
    with pytest.raises(KernelError, match="is not enclosed"):
        ball(f"jacobi_sn({u}, 1/2)")


@pytest.mark.parametrize(
    "text",
    [
        *("moment of inertia, kg m^2", "the sign of Omega_a", "unknown", "D(x)", "cos(x)", "sqrt"),
        *("x.real", "x[0]", "1.5", "'x'", "x**y", "x**-1", "x**1.5", "x//2", "x < 1"),
        *("x if x else 1", "lambda: 1", "__import__('os')", "(x, x)", ""),
    ],
)
def test_what_is_no_expression_of_known_names_has_no_value(text):
    with pytest.raises(KernelError, match="has no value"):
        ball(text, {"x": "2"})


@pytest.mark.parametrize(
    "reading",
    [{"y": "y + 1"}, {"y": "a", "a": "b", "b": "y"}, {"y": "sqrt(y)"}, {"y": "mass, kg"}],
)
def test_prose_and_what_refers_to_itself_have_no_value(reading):
    with pytest.raises(KernelError, match="has no value"):
        ball("x + y", {"x": "2"}, reading=reading)


def test_a_definition_comes_before_a_reading():
    named = {"reading": {"y": "2*x", "z": "5"}, "definitions": {"z": "y + 1"}}
    assert ball("z", {"x": "3"}, **named) == 7


@pytest.mark.parametrize("name", ["y", "z", "pi", "unknown"])
def test_a_point_gives_free_generators_only(name):
    named = {"reading": {"x": "a length, m", "y": "2*x"}, "definitions": {"z": "y + 1"}}
    with pytest.raises(KernelError, match=f"a point gives '{name}', which is not free"):
        ball("x", {"x": "3", name: "0"}, **named)


@pytest.mark.parametrize(
    ("equation", "point"),
    [
        (("K", "K"), {"K": "5", "x": "4"}),
        (("rho*K", "7*K"), {"rho": "7", "K": "5"}),
        (("x", "0"), {"x": "0"}),
    ],
)
def test_a_point_has_to_be_one_of_the_context(equation, point):
    relations = ("K**2 - x**2 - 16", "rho**2 - 1")
    part = Part(witness={"K": "5", "x": "3", "rho": "1"}, units=("x",), relations=relations)
    fact = Fact("c.f", "c", "equal", *((side,) for side in equation), "assumption")
    with pytest.raises(KernelError, match="not one of the context"):
        agree_at(join("c", part), fact, {"x": "3"} | point if "K" in point else point)


@pytest.mark.parametrize("text", ["sqrt(4, foo=3)", "sqrt(1, 2)", "True", "sqrt()", "exp()"])
def test_calls_are_strict(text):
    with pytest.raises(KernelError, match="has no value"):
        ball(text)


@pytest.mark.parametrize(
    ("number", "value"), [("-3/7", "-3/7"), ("-2", "-2"), ("3/8", "3/8"), ("1/10**2", "1/100")]
)
def test_numbers_of_a_point_are_exact(number, value):
    assert (ball("x", {"x": number}) * Fraction(value).denominator).contains(
        Fraction(value).numerator
    )
    assert agrees("x", value, {"x": number})


@pytest.mark.parametrize("number", ["one", None, -2, 0.375, "0.375", "1e-2", "1_0", "1/0", ""])
def test_what_is_no_number_of_the_language_is_refused(number):
    with pytest.raises(KernelError):
        ball("x", {"x": number})


TRUE = [
    ("jacobi_sn(x, y)**2 + jacobi_cn(x, y)**2", "1"),
    ("jacobi_dn(x, y)**2 + y*jacobi_sn(x, y)**2", "1"),
    ("theta3(0, nome(y))**4", "theta2(0, nome(y))**4 + theta4(0, nome(y))**4"),
    (
        "elliptic_e(y)*elliptic_k(1 - y) + elliptic_e(1 - y)*elliptic_k(y)",
        "pi/2 + elliptic_k(y)*elliptic_k(1 - y)",
    ),
    ("theta4(x + I*y, y)", "theta3(x + I*y + pi/2, y)"),
]
POINTS = [{"x": "7/5", "y": "1/3"}, {"x": "-4", "y": "9/10"}]


@pytest.mark.parametrize(("lhs", "rhs"), TRUE)
def test_true_identities_are_agreed_with(lhs, rhs):
    assert agrees(lhs, rhs, *POINTS)


@pytest.mark.parametrize(("lhs", "rhs"), TRUE)
@pytest.mark.parametrize("change", ["+ 1", "+ 1/10**30", "+ I/10**30", "*(1 + 1/2**150)"])
def test_nearly_true_ones_are_not(lhs, rhs, change):
    assert not agrees(lhs, f"({rhs}){change}", *POINTS)


def test_one_point_where_it_fails_is_enough():
    assert agrees("x**2", "x", {"x": "1"}, {"x": "0"})
    assert not agrees("x**2", "x", {"x": "1"}, {"x": "0"}, {"x": "2"})


@pytest.mark.parametrize("text", ["1/0", "elliptic_pi(2, 1, 1/2)", "1/(x - x)"])
def test_a_ball_without_bound_agrees_with_nothing(text):
    assert not agrees(text, text, {"x": "1"})


@pytest.mark.parametrize("m", ["0", "1", "-1/2", "3/2", "I/2"])
@pytest.mark.parametrize("text", ["nome({})", "jacobi_sn(x, {})", "arcsc(x, {})"])
def test_a_parameter_is_between_0_and_1(text, m):
    with pytest.raises(KernelError, match="not between 0 and 1"):
        ball(text.format(m), {"x": "1"})


def test_a_wide_ball_is_no_evidence():
    assert agrees("sqrt(x) - sqrt(x)", "0", {"x": "2"})
    assert not agrees("10**25*(sqrt(x) - sqrt(x))", "0", {"x": "2"})


def test_components_are_all_looked_at():
    fact = Fact("c.f", "c", "equal", ("x", "x"), ("x", "x + 1"), "assumption")
    assert not agree_at(context(), fact, {"x": "1"})


@pytest.mark.parametrize("text", ["x", "unknown", "1/0", "jacobi_sn(3*I, 1/2)", "sqrt()"])
def test_the_precision_is_given_back(text):
    with flint.ctx.workprec(77):
        try:
            agrees(text, text, {"x": "1"})
        except (KernelError, TypeError):
            assert text != "x"
        assert flint.ctx.prec == 77


def test_an_assumption_is_graded_by_its_points_and_replays_with_the_same_balls():
    builder = LedgerBuilder()
    part = Part(witness={"u": "0", "s": "0"}, reading={"s": "jacobi_sn(u, 1/2)"})
    builder.open(join("c", part, static=True))
    points = [{"u": "3/2"}]
    right = "2*s*jacobi_cn(u, 1/2)"
    with pytest.raises(KernelError):
        builder.assume("c.function", {"s": right}, "nobody", points)
    with pytest.raises(KernelError, match="agree"):
        builder.assume("c.wrong", {"s": "u"}, "nobody", points)
    with pytest.raises(KernelError, match="reference"):
        builder.assume("c.orphan", {"s**2": "s*s"}, "", points)
    assert builder.assume("c.bare", {"s": "u"}, "somebody", []).grade == Grade.ASSUMED
    assert builder.assume("c.same", {"s**2": "s*s"}, "anybody", points).grade == Grade.ENCLOSED
    sealed = builder.ledger.to_text()
    assert replay(sealed, encloses).to_text() == sealed
    with pytest.raises(KernelError):
        replay(sealed)
