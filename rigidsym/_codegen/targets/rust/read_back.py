"""Check of the printed Rust: it is read back, and compared with its routines."""

import ast
import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache

import tree_sitter
import tree_sitter_rust
from tree_sitter import Node

from rigidsym._codegen import header
from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.printer import COMPARISONS, OPERATIONS
from rigidsym._codegen.routines import Routine, annotation, copied
from rigidsym._codegen.seal.bodies import Body, check_function, check_outside
from rigidsym._codegen.targets.rust import module
from rigidsym._codegen.targets.rust.declared import LET
from rigidsym._codegen.targets.rust.printer import CALLS, NAMES, TYPES, type_name, zero
from rigidsym.errors import InputError

_NAMES = {text: name for name, text in {**NAMES, **CALLS}.items()}
_TYPES = {text: name for name, text in TYPES.items()}
_COMPARED = {text: kind for kind, text in COMPARISONS.items() if kind not in (ast.Is, ast.IsNot)}
_OPERATED = {text: kind for kind, (text, _) in OPERATIONS.items() if kind is not ast.FloorDiv}
_LOGICAL: dict[str, type[ast.boolop]] = {"&&": ast.And, "||": ast.Or}
_COMMENTS = ("block_comment", "line_comment")


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """Check the printed files against their routines, and return the number of derived lines.

    Raises InputError for a statement that differs, and for other text that does.
    """
    wanted, of = module.build(functions, constants, form), key("rust", form)
    if files.keys() != wanted.files.keys():
        raise InputError("files", ", ".join(files), f"are not {', '.join(wanted.files)}")
    routines, source = module.program(functions, constants, form).routines, module.source(form)
    digest, decided = header.digest_in(source, files[source]), 0
    texts = {name: header.unsealed(text, of, digest) for name, text in files.items()}
    for name, text in texts.items():
        other, own = header.unsealed(wanted.files[name], of, wanted.digest), {}
        if name == source:
            own = routines
        check_outside(name, _outside(name, text, own), _outside(name, other, own))
    for name, node in _bodies(source, texts[source], routines):
        body = Body(source, texts[source].split("\n"), routines[name], _plain)
        decided += body.check(list(_Reader(source).block(node)), routines[name].body)
    for function in functions:
        check_function(function, [one for one in routines.values() if one.prints(function)])
    return decided


def _plain(node: ast.AST) -> ast.AST:
    """Return a tree as Rust says it."""
    return _Plain().visit(copied(node))


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
                return _call("pair", *parts)
        return node


@cache
def _parser() -> tree_sitter.Parser:
    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_rust.language()))


def _bodies(file: str, text: str, names: Mapping[str, Routine]) -> Iterator[tuple[str, Node]]:
    """Yield the names and bodies of the functions that print routines."""
    for node in _parser().parse(text.encode()).root_node.named_children:
        name = _text(node.child_by_field_name("name"))
        if node.type == "function_item" and name in names:
            if node.has_error:
                raise InputError(f"{file}:{node.start_point.row + 1}", name, "is no Rust")
            yield name, _child(node, "body")


def _outside(file: str, text: str, names: Mapping[str, Routine]) -> Iterator[tuple[int, str]]:
    """Yield the lines outside the bodies of routines, with their numbers."""
    inside = {
        number
        for _, body in (_bodies(file, text, names) if names else ())
        for number in range(body.start_point.row + 2, body.end_point.row + 2)
    }
    lines = enumerate(text.split("\n"), 1)
    yield from ((number, line) for number, line in lines if number not in inside)


def _text(node: Node | None) -> str:
    return node.text.decode() if node is not None and node.text is not None else ""


def _child(node: Node, name: str) -> Node:
    found = node.child_by_field_name(name)
    if found is None:
        raise InputError("Rust", _text(node)[:60], f"has no {name}")
    return found


def _parts(node: Node) -> list[Node]:
    """Return the named children of a node without its comments."""
    return [child for child in node.named_children if child.type not in _COMMENTS]


def _call(name: str, *given: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(given), [])


