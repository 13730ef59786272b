"""The double-double arithmetic of modules, against exact arithmetic.

Sums and products of two doubles are exact to the last bit: on drawn and extreme doubles, and, by
the very same text, on all numbers of small precisions.  Of pairs, u = 2^-53, relative errors are
below the bounds that the modules state: 3 u^2 for sums (2 u^2 of a pair and a double), 5 u^2 for
products (3 u^2), 15 u^2 for quotients (3 u^2), 25/8 u^2 for roots.
"""

import ctypes
import inspect
import math
import operator
import random
from fractions import Fraction
from functools import partial
from itertools import product

import numpy as np
import pytest
from compilers import PLAIN, X86, needed

from rigidsym.generated import torque_free_step as double_double
from rigidsym.generated.torque_free_step import _DoubleDouble

U2 = Fraction(1, 2**106)
# An operation on x and y, and its relative error in units of u^2; of `_xd`, y is a double.
EXACT = {
    "add_xx": (operator.add, 3),
    "add_xd": (operator.add, 2),
    "sub_xx": (operator.sub, 3),
    "mul_xx": (operator.mul, 5),
    "mul_xd": (operator.mul, 3),
    "div_xx": (operator.truediv, 15),
    "div_xd": (operator.truediv, 3),
    "root": (lambda x, _: double_double._sqrt(x), Fraction(25, 8)),
    "sum": (operator.add, 0),
    "quick_sum": (operator.add, 0),
    "product": (operator.mul, 0),
}
NAMES = list(EXACT)  # numbered as in pairs.c
DRAWN = 2000


def significand(draw):
    """Return 53 bits in [1, 2): any, few of them set, or few of them not."""
    bits = draw.choice(
        [
            draw.getrandbits(52),
            sum(1 << draw.randrange(52) for _ in range(draw.randrange(4))) % 2**52,
            (2**52 - 1) ^ (1 << draw.randrange(52)) >> draw.randrange(2),
        ]
    )
    return draw.choice((1, -1)) * (1 + bits * 2.0**-52)


def pair(draw, reach=60):
    """Return hi and lo, |lo| <= ulp(hi)/2, to the very half where hi is even."""
    hi = math.ldexp(significand(draw), draw.randint(-reach, reach))
    half = math.ulp(hi) / 2
    lo = draw.choice([0.0, half, -half, half * 2.0**-40, draw.uniform(-half, half)])
    lo = lo if hi + lo == hi else lo * (1 - 2.0**-53)
    return (hi, lo) if hi + lo == hi else (hi, 0.0)


def drawn(seed=1):
    """Return rows of two pairs: of any sizes, and of sizes where sums cancel."""
    draw = random.Random(seed)
    rows = []
    for _ in range(DRAWN):
        x, y = pair(draw), pair(draw)
        near = (
            math.nextafter(-x[0], draw.choice((0.0, math.inf))),
            x[1] * draw.choice((1, -1, 0.5)),
        )
        rows.append((*x, *draw.choice((y, near if near[0] + near[1] == near[0] else y))))
    return rows


def extremes(least, most):
    """Return doubles at the ends of binades between two exponents, and zero."""
    found = [0.0]
    for e in sorted({least, least + 1, least + 52, -54, -53, -1, 0, 1, 52, 53, 54, most - 1, most}):
        x = math.ldexp(1.0, e)
        found += [x, math.nextafter(x, math.inf), math.nextafter(2 * x, 0.0), 1.5 * x]
    return [sign * x for x in found for sign in (1, -1)]


def rows_of(xs):
    return [(x, 0.0, y, 0.0) for x, y in product(xs, repeat=2)]


SUMS = rows_of(extremes(-1074, 1022))
# Errors of products have digits below those of products: 2^-1074 bounds them from below.
PRODUCTS = [row for row in rows_of(extremes(-480, 500)) if abs(row[0] * row[2]) < 2.0**1000]


class InPython:
    """The NumPy module's arithmetic: of arrays, or of Python's floats one by one."""

    def __init__(self, whole):
        self.whole = whole

    def _run(self, function, rows):
        if not self.whole:
            return [function(*map(float, row)) for row in rows]
        with np.errstate(all="ignore"):
            return np.transpose(function(*np.array(rows).T)).tolist()

    def pairs(self, name, rows):
        def found(a, b, c, d):
            if name == "sum":
                z = double_double._two_sum(a, c)
            elif name == "product":
                z = double_double._two_product(a, c)
            else:
                y = c if name.endswith("_xd") else _DoubleDouble(c, d)
                z = EXACT[name][0](_DoubleDouble(a, b), y)
            return z.hi, z.lo

        return self._run(found, rows)

    def exponents(self, values):
        return self._run(lambda x: double_double._exponent(_DoubleDouble(x)), [[x] for x in values])

    def nearest(self, values):
        return self._run(double_double._nearest, [[x] for x in values])

    def alternating(self, values):
        return [float(double_double._alternating(x)) for x in values]


