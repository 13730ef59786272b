"""Theorem 1 as SymPy: rates by Lemma 1, phi1 by Pi, the mended halves, (18) and (37)."""

from types import MappingProxyType
from typing import Any

from sympy import Gt, Integer, N, Ne, S, im

from rigidsym.solution import sines
from rigidsym.solution.symbolic import conditions
from rigidsym.solution.symbolic.given import Given
from rigidsym.solution.symbolic.sheet import Sheet
from rigidsym.solution.symbolic.symbols import TIME, named
from rigidsym.solution.symbolic.taylor import Dynamics
from rigidsym.solution.symbolic.value import Symbolic, column

_ABD = ("0", "a", "b", "d")
_SERVE = "pi and theta serve"
_CYCLIC = ((1, 2), (2, 0), (0, 1))
_CHOICES = {
    "half_1": "the sign of xi_1 with which Omega1 starts, C_1 being a principal value (Remark 1)",
    "half_2": "the same of Omega2",
    "half_3": "the same of Omega3",
    "side": "the sign of Omega3, which does not change: where it does, another interval begins",
}


def theorem1(form: str, given: Given | None) -> Symbolic:
    """The paper's solution; over complex numbers for the rate that motions circulate about."""
    sheet = Sheet(exact=given is not None)
    _begin(sheet, given)
    parts = [_sine(sheet, given, i) for i in range(3)]
    rates = [part.work_out("sine_state", {"t": TIME})["Omega_i"] for part in parts]
    first = parts[0].known
    sheet.known |= {"C_1": first["C_i"], **{name: first[name] for name in ("zeta", "xi", "mu")}}
    sheet.compute("theorem1")
    side = named("side") if given is None else Integer(1 if given.exact[1][2] > 0 else -1)
    sheet.known["side"] = side
    moving = {f"Omega{k}": rate for k, rate in enumerate(rates, 1)}
    at = _turned(sheet, _by_angles(sheet, {**moving, "t": TIME}))
    holds = [*conditions.of_context("theorem1_motion", sheet.known, ("side",))]
    for part in parts:
        holds += conditions.of_context("one_rate", part.known, ("half",))
    holds.append(Gt(side * rates[2], 0))
    if side == -1:
        holds.append(Ne(rates[1], 0))
    known = sheet.known
    for part in parts:
        sheet.facts |= part.facts
    return Symbolic(
        form=form,
        regime=given.polhode.regime if given else None,
        constants=MappingProxyType(sheet.constants),
        conditions=conditions.told(holds),
        choices=MappingProxyType({named(name): text for name, text in _CHOICES.items()}),
        facts=tuple(sheet.facts),
        quantities=MappingProxyType({"energy": known["H"], "momentum": known["K"]}),
        attitude=column([at[f"q_{x}"] for x in _ABD]),
        rates=column(rates),
        dynamics=Dynamics(
            tuple(known[f"c{k}"] for k in (1, 2, 3)),
            tuple(known[f"q{k}"] for k in range(4)),
            tuple(known[f"Omega{k}"] for k in (1, 2, 3)),
        ),
    )


def _begin(sheet: Sheet, given: Given | None) -> None:
    names = [f"{c}{k}" for c in ("c", "Omega") for k in (1, 2, 3)] + [f"q{k}" for k in range(4)]
    if given is None:
        sheet.known |= {name: named(name) for name in names}
        return
    sines.check("form", "'theorem1'", given.polhode.regime, given.exact[1], _SERVE)
    for name, value in zip(names, (*given.inertia, *given.omega0, *given.attitude0), strict=True):
        sheet.name(name, value)


def _sine(sheet: Sheet, given: Given | None, i: int) -> Sheet:
    """The constants of one rate, with the number of its axis behind their names."""
    j, k = _CYCLIC[i] if given is None else sines.others(given.polhode, i)
    known: dict[str, Any] = {
        f"{letter}_{x}": sheet.known[f"{letter}{n + 1}"]
        for letter in ("c", "Omega")
        for x, n in zip("ijk", (i, j, k), strict=True)
    }
    name = f"half_{i + 1}"
    known["half"] = named(name) if given is None else Integer(sines.half(*given.exact, i))
    part = Sheet(sheet.exact, dict(known))
    inner = ("alpha", "root_j", "root_k", "zeta", "xi", "mu", "H", "K_squared")
    names = {n: f"{n}_{i + 1}" for n in inner} | {"C_i": f"C_{i + 1}"}
    part.compute("sine", rename=names)
    if given is not None and im(N(part.known["C_i"])) < 0:
        # SymPy's inverse beside the real line is the conjugate of the one that grows with xi.
        known["half"] *= -1
        part = Sheet(sheet.exact, dict(known))
        part.compute("sine", rename=names)
    sheet.constants |= part.constants
    return part


def _by_angles(sheet: Sheet, known: dict[str, Any]) -> dict[str, Any]:
    """The quaternion of (18), axes 1, 2, 3 being a, b, d."""
    found = sheet.work_out("theorem1_state", known)
    return {f"qbar_{x}": found[f"qbar_{k}"] for k, x in enumerate(_ABD)}


def _turned(sheet: Sheet, moving: dict[str, Any]) -> dict[str, Any]:
    """The constant quaternion of (37), and the attitude that starts where it should."""
    start = _by_angles(sheet, {"t": S.Zero})
    given = {f"q_{x}": sheet.known[f"q{k}"] for k, x in enumerate(_ABD)}
    front = sheet.work_out("pull_back", {**start, **given, "epsilon": S.One})
    for x in _ABD:
        sheet.name(f"p_{x}", front[f"p_{x}"])
    return sheet.work_out("turned", {**moving, "epsilon": S.One})
