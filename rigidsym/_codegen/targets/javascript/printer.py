"""Printer of JavaScript, from the routines of `rigidsym._codegen.objects`, and of its types."""

import ast
from collections.abc import Iterator, Sequence
from textwrap import wrap
from typing import ClassVar

from rigidsym._codegen import printer
from rigidsym._codegen.objects import LET, zero
from rigidsym._codegen.printer import ATOM, COMPARED, WIDTH
from rigidsym._codegen.routines import Enumeration, Number, Routine, Struct, Type

CALLS = {
    **{name: f"Math.{name}" for name in ("abs", "sqrt", "log", "log2")},
    **{"isfinite": "Number.isFinite", "isnan": "Number.isNaN", "int": "Math.trunc"},
    **{"bits": "BigInt", "product_error": "split_product_error"},
}
COMPARISONS = {
    **printer.COMPARISONS,
    **dict.fromkeys((ast.Eq, ast.Is), "==="),
    **dict.fromkeys((ast.NotEq, ast.IsNot), "!=="),
}
NAMES = {"inf": "Infinity", "nan": "NaN", "ALLOW_NONPHYSICAL": "settings.ALLOW_NONPHYSICAL"}
_TYPES = {
    **dict.fromkeys(("double", "int", "size"), "number"),
    **{"bool": "boolean", "text": "string", "bits": "bigint", "pair": "Pair", "void": "void"},
}


class Printer(printer.Printer):
    """Printer of a program's structs, numbers and routines in JavaScript."""

    calls: ClassVar = CALLS
    comparisons: ClassVar = COMPARISONS
    none: ClassVar = "null"
    opening: ClassVar = " {"

    # --- definitions

    def enumeration(self, one: Enumeration) -> Iterator[str]:
        """Print whole numbers of the interface."""
        for x in one.numbers:
            yield f"export const {x.name} = {self.text(x.value)}; // {x.comment}"

    def struct(self, struct: Struct) -> str:
        """Print the function that makes a struct of zeros."""
        notes = (f" // {x.comment}" if x.comment else "" for x in struct.fields)
        zeros = (f"{x.name}: {self.text(zero(x.type))}" for x in struct.fields)
        members = [f"        {x},{note}" for x, note in zip(zeros, notes, strict=True)]
        word = "export " if struct.is_public else ""
        head = f"{word}function new_{struct.name}() {{"
        return "\n".join([head, "    return {", *members, "    };", "}", ""])

    def number(self, number: Number) -> str:
        """Print the definition of a named number or array."""
        note = f" // {number.comment}" if number.comment else ""
        return f"const {number.name} = {self._initial(number.value, number.type)};{note}"

    def _initial(self, node: ast.expr, type_: Type) -> str:
        match node:
            case ast.Constant(value=int(value)) if type_.name == "bits":
                return self.bits(value)
        return self.text(node)

    @staticmethod
    def bits(value: int) -> str:
        """Print a constant of 64 bits."""
        return f"{value:#x}n"

    # --- routines

    def head(self, one: Routine) -> str:
        """Return the head of a routine."""
        word = "export " if one.is_public else ""
        return self.wrapped(f"{word}function {one.name}(", [*one.parameters], ")")

    def notes(self, one: Routine) -> Sequence[str]:
        """Return the comment above a routine, that of tools for public ones."""
        if not one.is_public:
            return super().notes(one)
        paragraphs = (wrap(" ".join(x.split()), WIDTH - 3) for x in one.summary.split("\n\n"))
        lines = [line for paragraph in paragraphs for line in [*paragraph, ""]]
        return ["/**", *(f" * {line}".rstrip() for line in lines[:-1]), " */"]

    def _declaration(self, node: ast.AnnAssign) -> Iterator[str]:
        value = f" = {self.text(node.value)}" if node.value else ""
        yield f"{ast.unparse(node.annotation)} {ast.unparse(node.target)}{value};"

    def _assignment(self, node: ast.Assign) -> Iterator[str]:
        word = f"{LET} " if node.type_comment else ""
        yield f"{word}{self.text(node.targets[0])} = {self.text(node.value)};"

    def _cleared(self, struct: ast.expr) -> str:
        raise NotImplementedError("objects say this")

    def _loop(self, name: str, first: str, end: ast.expr, step: ast.expr | None) -> str:
        by = f"{name}++" if step is None else f"{name} += {self.text(step)}"
        return f"for (let {name} = {first}; {name} < {self.text(end, COMPARED + 1)}; {by})"

    # --- expressions

    def argument(self, node: ast.expr, type_: Type) -> str:
        """Print an argument, which is passed on as it is."""
        return self.text(node)

    def _several(self, node: ast.Tuple | ast.List) -> tuple[str, int]:
        return f"[{', '.join(map(self.text, node.elts))}]", ATOM

    def _members(self, node: ast.Dict) -> tuple[str, int]:
        both = zip(filter(None, node.keys), node.values, strict=True)
        members = (f"{ast.literal_eval(name)}: {self.text(value)}" for name, value in both)
        return f"{{ {', '.join(members)} }}", ATOM

    def _constant(self, node: ast.Constant) -> tuple[str, int]:
        match node:
            case ast.Constant(value=int(value), kind="n"):
                return self.bits(value), ATOM
        return super()._constant(node)

    def _operand(self, node: ast.expr, other: ast.expr, least: int) -> str:
        return self.text(node, least)

    def _slice(self, array: ast.expr, first: ast.expr) -> tuple[str, int]:
        return f"{self.text(array, ATOM)}.subarray({self.text(first)})", ATOM

    # --- type declarations

    def declared_struct(self, struct: Struct) -> str:
        """Print the type of a struct, and the function that makes one."""
        members: list[str] = []
        for x in struct.fields:
            members += [f"    /** {x.comment} */"] if x.comment else []
            members.append(f"    {x.name}: {_type(x.type)};")
        made = f"export function new_{struct.name}(): {struct.name};"
        head = [*self.note(struct.summary)] if struct.summary else []
        return "\n".join([*head, f"export interface {struct.name} {{", *members, "}", made])

    def declared_routine(self, one: Routine) -> str:
        """Print the type of a routine with its description."""
        parameters = [f"{name}: {_type(x, True)}" for name, x in one.parameters.items()]
        kinds = [_type(x) for x in one.results] or ["void"]
        result = kinds[0] if len(kinds) == 1 else f"[{', '.join(kinds)}]"
        head = self.wrapped(f"export function {one.name}(", parameters, f"): {result};")
        return "\n".join([*self.notes(one), head])


def _type(type_: Type, is_parameter: bool = False) -> str:
    """Return a type in TypeScript."""
    if type_.name == "union":
        return f"{{ {'; '.join(f'{name}: {name}' for name in type_.members)} }}"
    name = _TYPES.get(type_.name, type_.name)
    if type_.shape and (type_.shape[0] == "..." or (is_parameter and type_.is_out)):
        name = "Int32Array" if type_.name == "int" else "Float64Array"
    else:
        for _ in type_.shape:
            name = f"ArrayLike<{name}>" if is_parameter else f"{name}[]"
    return f"{name} | null" if type_.may_be_none else name
