"""The C source read back: its functions hold the lets, one a line, and nothing else that counts."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import replace

from rigidsym.codegen.ir import Constant, Function, Let
from rigidsym.codegen.lines import flat_results
from rigidsym.codegen.passes import fuse, unfused
from rigidsym.codegen.seal.claims import DIFFERS
from rigidsym.codegen.seal.equality import is_equal
from rigidsym.codegen.targets.c import emit, module
from rigidsym.errors import InputError
from rigidsym.language.expression import Call, Expression, children, rebuild

_SET = re.compile(r"const (?:double|double_double|exact) (\w+) = (.*);")
_CALL = re.compile(r"(\w+\(.*?), (&\w+(?:, &\w+)*)\);")
_STORES = (
    re.compile(r"\*(\w+)_out = (\w+);"),
    re.compile(r"(\w+)_out\[i\] = (\w+);"),
    re.compile(r"motion->(\w+) = (?:dd_rounded\((?=\w+\)))?([\w.]+)\)?;"),
)
_FRAME = re.compile(
    r"(?:double_double|exact) \w+(?:, \w+)*;|for \(size_t i = 0; i < n; i\+\+\) \{|\}"
)


def check(
    files: Mapping[str, str], functions: tuple[Function, ...], constants: tuple[Constant, ...]
) -> int:
    """The number of lines that read back as their lets; raises InputError for the first not to."""
    source = files[module.SOURCE]
    _check_numbers(source, functions, constants)
    decided = 0
    for function in functions:
        for name, printed in _printed(function):
            _check_function(name, printed, _body(source, name))
            decided += len(printed.lets)
    return decided


def _check_numbers(
    source: str, functions: tuple[Function, ...], constants: tuple[Constant, ...]
) -> None:
    """Named numbers are written to the last digit."""
    used = {name for function in functions for name in function.used()}
    for number in constants:
        found = re.findall(rf"static const \w+ {number.name} = (.*?); /\*", source)
        expected = [number.hi] if number.lo is None else [number.hi, number.lo]
        values = [[float(part) for part in text.strip("{}").split(",")] for text in found]
        if number.name in used and values != [expected]:
            raise InputError(module.SOURCE, number.name, f"is not {expected}")


def _printed(function: Function) -> Iterator[tuple[str, Function]]:
    """The functions of C that print this one."""
    if function.name == "_discriminant":
        every = replace(function, extended=frozenset(function.parameters))
        yield from (("discriminant_dd", every), ("discriminant_exact", every))
    else:
        yield function.name[1:], function


def _body(source: str, name: str) -> list[str]:
    """The lines of a function between its braces, without comments."""
    pattern = rf"^static (?:inline )?\w+ {name}\([^)]*\)\n{{\n(.*?)^}}"
    found = re.findall(pattern, source, re.DOTALL | re.MULTILINE)
    if len(found) != 1:
        raise InputError(name, module.SOURCE, f"is there {len(found)} times")
    return [re.sub(r" /\*.*?\*/", "", line).strip() for line in found[0].splitlines()]


def _check_function(name: str, function: Function, lines: list[str]) -> None:
    fused = zip(function.lets, fuse(function), strict=True)
    stored: dict[str, str] = {}
    returned = None
    for line in lines:
        if line.startswith("return "):
            returned = line.removeprefix("return ").rstrip(";")
        elif store := next(filter(None, (form.fullmatch(line) for form in _STORES)), None):
            stored[store[1]] = store[2]
        elif not _FRAME.fullmatch(line) and not _is_load(line):
            _check_line(name, line, next(fused, None))
    if (missing := next(fused, None)) is not None:
        raise InputError(name, missing[0], "is not printed")
    _check_results(name, function, returned, stored)


def _is_load(line: str) -> bool:
    """A parameter that comes from the motion or from an array, under its own name."""
    found = _SET.fullmatch(line)
    return bool(found) and found[2] in (f"motion->{found[1]}", f"{found[1]}_in[i]")


def _check_line(name: str, line: str, expected: tuple[Let, Let] | None) -> None:
    if expected is None:
        raise InputError(name, line, "no let stands behind it")
    let, fused = expected
    if _read(line) != (let.targets, _without_prefix(fused.expression)):
        raise InputError(name, line, f"{let}: {DIFFERS}")
    if not is_equal(unfused(fused.expression), let.expression):
        raise InputError(name, line, f"{let}: not what was fused")


def _read(line: str) -> tuple[tuple[str, ...], Expression] | None:
    """What a line sets, and to what."""
    if found := _SET.fullmatch(line):
        return (found[1],), emit.read(line)
    if found := _CALL.fullmatch(line):
        return tuple(found[2].replace("&", "").split(", ")), emit.read(f"{found[1]})")
    return None


def _without_prefix(expression: Expression) -> Expression:
    """Functions of the module have a leading underscore in lets and none in C."""
    parts = tuple(map(_without_prefix, children(expression)))
    if isinstance(expression, Call):
        return Call(expression.function.removeprefix("_"), parts)
    return rebuild(expression, parts)


def _check_results(
    name: str, function: Function, returned: str | None, stored: dict[str, str]
) -> None:
    """Each result is handed out under its own name."""
    names = flat_results(function) if function.rounds else list(function.results)
    halves = {f"{split}_{half}": f"{split}.{half}" for split in function.split
              for half in ("hi", "lo")}  # fmt: skip
    expected = {result: halves.get(result, result) for result in names}
    if stored != expected and (stored or [returned] != names):
        raise InputError(name, stored or returned, f"does not hand out {', '.join(names)}")
