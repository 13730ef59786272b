"""Sensitivities of the attitude: a small turn by the integrals of Omega_k^2 alone.

L = R M is constant, so its change is; seen in the body it is l, with l' = l x Omega.  Let xi be the
small turn in the body, dR = R [xi], and s its component along M, times K:

    xi = (M x (l - dM) + s M)/K^2,    s = s_0 + t dH - (dc1 I1 + dc2 I2 + dc3 I3)/2

where I_k' = Omega_k^2.  The change of q is q (0, xi)/2.  Nothing divides by anything but K, and no
derivative of an elliptic integral of the third kind is asked for, whatever the motion.
"""

from collections.abc import Iterable, Mapping

import sympy

from derivations.euler_lax import Dynamics
from derivations.rate_sensitivities import change_of
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._quaternion import kinematics, product
from rigidsym.proof.steps._names import read, symbol, symbols

Vector = tuple[sympy.Symbol, ...]
AXES = (1, 2, 3)
C, OMEGA, M, L, XI = (symbols(f"{x}1 {x}2 {x}3") for x in ("c", "Omega", "M", "l", "xi"))
Q = symbols("q0 q1 q2 q3")


def varied(names: Iterable[sympy.Symbol]) -> Vector:
    """Return the names of the changes of quantities."""
    return tuple(symbol(f"d{name}") for name in names)


def _texts(names: Iterable[object], values: Iterable[object]) -> dict[str, str]:
    return {str(name): str(value) for name, value in zip(names, values, strict=True)}


def _cross(one: Iterable[sympy.Expr], other: Iterable[sympy.Expr]) -> list[sympy.Expr]:
    return list(sympy.Matrix([*one]).cross(sympy.Matrix([*other])))


def _variations(rates: Mapping[str, str]) -> dict[str, str]:
    """Return the change of each rate by the chain rule."""
    return {f"d{name}": str(change_of(read(text))) for name, text in rates.items()}


# A body beside the one that moves: its moments, its rates and, in the body, its momentum differ.
BESIDE = Part(
    witness={
        **dict.fromkeys(map(str, varied(C)), "1"),
        **dict.fromkeys(map(str, varied(OMEGA)), "0"),
    },
    definitions={
        **{f"dM{k}": f"dc{k}*Omega{k} + c{k}*dOmega{k}" for k in AXES},
        "dH": "(dc1*Omega1**2 + dc2*Omega2**2 + dc3*Omega3**2)/2"
        " + M1*dOmega1 + M2*dOmega2 + M3*dOmega3",
    },
    reading={
        **{f"dc{k}": f"change of the moment of inertia c{k}, kg m^2" for k in AXES},
        **{f"dOmega{k}": f"change of Omega{k}, rad/s" for k in AXES},
        "dH": "change of the energy, constant",
    },
)
STATE = Part(
    witness={"Omega1": "1", "Omega2": "0", "Omega3": "0", "K": "1"},
    units=("K",),
    relations=("K**2 - M1**2 - M2**2 - M3**2",),
    reading={"K": "|M|, kg m^2 rad/s"},
)
MOMENTUM = Part(
    witness={"l1": "1", "l2": "0", "l3": "0"},
    relations=("M1*(l1 - dM1) + M2*(l2 - dM2) + M3*(l3 - dM3)",),
    rates=_texts(L, _cross(L, OMEGA)),
    reading={f"l{k}": f"component {k} in the body of the change of L = R M" for k in AXES},
)
INTEGRALS = Part(
    witness={"t": "0", **{f"I{k}": "0" for k in AXES}},
    rates={"t": "1", **{f"I{k}": f"Omega{k}**2" for k in AXES}},
    reading={
        "t": "time, s",
        **{f"I{k}": f"the integral of Omega{k}^2 from 0 to t" for k in AXES},
    },
)
ALONG = {"s": "s_0 + t*dH - (dc1*I1 + dc2*I2 + dc3*I3)/2"}
BEGUN = Part(witness={"s_0": "0"}, definitions=ALONG, reading={"s_0": "xi . M at t = 0"})
ACROSS = _cross(M, (x - y for x, y in zip(L, varied(M), strict=True)))
TURN = Part(
    definitions=_texts(
        XI, ((x + symbol("s") * m) / symbol("K") ** 2 for x, m in zip(ACROSS, M, strict=True))
    ),
    reading={f"xi{k}": f"component {k} in the body of the small turn" for k in AXES},
)
ATTITUDE = Part(
    witness={str(q): str(int(k == 0)) for k, q in enumerate(Q)},
    rates=_texts(Q, kinematics("q0 q1 q2 q3", "Omega1 Omega2 Omega3").values()),
    relations=("q3**2 + q2**2 + q1**2 + q0**2 - 1",),
    definitions=_texts(varied(Q), (x / 2 for x in product(Q, (0, *XI)))),
    reading={str(q): f"component {k} of the attitude" for k, q in enumerate(Q)},
)


