"""Claims that the generated attitude and rates equal those of the ledger.

Generated constants (rows and gains) collect the factors that do not change with time; the generated
state sums their products.  Substituted into each other they are the formulas of the ledger, where
1/N is the product of over_N and scale, Jacobi's functions are quotients of thetas, and rates are in
the unit.
"""

from collections.abc import Iterable, Iterator, Mapping

from rigidsym._codegen.forms import STEP, THETA
from rigidsym._codegen.ir import Function
from rigidsym._codegen.names import ATTITUDE, PARTS, RATES
from rigidsym._codegen.seal.equality import Claim, formulas_of
from rigidsym._codegen.seal.facts import by_fact
from rigidsym.errors import InputError
from rigidsym.language._expression import (
    Call,
    Expression,
    Number,
    Operation,
    parse,
    put,
    to_text,
)
from rigidsym.solution import Formula, Solution

# A period later along the imaginary axis theta_1 has the other sign (DLMF 20.2.6), theta_2 has not.
_FLIP = {"circular": "", "hyperbolic": "*flip"}
# DLMF 22.2.4 to 22.2.6; on the imaginary axis by Jacobi's transformation, DLMF 20.7(viii).
_QUOTIENTS = {
    "circular": {
        "sn": "three/two*theta1_v/theta4_v",
        "cn": "four/two*theta2_v/theta4_v",
        "dn": "four/three*theta3_v/theta4_v",
    },
    "hyperbolic": {
        "sn": "three/four*flip*theta1_y/theta2_y",
        "cn": "two/four*flip*theta4_y/theta2_y",
        "dn": "two/three*theta3_y/theta2_y",
    },
}
# What the polynomials of an angle in half turns are (DLMF 4.19.1, 4.19.2); a period of the
# hyperbolic branch adds `jump` to the angle.
_PHASE = {"X_re": "cos(pi*(Lambda_rate*t))", "X_im": "sin(pi*(Lambda_rate*t))"}


def claims(solution: Solution, functions: Iterable[Function], form: str = THETA) -> Iterator[Claim]:
    """Yield the claims on the attitude, norm, phase and rates of each branch."""
    if form == STEP:
        return
    emitted = {function.name: formulas_of(function.formulas) for function in functions}
    rates = {formula.name: formula for formula in solution.sequences["rates"]}
    for branch in ("circular", "hyperbolic") if form == THETA else ():
        constants, state = emitted[f"_{branch}_constants"], emitted[f"_{branch}_state"]
        ledger = {formula.name: formula for formula in solution.sequences[f"{branch}_state"]}
        yield from _attitude(branch, ledger, constants, state)
        yield _norm(branch, constants, state)
        yield from _phase(branch, ledger, constants)
        yield from _rates(branch, rates, constants, state)
    yield from _steady(solution, emitted["_steady_constants"], emitted["_steady_state"])


def _attitude(
    branch: str,
    ledger: Mapping[str, Formula],
    constants: Mapping[str, Expression],
    state: Mapping[str, Expression],
) -> Iterator[Claim]:
    bars = {name: ledger[name].expression for name in ledger if name.startswith("qbar_")}
    rows = {name: constants[name] for name in constants if name.startswith("row_")}
    share = {name: f"{name}*over_N*scale{_FLIP[branch] * name.startswith('P1')}" for name in PARTS}
    shares = {name: parse(text) for name, text in share.items()} | {"N": Number(1)}
    for name in ATTITUDE:
        formula = ledger[name]
        derived = put(put(formula.expression, bars), shares)
        yield Claim(f"_{branch}_state", formula.fact, derived, put(state[name], rows))


def _norm(
    branch: str, constants: Mapping[str, Expression], state: Mapping[str, Expression]
) -> Claim:
    """Return the claim that over_N times scale is 1/N, where N is the attitude's norm.

    The claim is (over_N scale)^2 W = 1, where W = N^2; both factors are positive.
    """
    scale = put(state["scale"], {"over": state["over"]})
    product = Operation("*", _squared(branch, constants["over_N"]), _squared(branch, scale))
    square = Operation("*", product, constants["W"])
    return Claim(f"_{branch}_state", "over_N and scale", Number(1), square)


def _squared(place: str, positive: Expression) -> Expression:
    """Return the square of a positive expression: a root, a quotient of roots, or 1."""
    match positive:
        case Call("sqrt", (radicand,)):
            return radicand
        case Operation("/", left, right):
            return Operation("/", _squared(place, left), _squared(place, right))
        case Number(1):
            return positive
    raise InputError(place, to_text(positive), "is not seen to be positive")


def _phase(
    branch: str, ledger: Mapping[str, Formula], constants: Mapping[str, Expression]
) -> Iterator[Claim]:
    rate = {"Lambda_rate": constants["Lambda_rate"]}
    for name, text in _PHASE.items():
        formula = ledger[name]
        yield Claim(
            f"_{branch}_constants", formula.fact, formula.expression, put(parse(text), rate)
        )


def _rates(
    branch: str,
    ledger: Mapping[str, Formula],
    constants: Mapping[str, Expression],
    state: Mapping[str, Expression],
) -> Iterator[Claim]:
    quotients = {name: parse(text) for name, text in _QUOTIENTS[branch].items()}
    known = {name: constants[name] for name in constants if name.startswith("gain_")}
    known |= {"over": state["over"]}
    for name in RATES:
        formula = ledger[name]
        derived = Operation("*", put(formula.expression, quotients), parse("unit"))
        yield Claim(f"_{branch}_state", formula.fact, derived, put(state[name], known))


def _steady(
    solution: Solution, constants: Mapping[str, Expression], state: Mapping[str, Expression]
) -> Iterator[Claim]:
    """Yield the claims that the phase of constant rates is half their rotation angle."""
    ledger = by_fact(solution)
    angle = {"theta": ledger["definition steady.theta"].expression}
    phase = {n: put(parse(x), {"Lambda_rate": constants["Lambda_rate"]}) for n, x in _PHASE.items()}
    for name in ("cos_half_theta", "sin_half_theta"):
        formula = ledger[f"reading steady.{name}"]
        derived = put(formula.expression, angle)
        yield Claim("_steady_state", formula.fact, derived, put(state[name], phase))
