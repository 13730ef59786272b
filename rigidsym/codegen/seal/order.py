"""Every name is set once and before it is used, no line is idle, and calls fit what they call."""

from collections.abc import Iterable, Iterator

from rigidsym.codegen.ir import CALLS, Function, Let
from rigidsym.errors import InputError
from rigidsym.language.expression import Call, Expression, children, names


def check(functions: Iterable[Function], numbers: set[str]) -> None:
    """Raises InputError, naming the line, where the formulas or the lines of a function do not."""
    called: dict[str, Function] = {}
    for function in functions:
        for lets in (function.formulas, function.lets):
            _check_names(function, lets, numbers)
            _check_use(function, lets)
            for let in lets:
                _check_calls(function.name, let, called)
        called[function.name] = function


def _check_names(function: Function, lets: tuple[Let, ...], numbers: set[str]) -> None:
    known = {*function.parameters, *numbers}
    if len(set(function.parameters)) != len(function.parameters):
        raise InputError(function.name, ", ".join(function.parameters), "a name is given twice")
    for let in lets:
        missing = sorted(set(names(let.expression)) - known)
        if missing:
            raise InputError(function.name, let, f"{', '.join(missing)}: used before it is known")
        again = sorted(known.intersection(let.targets))
        if again or len(set(let.targets)) != len(let.targets):
            raise InputError(function.name, let, f"{', '.join(again)}: known already, set again")
        known.update(let.targets)
    left = sorted(set(function.results) - known)
    if left:
        raise InputError(function.name, ", ".join(left), "is returned and never set")


def _check_use(function: Function, lets: tuple[Let, ...]) -> None:
    """Of what a line sets, something is used later, or returned."""
    wanted = set(function.results)
    for let in reversed(lets):
        if not wanted.intersection(let.targets):
            raise InputError(function.name, let, "nothing needs this line")
        wanted.update(names(let.expression))


def _check_calls(place: str, let: Let, known: dict[str, Function]) -> None:
    """Functions of the module are called with what they take, for what they return."""
    whole = let.expression
    if len(let.targets) > 1 and not (isinstance(whole, Call) and whole.function in known):
        raise InputError(place, let, "several names are set by no function that returns several")
    for call in _calls(whole):
        if call.function in CALLS:
            continue
        if call.function not in known:
            raise InputError(place, let, f"{call.function}: called and not known")
        function = known[call.function]
        expected = len(let.targets) if call is whole else 1
        if len(call.arguments) != len(function.parameters) or len(function.results) != expected:
            raise InputError(place, let, f"{call.function}: takes or returns another number")


def _calls(expression: Expression) -> Iterator[Call]:
    if isinstance(expression, Call):
        yield expression
    for part in children(expression):
        yield from _calls(part)
