"""Arithmetic in a context as a list of computation steps that Coq checks.

The kernel's own ring computes the certificates; Coq checks them again.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from copy import copy

from sympy.polys.rings import PolyElement

from rigidsym.proof._coq.text import data, derivatives, divisors, listed, names_in, rational, terms
from rigidsym.proof.algebra._normal_form import divide, quotients
from rigidsym.proof.kernel import Context, Element, Ring
from rigidsym.proof.kernel._language import Tree, parse


class NotExportedError(ValueError):
    """Error for a fact that cannot be stated or proved in Coq.

    The message gives the reason.
    """


class Theory:
    """Computation steps for Coq, and the kernel ring that provides their certificates.

    `given` are Coq terms that prove the hypotheses of the steps.
    """

    def __init__(self, context: Context) -> None:
        """Start with a context's generators and assign indices to its definitions."""
        self.context = context
        self.ring = Ring(context.generators, context.definitions)
        self.texts: dict[str, Tree] = {n: parse(t) for n, t in context.definitions.items()}
        self.index = {name: k for k, name in enumerate(context.generators, 1)}
        self.steps = [f"Generator {k}" for k in self.index.values()]
        self.given: list[str] = []
        self.extra: tuple[PolyElement, ...] = ()
        self._inverted: set[Tree] = set()
        self._slopes: set[Tree] = set()
        self._defined: set[str] = set()
        self._place(context.definitions)

    def _place(self, names: Iterable[str]) -> None:
        """Assign indices to definitions, so that each comes after the definitions that it uses."""
        for name in names:
            if name in self.texts and name not in self.index:
                self._place(x for x in names_in(self.texts[name]) if x != name)
                self.index[name] = len(self.index) + 1

    def extended(self) -> "Theory":
        """Return a copy of the theory to be extended, with empty lists of steps and proofs."""
        more = copy(self)
        more.ring = copy(self.ring)
        more.ring.values = dict(self.ring.values)
        more.texts, more.index = dict(self.texts), dict(self.index)
        more.steps, more.given = [], []
        more._inverted, more._slopes = set(self._inverted), set(self._slopes)
        more._defined = set(self._defined)
        return more

    @property
    def names(self) -> list[str]:
        """All names in the order of their indices."""
        return list(self.index)

    def unit(self, text: str, proof: str) -> None:
        """Add the hypothesis that an expression is not zero."""
        value = self.read(parse(text))
        self._step(f"Unit {self.data(text)}", proof)
        self.ring.units += (value.numerator,)

    def relation(self, text: str, proof: str) -> None:
        """Add the hypothesis that an expression is zero."""
        value = self.read(parse(text))
        self._step(f"Relation {self.data(text)}", proof)
        self.ring.relations += (value.numerator,)

    def premise(self, tree: Tree, proof: str) -> None:
        """Add a proved equation in the form expression = 0.

        In divisions it precedes all relations.
        """
        numerator = self.read(tree).numerator
        self._step(f"Relation {data(tree, self.index)}", proof)
        self.extra += (numerator,)

    def rate(self, name: str, text: str, proof: str) -> None:
        """Add the hypothesis that a generator has a given time derivative."""
        tree = parse(text)
        self.read(tree)
        self._step(f"Moves {self.index[name]} {data(tree, self.index)}", proof)
        self._slopes.add(name)

    def sign(self, text: str, proof: str) -> None:
        """Add the hypothesis that an expression is nonnegative."""
        self.define(*names_in(parse(text)))
        self._step(f"Sign {self.data(text)}", proof)

    def alias(self, name: str, own: str, tree: Tree, proof: str) -> None:
        """Add a second name for an expression.

        If this context has a name of its own for the expression, that name's normal form is used.
        """
        value = self.read(tree)
        self.index[name] = len(self.index) + 1
        place, text = self.index[name], data(tree, self.index)
        if own in self.index:
            self._step(
                f"Rename {place} {text} (Var {self.index[own]}) {self.gap(tree, own)}", proof
            )
            value = self.ring.read(own)
        else:
            self._step(f"Define {place} {text}", proof)
        self.ring.values[name] = value
        self.texts[name] = tree
        self._defined.add(name)

    def _step(self, step: str, proof: str | None = None) -> None:
        self.steps.append(step)
        if proof is not None:
            self.given.append(proof)

    def define(self, *names: str) -> None:
        """Add a definition step for each given name that has none yet."""
        for name in names:
            if name in self.texts and name not in self._defined:
                self._defined.add(name)
                tree = self.texts[name]
                self.ready(tree)
                constant = "fun t => eq_refl"
                self._step(f"Define {self.index[name]} {data(tree, self.index)}", constant)
                self.ring.read(name)

    def ready(self, tree: Tree) -> None:
        """Add steps for the definitions, inverses and derivatives in an expression."""
        self.define(*names_in(tree))
        for divisor in divisors(tree):
            self.invert(divisor)
        for inner in derivatives(tree):
            self.differentiate(inner)

    def read(self, tree: Tree) -> Element:
        """Return the ring element of an expression.

        Adds the steps that Coq needs to read the expression.
        """
        self.ready(tree)
        return self.ring.value(tree)

    def invert(self, tree: Tree) -> None:
        """Add a step that inverts an expression.

        Raises NotExportedError unless the expression is a product of units.
        """
        if isinstance(tree, int) or tree in self._inverted:
            return
        value = self.read(tree)
        below, rest = self.ring._factors(value.numerator)
        cofactors: Sequence[PolyElement] = ()
        if not rest.is_ground:
            cofactors, remainder = quotients(value.numerator, self.ring.relations)
            below, rest = self.ring._factors(remainder)
        if not rest or not rest.is_ground:
            raise NotExportedError(f"1/({value.numerator!s:.60}): no product of units")
        self._inverted.add(tree)
        number, what = f"(ratio {rational(rest.LC)})", data(tree, self.index)
        self._step(f"Invert {what} {number} {self.powers(below)} {self.rows(cofactors)}")

    def differentiate(self, tree: Tree) -> None:
        """Add a step that computes the time derivative of an expression.

        The derivative is in the kernel's normal form.
        """
        if tree in self._slopes:
            return
        self.ready(tree)
        body = self.texts.get(tree, tree) if isinstance(tree, str) else tree
        if body == tree and isinstance(tree, str):
            raise NotExportedError(f"D({tree}) is not known")
        for name in names_in(body):
            self.differentiate(name)
        target = self.ring.rate(self.ring.value(tree))
        gap = self._slope(body) - target
        cofactors, remainder = self.reduce(gap.numerator)
        if remainder:
            raise NotExportedError(f"the derivative of {tree!s:.60} has no certificate")
        self._slopes.add(tree)
        form = f"{terms(target.numerator, self.index)} {self.powers(target.below)}"
        what = data(tree, self.index)
        self._step(f"Differentiate {what} {form} {self.rows(cofactors)}")

    def _slope(self, tree: Tree) -> Element:
        """Return the time derivative of an expression, computed as in the Coq prelude.

        The prelude's function is called `slope`.
        """
        ring = self.ring
        match tree:
            case int():
                return ring.value(0)
            case str():
                return ring.rate(ring.value(tree))
            case ("D", "(", _):
                raise NotExportedError("a second derivative")
            case ("-", argument):
                return -self._slope(argument)
            case (base, "**", int(exponent)):
                value = ring.value(base)
                lower = value ** (exponent - 1) if exponent > 1 else ring.value(1)
                return self._slope(base) * ring.value(exponent) * lower
        total, rate = ring.value(tree[0]), self._slope(tree[0])
        for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
            value, slope = ring.value(operand), self._slope(operand)
            match operator:
                case "+":
                    total, rate = total + value, rate + slope
                case "-":
                    total, rate = total - value, rate - slope
                case "*":
                    total, rate = total * value, rate * value + total * slope
                case _:
                    inverse = ring.inverse(value)
                    rate = rate * inverse - total * slope * (inverse * inverse)
                    total = total * inverse
        return rate

    def reduce(self, polynomial: PolyElement) -> tuple[list[PolyElement], PolyElement]:
        """Divide a polynomial by all premises and relations.

        Returns the cofactors of the relations, then those of the premises, and the remainder.
        If premises and relations together leave a remainder, the relations alone may not.
        """
        cofactors, remainder = quotients(polynomial, self.extra + self.ring.relations)
        if remainder:
            return divide(self.ring, polynomial)
        count = len(self.extra)
        return [*cofactors[count:], *cofactors[:count]], remainder

    def rows(self, cofactors: Sequence[PolyElement]) -> str:
        """Return cofactors as a Coq list, without trailing zeros."""
        kept = list(cofactors)
        while kept and not kept[-1]:
            kept.pop()
        return listed(terms(polynomial, self.index) for polynomial in kept)

    def powers(self, below: Counter[PolyElement]) -> str:
        """Return the multiplicities of units in a denominator as a Coq list.

        A unit that is listed twice is counted once.
        """
        left = Counter(below)
        return f"{listed(left.pop(unit, 0) for unit in self.ring.units)}%nat"

    def gap(self, left: Tree, right: Tree) -> str:
        """Return the cofactors that prove two expressions equal, as a Coq list.

        Division by the premises and relations finds them.
        """
        difference = (self.read(left) - self.read(right)).numerator
        cofactors, remainder = self.reduce(difference)
        if remainder:
            raise NotExportedError(f"no certificate for {left!s:.60} = {right!s:.60}")
        return self.rows(cofactors)

    def data(self, text: str) -> str:
        """Return an expression as a Coq term of the prelude's type `expr`."""
        return data(parse(text), self.index)
