"""Printer of routines in Rust.

Structs and arrays are handed on by reference, numbers, double-doubles and exact numbers by value.
An array that may be None is an empty slice.
"""

import ast
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from textwrap import wrap
from typing import ClassVar

from rigidsym._codegen import printer
from rigidsym._codegen.printer import ATOM, CHOICE, COMPARED, UNARY, WIDTH
from rigidsym._codegen.routines import (
    Field,
    Number,
    Program,
    Routine,
    Struct,
    Type,
    type_of_annotation,
)
from rigidsym._codegen.targets.rust.declared import LET, is_zero_at_first

TYPES = {
    **{"double": "f64", "int": "i32", "size": "usize", "bits": "u64", "bool": "bool"},
    **{"pair": "Pair", "exact": "Exact", "text": "&'static str"},
}
CALLS = {
    **{"bits_of": "f64::to_bits", "from_bits": "f64::from_bits", "dd_pair": "pair"},
    **{"isfinite": "f64::is_finite", "isnan": "f64::is_nan"},
    "product_error": "split_product_error",
}
NAMES = {"inf": "f64::INFINITY", "nan": "f64::NAN"}
CASTS = ("double", "int", "size", "bits")


def type_name(name: str) -> str:
    """Return the name of a type in Rust."""
    return TYPES.get(name) or "".join(part.capitalize() for part in name.split("_"))


def whole(type_: Type) -> str:
    """Return a type in Rust, for example `[f64; 3]`."""
    found = type_name(type_.name)
    for length in reversed(type_.shape):
        count = length if length.isdigit() else f"{length} as usize"
        found = f"[{found}]" if length == "..." else f"[{found}; {count}]"
    return found


def zero(text: str) -> str:
    """Return the zero of a type in Rust.

    >>> zero("[[f64; 2]; 3]"), zero("Motion")
    ('[[0.0; 2]; 3]', 'Motion::ZERO')
    """
    if text.startswith("["):
        element, _, length = text[1:-1].rpartition("; ")
        return f"[{zero(element)}; {length}]"
    known = {"f64": "0.0", "i32": "0", "usize": "0", "u64": "0", "bool": "false"}
    return known.get(text) or f"{text}::ZERO"


