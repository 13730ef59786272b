"""Numerical checks of equations by ball arithmetic, at given and at pseudorandom points.

The value of a name comes from the point, from its definition, or from a reading that is a formula.
Two sides agree if the ball of their difference is small and contains 0.

Besides the points of a certificate, a hash of the claim draws others, so that no claim can be
fitted to them.  Numbers are from (0, 1), from near its ends or from (-8, 8); integers are small.
If a relation connects drawn names, it is solved for the last of them.  Draws that are no points of
the context, or at which a function has no value, are skipped; at least `DUE` must remain.
"""

import hashlib
from collections.abc import Callable

from flint import acb, arb, ctx, fmpq

from rigidsym.proof.checker import _elliptic as elliptic
from rigidsym.proof.checker._elliptic import between
from rigidsym.proof.checker._language import NAME, Language, is_formula
from rigidsym.proof.checker._records import Claim, Hypotheses, Refused
from rigidsym.proof.checker._theory import rational

PRECISION = 192
TOLERANCE = "1e-30"


def check_point(given: Hypotheses, fact: Claim, point: dict[str, str]) -> None:
    """Check by ball arithmetic that an equation holds at one point.

    Raises Refused unless the balls of both sides agree and the point is one of the context.
    """
    with ctx.workprec(PRECISION):
        values = Values(given, numbers(given, point))
        if not values.confirm(fact, TOLERANCE):
            raise Refused(f"balls do not confirm {fact.lhs} = {fact.rhs} at {point}")


def numbers(given: Hypotheses, point: dict[str, str]) -> dict[str, acb]:
    """Convert the coordinates of a point to balls.

    Raises Refused for names that are not free.
    """
    if taken := point.keys() - {*given.generators}:
        raise Refused(f"a point gives {min(taken)!a}, which is no generator")
    if forced := [name for name in point if is_formula(given.reading.get(name, "?"))]:
        raise Refused(f"a point gives {forced[0]}, which its reading gives")
    return {name: acb(arb(rational(text))) for name, text in point.items()}


class Values(Language[acb]):
    """Values of a context's expressions at one point, computed by ball arithmetic."""

    def __init__(self, given: Hypotheses, point: dict[str, acb]) -> None:
        self._given, self._unread = given, {**given.reading, **given.definitions}
        constants = {"pi": acb.pi(), "I": acb(0, 1)}
        known = {*given.generators, *self._unread}
        self._values = {name: constants[name] for name in constants.keys() - known}
        self._values |= point

    def confirm(self, fact: Claim, tolerance: str) -> bool:
        """Return whether both sides of a fact agree within a tolerance.

        Raises Refused if they have no value, or if the point is not one of the context.
        """
        sides = [(self.read(x), self.read(y)) for x, y in zip(fact.lhs, fact.rhs, strict=True)]
        self.check()
        for left, right in sides:
            gap, bound = left - right, arb(tolerance) * (1 + left.abs_lower())
            narrow = gap.real.rad() <= bound and gap.imag.rad() <= bound
            if not (gap.is_finite() and narrow and gap.contains(0)):
                return False
        return True

    def check(self) -> None:
        """Check that the point satisfies the hypotheses of the context.

        Only hypotheses whose names have all been evaluated are checked.  Raises Refused.
        """
        given = self._given
        for texts, holds in (
            (given.relations, lambda value: value.contains(0)),
            (given.units, lambda value: not value.contains(0)),
            (given.nonnegative, lambda value: not value.real < 0),
        ):
            for text in texts:
                if self._values.keys() >= {*NAME.findall(text)} and not holds(self.read(text)):
                    raise Refused(f"the point does not satisfy what is assumed of {text}")

    def number(self, number: int) -> acb:
        """Return a natural number as a ball."""
        return acb(number)

    def name(self, name: str) -> acb:
        """Return the value of a name as a ball.

        Raises Refused if the definition of the name is circular.
        """
        if name not in self._values:
            if name not in self._unread:
                raise Refused(f"{name!r} has no value at the point")
            value = self.read(self._unread.pop(name))
            # The rules on signs and even powers hold for real numbers only.
            if name in self._given.generators and not value.imag.contains(0):
                raise Refused(f"{name} is not real at the point")
            self._values[name] = value
        return self._values[name]

    def call(self, function: str, arguments: list[acb]) -> acb:
        """Return the value of a function call as a ball.

        The imaginary part is dropped if all arguments are real.
        """
        key = function, len(arguments)
        if key not in FUNCTIONS:
            raise Refused(f"{function} of {len(arguments)} is no function here")
        value = FUNCTIONS[key](*arguments)
        if not value.is_finite():
            raise Refused(f"{function} has no finite value at the point")
        return acb(value.real) if all(x.imag == 0 for x in arguments) else value


