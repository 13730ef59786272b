"""Facts graded ENCLOSED: balls confirm or exclude them, at given and at drawn points."""

from dataclasses import replace
from itertools import product
from time import process_time

import mpmath
import pytest
from flint import acb, arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st
from ledgers import unchecked

from rigidsym.proof.algebra._enclosures import COUNT, encloses
from rigidsym.proof.checker import Refused, check
from rigidsym.proof.checker import _enclosures as enclosures
from rigidsym.proof.checker._enclosures import FUNCTIONS, PRECISION
from rigidsym.proof.kernel import Context, Fact, Grade, KernelError, replay

SQUARES = "1 - m*jacobi_sn(u, m)**2*jacobi_sn(v, m)**2"
# Names as they are read, and relations between them that hold.
READING = {
    "S": "jacobi_sn(u + v, m)",
    "s": "jacobi_sn(u, m)",
    "c": "jacobi_cn(u, m)",
    "d": "jacobi_dn(u, m)",
    "K": "elliptic_k(m)",
    "q": "nome(m)",
    "zeta": "pi*u/(2*K)",
    "x": "re(jacobi_sn(u + I*v, m))",
    "y": "im(jacobi_sn(u + I*v, m))",
    "prose": "a number, in rad",
    "word": "unknown",
    "loop": "1 + loop",
    "one": "other",
    "other": "one",
    "odd": "D(u)",
    "complex": "1 + I*u",
    "pole": "1/(u - u)",
}
NAMES = ("u", "v", "m", *READING)
CONTEXT = Context(
    "balls",
    NAMES,
    dict.fromkeys(NAMES, "1"),
    units=("m",),
    definitions={"half": "u/2"},
    nonnegative=("m",),
    reading=READING,
)
POINT = {"u": "9/10", "v": "-1/3", "m": "7/10"}


def enclosed(lhs: str, rhs: str, *points: dict[str, str], **fields) -> Fact:
    certificate = {"reference": "a book", "points": list(points or [POINT])}
    fact = Fact("f", "balls", "equal", (lhs,), (rhs,), "assumption", Grade.ENCLOSED)
    return replace(fact, certificate=certificate, **fields)


def refusal(fact: Fact, context: Context = CONTEXT) -> str:
    with pytest.raises(Refused) as caught:
        check(unchecked([context], [fact]))
    assert "\n" not in str(caught.value)
    return str(caught.value)


CONFIRMED = [
    ("s**2 + c**2", "1"),
    ("d**2 + m*s**2", "1"),
    ("2*half", "u"),
    ("S*(1 - m*s**2*t**2)", "s*b*e + t*c*d"),  # the addition theorem
    ("s*theta2_0*theta4_z", "theta3_0*theta1_z"),  # sn as a quotient of theta functions
]
ADDED = {
    "t": "jacobi_sn(v, m)",
    "b": "jacobi_cn(v, m)",
    "e": "jacobi_dn(v, m)",
    "theta1_z": "theta1(zeta, q)",
    "theta4_z": "theta4(zeta, q)",
    "theta2_0": "theta2(0, q)",
    "theta3_0": "theta3(0, q)",
}
WIDER = replace(
    CONTEXT,
    generators=(*NAMES, *ADDED),
    witness=dict.fromkeys((*NAMES, *ADDED), "1"),
    reading=READING | ADDED,
)
POINTS = [
    {"u": u, "v": v, "m": m}
    for u, v, m in product(["9/10", "-7/2", "11"], ["-1/3"], ["1/100", "7/10", "99/100"])
]


@pytest.mark.parametrize(("lhs", "rhs"), CONFIRMED)
def test_what_holds_is_confirmed(lhs, rhs):
    text = unchecked([WIDER], [enclosed(lhs, rhs, *POINTS)])
    assert check(text) == 1
    assert replay(text, lambda context, fact, points: True).facts["f"].grade == Grade.ENCLOSED


