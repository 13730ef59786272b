"""Theta functions in a context, and proofs of identities between their products.

    theta_j(z, q) = sum of chi_j(n) q**(n**2) exp(2 i n z),   n in Z, or in Z + 1/2 where j < 3
    chi_1(n) = -i (-1)**(n - 1/2),   chi_2(n) = chi_3(n) = 1,   chi_4(n) = (-1)**n,   0 < q < 1

(DLMF 20.2(i)); each d before the name is a derivative in z.  In a context `thetas` maps generators
to texts like `re(dtheta4(v - I*b, q**2))`: the argument is linear in real names, with the unit I,
and the nome a power of a constant generator.  Such arguments have no brackets.
"""

import re
from collections.abc import Iterable, Mapping
from functools import cache, lru_cache
from math import lcm, prod
from operator import mul
from typing import NamedTuple, TypeAlias

from sympy.polys.domains import QQ
from sympy.polys.matrices import DomainMatrix

from rigidsym.proof.kernel._language import KernelError
from rigidsym.proof.kernel._ring import Element, Number, Ring

Form: TypeAlias = tuple[tuple[str, bool, Number], ...]  # names, whether times I, coefficients
Complex: TypeAlias = tuple[Element, Element]  # real and imaginary part
_NAME = r"[A-Za-z_][A-Za-z_0-9]*"
_CALL = re.compile(rf"(d{{0,4}})theta([1-4])\(([^(),]+), ({_NAME})(?:\*\*([1-9]))?\)")
_PART = re.compile(rf"(re|im)\(({_CALL.pattern})\)")
MOST = 10_000  # classes of exponents of a product, so that no identity takes long


class Theta(NamedTuple):
    """A Jacobi theta function or one of its z-derivatives, at a linear argument."""

    index: int
    order: int  # of the derivative
    nome: str
    power: int  # of the nome
    form: Form  # the argument z


@cache
def linear(text: str) -> Form:
    """Parse a linear form in names, where I is the imaginary unit."""
    ring, form = Ring(tuple(sorted({*re.findall(_NAME, text)})), {}), []
    for powers, number in ring.read(text).numerator.terms():
        names = [str(x) for x, power in zip(ring.poly.gens, powers, strict=True) if power]
        rest = [name for name in names if name != "I"]
        if sum(powers) != len(names) or len(rest) != 1:
            raise KernelError(f"{text!r:.80} is not linear in names")
        form.append((rest[0], "I" in names, number))
    return tuple(sorted(form))


def theta(text: str) -> Theta:
    """Parse a call of a theta function."""
    if not (found := _CALL.fullmatch(text)):
        raise KernelError(f"{text!r:.80} is no theta function")
    primes, index, argument, nome, power = found.groups()
    return Theta(int(index), len(primes), nome, int(power or 1), linear(argument))


