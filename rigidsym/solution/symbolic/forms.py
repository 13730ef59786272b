"""The forms by name: which sequences of the ledger make each, and of which motions."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import Any

from sympy import Integer, Rational, S, oo, pi, sqrt

from rigidsym.errors import InputError
from rigidsym.solution import sines
from rigidsym.solution.formulas import AXES
from rigidsym.solution.polhode import Regime, classify
from rigidsym.solution.symbolic import conditions
from rigidsym.solution.symbolic.given import Given
from rigidsym.solution.symbolic.sheet import Sheet, used
from rigidsym.solution.symbolic.symbols import TIME, named
from rigidsym.solution.symbolic.taylor import Dynamics
from rigidsym.solution.symbolic.theorem1 import theorem1
from rigidsym.solution.symbolic.value import Symbolic, column

_SIGNS = {
    "epsilon": "+1 when the axes (a, b, d) are right-handed, -1 when not",
    "sigma": "the sign of Omega_a at t = 0",
    "rho": "the sign of c_a - c_d",
    "chi": "the sign of -rho epsilon sigma Omega_d at t = 0, +1 where that is zero",
}
_BETWEEN = (Regime.LARGEST, Regime.SMALLEST)
_IDENTITY = {"p_0": S.One, **{f"p_{x}": S.Zero for x in AXES}}
# m and 1 - m on the edges.
_EDGES = {"separatrix": (1, 0), "symmetric": (0, 1)}


Maker = Callable[[str, Given | None], Symbolic]


def symbolic(form: str) -> Symbolic:
    """A form with free symbols; raises InputError for an unknown one.

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
    """A form with a motion's exact numbers; the one that serves its regime where None is asked for.

    Raises InputError for an unknown form, and for one that the motion's regime has not.
    """
    polhode = classify(inertia, omega0)
    form = sines.serving(polhode.regime) if form is None else form
    make = _maker(form)
    if polhode.regime not in FORMS[form].regimes:
        rule = f"does not hold here: the motion's regime is {polhode.regime}; "
        raise InputError("form", repr(form), f"{rule}{sines.serving(polhode.regime)} serves")
    moments, rates, start = (
        tuple(Rational(x.numerator, x.denominator) for x in numbers)
        for numbers in (inertia, omega0, attitude0)
    )
    size = sqrt(sum(x * x for x in start))
    unit = tuple(x / size for x in start)
    return make(form, Given(moments, rates, unit, polhode, (inertia, omega0)))


def _maker(form: str) -> Maker:
    if not isinstance(form, str) or form not in FORMS:
        raise InputError("form", repr(form), f"must be one of: {', '.join(FORMS)}")
    return FORMS[form].make


def _regular(form: str, given: Given | None) -> Symbolic:
    """By the axes a, b and d: the integral of the third kind, the thetas, and the edges."""
    sheet = Sheet(exact=given is not None)
    _begin(sheet, form, given)
    by_thetas = form == "theta"
    state = ("circular_state", "momentum", "theta", "circular") if by_thetas else ("state",)
    wanted = used(*state) | {"H", "K", "m", "m_1", "lambda_", "psi_0", "mu", "kappa", "n", "m_c"}
    sheet.compute("constants", wanted - {*_IDENTITY} if by_thetas else wanted)
    if by_thetas:
        _thetas(sheet)
        at = sheet.work_out("circular_state", {"t": TIME})
        at = sheet.work_out("momentum", at)
    else:
        # J_0 written out: at t = 0 it cancels, where two names would be two numbers that are equal
        # to as many digits as anybody asks for.
        at = sheet.work_out("state", {"t": TIME, "J_0": sheet.constants[named("J_0")]})
    order = (0, 1, 2)
    if given is not None:
        order = tuple(given.polhode.axes.index(k) for k in range(3))
    known = sheet.known
    holds = (*conditions.of_context("rates_start", known, _SIGNS), *conditions.choices(known))
    holds += () if form in _EDGES else conditions.between(known)
    return Symbolic(
        form=form,
        regime=given.polhode.regime if given else None,
        constants=MappingProxyType(sheet.constants),
        conditions=conditions.told(holds),
        choices=MappingProxyType({named(name): text for name, text in _SIGNS.items()}),
        facts=tuple(sheet.facts),
        quantities=MappingProxyType(_quantities(sheet, form)),
        attitude=column([at["q_0"], *(at[f"q_{AXES[k]}"] for k in order)]),
        rates=column([at[f"Omega_{AXES[k]}"] for k in order]),
        dynamics=_dynamics(sheet, given, [AXES[k] for k in order]),
    )


