"""C program that tests the flight profile's functions by reference vectors."""

from collections.abc import Iterable, Iterator
from importlib import resources

from rigidsym._codegen.flight.program import PREFIX
from rigidsym._codegen.flight.vectors import Refusal, Vector, Vectors
from rigidsym._codegen.routines import Program, Routine

NAME = "test_torque_free.c"
# Documented bounds of validation, on angle and rates, of states and of steps.
BOUNDS = {"state bound": 2e-15, "step bound": 1e-15}
# Arguments that stand for any number or array.
_VALUES = {"double": "1.0", "int": "0", "bool": "true"}


def text(program: Program, vectors: Vectors) -> str:
    """Return the text of the test program."""
    marks = {name: repr(bound) for name, bound in BOUNDS.items()}
    marks |= {
        "states": _states(vectors.states),
        "steps": _states(vectors.steps),
        "refused motions": _refusals(vectors.refused_motions, ""),
        "refused steps": _refusals(vectors.refused_steps, "STEP_"),
        "assertions": "\n".join(_assertions(program)),
    }
    found = resources.files("rigidsym._codegen.flight").joinpath(NAME).read_text("utf-8")
    for mark, meaning in marks.items():
        found = found.replace(f"@{mark}@", meaning)
    return found


def _states(found: Iterable[Vector]) -> str:
    rows = (
        f'    {{"{x.name}", {", ".join(map(_row, x.given))},\n'
        f"     {_number(x.time)}, {_number(x.more)},\n"
        f"     {_row(x.state[:4])}, {_row(x.state[4:])}}},"
        for x in found
    )
    return "\n".join(rows)


def _refusals(found: Iterable[Refusal], form: str) -> str:
    rows = (
        f'    {{"{x.code}: {x.about}", TORQUE_FREE_{form}{x.code},\n'
        f"     {', '.join(map(_row, x.given))}, {_number(x.time)}}},"
        for x in found
    )
    return "\n".join(rows)


def _row(numbers: Iterable[float]) -> str:
    return f"{{{', '.join(map(_number, numbers))}}}"


def _number(x: float) -> str:
    special = {"nan": "NAN", "inf": "INFINITY", "-inf": "-INFINITY"}
    return special.get(str(x), float(x).hex())


def _assertions(program: Program) -> Iterator[str]:
    """Yield a test that calls each public function with each pointer missing."""
    public = [one for one in program.routines.values() if one.is_public]
    yield "/* Call each function with each pointer missing: an assertion fails before all else. */"
    yield "static void test_assertions(void)\n{"
    structs = sorted({x.name for one in public for x in one.parameters.values() if x.is_struct})
    for name in structs:
        yield f"    static {PREFIX}{name} one_{name};"
    yield "    static double numbers[4] = {1.0, 1.0, 1.0, 1.0};"
    for one in public:
        for missing, type_ in one.parameters.items():
            if type_.is_struct or type_.shape:
                yield "    if (setjmp(after_assertion) == 0) {"
                yield f"        (void){_call(one, missing)};"
                yield f'        check(0, "assertion", "{one.name}: {missing}");'
                yield "    } else {"
                yield f'        check(1, "assertion", "{one.name}: {missing}");'
                yield "    }"
    yield "}"


def _call(one: Routine, missing: str) -> str:
    given = [
        "NULL"
        if name == missing
        else f"&one_{type_.name}"
        if type_.is_struct
        else "numbers"
        if type_.shape
        else _VALUES[type_.name]
        for name, type_ in one.parameters.items()
    ]
    return f"{PREFIX}{one.name}({', '.join(given)})"