@pytest.mark.parametrize(("lhs", "rhs"), CONFIRMED)
def test_what_does_not_hold_is_excluded(lhs, rhs):
    nearly = f"{rhs} + 1/10**28"
    assert "do not confirm" in refusal(enclosed(lhs, nearly, *POINTS), WIDER)


def test_one_bad_point_is_enough():
    assert "7/10" in refusal(enclosed("m", "1/2", {"m": "1/2"}, {"m": "7/10"}))


# Each evaluates one formula, named f in its context, and compares it with g.
FORMULAS = [
    ("sqrt(16/9)", "4/3"),
    ("exp(I*pi)", "-1"),
    ("1/2**3", "1/8"),
    ("re(u + I*v) + im(u + I*v)", "u + v"),
    ("-u**2", "0 - u*u"),
    ("jacobi_sn(u + elliptic_k(m), m)", "jacobi_cn(u, m)/jacobi_dn(u, m)"),
    ("jacobi_dn(u + elliptic_k(m)*4, m)", "jacobi_dn(u, m)"),
    ("jacobi_sn(I*v, m)*jacobi_cn(v, 1 - m)", "I*jacobi_sn(v, 1 - m)"),
    ("jacobi_cn(I*v, m)*jacobi_cn(v, 1 - m)", "1"),
    ("jacobi_sn(elliptic_k(m) + I*v, m)*jacobi_dn(v, 1 - m)", "1"),
    ("jacobi_epsilon(elliptic_k(m), m)", "elliptic_e(m)"),
    ("jacobi_epsilon(u + 2*elliptic_k(m), m)", "jacobi_epsilon(u, m) + 2*elliptic_e(m)"),
    (
        "jacobi_epsilon(u + I*v, m) + jacobi_epsilon(u - I*v, m) - jacobi_epsilon(2*u, m)",
        "m*jacobi_sn(u + I*v, m)*jacobi_sn(u - I*v, m)*jacobi_sn(2*u, m)",
    ),
    ("elliptic_pi(n, pi/2, m)", "elliptic_pi(n, m)"),
    ("elliptic_pi(n, u + 3*pi, m)", "elliptic_pi(n, u, m) + 6*elliptic_pi(n, m)"),
    ("elliptic_pi(0, -pi/2, m)", "-elliptic_k(m)"),
    ("elliptic_pi(n, pi/2, -3)", "elliptic_pi(n, -3)"),
    ("elliptic_j(0, n, m)", "0"),
    ("elliptic_j(-u, n, m)", "-elliptic_j(u, n, m)"),
    ("m*elliptic_j(u, 0, m)", "u - jacobi_epsilon(u, m)"),
    ("elliptic_k(m) + n*elliptic_j(elliptic_k(m), n, m)", "elliptic_pi(n, m)"),
    ("elliptic_k(m)*2/pi", "theta3(0, nome(m))**2"),
    ("theta1(u + I*v + pi/2, q)", "theta2(u + I*v, q)"),
    ("theta4(u + I*v + pi/2, q)", "theta3(u + I*v, q)"),
    (
        "theta4(u + I*v, q)*theta3(u + I*v, q)",
        "theta4(2*u + 2*I*v, q**2)*theta4(0, q**2)",
    ),
    ("dtheta4(u + pi, q)", "dtheta4(u, q)"),
    ("dtheta4(0, q)", "0"),
    (
        "jacobi_epsilon(u, m) - u*elliptic_e(m)/elliptic_k(m)",
        "pi/2/elliptic_k(m)*dtheta4(zeta, q)/theta4(zeta, q)",
    ),
]