def _dynamics(sheet: Sheet, given: Given | None, axes: Sequence[str]) -> Dynamics:
    """By the axes in the order of the columns: with numbers, those of the body."""
    known = sheet.known
    return Dynamics(
        tuple(known[f"c_{x}"] for x in axes),
        tuple(known[f"q_{x}"] for x in ("0", *axes)),
        tuple(known[f"Omega_{x}"] for x in axes),
        known["epsilon"] if given is None else S.One,
    )


def _begin(sheet: Sheet, form: str, given: Given | None) -> None:
    """What the constants are computed from."""
    names = [f"{c}_{x}" for c in ("c", "Omega") for x in AXES]
    names += ["q_0", *(f"q_{x}" for x in AXES), *_SIGNS]
    if given is None:
        sheet.known |= {name: named(name) for name in names}
    else:
        axes, q = given.polhode.axes, given.attitude0
        put = [given.inertia[k] for k in axes] + [given.omega0[k] for k in axes]
        put += [q[0], *(q[k + 1] for k in axes)]
        put += [Integer(getattr(given.polhode, name)) for name in _SIGNS]
        for name, value in zip(names, put, strict=True):
            sheet.name(name, value)
    sheet.known |= {"t": S.Zero, "cos_half_psi": S.One, "sin_half_psi": S.Zero}
    if form in _EDGES:
        for name, value in zip(("m", "m_1"), _EDGES[form], strict=True):
            sheet.name(name, Integer(value))


def _thetas(sheet: Sheet) -> None:
    """The constants of the theta form, and the quaternion in front: psi does not start at 0."""
    sheet.compute("theta", used("circular_state", "circular") | {"Lambda"})
    sheet.compute("circular")
    begin = sheet.work_out("circular_state", {"t": S.Zero, **_IDENTITY})
    start = {name: sheet.known[name] for name in ("q_0", *(f"q_{x}" for x in AXES))}
    front = sheet.work_out("pull_back", {**begin, **start})
    for name in _IDENTITY:
        sheet.name(name, front[name])


def _quantities(sheet: Sheet, form: str) -> dict[str, Any]:
    """Energy, momentum, modulus and parameter; the period of the rates and what goes with it."""
    known = sheet.known
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
        at = sheet.work_out("periods", {})
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


def _steady(form: str, given: Given | None) -> Symbolic:
    """One exponential: rates are constant."""
    sheet = Sheet(exact=given is not None)
    names = [*(f"{c}{k}" for c in ("c", "Omega") for k in (1, 2, 3)), *(f"p{k}" for k in range(4))]
    if given is None:
        sheet.known |= {name: named(name) for name in names}
    else:
        numbers = (*given.inertia, *given.omega0, *given.attitude0)
        for name, value in zip(names, numbers, strict=True):
            sheet.name(name, value)
    holds = conditions.of_context("steady", sheet.known, names[:6])
    known = sheet.known
    rates = [known[f"Omega{k}"] for k in (1, 2, 3)]
    sheet.compute("steady", ("omega",))
    if known["omega"] == 0:
        attitude = [known[f"p{k}"] for k in range(4)]
    else:
        at = sheet.work_out("steady", {"t": TIME}, ("omega",))
        attitude = [at[f"q{k}"] for k in range(4)]
    if form == "sphere":
        holds = conditions.told((*conditions.spheres(known), *holds))
    sheet.compute("theorem1", ("H", "K"))
    return Symbolic(
        form=form,
        regime=given.polhode.regime if given else None,
        constants=MappingProxyType(sheet.constants),
        conditions=holds,
        choices=MappingProxyType({}),
        facts=tuple(sheet.facts),
        quantities=MappingProxyType(
            {
                "energy": known["H"],
                "momentum": known["K"],
                "precession_rate": known["omega"],
            }
        ),
        attitude=column(attitude),
        rates=column(rates),
        dynamics=Dynamics(
            tuple(known[f"c{k}"] for k in (1, 2, 3)),
            tuple(known[f"p{k}"] for k in range(4)),
            tuple(rates),
        ),
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
