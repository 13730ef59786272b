"""What a generated module asks of a machine: operations of a state, its constants, its bytes."""

from collections import Counter
from collections.abc import Mapping, Sequence

from rigidsym.codegen.functions import functions
from rigidsym.codegen.generate import generate
from rigidsym.codegen.ir import Function
from rigidsym.codegen.lines import flat_results
from rigidsym.language.expression import Call, Expression, Operation, children
from rigidsym.solution import sealed

_DOUBLE = 8


# What changes with time, and what is made of it.
PARTS = ("angles", "state")


def operations(form: str, branch: str, parts: Sequence[str] = PARTS) -> int:
    """How many sums, products, quotients, roots and exponentials one state takes on a branch."""
    by_name = {function.name: function for function in functions(sealed(), form)}
    found = (_of_function(by_name[f"_{branch}_{part}"], by_name) for part in parts)
    return sum(sum(each.values()) for each in found)


def of_function(function: Function) -> int:
    """The same of one function that calls none."""
    return sum(_of_function(function, {}).values())


def _of_function(function: Function, known: Mapping[str, Function]) -> Counter[str]:
    counts = (_of(let.expression, known) for let in function.lets)
    return sum(counts, Counter[str]())


def _of(expression: Expression, known: Mapping[str, Function]) -> Counter[str]:
    total = sum((_of(part, known) for part in children(expression)), Counter[str]())
    match expression:
        case Operation(symbol, _, _):
            total[symbol] += 1
        case Call("sqrt" | "exp", _):
            total[expression.function] += 1
        case Call(name, _) if name in known:
            total += _of_function(known[name], known)
    return total


def constant_bytes(form: str, branch: str) -> int:
    """What a plan keeps for the states of a branch."""
    by_name = {function.name: function for function in functions(sealed(), form)}
    return _DOUBLE * len(flat_results(by_name[f"_{branch}_constants"]))


def code_bytes(form: str) -> int:
    """The C source, without its header file."""
    files = generate("c", form=form).files
    return sum(len(text.encode()) for name, text in files.items() if name.endswith(".c"))
