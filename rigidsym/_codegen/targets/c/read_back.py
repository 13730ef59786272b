"""Check of the printed C module, which is read back and compared with its functions.

The module holds numbers, functions and structs in order, and nothing else.  Hand-written text is
compared word for word, after its placeholders have been filled from the functions.
"""

import re
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from rigidsym._codegen import header
from rigidsym._codegen.forms import STEP, THETA, key
from rigidsym._codegen.ir import Constant, Function, Let, named
from rigidsym._codegen.lines import comment, shares
from rigidsym._codegen.passes import fuse, unfused
from rigidsym._codegen.seal.equality import DIFFERS, is_equal
from rigidsym._codegen.seal.text import Between, between
from rigidsym._codegen.targets.c import module
from rigidsym._codegen.targets.c.frames import Frame, frames, lane_structs, struct
from rigidsym.errors import InputError
from rigidsym.language._expression import Call, Expression, Name, Number, Operation, parse

# The types of extended numbers by what begins the names of their operations.
_PAIRS = {"dd": "double_double", "exact": "exact"}
_SET = re.compile(r"const (\w+) (\w+) = (.*);")
_CALL = re.compile(r"(\w+\([^&]*), &(\w+(?:, &\w+)*)\);")
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
# A backslash, or a trigraph, could end a comment early; the rest is what no derived line needs.
_STRANGE = re.compile(r"\\|\?\?|[^\n -~]")
_FOREIGN = re.compile(r"//|/\*|[^\w\s(){}\[\]+*/,;.=<>&-]")
# A loop, a number that is a pair, or what ends with a semicolon or begins or ends a block.
_STATEMENT = re.compile(r"\s*(for \([^(){}]*\) \{|[^;{}]*= \{[^;{}]*\};|[^;{}]*[;{}])")
_NUMBER = re.compile(r"(?<![\w.])[\d.][\w.]*")
_WHOLE = re.compile(r"(0|[1-9]\d*)\.0")
_OPERATIONS = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
# Functions of doubles and what they compute.
_OF_DOUBLES = {
    **{"fused": "fma", "fabs": "size", "sqrt": "sqrt", "exponential": "exp", "choose": "choose"},
    **{name: name for name in ("nearest", "alternating", "power_of_two", "product_error")},
}
# Functions of extended numbers, after `dd_`: kinds of arguments (x: extended), and of the value.
_OF_EXTENDED = {
    **{"neg": ("x", "x"), "sqrt": ("x", "x"), "size": ("x", "x"), "mantissa": ("x", "x")},
    **{"rounded": ("x", "d"), "exponent": ("x", "d"), "choose": ("ddxx", "x"), "of": ("d", "x")},
}


class Statement(NamedTuple):
    """C statement with single spaces, and the number of its first line."""

    line: int
    text: str


def statements(file: str, derived: Between) -> Iterator[Statement]:
    """Yield the C statements in generated text.

    Raises InputError for a character that derived text never has.
    """
    _refuse(file, derived, _STRANGE)
    # As many lines stay as comments have.
    bare = _COMMENT.sub(lambda comment: " " + "\n" * comment[0].count("\n"), derived.text)
    blank = Between(file, derived.line, bare)
    _refuse(file, blank, _FOREIGN)
    text, begin, line = blank.text, 0, blank.line
    end = len(text.rstrip())
    while begin < end:
        found = _STATEMENT.match(text, begin)
        if not found:
            raise InputError(f"{file}:{line}", text[begin:].strip(), "does not end")
        line += text.count("\n", begin, found.start(1))
        yield Statement(line, " ".join(found[1].split()))
        line += text.count("\n", found.start(1), found.end())
        begin = found.end()


def _refuse(file: str, text: Between, what: re.Pattern[str]) -> None:
    """Raise InputError for the first match of a pattern in a text."""
    found = what.search(text.text)
    if found:
        number = text.text.count("\n", 0, found.start())
        line = text.text.split("\n")[number].strip()
        rule = f"derived text has no {found[0].strip()!r}"
        raise InputError(f"{file}:{number + text.line}", line, rule)


