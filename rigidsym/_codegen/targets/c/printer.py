"""Printer of routines as C99 code, by one table of the node classes of `ast`.

Structs and arrays are handed on by reference, numbers and double-doubles by value.  Several
results are written through pointers, as `pointers` says it.
"""

import ast
from collections.abc import Callable, Iterator, Mapping, Sequence
from textwrap import wrap
from typing import Any

from rigidsym._codegen.ir import Let
from rigidsym._codegen.lines import Lines, comment
from rigidsym._codegen.routines import (
    Enumeration,
    Field,
    Number,
    Program,
    Routine,
    Scope,
    Struct,
    Type,
    let_of,
)

TYPES = {
    **{"double": "double", "int": "int", "size": "size_t", "bits": "uint64_t", "bool": "int"},
    **{"pair": "double_double", "text": "const char *", "void": "void"},
}
CALLS = {
    **{"abs": "fabs", "exponent": "exponent_of", "prefetch": "PREFETCH", "hidden": "hidden"},
}
CASTS = {"double": "double", "int": "int", "size": "size_t", "bits": "uint64_t"}
COMPARISONS: dict[type, str] = {
    **{ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!="},
    **{ast.Is: "==", ast.IsNot: "!="},
}
OPERATIONS: dict[type, tuple[str, int]] = {
    **{ast.Mult: ("*", 10), ast.Div: ("/", 10), ast.FloorDiv: ("/", 10), ast.Mod: ("%", 10)},
    **{ast.Add: ("+", 9), ast.Sub: ("-", 9), ast.LShift: ("<<", 8), ast.RShift: (">>", 8)},
    **{ast.BitAnd: ("&", 5), ast.BitXor: ("^", 4), ast.BitOr: ("|", 3)},
}
_SIGNS: dict[type, str] = {ast.USub: "-", ast.Not: "!", ast.Invert: "~"}
_ATOM, _UNARY, _COMPARED, _AND, _OR, _CHOICE = 12, 11, 7, 2, 1, 0
_WIDTH = 100


class Printer:
    """Printer of a program's structs, numbers and routines in C.

    prefix: what the names of public functions and structs begin with.  names: what names that the
    program knows are called in C.
    """

    def __init__(self, program: Program, prefix: str, names: Mapping[str, str]) -> None:
        self.program, self.prefix = program, prefix
        self.names = {"inf": "HUGE_VAL", "nan": "((double)NAN)", **names}
        self._statements: dict[type, Callable[[Any], Iterator[Any]]] = {
            ast.AnnAssign: self._declaration,
            ast.Assign: self._assignment,
            ast.AugAssign: self._change,
            ast.Expr: self._call_alone,
            ast.If: self._if,
            ast.For: self._for,
            ast.Return: self._return,
            ast.Break: lambda _: iter(["break;"]),
            ast.Continue: lambda _: iter(["continue;"]),
            ast.Pass: lambda _: iter(()),
        }
        self._expressions: dict[type, Callable[[Any], tuple[str, int]]] = {
            ast.Constant: self._constant,
            ast.Name: self._name,
            ast.Attribute: self._attribute,
            ast.Subscript: self._subscript,
            ast.BinOp: self._operation,
            ast.UnaryOp: self._unary,
            ast.BoolOp: self._logical,
            ast.Compare: self._comparison,
            ast.IfExp: self._choice,
            ast.Call: self._call,
        }
        self.one = Routine("", "", {}, (), ())
        self.scope = Scope(self.one, program)
        self._set_again: set[str] = set()

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
        return self._wrapped(begin, parameters or ["void"], ")")

    @staticmethod
    def _wrapped(begin: str, parts: list[str], end: str) -> str:
        """Write a list over as many lines as it takes."""
        whole = f"{begin}{', '.join(parts)}{end}"
        if len(whole) <= _WIDTH:
            return whole
        rows = [begin]
        for k, part in enumerate(parts):
            piece = part + (end if k + 1 == len(parts) else ",")
            if rows[-1].endswith("(") or len(rows[-1]) + 1 + len(piece) <= _WIDTH:
                rows[-1] += piece if rows[-1].endswith("(") else f" {piece}"
            else:
                rows.append(f"    {piece}")
        return "\n".join(rows)

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
            shape = "".join(f"[{x}]" for x in number.type.shape)
            return f"static const char *const {number.name}{shape} = {value};{note}"
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

    @staticmethod
    def note(text: str) -> Iterator[str]:
        """Print a comment of any length."""
        words = " ".join(text.split())
        lines = wrap(f"/* {words} */", _WIDTH, subsequent_indent="   ", break_long_words=False)
        yield from lines

    def routine(self, one: Routine) -> Lines:
        """Print a routine, with the derived assignments behind its lines."""
        head = self.head(one)
        self.scope = Scope(one, self.program)
        self._set_again = _set_again(one, self.program)
        notes = [] if one.is_public else list(self.note(one.summary))
        text, lets = [*notes, *head.split("\n"), "{"], {}
        for line, let in self._block(one.body, "    "):
            if let is not None:
                lets[len(text)] = let
            text.append(line)
        return Lines((*text, "}", ""), lets)

    # --- statements

    def _block(self, body: Sequence[ast.stmt], indent: str) -> Iterator[tuple[str, Let | None]]:
        """Print statements, with the derived assignment behind each line."""
        for statement in body:
            self.scope.declare(statement)
            let = let_of(statement)
            if words := getattr(statement, "note", ""):
                yield from ((f"{indent}{line}", None) for line in self.note(words))
            if isinstance(statement, ast.If | ast.For):
                yield from self._compound(statement, indent)
                continue
            lines = list(self._statements[type(statement)](statement))
            for line in lines[:-1]:
                yield f"{indent}{line}", None
            if lines:
                note = f" /* {comment(let)} */" if let is not None else ""
                yield f"{indent}{lines[-1]}{note}", let

    def _compound(self, statement: ast.stmt, indent: str) -> Iterator[tuple[str, Let | None]]:
        for part in self._statements[type(statement)](statement):
            if isinstance(part, str):
                yield f"{indent}{part}", None
            else:
                outside = dict(self.scope.types)
                yield from self._block(part, f"{indent}    ")
                self.scope.types = outside

    def _declaration(self, node: ast.AnnAssign) -> Iterator[str]:
        name = ast.unparse(node.target)
        type_ = self.scope.types[name]
        declared = self.declared(name, type_)
        if node.value is None:
            yield f"{declared};"
            return
        is_kept = name in self._set_again or type_.shape or declared.startswith("const ")
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

    def _change(self, node: ast.AugAssign) -> Iterator[str]:
        symbol = OPERATIONS[type(node.op)][0]
        yield f"{self.text(node.target)} {symbol}= {self.text(node.value)};"

    def _call_alone(self, node: ast.Expr) -> Iterator[str]:
        match node.value:
            case ast.Call(func=ast.Name(id="cleared"), args=[struct]):
                place = self.argument(struct, self.scope.of(struct))
                yield f"memset({place}, 0, sizeof({self.type_name(self.scope.of(struct).name)}));"
            case ast.Call() as call:
                yield f"{self._called(call)};"

    def _if(self, node: ast.If) -> Iterator[str | list[ast.stmt]]:
        yield f"if ({self.text(node.test)}) {{"
        yield node.body
        rest = node.orelse
        while len(rest) == 1 and isinstance(rest[0], ast.If):
            yield f"}} else if ({self.text(rest[0].test)}) {{"
            yield rest[0].body
            rest = rest[0].orelse
        if rest:
            yield "} else {"
            yield rest
        yield "}"

    def _for(self, node: ast.For) -> Iterator[str | list[ast.stmt]]:
        name = ast.unparse(node.target)
        begin, end, step = _range(node)
        by = f"{name}++" if step is None else f"{name} += {self.text(step)}"
        first = "0" if begin is None else self.text(begin)
        yield f"for (size_t {name} = {first}; {name} < {self.text(end, _COMPARED + 1)}; {by}) {{"
        yield node.body
        yield "}"

    def _return(self, node: ast.Return) -> Iterator[str]:
        yield "return;" if node.value is None else f"return {self.text(node.value)};"

    # --- expressions

    def text(self, node: ast.expr, least: int = 0) -> str:
        """Print an expression, in brackets where it binds less than `least`."""
        found, bound = self._expressions[type(node)](node)
        return found if bound >= least else f"({found})"

    def argument(self, node: ast.expr, type_: Type) -> str:
        """Print an argument for a parameter of some type."""
        match node:
            case ast.Constant(value=None):
                return "NULL"
        if (type_.is_struct or type_.is_result) and not self._is_pointer(node):
            return f"&{self.text(node, _UNARY)}"
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

    def _constant(self, node: ast.Constant) -> tuple[str, int]:
        value = node.value
        if isinstance(value, bool):
            return str(int(value)), _ATOM
        if isinstance(value, str):
            return '"' + value.replace('"', '\\"') + '"', _ATOM
        if isinstance(value, int | float):
            return self.literal(value), _ATOM if value >= 0 else _UNARY
        return "NULL", _ATOM

    @staticmethod
    def literal(value: float) -> str:
        """Print a number."""
        is_whole = isinstance(value, float) and value.is_integer() and abs(value) < 1e17
        return f"{int(value)}.0" if is_whole else repr(value)

    def _name(self, node: ast.Name) -> tuple[str, int]:
        return self.names.get(node.id, node.id), _ATOM

    def _attribute(self, node: ast.Attribute) -> tuple[str, int]:
        arrow = "->" if self._is_pointer(node.value) else "."
        return f"{self.text(node.value, _ATOM)}{arrow}{node.attr}", _ATOM

    def _subscript(self, node: ast.Subscript) -> tuple[str, int]:
        match node.slice:
            case ast.Slice(lower=lower):
                if lower is None:
                    return self._expressions[type(node.value)](node.value)
                return f"{self.text(node.value, 9)} + {self.text(lower, 10)}", 9
            case ast.Tuple(elts=parts):
                places = "".join(f"[{self.text(part)}]" for part in parts)
            case part:
                places = f"[{self.text(part)}]"
        return f"{self.text(node.value, _ATOM)}{places}", _ATOM

    def _operation(self, node: ast.BinOp) -> tuple[str, int]:
        symbol, bound = OPERATIONS[type(node.op)]
        of_bits = bound < 9
        # Compilers, and readers, ask for brackets around what stands among operations on bits.
        left = self._operand(node.left, node.right, _UNARY if of_bits else bound)
        shift = isinstance(node.op, ast.LShift | ast.RShift)
        if shift:
            right = self.text(node.right, _UNARY)
        else:
            right = self._operand(node.right, node.left, _UNARY if of_bits else bound + 1)
        return f"{left} {symbol} {right}", bound

    def _operand(self, node: ast.expr, other: ast.expr, least: int) -> str:
        match node:
            case ast.Constant(value=int(value)) if self.scope.of(other).name == "bits":
                return f"UINT64_C({value:#x})"
        return self.text(node, least)

    def _unary(self, node: ast.UnaryOp) -> tuple[str, int]:
        symbol = _SIGNS[type(node.op)]
        text = self.text(node.operand, _UNARY)
        return f"{symbol}({text})" if text.startswith(symbol) else f"{symbol}{text}", _UNARY

    def _logical(self, node: ast.BoolOp) -> tuple[str, int]:
        symbol, bound = ("&&", _AND) if isinstance(node.op, ast.And) else ("||", _OR)
        return f" {symbol} ".join(self.text(part, _AND + 1) for part in node.values), bound

    def _comparison(self, node: ast.Compare) -> tuple[str, int]:
        (right,), (operator,) = node.comparators, node.ops
        return (
            f"{self.text(node.left, _COMPARED + 1)} {COMPARISONS[type(operator)]}"
            f" {self.text(right, _COMPARED + 1)}",
            _COMPARED,
        )

    def _choice(self, node: ast.IfExp) -> tuple[str, int]:
        test, one = self.text(node.test, _CHOICE + 1), self.text(node.body, _CHOICE + 1)
        return f"{test} ? {one} : {self.text(node.orelse, _CHOICE + 1)}", _CHOICE

    def _call(self, node: ast.Call) -> tuple[str, int]:
        match node:
            case ast.Call(func=ast.Name(id=cast), args=[value]) if cast in CASTS:
                return f"({CASTS[cast]}){self.text(value, _UNARY)}", _UNARY
            case ast.Call(func=ast.Name(id="sizeof"), args=[ast.Name(id=struct)]):
                return f"sizeof({self.type_name(struct)})", _ATOM
        return self._called(node), _ATOM

    def _called(self, node: ast.Call) -> str:
        if not isinstance(node.func, ast.Name):
            given = [self.argument(one, self.scope.of(one)) for one in node.args]
            return f"{self.text(node.func)}({', '.join(given)})"
        name = node.func.id
        if name in self.program.routines:
            types = self.program.routines[name].parameters.values()
            given = [self.argument(*both) for both in zip(node.args, types, strict=True)]
            return f"{self.function_name(name)}({', '.join(given)})"
        given = [self.text(one) for one in node.args]
        return f"{CALLS.get(name, name)}({', '.join(given)})"


def _range(node: ast.For) -> tuple[ast.expr | None, ast.expr, ast.expr | None]:
    """Return begin, end and step of a loop; begin and step are None where they are not given."""
    match node.iter:
        case ast.Call(func=ast.Name(id="range"), args=[end]):
            return None, end, None
        case ast.Call(func=ast.Name(id="range"), args=[begin, end]):
            return begin, end, None
        case ast.Call(func=ast.Name(id="range"), args=[begin, end, step]):
            return begin, end, step
    raise ValueError(f"{ast.unparse(node.iter)}: a loop is over a range")


def _set_again(one: Routine, program: Program) -> set[str]:
    """Return the names that are set after their declaration."""
    targets: list[ast.expr] = []
    for node in (node for part in one.body for node in ast.walk(part)):
        match node:
            case ast.Assign(targets=[target]) | ast.AugAssign(target=target):
                targets.append(target)
            case ast.Call(func=ast.Name(id=name), args=given) if name in program.routines:
                types = program.routines[name].parameters.values()
                targets += (x for x, type_ in zip(given, types, strict=True) if type_.is_result)
    found: set[str] = set()
    for target in targets:
        while isinstance(target, ast.Subscript | ast.Attribute):
            target = target.value
        found |= {target.id} if isinstance(target, ast.Name) else set()
    return found
