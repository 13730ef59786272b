"""The forms of the closed-form solution in SymPy, built from the ledger's formulas."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from types import MappingProxyType
from typing import Any

from sympy import Eq, Ge, Gt, Integer, Rational, S, oo, pi, sqrt

from rigidsym.errors import InputError, unknown
from rigidsym.language._expression import parse
from rigidsym.solution._formulas import AXES
from rigidsym.solution._polhode import Regime, classify
from rigidsym.solution._symbolic.calculation import (
    Calculation,
    ExactMotion,
    conditions_of,
    evaluated,
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
# What the signs require: these products are not negative at t = 0.
_CHOSEN = ("sigma*Omega_a", "rho*(c_a - c_d)", "chi*tau*Omega_d")
_IDENTITY = {"p_0": S.One, **{f"p_{x}": S.Zero for x in AXES}}
# m and 1 - m on the edges.
_EDGES = {"separatrix": {"m": 1, "m_1": 0}, "symmetric": {"m": 0, "m_1": 1}}

Maker = Callable[[Calculation], Symbolic]


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
    return _form(form)[0](Calculation(form, None))


def of_motion(
    form: str | None,
    inertia: Sequence[Fraction],
    omega0: Sequence[Fraction],
    attitude0: Sequence[Fraction],
) -> Symbolic:
    """Return a form of the solution with a motion's exact numbers.

    For None, take the form that serves the motion's regime.  Raises InputError for an unknown form,
    and for one that does not hold in this regime.
    """
    polhode = classify(inertia, omega0)
    serving = _SERVING.get(polhode.regime, "pi")
    form = serving if form is None else form
    make, regimes = _form(form)
    if polhode.regime not in regimes:
        rule = f"does not hold here: the motion's regime is {polhode.regime}; "
        raise InputError("form", repr(form), f"{rule}{serving} serves")
    moments, rates, start = (
        tuple(Rational(x.numerator, x.denominator) for x in numbers)
        for numbers in (inertia, omega0, attitude0)
    )
    size = sqrt(sum(x * x for x in start))
    unit = tuple(x / size for x in start)
    given = ExactMotion(moments, rates, unit, polhode, (inertia, omega0))
    return make(Calculation(form, given))


def _form(form: str) -> tuple[Maker, tuple[Regime, ...]]:
    if not isinstance(form, str) or form not in FORMS:
        raise unknown("form", form, FORMS)
    return FORMS[form]


def _regular(work: Calculation) -> Symbolic:
    """Return the solution in the form `pi`, `theta`, `separatrix` or `symmetric`.

    It is in the axes a, b and d.
    """
    form, known, given = work.form, work.known, work.given
    names = [f"{c}_{x}" for c in ("c", "Omega") for x in AXES]
    names += ["q_0", *(f"q_{x}" for x in AXES), *_SIGNS]
    numbers: list[Any] = []
    if given:
        numbers = given.numbers(given.polhode.axes)
        numbers += [Integer(getattr(given.polhode, name)) for name in _SIGNS]
    work.begin(names, numbers)
    known |= {"t": S.Zero, "cos_half_psi": S.One, "sin_half_psi": S.Zero}
    for name, value in _EDGES.get(form, {}).items():
        work.name(name, Integer(value))
    by_thetas = form == "theta"
    state = ("circular_state", "momentum", "theta", "circular") if by_thetas else ("state",)
    wanted = used(*state) | {"H", "K", "m", "m_1", "lambda_", "psi_0", "mu", "kappa", "n", "m_c"}
    work.compute("constants", wanted - {*_IDENTITY} if by_thetas else wanted)
    if by_thetas:
        _thetas(work)
        at = work.work_out("momentum", work.work_out("circular_state", {"t": TIME}))
    else:
        # J_0 is written out.  At t = 0 it cancels; two named numbers would only be equal to as many
        # digits as are evaluated.
        at = work.work_out("state", {"t": TIME, "J_0": work.constants[named("J_0")]})
    axes: Sequence[str] = AXES
    if given:
        axes = [AXES[given.polhode.axes.index(k)] for k in range(3)]
    moments, rates, attitude = (
        [f"{letter}_{x}" for x in names]
        for letter, names in (("c", axes), ("Omega", axes), ("q", ("0", *axes)))
    )
    holds = [*conditions_of("rates_start", known, _SIGNS)]
    holds += (Ge(evaluated(parse(text), known), 0) for text in _CHOSEN)
    if form not in _EDGES:
        holds += (Gt(known["m"], 0), Gt(known["m_1"], 0))
    return work.solution(
        [at[name] for name in attitude],
        [at[name] for name in rates],
        holds,
        _SIGNS,
        _quantities(work),
        Dynamics(
            work.values(*moments),
            work.values(*attitude),
            work.values(*rates),
            S.One if given else known["epsilon"],
        ),
    )


def _thetas(work: Calculation) -> None:
    """Add the constants of the theta form, including its constant quaternion."""
    work.compute("theta", used("circular_state", "circular") | {"Lambda"})
    work.compute("circular")
    begin = work.work_out("circular_state", {"t": S.Zero, **_IDENTITY})
    start = {name: work.known[name] for name in ("q_0", *(f"q_{x}" for x in AXES))}
    front = work.work_out("pull_back", {**begin, **start})
    for name in _IDENTITY:
        work.name(name, front[name])


def _quantities(work: Calculation) -> dict[str, Any]:
    """Return energy, momentum, modulus, period and mean rates by name."""
    form, known = work.form, work.known
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


def _steady(work: Calculation) -> Symbolic:
    """Return the solution with constant rates, of a sphere or a spin about a principal axis.

    Its attitude is one exponential.
    """
    moments, rates = ([f"{letter}{k}" for k in (1, 2, 3)] for letter in ("c", "Omega"))
    start, known = ["p0", "p1", "p2", "p3"], work.known
    work.begin([*moments, *rates, *start], work.given.numbers() if work.given else ())
    holds = [*conditions_of("steady", known, (*moments, *rates))]
    work.compute("steady", ("omega",))
    dynamics = Dynamics(work.values(*moments), work.values(*start), work.values(*rates))
    attitude = dynamics.attitude0
    if known["omega"] != 0:
        at = work.work_out("steady", {"t": TIME}, ("omega",))
        attitude = tuple(at[f"q{k}"] for k in range(4))
    if work.form == "sphere":
        holds = [*(Eq(x, y) for x, y in pairwise(dynamics.moments)), *holds]
    work.compute("theorem1", ("H", "K"))
    quantities = {"energy": known["H"], "momentum": known["K"], "precession_rate": known["omega"]}
    return work.solution(attitude, dynamics.omega0, holds, {}, quantities, dynamics)


# Each form by name: its function, and the regimes that it holds in.
FORMS: Mapping[str, tuple[Maker, tuple[Regime, ...]]] = MappingProxyType(
    {
        "theorem1": (theorem1, _BETWEEN),
        "pi": (_regular, _BETWEEN),
        "theta": (_regular, _BETWEEN),
        "separatrix": (_regular, (Regime.SEPARATRIX,)),
        "symmetric": (_regular, (Regime.SYMMETRIC,)),
        "sphere": (_steady, (Regime.SPHERICAL, Regime.REST)),
        "spin": (_steady, (Regime.SPIN, Regime.SPHERICAL, Regime.REST)),
    }
)
