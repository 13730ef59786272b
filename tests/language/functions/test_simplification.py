"""Simplification of Jacobi's functions, and differential equations that SymPy checks by it."""

import random
import subprocess
import sys
from pathlib import Path

import pytest
import sympy as sp
from sympy import checkodesol, cos, simplify, sin

import rigidsym.language.functions as package
from rigidsym.language.functions import (
    jacobi_am,
    jacobi_cn,
    jacobi_dn,
    jacobi_epsilon,
    jacobi_sn,
    jacobisimp,
)
from rigidsym.language.functions._simplification import join

u, v, m, n, t = sp.symbols("u v m n t")
omega, k = sp.symbols("omega k", positive=True)
f, g, h = map(sp.Function, "fgh")
S, C, D = (function(u, m) for function in (jacobi_sn, jacobi_cn, jacobi_dn))
AM = jacobi_am(u, m)

IDENTITIES = {
    S**2 + C**2: 1,
    D**2 + m * S**2: 1,
    D**2 - m * C**2: 1 - m,
    1 - S**2: C**2,
    1 - m * S**2: D**2,
    1 - m + m * C**2: D**2,
    3 * S**4 + 6 * S**2 * C**2 + 3 * C**4: 3,
    (1 - S**2) / C: C,
    (D**2 - 1) / S**2: -m,
    (1 - D**2) / (m * S): S,
    (D**2 - C**2) / S**2 + m: 1,
    1 / C**2 - S**2 / C**2: 1,
    C**2 * D**2 - (1 - S**2) * (1 - m * S**2): 0,
    sp.sqrt(S**2 + C**2): 1,
    sp.exp(v * (S**2 + C**2)): sp.exp(v),
    S**2 + C**2 + jacobi_dn(v, n) ** 2 + n * jacobi_sn(v, n) ** 2: 2,
    sin(AM) ** 2 + C**2: 1,
    sp.tan(AM) * C: S,
    cos(2 * AM) + 2 * S**2: 1,
}


@pytest.mark.parametrize("long", IDENTITIES, ids=str)
def test_simplify_uses_the_identities(long):
    assert simplify(long) == IDENTITIES[long]


@pytest.mark.parametrize("function", [jacobi_sn, jacobi_cn, jacobi_dn])
def test_sums_keep_the_identities(function):
    two = sp.expand_func(jacobi_sn(u + v, m)), sp.expand_func(function(u + v, m))
    rest = {jacobi_sn: 0, jacobi_cn: two[0] ** 2 - 1, jacobi_dn: m * two[0] ** 2 - 1}[function]
    square = two[1] ** 2 if function is not jacobi_sn else 0
    assert simplify(square + rest) == 0


def test_what_is_not_an_identity_stays():
    for other in (
        S**2 - C**2,
        S**2 + jacobi_cn(v, m) ** 2,
        S**2 + jacobi_cn(u, n) ** 2,
        D**2 + S**2,
    ):
        assert simplify(other - 1) != 0
    assert simplify(S * C * D) == S * C * D
    assert jacobisimp(u + v) == u + v


def test_simplification_keeps_values():
    """Compare random polynomials and quotients with their simplified forms at a point."""
    draw = random.Random(34)
    at = {u: sp.Rational(7, 10), m: sp.Rational(2, 7)}
    for _ in range(12):
        parts = [
            sum(
                draw.randint(-3, 3) * S ** draw.randint(0, 2) * C ** draw.randint(0, 2) * D**power
                for power in range(3)
            )
            for _ in range(2)
        ]
        before = parts[0] / (parts[1] + 7)
        after = jacobisimp(before)
        assert abs(sp.N((before - after).subs(at), 30, chop=True)) < 1e-25
        assert sp.count_ops(after) <= sp.count_ops(before)


def test_joining_twice_is_joining_once():
    module = sys.modules["sympy.simplify.simplify"]
    before = module.hyperexpand
    join()
    assert module.hyperexpand is before
    assert simplify(sp.hyper([], [], u)) == sp.exp(u)
    assert simplify(sin(u) ** 2 + cos(u) ** 2) == 1


# --- differential equations -----------------------------------------------------------------

