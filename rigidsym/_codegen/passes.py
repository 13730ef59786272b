"""Compiler passes that turn formulas into printable assignments, each a pure function."""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace

from rigidsym._codegen.ir import Function, Let, is_extended
from rigidsym.language._expression import (
    Call,
    Expression,
    Name,
    Number,
    Operation,
    children,
    names,
    put,
    rebuild,
    to_text,
)
from rigidsym.solution import Formula

_SHARED = "common_"


def select(
    formulas: Iterable[Formula], results: Iterable[str], given: Iterable[str]
) -> tuple[Let, ...]:
    """Select the formulas needed to compute the wanted quantities from the given ones.

    Input: formulas, names wanted, names given.  Output: the lets that the wanted names need.
    """
    known, wanted, kept = set(given), set(results), []
    for formula in reversed(tuple(formulas)):
        if formula.name in wanted and formula.name not in known:
            wanted |= set(names(formula.expression))
            kept.append(Let((formula.name,), formula.expression, formula.source, (formula.fact,)))
    return tuple(reversed(kept))


def specialise(lets: Iterable[Let], values: Mapping[str, int]) -> tuple[Let, ...]:
    """Substitute integers for names, and simplify the assignments.

    Input: lets, and integers for some names.  Output: the lets with these put in and folded.
    """
    constants = {Name(n): Number(value) for n, value in values.items()}
    return _mapped(lets, lambda expression: _folded(expression, constants))


def _mapped(lets: Iterable[Let], change: Callable[[Expression], Expression]) -> tuple[Let, ...]:
    return tuple(replace(let, expression=change(let.expression)) for let in lets)


def _folded(expression: Expression, constants: Mapping[Name, Expression]) -> Expression:
    if isinstance(expression, Name) and expression in constants:
        return constants[expression]
    parts = tuple(_folded(part, constants) for part in children(expression))
    match rebuild(expression, parts):
        case Operation("*", Number(0), _) | Operation("*", _, Number(0)):
            return Number(0)
        case Operation("*", Number(1), other) | Operation("*", other, Number(1)):
            return other
        case Operation("+", Number(0), other) | Operation("+" | "-", other, Number(0)):
            return other
        case Operation("-", Number(0), other):
            return Call("neg", (other,))
        case Operation("/", Number(0), _) | Call("neg", (Number(0),)):
            return Number(0)
        case Operation("/", other, Number(1)) | Call("neg", (Call("neg", (other,)),)):
            return other
        case folded:
            return folded


def renamed(lets: Iterable[Let], new: Mapping[str, str]) -> tuple[Let, ...]:
    """Rename quantities in assignments.

    Input: lets, and new names for some quantities.  Output: the lets under these names.
    """
    meaning = {old: Name(name) for old, name in new.items()}
    return tuple(
        replace(let, targets=tuple(new.get(x, x) for x in let.targets))
        for let in _mapped(lets, lambda expression: put(expression, meaning))
    )


def inlined(lets: Iterable[Let], kept: Iterable[str]) -> tuple[Let, ...]:
    """Substitute intermediate quantities into the assignments that are kept.

    Input: lets, and names to keep.  Output: the lets of these names, with all others put in.
    """
    meaning: dict[str, Expression] = {}
    wanted, found = set(kept), []
    for let in lets:
        expression = put(let.expression, meaning)
        (target,) = let.targets
        if target in wanted:
            found.append(replace(let, expression=expression))
        else:
            meaning[target] = expression
    return tuple(found)


def coefficient(expression: Expression, of: str, among: Iterable[str], over: str) -> Expression:
    """Return the factor of one quantity in a linear expression.

    Input: an expression linear in names over another.  Output: the factor of `of`/`over`.
    """
    values = {Name(n): Number(int(n == of)) for n in among}
    return _folded(expression, values | {Name(over): Number(1)})


def live(lets: Iterable[Let], results: Iterable[str]) -> tuple[Let, ...]:
    """Drop the assignments that no wanted quantity depends on.

    Input: lets, and the names wanted.  Output: the lets that these names need.
    """
    wanted, kept = set(results), []
    for let in reversed(tuple(lets)):
        if wanted & set(let.targets):
            wanted |= set(names(let.expression))
            kept.append(let)
    targets = Counter(target for let in kept for target in let.targets)
    repeated = sorted(name for name, count in targets.items() if count > 1)
    if repeated:
        raise ValueError(f"{', '.join(repeated)}: set more than once")
    return tuple(reversed(kept))


def products(lets: Iterable[Let]) -> tuple[Let, ...]:
    """Replace whole powers by products.

    Input: lets with whole powers.  Output: lets with products in place of powers.
    """
    return _mapped(lets, _multiplied)


