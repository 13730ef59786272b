"""The passes from formulas to lets that can be printed: each is a pure function of its input."""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from rigidsym.codegen.ir import Let
from rigidsym.solution import Formula
from rigidsym.solution.expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    children,
    names,
    rebuild,
)

_JACOBI = ("jacobi_sn", "jacobi_cn", "jacobi_dn")


def select(
    formulas: Iterable[Formula], results: Iterable[str], given: Iterable[str]
) -> tuple[Let, ...]:
    """Input: a programme, the names wanted and the names given.  Output: the lets in between."""
    known, wanted, kept = set(given), set(results), []
    for formula in reversed(tuple(formulas)):
        if formula.name in wanted and formula.name not in known:
            wanted |= set(names(formula.expression))
            kept.append(Let((formula.name,), formula.expression, formula.source, (formula.fact,)))
    return tuple(reversed(kept))


def specialise(lets: Iterable[Let], values: Mapping[str, int]) -> tuple[Let, ...]:
    """Input: lets, and integers for some names.  Output: the lets with those put in and folded."""
    constants: dict[Expression, Expression] = {
        Name(n): Number(value) for n, value in values.items()
    }
    return tuple(
        Let(let.targets, _folded(let.expression, constants), let.source, let.facts) for let in lets
    )


def _folded(expression: Expression, constants: Mapping[Expression, Expression]) -> Expression:
    if expression in constants:
        return constants[expression]
    parts = tuple(_folded(part, constants) for part in children(expression))
    match rebuild(expression, parts):
        case Operation("*", Number(0), _) | Operation("*", _, Number(0)):
            return Number(0)
        case Operation("*", Number(1), other) | Operation("*", other, Number(1)):
            return other
        case Operation("+", Number(0), other) | Operation("+" | "-", other, Number(0)):
            return other
        case folded:
            return folded


def lower(lets: Iterable[Let]) -> tuple[Let, ...]:
    """Input: lets that call functions of (..., mc).  Output: lets that call the kernels.

    sn, cn and dn of one argument become one call; quarter periods and complete integrals become
    lets of their own, `quarter_<mc>` and `complete_<n>`, so that a plan can keep them.
    """
    lowered: list[Let] = []
    jacobi: dict[tuple[Expression, ...], tuple[str, str, str]] = {}
    for let in lets:
        match let.expression:
            case Call(function, arguments) if function in _JACOBI:
                values = _jacobi_targets(jacobi, arguments, let, lowered)
                value = values[_JACOBI.index(function)]
                if let.targets != (value,):
                    lowered.append(Let(let.targets, Name(value), let.source, let.facts))
            case Call("elliptic_j", (u, n, mc)):
                values = _jacobi_targets(jacobi, (u, mc), let, lowered)
                complete = Name(f"complete_{_label(n)}")
                _once(lowered, complete, Call("complete_j", (n, mc)), let)
                quarter = _quarter(lowered, mc, let)
                triple = tuple(map(Name, values))
                call = Call("elliptic_j", (u, n, quarter, *triple, complete))
                lowered.append(Let(let.targets, call, let.source, let.facts))
            case _:
                lowered.append(let)
    return tuple(lowered)


def _jacobi_targets(
    jacobi: dict[tuple[Expression, ...], tuple[str, str, str]],
    arguments: tuple[Expression, ...],
    let: Let,
    lowered: list[Let],
) -> tuple[str, str, str]:
    """The names of sn, cn, dn of the arguments, which are computed once."""
    if arguments not in jacobi:
        u, mc = arguments
        quarter = _quarter(lowered, mc, let)
        jacobi[arguments] = ("s", "c", "d")
        call = Call("jacobi", (u, mc, quarter))
        lowered.append(Let(jacobi[arguments], call, let.source, let.facts))
    return jacobi[arguments]


def _quarter(lowered: list[Let], mc: Expression, let: Let) -> Name:
    name = Name(f"quarter_{_label(mc)}")
    _once(lowered, name, Call("quarter_period", (mc,)), let)
    return name


def _once(lowered: list[Let], name: Name, call: Call, let: Let) -> None:
    if not any(name.name in done.targets for done in lowered):
        lowered.append(Let((name.name,), call, let.source, let.facts))


def _label(expression: Expression) -> str:
    if not isinstance(expression, Name):
        raise ValueError(f"{expression}: a parameter must be a named quantity")
    return expression.name


def without(lets: Iterable[Let], given: Iterable[str]) -> tuple[Let, ...]:
    """Input: lets, and names that are given after all.  Output: the lets without theirs."""
    known = set(given)
    return tuple(let for let in lets if not set(let.targets) <= known)


def share(lets: Iterable[Let]) -> tuple[Let, ...]:
    """Input: lets.  Output: the same, common subexpressions named x1, x2, ... before first use.

    The provenance of a shared let is the union over its users.
    """
    lets = tuple(lets)
    parts = {part for let in lets for part in _compound(let.expression)}
    counts = Counter(child for part in parts for child in children(part))
    counts.update(let.expression for let in lets)
    users: dict[Expression, list[Let]] = {}
    for let in lets:
        for part in set(_compound(let.expression)):
            users.setdefault(part, []).append(let)
    named: dict[Expression, Name] = {}
    shared: list[Let] = []
    for let in lets:
        expression = _shared(let.expression, counts, users, named, shared)
        shared.append(Let(let.targets, expression, let.source, let.facts))
        if len(let.targets) == 1:
            named.setdefault(let.expression, Name(let.targets[0]))
    return tuple(shared)


def _compound(expression: Expression) -> Iterator[Expression]:
    """The expression and its parts, but for single names and numbers."""
    if isinstance(expression, Operation | Call):
        yield expression
    for part in children(expression):
        yield from _compound(part)


def _shared(
    expression: Expression,
    counts: Counter[Expression],
    users: Mapping[Expression, list[Let]],
    named: dict[Expression, Name],
    shared: list[Let],
    top: bool = True,
) -> Expression:
    if expression in named:
        return named[expression]
    parts = tuple(
        _shared(part, counts, users, named, shared, top=False) for part in children(expression)
    )
    small = rebuild(expression, parts)
    if top or counts[expression] < 2 or not isinstance(expression, Operation):
        return small
    named[expression] = Name(f"x{sum(let.targets[0].startswith('x') for let in shared) + 1}")
    source = tuple(dict.fromkeys(s for let in users[expression] for s in let.source))
    facts = tuple(dict.fromkeys(f for let in users[expression] for f in let.facts))
    shared.append(Let((named[expression].name,), small, source, facts))
    return named[expression]


def expand(lets: Iterable[Let]) -> tuple[Let, ...]:
    """Input: lets after `share`.  Output: the lets before it; what `share` named is put back."""
    meaning: dict[Expression, Expression] = {}
    expanded = []
    for let in lets:
        expression = _replaced(let.expression, meaning)
        if let.targets[0].startswith("x") and let.targets[0][1:].isdigit():
            meaning[Name(let.targets[0])] = expression
        else:
            expanded.append(Let(let.targets, expression, let.source, let.facts))
    return tuple(expanded)


def _replaced(expression: Expression, meaning: Mapping[Expression, Expression]) -> Expression:
    if expression in meaning:
        return meaning[expression]
    parts = tuple(_replaced(part, meaning) for part in children(expression))
    return rebuild(expression, parts)
