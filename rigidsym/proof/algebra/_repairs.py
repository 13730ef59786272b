"""Search for small edits of a printed line that turn a false statement into an identity.

The edits are those of mutants, and insertions of a sign, of a derivative, or of a constant or its
square as a factor or divisor.  Edits that fail at a rational point of the context are dropped, the
others are decided by normal form.  Every repair is therefore a proved identity under the same
hypotheses.
"""

import ast
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

from flint import fmpq

from rigidsym.proof.algebra._mutants import decide, edits, variants
from rigidsym.proof.kernel import Context, Fact, KernelError, Ledger, Ring

MOST = 3
_SIDES = ("lhs", "rhs")


def repairs(ledger: Ledger, fact_id: str, place: str, component: int = 0) -> list[tuple[str, str]]:
    """Return the shortest proved repairs of a refuted fact.

    There are at most `MOST`, each a pair of sides (lhs, rhs), or of a name and its definition.
    `place` is what the paper prints: a side of the statement, or a definition of its context.
    `component` says which of several components to mend.
    """
    whole = ledger.facts[fact_id]
    fact = replace(whole, lhs=(whole.lhs[component],), rhs=(whole.rhs[component],))
    context, ring = ledger.contexts[fact.context], ledger.rings[fact.context]
    printed = fact.rhs[0] if place == "rhs" else fact.lhs[0]
    printed = context.definitions.get(place, printed)
    instants = [Instant(context, point) for point in _points(ledger, context)]
    found: dict[str, tuple[str, str]] = {}
    for text in sorted({*_edited(printed, context, ring)}, key=lambda text: (len(text), text)):
        lhs, rhs = _statement(fact, place, text)
        changed = {} if place in _SIDES else {place: text}
        if not all(instant.agree(lhs, rhs, changed) for instant in instants):
            continue
        mended = _ring(context, ring, changed)
        new = all(decide(ring, text, other) != "equivalent" for other in found)
        if new and mended and decide(mended, lhs, rhs) == "equivalent":
            found[text] = (lhs, rhs) if place in _SIDES else (place, text)
    return list(found.values())[:MOST]


def _edited(printed: str, context: Context, ring: Ring) -> Iterator[str]:
    factors: list[ast.expr]
    factors = [ast.Name(name) for name in context.generators if name not in (context.rates or ())]
    factors += [ast.BinOp(name, ast.Pow(), ast.Constant(2)) for name in factors]
    factors += [ast.Constant(2)]

    def wider(node: ast.AST) -> Iterator[tuple[str, ast.expr]]:
        yield from variants(node, ring.values)
        if isinstance(node, ast.Name | ast.BinOp | ast.Constant):
            yield "sign", ast.UnaryOp(ast.USub(), node)
            for factor in factors:
                one = isinstance(node, ast.Constant) and node.value == 1
                yield "factor", factor if one else ast.BinOp(factor, ast.Mult(), node)
                yield "divisor", ast.BinOp(node, ast.Div(), factor)
            if context.rates is not None:
                yield "derivative", ast.Call(ast.Name("D"), [node], [])

    yield from (edit() for _, edit in edits(printed, wider))


def _statement(fact: Fact, place: str, text: str) -> tuple[str, str]:
    lhs, rhs = fact.lhs[0], fact.rhs[0]
    return {"lhs": (text, rhs), "rhs": (lhs, text)}.get(place, (lhs, rhs))


def _ring(context: Context, ring: Ring, changed: Mapping[str, str]) -> Ring | None:
    """Return a context's ring with changed definitions, or None if the kernel refuses them."""
    if not changed:
        return ring
    try:
        return replace(context, definitions={**context.definitions, **changed}).open()
    except KernelError:
        return None


def _points(ledger: Ledger, context: Context) -> Iterable[Mapping[str, str]]:
    """Yield the known rational points of a context.

    These are its witness and the points of its counterexamples.
    """
    yield context.witness
    for fact in ledger.facts.values():
        if fact.context == context.name and fact.kind == "unequal":
            yield fact.certificate["point"]


