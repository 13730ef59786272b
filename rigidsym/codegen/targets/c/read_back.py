"""The C module read back: numbers, functions and structs in order, and nothing else.

What is written by hand is compared word for word, with what the functions say at its marks.
"""

import re
from collections.abc import Iterator, Mapping
from dataclasses import astuple

from rigidsym.codegen import header, shares
from rigidsym.codegen.forms import STEP, THETA, key
from rigidsym.codegen.ir import Constant, Function, Let
from rigidsym.codegen.limits import limits
from rigidsym.codegen.lines import comment
from rigidsym.codegen.passes import fuse, unfused
from rigidsym.codegen.seal.by_hand import Between, between
from rigidsym.codegen.seal.claims import DIFFERS
from rigidsym.codegen.seal.equality import is_equal
from rigidsym.codegen.special_functions.short_time import LAST, STEPS
from rigidsym.codegen.targets.c import lanes, module
from rigidsym.codegen.targets.c.expressions import Reader
from rigidsym.codegen.targets.c.frame import Frame
from rigidsym.codegen.targets.c.frames import frames, struct
from rigidsym.codegen.targets.c.statements import Statement, statements
from rigidsym.errors import InputError

# The types of extended numbers by what begins the names of their operations.
_PAIRS = {"dd": "double_double", "exact": "exact"}
_SET = re.compile(r"const (\w+) (\w+) = (.*);")
_CALL = re.compile(r"(\w+\([^&]*), &(\w+(?:, &\w+)*)\);")


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """The number of lines that read back as their lets; raises InputError for the first not to."""
    source, files = module.SOURCES[form], _plain(files, form)
    _check_header(files[module.HEADERS[form]], functions, form)
    derived = _derived(files[source], functions, form)
    given = statements(source, derived)
    for number in _numbers(functions, constants):
        _expect(source, given, number)
    for statement in lanes.structs(functions):
        _expect(source, given, statement)
    known: dict[str, Function] = {}
    decided = 0
    for frame in frames(functions):
        _check_function(frame, given, known, derived)
        known[frame.name] = frame.function
        decided += len(frame.function.lets)
    _expect_end(source, given)
    return decided


def _plain(files: Mapping[str, str], form: str) -> dict[str, str]:
    """The files with names as they are written by hand; refuses one that is not the form's."""
    found = {file: module.plain(text, form) for file, text in files.items()}
    for file, text in found.items():
        own_names = module.named(text, form).split("\n")
        for number, line in enumerate(files[file].split("\n"), 1):
            own = own_names[number - 1]
            if line != own:
                raise InputError(f"{file}:{number}", line.strip(), "has another form's name")
    return found


def _check_header(text: str, functions: tuple[Function, ...], form: str) -> None:
    file = module.HEADERS[form]
    kinds = (let.kind for frame in frames(functions) for let in frame.function.lets)
    counts = shares.text(shares.shares(kinds, key("c", form)))
    said = module.header_first(form).replace(header.SHARES, counts)
    first = header.filled(said, key("c", form), header.digest_in(file, text))
    last = _filled(module.header_last(form), functions, form)
    structs = statements(file, between(file, text, first, last))
    given = iter(_without_rows(structs))
    for function in functions:
        if function.rounds and form != STEP:
            for line in struct(function):
                _expect(file, given, line)
    _expect_end(file, given)


def _without_rows(given: Iterator[Statement]) -> list[Statement]:
    """Members declared in several rows as if it were one."""
    rows: list[Statement] = []
    for statement in given:
        if rows and all(x.text.startswith("double ") for x in (statement, rows[-1])):
            line, text = rows.pop()
            more = statement.text.removeprefix("double ")
            statement = Statement(line, f"{text.removesuffix(';')}, {more}")
        rows.append(statement)
    return rows


def _derived(text: str, functions: tuple[Function, ...], form: str) -> Between:
    """What stands between the parts written by hand."""
    file = module.SOURCES[form]
    digest = header.digest_in(file, text)
    last = header.filled(_filled(module.source_last(form), functions, form), key("c", form), digest)
    return between(file, text, module.source_first(form), last)


def _filled(text: str, functions: tuple[Function, ...], form: str) -> str:
    """The text written by hand with what functions take and give, and limits, at its marks."""
    marks = {"steps": str(STEPS), "last": str(LAST)} if form == STEP else _marks(functions)
    marks["limits"] = "\n".join(
        f"static const double {name} = {2.0**exponent!r}; /* 2^{exponent}, {meaning} */"
        for name, exponent, meaning in map(astuple, limits(form))
    )
    marks |= {limit.name: str(limit.exponent) for limit in limits(form)}
    for mark, meaning in marks.items():
        text = text.replace(f"@{mark}@", meaning)
    return text


