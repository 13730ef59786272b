"""Theta functions in a context, and proofs of identities between their products.

theta_j(z, q) is the sum of chi(n) q**(n**2) exp(2 i n z) over whole n, or halves of odd n if j < 3;
chi(n) is (-1)**n for j = 4, -i (-1)**(n - 1/2) for j = 1, else 1 (DLMF 20.2(i)), and 0 < q < 1.  A
d before it is a derivative in z.  Arguments are linear in real names, I being the unit.
"""

import re
from collections.abc import Iterator
from functools import lru_cache
from itertools import product, repeat
from math import lcm, prod
from operator import add, mod, mul
from typing import NamedTuple, TypeAlias

from flint import fmpq, fmpq_mat, fmpq_mpoly, fmpq_mpoly_ctx, fmpz_mat

from rigidsym.proof.checker._language import Language
from rigidsym.proof.checker._records import Refused
from rigidsym.proof.checker._ring import Quotient, Ring

_FUNCTION = re.compile(r"(d{0,4})theta([1-4])")
_MOST = 10_000
Form: TypeAlias = tuple[tuple[str, bool, fmpq], ...]  # names, whether they have the factor I


class Theta(NamedTuple):
    """A Jacobi theta function or one of its z-derivatives, at a linear argument.

    It is the derivative of this `order` of theta_index(form, nome**power).
    """

    index: int
    order: int
    nome: str
    power: int
    form: Form

    @property
    def odd(self) -> bool:
        """True if the function is odd in z."""
        return (self.order + (self.index == 1)) % 2 == 1


Leaf: TypeAlias = "str | Theta"
Sum: TypeAlias = dict[tuple[Leaf, ...], fmpq]


class Sums(Language[Sum]):
    """Parser of expressions into sums of products of names and theta functions."""

    def number(self, number: int) -> Sum:
        """Return a natural number as a sum of one term."""
        return {(): fmpq(number)} if number else {}

    def name(self, name: str) -> Sum:
        """Return a name as a sum of one term."""
        return {(name,): fmpq(1)}

    def call(self, function: str, arguments: list[Sum]) -> Sum:
        """Return a theta function as a sum of one term."""
        kind = _FUNCTION.fullmatch(function)
        if not kind or len(arguments) != 2 or len(arguments[1]) != 1:
            raise Refused(f"{function} of {len(arguments)} is no theta function")
        ((nomes, factor),) = arguments[1].items()
        if len({*nomes}) != 1 or factor != 1 or not isinstance(nomes[0], str):
            raise Refused("a nome is not a power of a name")
        value = Theta(int(kind[2]), len(kind[1]), nomes[0], len(nomes), form(arguments[0]))
        return {(value,): fmpq(1)}

    def combine(self, operator: str, left: Sum, right: Sum) -> Sum:
        """Return the sum, difference, product or quotient of two sums.

        Raises Refused for divisors with names.
        """
        if operator in "+-":
            right = self.negative(right) if operator == "-" else right
            return _sum([*left.items(), *right.items()])
        if operator == "/":
            if [*right] != [()]:
                raise Refused("a division by what is no number")
            right = {(): 1 / right[()]}
        if len(left) * len(right) > _MOST:
            raise Refused("a product of too many terms")
        pairs = product(left.items(), right.items())
        return _sum([(tuple(sorted(x + y, key=repr)), k * m) for (x, k), (y, m) in pairs])

    def negative(self, operand: Sum) -> Sum:
        """Return the negative of a sum."""
        return {leaves: -factor for leaves, factor in operand.items()}

    def power(self, base: Sum, exponent: int) -> Sum:
        """Return a power of a sum.

        Raises Refused unless the exponent is from 1 to 9.
        """
        if not 1 <= exponent <= 9:
            raise Refused(f"a power {exponent}")
        total = base
        for _ in range(exponent - 1):
            total = self.combine("*", total, base)
        return total