def _multiplied(expression: Expression) -> Expression:
    match rebuild(expression, tuple(map(_multiplied, children(expression)))):
        case Operation("**", base, Number(power)) if power > 0:
            product = base
            for _ in range(power - 1):
                product = Operation("*", product, base)
            return product
        case Operation("**", _, power):
            raise ValueError(f"{to_text(expression)}: {to_text(power)} is not a whole power")
        case other:
            return other


def fuse(function: Function) -> tuple[Let, ...]:
    """Replace each a*b + c of doubles by a fused multiply-add.

    Input: a function.  Output: its lets with each a*b + c of doubles as one `fma`.
    """
    extended = function.all_extended()
    return _mapped(function.lets, lambda expression: _fused(expression, extended))


def _fused(expression: Expression, extended: frozenset[str]) -> Expression:
    small = rebuild(expression, tuple(_fused(part, extended) for part in children(expression)))
    match small:
        case Operation("+", Operation("*", a, b), c) | Operation("+", c, Operation("*", a, b)):
            fused = Call("fma", (a, b, c))
        case Operation("-", Operation("*", a, b), c):
            fused = Call("fma", (a, b, Call("neg", (c,))))
        case Operation("-", c, Operation("*", a, b)):
            fused = Call("fma", (Call("neg", (a,)), b, c))
        case _:
            return small
    return small if is_extended(expression, extended) else fused


def narrowed(function: Function) -> Function:
    """Compute with doubles all that no result depends on which is handed on in two parts.

    Input: a function.  Output: the function with each extended number that other assignments need
    rounded once.  Functions without such results stay as they are.
    """
    wide = live(function.lets, function.split) if function.split else function.lets
    extended, targets = function.all_extended(), {name for let in wide for name in let.targets}
    rounded: dict[str, Expression] = {}
    lets = []
    for let in function.lets:
        if let in wide:
            lets.append(let)
            continue
        for name in sorted(set(names(let.expression)) & extended - rounded.keys()):
            if name in targets or name in function.extended:
                rounded[name] = Name(f"{name}_rounded")
                lets.append(Let((f"{name}_rounded",), Call("rounded", (Name(name),)), (), ()))
        lets.append(replace(let, expression=_unrounded(put(let.expression, rounded))))
    return replace(function, lets=tuple(lets))


def _unrounded(expression: Expression) -> Expression:
    """Drop the rounding of what is a double already."""
    match rebuild(expression, tuple(map(_unrounded, children(expression)))):
        case Call("rounded", (inner,)):
            return inner
        case other:
            return other


def unfused(expression: Expression) -> Expression:
    """Replace each fused multiply-add in an expression by a product and a sum.

    Input: an expression after `fuse`.  Output: the expression with products and sums again.
    """
    match rebuild(expression, tuple(map(unfused, children(expression)))):
        case Call("fma", (a, b, c)):
            return Operation("+", Operation("*", a, b), c)
        case other:
            return other


def share(lets: Iterable[Let]) -> tuple[Let, ...]:
    """Give names to common subexpressions, and assign them before their first use.

    Input: lets.  Output: lets with common subexpressions named common_1, common_2 and so on.

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
        shared.append(replace(let, expression=expression))
    return tuple(shared)


def _is_shared(name: str) -> bool:
    return name.startswith(_SHARED) and name[len(_SHARED) :].isdigit()


def _compound(expression: Expression) -> Iterator[Expression]:
    """Yield all operations and calls in an expression, the outermost first."""
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
) -> Expression:
    if expression in named:
        return named[expression]
    parts = tuple(_shared(part, counts, users, named, shared) for part in children(expression))
    small = rebuild(expression, parts)
    if counts[expression] < 2 or not isinstance(expression, Operation):
        return small
    named[expression] = Name(f"{_SHARED}{len(named) + 1}")
    source = tuple(dict.fromkeys(s for let in users[expression] for s in let.source))
    facts = tuple(dict.fromkeys(f for let in users[expression] for f in let.facts))
    shared.append(Let((named[expression].name,), small, source, facts))
    return named[expression]


def expand(lets: Iterable[Let]) -> tuple[Let, ...]:
    """Put shared subexpressions back into the expressions that use their names.

    Input: lets after `share`.  Output: the lets before it.
    """
    meaning: dict[str, Expression] = {}
    expanded = []
    for let in lets:
        expression = put(let.expression, meaning)
        if _is_shared(let.targets[0]):
            meaning[let.targets[0]] = expression
        else:
            expanded.append(replace(let, expression=expression))
    return tuple(expanded)