class _Reader:
    """Reader of the bodies of functions; what is not in its tables is refused."""

    def __init__(self, file: str) -> None:
        self.file = file
        self._statements: dict[str, Callable[[Node], ast.stmt]] = {
            "let_declaration": self._declaration,
            "assignment_expression": self._assignment,
            "compound_assignment_expr": self._change,
            "call_expression": lambda node: ast.Expr(self.read(node)),
            "if_expression": self._if,
            "for_expression": self._for,
            "return_expression": lambda node: ast.Return(*map(self.read, _parts(node))),
            "break_expression": lambda _: ast.Break(),
            "continue_expression": lambda _: ast.Continue(),
        }
        self._expressions: dict[str, Callable[[Node], ast.expr]] = {
            **dict.fromkeys(("identifier", "scoped_identifier"), self._name),
            "boolean_literal": lambda node: ast.Constant(_text(node) == "true"),
            "integer_literal": lambda node: ast.Constant(int(_text(node), 0)),
            "float_literal": lambda node: ast.Constant(float(_text(node))),
            "string_literal": lambda node: ast.Constant(ast.literal_eval(_text(node))),
            "field_expression": self._member,
            "index_expression": self._element,
            "binary_expression": self._operation,
            "unary_expression": self._unary,
            "reference_expression": self._reference,
            "parenthesized_expression": lambda node: self.read(*_parts(node)),
            "if_expression": self._choice,
            "type_cast_expression": lambda node: _call(
                self._type(_child(node, "type")), self.read(_child(node, "value"))
            ),
            "call_expression": self._call,
            "tuple_expression": self._several,
            "tuple_pattern": self._several,
            "mut_pattern": lambda node: self.read(_parts(node)[-1]),
        }

    def _refuse(self, node: Node) -> InputError:
        place = f"{self.file}:{node.start_point.row + 1}"
        return InputError(place, _text(node)[:80], f"is nothing that a routine has ({node.type})")

    def block(self, node: Node) -> Iterator[ast.stmt]:
        """Read the statements of a block; each knows its line."""
        for child in _parts(node):
            inner = _parts(child)[0] if child.type == "expression_statement" else child
            if node.type != "block" or inner.type not in self._statements:
                raise self._refuse(child)
            statement = self._statements[inner.type](inner)
            statement.lineno = child.start_point.row + 1
            yield statement

    def read(self, node: Node) -> ast.expr:
        """Read an expression."""
        if node.type not in self._expressions:
            raise self._refuse(node)
        return self._expressions[node.type](node)

    # --- statements

    def _declaration(self, node: Node) -> ast.stmt:
        pattern, kind = _child(node, "pattern"), node.child_by_field_name("type")
        value = node.child_by_field_name("value")
        if pattern.type == "tuple_pattern" and value is not None and kind is None:
            targets = self._several(pattern)
            return ast.Assign([targets], self.read(value), type_comment=LET, lineno=1)
        if pattern.type != "identifier" or kind is None:
            raise self._refuse(node)
        is_zero = kind.type in ("array_type", "type_identifier") and _text(value) == zero(
            _text(kind)
        )
        read = None if value is None or is_zero else self.read(value)
        target, type_ = ast.Name(_text(pattern), ast.Store()), annotation(self._type(kind))
        return ast.AnnAssign(target, type_, read, simple=1)

    def _type(self, node: Node) -> str:
        """Return the annotation of a type."""
        if node.type == "array_type":
            inner, length = self._type(_child(node, "element")), _text(_child(node, "length"))
            name, _, more = inner.rstrip("]").partition("[")
            return f"{name}[{', '.join(filter(None, (length, more)))}]"
        text = _text(node)
        name = re.sub(r"(?<=.)([A-Z])", r"_\1", text).lower()
        if text not in _TYPES and type_name(name) != text:
            raise self._refuse(node)
        return _TYPES.get(text, name)

    def _assignment(self, node: Node) -> ast.stmt:
        target, value = self.read(_child(node, "left")), _child(node, "right")
        if value.type == "scoped_identifier" and _text(value).endswith("::ZERO"):
            return ast.Expr(_call("cleared", target))
        return ast.Assign([target], self.read(value), lineno=1)

    def _change(self, node: Node) -> ast.stmt:
        target, symbol = self.read(_child(node, "left")), _text(_child(node, "operator"))
        kind = _OPERATED.get(symbol.removesuffix("="))
        if kind is None or not isinstance(target, ast.Name | ast.Attribute | ast.Subscript):
            raise self._refuse(node)
        return ast.AugAssign(target, kind(), self.read(_child(node, "right")))

    def _if(self, node: Node) -> ast.stmt:
        test = self.read(_child(node, "condition"))
        then, rest = list(self.block(_child(node, "consequence"))), []
        if other := node.child_by_field_name("alternative"):
            (inner,) = _parts(other)
            if inner.type == "if_expression":
                rest = [self._if(inner)]
                rest[0].lineno = inner.start_point.row + 1
            else:
                rest = list(self.block(inner))
        return ast.If(test, then, rest)

    def _for(self, node: Node) -> ast.stmt:
        values = _child(node, "value")
        ends = [self.read(x) for x in _parts(values)]
        if values.type != "range_expression" or len(ends) != 2 or "..=" in _text(values):
            raise self._refuse(values)
        given = ends[1:] if ast.unparse(ends[0]) == "0" else ends
        name = ast.Name(_text(_child(node, "pattern")), ast.Store())
        body = list(self.block(_child(node, "body")))
        return ast.For(name, _call("range", *given), body, [], lineno=1)

    # --- expressions

    def _several(self, node: Node) -> ast.expr:
        return ast.Tuple([*map(self.read, _parts(node))], ast.Load())

    def _name(self, node: Node) -> ast.expr:
        text = _text(node)
        if node.type == "scoped_identifier" and text not in _NAMES:
            raise self._refuse(node)
        return ast.Name(_NAMES.get(text, text), ast.Load())

    def _member(self, node: Node) -> ast.expr:
        return ast.Attribute(
            self.read(_child(node, "value")), _text(_child(node, "field")), ast.Load()
        )

    def _element(self, node: Node) -> ast.expr:
        array, place = _parts(node)
        read = self.read(array)
        if place.type == "range_expression":
            (first,) = _parts(place)
            if _text(place) != f"{_text(first)}..":
                raise self._refuse(place)
            return ast.Subscript(read, ast.Slice(self.read(first), None, None), ast.Load())
        found = _Plain().visit(ast.Subscript(read, self.read(place), ast.Load()))
        match read:
            case ast.Subscript(value=whole, slice=one):
                return ast.Subscript(whole, ast.Tuple([one, found.slice], ast.Load()), ast.Load())
        return found

    def _unary(self, node: Node) -> ast.expr:
        symbol, read = node.children[0].type, self.read(*_parts(node))
        match symbol, read:
            case "*", ast.Name() | ast.Subscript():
                return read
            case "!", ast.Compare(left=left, ops=[ast.Is()], comparators=[none]):
                return ast.Compare(left, [ast.IsNot()], [none])
            case "!", _:
                return ast.UnaryOp(ast.Not(), read)
            case "-", _:
                return ast.UnaryOp(ast.USub(), read)
        raise self._refuse(node)

    def _reference(self, node: Node) -> ast.expr:
        value = _child(node, "value")
        if value.type == "array_expression" and not _parts(value):
            return ast.Constant(None)
        return self.read(value)

    def _operation(self, node: Node) -> ast.expr:
        left, right = _child(node, "left"), _child(node, "right")
        symbol, one, other = _text(_child(node, "operator")), self.read(left), self.read(right)
        if symbol in _LOGICAL:
            kind = _LOGICAL[symbol]
            match one:
                case ast.BoolOp(op=op, values=values) if type(op) is kind and (
                    left.type == "binary_expression"
                ):
                    return ast.BoolOp(op, [*values, other])
            return ast.BoolOp(kind(), [one, other])
        if symbol in _COMPARED:
            return ast.Compare(one, [_COMPARED[symbol]()], [other])
        if symbol not in _OPERATED:
            raise self._refuse(node)
        return ast.BinOp(one, _OPERATED[symbol](), other)

    def _choice(self, node: Node) -> ast.expr:
        test = self.read(_child(node, "condition"))
        (block,) = _parts(_child(node, "alternative"))
        return ast.IfExp(test, self._value(_child(node, "consequence")), self._value(block))

    def _value(self, block: Node) -> ast.expr:
        """Read the value of a block, or a choice that is another's value."""
        if block.type == "if_expression":
            return self._choice(block)
        (one,) = _parts(block)
        is_choice = one.type == "expression_statement" and not _text(one).endswith(";")
        return self.read(_parts(one)[0] if is_choice else one)

    def _call(self, node: Node) -> ast.expr:
        function, given = _child(node, "function"), _parts(_child(node, "arguments"))
        read = [self.read(x) for x in given]
        if function.type == "field_expression":
            value, method = self.read(_child(function, "value")), _text(_child(function, "field"))
            if method == "is_empty" and not read:
                return ast.Compare(value, [ast.Is()], [ast.Constant(None)])
            if method == "wrapping_mul":
                return ast.BinOp(value, ast.Mult(), *read)
            raise self._refuse(node)
        if _text(function) in ("fixed", "fixed_mut"):
            return read[0]
        return ast.Call(self.read(function), read, [])
