"""Derivatives of rates and attitude with respect to initial rates and moments.

They follow from the ledger's formulas.

Numbers are of any kind that mixes with integers.  Columns have the names of the inputs: Omega1 to
Omega3, c1 to c3.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, TypeAlias

from flint import arb

from rigidsym.language._sequence import FormulaSequence, Functions
from rigidsym.precise._balls import ball, power
from rigidsym.precise._functions import Functions as BallFunctions
from rigidsym.precise._functions import Theta
from rigidsym.precise._sensitivity.elapsed import elapsed
from rigidsym.solution._formulas import AXES, sequence
from rigidsym.solution._partition import handedness
from rigidsym.solution._polhode import discriminant

# Quantities by the names of formulas.
Named: TypeAlias = dict[str, Any]
NUMBERS = (1, 2, 3)
KINDS = ("Omega", "c")
INPUTS = tuple(f"{x}{k}" for x in KINDS for k in NUMBERS)
EXCESSES = tuple(f"excess_{x}" for x in AXES)
_COEFFICIENTS = (*(f"alpha_{x}" for x in AXES), "tilt")
_ROTATION = frozenset(f"R{i}{k}" for i in NUMBERS for k in NUMBERS)
_PARAMETERS = ("p", "r", "apart")
# Changes of rates with p and r alike, and with r alone.
_WAYS = tuple(f"Omega_{x}_{way}" for x in AXES for way in "kr")


@dataclass(frozen=True)
class Columns:
    """Formulas for the derivatives of a motion's states by each initial rate and moment.

    A column has the derivatives by one input.

    inertia, omega0, start: moments (3), rates (3) and unit attitude (4) at t = 0. axes: the indices
    of the axes a, b, d.
    is_sphere: the rates are constant.
    product: the product of all rates at any time, given where moments may be equal.
    """

    inertia: Sequence[Any]
    omega0: Sequence[Any]
    start: Sequence[Any]
    axes: Sequence[int]
    functions: Functions
    is_sphere: bool = False
    product: Any = None

    @cached_property
    def constants(self) -> Mapping[str, Any]:
        """The constants in the formulas of the rates and their derivatives.

        They include p, r and `apart` = p - r.
        """
        known = _lettered(self.inertia, self.omega0, self.axes)
        return self._of("columns", self._of("moments", known))

    def rates(self, t: Any, elapsed: Mapping[str, Any]) -> Named:
        """Return the rates at a time with their derivatives and the integrals of their squares.

        Derivatives are columns, integrals are excesses.

        elapsed: the functions of elapsed time.
        Names have the numbers of the axes.  An excess is the integral of the square of a rate, less
        that of its value at t = 0.  A column is

            Omega1_by_c1 = Omega1_at_c1 + p_by_c1 Omega1_k - apart_by_c1 Omega1_r,

        where the first term is the change with the functions of elapsed time held fixed.
        """
        ways, rest = _formulas()
        found = ways.evaluate({**self.constants, **elapsed, "t": t}, self.functions)
        ahead = rest.evaluate({**found, **dict.fromkeys(_WAYS, 0)}, self.functions)
        ahead |= self._excesses(t, ahead)
        known: Named = {}
        for x, k in self._numbered:
            known |= {f"Omega{k}": found[f"Omega_{x}"], f"excess{k}": ahead[f"excess_{x}"]}
            known |= {f"Omega{k}_{way}": found[f"Omega_{x}_{way}"] for way in "kr"}
        for y, j in self._numbered:
            for z in KINDS:
                for parameter in ("p", "apart"):
                    known[f"{parameter}_by_{z}{j}"] = self._by(parameter, f"{z}_{y}")
                for x, k in self._numbered:
                    known[f"Omega{k}_at_{z}{j}"] = ahead[f"Omega_{x}_by_{z}_{y}"]
        for k in NUMBERS:
            for name in INPUTS:
                known[f"Omega{k}_by_{name}"] = (
                    known[f"Omega{k}_at_{name}"]
                    + known[f"p_by_{name}"] * known[f"Omega{k}_k"]
                    - known[f"apart_by_{name}"] * known[f"Omega{k}_r"]
                )
        return known

    def _by(self, parameter: str, name: str) -> Any:
        """Return the derivative of an elliptic parameter, p or p - r, with respect to an input.

        Each rate changes p or r alone.
        """
        alone = {"Omega_b": 0, "Omega_a": self.constants["p_by_Omega_a"]}
        if parameter == "apart" and name in (*alone, "Omega_d"):
            return alone.get(name, -self.constants["r_by_Omega_d"])
        return self.constants.get(f"{parameter}_by_{name}", 0)

    def _excesses(self, t: Any, found: Named) -> Named:
        """Return the integrals of the excess of each squared rate over its value at t = 0.

        They follow from (Omega_x^2)' = 2 alpha_x Omega_a Omega_b Omega_d.
        """
        if self.is_sphere:
            return dict.fromkeys(EXCESSES, 0)
        if self.product is None:
            return self._of("excesses", found)
        return {f"excess_{x}": self.constants[f"alpha_{x}"] * (t * t * self.product) for x in AXES}

    def turned(self, t: Any, rates: Mapping[str, Any], attitude: Sequence[Any]) -> Named:
        """Return the derivatives of the attitude as small turns in space.

        Those by the time and the rotation matrix are returned as well.
        """
        known = {**self.begun, **rates, **{f"q{k}": x for k, x in enumerate(attitude)}}
        return self._of("turn", {**known, "t": t})

    def rotation(self, attitude: Sequence[Any]) -> Named:
        """Return the entries R11 to R33 of an attitude's rotation matrix, from body to space."""
        known = {f"q{k}": x for k, x in enumerate(attitude)}
        return sequence("turn").up_to(_ROTATION).evaluate(known, self.functions)

    @property
    def _numbered(self) -> list[tuple[str, int]]:
        return [(x, k + 1) for x, k in zip(AXES, self.axes, strict=True)]

    @cached_property
    def begun(self) -> Mapping[str, Any]:
        """The constants in the derivatives of the attitude."""
        known: Named = {f"p{k}": x for k, x in enumerate(self.start)}
        for k, (c, w) in enumerate(zip(self.inertia, self.omega0, strict=True), 1):
            known |= {f"c{k}": c, f"Omega{k}_0": w}
        return self._of("turn_constants", known)

    def _of(self, name: str, known: Mapping[str, Any]) -> Named:
        return sequence(name).evaluate(known, self.functions)


