"""Check of the printed Rust: it is read back, and compared with its routines."""

import ast
import re
from collections.abc import Iterator, Mapping

import tree_sitter_rust
from tree_sitter import Node

from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.routines import Program, Type, annotation, copied
from rigidsym._codegen.seal.trees import (
    Definition,
    Reader,
    call,
    check_files,
    child,
    parts,
    text_of,
)
from rigidsym._codegen.targets.rust import module
from rigidsym._codegen.targets.rust.declared import LET
from rigidsym._codegen.targets.rust.printer import CALLS, NAMES, TYPES, structs, type_name, zero

_NAMES = {text: name for name, text in {**NAMES, **CALLS}.items()}
_TYPES = {text: name for name, text in TYPES.items()}


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """Check the printed files against their routines, and return the number of derived lines.

    Raises InputError for a statement that differs, and for other text that does.
    """
    wanted = module.build(functions, constants, form)
    made = module.program(functions, constants, form)
    given = functions, constants
    return check_files(files, wanted, key("rust", form), made, given, RustReader)


class _Plain(ast.NodeTransformer):
    """What Rust says in another way: places in arrays are sizes."""

    def visit_Subscript(self, node: ast.Subscript) -> ast.expr:
        """Drop the conversion of a place to a size."""
        self.generic_visit(node)
        match node.slice:
            case ast.Call(func=ast.Name(id="size"), args=[place]):
                return ast.Subscript(node.value, place, node.ctx)
        return node

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Call pairs by one name."""
        self.generic_visit(node)
        match node:
            case ast.Call(func=ast.Name(id="dd_pair"), args=parts):
                return call("pair", *parts)
        return node


def _said(type_: Type) -> str:
    """Return the annotation of a type."""
    return f"{type_.name}[{', '.join(type_.shape)}]" if type_.shape else type_.name


def _mark(type_: Type) -> str:
    """Return how an argument of a type is handed on: by value, or by reference."""
    return "&mut " if type_.is_out else "&" if type_.is_struct or type_.shape else ""


class RustReader(Reader):
    """Reader of Rust."""

    language, grammar = "Rust", tree_sitter_rust.language
    function, words = "function_item", module.WORDS

    def __init__(self, file: str) -> None:
        super().__init__(file)
        self.statements |= {
            "let_declaration": self._declaration,
            "assignment_expression": self.assignment,
            "compound_assignment_expr": self.change,
            "call_expression": lambda node: ast.Expr(self.read(node)),
            "if_expression": self.choice_of_blocks,
            "for_expression": self._for,
            "return_expression": lambda node: ast.Return(*map(self.read, parts(node))),
            "break_expression": lambda _: ast.Break(),
            "continue_expression": lambda _: ast.Continue(),
        }
        self.expressions |= {
            **dict.fromkeys(("identifier", "scoped_identifier"), self._name),
            "boolean_literal": lambda node: ast.Constant(text_of(node) == "true"),
            "integer_literal": lambda node: ast.Constant(int(text_of(node), 0)),
            "float_literal": lambda node: ast.Constant(float(text_of(node))),
            "string_literal": lambda node: ast.Constant(ast.literal_eval(text_of(node))),
            "field_expression": lambda node: ast.Attribute(
                self.read(child(node, "value")), text_of(child(node, "field")), ast.Load()
            ),
            "index_expression": self._element,
            "unary_expression": self._unary,
            "reference_expression": self._reference,
            "array_expression": lambda node: ast.List([*map(self.read, parts(node))], ast.Load()),
            "if_expression": self._choice,
            "type_cast_expression": lambda node: call(
                self._type(child(node, "type")), self.read(child(node, "value"))
            ),
            "call_expression": self._call,
            **dict.fromkeys(("tuple_expression", "tuple_pattern"), self.several),
            "mut_pattern": lambda node: self.read(parts(node)[-1]),
        }

    def plain(self, node: ast.AST) -> ast.AST:
        """Return a tree in which places and pairs are as Rust says them."""
        return _Plain().visit(copied(node))

    # --- definitions

    def wanted(self, made: Program) -> Iterator[tuple[str, Definition]]:
        """Yield what functions, structs and numbers are: types, with names or values."""
        for one in made.enumerations.values():
            yield from ((x.name, ("int", x.value)) for x in one.numbers)
        yield from ((x.name, (_said(x.type), x.value)) for x in made.numbers.values())
        for struct in made.structs.values():
            for one in structs(struct):
                members = (f"{x.name}: {_said(x.type)}" for x in one.fields)
                yield type_name(one.name), ("pub" if one.is_public else "pub(crate)", *members)
        for one in made.routines.values():
            parameters = (f"{name}: {_mark(x)}{_said(x)}" for name, x in one.parameters.items())
            yield one.name, ("pub(crate)", *parameters, "->", *map(_said, one.results))

    def defined(self, node: Node, name: str) -> Definition:
        """Read a value, the members of a struct, or the parameters of a function."""
        mark = "".join(text_of(x) for x in parts(node) if x.type == "visibility_modifier")
        if node.type == "const_item" and not mark:
            return self._type(child(node, "type")), self.read(child(node, "value"))
        if node.type == "struct_item":
            return mark, *(self._typed(x, "name") for x in parts(child(node, "body")))
        if node.type != self.function:
            raise self.refusal(node)
        parameters = [self._typed(x, "pattern") for x in parts(child(node, "parameters"))]
        result = node.child_by_field_name("return_type")
        several = parts(result) if result and result.type == "tuple_type" else [result]
        return mark, *parameters, "->", *(self._type(x) for x in several if x)

    def _typed(self, node: Node, name: str) -> str:
        """Return the name of a parameter or a member with its type."""
        kind, mark = child(node, "type"), ""
        if kind.type == "reference_type" and text_of(kind) not in _TYPES:
            inner = child(kind, "type")
            kind, mark = inner, text_of(kind).removesuffix(text_of(inner))
        return f"{text_of(child(node, name))}: {mark}{self._type(kind)}"

    # --- statements

    def _declaration(self, node: Node) -> ast.stmt:
        pattern, kind = child(node, "pattern"), node.child_by_field_name("type")
        value = node.child_by_field_name("value")
        if pattern.type == "tuple_pattern" and value is not None and kind is None:
            targets = self.several(pattern)
            return ast.Assign([targets], self.read(value), type_comment=LET, lineno=1)
        if pattern.type != "identifier" or kind is None:
            raise self.refusal(node)
        is_zero = kind.type in ("array_type", "type_identifier") and text_of(value) == zero(
            text_of(kind)
        )
        read = None if value is None or is_zero else self.read(value)
        target, type_ = ast.Name(text_of(pattern), ast.Store()), annotation(self._type(kind))
        return ast.AnnAssign(target, type_, read, simple=1)

    def _type(self, node: Node) -> str:
        """Return the annotation of a type."""
        if node.type == "array_type":
            inner = self._type(child(node, "element"))
            length = text_of(node.child_by_field_name("length")).removesuffix(" as usize")
            name, _, more = inner.rstrip("]").partition("[")
            return f"{name}[{', '.join(filter(None, (length or '...', more)))}]"
        text = text_of(node)
        name = re.sub(r"(?<=.)([A-Z])", r"_\1", text).lower()
        if text not in _TYPES and type_name(name) != text:
            raise self.refusal(node)
        return _TYPES.get(text, name)

    def assignment(self, node: Node) -> ast.stmt:
        """Read an assignment; that of zero to a struct clears it."""
        value = child(node, "right")
        if value.type == "scoped_identifier" and text_of(value).endswith("::ZERO"):
            return ast.Expr(call("cleared", self.read(child(node, "left"))))
        return super().assignment(node)

    def _for(self, node: Node) -> ast.stmt:
        values = child(node, "value")
        ends = [self.read(x) for x in parts(values)]
        if values.type != "range_expression" or len(ends) != 2 or "..=" in text_of(values):
            raise self.refusal(values)
        given = ends[1:] if ast.unparse(ends[0]) == "0" else ends
        name = ast.Name(text_of(child(node, "pattern")), ast.Store())
        body = list(self.block(child(node, "body")))
        return ast.For(name, call("range", *given), body, [], lineno=1)

    # --- expressions

    def _name(self, node: Node) -> ast.expr:
        text = text_of(node)
        if node.type == "scoped_identifier" and text not in _NAMES:
            raise self.refusal(node)
        return ast.Name(_NAMES.get(text, text), ast.Load())

    def _element(self, node: Node) -> ast.expr:
        array, place = parts(node)
        read = self.read(array)
        if place.type == "range_expression":
            (first,) = parts(place)
            if text_of(place) != f"{text_of(first)}..":
                raise self.refusal(place)
            return ast.Subscript(read, ast.Slice(self.read(first), None, None), ast.Load())
        found = _Plain().visit(ast.Subscript(read, self.read(place), ast.Load()))
        match read:
            case ast.Subscript(value=whole, slice=one):
                return ast.Subscript(whole, ast.Tuple([one, found.slice], ast.Load()), ast.Load())
        return found

    def _unary(self, node: Node) -> ast.expr:
        symbol, read = node.children[0].type, self.read(*parts(node))
        match symbol, read:
            case "*", ast.Name() | ast.Subscript():
                return read
            case "!", ast.Compare(left=left, ops=[ast.Is()], comparators=[none]):
                return ast.Compare(left, [ast.IsNot()], [none])
            case "!", _:
                return ast.UnaryOp(ast.Not(), read)
            case "-", _:
                return ast.UnaryOp(ast.USub(), read)
        raise self.refusal(node)

    def _reference(self, node: Node) -> ast.expr:
        value = child(node, "value")
        if value.type == "array_expression" and not parts(value):
            return ast.Constant(None)
        return self.read(value)

    def _choice(self, node: Node) -> ast.expr:
        test = self.read(child(node, "condition"))
        (block,) = parts(child(node, "alternative"))
        return ast.IfExp(test, self._value(child(node, "consequence")), self._value(block))

    def _value(self, block: Node) -> ast.expr:
        """Read the value of a block, or a choice that is another's value."""
        if block.type == "if_expression":
            return self._choice(block)
        (one,) = parts(block)
        is_choice = one.type == "expression_statement" and not text_of(one).endswith(";")
        return self.read(parts(one)[0] if is_choice else one)

    def _call(self, node: Node) -> ast.expr:
        function, given = child(node, "function"), parts(child(node, "arguments"))
        read = [self.read(x) for x in given]
        if function.type == "field_expression":
            value, method = self.read(child(function, "value")), text_of(child(function, "field"))
            if method == "is_empty" and not read:
                return ast.Compare(value, [ast.Is()], [ast.Constant(None)])
            if method == "wrapping_mul":
                return ast.BinOp(value, ast.Mult(), *read)
            raise self.refusal(node)
        if text_of(function) in ("fixed", "fixed_mut"):
            return read[0]
        return ast.Call(self.read(function), read, [])
