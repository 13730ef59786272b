"""Sensitivities of the rates: derivatives by the rates at t = 0 and the moments of inertia.

A change of the rates at t = 0 and of the moments is written d; it is the derivative by a parameter
on which all of them depend.  In `perturbed` D is that derivative: the change of each
quantity of the addition form follows by the chain rule.  In `varied` D is the time derivative
again, and the changes satisfy the variation of Euler's equations.

The functions change along two directions: `_k`, where p and r grow alike, and `_r`, where r does.
The time t is the integral of dS/sqrt((1 - p S^2) (1 - r S^2)) from 0 to S_t, and stays, so

    0 = S_k/(C_t D_t) + the integral of the change of the integrand,

and the relations between the functions give C_k and D_k.  Nothing divides by p, r or p - r.
"""

from collections.abc import Mapping
from typing import Any

import sympy
from sympy import Expr, Symbol

from derivations.addition_form import (
    COEFFICIENTS,
    EULER,
    FORCES,
    FUNCTIONS,
    GIVEN,
    OTHERS,
    OVER_SQUARE,
    RATES,
    SQUARED,
    START,
    TIME,
)
from derivations.attitude import HANDEDNESS, INERTIA
from rigidsym.proof.algebra import LedgerBuilder, Part, Proofs, join, named
from rigidsym.proof.algebra._computation import Computation, compute
from rigidsym.proof.steps._names import collected, read, symbol, symbols

EPSILON = symbol("epsilon")
p, r, S, C, D, E, F = symbols("p r S_t C_t D_t E_t F_t")
dp, dr, *VARIED = symbols("dp dr dS_t dC_t dD_t")
MOVED = (*GIVEN.names, *FORCES, *FUNCTIONS.names)
PARAMETER = "a change is the derivative by the parameter that D is about"
MODULI = Part({p: "lambda^2", r: "m lambda^2"})
PARAMETERS = Part(
    (*MODULI.names, dp, dr),
    reading={**MODULI.reading, dp: "a change of p", dr: "a change of r"},
)
FUNCTION_PARTS = (FUNCTIONS, TIME, SQUARED, OVER_SQUARE)


def small(*names: Any) -> Part:
    """Return the part that introduces changes of names."""
    return Part({f"d{x}": f"the change of {x}" for x in names})


def still(*parts: Part) -> list[Part]:
    """Return the names of parts without hypotheses about them, as at one instant."""
    return [Part(x.names, x.units, reading=x.reading) for x in parts]


def at_start(part: Part) -> dict[Any, Any]:
    """Return the values that definitions have at t = 0."""
    begun = {x: int(str(x) in ("C_t", "D_t")) for x in symbols("t S_t C_t D_t E_t F_t U_t V_t W_t")}
    return {name: compute(value).subs(begun) for name, value in part.definitions.items()}


def defined(*parts: Part) -> dict[Symbol, Expr]:
    """Return the definitions of parts as expressions."""
    found = join("parts", *parts, static=True).definitions
    return {symbol(name): read(text) for name, text in found.items()}


def moving(*parts: Part) -> dict[Symbol, Expr]:
    """Return the time derivatives of names as expressions."""
    found = join("parts", *parts).rates or {}
    return {symbol(name): read(text) for name, text in found.items()}


def change(value: Any, by: Mapping[Any, Any] | None = None) -> Computation:
    """Return the change of an expression by the chain rule, from those of the names in it.

    The change of x is dx where none are given; the handedness is constant.
    """
    return compute(value).apply(by_chain_rule, by)


def by_chain_rule(value: Expr, by: Mapping[Any, Any] | None) -> Expr:
    """Return the sum of the derivatives by each name, times the name's change."""
    if by is None:
        by = {x: symbol(f"d{x}") for x in value.free_symbols - {EPSILON}}
    return sympy.Add(*(sympy.diff(value, x) * dx for x, dx in by.items()))


def change_of(name: Symbol, value: Any, by: Mapping[Any, Any] | None = None) -> Computation:
    """Return the change of what is defined as a quotient N/d: dN/d - (N/d) dd/d."""
    above, below = compute(value).apply(sympy.fraction)
    return change(above, by) / below - name * change(below, by) / below


CURVES = tuple(read(x) for x in join("functions", MODULI, FUNCTIONS).relations)
MOVING = moving(MODULI, *FUNCTION_PARTS)


def integral(rate: Any, *functions: Any, rates: Mapping[Symbol, Expr] = MOVING) -> Computation:
    """Return the combination of functions of the time whose derivative is an expression.

    `rates` are the derivatives of the names in them.
    """
    return compute(rate).apply(by_coefficients, functions, rates)


def by_coefficients(rate: Expr, functions: tuple[Expr, ...], rates: Mapping[Symbol, Expr]) -> Expr:
    """Solve for the coefficients, as each monomial in S_t, C_t and D_t has to have the same."""
    unknown = sympy.symbols(f"x:{len(functions)}")
    terms = zip(unknown, functions, strict=True)
    gap = sympy.Add(*(x * by_chain_rule(f, rates) for x, f in terms), -rate)
    above = sympy.fraction(sympy.together(gap))[0]
    for curve, name in zip(CURVES, (C, D), strict=True):
        above = sympy.rem(above, curve, name)
    monomials = sorted(above.free_symbols - {p, r, *unknown}, key=str)
    (found,) = sympy.linsolve(sympy.Poly(above, *monomials).coeffs(), *unknown)
    below = sympy.factor(sympy.lcm([sympy.fraction(sympy.cancel(x))[1] for x in found]))
    terms = (collected(x * below * f) for x, f in zip(found, functions, strict=True))
    return sympy.Mul(*sympy.Mul.make_args(1 / below), sympy.Add(*terms), evaluate=False)