@pytest.mark.parametrize(("left", "right"), FORMULAS, ids=[left for left, _ in FORMULAS])
def test_formulas_that_are_known(left, right):
    texts = {
        f"{part}_{side}": f"{part}({text})"
        for side, text in (("f", left), ("g", right))
        for part in ("re", "im")
    }
    names = ("u", "v", "m", "n", *texts)
    reading = texts | {"q": "nome(m)", "zeta": "pi*u/(2*elliptic_k(m))"}
    context = Context("balls", names, dict.fromkeys(names, "1"), reading=reading)
    fact = replace(enclosed("", ""), lhs=("re_f", "im_f"), rhs=("re_g", "im_g"))
    points = [{**POINT, "n": n} for n in ("-3/2", "9/10")]
    fact = replace(fact, certificate={"reference": "DLMF", "points": points})
    assert check(unchecked([context], [fact])) == 1
    assert "confirm" in refusal(replace(fact, rhs=("re_g + 1/10**28", "im_g")), context)


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("prose", "no value"),
        ("word", "'unknown' has no value"),
        ("loop", "'loop' has no value"),
        ("one", "'one' has no value"),
        ("odd", "D of 1 is no function"),
        ("complex", "complex is not real"),
        ("pole", ""),
    ],
)
def test_readings_without_a_real_value(name, reason):
    assert reason in refusal(enclosed(f"2*{name}", f"{name} + {name}"))


@pytest.mark.parametrize(
    ("point", "reason"),
    [
        ({"u": "1"}, "'v' has no value"),
        ({**POINT, "v": "pi"}, "meaning"),
        ({**POINT, "v": "1/0"}, "division"),
        ({**POINT, "v": ""}, ""),
        ({**POINT, "half": "3"}, "half', which is no generator"),
        ({**POINT, "pi": "3"}, "pi', which is no generator"),
        ({**POINT, "m": "-7/10"}, "does not satisfy what is assumed of m"),
        ({**POINT, "m": "0"}, "does not satisfy what is assumed of m"),
    ],
    ids=str,
)
def test_points_that_are_none(point, reason):
    assert reason in refusal(enclosed("u + v + m", "m + u + v", point))


def test_a_point_must_satisfy_the_relations_between_the_names_it_gives():
    names = {"u": "1", "v": "1", "w": "1"}
    context = Context("balls", tuple(names), names, relations=("u - v", "v - w"))
    fact = enclosed("u*v", "v*u", {"u": "2", "v": "2"})
    assert check(unchecked([context], [fact])) == 1
    assert "assumed of u - v" in refusal(enclosed("u*v", "v*u", {"u": "2", "v": "3"}), context)


@pytest.mark.parametrize(
    "text",
    [
        "sqrt(-1)",
        "sqrt(I)",
        "sqrt(m - 1)",
        "sqrt(exp(u) - exp(u))",  # it may be negative, for all that the ball says
        *("elliptic_k(1)", "elliptic_k(I)", "elliptic_pi(1, m)", "elliptic_pi(2, u, m)"),
        *("elliptic_pi(0, I, m)", "elliptic_pi(0, 10**9, m)", "elliptic_j(I*v, 0, m)"),
        *("jacobi_sn(u, 1)", "jacobi_sn(u, 0)", "jacobi_sn(u, m + I)"),
        *("jacobi_sn(I*elliptic_k(1 - m), m)", "jacobi_dn(u - 2*I, m)", "jacobi_epsilon(2*I, m)"),
        *("theta1(u, 1)", "theta1(u, -m)", "theta5(u, m)", "nome(1)", "jacobi_sn(u)", "sqrt(u, v)"),
        *("sqrt()", "1/(m - m)*0", "u**v", "u**(1/2)", "u.real", "abs(u)", "1.5"),
    ],
)
def test_what_has_no_value(text):
    context = replace(CONTEXT, reading={"s": text})
    refusal(enclosed("s", "s"), context)


def test_what_is_known_too_coarsely_is_not_confirmed():
    for digits, confirmed in ((20, True), (60, False)):
        reading = {"s": f"exp(u) + 10**{digits} - 10**{digits}", "c": "exp(u)"}
        context = replace(CONTEXT, reading=reading)
        if confirmed:
            assert check(unchecked([context], [enclosed("s", "c")])) == 1
        else:
            assert "do not confirm" in refusal(enclosed("s", "c"), context)


