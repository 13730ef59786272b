"""Equations of motion from a Lagrangian in body rates, by Euler-Poincare variation."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy

from rigidsym.proof.algebra import LedgerBuilder, Part
from rigidsym.proof.algebra._builder import Source
from rigidsym.proof.algebra._computation import Computation
from rigidsym.proof.steps._names import symbol, symbols
from rigidsym.proof.steps._record import Step, StepError
from rigidsym.proof.steps._scope import Scope

RATES, MOMENTA = symbols("Omega1 Omega2 Omega3"), symbols("M1 M2 M3")
# f[i][j][k]: the coordinates of [A_i, A_j] = sum f_ijk A_k.
Constants = Sequence[Sequence[Sequence[sympy.Expr]]]


@dataclass(frozen=True, slots=True)
class Variation:
    """Equations of motion M' = moment for momenta M, derived by a variation."""

    momenta: tuple[sympy.Expr, ...]
    moments: tuple[sympy.Expr, ...]
    scope: Scope
    step: Step

    @property
    def equations(self) -> list[tuple[Any, Any]]:
        """The equations of motion M' = moment.

        Their unknowns are the time derivatives of the body rates.
        """
        known: Any = dict(zip(MOMENTA, self.momenta, strict=True))
        pairs = zip(self.momenta, self.moments, strict=True)
        return [(self.scope.rate(momentum), moment.subs(known)) for momentum, moment in pairs]


def vary(
    builder: LedgerBuilder,
    name: str,
    lagrangian: sympy.Expr,
    constants: Constants,
    parameters: Part,
    why: str,
    source: Source = (),
) -> Variation:
    """Derive the equations of motion of a Lagrangian L(Omega) by Euler-Poincare variation.

    For R' = R Omega and delta R = R eta, delta Omega = eta' + [Omega, eta].  Then delta L is the
    rate of M eta less (M' - moment) eta, with M = dL/dOmega, for every eta.  The kernel decides it
    with eps, eps^2 = 0, for the small number.  Raises StepError where L is not in Omega1 to Omega3
    and the parameters.
    """
    etas = symbols("eta1 eta2 eta3")
    turned = _turned(constants, etas)
    momenta = tuple(sympy.diff(lagrangian, rate) for rate in RATES)
    change = sympy.expand(sum(m * t for m, t in zip(MOMENTA, turned, strict=True)))
    moments = tuple(sympy.factor(change.coeff(eta)) for eta in etas)
    strange = lagrangian.free_symbols - {*RATES} - {*map(symbol, parameters.names)}
    if strange:
        raise StepError(f"vary: {name}: the Lagrangian has {min(map(str, strange))} in it")
    pairs = zip(RATES, turned, strict=True)
    small = {rate: rate + symbol("eps") * change for rate, change in pairs}
    scope = Scope.open(builder, name, parameters, _free_motion(lagrangian, small, momenta, moments))
    boundary = " + ".join(f"M{k}*eta{k}" for k in (1, 2, 3))
    rest = " + ".join(f"E{k}*eta{k}" for k in (1, 2, 3))
    change = [("L_varied - L", f"eps*(D({boundary}) - ({rest}))")]
    origin = Computation(moments, ("vary",))
    fact = scope.decide(f"{name}.by_parts", change, source, origin)
    equations = [(symbol(f"M{k}_rate"), moment) for k, moment in enumerate(moments, 1)]
    step = scope.note("vary", why, moments, equations, fact)
    return Variation(momenta, moments, scope, step)


def _turned(constants: Constants, etas: Sequence[sympy.Symbol]) -> list[sympy.Expr]:
    """Return the variations of the body rates.

    They are delta Omega_k = eta_k' + sum f_ijk Omega_i eta_j.
    """
    triple = range(3)
    return [
        symbol(f"{etas[k]}_rate")
        + sum(constants[i][j][k] * RATES[i] * etas[j] for i in triple for j in triple)
        for k in triple
    ]


def _free_motion(
    lagrangian: sympy.Expr,
    small: Any,
    momenta: Sequence[sympy.Expr],
    moments: Sequence[sympy.Expr],
) -> Part:
    """Return the part that introduces an arbitrary motion and its variation.

    Second time derivatives are unknown.
    """
    names = [f"{name}{k}" for name in ("Omega", "eta") for k in (1, 2, 3)]
    numbered = list(enumerate(zip(momenta, moments, strict=True), 1))
    return Part(
        witness={**dict.fromkeys([*names, *(f"{x}_rate" for x in names)], "1"), "eps": "0"},
        definitions={
            "L": str(lagrangian),
            "L_varied": str(lagrangian.subs(small, simultaneous=True)),
            **{f"M{k}": str(momentum) for k, (momentum, _) in numbered},
            **{f"E{k}": f"D(M{k}) - ({moment!s})" for k, (_, moment) in numbered},
        },
        relations=("eps**2",),
        rates={**{x: f"{x}_rate" for x in names}, **{f"{x}_rate": "?" for x in names}},
        reading={
            "L": "the Lagrangian",
            "eps": "a small number: its square is nothing",
            **{f"eta{k}": f"component {k} of R^-1 delta R" for k in (1, 2, 3)},
        },
    )