def _along(*grow: Symbol) -> tuple[Computation, ...]:
    """Return the changes of S_t, C_t and D_t where some of p and r grow.

    The change of the integrand is integrated by parts where p grows.
    """
    integrand = compute(-(sympy.log(1 - p * S**2) + sympy.log(1 - r * S**2)) / 2)
    slope = change(integrand, dict.fromkeys(grow, 1)).subs({1 - p * S**2: C**2, 1 - r * S**2: D**2})
    late = integral(slope, *((S**3 / (C * D), E) if p in grow else (F,)))
    found = (-C * D * late).expand().factor()
    others = []
    for curve, x, q in zip(CURVES, (C, D), (p, r), strict=True):
        moved = change(curve, {S: found, **dict.fromkeys(grow, 1)}).expand()
        by_curve = moved.subs(q * S**4, S**2 * (1 - x**2))
        others.append((-by_curve / sympy.diff(curve, x)).cancel().factor())
    return found, *others


ALONG_K, ALONG_R = _along(p, r), _along(r)
# What S_t, C_t and D_t change by, in every case: nothing divides by p, r or p - r.
REGULAR = Part(
    definitions={
        name: dp * along_k + (dr - dp) * along_r
        for name, along_k, along_r in zip(VARIED, ALONG_K, ALONG_R, strict=True)
    }
)
# The variation of S_t' = C_t D_t and the other two, and of the relations between them.
VARIED_RATES = {f"D(d{x})": change(rate) for x, rate in moving(MODULI, FUNCTIONS).items()}
VARIED_CURVES = tuple(map(change, CURVES))
VARIED_FUNCTIONS = Part(relations=VARIED_CURVES, rates=named(VARIED, VARIED_RATES.values()))
QUANTITIES = defined(COEFFICIENTS, GIVEN, FUNCTIONS, RATES)
CHANGES = {f"d{name}": change_of(name, value) for name, value in QUANTITIES.items()}


def derive(builder: LedgerBuilder) -> None:
    """Prove the changes of the rates, and of the functions in them."""
    _perturbed(builder)
    _moving(builder)
    _functions(builder)


def _perturbed(builder: LedgerBuilder) -> None:
    """Prove that the changes are derivatives by a parameter D."""
    along = Part(rates={x: f"d{x}" for x in MOVED}, definitions=CHANGES)
    fixed = Part(FUNCTIONS.names, reading=FUNCTIONS.reading)
    here = Proofs.open(
        builder, "perturbed", COEFFICIENTS, GIVEN, fixed, RATES, small(*MOVED), along
    )
    changes = {f"D({name[1:]})": name for name in CHANGES}
    here.claim("changes", changes, 5, law=PARAMETER)
    forces = defined(HANDEDNESS, INERTIA, Part(definitions=FORCES))
    by_moments = {f"d{name}": change_of(name, value) for name, value in forces.items()}
    along = Part(rates={c: f"d{c}" for c in INERTIA.names}, definitions={**FORCES, **by_moments})
    moments = (HANDEDNESS, INERTIA, small(*INERTIA.names))
    here = Proofs.open(builder, "perturbed_moments", *moments, along)
    claims = {f"D({name})": f"d{name}" for name in FORCES}
    here.claim("changes", claims, 5, law=PARAMETER)


def _moving(builder: LedgerBuilder) -> None:
    """Prove that the changes satisfy the variation of Euler's equations in time."""
    given = (COEFFICIENTS, GIVEN)
    constant = small(*GIVEN.names, *FORCES)
    functions = small(*FUNCTIONS.names)
    rates = (RATES, constant, functions, Part(definitions=CHANGES))
    here = Proofs.open(builder, "varied", *given, FUNCTIONS, *rates, VARIED_FUNCTIONS)
    here.claim("euler", EULER, 5)
    varied = {f"D(dOmega_{x})": change(EULER[f"D(Omega_{x})"]) for x in OTHERS}
    here.claim("variation", varied, 5)
    start = Part(relations=("S_t", "C_t - 1", "D_t - 1", *VARIED))
    here = Proofs.open(
        builder, "varied_start", *given, *still(FUNCTIONS), *rates, start, static=True
    )
    here.evaluate("rates", [f"dOmega_{x}" for x in "abd"], 12)


def _functions(builder: LedgerBuilder) -> None:
    """Prove that changes of S_t, C_t, D_t satisfy the varied equations and start at 0."""
    here = Proofs.open(builder, "varied_regular", PARAMETERS, *FUNCTION_PARTS, REGULAR)
    relations = dict.fromkeys(VARIED_CURVES, "0")
    here.claim("variation", [*VARIED_RATES.items(), *relations.items()], 5, 10)
    start = Part(relations=(*START.relations, "F_t"))
    parts = (PARAMETERS, *still(*FUNCTION_PARTS), REGULAR, start)
    here = Proofs.open(builder, "varied_regular_start", *parts, static=True)
    here.claim("functions", at_start(REGULAR), 12)