def _sum(terms: list[tuple[tuple[Leaf, ...], fmpq]]) -> Sum:
    total: Sum = {}
    for leaves, factor in terms:
        total[leaves] = total.get(leaves, fmpq(0)) + factor
    return {leaves: factor for leaves, factor in total.items() if factor}


def form(terms: Sum) -> Form:
    """Convert a sum to a linear form in names.

    Raises Refused unless it is linear, with I at most once a term.
    """
    found = []
    for leaves, factor in terms.items():
        names = [leaf for leaf in leaves if leaf != "I"]
        if len(names) != 1 or len(leaves) > 2 or not isinstance(names[0], str):
            raise Refused("an argument of a theta function is not linear in names")
        found.append((names[0], len(leaves) == 2, factor))
    return tuple(sorted(found))


@lru_cache(maxsize=64)
def zero(text: str) -> list[tuple[list[Theta], fmpq]]:
    """Check an identity between products of theta functions, and return its terms.

    Raises Refused unless the identity holds for all values of its names.

    With z = F x, and F invertible, a product is the sum over n, or over a = F^T n, of its factor
    times chi(n_1) (2 i n_1)**d_1 ... q**(a.E a) exp(2 i a.x).  Where two products have one E, terms
    of one a have one q**(a.E a).  M F^-1 is made of even numbers: so n + M F^-T m and n have the
    same chi, for whole m, and the coefficients are polynomials on each class of a modulo M.
    """
    read = Sums().read(text).items()
    terms = [([x for x in leaves if isinstance(x, Theta)], factor) for leaves, factor in read]
    if not terms or any(len(x) < len(y) for (x, _), (y, _) in zip(terms, read, strict=True)):
        raise Refused("an identity is not a sum of products of theta functions")
    thetas = [theta for leaves, _ in terms for theta in leaves]
    if len({theta.nome for theta in thetas}) != 1:
        raise Refused("an identity has more than one nome, or no theta function")
    if any(imaginary for theta in thetas for _, imaginary, _ in theta.form):
        raise Refused("an identity has I in an argument")
    names = sorted({name for theta in thetas for name, *_ in theta.form})
    matrices = [_matrix(leaves, names) for leaves, _ in terms]
    exponents = [
        _exponent(leaves, below) for (leaves, _), (_, below) in zip(terms, matrices, strict=True)
    ]
    if any(exponent != exponents[0] for exponent in exponents):
        raise Refused("powers of the nome differ")
    period = 2 * lcm(*(int(x.q) for _, below in matrices for x in below.entries()))
    unit = 2 * lcm(*(int(x.q) for above, _ in matrices for x in above.entries()))
    found: dict[tuple[object, ...], fmpq_mpoly] = {}
    for (leaves, factor), (above, below) in zip(terms, matrices, strict=True):
        weight, imaginary = _weight(leaves, below, names)
        for place, sign in _classes(leaves, above, below, period, unit):
            value = weight * (factor * sign)
            key = place, imaginary
            found[key] = found[key] + value if key in found else value
    if any(found.values()):
        raise Refused("the Fourier coefficients of an identity are not zero")
    return terms


def _matrix(leaves: list[Theta], names: list[str]) -> tuple[fmpq_mat, fmpq_mat]:
    """Return the matrix of the arguments in a product of theta functions, and its inverse.

    The arguments are z = F x with the matrix F.
    """
    tables = [{name: factor for name, _, factor in theta.form} for theta in leaves]
    size = len(names)
    if len(leaves) != size or not 1 <= size <= 6:
        raise Refused("a product has not one argument for each name")
    above = fmpq_mat(size, size, [table.get(name, fmpq(0)) for table in tables for name in names])
    if not above.det():
        raise Refused("the arguments of a product depend on each other")
    return above, above.inv()


