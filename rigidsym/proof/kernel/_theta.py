"""Theta functions in a context, and proofs of identities between their products.

    theta_j(z, q) = sum of chi_j(n) q**(n**2) exp(2 i n z),   n in Z, or in Z + 1/2 where j < 3
    chi_1(n) = -i (-1)**(n - 1/2),   chi_2(n) = chi_3(n) = 1,   chi_4(n) = (-1)**n,   0 < q < 1

(DLMF 20.2(i)); each d before the name is a derivative in z.  In a context `thetas` maps generators
to texts like `re(dtheta4(v - I*b, q**2))`: the argument is linear in real names, with the unit I,
and the nome a power of a constant generator.  Such arguments have no brackets.
"""

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache
from math import lcm, prod
from operator import mul
from typing import NamedTuple

from sympy.polys.domains import QQ
from sympy.polys.matrices import DomainMatrix
from sympy.polys.rings import PolyElement

from rigidsym.proof.kernel._language import KernelError, parse
from rigidsym.proof.kernel._ring import Element, Number, Ring

_NAME = r"[A-Za-z_][A-Za-z_0-9]*"
_CALL = re.compile(rf"(d{{0,4}})theta([1-4])\(([^(),]+), ({_NAME})(?:\*\*([1-9]))?\)")
MOST = 10_000  # classes of exponents of a product, so that no identity takes long


class Theta(NamedTuple):
    """A Jacobi theta function or one of its z-derivatives, at z = x + I*y."""

    order: int  # of the derivative
    index: int
    nome: str
    power: int  # of the nome
    x: PolyElement
    y: PolyElement

    @property
    def parity(self) -> int:
        """Return 1 for an even function of z, -1 for an odd one."""
        return (-1) ** (self.order + (self.index == 1))


def arguments(texts: Iterable[str]) -> Ring:
    """Return a ring of the names in arguments of theta functions, the last of which is I."""
    found = {
        name
        for text in texts
        for call in _CALL.findall(text)
        for name in re.findall(_NAME, call[2])
    }
    return Ring((*sorted(found - {"I"}), "I"), {})


def theta(text: str, ring: Ring) -> Theta:
    """Parse a call of a theta function."""
    if not (found := _CALL.fullmatch(text)):
        raise KernelError(f"{text!a:.80} is no theta function")
    order, index, argument, nome, power = found.groups()
    z = ring.read(argument)
    x, y = parts(z.numerator)
    if z.below or any(sum(powers) != 1 or powers[0] for part in (x, y) for powers in part):
        raise KernelError(f"{argument!r:.80} is not linear in names")
    return Theta(len(order), int(index), nome, int(power or 1), x, y)


def parts(polynomial: PolyElement) -> tuple[PolyElement, PolyElement]:
    """Return the real and the imaginary part of a polynomial that is linear in I."""
    imaginary = polynomial.diff(0)  # I, the last generator of its ring, has the first place
    return polynomial - imaginary * polynomial.ring.gens[0], imaginary


@lru_cache(maxsize=64)
def vanishing(text: str) -> list[tuple[Number, list[str]]]:
    """Check that a sum of theta products vanishes identically, and return its terms.

    A product of r functions of independent forms z = F x is the sum over a = F^T n, n = F^-T a, of
    f(a) q**Q(a) exp(2 i a.x) with Q(a) = sum of p_k n_k**2, f(a) = prod of chi(n_k) (2 i n_k)**d_k.
    So a sum of products is 0 if Q is the same in all of them and the f add up to 0 at each a.

    Let M/2 be a multiple of all denominators in F^-1.  The n of a + M e_i differ from those of a by
    even numbers, which leave chi unchanged: on a class of a modulo M, f is 0, or one sign times the
    polynomial prod (2 i n_k)**d_k in a.  All classes where it is not 0 are reached from one by
    steps of single n_k.  Polynomials that add up to 0 on each class do so at each a.
    """
    calls = [*dict.fromkeys(found[0] for found in _CALL.finditer(text))]
    ring, inner = Ring(tuple(f"x{k}" for k in range(len(calls))), {}), arguments(calls)
    ring.values = dict(zip(map(parse, calls), ring.values.values(), strict=True))  # no other names
    terms = [
        (number, [call for call, power in zip(calls, powers, strict=True) for _ in range(power)])
        for powers, number in ring.read(text).numerator.terms()
    ]
    thetas = {call: theta(call, inner) for call in calls}
    if len({of.nome for of in thetas.values()}) != 1 or any(of.y for of in thetas.values()):
        raise KernelError("an identity is about real multiples of its names, and one nome")
    scale = 2 * _denominator(of.x for of in thetas.values())
    series = [Series(x, [thetas[call] for call in product], inner, scale) for x, product in terms]
    if any(x.exponent != series[0].exponent for x in series):
        raise KernelError("the quadratic forms of the exponents differ")
    period = 2 * lcm(*(_denominator(x.indices) for x in series))
    classes: dict[tuple[int, ...], list[tuple[int, int]]] = {}
    for k, x in enumerate(series):
        for place, sign in x.classes(period).items():
            classes.setdefault((*place, x.imaginary), []).append((k, sign))
    # The same polynomials with the same signs meet on many classes.
    if any(sum(sign * series[k].weight for k, sign in x) for x in {*map(tuple, classes.values())}):
        raise KernelError("the Fourier coefficients do not add up to 0")
    return terms