@cache
def _formulas() -> tuple[FormulaSequence, FormulaSequence]:
    """Return the formulas of sensitivities as two sequences.

    The first has the changes with p and r alone, the second all others but f = D_t F_t.
    """
    formulas = [x for x in sequence("sensitivity").formulas if x[0] != "f"]
    ways = FormulaSequence(formulas).up_to(frozenset([*_WAYS, *(f"Omega_{x}" for x in AXES)]))
    names = {name for name, _ in ways.formulas}
    return ways, FormulaSequence(x for x in formulas if x[0] not in names)


def axes_of(inertia: Sequence[Fraction], omega0: Sequence[Fraction]) -> tuple[int, ...]:
    """Return the indices of a motion's circulation axis, middle axis and third axis.

    They are a, b and d, and 0 <= r <= p.
    """
    order = sorted(range(3), key=lambda k: inertia[k], reverse=True)
    return tuple(order if discriminant(inertia, omega0) >= 0 else order[::-1])


def parameters(
    inertia: Sequence[Fraction], omega0: Sequence[Fraction], axes: Sequence[int]
) -> list[Fraction]:
    """Return the exact parameters p, r and p - r of a motion's elliptic functions."""
    known: Named = _lettered(inertia, omega0, axes)
    for name, wanted in (("moments", _COEFFICIENTS), ("columns", _PARAMETERS)):
        formulas = sequence(name).up_to(frozenset(wanted))
        known = formulas.evaluate_exactly(known, {"power": pow}, Fraction)
    return [Fraction(known[name]) for name in _PARAMETERS]


def _lettered(inertia: Sequence[Any], omega0: Sequence[Any], axes: Sequence[int]) -> Named:
    """Name moments and rates by the axis letters a, b and d, as formulas do."""
    known: Named = {"epsilon": handedness(*axes)}
    for x, k in zip(AXES, axes, strict=True):
        known |= {f"c_{x}": inertia[k], f"Omega_{x}0": omega0[k]}
    return known


TURN = [f"q{k}" for k in range(4)]
RATES = [f"Omega{k}" for k in NUMBERS]


@dataclass(frozen=True)
class TurnColumns:
    """Derivatives of the turn since t = 0 along directions in input space, in body axes.

    In the body no wide number is multiplied by another; in the columns of `Columns.turned`, seen
    in space, the attitude turns all uncertainty of the rates.

    directions: the components of each direction (m), by the names of inputs.
    """

    columns: Columns
    t: Any
    rates: Mapping[str, Any]
    directions: Mapping[str, Sequence[arb]]

    def of(self, turn: Sequence[Any]) -> list[list[Any]]:
        """Return the derivatives (4, m) of a turn along each direction.

        The turn is a quaternion (4).
        """
        rotation = self.columns.rotation(turn)
        known = {**rotation, **self._given}
        found = []
        for change, momentum in self._changes:
            seen = {
                f"l{i}": combined(momentum, [rotation[f"R{k}{i}"] for k in NUMBERS])
                for i in NUMBERS
            }
            column = sequence("turned_body").evaluate(
                {**known, **change, **seen}, self.columns.functions
            )
            found.append([column[f"d{x}"] for x in TURN])
        return [list(row) for row in zip(*found, strict=True)]

    @property
    def of_rates(self) -> list[list[Any]]:
        """The derivatives (3, m) of the rates along each direction."""
        return [[change[f"d{x}"] for change, _ in self._changes] for x in RATES]

    @cached_property
    def _given(self) -> Named:
        known: Named = {"K": self.columns.begun["K_squared"].sqrt()}
        for k, c in enumerate(self.columns.inertia, 1):
            known |= {f"c{k}": c, f"Omega{k}": self.rates[f"Omega{k}"]}
        return known

    @cached_property
    def _changes(self) -> list[tuple[Named, list[Any]]]:
        """The derivatives of rates, moments and initial momentum along each direction.

        They do not depend on the turn.
        """
        return [self._change(parts) for parts in zip(*self.directions.values(), strict=True)]

    def _change(self, parts: Sequence[arb]) -> tuple[Named, list[Any]]:
        """Return the derivatives of rates and momentum along one direction of the inputs."""
        share = dict(zip(self.directions, parts, strict=True))
        change: Named = {}
        ways = {
            way: combined(parts, [self.rates[f"{parameter}_by_{name}"] for name in share])
            for way, parameter in (("k", "p"), ("r", "apart"))
        }
        for x in RATES:
            values = [self.rates[f"{x}_at_{name}"] for name in share]
            change[f"d{x}"] = (
                combined(parts, values)
                + ways["k"] * self.rates[f"{x}_k"]
                - ways["r"] * self.rates[f"{x}_r"]
            )
        momentum, along = [], []
        for k, (c, w) in enumerate(zip(self.columns.inertia, self.columns.omega0, strict=True), 1):
            by_rate, by_moment = (share.get(f"{x}{k}", arb(0)) for x in KINDS)
            change[f"dc{k}"] = by_moment
            momentum.append(combined([by_rate, by_moment], [c, w]))
            excess = self.rates[f"excess{k}"] / -2
            along.append(combined([by_rate * self.t, by_moment], [c * w, excess]))
        return {**change, "s": combined([arb(1)] * 3, along)}, momentum