def _exponent(leaves: list[Theta], below: fmpq_mat) -> fmpq_mat:
    """Return the quadratic form of the nome's exponents in a product of theta functions.

    It is E = F^-1 diag(powers) F^-T.
    """
    size = len(leaves)
    powers = fmpq_mat(size, size, [fmpq(0)] * size**2)
    for k, theta in enumerate(leaves):
        powers[k, k] = fmpq(theta.power)
    return below * powers * below.transpose()


def _weight(leaves: list[Theta], below: fmpq_mat, names: list[str]) -> tuple[fmpq_mpoly, bool]:
    """Return the polynomial factor in the Fourier coefficients of a theta product.

    It is the product of (2 i n)**d, and of -i for theta_1, as a polynomial in a.
    The second value says whether a factor i is left out.
    """
    polynomials = fmpq_mpoly_ctx.get(names, "lex")
    weight, turns = polynomials.constant(1), 0
    for k, theta in enumerate(leaves):
        n = sum(
            (a * below[i, k] for i, a in enumerate(polynomials.gens())), polynomials.constant(0)
        )
        weight *= (2 * n) ** theta.order
        turns += theta.order + 3 * (theta.index == 1)
    return -weight if turns % 4 >= 2 else weight, turns % 2 == 1


def _classes(
    leaves: list[Theta], above: fmpq_mat, below: fmpq_mat, period: int, unit: int
) -> Iterator[tuple[tuple[object, ...], int]]:
    """Yield one exponent vector of each residue class modulo `period`, with its sign.

    It is a*unit, with its sign.
    The a, but for a first one, are the lattice of the rows of F.  In a triangular basis of it (the
    Hermite normal form) the diagonal h divides the period, and the coefficients from 0 to period/h
    are one for each class.
    """
    size = len(leaves)
    scaled = fmpz_mat(size, size, [int((x * unit).p) for x in above.entries()])
    basis = [[int(x) for x in row] for row in scaled.hnf().tolist()]
    counts = [period * unit // row[k] for k, row in enumerate(basis)]
    if prod(counts) > _MOST:
        raise Refused("too many classes of exponents")
    halves = [int(theta.index < 3) for theta in leaves]
    first = [int(x) // 2 for x in (fmpz_mat(1, size, halves) * scaled).entries()]
    flips = [k for k, theta in enumerate(leaves) if theta.index in (1, 4)]
    turns = [
        sum(int(((fmpq_mat(1, size, row) * below)[0, k] / unit).p) for k in flips) for row in basis
    ]
    for numbers in product(*map(range, counts)):
        odd = sum(map(mul, numbers, turns)) % 2
        steps = [sum(map(mul, numbers, column)) for column in zip(*basis, strict=True)]
        yield tuple(map(mod, map(add, first, steps), repeat(period * unit))), -1 if odd else 1


class Functions:
    """The names of a context that are declared to be values of theta functions."""

    def __init__(self, ring: Ring, declared: dict[str, str]) -> None:
        self.ring = ring
        self._parts: dict[tuple[str, Theta], Quotient] = {}
        self._declared: list[tuple[str, str, Theta]] = []
        for name, text in declared.items():
            if text[:3] not in ("re(", "im(") or text[-1] != ")":
                raise Refused(f"{name} is declared to be no part of a theta function")
            ((leaves, factor),) = Sums().read(text[3:-1]).items()
            (theta,) = leaves
            if factor != 1 or not isinstance(theta, Theta):
                raise Refused(f"{name} is declared to be no theta function")
            self._declared.append((name, text[:2], theta))
            least, *signs = _least(theta)
            self._parts[text[:2], least] = ring.name(name) * self._number(signs[text[:2] == "im"])

    def check(self, generators: list[str], rates: dict[str, str] | None) -> None:
        """Check the declared theta functions against the rest of the context.

        Raises Refused for undeclared generators, a moving nome, and wrong time derivatives.
        """
        ring = self.ring
        for name, part, theta in self._declared:
            if not {name, theta.nome} <= {*generators}:
                raise Refused(f"{name} or its nome is not a generator")
            places = [self._linear(theta.form, imaginary) for imaginary in (False, True)]
            if rates is None:
                continue
            if ring.rate(ring.name(theta.nome)).above:
                raise Refused(f"{theta.nome} is a nome, and moves")
            if rates.get(name) == "?":
                continue
            slope = theta._replace(order=theta.order + 1)
            real, imaginary = map(ring.rate, places)
            terms = [(part, real), ("re", imaginary)] if part == "im" else [(part, real)]
            due = sum((self._part(x, slope) * y for x, y in terms if y.above), self._number(0))
            if part == "re" and imaginary.above:
                due -= self._part("im", slope) * imaginary
            if ring.remainder((ring.rate(ring.name(name)) - due).above):
                raise Refused(f"{name} does not move as it is declared")

    def values(self, identity: str, forms: dict[str, str]) -> list[fmpq_mpoly]:
        """Substitute linear forms into an identity of theta functions.

        Returns its real and imaginary part, which both vanish.
        """
        places = {name: form(Sums().read(text)) for name, text in forms.items()}
        total = [self._number(0), self._number(0)]
        for leaves, factor in zero(identity):
            placed = [theta._replace(form=_placed(theta.form, places)) for theta in leaves]
            if any(theta.odd and not theta.form for theta in placed):
                continue
            real, imaginary = self._number(factor), self._number(0)
            for theta in placed:
                x, y = self._part("re", theta), self._part("im", theta)
                real, imaginary = real * x - imaginary * y, real * y + imaginary * x
            total = [total[0] + real, total[1] + imaginary]
        return [part.above for part in total]

    def _number(self, number: fmpq | int) -> Quotient:
        return self.ring.over_one(self.ring.one * number)

    def _linear(self, terms: Form, imaginary: bool) -> Quotient:
        parts = (self.ring.name(x) * self._number(k) for x, i, k in terms if i == imaginary)
        return sum(parts, self._number(0))

    def _part(self, part: str, theta: Theta) -> Quotient:
        """Return the real or imaginary part of a theta function's value.

        It is expressed in the context's names.
        The value is real for real z; at z = i y it is real if the function is even, else imaginary.
        """
        kinds = {imaginary for _, imaginary, _ in theta.form}
        if part == "im" and True not in kinds:
            return self._number(0)
        if False not in kinds and (part == "re") == theta.odd:
            return self._number(0)
        least, *signs = _least(theta)
        if (part, least) not in self._parts:
            raise Refused(f"no name is declared for a theta function: {part} of {theta}")
        return self._parts[part, least] * self._number(signs[part == "im"])


def _least(theta: Theta) -> tuple[Theta, int, int]:
    """Replace the argument of a theta function by the least of z, -z and their conjugates.

    Returns the function, and the signs of its real and imaginary part.
    f(-z) is f(z) or -f(z), and f at the conjugate of z is the conjugate of f(z).
    """
    odd = -1 if theta.odd else 1
    signs = ((1, 1, 1, 1), (-1, -1, odd, odd), (1, -1, 1, -1), (-1, 1, odd, -odd))
    turned = [
        (tuple((x, i, k * (imaginary if i else real)) for x, i, k in theta.form), re_sign, im_sign)
        for real, imaginary, re_sign, im_sign in signs
    ]
    least, re_sign, im_sign = min(turned)
    return theta._replace(form=least), re_sign, im_sign


def _placed(terms: Form, places: dict[str, Form]) -> Form:
    """Substitute linear forms for the names in a linear form."""
    found: dict[tuple[str, bool], fmpq] = {}
    for name, _, factor in terms:
        for inner, imaginary, k in places[name]:
            key = inner, imaginary
            found[key] = found.get(key, fmpq(0)) + factor * k
    return tuple(sorted((*key, k) for key, k in found.items() if k))
