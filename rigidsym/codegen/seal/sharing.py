"""Lines with all that was shared put back are the formulas that were stated, in their order."""

from collections.abc import Iterable, Iterator

from rigidsym.codegen.ir import Function
from rigidsym.codegen.lines import comment
from rigidsym.codegen.passes import expand
from rigidsym.codegen.seal.claims import DIFFERS, Claim
from rigidsym.errors import InputError
from rigidsym.language.expression import Expression, Operation, children, names


def claims(stated: Iterable[Function], functions: Iterable[Function]) -> Iterator[Claim]:
    """Each formula of each function, and what its lines give."""
    for origin, function in zip(stated, functions, strict=True):
        _check_stated(origin, function)
        _check_shared(function)
        printed = expand(function.lets)
        targets = [let.targets for let in printed]
        if targets != [formula.targets for formula in function.formulas]:
            raise InputError(function.name, "its lines", "do not set what the formulas set")
        for formula, let in zip(function.formulas, printed, strict=True):
            # Rounding errors are found by sums that would vanish in a ring: no other order will do.
            if let.expression != formula.expression and not _has_power(formula.expression):
                raise InputError(function.name, formula, DIFFERS)
            if (let.facts, let.source) != (formula.facts, formula.source):
                raise InputError(function.name, let, f"is by {comment(formula)}")
            yield Claim(function.name, str(formula), formula.expression, let.expression)


def _check_stated(origin: Function, function: Function) -> None:
    """Formulas are left out, and nothing else happens to them."""
    later = iter(origin.lets)
    for formula in function.formulas:
        if formula not in later:
            raise InputError(function.name, formula, DIFFERS)
    if function.results != origin.results or function.parameters != origin.parameters:
        raise InputError(function.name, "its parameters and results", "are not those stated")


def _check_shared(function: Function) -> None:
    """A part that lines share is by the facts of these lines, and by no other."""
    formulas = {formula.targets[0] for formula in function.formulas}
    users: dict[str, set[str]] = {}
    for let in reversed(function.lets):
        own = {*let.facts} if let.targets[0] in formulas else users.get(let.targets[0], set())
        if own != {*let.facts}:
            raise InputError(function.name, let, f"is by {', '.join(sorted(own)) or 'no fact'}")
        for name in names(let.expression):
            users.setdefault(name, set()).update(own)


def _has_power(expression: Expression) -> bool:
    if isinstance(expression, Operation) and expression.operator == "**":
        return True
    return any(map(_has_power, children(expression)))
