"""Interface of the Rust crate: refusals, and functions that return results, from the routines."""

import re
from collections.abc import Iterator
from textwrap import wrap

from rigidsym._codegen.printer import WIDTH
from rigidsym._codegen.routines import INT, Enumeration, Routine
from rigidsym._codegen.targets.rust.printer import Printer, type_name

_PART = re.compile(r"\w+(?:\[[^]]*\])+")
# What a function says of its code, which is a result here.
_CODE = re.compile(r"; return a code(?: as \w+ does)?(?: and a body)?")


def refusals(one: Enumeration, said: list[Routine]) -> Iterator[str]:
    """Print the codes as an enumeration, with the words that routines say of them."""
    names = {x.name: type_name(x.name.lower()) for x in one.numbers[1:]}
    numbers = range(1, len(one.numbers))
    yield "/// A refused input, by the rule that it breaks."
    yield "#[derive(Clone, Copy, Debug, PartialEq, Eq)]\npub enum Refusal {"
    for x, number in zip(one.numbers[1:], numbers, strict=True):
        yield from _documented(x.comment, "    ")
        yield f"    {names[x.name]} = {number},"
    yield "}\n\nimpl Refusal {"
    for k, routine in enumerate(said):
        yield from [""] * bool(k)
        yield from _documented(routine.summary, "    ")
        yield f"    pub fn {routine.name}(self) -> &'static str {{"
        yield f"        routines::{routine.name}(self as i32)\n    }}"
    yield "}\n"
    yield "/// Return the refusal that a code stands for; 0 is none."
    yield "pub fn refused(code: i32) -> Result<(), Refusal> {\n    Err(match code {"
    for name, number in zip(names.values(), numbers, strict=True):
        yield f"        {number} => Refusal::{name},"
    yield "        _ => return Ok(()),\n    })\n}\n"


def function(one: Routine, printer: Printer) -> Iterator[str]:
    """Print a public function, which returns what its routine writes, or the refusal."""
    made = {x: type_name(t.name) for x, t in one.parameters.items() if t.is_struct and t.is_out}
    given = [x if x not in made else f"&mut {x}" for x in one.parameters]
    call = f"routines::{one.name}({', '.join(given)})"
    parameters = [printer.parameter(*x) for x in one.parameters.items() if x[0] not in made]
    ok = ", ".join(made.values()) or "()"
    body = [f"let mut {name} = {kind}::ZERO;" for name, kind in made.items()]
    result = f" -> Result<{ok}, Refusal>"
    if one.results[0] != INT:
        result, last = printer.results(one), [call]
    elif len(one.results) > 1:
        result = f" -> Result<{ok}, (Refusal, usize)>"
        last = [f"let (code, k) = {call};", "refused(code).map_err(|refusal| (refusal, k))"]
    elif made:
        last = [f"refused({call})?;", f"Ok({', '.join(made)})"]
    else:
        last = [f"refused({call})"]
    yield from _documented(_CODE.sub("", one.summary))
    yield printer.wrapped(f"pub fn {one.name}(", parameters, f"){result} {{")
    yield from (f"    {line}" for line in (*body, *last))
    yield "}\n"


def _documented(text: str, indent: str = "") -> Iterator[str]:
    """Print a comment of documentation, in which parts of arrays are code."""
    text = _PART.sub(lambda found: f"`{found[0]}`".replace(" ", "\xa0"), text)
    for k, paragraph in enumerate(text.split("\n\n")):
        yield from [f"{indent}///"] * bool(k)
        for line in wrap(" ".join(paragraph.split(" ")), WIDTH - 8):
            yield f"{indent}/// {line}".replace("\xa0", " ")
