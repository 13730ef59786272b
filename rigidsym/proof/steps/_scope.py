"""SymPy's representation of a context: names, named matrices and time derivative."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any

import sympy
from sympy import Eq, Identity, ImmutableMatrix, Inverse, MatrixExpr, MatrixSymbol

from rigidsym.language._expression import parse, to_text
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._builder import Source
from rigidsym.proof.algebra._computation import Computation, computed
from rigidsym.proof.algebra._rational import cancel
from rigidsym.proof.kernel import Context, Fact, KernelError, Ring
from rigidsym.proof.steps._matrices import (
    SIZE,
    Real,
    determinant,
    entries,
    explicit,
    indices,
    part_name,
    split,
)
from rigidsym.proof.steps._names import Dictionary, collected, positive, read, symbol
from rigidsym.proof.steps._record import Step, StepError

ONE = Identity(SIZE)
MULTIPLIED = "an equation between named matrices: the kernel multiplies both sides out"
SOLVED = "an equation between named matrices, solved for one of them by hand"
# Quantities that never vanish for a moving body.
STANDING = {*map(symbol, ["c1", "c2", "c3", "c_i", "c_j", "c_k", "K"])}


class Scope:
    """A context of a ledger, with SymPy expressions for its names and its matrices."""

    def __init__(
        self, builder: LedgerBuilder, context: Context, matrices: Mapping[str, ImmutableMatrix]
    ) -> None:
        self.builder, self.context, self.matrices = builder, context, dict(matrices)
        self.dictionary = Dictionary(context)

    @classmethod
    def open(
        cls,
        builder: LedgerBuilder,
        name: str,
        *parts: Part,
        matrices: Mapping[str, ImmutableMatrix | MatrixExpr] | None = None,
        static: bool = False,
    ) -> "Scope":
        """Create a context from parts and named matrices, and add it to the ledger.

        A matrix is explicit, or an expression in those before it.
        """
        scope = cls(builder, join(name, *parts, static=static), {})
        for matrix, value in (matrices or {}).items():
            scope._define(matrix, value)
        builder.open(scope.context)
        scope.context = builder.ledger.contexts[name]
        builder.matrices[name] = dict(matrices or {})
        return scope

    def _define(self, name: str, value: ImmutableMatrix | MatrixExpr) -> None:
        if isinstance(value, MatrixExpr) and not isinstance(value, ImmutableMatrix):
            found, known = self.entries(value), self.explicit(value)
        else:
            found = {
                (i, j): tuple(self.text(x) if x else None for x in split(value[i - 1, j - 1]))
                for i, j in indices(value.rows)
            }
            known = value
        texts = {
            part_name(name, index, k): text
            for index, parts in found.items()
            for k, text in enumerate(parts)
            if text is not None
        }
        definitions = {**self.context.definitions, **texts}
        self.context = replace(self.context, definitions=definitions)
        self.matrices[name] = known

    def where(self, name: str, *nonzero: sympy.Expr) -> "Scope":
        """Return a copy of the context in which further quantities are nonzero.

        It is added to the ledger under another name.
        """
        units = tuple(map(self.text, nonzero))
        narrower = replace(self.context, name=name, units=(*self.context.units, *units))
        self.builder.open(narrower)
        self.builder.matrices[name] = self.builder.matrices.get(self.name, {})
        return Scope(self.builder, self.builder.ledger.contexts[name], self.matrices)

    @property
    def name(self) -> str:
        """The name of the context."""
        return self.context.name

    def fact(self, name: str) -> str:
        """Return the id of a fact: the part before a dot is its context, this one if none is."""
        return name if "." in name else f"{self.name}.{name}"

    @property
    def ring(self) -> Ring:
        """The kernel's ring of the context."""
        return self.builder.ledger.rings[self.name]

    def text(self, expression: sympy.Expr | Computation | int | str) -> str:
        """Convert a SymPy expression to text that the kernel can parse.

        Texts are returned unchanged.
        """
        return expression if isinstance(expression, str) else self.dictionary.text(expression)

    def read(self, text: str) -> sympy.Expr:
        """Convert an expression of the ledger to SymPy, with names replaced by functions."""
        return self.dictionary.meant(read(text))

    def entries(self, expression: MatrixExpr) -> dict[tuple[int, int], tuple[str | None, ...]]:
        """Return the real and imaginary parts of a matrix expression's entries as texts.

        Products are not multiplied out.
        """
        trees = entries(expression, self.matrices, lambda factor: parse(self.text(factor)))
        return {index: tuple(map(_printed, parts)) for index, parts in trees.items()}

    def determinant(self, expression: MatrixExpr) -> tuple[str, str | None]:
        """Return the real and imaginary part of a determinant as texts."""
        trees = entries(expression, self.matrices, lambda factor: parse(self.text(factor)))
        real, imaginary = determinant(trees)
        return _printed(real) or "0", _printed(imaginary)

    def explicit(self, expression: MatrixExpr) -> ImmutableMatrix:
        """Multiply out an expression in named matrices with SymPy."""
        return explicit(expression, self.matrices, self.rate)

    @cached_property
    def _rates(self) -> Mapping[sympy.Symbol, sympy.Expr]:
        rates = self.context.rates
        if rates is None:
            raise StepError(f"D: {self.name} has no time derivative")
        return {symbol(name): read(text) for name, text in rates.items() if text != "?"}

    def rate(self, expression: sympy.Expr) -> sympy.Expr:
        """Return the time derivative of an expression.

        The context gives the time derivatives of its names.
        """
        named = self.dictionary.named(sympy.sympify(expression))
        return sympy.expand(self.dictionary.meant(self._named_rate(named)))

    def _named_rate(self, named: sympy.Expr) -> sympy.Expr:
        total = sympy.S.Zero
        for name in map(symbol, sorted(map(str, named.free_symbols))):
            total += sympy.diff(named, name) * self._rate_of(name)
        return total

    def _rate_of(self, name: sympy.Symbol) -> sympy.Expr:
        if name in self._rates:
            return self._rates[name]
        if str(name) in self.context.definitions:
            return self._named_rate(read(self.context.definitions[str(name)]))
        if self.context.rates is not None and self.context.rates.get(str(name)) == "?":
            raise StepError(f"D({name}) is not known in {self.name}")
        return sympy.S.Zero

    def rates(self, expression: sympy.Expr) -> tuple[sympy.Expr, sympy.Expr]:
        """Return two forms of a time derivative: in names, and with definitions expanded."""
        rate = self.rate(expression)
        texts = self.context.definitions
        written = rate
        while known := {
            x: self.read(texts[str(x)]) for x in written.free_symbols if str(x) in texts
        }:
            written = written.subs(known)
        return rate, sympy.expand(written)

    def reduced(self, expression: sympy.Expr) -> sympy.Expr:
        """Simplify an expression modulo the relations of the context.

        Numerator and denominator are reduced, and the quotient is collected.
        """
        named = self.dictionary.named(expression)
        parts = sympy.fraction(sympy.together(named))
        if self.context.relations and {*map(str, named.free_symbols)} <= {*self.context.generators}:
            parts = tuple(self._modulo(part) for part in parts)
        return collected(self.dictionary.meant(cancel(parts[0] / parts[1])))

    def _modulo(self, polynomial: sympy.Expr) -> sympy.Expr:
        """Reduce a polynomial modulo the relations of the context.

        It is returned unchanged if that makes it longer.
        """
        numerator = self.ring.read(self.text(sympy.expand(polynomial))).numerator
        rest = read(str(self.ring.remainder(numerator)))
        return min(polynomial, rest, key=lambda x: sympy.count_ops(sympy.expand(x)))

    def divisors(self, *expressions: sympy.Expr) -> tuple[sympy.Expr, ...]:
        """Return the distinct factors in the denominators of expressions.

        Quantities that never vanish, such as a moment of inertia, are left out.
        """
        found: dict[sympy.Expr, None] = {}
        for expression in expressions:
            below = sympy.denom(sympy.together(expression))
            if below.is_Number:
                continue
            numerator = self.ring.read(self.text(below)).numerator
            factors = sympy.factor_list(read(str(self.ring.remainder(numerator))))[1]
            unknown = (x for x, _ in factors if x not in STANDING)
            found.update((self.dictionary.meant(positive(x)), None) for x in unknown)
        return tuple(sorted(found, key=sympy.default_sort_key))

    def decide(
        self,
        fact_id: str,
        pairs: Iterable[tuple[Any, Any]],
        source: Source,
        origin: Computation | None = None,
        law: str = "",
        why: str = "",
    ) -> Fact:
        """Prove equations with the kernel.

        `origin` is the computation that found their right sides, if one did; else they
        are a `law`, or `why` says why they were not computed.
        Raises StepError if the kernel cannot decide them.
        """
        texts = [(self.text(left), computed(self.text(right), origin)) for left, right in pairs]
        try:
            return self.builder.claim(self.fact(fact_id), texts, source, law, why)
        except KernelError as error:
            raise StepError(str(error)) from None

    def decide_matrices(
        self,
        fact_id: str,
        left: MatrixExpr,
        right: MatrixExpr,
        source: Source,
        origin: Computation | None = None,
    ) -> Fact:
        """Prove an equation of matrices with the kernel, entry by entry.

        Raises StepError where both are the same, or an inverted matrix is not unitary.
        """
        for inverse in sorted(left.atoms(Inverse) | right.atoms(Inverse), key=str):
            product = self.entrywise(inverse.arg * inverse.arg.adjoint(), ONE)
            gaps = (self.ring.read(x) - self.ring.read(y) for x, y in product)
            if any(self.ring.remainder(gap.numerator) for gap in gaps):
                raise StepError(f"fact {fact_id}: {inverse.arg} is not unitary: no inverse of it")
        pairs = self.entrywise(left, right)
        if not pairs:
            raise StepError(f"fact {fact_id}: both sides are the same: {left}")
        why = SOLVED if isinstance(left, MatrixSymbol) else MULTIPLIED
        return self.decide(fact_id, pairs, source, origin, why=why)

    def entrywise(self, left: MatrixExpr, right: MatrixExpr) -> list[tuple[str, str]]:
        """Return the equations between corresponding entries of two matrices.

        Equal entries are left out.
        """
        x, y = self.entries(left), self.entries(right)
        return [
            (a or "0", b or "0")
            for index in x
            for a, b in zip(x[index], y[index], strict=True)
            if a != b
        ]

    def at(self, fact_id: str, *nonzero: sympy.Expr) -> "Scope":
        """Return the scope of a fact's context, creating the context if necessary.

        In a new context the given quantities are nonzero.
        """
        name = self.fact(fact_id).split(".")[0]
        if name == self.name:
            return self
        if name in self.builder.ledger.contexts:
            return Scope(self.builder, self.builder.ledger.contexts[name], self.matrices)
        return self.where(name, *nonzero)

    def note(
        self,
        verb: str,
        why: str,
        value: Any,
        equations: Iterable[tuple[sympy.Basic, sympy.Basic]],
        fact: Fact,
        conditions: tuple[sympy.Expr, ...] = (),
        choice: str = "",
    ) -> Step:
        """Record a derivation step in the builder and return it."""
        shown = tuple(Eq(left, right, evaluate=False) for left, right in equations)
        step = Step(verb, why, value, shown, fact, conditions, choice)
        self.builder.steps.append(step)
        return step


def _printed(tree: Real) -> str | None:
    return None if tree is None else to_text(tree)
