"""How rates and attitude move with rates at t = 0 and moments: the ledger's formulas.

Numbers are of any kind that mixes with integers.  Columns are named as the inputs are: Omega1 to
Omega3, c1 to c3.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import Any, TypeAlias

from rigidsym.language.sequence import FormulaSequence, Functions
from rigidsym.solution.formulas import AXES, sequence
from rigidsym.solution.polhode import discriminant
from rigidsym.solution.signs import handedness

# By the names of formulas.
Named: TypeAlias = dict[str, Any]
NUMBERS = (1, 2, 3)
KINDS = ("Omega", "c")
INPUTS = tuple(f"{x}{k}" for x in KINDS for k in NUMBERS)
EXCESSES = tuple(f"excess_{x}" for x in AXES)
_COEFFICIENTS = (*(f"alpha_{x}" for x in AXES), "tilt")
_ROTATION = frozenset(f"R{i}{k}" for i in NUMBERS for k in NUMBERS)
_PARAMETERS = ("p", "r", "apart")
# How rates change with p and r alike, and with r alone.
_WAYS = tuple(f"Omega_{x}_{way}" for x in AXES for way in "kr")


@dataclass(frozen=True)
class Columns:
    """A motion: moments (3), rates (3) and unit attitude (4) at t = 0, and which axes are a, b, d.

    Of a sphere the rates stay as they are.  product: where moments may be equal, what the product
    of all rates is at any time.
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
        """Of the rates: p, r and `apart`, which is p - r, among them."""
        known = _lettered(self.inertia, self.omega0, self.axes)
        return self._of("columns", self._of("moments", known))

    def rates(self, t: Any, elapsed: Mapping[str, Any]) -> Named:
        """Rates and their columns, by the numbers of the axes, with the functions of elapsed time;
        and by what the integrals of their squares exceed those of the rates at t = 0.

        A column is  Omega1_at_c1 + p_by_c1 Omega1_k - apart_by_c1 Omega1_r,  where the first is
        what changes with functions of elapsed time as they are.
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
        """How p or p - r changes with an input; with rates r and p do alone."""
        alone = {"Omega_b": 0, "Omega_a": self.constants["p_by_Omega_a"]}
        if parameter == "apart" and name in (*alone, "Omega_d"):
            return alone.get(name, -self.constants["r_by_Omega_d"])
        return self.constants.get(f"{parameter}_by_{name}", 0)

    def _excesses(self, t: Any, found: Named) -> Named:
        """Half of a square's slope is alpha times the product of all rates: Euler's equations."""
        if self.is_sphere:
            return dict.fromkeys(EXCESSES, 0)
        if self.product is None:
            return self._of("excesses", found)
        return {f"excess_{x}": self.constants[f"alpha_{x}"] * (t * t * self.product) for x in AXES}

    def turned(self, t: Any, rates: Mapping[str, Any], attitude: Sequence[Any]) -> Named:
        """With the attitude then, columns of small turns in space; its matrix R, and the column of
        the time."""
        known = {**self.begun, **rates, **{f"q{k}": x for k, x in enumerate(attitude)}}
        return self._of("turn", {**known, "t": t})

    def rotation(self, attitude: Sequence[Any]) -> Named:
        """The matrix of an attitude, R11 to R33: from the body to space."""
        known = {f"q{k}": x for k, x in enumerate(attitude)}
        return sequence("turn").up_to(_ROTATION).evaluate(known, self.functions)

    @property
    def _numbered(self) -> list[tuple[str, int]]:
        return [(x, k + 1) for x, k in zip(AXES, self.axes, strict=True)]

    @cached_property
    def begun(self) -> Mapping[str, Any]:
        """What the attitude's columns have of t = 0."""
        known: Named = {f"p{k}": x for k, x in enumerate(self.start)}
        for k, (c, w) in enumerate(zip(self.inertia, self.omega0, strict=True), 1):
            known |= {f"c{k}": c, f"Omega{k}_0": w}
        return self._of("turn_constants", known)

    def _of(self, name: str, known: Mapping[str, Any]) -> Named:
        return sequence(name).evaluate(known, self.functions)


@cache
def _formulas() -> tuple[FormulaSequence, FormulaSequence]:
    """Of rates, f = D_t F_t being given: how they change with p and r alone; and the others."""
    formulas = [x for x in sequence("sensitivity").formulas if x[0] != "f"]
    ways = FormulaSequence(formulas).up_to(frozenset([*_WAYS, *(f"Omega_{x}" for x in AXES)]))
    names = {name for name, _ in ways.formulas}
    return ways, FormulaSequence(x for x in formulas if x[0] not in names)


def axes_of(inertia: Sequence[Fraction], omega0: Sequence[Fraction]) -> tuple[int, ...]:
    """Axes a, b, d with b the middle one, so that 0 <= r <= p."""
    order = sorted(range(3), key=lambda k: inertia[k], reverse=True)
    return tuple(order if discriminant(inertia, omega0) >= 0 else order[::-1])


def parameters(
    inertia: Sequence[Fraction], omega0: Sequence[Fraction], axes: Sequence[int]
) -> list[Fraction]:
    """p, r and p - r, exactly."""
    known: Named = _lettered(inertia, omega0, axes)
    for name, wanted in (("moments", _COEFFICIENTS), ("columns", _PARAMETERS)):
        formulas = sequence(name).up_to(frozenset(wanted))
        known = formulas.evaluate_exactly(known, {"power": pow}, Fraction)
    return [Fraction(known[name]) for name in _PARAMETERS]


def _lettered(inertia: Sequence[Any], omega0: Sequence[Any], axes: Sequence[int]) -> Named:
    """By the names that formulas have for them."""
    known: Named = {"epsilon": handedness(*axes)}
    for x, k in zip(AXES, axes, strict=True):
        known |= {f"c_{x}": inertia[k], f"Omega_{x}0": omega0[k]}
    return known