@lru_cache(maxsize=64)
def vanishing(text: str) -> list[tuple[Number, list[Theta]]]:
    """Check that a sum of theta products vanishes identically, and return its terms.

    A product of r functions of independent forms z = F x is the sum over a = F^T n, n = F^-T a, of
    f(a) q**Q(a) exp(2 i a.x) with Q(a) = sum of p_k n_k**2, f(a) = prod of chi(n_k) (2 i n_k)**d_k.
    So a sum of products is 0 if Q is the same in all of them and the f add up to 0 at each a.

    Let M be even and M/2 a multiple of all denominators in F^-1.  The n of a + M e_i differ from
    those of a by even numbers, which leave chi unchanged: on a class of a modulo M, f is 0, or one
    sign times the polynomial prod (2 i n_k)**d_k in a.  All classes where it is not 0 are reached
    from one by steps of single n_k.  Polynomials that add up to 0 on each class do so at each a.
    """
    calls = [*dict.fromkeys(found[0] for found in _CALL.finditer(text))]
    ring = Ring(tuple(f"x{k}" for k in range(len(calls))), {})
    if re.search(_NAME, _CALL.sub("()", text)):
        raise KernelError(f"{text!r:.80} is made of more than theta functions")
    short = _CALL.sub(lambda found: f"(x{calls.index(found[0])})", text)
    functions = [*map(theta, calls)][::-1]  # as the generators of a ring are
    terms = []
    for powers, number in ring.read(short).numerator.terms():
        factors = zip(functions, powers, strict=True)
        terms.append((number, [x for x, power in factors for _ in range(power)]))
    names = sorted({name for function in functions for name, *_ in function.form})
    if len({x.nome for x in functions}) != 1 or any(i for x in functions for _, i, _ in x.form):
        raise KernelError("an identity is about real multiples of its names, and one nome")
    series = [Series(number, factors, names) for number, factors in terms]
    if any(x.exponent != series[0].exponent for x in series):
        raise KernelError("the quadratic forms of the exponents differ")
    period = 2 * lcm(*(x.denominator for x in series))
    unit = 2 * lcm(*(_denominator(x.rows) for x in series))
    classes: dict[tuple[int, ...], list[tuple[int, int]]] = {}
    for k, x in enumerate(series):
        for place, sign in x.classes(period, unit):
            classes.setdefault((*place, x.imaginary), []).append((k, sign))
    # The same polynomials with the same signs meet on many classes.
    if any(sum(sign * series[k].weight for k, sign in x) for x in {*map(tuple, classes.values())}):
        raise KernelError("the Fourier coefficients do not add up to 0")
    return terms