def test_a_point_wins_over_a_reading_but_not_over_hypotheses():
    fact = enclosed("prose*u", "u*prose", {"u": "1", "prose": "2"})
    assert check(unchecked([CONTEXT], [fact])) == 1


@pytest.mark.parametrize("grade", [grade for grade in Grade if grade != Grade.ENCLOSED])
def test_the_grade_is_that_of_balls(grade):
    text = unchecked([CONTEXT], [replace(enclosed("s**2", "1 - c**2"), grade=grade)])
    with pytest.raises(Refused, match="has earned ENCLOSED"):
        check(text)
    with pytest.raises(KernelError, match="has earned ENCLOSED"):
        replay(text, lambda context, fact, points: True)


@pytest.mark.parametrize(
    "certificate",
    [
        {"reference": "a book", "points": []},
        {"reference": "a book"},
        {"reference": "", "points": [POINT]},
        {"points": [POINT]},
    ],
    ids=str,
)
def test_no_points_no_reference_no_enclosure(certificate):
    text = unchecked([CONTEXT], [replace(enclosed("m", "m"), certificate=certificate)])
    with pytest.raises(Refused):
        check(text)
    with pytest.raises(KernelError):
        replay(text, lambda context, fact, points: True)


@pytest.mark.parametrize("points", [{"m": "1"}, "m", [["m"]], [{"m": 1}], [None], 1], ids=str)
def test_points_have_a_shape(points):
    certificate = {"reference": "a book", "points": points}
    refusal(replace(enclosed("m", "m"), certificate=certificate))


@pytest.mark.parametrize("kind", ["root", "nonnegative", "unequal", "model"])
def test_only_equations_are_enclosed(kind):
    text = unchecked([CONTEXT], [replace(enclosed("m", "m"), kind=kind)])
    with pytest.raises(Refused):
        check(text)
    with pytest.raises(KernelError):
        replay(text, lambda context, fact, points: True)


def test_the_kernel_asks_for_balls():
    """The kernel refuses ENCLOSED without balls that agree, and passes them all points."""
    text, asked = unchecked([CONTEXT], [enclosed("s**2", "1 - c**2")]), []
    for balls in (None, lambda context, fact, points: False):
        with pytest.raises(KernelError, match="balls"):
            replay(text, balls)
    replay(text, lambda *question: asked.append(question) is None)
    ((context, fact, points),) = asked
    assert (context.name, fact.id, points) == ("balls", "f", [POINT])


def test_the_square_of_a_name_is_not_minus_one():
    """A square that is -1 would prove a false sign by way of a model."""
    names = {"z": "1"}
    context = Context("balls", ("z",), names, reading={"z": "I"})
    assert "z is not real" in refusal(enclosed("z**2", "-1", {}), context)


def test_the_precision_of_others_is_left_alone():
    before = ctx.prec
    check(unchecked([CONTEXT], [enclosed("s**2", "1 - c**2")]))
    refusal(enclosed("s", "c"))
    assert ctx.prec == before


def test_ten_points_take_no_time():
    lhs, rhs = ("2*s", "2*c", "2*S", "2*x"), ("s + s", "c + c", "S + S", "x + x")
    fact = replace(enclosed("", "", *POINTS, POINT), lhs=lhs, rhs=rhs)
    text = unchecked([CONTEXT], [fact])
    start = process_time()
    assert check(text) == 1
    assert process_time() - start < 1  # some 0.02 s


def ball(number: fmpq) -> acb:
    return acb(arb(number))


def exact(number: fmpq) -> mpmath.mpf:
    return mpmath.mpf(int(number.p)) / int(number.q)


def holds(value: acb, number) -> bool:
    number = mpmath.mpmathify(number)
    real, imag = (mpmath.nstr(part, 40) for part in (number.real, number.imag))
    gap = value - acb(arb(f"{real} +/- 1e-33"), arb(f"{imag} +/- 1e-33"))
    return gap.contains(0)