class InC:
    """The C source's arithmetic, in one build."""

    def __init__(self, library):
        self._c = ctypes.CDLL(str(library))

    def _run(self, function, rows, width, *first):
        given = np.ascontiguousarray(rows, float)
        out = np.empty((len(given), width))
        pointers = (x.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for x in (given, out))
        function(*first, ctypes.c_size_t(len(given)), *pointers)
        return out.tolist()

    def pairs(self, name, rows):
        return self._run(self._c.pairs, rows, 2, NAMES.index(name))

    def parts(self, rows):
        return self._run(self._c.exact_parts, rows, 32)

    def doubles(self, which, values):
        return [value for (value,) in self._run(self._c.doubles, values, 1, which)]

    def nearest(self, values):
        return self.doubles(0, values)

    def alternating(self, values):
        return self.doubles(1, values)

    def exponents(self, values):
        return self.doubles(3, values)


MACHINES = ["arrays", "floats", "native", *(["x86-64"] if X86 else [])]


@pytest.fixture(scope="module", params=MACHINES)
def machine(request, here):
    """Return NumPy's arrays, Python's floats, and C with and without fused multiply-add."""
    if request.param in ("arrays", "floats"):
        return InPython(request.param == "arrays")
    gcc = needed("gcc")
    flags = (*PLAIN, "-ffp-contract=off", *gcc.machine(request.param))
    return InC(gcc.linked(here, *flags, sources=("pairs.c",), end=".so"))


def check_all(name, rows, machine):
    """Check all results of an operation."""
    for row, found in zip(rows, machine.pairs(name, rows), strict=True):
        check(name, row, found)


def check(name, row, found):
    """Check the relative error of a result, and that its halves do not overlap."""
    compute, bound = EXACT[name]
    a, b, c, d = map(Fraction, row)
    hi, lo = found
    value = Fraction(hi) + Fraction(lo)
    assert hi + lo == hi, (name, row, found)
    if name == "root":
        # |s - sqrt(x)| <= e sqrt(x) for 0 < e < 1 is (1 - e)^2 x <= s^2 <= (1 + e)^2 x.
        error = bound * U2
        assert value >= 0
        assert (1 - error) ** 2 * (a + b) <= value**2 <= (1 + error) ** 2 * (a + b), (row, found)
        return
    single = name.endswith("_xd") or bound == 0
    x, y = (a if bound == 0 else a + b), (c if single else c + d)
    exact = compute(x, y)
    assert abs(value - exact) <= bound * U2 * abs(exact), (name, row, found)


@pytest.mark.parametrize("name", [name for name in NAMES if EXACT[name][1]])
def test_errors_of_pairs_are_below_their_bounds(machine, name):
    rows = drawn()
    if name == "root":
        rows = [row if row[0] > 0 else (-row[0], -row[1], *row[2:]) for row in rows]
    check_all(name, rows, machine)


@pytest.mark.parametrize(("name", "rows"), [("sum", SUMS), ("product", PRODUCTS)])
def test_sums_and_products_of_doubles_are_exact(machine, name, rows):
    rows = rows + drawn(seed=2)
    check_all(name, rows, machine)


def test_quick_sums_are_exact_where_the_first_is_the_larger(machine):
    if isinstance(machine, InPython):
        pytest.skip("NumPy's operations have them in their lines")
    rows = [row if abs(row[0]) >= abs(row[2]) else (*row[2:], *row[:2]) for row in SUMS + drawn(3)]
    check_all("quick_sum", rows, machine)


SPOILT = {
    "sum": ("_two_sum", "a - (s - c) + (b - c)", "a - s + b"),
    "add_xx": ("_dd_add_xx", "x.hi - (s_s - s_c) + (y.hi - s_c)", "x.hi - s_s + y.hi"),
    "sub_xx": ("_dd_add_xx", "x.hi - (s_s - s_c) + (y.hi - s_c)", "x.hi - s_s + y.hi"),
    "product": ("_two_product", "r_lo_error += r_lo_a2 * r_lo_b2", "pass"),
    "mul_xx": ("_dd_mul_xx", "p_r_lo_error += p_r_lo_a2 * p_r_lo_b1", "pass"),
    "mul_xd": ("_dd_mul_xd", "p_r_lo_error += p_r_lo_a1 * p_r_lo_b2", "pass"),
    "div_xx": ("_dd_div_xx", "r_p_r_lo_error += r_p_r_lo_a2 * r_p_r_lo_b1", "pass"),
    "root": ("_dd_sqrt", "r_r_lo_error += r_r_lo_a2 * r_r_lo_b1", "pass"),
}


