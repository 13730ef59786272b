"""Setting of a derivation: what it starts from, with the choices that a user has.

The paper's choice is the default: the basis (4), H = (c1 Omega1^2 + c2 Omega2^2 + c3 Omega3^2)/2,
R = exp(phi1 A1) exp(phi2 A2) exp(phi3 A1), and the momentum turned onto A1.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import permutations
from typing import Any

import sympy

from rigidsym.errors import InputError
from rigidsym.proof.steps._names import read, symbols

KINETIC = "(c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2)/2"
AXES = (1, 2, 3)


@dataclass(frozen=True, slots=True)
class Setting:
    """Choices of a derivation; raises InputError for an invalid one.

    `sequence` are the axes of three turns, the outer two alike, and `axis` is the one that the
    momentum is turned onto.  The basis is sign * factor times the quaternions i, j, k in the order
    `order`.  `lagrangian` is diagonal and quadratic in the rates plus linear: constant wheel
    momenta h1, h2, h3 make a gyrostat of the body.
    """

    sequence: tuple[int, int, int] = (1, 2, 1)
    axis: int = 0
    factor: sympy.Rational = field(default_factory=lambda: sympy.Rational(1, 2))
    sign: int = 1
    order: tuple[int, int, int] = AXES
    lagrangian: str = KINETIC

    def __post_init__(self) -> None:
        outer, middle, last = (*self.sequence, None, None, None)[:3]
        if len(self.sequence) != 3 or {outer, middle} - {*AXES} or outer != last or outer == middle:
            known = ", ".join(f"{i}-{j}-{i}" for i, j in permutations(AXES, 2))
            raise InputError("sequence", _dashed(self.sequence), f"must be one of: {known}")
        if self.axis not in (0, *AXES):
            raise InputError("axis", self.axis, "must be 1, 2 or 3")
        if self.factor not in (sympy.Rational(1, 2), 1):
            raise InputError("factor", self.factor, "must be 1/2 or 1")
        if self.sign not in (1, -1):
            raise InputError("sign", self.sign, "must be 1 or -1")
        if tuple(sorted(self.order)) != AXES:
            rule = "must have each of 1, 2, 3 once: another basis spans no algebra"
            raise InputError("order", _dashed(self.order), rule)
        self.wheel()  # says what is wrong with the Lagrangian

    @property
    def target(self) -> int:
        """The axis that the momentum is turned onto: the outer one of the sequence by default."""
        return self.axis or self.sequence[0]

    @property
    def paper(self) -> bool:
        """True for the paper's choices."""
        return self == Setting() or self == Setting(axis=1)

    @property
    def axes(self) -> tuple[int, int, int]:
        """The outer, the middle and the third axis of the sequence."""
        outer, middle, _ = self.sequence
        return outer, middle, 6 - outer - middle

    def basis(self) -> tuple[sympy.ImmutableMatrix, ...]:
        """Return the basis A1, A2, A3."""
        i = sympy.I
        units = (((i, 0), (0, -i)), ((0, 1), (-1, 0)), ((0, i), (i, 0)))
        scale = self.sign * self.factor
        return tuple(sympy.ImmutableMatrix(units[k - 1]) * scale for k in self.order)

    def energy(self) -> sympy.Expr:
        """Return the Lagrangian as an expression."""
        try:
            return read(self.lagrangian)
        except (ValueError, SyntaxError, TypeError):  # TypeError: neg(x, y)
            raise InputError("lagrangian", self.lagrangian, "must be an expression") from None

    def wheel(self) -> tuple[sympy.Expr, ...]:
        """Return the linear coefficients h1, h2, h3 of the Lagrangian."""
        rates = symbols("Omega1 Omega2 Omega3")
        rule = "must be (c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2)/2 plus a linear part"
        try:
            rest = sympy.Poly(self.energy() - read(KINETIC), *rates)
        except sympy.PolynomialError:
            raise InputError("lagrangian", self.lagrangian, rule) from None
        known = symbols("h1 h2 h3")
        if any(sum(powers) != 1 for powers in rest.monoms() if not rest.is_zero):
            raise InputError("lagrangian", self.lagrangian, rule)
        linear = tuple(rest.coeff_monomial(rate) for rate in rates)
        if any(h.free_symbols - {*known} or not h.is_polynomial(*known) for h in linear):
            rule = "must have polynomials in h1, h2, h3 in front of the rates of its linear part"
            raise InputError("lagrangian", self.lagrangian, rule)
        return linear


def setting_of(texts: Mapping[str, str]) -> Setting:
    """Return a setting from texts by field names; raise InputError for an invalid one."""
    readers: dict[str, Callable[[str, str], Any]] = {
        "sequence": _axes,
        "order": _axes,
        "axis": _whole,
        "sign": _whole,
    }
    fields: dict[str, Any] = {k: readers.get(k, _as_it_is)(k, text) for k, text in texts.items()}
    return Setting(**fields)


def _axes(name: str, text: str) -> tuple[int, ...]:
    """Parse "3-1-3" or "313" as three axes."""
    if not re.fullmatch(r"[1-3](-?)[1-3]\1[1-3]", text):
        raise InputError(name, text, "must be three axes such as 3-1-3")
    return tuple(map(int, text.replace("-", "")))


def _whole(name: str, text: str) -> int:
    if not re.fullmatch(r"[+-]?[0-9]+", text):
        raise InputError(name, text, "must be a whole number")
    return int(text)


def _as_it_is(name: str, text: str) -> Any:
    return sympy.Rational(text) if name == "factor" and text in ("1/2", "1") else text


def _dashed(axes: tuple[int, ...]) -> str:
    return "-".join(map(str, axes))