class Printer(printer.Printer):
    """Printer of a program's structs, numbers and routines in Rust."""

    calls: ClassVar = CALLS
    condition: ClassVar = "{}"
    opening: ClassVar = " {"

    def __init__(self, program: Program) -> None:
        super().__init__(program, NAMES)
        self.sets: Counter[str] = Counter()

    # --- definitions

    def struct(self, struct: Struct) -> Iterator[str]:
        """Print a struct, its zero, and the structs of members that are a union elsewhere."""
        for one in structs(struct):
            yield from self._struct(one)

    @staticmethod
    def _struct(struct: Struct) -> Iterator[str]:
        word = "pub " if struct.is_public else "pub(crate) "
        name, kinds = type_name(struct.name), {x.name: whole(x.type) for x in struct.fields}
        yield from (f"/// {line}" for line in wrap(struct.summary, WIDTH - 4))
        yield f"#[derive(Clone, Copy, Debug)]\n{word}struct {name} {{"
        for x in struct.fields:
            note = f" // {x.comment}" if x.comment else ""
            yield f"    pub(crate) {x.name}: {kinds[x.name]},{note}"
        yield f"}}\n\nimpl {name} {{\n    /// All numbers are zero."
        yield "    pub const ZERO: Self = Self {"
        yield from (f"        {member}: {zero(kind)}," for member, kind in kinds.items())
        yield "    };\n}\n"

    def number(self, number: Number) -> str:
        """Print the definition of a named number or array."""
        note = f" // {number.comment}" if number.comment else ""
        return f"const {number.name}: {whole(number.type)} = {self.text(number.value)};{note}"

    # --- routines

    def parameter(self, name: str, type_: Type) -> str:
        """Return the declaration of a parameter."""
        is_reference = type_.is_struct or type_.shape
        mark = "&mut " if type_.is_out else "&" if is_reference else ""
        return f"{name}: {mark}{whole(type_)}"

    @staticmethod
    def results(one: Routine) -> str:
        """Return what a head says of a routine's results."""
        kinds = ", ".join(map(whole, one.results))
        return "" if not kinds else f" -> ({kinds})" if len(one.results) > 1 else f" -> {kinds}"

    def head(self, one: Routine) -> str:
        """Return the head of a routine."""
        self.sets, mark = _sets(one), "#[inline]\n" if "inline" in one.decorators else ""
        parameters = [self.parameter(*both) for both in one.parameters.items()]
        return self.wrapped(f"{mark}pub(crate) fn {one.name}(", parameters, f"){self.results(one)}")

    def _declaration(self, node: ast.AnnAssign) -> Iterator[str]:
        name = ast.unparse(node.target)
        type_ = self.scope.types[name]
        text = zero(whole(type_)) if is_zero_at_first(type_) else ""
        text = self._copied(node.value) if node.value is not None else text
        yield f"let {self._mutable(name)}: {whole(type_)}{f' = {text}' if text else ''};"

    def _mutable(self, name: str) -> str:
        return f"mut {name}" if self.sets[name] > 1 else name

    def _assignment(self, node: ast.Assign) -> Iterator[str]:
        (target,), value = node.targets, self._copied(node.value)
        if isinstance(target, ast.Tuple) and node.type_comment == LET:
            names = (self._mutable(_root(name)) for name in target.elts)
            yield f"let ({', '.join(names)}) = {value};"
        else:
            yield f"{self._copied(target)} = {value};"

    def _copied(self, node: ast.expr) -> str:
        """Print a value or a place, not a reference to it."""
        match node:
            case ast.Name(id=name) if self._is_reference(name):
                return f"*{name}"
            case ast.Subscript(slice=ast.Slice()):
                return f"*fixed(&{self.text(node)})"
        return self.text(node)

    def _is_reference(self, name: str) -> bool:
        type_ = self.one.parameters.get(name)
        return type_ is not None and bool(type_.is_struct or type_.shape)

    def _cleared(self, struct: ast.expr) -> str:
        return f"{self._copied(struct)} = {zero(whole(self.scope.of(struct)))}"

    def _loop(self, name: str, first: str, end: ast.expr, step: ast.expr | None) -> str:
        if step is not None:
            raise ValueError(f"{name}: Rust's loops have no step")
        return f"for {name} in {first}..{self.text(end, COMPARED + 1)}"

    # --- expressions

    def argument(self, node: ast.expr, type_: Type) -> str:
        """Print an argument for a parameter of some type."""
        mark = "&mut " if type_.is_out else "&"
        match node:
            case ast.Constant(value=None):
                return f"{mark}[]"
            case ast.Name(id=name) if self._is_reference(name):
                return name
            case ast.Subscript(slice=ast.Slice()) if type_.shape != ("...",):
                return f"fixed{'_mut' if type_.is_out else ''}({mark}{self.text(node)})"
        is_reference = type_.is_struct or type_.shape
        return f"{mark}{self.text(node, ATOM)}" if is_reference else self.text(node)

    def _several(self, node: ast.Tuple | ast.List) -> tuple[str, int]:
        begin, end = "()" if isinstance(node, ast.Tuple) else "[]"
        return f"{begin}{', '.join(map(self._copied, node.elts))}{end}", ATOM

    def _slice(self, array: ast.expr, first: ast.expr) -> tuple[str, int]:
        return f"{self.text(array, ATOM)}[{self.text(first, COMPARED + 1)}..]", ATOM

    def _subscript(self, node: ast.Subscript) -> tuple[str, int]:
        if isinstance(node.slice, ast.Slice):
            return super()._subscript(node)
        parts = node.slice.elts if isinstance(node.slice, ast.Tuple) else [node.slice]
        places = "".join(f"[{self._place(part)}]" for part in parts)
        return f"{self.text(node.value, ATOM)}{places}", ATOM

    def _place(self, node: ast.expr) -> str:
        is_cast = self.scope.of(node).name == "int" and not isinstance(node, ast.Constant)
        return f"{self.text(node, UNARY)} as usize" if is_cast else self.text(node)

    def _operation(self, node: ast.BinOp) -> tuple[str, int]:
        if isinstance(node.op, ast.Mult) and self.scope.of(node).name == "bits":
            one, other = self.text(node.left, ATOM), self._operand(node.right, node.left, 0)
            return f"{one}.wrapping_mul({other})", ATOM
        return super()._operation(node)

    def _comparison(self, node: ast.Compare) -> tuple[str, int]:
        if isinstance(node.ops[0], ast.Is | ast.IsNot):
            sign = "!" if isinstance(node.ops[0], ast.IsNot) else ""
            return f"{sign}{self.text(node.left, ATOM)}.is_empty()", UNARY
        return super()._comparison(node)

    def _choice(self, node: ast.IfExp) -> tuple[str, int]:
        one, other = self.text(node.body), self.text(node.orelse)
        return f"if {self.text(node.test)} {{ {one} }} else {{ {other} }}", CHOICE

    def _call(self, node: ast.Call) -> tuple[str, int]:
        match node:
            case ast.Call(func=ast.Name(id=cast), args=[value]) if cast in CASTS:
                return f"{self.text(value, UNARY)} as {TYPES[cast]}", COMPARED
        return super()._call(node)


def structs(struct: Struct) -> Iterator[Struct]:
    """Yield a struct after the structs that stand for its unions."""
    fields = []
    for x in struct.fields:
        name = f"{struct.name}_{x.name}"
        if x.type.name == "union":
            yield Struct(name, "", tuple(Field(part, Type(part)) for part in x.type.members))
        fields.append(replace(x, type=Type(name)) if x.type.name == "union" else x)
    yield replace(struct, fields=tuple(fields))


def _sets(one: Routine) -> Counter[str]:
    """Count how often each name is set, or handed on to be written to."""
    found: Counter[str] = Counter()
    for node in (node for part in one.body for node in ast.walk(part)):
        match node:
            case ast.AnnAssign(target=ast.Name(id=name), value=None, annotation=kind):
                # What begins as zero is to be changed.
                found[name] += 2 * is_zero_at_first(type_of_annotation(kind))
            case ast.AnnAssign(target=ast.Name(id=name)):
                found[name] += 1
            case ast.Assign(targets=[ast.Tuple(elts=parts)]):
                found.update(map(_root, parts))
            case ast.Assign(targets=[target]) | ast.AugAssign(target=target):
                found[_root(target)] += 1
            case ast.Expr(value=ast.Call(args=given)):
                found.update(map(_root, given))
    return found


def _root(node: ast.expr) -> str:
    while isinstance(node, ast.Subscript | ast.Attribute):
        node = node.value
    return node.id if isinstance(node, ast.Name) else ""
