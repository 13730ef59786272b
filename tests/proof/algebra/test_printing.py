"""SymPy polynomials as kernel texts with a chosen order of names."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import (
    I,
    Integer,
    Poly,
    Rational,
    UnevaluatedExpr,
    expand,
    sin,
    sqrt,
    symbols,
    sympify,
)

from rigidsym.proof.algebra._printing import printed
from rigidsym.proof.kernel import Context, Ledger

x, y, z = symbols("x y z")
RING = Ledger().open(Context("free", ("x", "y", "z"), dict.fromkeys("xyz", "0")))


@pytest.mark.parametrize(
    ("polynomial", "names", "text"),
    [
        (x * y - z, "z y x", "-z + y*x"),
        (z * (y - x) + x + y, "x y z", "x + y + z*(y - x)"),
        (z * (y - x) + x - y, "y x z", "x - y + z*(y - x)"),
        (2 * x**2 - 3 * x - y**3, "x y", "-3*x + 2*x**2 - y**3"),
        ((x + y) ** 2 * z, "z y x", "z*(y + x)**2"),
        (x / 2 - Rational(2, 3) * y, "x y", "x/2 - 2*y/3"),
        (-x * (y + z), "x y z", "-x*(y + z)"),
        (Integer(0), "x", "0"),
        (Integer(-7), "x", "-7"),
        (x - 1, "x", "-1 + x"),
        (1 / x, "x", "1/x"),
        (x / (2 * y), "x y", "x/(2*y)"),
        (x * UnevaluatedExpr(y / z) ** 2, "x y z", "x*(y/z)**2"),
        (x + UnevaluatedExpr(z - y), "x y z", "x + (z - y)"),
    ],
    ids=str,
)
def test_names_come_as_listed_and_terms_by_degree_and_sign(polynomial, names, text):
    assert printed(polynomial, names) == text
    assert expand(sympify(text) - polynomial.doit()) == 0


def plain(polynomial):
    """Return a polynomial as a sum of monomials, from its coefficients alone."""
    terms = Poly(polynomial, x, y, z).terms()
    powers = ["".join(f"*{v}**{n}" for v, n in zip("xyz", p, strict=True) if n) for p, _ in terms]
    return " + ".join(f"({c}){power}" for (_, c), power in zip(terms, powers, strict=True))


@pytest.mark.parametrize("names", ["x y z", "z y x", "y z x"])
@given(
    st.recursive(
        st.sampled_from([x, y, z, Integer(1), Integer(-2), Rational(3, 7)]),
        lambda inner: st.one_of(
            st.builds(lambda a, b: a + b, inner, inner),
            st.builds(lambda a, b: a * b, inner, inner),
            st.builds(lambda a, n: a**n, inner, st.integers(1, 3)),
        ),
        max_leaves=8,
    )
)
def test_the_kernel_reads_back_what_was_printed(names, polynomial):
    assert not (RING.read(printed(polynomial, names)) - RING.read(plain(polynomial))).numerator


@pytest.mark.parametrize("expression", [sqrt(x), x**y, sin(x), I * x, x + symbols("w")], ids=str)
def test_anything_else_is_refused(expression):
    with pytest.raises(ValueError, match="not "):
        printed(expression, "x y z")