fractions = st.builds(lambda p, q: fmpq(p, q), st.integers(-400, 400), st.integers(60, 99))
inner = st.builds(lambda p: fmpq(p, 100), st.integers(1, 99))
fixed = settings(max_examples=40, deadline=None, derandomize=True, database=None)


@fixed
@given(fractions, inner, inner)
def test_jacobi_functions_agree_with_another_library(u, height, m):
    with ctx.workprec(PRECISION), mpmath.workdps(45):
        v = fmpq(int(exact(height) * mpmath.ellipk(1 - exact(m)) * 100), 101)
        z, at = ball(u) + acb(0, 1) * ball(v), mpmath.mpc(exact(u), exact(v))
        for name in ("sn", "cn", "dn"):
            value = FUNCTIONS[f"jacobi_{name}", 2](z, ball(m))
            assert holds(value, mpmath.ellipfun(name, at, m=exact(m)))


@fixed
@given(fractions, fractions, inner)
def test_theta_functions_agree_with_another_library(x, y, q):
    with ctx.workprec(PRECISION), mpmath.workdps(45):
        y, q = y / 16, q * 9 / 10
        z, at = ball(x) + acb(0, 1) * ball(y), mpmath.mpc(exact(x), exact(y))
        for k in (1, 2, 3, 4):
            value = FUNCTIONS[f"theta{k}", 2](z, ball(q))
            assert holds(value, mpmath.jtheta(k, at, exact(q)))
        for k in (2, 4):
            value = FUNCTIONS[f"dtheta{k}", 2](ball(x), ball(q))
            assert holds(value, mpmath.jtheta(k, exact(x), exact(q), 1))


@settings(fixed, max_examples=15)
@given(fractions, fractions, inner)
def test_legendre_integrals_agree_with_another_library(n, phi, m):
    with ctx.workprec(PRECISION), mpmath.workdps(45):
        n = 1 - n * n - fmpq(1, 9)
        value = FUNCTIONS["elliptic_pi", 3](ball(n), ball(phi), ball(m))
        assert holds(value, mpmath.ellippi(exact(n), exact(phi), exact(m)))


# Drawn points: each claim here holds at all points that its author gives.

DRAWN_NAMES = ("k_1", "rho", "a", "b", "K", "x", "n", "s")
PLACE = Context(
    "place",
    DRAWN_NAMES,
    dict.fromkeys(DRAWN_NAMES, "1") | {"a": "3", "b": "4", "K": "5"},
    units=("K",),
    relations=("rho**2 - 1", "K**2 - a**2 - b**2"),
    nonnegative=("K",),
    reading={"s": "sqrt(x**2)", "n": "a whole number"},
)
AUTHORS = {
    "k_1": ["1/100", "2/5", "9/10"],
    "rho": ["1", "1", "1"],
    "a": ["3", "-3", "24"],
    "b": ["4", "4", "7"],
    "K": ["5", "5", "25"],
    "x": ["1", "2", "7"],
    "n": ["1", "2", "3"],
}


def supposed(lhs, rhs, free, **certificate):
    """Return a cited equation with its author's points for some names."""
    points = [{name: AUTHORS[name][k] for name in free.split()} for k in range(3)]
    certificate |= {"reference": "a book", "points": points}
    fact = Fact("f", "place", "equal", (lhs,), (rhs,), "assumption", Grade.ENCLOSED)
    return replace(fact, certificate=certificate)


def by_the_kernel(fact, context=PLACE):
    return replay(unchecked([context], [fact]), encloses)


def by_the_other(fact, context=PLACE):
    return check(unchecked([context], [fact]))


