"""The seal of NumPy refuses every small edit of a printed decision and operation."""

import ast
import re

import pytest

from rigidsym import InputError
from rigidsym._codegen.forms import STEP, THETA
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.seal.bodies import Body
from rigidsym._codegen.targets.numpy import module, printer
from rigidsym._codegen.targets.numpy.reader import read_routine, wanted_of
from rigidsym.solution import sealed

TOKENS = re.compile(
    r"\d+(?:\.\d*)?(?:e[-+]?\d+)?|[A-Za-z_]\w*|<<|>>|<=|>=|==|!=|//|[-+*/<>%&|^]=?|(?<=, )(?=\w)"
)
OTHER = {
    **{"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">"},
    **{"==": "!=", "!=": "==", "&": "|", "|": "&", "<<": ">>", ">>": "<<", "+=": "-="},
    **{"hi": "lo", "lo": "hi", "0": "1", "1": "2", "True": "False", "_MASK": "_BLOCK"},
    **{"_where": "_choose", "_taken": "_where", "_only": "_taken", "if": "while", "abs": "_sqrt"},
    **{"np": "math", "_DoubleDouble": "_sqrt", "THIN": "OK", "OK": "THIN", "a": "b", "b": "d"},
}


def edited(line):
    """Yield a line with one token changed, for each token that may be."""
    for found in TOKENS.finditer(line):
        token = found[0]
        other = OTHER.get(token)
        if other is None and re.fullmatch(r"\d+\.\d*(?:e[-+]?\d+)?", token):
            other = repr(float(token) * 2 + 1)
        if other is None and token.isdigit():
            other = str(int(token) + 1)
        if other is not None:
            yield line[: found.start()] + other + line[found.end() :]


def is_sealed(one, made, text):
    """Return True if the seal accepts a text as that of a routine."""
    try:
        (node,) = ast.parse(text).body
        assert isinstance(node, ast.FunctionDef)
        read = read_routine("f.py", node, one, made)
        Body("f.py", text.split("\n"), one).check(read, wanted_of(one))
    except (InputError, SyntaxError):
        return False
    return True


@pytest.mark.parametrize("form", [THETA, STEP])
def test_every_edit_of_a_token_is_refused(form):
    made = module.program(functions(sealed(), form), constants(), form)
    routines, count, accepted = module.routines(made, form), 0, []
    for one in routines:
        whole = printer.text(one, made)
        assert is_sealed(one, made, whole), one.name
        node = ast.parse(whole).body[0]
        lines = whole.split("\n")
        for k in range(node.body[0].end_lineno, len(lines)):
            for other in edited(lines[k]):
                count += 1
                if is_sealed(one, made, "\n".join([*lines[:k], other, *lines[k + 1 :]])):
                    accepted.append((one.name, lines[k], other))
    assert accepted == []
    assert count > 500


def test_a_sum_that_changes_an_array_of_the_caller_is_refused():
    made = module.program(functions(sealed(), "step"), constants(), "step")
    (one,) = (x for x in module.routines(made, "step") if x.name == "two_product")
    text = printer.text(one, made)
    assert is_sealed(one, made, text)
    assert not is_sealed(one, made, text.replace("p = a * b", "a *= b"))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("    return", "    x = 0.0\n    return"),
        ("    y = ", "    y = y = "),
        ("    y = ", "    y: float = "),
        ("    return y", "    return +y"),
    ],
)
def test_other_statements_are_refused(old, new):
    made = module.program(functions(sealed(), "step"), constants(), "step")
    (one,) = (x for x in module.routines(made, "step") if x.name == "divided")
    text = printer.text(one, made)
    assert text.count(old) == 1
    assert is_sealed(one, made, text)
    assert not is_sealed(one, made, text.replace(old, new))