class Series:
    """The Fourier series of a number times a product of theta functions."""

    def __init__(self, number: Number, factors: list[Theta], names: list[str]) -> None:
        size, self.factors = len(names), factors
        tables = [{name: number for name, _, number in factor.form} for factor in factors]
        self.rows = [[QQ(table.get(name, 0)) for name in names] for table in tables]
        matrix = DomainMatrix(self.rows, (len(factors), size), QQ)
        if len(factors) != size or not 0 < size < 7 or not matrix.det():
            raise KernelError("the arguments of a product are not independent, or not as many")
        inverse = matrix.inv()
        powers = DomainMatrix.diag([QQ(factor.power) for factor in factors], QQ)
        self.exponent = inverse * powers * inverse.transpose()
        self.denominator = _denominator(inverse.to_list())
        a = Ring(tuple(names), {}).poly.gens[::-1]
        n = [sum(map(mul, column, a)) for column in zip(*inverse.to_list(), strict=True)]
        orders = [factor.order for factor in factors]
        # i**turns: i for each derivative, -i for each theta_1
        turns = sum(orders) - sum(factor.index == 1 for factor in factors)
        self.imaginary, sign = turns % 2, (-1) ** (turns % 4 // 2)
        self.weight = prod(map(pow, n, orders), start=a[0] ** 0) * number * sign * 2 ** sum(orders)

    def classes(self, period: int, unit: int) -> Iterable[tuple[tuple[int, ...], int]]:
        """Return one exponent vector of each residue class modulo `period`, with its sign."""
        steps = [[int(x * unit) for x in row] for row in self.rows]
        flips = [factor.index in (1, 4) for factor in self.factors]
        halves = [row for row, factor in zip(steps, self.factors, strict=True) if factor.index < 3]
        start = (sum(column) // 2 for column in zip([0] * len(steps), *halves, strict=True))
        signs = {(first := tuple(x % (period * unit) for x in start)): 1}
        waiting = [first]
        while waiting:
            a = waiting.pop()
            for step, flip in zip(steps, flips, strict=True):
                b = tuple((x + y) % (period * unit) for x, y in zip(a, step, strict=True))
                if b not in signs:
                    signs[b] = -signs[a] if flip else signs[a]
                    waiting.append(b)
            if len(signs) > MOST:
                raise KernelError(f"more than {MOST} classes of exponents")
        return signs.items()  # each a times `unit`, with the sign of `weight` there


def _denominator(rows: list[list[Number]]) -> int:
    return lcm(*(int(x.denominator) for row in rows for x in row))


class Thetas:
    """The names of a context that are declared to be values of theta functions."""

    def __init__(self, ring: Ring, declared: Mapping[str, str]) -> None:
        self.ring, self.zero = ring, ring.read("0")
        self.names: dict[tuple[str, Theta], str] = {}
        for name, text in declared.items():
            if not (found := _PART.fullmatch(text)):
                raise KernelError(f"{text!r:.80} is no part of a theta function")
            self.names[found[1], theta(found[2])] = name

    def check(self, rates: Mapping[str, str] | None) -> None:
        """Check the declared theta functions against the rest of the context.

        Refused are undeclared generators, a moving nome, and derivatives other than f'(z) D(z).
        """
        generators = {*map(str, self.ring.poly.gens)}
        for (part, of), name in self.names.items():
            if not {name, of.nome} <= generators:
                raise KernelError(f"{name}, or its nome {of.nome}, is no generator")
            argument = self._value(of.form)
            if rates is None:
                continue
            if self.ring.read(f"D({of.nome})").numerator:
                raise KernelError(f"the nome {of.nome} is not constant")
            if rates.get(name) != "?":
                speed = self.ring.rate(argument[0]), self.ring.rate(argument[1])
                slope = self._times(of._replace(order=of.order + 1), speed)[part == "im"]
                if self.ring.remainder((self.ring.read(f"D({name})") - slope).numerator):
                    raise KernelError(f"D({name}) is not that of a theta function")

    def at(self, identity: str, forms: Mapping[str, str]) -> Complex:
        """Substitute linear forms into an identity of theta functions."""
        places = {name: linear(text) for name, text in forms.items()}
        total = self.zero, self.zero
        for number, factors in vanishing(identity):
            product = self.ring.read(str(number)), self.zero
            placed = [_placed(factor, places) for factor in factors]
            for factor in sorted(placed, key=lambda factor: len(factor.form)):  # zeros first
                product = self._times(factor, product)
            total = total[0] + product[0], total[1] + product[1]
        return total  # which vanishes

    def _value(self, form: Form) -> Complex:
        parts = [self.zero, self.zero]
        for name, imaginary, number in form:
            parts[imaginary] = parts[imaginary] + self.ring.read(f"{number}*{name}")
        return parts[0], parts[1]

    def _times(self, of: Theta, other: Complex) -> Complex:
        """Return the product of a theta function and a complex value."""
        (a, b), (c, d) = ([self._part(part, of, x) for x in other] for part in ("re", "im"))
        return a - d, b + c

    def _part(self, part: str, of: Theta, factor: Element) -> Element:
        """Return the real or imaginary part of f(z), times a factor."""
        if not factor.numerator:  # f need not be declared
            return self.zero
        odd, conjugate = (-1) ** (of.order + (of.index == 1)), -1 if part == "im" else 1
        # f(-z) = +-f(z) and f(conj z) = conj f(z)
        turns = ((1, 1, 1), (odd, -1, -1), (conjugate, 1, -1), (odd * conjugate, -1, 1))
        images = []
        for sign, *signs in turns:
            form = tuple((name, i, signs[i] * number) for name, i, number in of.form)
            images.append((sign, of._replace(form=form)))
        if (-1, of) in images:
            return self.zero
        for sign, image in images:
            if (part, image) in self.names:
                return self.ring.read(f"{sign}*{self.names[part, image]}") * factor
        raise KernelError(f"{part}({'d' * of.order}theta{of.index}) is not declared at {of.form}")


def _placed(of: Theta, places: Mapping[str, Form]) -> Theta:
    """Substitute linear forms for the names in a theta function's argument."""
    total: dict[tuple[str, bool], Number] = {}
    for inner, _, factor in of.form:
        for name, imaginary, number in places[inner]:
            total[name, imaginary] = total.get((name, imaginary), 0) + factor * number
    return of._replace(form=tuple(sorted((*x, number) for x, number in total.items() if number)))