BOTH = pytest.mark.parametrize("decide", [by_the_kernel, by_the_other])
FALSE = [
    ("(k_1 - 1/100)*(k_1 - 2/5)*(k_1 - 9/10)", "0", "k_1"),
    ("jacobi_sn(x, k_1)*(k_1 - 1/100)*(k_1 - 2/5)*(k_1 - 9/10)", "0", "x k_1"),
    ("k_1", "k_1 + (100*k_1 - 1)*(5*k_1 - 2)*(10*k_1 - 9)/10**12", "k_1"),
    ("(K - 5)*(K - 25)", "0", "a b K"),
    ("(b - 4)*(b - 7)", "0", "a b K"),
    ("rho", "1", "rho"),
    ("s", "x", "x"),
    ("(x - 1)*(x - 2)*(x - 7)*k_1", "0", "x k_1"),
]
TRUE = [
    ("K**2", "a**2 + b**2", "a b K"),
    ("(K - b)*(K + b)", "a*a", "a b K"),
    ("rho**3", "rho", "rho"),
    ("s**2", "x*x", "x"),
    ("rho*(k_1 - 1)*(k_1 + 1)", "rho*k_1**2 - rho", "rho k_1"),
]


def functions(fact):
    """Replace a function in a fact by a name that is read as it; return fact and context."""
    text = "jacobi_sn(x, k_1)"
    names = (*DRAWN_NAMES, "y")
    reading = {**PLACE.reading, "y": text}
    wider = replace(PLACE, generators=names, witness={**PLACE.witness, "y": "1"}, reading=reading)
    return replace(fact, lhs=tuple(side.replace(text, "y") for side in fact.lhs)), wider


@BOTH
@pytest.mark.parametrize(("lhs", "rhs", "free"), FALSE)
def test_what_holds_where_its_author_looks_is_refused(decide, lhs, rhs, free):
    with pytest.raises((KernelError, Refused), match="balls"):
        decide(*functions(supposed(lhs, rhs, free)))


@BOTH
@pytest.mark.parametrize(("lhs", "rhs", "free"), TRUE)
def test_what_holds_everywhere_is_enclosed(decide, lhs, rhs, free):
    assert decide(supposed(lhs, rhs, free))


@BOTH
def test_a_hypothesis_is_where_to_look(decide):
    """The equation holds only for x >= 0, which the context assumes."""
    signed = replace(PLACE, nonnegative=("K", "x"))
    assert decide(supposed("2*s", "s + x", "x"), signed)


@BOTH
def test_whole_numbers_are_said_to_be_whole(decide):
    period = replace(PLACE, reading={"s": "re(exp(2*pi*I*n))"})
    claim = supposed("s", "n/n", "n", whole=["n"])
    period = replace(period, units=("K", "n"))
    assert decide(claim, period)
    with pytest.raises((KernelError, Refused), match="balls"):
        decide(supposed("s", "n/n", "n"), period)
    with pytest.raises((KernelError, Refused), match="balls"):
        decide(supposed("(n - 1)*(n - 2)*(n - 3)", "0", "n", whole=["n"]), period)


@BOTH
def test_a_claim_has_to_say_something_at_enough_points(decide):
    """Points where a function has no value are no evidence."""
    nowhere = replace(PLACE, reading={"s": "jacobi_sn(1, 1 + x**2)"})
    with pytest.raises((KernelError, Refused)):
        decide(supposed("2*s", "s + s", "x"), nowhere)
    rare = replace(PLACE, nonnegative=("K", "-x"), units=("K", "x"))
    few = replace(rare, relations=(*PLACE.relations, "x**2 - 1"))
    with pytest.raises((KernelError, Refused)):
        decide(supposed("2*s", "s - x", "x"), few)


def test_both_ask_for_forty():
    assert min(COUNT, enclosures.DUE) >= 40


@pytest.mark.parametrize("whole", [1, ["n", 1], {"n": "1"}])
def test_whole_names_are_a_list_of_names(whole):
    with pytest.raises(Refused):
        by_the_other(supposed("2*n", "n + n", "n", whole=whole))