EQUATIONS = {  # DLMF 22.13(ii) and (iii), the amplitude's and the pendulum's
    "sn": (f(t).diff(t, 2) + (1 + m) * f(t) - 2 * m * f(t) ** 3, jacobi_sn(t, m)),
    "cn": (f(t).diff(t, 2) + (1 - 2 * m) * f(t) + 2 * m * f(t) ** 3, jacobi_cn(t, m)),
    "dn": (f(t).diff(t, 2) - (2 - m) * f(t) + 2 * f(t) ** 3, jacobi_dn(t, m)),
    "sn'": (f(t).diff(t) ** 2 - (1 - f(t) ** 2) * (1 - m * f(t) ** 2), jacobi_sn(t, m)),
    "cn'": (f(t).diff(t) ** 2 - (1 - f(t) ** 2) * (1 - m + m * f(t) ** 2), jacobi_cn(t, m)),
    "dn'": (f(t).diff(t) ** 2 - (1 - f(t) ** 2) * (f(t) ** 2 - 1 + m), jacobi_dn(t, m)),
    "am": (f(t).diff(t, 2) + m * sin(2 * f(t)) / 2, jacobi_am(t, m)),
    "am'": (f(t).diff(t) ** 2 - 1 + m * sin(f(t)) ** 2, jacobi_am(t, m)),
    "epsilon": (f(t).diff(t) - jacobi_dn(t, m) ** 2, jacobi_epsilon(t, m)),
    "pendulum": (f(t).diff(t, 2) + omega**2 * sin(f(t)), 2 * jacobi_am(omega * t / k, k**2)),
    "swing": (f(t).diff(t, 2) + omega**2 * sin(f(t)), 2 * sp.asin(k * jacobi_sn(omega * t, k**2))),
}


@pytest.mark.parametrize("name", EQUATIONS)
def test_solutions_of_their_equations(name):
    equation, solution = EQUATIONS[name]
    assert checkodesol(equation, sp.Eq(f(t), solution)) == (True, 0)
    wrong = solution.subs(t, 2 * t)
    if name != "swing":  # SymPy needs a minute to give up
        assert not checkodesol(equation, sp.Eq(f(t), wrong))[0]


def test_eulers_equations_of_a_free_body():
    """Rates A cn, B sn and C dn of moments 3, 2 and 1, for any A and C."""
    size, last = sp.symbols("A C", positive=True)
    body = [f(t), g(t), h(t)]
    quotients = (sp.Rational(1, 3), -1, 1)
    equations = [
        rate.diff(t) - quotient * sp.Mul(*body) / rate
        for rate, quotient in zip(body, quotients, strict=True)
    ]
    argument = last * t / sp.sqrt(3), 3 * size**2 / last**2
    amplitudes = {jacobi_cn: size, jacobi_sn: -sp.sqrt(3) * size, jacobi_dn: last}
    found = [factor * function(*argument) for function, factor in amplitudes.items()]
    solutions = [sp.Eq(*pair) for pair in zip(body, found, strict=True)]
    assert checkodesol(equations, solutions) == (True, [0, 0, 0])
    faster = [sp.Eq(one.lhs, one.rhs.subs(t, 2 * t)) for one in solutions]
    assert not checkodesol(equations, faster)[0]


def test_systems():
    equations = [
        f(t).diff(t) - g(t) * h(t),
        g(t).diff(t) + f(t) * h(t),
        h(t).diff(t) + m * f(t) * g(t),
    ]
    solutions = [
        sp.Eq(one, F(t, m))
        for one, F in zip((f(t), g(t), h(t)), (jacobi_sn, jacobi_cn, jacobi_dn), strict=True)
    ]
    assert checkodesol(equations, solutions) == (True, [0, 0, 0])


# --- what could be offered to SymPy ---------------------------------------------------------

ALONE = ("_evaluated", "_arguments", "_jacobi", "_simplification")
SCRIPT = """
import sys
for name in ("numpy", "scipy", "flint"):
    sys.modules[name] = None
import doctest, importlib, sympy
modules = [importlib.import_module(f"rigidsym.language.functions.{name}") for name in NAMES]
modules[-1].join()
jacobi = modules[2]
u, m = sympy.symbols("u m")
assert sympy.simplify(jacobi.jacobi_sn(u, m)**2 + jacobi.jacobi_cn(u, m)**2) == 1
assert abs(jacobi.jacobi_dn(1, sympy.Rational(1, 3)).evalf(30)**2
    + jacobi.jacobi_sn(1, sympy.Rational(1, 3)).evalf(30)**2 / 3 - 1) < 1e-28
try:
    sympy.lambdify([u, m], jacobi.jacobi_sn(u, m), "mpmath")
except NotImplementedError as error:
    assert "jacobi_sn: Python with mpmath has no such function" in str(error)
else:
    raise AssertionError("printed")
assert sum(doctest.testmod(module).failed for module in modules) == 0
found = {name for name in sys.modules if name.startswith("rigidsym.language.functions.")}
assert found == {f"rigidsym.language.functions.{name}" for name in NAMES}, found
"""


def test_the_part_that_sympy_lacks_stands_alone(tmp_path):
    """Run its four modules where this package has nothing else, and without NumPy."""
    folder = tmp_path / "rigidsym" / "language" / "functions"
    folder.mkdir(parents=True)
    for place in (tmp_path / "rigidsym", folder.parent, folder):
        (place / "__init__.py").write_text("", encoding="utf-8")
    for name in ALONE:
        text = (Path(package.__file__).parent / f"{name}.py").read_text("utf-8")
        (folder / f"{name}.py").write_text(text, encoding="utf-8")
    script = SCRIPT.replace("NAMES", repr(ALONE))
    done = subprocess.run(
        [sys.executable, "-c", script],
        cwd=tmp_path,
        env={"PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