@pytest.mark.parametrize("name", SPOILT)
def test_an_operation_that_is_not_exact_is_seen(monkeypatch, name):
    function, old, new = SPOILT[name]
    source = inspect.getsource(getattr(double_double, function))
    assert source.count(old) == 1
    made = dict(vars(double_double))
    exec(source.replace(old, new), made)
    monkeypatch.setattr(double_double, function, made[function])
    rows = [(abs(a), b if a > 0 else -b, c, d) for a, b, c, d in drawn(7)]
    with pytest.raises(AssertionError):
        check_all(name, rows, InPython(True))


def test_the_root_of_zero_is_zero(machine):
    assert [tuple(x) for x in machine.pairs("root", [(0.0, 0.0, 1.0, 0.0)])] == [(0.0, 0.0)]


def test_whole_numbers_and_exponents(machine):
    draw = random.Random(4)
    values = [draw.uniform(-1, 1) * 2.0 ** draw.randrange(51) for _ in range(DRAWN)]
    values += [k / 2 for k in range(-9, 10)] + [2.0**51 - 1, 2.0**51 - 0.5, -(2.0**51) + 1.5]
    nearest = machine.nearest(values)
    assert nearest == [float(round(Fraction(x))) for x in values]
    whole = [x for x in nearest if abs(x) < 2.0**51]
    assert machine.alternating(whole) == [(-1.0) ** (int(x) % 2) for x in whole]
    positive = [x for x in extremes(-1000, 1000) if x > 0]
    for x, e in zip(positive, machine.exponents(positive), strict=True):
        assert Fraction(1, 2) <= (Fraction(x) / Fraction(2) ** int(e)) ** 2 * (1 + U2) <= 2 + 1e-15


def test_powers_of_two_in_c(machine):
    if isinstance(machine, InPython):
        pytest.skip("NumPy brings its own exponential")
    numbers = [float(n) for n in range(-1022, 1024)]
    assert machine.doubles(2, numbers) == [math.ldexp(1.0, int(n)) for n in numbers]


def test_exact_numbers_in_c_are_exact(machine):
    if isinstance(machine, InPython):
        pytest.skip("Python has its own integers")
    draw = random.Random(5)
    rows = [
        [math.ldexp(significand(draw), draw.randint(-60, 60)) for _ in range(4)]
        for _ in range(DRAWN)
    ]
    rows += [[1.0, 1.0, 3.0, 5.0], [1.0, math.nextafter(1.0, 0.0), 2.0**-50, 3.0]]
    for row, parts in zip(rows, machine.parts(rows), strict=True):
        a, b, c, d = map(Fraction, row)
        assert sum(map(Fraction, parts)) == (a - b) * (c * d), row


class Small:
    """Numbers of few binary digits and any exponent, rounded to nearest, ties to even."""

    def __init__(self, value, digits):
        self.digits = digits
        self.value = self._rounded(Fraction(value))

    def _rounded(self, value):
        if not value:
            return value
        top = abs(value).numerator.bit_length() - value.denominator.bit_length()
        top -= abs(value) < Fraction(2) ** top
        unit = Fraction(2) ** (top - self.digits + 1)
        return round(value / unit) * unit

    def _made(self, value):
        return Small(value, self.digits)

    def __add__(self, other):
        return self._made(self.value + other.value)

    def __sub__(self, other):
        return self._made(self.value - other.value)

    def __mul__(self, other):
        return self._made(self.value * other.value)


@pytest.mark.parametrize("digits", [3, 4, 5])
def test_sums_are_exact_for_all_numbers_of_a_small_precision(digits):
    small = partial(Small, digits=digits)
    tops = range(2 ** (digits - 1), 2**digits)
    gaps = [Fraction(2) ** e for e in range(-digits - 2, digits + 3)]
    seconds = [small(sign * n * gap) for n in tops for gap in gaps for sign in (1, -1)]
    for first, b in product(map(small, tops), seconds):
        found = double_double._two_sum(first, b)
        assert found.hi.value + found.lo.value == first.value + b.value


@pytest.mark.parametrize("digits", [4, 5, 6, 7])
def test_products_are_exact_for_all_numbers_of_a_small_precision(monkeypatch, digits):
    small = partial(Small, digits=digits)
    monkeypatch.setattr(double_double, "SPLITTER", small(2 ** ((digits + 1) // 2) + 1))
    tops = [small(n) for n in range(2 ** (digits - 1), 2**digits)]
    for a, b in product(tops, repeat=2):
        p = a * b
        assert double_double._product_error(a, b, p).value == a.value * b.value - p.value