class Series:
    """The Fourier series of a number times a product of theta functions.

    Names are in units of 1/scale, so that F and all a are made of whole numbers.
    """

    def __init__(self, number: Number, factors: list[Theta], ring: Ring, scale: int) -> None:
        names = ring.poly.gens[1:]
        rows = [[scale * of.x.coeff(name) for name in names] for of in factors]
        matrix = DomainMatrix(rows, (len(factors), len(names)), QQ)
        if len(factors) != len(names) or not 0 < len(names) < 7 or not matrix.det():
            raise KernelError("the arguments of a product are not independent, or not as many")
        columns = zip(*matrix.inv().to_list(), strict=True)
        # n, where names are a
        self.indices = [sum(map(mul, column, names), ring.poly(0)) for column in columns]
        self.exponent = sum(of.power * n**2 for of, n in zip(factors, self.indices, strict=True))
        orders = [of.order for of in factors]
        # i**turns: i for each derivative, -i for each theta_1
        turns = sum(orders) - sum(of.index == 1 for of in factors)
        self.imaginary, sign = turns % 2, (-1) ** (turns % 4 // 2)
        self.weight = prod(map(pow, self.indices, orders)) * number * sign * 2 ** sum(orders)
        self.steps = [([*map(int, row)], of.index) for row, of in zip(rows, factors, strict=True)]

    def classes(self, period: int) -> dict[tuple[int, ...], int]:
        """Return one exponent vector of each residue class, with the sign of `weight` there."""
        halves = [[x // 2 * (index < 3) for x in row] for row, index in self.steps]
        reached = [tuple(sum(column) % period for column in zip(*halves, strict=True))]
        signs = {reached[0]: 1}
        for a in reached:  # which grows
            for row, index in self.steps:
                b = tuple([(x + y) % period for x, y in zip(a, row, strict=True)])
                if b not in signs:
                    signs[b] = -signs[a] if index in (1, 4) else signs[a]
                    reached.append(b)
            if len(reached) > MOST:
                raise KernelError(f"more than {MOST} classes of exponents")
        return signs


def _denominator(polynomials: Iterable[PolyElement]) -> int:
    return lcm(*(int(x.denominator) for polynomial in polynomials for x in polynomial.values()))


class Thetas:
    """The names of a context that are declared to be values of theta functions."""

    def __init__(self, ring: Ring, declared: Mapping[str, str]) -> None:
        """Parse what is declared; `ring` is that of the context, with a last generator I."""
        ring.relations += (ring.read("I**2 + 1").numerator,)
        self.ring, self.declared = ring, declared
        self.names: dict[tuple[str, Theta], str] = {}
        inner = arguments(declared.values())
        for name, text in declared.items():
            if text[:3] not in ("re(", "im(") or text[-1] != ")":
                raise KernelError(f"{text!a:.80} is no part of a theta function")
            of = theta(text[3:-1], inner)
            if not {name, of.nome} <= ring.places.keys():
                raise KernelError(f"{name}, or its nome {of.nome}, is no generator")
            self.names[text[:2], of] = name

    def check(self) -> None:
        """Raise KernelError if a nome moves, or if a derivative is not f'(z) D(z)."""
        read, rates = self.ring.read, self.ring.rates
        if rates is None:
            return
        for (part, of), name in self.names.items():
            if read(f"D({of.nome})").numerator:
                raise KernelError(f"the nome {of.nome} is not constant")
            if rates.get(name, "constant") is None:
                continue
            ((*_, argument, _, _),) = _CALL.findall(self.declared[name])
            slope = read(f"D({argument})")
            if slope.numerator:
                slope *= self.value(of._replace(order=of.order + 1))
            gap = read(f"D({name})*{'I' if part == 'im' else 1}") - slope
            if parts(self.ring.remainder(gap.numerator))[part == "im"]:
                raise KernelError(f"D({name}) is not that of a theta function")

    def at(self, identity: str, forms: Mapping[str, str]) -> tuple[PolyElement, PolyElement]:
        """Return the real and imaginary part of an identity at linear forms: both vanish."""
        inner, total = arguments(self.declared.values()), self.ring.read("0")
        inner.values = {name: inner.read(text) for name, text in forms.items()}
        for number, product in vanishing(identity):
            factors = [theta(call, inner) for call in product]
            if not any(of.parity < 0 and not of.x and not of.y for of in factors):
                total += prod(map(self.value, factors), start=self.ring.read(str(number)))
        return parts(self.ring.remainder(total.numerator))

    def value(self, of: Theta) -> Element:
        """Return f(z), by f(-z) = +-f(z) and f(conj z) = conj f(z)."""
        total, odd, (x, y) = self.ring.read("0"), of.parity, (of.x, of.y)
        for part, unit, conjugate in (("re", "1", 1), ("im", "I", -1)):
            images = [(1, x, y), (odd, -x, -y), (conjugate, x, -y), (odd * conjugate, -x, y)]
            if (-1, x, y) in images:
                continue  # this part is zero
            named = [(sign, self.names.get((part, of._replace(x=a, y=b)))) for sign, a, b in images]
            if not (known := [f"{sign}*{name}*{unit}" for sign, name in named if name]):
                name = f"{part}({'d' * of.order}theta{of.index})"
                raise KernelError(f"{name} is not declared at {x} + I*({y})")
            total += self.ring.read(known[0])
        return total