def _theta(index: int, derivative: int = 0) -> Callable[[acb, acb], acb]:
    """Return a Jacobi theta function or its z-derivative as a Python function.

    It is theta_index(z, q) (DLMF 20.2(i)).
    FLINT takes z/pi.
    """

    def function(z: acb, q: acb) -> acb:
        tau = between(arb(0), q, arb(1)).log() / acb(0, arb.pi())
        return acb.modular_theta(z / acb.pi(), tau, derivative)[index - 1] / acb.pi() ** derivative

    return function


def _root(x: acb) -> acb:
    """Return the square root of a real ball.

    Raises Refused if the ball has negative points.
    """
    if not elliptic.real(x) >= 0:
        raise Refused("the root of a number that may be negative")
    return x.sqrt()


def _nome(m: acb) -> acb:
    """Return the elliptic nome exp(-pi K'/K) for a parameter m."""
    m = between(arb(0), m, arb(1))
    return (-acb.pi() * acb.elliptic_k(1 - m) / acb.elliptic_k(m)).exp()


FUNCTIONS: dict[tuple[str, int], Callable[..., acb]] = {
    ("sqrt", 1): _root,
    ("exp", 1): acb.exp,
    ("re", 1): lambda z: acb(z.real),
    ("im", 1): lambda z: acb(z.imag),
    **{(f"theta{index}", 2): _theta(index) for index in (1, 2, 3, 4)},
    **{(f"dtheta{index}", 2): _theta(index, derivative=1) for index in (2, 4)},
    ("nome", 1): _nome,
    ("elliptic_k", 1): lambda m: acb.elliptic_k(between(None, m, arb(1))),
    ("elliptic_e", 1): lambda m: acb.elliptic_e(between(None, m, arb(1))),
    ("elliptic_pi", 2): lambda n, m: elliptic.third_kind(n, acb.pi() / 2, m),
    ("elliptic_pi", 3): elliptic.third_kind,
    ("elliptic_j", 3): elliptic.third_kind_of_argument,
    ("arcsc", 2): elliptic.inverse_sc,
    ("jacobi_sn", 2): lambda u, m: elliptic.jacobi(u, m)[0],
    ("jacobi_cn", 2): lambda u, m: elliptic.jacobi(u, m)[1],
    ("jacobi_dn", 2): lambda u, m: elliptic.jacobi(u, m)[2],
    ("jacobi_epsilon", 2): elliptic.epsilon,
}


DUE, MOST = 40, 400
# Precision and tolerance at drawn points.
BITS, ALIKE = 128, "1e-18"


def check_drawn_points(given: Hypotheses, fact: Claim, free: list[str], whole: list[str]) -> None:
    """Check by ball arithmetic that an equation holds at many pseudorandom points.

    A hash of the claim draws the points.  Raises Refused if the equation fails at one of them.
    """
    free = [name for name in given.generators if name in free]
    seen = 0
    with ctx.workprec(BITS):
        for k in range(MOST):
            try:
                values = Values(given, _draw(given, fact, free, whole, k))
                confirmed = values.confirm(fact, ALIKE)
            except (Refused, ArithmeticError):
                continue
            if not confirmed:
                raise Refused(f"balls do not confirm {fact.lhs} = {fact.rhs} at draw {k}")
            seen += 1
            if seen == DUE:
                return
    raise Refused(f"only {seen} of {MOST} draws are points of {given.name}")


def _draw(
    given: Hypotheses, fact: Claim, free: list[str], whole: list[str], k: int
) -> dict[str, acb]:
    found = {}
    for name in free:
        told = repr((fact.context, fact.lhs, fact.rhs, name, k)).encode()
        seed = hashlib.blake2b(told, digest_size=16).digest()
        found[name] = _number(seed, name in whole, name in given.nonnegative)
    for relation in given.relations:
        names = {*NAME.findall(relation)}
        if names <= {*free}:
            name = max(names, key=free.index)
            found[name] = _solve(given, found, name, relation)
    return found


def _number(seed: bytes, whole: bool, positive: bool) -> acb:
    """Return a pseudorandom number for a seed.

    It is from (0, 1), from near the ends of this interval, or from (-8, 8); or a small integer.
    """
    part, choice = fmpq(int.from_bytes(seed[:8], "little"), 2**64), seed[8] % 10
    if whole:
        return acb(seed[9] % 9 - 4)
    if choice == 0:
        return acb(part / 4096)
    if choice == 1:
        return acb(1 - part / 4096)
    if choice < 7:
        return acb(part)
    return acb(8 * part if positive or choice == 7 else -8 * part)


def _solve(given: Hypotheses, known: dict[str, acb], name: str, relation: str) -> acb:
    """Solve a relation that is linear in a name or in its square."""
    at = [Values(given, {**known, name: acb(x)}).read(relation) for x in (-1, 0, 1)]
    if (at[0] - at[2]).contains(0):
        square = at[1] / (at[1] - at[2])
        if not square.real > 0:
            raise Refused(f"{name} is not real")
        return square.sqrt() if known[name].real > 0 else -square.sqrt()
    return at[1] / (at[1] - at[2])