def combined(parts: Sequence[Any], values: Sequence[Any]) -> Any:
    """Return a linear combination of values, without terms whose coefficient is zero."""

    def is_zero(value: Any) -> bool:
        return not value if isinstance(value, int) else isinstance(value, arb) and value.is_zero()

    terms = [x * part for part, x in zip(parts, values, strict=True) if not is_zero(part)]
    return sum(terms[1:], terms[0]) if terms else 0


@dataclass(frozen=True)
class Point:
    """The sensitivities of one motion with exact moments and rates.

    There are three moments and three rates.

    The initial attitude is a unit quaternion.
    """

    inertia: Sequence[Fraction]
    omega0: Sequence[Fraction]
    start: Sequence[arb]

    def at(self, time: Fraction, attitude: Sequence[arb]) -> list[arb]:
        """Return the sensitivities at a time, given the attitude at that time.

        They are the numbers of `listed`.
        """
        t = ball(time)
        if not any(self.omega0):
            return listed(self._at_rest(t, attitude))
        functions = elapsed(t, *self._parameters, self._functions)
        rates = self._columns.rates(t, functions._asdict())
        return listed({**rates, **self._columns.turned(t, rates, attitude)})

    def _at_rest(self, t: arb, attitude: Sequence[arb]) -> Named:
        """Return the sensitivities of a body at rest.

        A small rate turns it steadily.
        """
        rotation = self._columns.rotation(attitude)
        known: Named = dict.fromkeys(NAMES, 0)
        for i in NUMBERS:
            known[f"Omega{i}_by_Omega{i}"] = 1
            known |= {f"eta{i}_by_Omega{k}": t * rotation[f"R{i}{k}"] for k in NUMBERS}
        return known

    @cached_property
    def _functions(self) -> BallFunctions:
        return Theta()

    @cached_property
    def _axes(self) -> Sequence[int]:
        return axes_of(self.inertia, self.omega0)

    @cached_property
    def _parameters(self) -> list[arb]:
        """The parameters p, r and p - r of elliptic functions, as balls.

        They are exactly zero where they are zero.
        """
        return list(map(ball, parameters(self.inertia, self.omega0, self._axes)))

    @cached_property
    def _columns(self) -> Columns:
        inertia, omega0 = (list(map(ball, values)) for values in (self.inertia, self.omega0))
        is_sphere = len({*self.inertia}) == 1
        return Columns(inertia, omega0, self.start, self._axes, {"power": power}, is_sphere)


BY_TIME = [f"{x}{k}_by_t" for x in ("eta", "Omega") for k in NUMBERS]
_BY_INPUTS = (*(f"eta{k}" for k in NUMBERS), *INPUTS)
NAMES = [*(f"{x}{i}_by_{y}" for x in ("eta", "Omega") for i in NUMBERS for y in _BY_INPUTS),
         *BY_TIME]  # fmt: skip
# A small turn in space at t = 0 stays as it is, and does not change the rates.
STAYS = {f"{x}{i}_by_eta{k}": int(x == "eta" and i == k)
         for x in ("eta", "Omega") for i in NUMBERS for k in NUMBERS}  # fmt: skip


def listed(found: Mapping[str, Any]) -> list[arb]:
    """List the derivatives of attitude and rates in a fixed order.

    They are (3, 9) of a small turn in space and (3, 9) of the rates.

    These are by the small turn, rates and moments at t = 0; those by the time (3 each) follow.
    """
    known = {**found, **STAYS}
    return [ball(known[name]) for name in NAMES]
