"""The runtime's elementary functions agree with the C library's: `elementary` bit by bit."""

import __future__

import math
import random
import struct
from importlib import resources

import pytest

RANDOM = 20_000


def bits_of(x):
    return struct.unpack("<Q", struct.pack("<d", x))[0]


def from_bits(bits):
    return struct.unpack("<d", struct.pack("<Q", bits % 2**64))[0]


@pytest.fixture(scope="module")
def own():
    """The routines as functions of Python: their syntax is Python's, and so are their numbers."""
    known = {"bits_of": bits_of, "from_bits": from_bits, "inline": lambda function: function}
    known |= {"double": float, "isfinite": math.isfinite, "nan": math.nan, "pair": lambda *x: x}
    for name in ("arithmetic", "elementary"):
        text = (resources.files("rigidsym._codegen.runtime") / f"{name}.py").read_text("utf-8")
        flags = __future__.annotations.compiler_flag
        exec(compile(text, name, "exec", flags=flags, dont_inherit=True), known)
    known["product_error"] = known["split_product_error"]
    return known


def numbers(seed):
    """Yield doubles of all exponents, of both signs."""
    draw = random.Random(seed)
    found = (from_bits(draw.getrandbits(64)) for _ in range(RANDOM))
    return [x for x in found if math.isfinite(x)]


def roots(seed):
    """Yield squares, squares of what is between two doubles, and the doubles beside them."""
    draw = random.Random(seed)
    for _ in range(RANDOM // 4):
        s = 1 + draw.getrandbits(52) * 2.0**-52 + draw.choice((0, 2.0**-53))
        square = s * s * draw.choice((1.0, 2.0, 4.0, 2.0**-1072, 2.0**1020))
        yield from (square, math.nextafter(square, 0.0), math.nextafter(square, math.inf))


SPECIAL = (
    *(0.0, -0.0, 5e-324, 2.2250738585072014e-308, 2.225073858507201e-308, 1.0, 4.0, math.inf),
    *(math.nextafter(1, 0), math.nextafter(4, 0), 1.7976931348623157e308),
)


def test_roots_are_rounded_correctly(own):
    for x in (*SPECIAL, *map(abs, numbers(1)), *roots(2)):
        assert bits_of(own["sqrt"](x)) == bits_of(math.sqrt(x)), x
    assert math.isnan(own["sqrt"](-1.0))
    assert math.isnan(own["sqrt"](math.nan))


def test_exponents_and_scaling_are_exact(own):
    draw = random.Random(3)
    for x in (*SPECIAL, *numbers(4)):
        if math.isfinite(x):
            assert own["exponent"](x) == math.frexp(x)[1], x
        n = draw.randint(-2200, 2200)
        try:
            scaled = math.ldexp(x, n)
        except OverflowError:
            scaled = math.copysign(math.inf, x)
        assert bits_of(own["ldexp"](x, n)) == bits_of(scaled), (x, n)


def test_signs_are_those_of_bits(own):
    for x, y in zip(numbers(5), reversed(numbers(6)), strict=False):
        assert bits_of(own["abs"](x)) == bits_of(abs(x))
        assert bits_of(own["copysign"](x, y)) == bits_of(math.copysign(x, y))
