"""Printer of routines as C99 code.

Structs and arrays are handed on by reference, numbers and double-doubles by value.  Several
results are written through pointers (`pointers`).
"""

import ast
from collections.abc import Iterator, Mapping, Sequence
from typing import ClassVar

from rigidsym._codegen import printer
from rigidsym._codegen.printer import ATOM, COMPARED, OPERATIONS, UNARY
from rigidsym._codegen.routines import Enumeration, Field, Number, Program, Routine, Struct, Type

TYPES = {
    **{"double": "double", "int": "int", "size": "size_t", "bits": "uint64_t", "bool": "int"},
    **{"pair": "double_double", "text": "const char *", "void": "void"},
}
CALLS = {"abs": "fabs", "exponent": "exponent_of", "prefetch": "PREFETCH", "hidden": "hidden"}
CASTS = {"double": "double", "int": "int", "size": "size_t", "bits": "uint64_t"}


class Printer(printer.Printer):
    """Printer of a program's structs, numbers and routines in C.

    prefix: what the names of public functions and structs begin with.  names: what names that the
    program knows are called in C.
    """

    calls: ClassVar = CALLS

    def __init__(self, program: Program, prefix: str, names: Mapping[str, str]) -> None:
        super().__init__(program, {"inf": "HUGE_VAL", "nan": "((double)NAN)", **names})
        self.prefix = prefix

    # --- names and types

    def function_name(self, name: str) -> str:
        """Return the name of a routine in C."""
        return f"{self.prefix}{name}" if self.program.routines[name].is_public else name

    def type_name(self, name: str) -> str:
        """Return the name of a type in C."""
        if name in self.program.structs and self.program.structs[name].is_public:
            return f"{self.prefix}{name}"
        return TYPES.get(name, name)

    def declared(self, name: str, type_: Type, *, is_parameter: bool = False) -> str:
        """Return the declaration of a name, for example `const double x[3]`."""
        if type_.name == "raw":
            return type_.members[0]
        kind, shape = self.type_name(type_.name), "".join(f"[{x}]" for x in type_.shape)
        kind = kind if kind.endswith("*") else f"{kind} "
        if not is_parameter:
            if type_.shape == ("...",) or type_.may_be_none:
                return f"const {kind}*{name}"
            return f"{kind}{name}{shape}"
        by_reference = type_.is_struct or type_.is_result or bool(type_.shape)
        const = "const " if by_reference and not type_.is_out else ""
        note = " /* or NULL */" if type_.may_be_none else ""
        if type_.shape and type_.shape[0] != "...":
            return f"{const}{kind}{name}{shape}{note}"
        if not by_reference:
            return f"{kind}{name}"
        is_private = bool(type_.shape) and not self.one.is_public and not type_.may_be_none
        alone = "restrict " if type_.is_alone or is_private else ""
        rest = "".join(f"[{x}]" for x in type_.shape[1:])
        star = f"(*{alone}{name})" if rest else f"*{alone}{name}"
        return f"{const}{kind}{star}{rest}{note}"

    def head(self, one: Routine) -> str:
        """Return the head of a routine, from its storage to the closing bracket."""
        self.one = one
        parameters = [
            self.declared(name, type_, is_parameter=True) for name, type_ in one.parameters.items()
        ]
        kind = self.type_name(one.results[0].name) if one.results else "void"
        storage = "" if one.is_public else "static "
        storage += "INLINED " if "inline" in one.decorators else ""
        storage += "FLAT " if "flat" in one.decorators else ""
        kind = kind if kind.endswith("*") else f"{kind} "
        begin = f"{storage}{kind}{self.function_name(one.name)}("
        return self.wrapped(begin, parameters or ["void"], ")")

    # --- definitions

    def struct(self, struct: Struct) -> str:
        """Print the definition of a struct."""
        lines = [*self.note(struct.summary)] if struct.summary else []
        lines.append("typedef struct {")
        for field in struct.fields:
            note = f" /* {field.comment} */" if field.comment else ""
            lines += [f"    {line}" for line in self._member(field)]
            lines[-1] += note
        return "\n".join([*lines, f"}} {self.type_name(struct.name)};"])

    def _member(self, field: Field) -> Iterator[str]:
        if field.type.name == "union":
            yield "union {"
            for name in field.type.members:
                yield f"    {self.type_name(name)} {name};"
            yield f"}} {field.name};"
        else:
            yield f"{self.declared(field.name, field.type)};"

    def enumeration(self, one: Enumeration) -> str:
        """Print an enumeration with its comments."""
        lines = [*self.note(one.summary), "enum {"]
        for number in one.numbers:
            note = f" /* {number.comment} */" if number.comment else ""
            comma = "" if number is one.numbers[-1] else ","
            name = self.names.get(number.name, number.name)
            lines.append(f"    {name} = {self.text(number.value)}{comma}{note}")
        return "\n".join([*lines, "};"])

    def number(self, number: Number) -> str:
        """Print the definition of a named number or array."""
        value = self._initial(number.value)
        note = f" /* {number.comment} */" if number.comment else ""
        if number.type.name == "text":
            # No array of pointers: a shared library would have to write them when it is loaded.
            shape = "".join(f"[{x}]" for x in (*number.type.shape, _room(number.value)))
            return f"static const char {number.name}{shape} = {value};{note}"
        if number.type.name in ("int", "size") and not number.type.shape:
            return f"enum {{ {number.name} = {value} }};{note}"
        return f"static const {self.declared(number.name, number.type)} = {value};{note}"

    def _initial(self, node: ast.expr) -> str:
        if isinstance(node, ast.List | ast.Tuple):
            return f"{{{', '.join(map(self._initial, node.elts))}}}"
        match node:
            case ast.Call(func=ast.Name(id="pair"), args=parts):
                return f"{{{', '.join(map(self.text, parts))}}}"
        return self.text(node)

    def prototype(self, one: Routine) -> str:
        """Print the prototype of a public routine with its description."""
        return "\n".join([*self.note(one.summary), f"{self.head(one)};"])

    def notes(self, one: Routine) -> Sequence[str]:
        """Return the comment above a routine; the header describes public ones."""
        return [] if one.is_public else super().notes(one)

    # --- statements

    def _declaration(self, node: ast.AnnAssign) -> Iterator[str]:
        name = ast.unparse(node.target)
        type_ = self.scope.types[name]
        declared = self.declared(name, type_)
        if node.value is None:
            yield f"{declared};"
            return
        is_kept = name in self.set_again or type_.shape or declared.startswith("const ")
        const = "" if is_kept else "const "
        match node.value:
            case ast.List() | ast.Call(func=ast.Name(id="pair")):
                value = self._initial(node.value)
            case other:
                value = self.text(other)
        yield f"{const}{declared} = {value};"

    def _assignment(self, node: ast.Assign) -> Iterator[str]:
        (target,) = node.targets
        type_ = self.scope.of(target)
        match node.value:
            case value if type_.shape:
                length = " * ".join(type_.shape)
                place, size = self.text(target), self._element_size(type_)
                yield f"memcpy({place}, {self.text(value)}, {length} * {size});"
            case value:
                yield f"{self._whole(target)} = {self._whole(value)};"

    def _element_size(self, type_: Type) -> str:
        return f"sizeof({self.type_name(type_.name)})"

    def _whole(self, node: ast.expr) -> str:
        """Return a value itself, where its name is a pointer."""
        text = self.text(node)
        return (
            f"*{text}" if self._is_pointer(node) and not self.scope.of(node).may_be_none else text
        )

    def _cleared(self, struct: ast.expr) -> str:
        type_ = self.scope.of(struct)
        return f"memset({self.argument(struct, type_)}, 0, {self._element_size(type_)})"

    def _loop(self, name: str, first: str, end: ast.expr, step: ast.expr | None) -> str:
        by = f"{name}++" if step is None else f"{name} += {self.text(step)}"
        return f"for (size_t {name} = {first}; {name} < {self.text(end, COMPARED + 1)}; {by})"

    # --- expressions

    def argument(self, node: ast.expr, type_: Type) -> str:
        """Print an argument for a parameter of some type."""
        match node:
            case ast.Constant(value=None):
                return "NULL"
        if (type_.is_struct or type_.is_result) and not self._is_pointer(node):
            return f"&{self.text(node, UNARY)}"
        return self.text(node)

    def _is_pointer(self, node: ast.expr) -> bool:
        """Return True for a parameter that points to one value, and a member that may be none."""
        match node:
            case ast.Name(id=name) if name in self.one.parameters:
                type_ = self.one.parameters[name]
                return type_.is_struct or type_.is_result
            case ast.Attribute():
                return self.scope.of(node).may_be_none
        return False

    @staticmethod
    def truth(value: bool) -> str:
        """Print True or False as a whole number."""
        return str(int(value))

    @staticmethod
    def bits(value: int) -> str:
        """Print a constant of 64 bits."""
        return f"UINT64_C({value:#x})"

    def _attribute(self, node: ast.Attribute) -> tuple[str, int]:
        arrow = "->" if self._is_pointer(node.value) else "."
        return f"{self.text(node.value, ATOM)}{arrow}{node.attr}", ATOM

    def _slice(self, array: ast.expr, first: ast.expr) -> tuple[str, int]:
        _, bound = OPERATIONS[ast.Add]
        return f"{self.text(array, bound)} + {self.text(first, bound + 1)}", bound

    def _call(self, node: ast.Call) -> tuple[str, int]:
        match node:
            case ast.Call(func=ast.Name(id=cast), args=[value]) if cast in CASTS:
                return f"({CASTS[cast]}){self.text(value, UNARY)}", UNARY
            case ast.Call(func=ast.Name(id="sizeof"), args=[ast.Name(id=struct)]):
                return f"sizeof({self.type_name(struct)})", ATOM
        return super()._call(node)


def _room(texts: ast.expr) -> int:
    """Return the number of characters that the longest of some texts takes, with its end."""
    words = (node.value for node in ast.walk(texts) if isinstance(node, ast.Constant))
    return max(len(str(word).encode()) for word in words) + 1
