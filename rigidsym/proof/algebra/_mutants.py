"""Mutants of proved statements, to test that proofs reject wrong statements.

A proof that would also accept a changed sign, index or power proves nothing about them.  Each
mutant changes one place of one side of one component.  It is `refuted` (its normal form is not
zero), `refused` (it divides by something the hypotheses do not cover) or `equivalent` (it is an
identity too, by the same decision).  Mutants of enclosed facts are decided by balls in the same
way: the balls exclude a mutant, have no value for it, or agree with it too.
"""

import ast
import json
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import chain, islice, zip_longest
from typing import TypeAlias

from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.algebra._normal_form import divide
from rigidsym.proof.kernel import Context, Element, Fact, KernelError, Ledger, Ring
from rigidsym.proof.kernel._language import Tree
from rigidsym.proof.kernel._ring import Number, at

EACH = 16
# A part of the ids of all facts about printed lines.
PRINTED = ".print_"
# The number of nodes changed in a long statement; the walk is breadth-first.
PLACES = 30
# Only quantities with fewer terms are squared; longer ones take long to expand.
SHORT = 5
# The replacements of one node of a text, each with the kind of change.
Fates: TypeAlias = dict[str, int]
Variants = Callable[[ast.AST], Iterator[tuple[str, ast.expr]]]
Edit = Callable[[], str]
_PARTNERS = {"sn": "cn", "cn": "sn", "s": "c", "c": "s", "m": "m_1"}
_INDEX = {"1": "2", "2": "3", "3": "1", "a": "b", "b": "d", "d": "a"}


def tally(
    ledger: Ledger, known: Mapping[str, Fates] | None = None, each: int = EACH
) -> dict[str, Fates]:
    """Count the refuted, refused and equivalent mutants of each decided fact.

    At most `each` mutants of a fact are tried.
    Facts in `known` keep their counts.
    Facts about printed lines are left out: tests change one place of the printed LaTeX instead.
    """
    decided = [
        fact
        for fact in ledger.facts.values()
        if fact.rule in ("identity", "assumption") and PRINTED not in fact.id
    ]
    known = known or {}
    return {fact.id: known.get(fact.id) or _account(ledger, fact, each) for fact in decided}


def known_fates(ledger: Ledger, text: str) -> dict[str, Fates]:
    """Return the mutant counts in a written ledger for facts that have not changed.

    Their contexts have to be unchanged, too.
    """
    here, there = json.loads(ledger.to_text()), json.loads(text)
    contexts = {each["name"]: each for each in there["contexts"]}
    same = {each["name"] for each in here["contexts"] if each == contexts.get(each["name"])}
    facts = {each["id"]: each for each in there["facts"]}
    fates = there["published"].get("mutants", {})
    return {
        each["id"]: fates[each["id"]]
        for each in here["facts"]
        if each["id"] in fates and each["context"] in same and each == facts.get(each["id"])
    }


def _account(ledger: Ledger, fact: Fact, each: int) -> Fates:
    ring, power = ledger.rings[fact.context], 2 if fact.kind == "root" else 1
    context = ledger.contexts[fact.context]
    point = context.check_point(ring, context.witness)
    found: Counter[str] = Counter()
    for lhs, rhs in islice(mutants(fact, ring), each):
        if fact.rule == "identity":
            fate = decide(ring, lhs, rhs, power, point)
        else:
            fate = _enclose(context, replace(fact, lhs=(lhs,), rhs=(rhs,)))
        found[fate] += 1
    return dict(sorted(found.items()))


def _enclose(context: Context, mutant: Fact) -> str:
    try:
        agreed = encloses(context, mutant, mutant.certificate["points"])
    except KernelError:
        return "refused"
    return "equivalent" if agreed else "refuted"


def decide(
    ring: Ring, lhs: str, rhs: str, power: int = 1, point: list[Number] | None = None
) -> str:
    """Decide whether a mutated equation is refuted, refused or equivalent.

    The equation is lhs**power = rhs.  Its normal form decides.
    If the sides differ at a point of the context, they are refuted without a normal form.
    """
    try:
        difference = (ring.read(lhs) ** power - ring.read(rhs)).numerator
    except KernelError:
        return "refused"
    differ = point is not None and at(difference, point)
    return "refuted" if differ or divide(ring, difference)[1] else "equivalent"