def _marks(functions: tuple[Function, ...]) -> dict[str, str]:
    """What functions of motions take and give."""
    by_name = {function.name: function for function in functions}
    marks = {
        "branches": "\n".join(
            f"        torque_free_{name} {name};" for name in ("circular", "hyperbolic", "steady")
        ),
    }
    for name in ("circular", "hyperbolic"):
        count = len(by_name[f"_{name}_angles"].results)
        for array in ("in", "to"):
            rows = [f"{array} + {k} * s" for k in range(count)]
            rows[:2] = [array, f"{array} + s"]
            marks[f"{name} rows of {array}"] = ", ".join(rows)
    if "_moduli" in by_name:
        marks |= _of_sensitivities(by_name)
    return marks


def _of_sensitivities(by_name: Mapping[str, Function]) -> dict[str, str]:
    marks = {
        "moduli": ", ".join(by_name["_moduli"].results),
        "moduli out": ", ".join(f"&{name}" for name in by_name["_moduli"].results),
        "moduli given": ", ".join(by_name["_moduli"].parameters),
        "turn columns": ", ".join(f"by[{k}]" for k in range(18)),
    }
    for name in ("along", "columns", "real", "imaginary"):
        marks[f"{name} given"] = ", ".join(by_name[f"_{name}_constants"].parameters)
    arrays = {name: ("state", name, "s") for name in ("along", "columns")}
    arrays["turn"] = ("state", "turned_by", "s")
    arrays |= dict.fromkeys(("real", "imaginary"), ("angles", "in", "SENSITIVE"))
    for name, (part, array, apart) in arrays.items():
        rows = [f"{array} + {k} * {apart}" for k in range(len(by_name[f"_{name}_{part}"].results))]
        rows[:2] = [array, f"{array} + {apart}"]
        marks[f"{name} rows of {array}"] = ", ".join(rows)
    return marks


def _numbers(functions: tuple[Function, ...], constants: tuple[Constant, ...]) -> Iterator[str]:
    """The numbers that functions use, to the last digit."""
    used = {name for function in functions for name in function.used()}
    for number in constants:
        if number.name in used and number.lo is None:
            yield f"static const double {number.name} = {number.hi!r};"
        elif number.name in used:
            pair = f"{{{number.hi!r}, {number.lo!r}}}"
            yield f"static const double_double {number.name} = {pair};"


def _next(file: str, given: Iterator[Statement], expected: object) -> Statement:
    for statement in given:
        return statement
    raise InputError(file, expected, "is not there")


def _expect(file: str, given: Iterator[Statement], expected: str) -> None:
    line, text = _next(file, given, expected)
    if text != expected:
        raise InputError(f"{file}:{line}", text, f"is not {expected:.80}")


def _expect_end(file: str, given: Iterator[Statement]) -> None:
    for line, text in given:
        raise InputError(f"{file}:{line}", text, "is nothing that this module has")


def _check_function(
    frame: Frame, given: Iterator[Statement], known: Mapping[str, Function], derived: Between
) -> None:
    for statement in frame.before:
        _expect(derived.file, given, statement)
    function = frame.function
    extended = function.all_extended()
    reader = Reader(frame.name, frame.number, extended, known)
    for let, fused in zip(function.lets, fuse(function), strict=True):
        if len(let.targets) > 1:
            _expect(derived.file, given, f"double_double {', '.join(let.targets)};")
        line, text = _next(derived.file, given, let)
        _check_line(reader, text, fused)
        _, _, note = derived.at(line).partition("; /* ")
        if note.removesuffix(" */") != comment(let):
            raise InputError(frame.name, f"{let} /* {note}", f"is by {comment(let)}")
        if not is_equal(unfused(fused.expression), let.expression):
            raise InputError(frame.name, fused, f"{let}: not what was fused")
    for statement in frame.after:
        _expect(derived.file, given, statement)


def _check_line(reader: Reader, line: str, let: Let) -> None:
    """A line sets what its let sets, to that, as a number of its kind."""
    if found := _SET.fullmatch(line):
        expression, is_pair = reader.read(found[3])
        kind = _PAIRS[reader.number] if is_pair else "double"
        read = (found[2],), expression
        if found[1] != kind:
            raise InputError(reader.place, line, f"{let}: is a {kind}")
    elif found := _CALL.fullmatch(line):
        read = tuple(found[2].split(", &")), reader.read(f"{found[1]})")[0]
    else:
        raise InputError(reader.place, line, f"sets no name: {let}")
    if read != (let.targets, let.expression):
        raise InputError(reader.place, line, f"{let}: {DIFFERS}")