_STILL = fmpq(0)


@dataclass(frozen=True, slots=True)
class Jet:
    """A rational value with its time derivative.

    The derivative is None if it is unknown.
    """

    value: fmpq
    rate: fmpq | None = _STILL

    def plus(self, other: "Jet") -> "Jet":
        """Return the sum of two jets."""
        unknown = self.rate is None or other.rate is None
        return Jet(self.value + other.value, None if unknown else self.rate + other.rate)

    def times(self, other: "Jet") -> "Jet":
        """Return the product of two jets."""
        unknown = self.rate is None or other.rate is None
        rate = None if unknown else self.rate * other.value + self.value * other.rate
        return Jet(self.value * other.value, rate)

    def power(self, exponent: int) -> "Jet":
        """Return an integer power of a jet.

        Raises ZeroDivisionError if it is undefined.
        """
        slope = exponent * self.value ** (exponent - 1)
        return Jet(self.value**exponent, None if self.rate is None else slope * self.rate)


_MINUS = Jet(fmpq(-1))
_OPERATIONS: dict[type, Callable[[Jet, Jet], Jet]] = {
    ast.Add: Jet.plus,
    ast.Sub: lambda left, right: left.plus(_MINUS.times(right)),
    ast.Mult: Jet.times,
    ast.Div: lambda left, right: left.times(right.power(-1)),
}


class UnknownRateError(ValueError):
    """Error for a time derivative that the context does not determine.

    It is a second derivative, or a derivative that the context leaves unknown.
    """


class Instant:
    """A rational point at which a context's expressions are evaluated exactly.

    Time derivatives are evaluated, too.
    """

    def __init__(self, context: Context, point: Mapping[str, str]) -> None:
        self.definitions, self.rates = context.definitions, context.rates or {}
        self.still = {name: Jet(fmpq(value)) for name, value in point.items()}
        self.moving = self._moving({})

    def _moving(self, changed: Mapping[str, str]) -> dict[str, Jet]:
        """Return the values and time derivatives of generators under changed definitions."""
        known = {**self.still, **changed}
        rates = {
            name: None if text == "?" else self._value(text, dict(known)).value
            for name, text in self.rates.items()
        }
        return {name: Jet(jet.value, rates.get(name, jet.rate)) for name, jet in self.still.items()}

    def agree(self, lhs: str, rhs: str, changed: Mapping[str, str]) -> bool:
        """Return whether an equation can hold at the point under changed definitions.

        Returns True if a side needs an unknown time derivative.
        """
        try:
            moving = self._moving(changed) if changed else self.moving
            known: dict[str, Jet | str] = {**moving, **changed}
            left, right = (self._value(side, known).value for side in (lhs, rhs))
        except (ZeroDivisionError, KernelError):
            return False
        except UnknownRateError:
            return True
        return left == right

    def _value(self, text: str, known: dict[str, Jet | str]) -> Jet:
        return self._jet(_parsed(text), known)

    def _jet(self, node: ast.expr, known: dict[str, Jet | str]) -> Jet:
        match node:
            case ast.Constant(value=int(number)):
                return Jet(fmpq(number))
            case ast.Name(id=name):
                found = known[name] if name in known else self.definitions[name]
                if isinstance(found, str):
                    found = known[name] = self._value(found, known)
                return found
            case ast.UnaryOp(operand=operand):
                return _MINUS.times(self._jet(operand, known))
            case ast.Call(args=[argument]):
                if (rate := self._jet(argument, known).rate) is None:
                    raise UnknownRateError
                return Jet(rate, None)
            case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int(exponent))):
                return self._jet(left, known).power(exponent)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATIONS:
                return _OPERATIONS[type(op)](self._jet(left, known), self._jet(right, known))
        raise KernelError(f"{ast.unparse(node)!r} is no number")


@lru_cache(maxsize=4096)
def _parsed(text: str) -> ast.expr:
    return ast.parse(text, mode="eval").body