def mutants(fact: Fact, ring: Ring) -> Iterator[tuple[str, str]]:
    """Yield mutants of a fact as pairs of left and right side.

    In each, one place of one component is changed.  The kinds of change alternate.
    """
    kinds: dict[str, list[Callable[[], tuple[str, str]]]] = {}
    known = ring.values
    sides = list(dict.fromkeys(zip(fact.lhs, fact.rhs, strict=True)))
    for lhs, rhs in sides:
        for kind, edit in _changes(rhs, known):
            kinds.setdefault(kind, []).append(lambda lhs=lhs, edit=edit: (lhs, edit()))
        if fact.kind == "equal":
            for kind, edit in _changes(lhs, known):
                kinds.setdefault(kind, []).append(lambda rhs=rhs, edit=edit: (edit(), rhs))
    turns = chain.from_iterable(zip_longest(*kinds.values()))
    seen: set[tuple[str, str]] = set()
    for mutant in (turn() for turn in turns if turn is not None):
        if mutant not in seen:
            seen.add(mutant)
            yield mutant


def _changes(text: str, known: Mapping[Tree, Element]) -> Iterator[tuple[str, Edit]]:
    yield from edits(text, lambda node: variants(node, known))
    yield "factor", lambda: f"2*({text})"
    yield "offset", lambda: f"({text}) + 1"


def edits(text: str, variants: Variants) -> Iterator[tuple[str, Edit]]:
    """Yield all single changes of an expression, each with its kind.

    A change is a function that returns the new text.
    """
    tree = ast.parse(text, mode="eval")
    for place, node in enumerate(islice(ast.walk(tree), PLACES)):
        for kind, changed in variants(node):
            yield kind, partial(_replaced, text, place, changed)


def variants(node: ast.AST, known: Mapping[Tree, Element]) -> Iterator[tuple[str, ast.expr]]:
    """Yield erroneous variants of one syntax-tree node, each with the kind of error.

    The kinds are sign, power, factor, term, index, function and derivative.
    """
    match node:
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            yield "sign", ast.BinOp(left, ast.Sub(), right)
            yield "missing term", left
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            yield "sign", ast.BinOp(left, ast.Add(), right)
            yield "missing term", left
        case ast.BinOp(left=base, op=ast.Pow(), right=ast.Constant(value=int(exponent))):
            yield "power", ast.BinOp(base, ast.Pow(), ast.Constant(exponent + 1))
            lower = ast.BinOp(base, ast.Pow(), ast.Constant(exponent - 1))
            yield "root", base if exponent == 2 else lower
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            yield "missing factor", left
            yield "missing factor", right
        case ast.BinOp(left=left, op=ast.Div(), right=right):
            yield "missing divisor", left
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            yield "sign", operand
        case ast.Name(id=name):
            yield from (("index", ast.Name(other)) for other in _others(name, known))
            if name in known and len(known[name].numerator) < SHORT:
                yield "square", ast.BinOp(node, ast.Pow(), ast.Constant(2))
            yield "double", ast.BinOp(ast.Constant(2), ast.Mult(), node)
        case ast.Call(args=[argument]):
            yield "no derivative", argument


def _others(name: str, known: Mapping[Tree, Element]) -> Iterator[str]:
    """Yield known names that could be mistaken for the given name.

    These are names of the next axis and of similar functions.
    """
    axis = re.fullmatch(r"(.*?)([123]|(?<=_)[abd])(_rate|_squared)?", name)
    candidates = [_PARTNERS.get(name, "")]
    if axis:
        candidates.append(axis[1] + _INDEX[axis[2]] + (axis[3] or ""))
    return (candidate for candidate in candidates if candidate in known)


def _replaced(text: str, place: int, changed: ast.expr) -> str:
    """Replace one node in the syntax tree of an expression and return the new text."""
    tree = ast.parse(text, mode="eval")
    target = list(ast.walk(tree))[place]

    class Swap(ast.NodeTransformer):
        def visit(self, node: ast.AST) -> ast.AST:
            return changed if node is target else super().visit(node)

    return ast.unparse(Swap().visit(tree))