@dataclass(frozen=True, slots=True)
class Reader:
    """Reader of the C expressions in one function.

    extended: the names of the function's extended numbers.  number: the prefix of operations on
    these, `dd` or `exact`.  functions: those of the module that may be called, by name.
    """

    place: str
    number: str
    extended: Collection[str]
    functions: Mapping[str, Function]

    def read(self, text: str) -> tuple[Expression, bool]:
        """Parse a C expression; return it, and True if its value is an extended number.

        Raises InputError for any other text.
        """
        for number in _NUMBER.findall(text):
            if not _WHOLE.fullmatch(number):
                raise InputError(self.place, text, f"{number} is no whole number with a point")
        if re.search(r"\bneg\(", text):
            raise InputError(self.place, text, "neg: called and not known")
        try:
            expression = parse(_WHOLE.sub(r"\1", text))
        except (SyntaxError, ValueError):
            raise InputError(self.place, text, "is no expression") from None
        whole, kind = self._read(expression)
        return whole, kind == "x"

    def _read(self, expression: Expression) -> tuple[Expression, str]:
        match expression:
            case Number():
                return expression, "d"
            case Name(name):
                return expression, "x" if name in self.extended else "d"
            case Operation(symbol, left, right) if symbol in _OPERATIONS.values():
                return Operation(symbol, *self._all((left, right), "dd", symbol)), "d"
            case Call("neg", arguments):
                return Call("neg", self._all(arguments, "d", "-")), "d"
            case Call(function, arguments):
                return self._call(function, arguments)
        raise InputError(self.place, expression, "is nothing that derived lines have")

    def _call(self, function: str, arguments: tuple[Expression, ...]) -> tuple[Expression, str]:
        number, _, verb = function.partition("_")
        if number == self.number:
            return self._extended(function, verb, arguments)
        if function in _OF_DOUBLES:
            kinds = "d" * len(arguments)
            return Call(_OF_DOUBLES[function], self._all(arguments, kinds, function)), "d"
        if function in self.functions:
            called = self.functions[function]
            kinds = "".join("x" if name in called.extended else "d" for name in called.parameters)
            value = "x" if called.extended else "d"
            return Call(called.name, self._all(arguments, kinds, function)), value
        raise InputError(self.place, function, "called and not known")

    def _extended(
        self, function: str, verb: str, arguments: tuple[Expression, ...]
    ) -> tuple[Expression, str]:
        operation, _, kinds = verb.partition("_")
        if operation in _OPERATIONS and kinds in ("xx", "xd", "dx"):
            parts = self._all(arguments, kinds, function)
            return Operation(_OPERATIONS[operation], *parts), "x"
        if verb not in _OF_EXTENDED:
            raise InputError(self.place, function, "called and not known")
        kinds, value = _OF_EXTENDED[verb]
        parts = self._all(arguments, kinds, function)
        return (parts[0] if verb == "of" else Call(verb, parts)), value

    def _all(
        self, arguments: tuple[Expression, ...], kinds: str, function: str
    ) -> tuple[Expression, ...]:
        """Read all arguments of a call, and check that each is a double or extended as required."""
        read = [self._read(argument) for argument in arguments]
        if "".join(kind for _, kind in read) != kinds:
            raise InputError(self.place, function, "is given another kind of numbers")
        return tuple(argument for argument, _ in read)


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """Check the printed C files against their functions, and return the number of derived lines.

    Raises InputError for a line that differs from its let.
    """
    source, files = module.SOURCES[form], _plain(files, form)
    _check_header(files[module.HEADERS[form]], functions, form)
    parts = module.source_first(form), module.source_last(functions, form)
    derived = between(source, files[source], key("c", form), *parts)
    given = statements(source, derived)
    for constant in named(functions, constants):
        kind, value = "double", repr(constant.hi)
        if constant.lo is not None:
            kind, value = "double_double", f"{{{constant.hi!r}, {constant.lo!r}}}"
        _expect(source, given, f"static const {kind} {constant.name} = {value};")
    for statement in lane_structs(functions):
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
    """Return the C files with each name's prefix replaced by the default prefix.

    Raises InputError for a name with another form's prefix.
    """
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
    first = module.header_first(form).replace(header.SHARES, shares(kinds, key("c", form)))
    last = module.header_last(functions, form)
    structs = statements(file, between(file, text, key("c", form), first, last))
    given = iter(_without_rows(structs))
    for function in functions:
        if function.rounds and form != STEP:
            for line in struct(function):
                _expect(file, given, line)
    _expect_end(file, given)


def _without_rows(given: Iterator[Statement]) -> list[Statement]:
    """Join declarations of struct members that are split over several rows."""
    rows: list[Statement] = []
    for statement in given:
        if rows and all(x.text.startswith("double ") for x in (statement, rows[-1])):
            line, text = rows.pop()
            more = statement.text.removeprefix("double ")
            statement = Statement(line, f"{text.removesuffix(';')}, {more}")
        rows.append(statement)
    return rows


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
    """Check the names, value and type in a C statement against its assignment."""
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
