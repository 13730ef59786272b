"""The forms of the solution by name, made of the sequences of the ledger."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from types import MappingProxyType
from typing import Any

from sympy import Eq, Gt, Integer, Rational, S, oo, pi, sqrt

from rigidsym.errors import InputError
from rigidsym.solution._formulas import AXES
from rigidsym.solution._polhode import Regime, classify
from rigidsym.solution._symbolic.calculation import (
    Calculation,
    ExactMotion,
    choices,
    conditions_of,
    used,
)
from rigidsym.solution._symbolic.symbols import TIME, named
from rigidsym.solution._symbolic.theorem1 import theorem1
from rigidsym.solution._symbolic.value import Dynamics, Symbolic

_SIGNS = {
    "epsilon": "+1 when the axes (a, b, d) are right-handed, -1 when not",
    "sigma": "the sign of Omega_a at t = 0",
    "rho": "the sign of c_a - c_d",
    "chi": "the sign of -rho epsilon sigma Omega_d at t = 0, +1 where that is zero",
}
# The elementary form of a regime.
_SERVING = {
    Regime.SEPARATRIX: "separatrix",
    Regime.SYMMETRIC: "symmetric",
    Regime.SPHERICAL: "sphere",
    Regime.SPIN: "spin",
    Regime.REST: "spin",
}
_BETWEEN = (Regime.LARGEST, Regime.SMALLEST)
_IDENTITY = {"p_0": S.One, **{f"p_{x}": S.Zero for x in AXES}}
# m and 1 - m on the edges.
_EDGES = {"separatrix": (1, 0), "symmetric": (0, 1)}


Maker = Callable[[str, ExactMotion | None], Symbolic]


def symbolic(form: str) -> Symbolic:
    """Return a form of the solution with free symbols.

    Parameters
    ----------
    form : str
        "theorem1", "pi", "theta", "separatrix", "symmetric", "sphere" or "spin".

    Returns
    -------
    Symbolic
        Attitude and body rates as SymPy's expressions of the time.

    Raises
    ------
    InputError
        For an unknown form.

    Examples
    --------
    >>> solution = symbolic("pi")
    >>> solution.q(0).shape, solution.omega().free_symbols >= {solution.t}
    ((4, 1), True)
    """
    return _maker(form)(form, None)


def of_motion(
    form: str | None,
    inertia: Sequence[Fraction],
    omega0: Sequence[Fraction],
    attitude0: Sequence[Fraction],
) -> Symbolic:
    """Return a form with a motion's exact numbers; for None, the form that serves its regime.

    Raises InputError for an unknown form, and for one that does not hold in the motion's regime.
    """
    polhode = classify(inertia, omega0)
    serving = _SERVING.get(polhode.regime, "pi")
    form = serving if form is None else form
    make = _maker(form)
    if polhode.regime not in FORMS[form].regimes:
        rule = f"does not hold here: the motion's regime is {polhode.regime}; "
        raise InputError("form", repr(form), f"{rule}{serving} serves")
    moments, rates, start = (
        tuple(Rational(x.numerator, x.denominator) for x in numbers)
        for numbers in (inertia, omega0, attitude0)
    )
    size = sqrt(sum(x * x for x in start))
    unit = tuple(x / size for x in start)
    return make(form, ExactMotion(moments, rates, unit, polhode, (inertia, omega0)))


def _maker(form: str) -> Maker:
    if not isinstance(form, str) or form not in FORMS:
        raise InputError("form", repr(form), f"must be one of: {', '.join(FORMS)}")
    return FORMS[form].make


def _regular(form: str, given: ExactMotion | None) -> Symbolic:
    """Return a form by the axes a, b and d: pi, theta, or one of the two edges."""
    work = Calculation(exact=given is not None)
    _begin(work, form, given)
    by_thetas = form == "theta"
    state = ("circular_state", "momentum", "theta", "circular") if by_thetas else ("state",)
    wanted = used(*state) | {"H", "K", "m", "m_1", "lambda_", "psi_0", "mu", "kappa", "n", "m_c"}
    work.compute("constants", wanted - {*_IDENTITY} if by_thetas else wanted)
    if by_thetas:
        _thetas(work)
        at = work.work_out("circular_state", {"t": TIME})
        at = work.work_out("momentum", at)
    else:
        # J_0 is written out.  At t = 0 it cancels; two named numbers would only be equal to as many
        # digits as are evaluated.
        at = work.work_out("state", {"t": TIME, "J_0": work.constants[named("J_0")]})
    axes: Sequence[str] = AXES
    if given is not None:
        axes = [AXES[given.polhode.axes.index(k)] for k in range(3)]
    known = work.known
    holds = (*conditions_of("rates_start", known, _SIGNS), *choices(known))
    holds += () if form in _EDGES else (Gt(known["m"], 0), Gt(known["m_1"], 0))
    return work.solution(
        form,
        given,
        holds,
        _SIGNS,
        _quantities(work, form),
        [at[f"q_{x}"] for x in ("0", *axes)],
        [at[f"Omega_{x}"] for x in axes],
        Dynamics(
            tuple(known[f"c_{x}"] for x in axes),
            tuple(known[f"q_{x}"] for x in ("0", *axes)),
            tuple(known[f"Omega_{x}"] for x in axes),
            known["epsilon"] if given is None else S.One,
        ),
    )


def _begin(work: Calculation, form: str, given: ExactMotion | None) -> None:
    """Name the inputs of the constants."""
    names = [f"{c}_{x}" for c in ("c", "Omega") for x in AXES]
    names += ["q_0", *(f"q_{x}" for x in AXES), *_SIGNS]
    if given is None:
        work.known |= {name: named(name) for name in names}
    else:
        axes, q = given.polhode.axes, given.attitude0
        put = [given.inertia[k] for k in axes] + [given.omega0[k] for k in axes]
        put += [q[0], *(q[k + 1] for k in axes)]
        put += [Integer(getattr(given.polhode, name)) for name in _SIGNS]
        for name, value in zip(names, put, strict=True):
            work.name(name, value)
    work.known |= {"t": S.Zero, "cos_half_psi": S.One, "sin_half_psi": S.Zero}
    if form in _EDGES:
        for name, value in zip(("m", "m_1"), _EDGES[form], strict=True):
            work.name(name, Integer(value))


def _thetas(work: Calculation) -> None:
    """Add the constants of the theta form and its quaternion in front: psi does not start at 0."""
    work.compute("theta", used("circular_state", "circular") | {"Lambda"})
    work.compute("circular")
    begin = work.work_out("circular_state", {"t": S.Zero, **_IDENTITY})
    start = {name: work.known[name] for name in ("q_0", *(f"q_{x}" for x in AXES))}
    front = work.work_out("pull_back", {**begin, **start})
    for name in _IDENTITY:
        work.name(name, front[name])


def _quantities(work: Calculation, form: str) -> dict[str, Any]:
    """Return energy, momentum, modulus and parameter, the period of the rates and mean rates."""
    known = work.known
    found = {
        "energy": known["H"],
        "momentum": known["K"],
        "parameter": known["m"],
        "modulus": sqrt(known["m"]),
    }
    if form == "separatrix":
        return {**found, "period": oo, "mean_circulation_rate": S.Zero}
    if form == "symmetric":
        period, mean, along = 2 * pi / known["mu"], known["psi_0"], known["sigma"] * known["A_a"]
    else:
        # The facts of the solution are those of the state alone.
        at = replace(work, facts={}).work_out("periods", {})
        period, mean, along = at["period"], at["psi_mean"], at["Omega_mean"]
    return {
        **found,
        "period": period,
        "mean_circulation_rate": along,
        "circulation_rate": 2 * pi / period,
        "precession_rate": mean,
        "phase_per_period": mean * period,
        "solid_angle": 2 * known["H"] * period / known["K"] - mean * period,
    }


def _steady(form: str, given: ExactMotion | None) -> Symbolic:
    """Return a form with constant rates: the attitude is one exponential."""
    work = Calculation(exact=given is not None)
    names = [*(f"{c}{k}" for c in ("c", "Omega") for k in (1, 2, 3)), *(f"p{k}" for k in range(4))]
    if given is None:
        work.known |= {name: named(name) for name in names}
    else:
        numbers = (*given.inertia, *given.omega0, *given.attitude0)
        for name, value in zip(names, numbers, strict=True):
            work.name(name, value)
    known = work.known
    holds = conditions_of("steady", known, names[:6])
    c, rates, start = names[:3], names[3:6], names[6:]
    work.compute("steady", ("omega",))
    attitude = [known[x] for x in start]
    if known["omega"] != 0:
        at = work.work_out("steady", {"t": TIME}, ("omega",))
        attitude = [at[f"q{k}"] for k in range(4)]
    if form == "sphere":
        holds = (*(Eq(known[x], known[y]) for x, y in pairwise(c)), *holds)
    work.compute("theorem1", ("H", "K"))
    moments, rates, start = (tuple(known[x] for x in part) for part in (c, rates, start))
    return work.solution(
        form,
        given,
        holds,
        {},
        {"energy": known["H"], "momentum": known["K"], "precession_rate": known["omega"]},
        attitude,
        rates,
        Dynamics(moments, start, rates),
    )


@dataclass(frozen=True, slots=True)
class _Form:
    make: Maker
    regimes: tuple[Regime, ...]


FORMS: Mapping[str, _Form] = MappingProxyType(
    {
        "theorem1": _Form(theorem1, _BETWEEN),
        "pi": _Form(_regular, _BETWEEN),
        "theta": _Form(_regular, _BETWEEN),
        "separatrix": _Form(_regular, (Regime.SEPARATRIX,)),
        "symmetric": _Form(_regular, (Regime.SYMMETRIC,)),
        "sphere": _Form(_steady, (Regime.SPHERICAL, Regime.REST)),
        "spin": _Form(_steady, (Regime.SPIN, Regime.SPHERICAL, Regime.REST)),
    }
)
