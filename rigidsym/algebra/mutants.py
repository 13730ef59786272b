"""Mutants: proved statements made wrong on purpose, to see that the same proof refuses them.

A proof that would also accept a changed sign, index or power proves nothing about them.  Each
mutant changes one place of one side of one component; it is `refuted` (its normal form is not
zero), `refused` (it divides by something the hypotheses do not cover) or `equivalent` (it is an
identity too, as the same decision shows).
"""

import ast
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import chain, islice, zip_longest

from rigidsym.kernel import Element, Fact, KernelError, Ledger, Ring

EACH = 16
# Long statements are changed near their top: the walk goes by depth.
PLACES = 30
# Squares of longer quantities take long to expand and say no more.
SHORT = 5
_PARTNERS = {"sn": "cn", "cn": "sn", "s": "c", "c": "s", "m": "m_1"}
_INDEX = {"1": "2", "2": "3", "3": "1", "a": "b", "b": "d", "d": "a"}


def tally(ledger: Ledger, each: int = EACH) -> dict[str, dict[str, int]]:
    """For every fact decided by normal form: how its mutants, at most `each`, are accounted for."""
    decided = [fact for fact in ledger.facts.values() if fact.rule in ("identity", "root")]
    return {fact.id: _account(ledger.rings[fact.context], fact, each) for fact in decided}


def _account(ring: Ring, fact: Fact, each: int) -> dict[str, int]:
    power = 2 if fact.kind == "root" else 1
    found: Counter[str] = Counter()
    for lhs, rhs in islice(mutants(fact, ring), each):
        found[_decide(ring, lhs, rhs, power)] += 1
    return dict(sorted(found.items()))


def _decide(ring: Ring, lhs: str, rhs: str, power: int) -> str:
    try:
        difference = (ring.read(lhs) ** power - ring.read(rhs)).numerator
    except KernelError:
        return "refused"
    return "refuted" if ring.reduce(difference)[1] else "equivalent"


def mutants(fact: Fact, ring: Ring) -> Iterator[tuple[str, str]]:
    """(lhs, rhs) of one component each, one place changed; kinds of change take turns."""
    kinds: dict[str, list[tuple[str, str]]] = {}
    known = ring.names
    sides = list(dict.fromkeys(zip(fact.lhs, fact.rhs, strict=True)))
    for lhs, rhs in [side for side in sides if side[0] != side[1]] or sides:
        for kind, text in _changes(rhs, known):
            kinds.setdefault(kind, []).append((lhs, text))
        if fact.kind == "equal":
            for kind, text in _changes(lhs, known):
                kinds.setdefault(kind, []).append((text, rhs))
    turns = chain.from_iterable(zip_longest(*kinds.values()))
    yield from dict.fromkeys(mutant for mutant in turns if mutant is not None)


def _changes(text: str, known: Mapping[str, Element]) -> Iterator[tuple[str, str]]:
    """Every text that differs from this one in one place, with the kind of change."""
    tree = ast.parse(text, mode="eval")
    for place, node in enumerate(islice(ast.walk(tree), PLACES)):
        for kind, changed in _variants(node, known):
            yield kind, ast.unparse(_replaced(text, place, changed))
    yield "factor", f"2*({text})"
    yield "offset", f"({text}) + 1"


def _variants(node: ast.AST, known: Mapping[str, Element]) -> Iterator[tuple[str, ast.expr]]:
    match node:
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            yield "sign", ast.BinOp(left, ast.Sub(), right)
            yield "missing term", left
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            yield "sign", ast.BinOp(left, ast.Add(), right)
            yield "missing term", left
        case ast.BinOp(left=base, op=ast.Pow(), right=ast.Constant(value=int(exponent))):
            yield "power", ast.BinOp(base, ast.Pow(), ast.Constant(exponent + 1))
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            yield "missing factor", left
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            yield "sign", operand
        case ast.Name(id=name):
            yield from (("index", ast.Name(other)) for other in _others(name, known))
            if name in known and len(known[name].numerator) < SHORT:
                yield "square", ast.BinOp(node, ast.Pow(), ast.Constant(2))
            yield "double", ast.BinOp(ast.Constant(2), ast.Mult(), node)
        case ast.Call(args=[argument]):
            yield "no derivative", argument


def _others(name: str, known: Mapping[str, Element]) -> Iterator[str]:
    """The same quantity of the next axis, and the function that is easily taken for this one."""
    axis = re.fullmatch(r"(.*?)([123]|(?<=_)[abd])(_rate|_squared)?", name)
    candidates = [_PARTNERS.get(name, "")]
    if axis:
        candidates.append(axis[1] + _INDEX[axis[2]] + (axis[3] or ""))
    return (candidate for candidate in candidates if candidate in known)


def _replaced(text: str, place: int, changed: ast.expr) -> ast.AST:
    """A fresh tree of the text with the node at one place of the walk changed."""
    tree = ast.parse(text, mode="eval")
    target = list(ast.walk(tree))[place]

    class Swap(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            return changed if node is target else super().visit(node)

    return Swap().visit(tree)