def derive(builder: LedgerBuilder) -> None:
    """Prove that small turn and change of q satisfy the variation of (3) from given values."""
    dynamics = builder.result(Dynamics)
    moving = Part(rates=_variations(dynamics.body.rates))
    parts = (
        *(dynamics.parameters, dynamics.body, moving, STATE),
        *(BESIDE, MOMENTUM, INTEGRALS, BEGUN, TURN),
    )
    builder.open(join("turned", *parts))
    builder.claim("turned.energy", {"D(dH)": "0"}, ["6"])
    builder.claim("turned.along", {"xi1*M1 + xi2*M2 + xi3*M3": "s"}, ["6"])
    turning = [dw - x for dw, x in zip(varied(OMEGA), _cross(OMEGA, XI), strict=True)]
    builder.claim("turned.variation", _texts((f"D({x})" for x in XI), turning), ["3"])
    builder.open(join("turned_attitude", *parts, ATTITUDE))
    variation = {f"D({name})": rate for name, rate in _variations(ATTITUDE.rates).items()}
    builder.claim("turned_attitude.variation", variation, ["3"])
    builder.claim("turned_attitude.norm", {" + ".join(f"{q}*d{q}" for q in Q): "0"}, ["1"])
    momenta = Part(definitions={str(m): dynamics.body.definitions[str(m)] for m in M})
    _start(builder, dynamics.parameters, momenta)
    _rest(builder)


def _rest(builder: LedgerBuilder) -> None:
    """Prove the case of a body at rest, where the small turn grows linearly."""
    given = symbols("eta1 eta2 eta3")
    turned = [x + symbol("t") * dw for x, dw in zip(given, varied(OMEGA), strict=True)]
    begun = Part(
        witness={"t": "0", **dict.fromkeys(map(str, (*given, *varied(OMEGA))), "1")},
        rates={"t": "1"},
        definitions={**dict.fromkeys(map(str, OMEGA), "0"), **_texts(XI, turned)},
        reading={str(x): f"component {k} of xi at t = 0" for k, x in enumerate(given, 1)},
    )
    builder.open(join("turned_at_rest", begun))
    turning = [dw - x for dw, x in zip(varied(OMEGA), _cross(OMEGA, XI), strict=True)]
    builder.claim("turned_at_rest.variation", _texts((f"D({x})" for x in XI), turning), ["3"])


def _start(builder: LedgerBuilder, *body: Part) -> None:
    """Prove that the small turn at t = 0 is the given one."""
    given = symbols("eta1 eta2 eta3")
    still = Part(INTEGRALS.witness, relations=tuple(INTEGRALS.witness), reading=INTEGRALS.reading)
    turned = [x + y for x, y in zip(_cross(given, M), varied(M), strict=True)]
    along = " + ".join(f"{x}*{m}" for x, m in zip(given, M, strict=True))
    start = Part(
        witness=dict.fromkeys(map(str, given), "1"),
        definitions={**_texts(L, turned), "s_0": along, **ALONG},
        reading={str(x): f"component {k} of xi at t = 0" for k, x in enumerate(given, 1)},
    )
    builder.open(join("turned_start", *body, STATE, still, BESIDE, start, TURN, static=True))
    builder.claim("turned_start.turn", _texts(XI, given), ["37"])
