"""The seal refuses every small edit of a printed statement, in derived lines and in the runtime."""

import re
from functools import cache

import pytest

from rigidsym import InputError
from rigidsym._codegen.forms import FORMS
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.seal.bodies import Body
from rigidsym._codegen.targets.c import module, reader
from rigidsym._codegen.targets.c.program import program
from rigidsym.solution import sealed

# Tokens, and what each becomes in an edit; all are of statements that compile.
TOKENS = re.compile(
    r"0x[0-9a-f]+|\d+(?:\.\d*)?(?:e[-+]?\d+)?|[A-Za-z_]\w*|<<|>>|<=|>=|==|!=|&&|\|\||->|[-+*/<>%&|^!?=]=?"
)
OTHER = {
    **{"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">"},
    **{"==": "!=", "!=": "==", "&&": "||", "||": "&&", "<<": ">>", ">>": "<<", "+=": "-="},
    **{"break": "continue", "hi": "lo", "lo": "hi", "0": "1", "1": "2", "sin": "cos", "cos": "sin"},
}


@cache
def printer(form):
    made = program(functions(sealed(), form), constants(), form)
    return module.Files(made, form).printer


def edited(line):
    """Yield a line with one token changed, for each token that may be."""
    code, _, _ = line.partition("; /* ")
    for found in TOKENS.finditer(code):
        token = found[0]
        other = OTHER.get(token)
        if other is None and re.fullmatch(r"\d+\.\d*(?:e[-+]?\d+)?", token):
            other = repr(float(token) * 2 + 1)
        if other is None and re.fullmatch(r"\d+", token):
            other = str(int(token) + 1)
        # A step of a loop that is one has no number, and a pointer's arrow is no operation.
        if other is None or code[found.start() : found.start() + 2] in ("++", "->"):
            continue
        if token in "+-" and code[found.end() : found.end() + 1] == "+":
            continue
        yield line[: found.start()] + other + line[found.end() :]


def is_sealed(form, one, text):
    """Return True if the seal accepts a text as the body of a routine."""
    try:
        ((_, node),) = reader.functions("f.c", reader.parsed(text))
        read = reader.Reader("f.c", one, printer(form)).body(node)
        Body("f.c", text.split("\n"), one).check(read, one.body)
    except InputError:
        return False
    return True


def bodies(form):
    for one in printer(form).program.routines.values():
        lines = list(printer(form).routine(one).text)
        begin = lines.index("{")
        yield one, lines, range(begin + 1, len(lines) - 2)


def survivors(form, every):
    """Return the edits that the seal accepts, and how many were made; one line in `every`."""
    count, accepted, place = 0, [], 0
    for one, lines, body in bodies(form):
        assert is_sealed(form, one, "\n".join(lines))
        for k in body:
            place += 1
            if (
                place % every
                or lines[k].lstrip().startswith(("/*", "*/"))
                or not re.search(r"[;{]", lines[k])
            ):
                continue
            for line in edited(lines[k]):
                count += 1
                if is_sealed(form, one, "\n".join([*lines[:k], line, *lines[k + 1 :]])):
                    accepted.append(f"{one.name}: {line.strip()}")
    return accepted, count


@pytest.mark.parametrize("form", FORMS)
def test_no_edit_of_some_statements_is_sealed(form):
    accepted, count = survivors(form, 25)
    assert not accepted
    assert count > 60


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMS)
def test_no_edit_of_any_statement_is_sealed(form):
    accepted, count = survivors(form, 1)
    assert not accepted
    assert count > 1000


def test_statements_may_not_change_places():
    for one, lines, body in bodies("step"):
        pairs = [(k, k + 1) for k in body if k + 1 in body]
        for k, other in pairs[::25]:
            if lines[k].strip().endswith(";") and lines[other].strip().endswith(";"):
                swapped = [*lines]
                swapped[k], swapped[other] = lines[other], lines[k]
                assert not is_sealed("step", one, "\n".join(swapped)), lines[k]
                dropped = "\n".join([*lines[:k], *lines[k + 1 :]])
                assert not is_sealed("step", one, dropped), lines[k]
