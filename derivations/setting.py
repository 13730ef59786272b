"""Setting of a derivation: what it starts from, with the choices that a user has.

The paper's choice is the default: SU(2) with the basis (4), R = exp(phi1 A1) exp(phi2 A2)
exp(phi3 A1), H = (c1 Omega1^2 + c2 Omega2^2 + c3 Omega3^2)/2, and the momentum turned onto A1.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations, permutations, product
from typing import Any, NoReturn

import sympy

from rigidsym.errors import InputError, unknown
from rigidsym.proof.algebra._quaternion import rotated
from rigidsym.proof.steps._names import read, symbols

RATES = symbols("Omega1 Omega2 Omega3")
MOMENTS, PRODUCTS, WHEELS = symbols("c1 c2 c3"), symbols("c12 c13 c23"), symbols("h1 h2 h3")
MOMENTA = symbols("M1 M2 M3")
KINETIC = "(c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2)/2"
AXES = (1, 2, 3)
# Twelve sequences of turns: no two in a row are about the same axis.
SEQUENCES = tuple((i, j, k) for i, j, k in product(AXES, repeat=3) if j not in (i, k))


def su2(q: Sequence[Any]) -> sympy.ImmutableMatrix:
    """Return F of (1) and (2): q0 + q1 i + q2 j + q3 k -> ((z1, z2), (-z2*, z1*))."""
    z1, z2 = q[0] + sympy.I * q[1], q[2] + sympy.I * q[3]
    return sympy.ImmutableMatrix(((z1, z2), (-sympy.conjugate(z2), sympy.conjugate(z1))))


def so3(q: Sequence[Any]) -> sympy.ImmutableMatrix:
    """Return the matrix of the rotation v -> q v q^-1: its columns are the rotated axes."""
    columns = (rotated(q, axis) for axis in sympy.eye(3).tolist())
    return sympy.ImmutableMatrix([*columns]).T


# The matrix of a unit quaternion in each group.
GROUPS: Mapping[str, Callable[[Sequence[Any]], sympy.ImmutableMatrix]] = {"SU2": su2, "SO3": so3}


@dataclass(frozen=True, slots=True)
class Setting:
    """Choices of a derivation; raises InputError for an invalid one.

    `group` has the matrices of attitudes: SU2, the paper's, or SO3, the rotation matrices.
    `sequence` are the axes of three turns: Euler's such as 3-1-3, or Tait's and Bryan's such as
    3-2-1.  `axis` is the one that the momentum is turned onto.  The basis is sign * factor times
    the quaternions i, j, k in the order `order`, or the matrices of SO(3) with the same brackets.
    `lagrangian` is quadratic in the
    rates plus linear: moments of inertia c1, c2, c3, of which some may be equal; products of
    inertia c12, c13, c23 about other axes than the principal ones; constant wheel momenta h1, h2,
    h3, which make a gyrostat of the body.
    """

    sequence: tuple[int, int, int] = (1, 2, 1)
    axis: int = 0
    factor: sympy.Rational = field(default_factory=lambda: sympy.Rational(1, 2))
    sign: int = 1
    order: tuple[int, int, int] = AXES
    lagrangian: str = KINETIC
    group: str = "SU2"

    def __post_init__(self) -> None:
        if self.sequence not in SEQUENCES:
            known = ", ".join(map(_dashed, SEQUENCES))
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
        if self.group not in GROUPS:
            raise unknown("group", self.group, GROUPS, plain=True)
        self._check_lagrangian()

    @property
    def target(self) -> int:
        """The axis that the momentum is turned onto: the first one of the sequence by default."""
        return self.axis or self.sequence[0]

    @property
    def paper(self) -> bool:
        """True for the paper's choices."""
        return self == Setting() or self == Setting(axis=1)

    @property
    def axes(self) -> tuple[int, int, int]:
        """The last axis of the sequence, the middle one, and the one that is neither."""
        _, middle, last = self.sequence
        return last, middle, 6 - last - middle

    def nutation(self, phi2: sympy.Symbol) -> tuple[sympy.Expr, sympy.Expr]:
        """Return two functions of phi2: of the momentum along the last axis, and across it.

        They are the cosine and the sine of the whole angle, or the sine and the cosine where the
        first and the last axis differ.
        """
        pair = sympy.cos(2 * self.factor * phi2), sympy.sin(2 * self.factor * phi2)
        return pair if self.sequence[0] == self.sequence[2] else pair[::-1]

    def element(self, name: str) -> sympy.ImmutableMatrix:
        """Return the matrix of the unit quaternion with the components name0 to name3."""
        return GROUPS[self.group](_components(name))

    def basis(self) -> tuple[sympy.ImmutableMatrix, ...]:
        """Return the basis A1, A2, A3: derivatives of the group's matrices at the identity."""
        q = _components("q")
        at_one = dict(zip(q, (1, 0, 0, 0), strict=True))
        slopes = (self.element("q").diff(q[k]).subs(at_one) for k in self.order)
        return tuple(slope * self.sign * self.factor for slope in slopes)

    @property
    def frequency(self) -> sympy.Rational:
        """The frequency w of exp(angle A) for a basis matrix A, where A^3 = -w^2 A."""
        return self.factor if self.group == "SU2" else 2 * self.factor

    def energy(self) -> sympy.Expr:
        """Return the Lagrangian as an expression."""
        try:
            return read(self.lagrangian)
        except (ValueError, SyntaxError, TypeError):  # TypeError: neg(x, y)
            raise InputError("lagrangian", self.lagrangian, "must be an expression") from None

    def inertia(self) -> sympy.ImmutableMatrix:
        """Return the inertia tensor: the second derivatives of the Lagrangian by the rates."""
        return sympy.ImmutableMatrix(sympy.hessian(self.energy(), RATES))

    def wheel(self) -> tuple[sympy.Expr, ...]:
        """Return the linear coefficients h1, h2, h3 of the Lagrangian."""
        lagrangian = sympy.Poly(self.energy(), *RATES)
        return tuple(lagrangian.coeff_monomial(rate) for rate in RATES)

    @property
    def about_principal_axes(self) -> bool:
        """True if the inertia tensor is diagonal."""
        return self.inertia().is_diagonal()

    def moment(self, axis: int) -> sympy.Expr:
        """Return the moment of inertia about an axis."""
        return self.inertia()[axis - 1, axis - 1]

    def alike(self, *axes: int) -> bool:
        """Return True if the moments of inertia about these axes are equal."""
        return len({*map(self.moment, axes)}) == 1

    @property
    def symmetry_axis(self) -> int | None:
        """The axis that has equal moments across it, if there is one; the first of a sphere."""
        return next((k for k in AXES if self.alike(*({*AXES} - {k}))), None)

    def _refuse(self, rule: str) -> NoReturn:
        raise InputError("lagrangian", self.lagrangian, rule)

    def _check_lagrangian(self) -> None:
        """Raise InputError for a Lagrangian that no chapter derives from."""
        rule = f"must be {KINETIC} plus products of inertia, plus a linear part"
        try:
            lagrangian = sympy.Poly(self.energy(), *RATES)
        except sympy.PolynomialError:
            self._refuse(rule)
        potential = lagrangian.coeff_monomial(1)
        if potential.free_symbols - {*MOMENTS, *PRODUCTS, *WHEELS}:
            self._refuse(
                f"must have no potential ({potential}): its torque adds to [M, Omega] in M', (7), "
                "so the spectrum of M, that is K, is not conserved, (15)"
            )
        if potential != 0 or lagrangian.total_degree() > 2:
            self._refuse(rule)
        self._check_inertia()
        if any(h.free_symbols - {*WHEELS} or not h.is_polynomial(*WHEELS) for h in self.wheel()):
            self._refuse(
                "must have polynomials in h1, h2, h3 in front of the rates of its linear part"
            )

    def _check_inertia(self) -> None:
        """Raise InputError unless the entries of the inertia tensor have their names."""
        tensor, names = self.inertia(), list(sympy.hessian(read(KINETIC), RATES).diagonal())
        moments = list(tensor.diagonal())
        for moment in moments:
            if moment not in names or moments[names.index(moment)] != moment:
                self._refuse("must have the moments c1, c2, c3; equal ones have one of their names")
        for (i, j), name in zip(combinations(range(3), 2), PRODUCTS, strict=True):
            if tensor[i, j] not in (0, name, -name):
                rates = RATES[i] * RATES[j]
                self._refuse(f"must have the product of inertia {name} in front of {rates}")


def _components(name: str) -> tuple[sympy.Symbol, ...]:
    return symbols(" ".join(f"{name}{k}" for k in range(4)))


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
        known = SEQUENCES if name == "sequence" else permutations(AXES)
        raise InputError(name, text, f"must be one of: {', '.join(map(_dashed, known))}")
    return tuple(map(int, text.replace("-", "")))


def _whole(name: str, text: str) -> int:
    if not re.fullmatch(r"[+-]?[0-9]+", text):
        raise InputError(name, text, "must be a whole number")
    return int(text)


def _as_it_is(name: str, text: str) -> Any:
    return sympy.Rational(text) if name == "factor" and text in ("1/2", "1") else text


def _dashed(axes: tuple[int, ...]) -> str:
    return "-".join(map(str, axes))
