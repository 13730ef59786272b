"""Reading of C functions back as syntax trees of routines.

The text is parsed by tree-sitter.  One table says what each node of C's grammar is in a routine;
what is not in it is refused.
"""

import ast
from collections.abc import Callable, Collection, Iterator
from functools import cache

import tree_sitter
import tree_sitter_c
from tree_sitter import Node

from rigidsym._codegen.printer import COMPARISONS, OPERATIONS
from rigidsym._codegen.routines import Routine, Scope, Type, annotation
from rigidsym._codegen.targets.c.printer import CALLS, CASTS, TYPES, Printer
from rigidsym.errors import InputError

_COMPARED = {text: kind for kind, text in COMPARISONS.items() if kind not in (ast.Is, ast.IsNot)}
_OPERATED = {text: kind for kind, (text, _) in OPERATIONS.items() if kind is not ast.FloorDiv}
_CALLED = {text: name for name, text in CALLS.items()}
_CAST = {text: name for name, text in CASTS.items()}
_KINDS = {text: name for name, text in TYPES.items() if name != "bool"}
_SIGNS: dict[str, type[ast.unaryop]] = {"-": ast.USub, "!": ast.Not, "~": ast.Invert}


@cache
def _parser() -> tree_sitter.Parser:
    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_c.language()))


def parsed(text: str) -> Node:
    """Parse a C text; lines keep their numbers, without the macros before a function's type."""
    for macro in ("INLINED", "FLAT"):
        text = text.replace(f" {macro} ", " " * (len(macro) + 2))
    return _parser().parse(text.encode()).root_node


def functions(file: str, root: Node) -> Iterator[tuple[str, Node]]:
    """Yield the name and the node of each function that a C text defines.

    Raises InputError where the text is no C.
    """
    for node in _all(root, "function_definition"):
        if node.has_error:
            raise InputError(f"{file}:{node.start_point.row + 1}", _text(node)[:60], "is no C")
        declarator = node.child_by_field_name("declarator")
        while declarator is not None and declarator.type != "identifier":
            declarator = declarator.child_by_field_name("declarator")
        if declarator is not None:
            yield _text(declarator), node


def without_bodies(file: str, text: str, names: Collection[str]) -> list[tuple[int, str]]:
    """Return the lines of a C text outside the bodies of some functions, with their numbers.

    The lines with the brackets of a body are outside.
    """
    lines = dict(enumerate(text.split("\n"), 1))
    for name, node in functions(file, parsed(text)):
        body = node.child_by_field_name("body")
        if name in names and body is not None:
            for number in range(body.start_point.row + 2, body.end_point.row + 1):
                del lines[number]
    return list(lines.items())


def comments(node: Node) -> list[str]:
    """Return the comments within a node, in their order."""
    own = [_text(node)] if node.type == "comment" else []
    return [*own, *(text for child in node.children for text in comments(child))]


def numbers(root: Node) -> dict[str, str]:
    """Return the value of each named number, as text with single spaces."""
    found = {}
    for node in _all(root, "declaration"):
        for place in node.children_by_field_name("declarator"):
            if place.type == "init_declarator":
                name = _child(place, "declarator")
                while name.type != "identifier":
                    name = next(x for x in name.named_children if x.type != "type_qualifier")
                found[_text(name)] = " ".join(_text(_child(place, "value")).split())
    for node in _all(root, "enum_specifier"):
        for place in _child(node, "body").named_children:
            if place.type == "enumerator" and (value := place.child_by_field_name("value")):
                found[_text(_child(place, "name"))] = " ".join(_text(value).split())
    return found


def structs(root: Node) -> dict[str, list[tuple[str, str]]]:
    """Return the members of each struct: type and declarator."""
    found = {}
    for node in _all(root, "type_definition"):
        body = _child(node, "type").child_by_field_name("body")
        fields = body.named_children if body is not None else []
        found[_text(_child(node, "declarator"))] = [
            (_text(_child(field, "type")), _text(_child(field, "declarator")))
            for field in fields
            if field.type == "field_declaration"
        ]
    return found


def head(node: Node) -> tuple[str, list[str]]:
    """Return the type of a function's value, and its parameters, each with single spaces."""
    declarator, kind = _child(node, "declarator"), _text(_child(node, "type"))
    while declarator.type == "pointer_declarator":
        declarator, kind = _child(declarator, "declarator"), f"{kind} *"
    given = _child(declarator, "parameters").named_children
    words = (" ".join(_text(x).split()) for x in given if x.type != "comment")
    return kind, [word for word in words if word != "void"]


def _all(node: Node, kind: str) -> Iterator[Node]:
    """Yield the nodes of a kind outside of functions."""
    for child in node.children:
        if child.type == kind:
            yield child
        elif child.type in (
            "linkage_specification",
            "declaration_list",
            "preproc_ifdef",
            "preproc_if",
        ):
            yield from _all(child, kind)


def _text(node: Node | None) -> str:
    return node.text.decode() if node is not None and node.text is not None else ""


class Reader:
    """Reader of the body of one C function.

    one: the routine that it is said to be, whose types names have.
    """

    def __init__(self, file: str, one: Routine, printer: Printer) -> None:
        self.file, self.scope, self.printer = file, Scope(one, printer.program), printer
        self.names = {printed: name for name, printed in printer.names.items()}
        self.functions = {printer.function_name(name): name for name in printer.program.routines}
        self.pointers = {
            name for name, x in one.parameters.items() if x.is_struct or x.is_result or x.shape
        }
        self.kinds = {printer.type_name(name): name for name in printer.program.structs} | _KINDS
        self._statements: dict[str, Callable[[Node], ast.stmt]] = {
            "declaration": self._declaration,
            "expression_statement": self._alone,
            "if_statement": self._if,
            "for_statement": self._for,
            "return_statement": self._return,
            "break_statement": lambda _: ast.Break(),
            "continue_statement": lambda _: ast.Continue(),
        }
        self._expressions: dict[str, Callable[[Node], ast.expr]] = {
            "identifier": self._name,
            "number_literal": self._number,
            "string_literal": lambda node: ast.Constant(_text(node)[1:-1].replace('\\"', '"')),
            "null": lambda _: ast.Constant(None),
            "field_expression": self._member,
            "subscript_expression": self._element,
            "binary_expression": self._operation,
            "unary_expression": self._unary,
            "pointer_expression": lambda node: self.read(_child(node, "argument")),
            "parenthesized_expression": lambda node: self.read(node.named_children[0]),
            "conditional_expression": self._choice,
            "cast_expression": self._cast,
            "call_expression": self._call,
            "sizeof_expression": self._sizeof,
            "initializer_list": lambda node: ast.List(
                [self.read(part) for part in node.named_children], ast.Load()
            ),
        }

    def _refuse(self, node: Node) -> InputError:
        place = f"{self.file}:{node.start_point.row + 1}"
        return InputError(place, _text(node)[:80], f"is nothing that a routine has ({node.type})")

    # --- statements

    def statements(self, function: Node) -> list[ast.stmt]:
        """Read the statements of a function.

        Raises InputError for what no routine has.
        """
        try:
            return self.block(_child(function, "body"))
        except (KeyError, IndexError, ValueError) as error:
            if isinstance(error, InputError):
                raise
            place = f"{self.file}:{function.start_point.row + 1}"
            raise InputError(place, _text(function)[:60], f"is not read: {error}") from None

    def block(self, node: Node) -> list[ast.stmt]:
        """Read the statements of a block; each knows its line."""
        found: list[ast.stmt] = []
        for child in node.named_children:
            if child.type == "comment":
                continue
            if child.type not in self._statements:
                raise self._refuse(child)
            statement = self._statements[child.type](child)
            statement.lineno = child.start_point.row + 1
            found.append(statement)
        return found

    def _inside(self, node: Node | None) -> list[ast.stmt]:
        if node is None or node.type != "compound_statement":
            raise InputError(self.file, _text(node)[:60], "is no block in brackets")
        outside = dict(self.scope.types)
        found = self.block(node)
        self.scope.types = outside
        return found

    def _declaration(self, node: Node) -> ast.stmt:
        kind = self.kinds.get(_text(node.child_by_field_name("type")), "")
        declarators = node.children_by_field_name("declarator")
        others = [x for x in node.named_children if x not in declarators][:-1]
        if len(declarators) != 1 or not kind or any(_text(x) != "const" for x in others):
            raise self._refuse(node)
        place, value = declarators[0], None
        if place.type == "init_declarator":
            value, place = _child(place, "value"), _child(place, "declarator")
        lengths: list[str] = []
        while place.type == "array_declarator":
            lengths.insert(0, ast.unparse(self.read(_child(place, "size"))))
            place = _child(place, "declarator")
        if place.type == "pointer_declarator":
            lengths, place = ["..."], _child(place, "declarator")
        name = _text(place)
        self.scope.types[name] = type_ = Type(kind, tuple(lengths))
        read = None
        if value is not None and value.type == "initializer_list" and type_.is_pair:
            read = _call("pair", *(self.read(part) for part in value.named_children))
        elif value is not None:
            read = self.read(value)
        shape = f"[{', '.join(lengths)}]" if lengths else ""
        return ast.AnnAssign(ast.Name(name, ast.Store()), annotation(f"{kind}{shape}"), read, 1)

    def _alone(self, node: Node) -> ast.stmt:
        inner = node.named_children[0]
        if inner.type == "assignment_expression":
            place, value = _child(inner, "left"), _child(inner, "right")
            target = self.read(place)
            if place.type == "identifier" and _text(place) in self.pointers:
                raise self._refuse(place)
            symbol = _text(inner.child_by_field_name("operator"))
            if symbol == "=":
                return ast.Assign([target], self.read(value), lineno=1)
            if not isinstance(target, ast.Name | ast.Attribute | ast.Subscript):
                raise self._refuse(place)
            return ast.AugAssign(target, _OPERATED[symbol[:-1]](), self.read(value))
        if inner.type != "call_expression":
            raise self._refuse(node)
        name = _text(inner.child_by_field_name("function"))
        given = [x for x in _child(inner, "arguments").named_children if x.type != "comment"]
        if name == "memcpy":
            self._check_whole(given)
            return ast.Assign([self.read(given[0])], self.read(given[1]), lineno=1)
        if name == "memset":
            struct = self.read(given[0])
            size = f"sizeof({self.printer.type_name(self.scope.of(struct).name)})"
            if [_text(one) for one in given[1:]] != ["0", size]:
                raise self._refuse(node)
            return ast.Expr(_call("cleared", struct))
        return ast.Expr(self.read(inner))

    def _check_whole(self, given: list[Node]) -> None:
        """Raise InputError unless a copy of memory is of the whole array that it copies to."""
        type_ = self.scope.of(self.read(given[0]))
        size = f"{' * '.join(type_.shape)} * sizeof({self.printer.type_name(type_.name)})"
        if _text(given[2]) != size:
            raise InputError(self.file, _text(given[2]), f"is not {size}")

    def _if(self, node: Node) -> ast.stmt:
        rest = node.child_by_field_name("alternative")
        other: list[ast.stmt] = []
        test = self.read(_child(node, "condition"))
        then = self._inside(node.child_by_field_name("consequence"))
        if rest is not None:
            inner = rest.named_children[-1]
            if inner.type == "if_statement":
                other = [self._if(inner)]
                other[0].lineno = inner.start_point.row + 1
            else:
                other = self._inside(inner)
        return ast.If(test, then, other)

    def _for(self, node: Node) -> ast.stmt:
        begin = _child(node, "initializer")
        first = self._declaration(begin)
        test, step = self.read(_child(node, "condition")), _child(node, "update")
        match first, test:
            case (
                ast.AnnAssign(
                    target=ast.Name(id=name),
                    annotation=ast.Name(id="size"),
                    value=ast.expr() as start,
                ),
                ast.Compare(left=ast.Name(id=same), ops=[ast.Lt()], comparators=[end]),
            ) if name == same:
                pass
            case _:
                raise self._refuse(node)
        given = [end]
        if not (isinstance(start, ast.Constant) and start.value == 0):
            given = [start, end]
        if step.type == "assignment_expression":
            own = _text(step.child_by_field_name("left"))
            if _text(step.child_by_field_name("operator")) != "+=" or own != name:
                raise self._refuse(step)
            given = [start, end, self.read(_child(step, "right"))]
        elif _text(step) != f"{name}++":
            raise self._refuse(step)
        body = self._inside(node.child_by_field_name("body"))
        return ast.For(ast.Name(name, ast.Store()), _call("range", *given), body, [], lineno=1)

    def _return(self, node: Node) -> ast.stmt:
        return ast.Return(self.read(node.named_children[0]) if node.named_children else None)

    # --- expressions

    def read(self, node: Node) -> ast.expr:
        """Read an expression.

        Raises InputError for what no routine has.
        """
        if node.type not in self._expressions:
            raise self._refuse(node)
        return self._expressions[node.type](node)

    def _name(self, node: Node) -> ast.expr:
        text = _text(node)
        if self.printer.names.get(text, text) != text:
            raise self._refuse(node)
        return ast.Name(self.names.get(text, text), ast.Load())

    def _number(self, node: Node) -> ast.expr:
        text = _text(node)
        try:
            size = text.removeprefix("-")
            number = ast.Constant(int(size, 0) if size.isalnum() else float(size))
            return ast.UnaryOp(ast.USub(), number) if size != text else number
        except ValueError:
            raise self._refuse(node) from None

    def _member(self, node: Node) -> ast.expr:
        return ast.Attribute(
            self.read(_child(node, "argument")), _text(_child(node, "field")), ast.Load()
        )

    def _element(self, node: Node) -> ast.expr:
        array, place = self.read(_child(node, "argument")), self.read(_child(node, "index"))
        match array:
            case ast.Subscript(value=whole, slice=first) if len(self.scope.of(whole).shape) > 1:
                return ast.Subscript(whole, ast.Tuple([first, place], ast.Load()), ast.Load())
        return ast.Subscript(array, place, ast.Load())

    def _operation(self, node: Node) -> ast.expr:
        left, right = self.read(_child(node, "left")), self.read(_child(node, "right"))
        symbol = _text(_child(node, "operator"))
        if symbol in ("&&", "||"):
            kind = ast.And() if symbol == "&&" else ast.Or()
            is_bare = _child(node, "left").type == "binary_expression"
            match left:
                case ast.BoolOp(op=op, values=values) if is_bare and type(op) is type(kind):
                    return ast.BoolOp(kind, [*values, right])
            return ast.BoolOp(kind, [left, right])
        if symbol in _COMPARED:
            is_none = isinstance(right, ast.Constant) and right.value is None
            compared = {"==": ast.Is, "!=": ast.IsNot}[symbol] if is_none else _COMPARED[symbol]
            return ast.Compare(left, [compared()], [right])
        if symbol not in _OPERATED:
            raise self._refuse(node)
        type_ = self.scope.of(left)
        if symbol == "+" and type_.shape:
            return ast.Subscript(left, ast.Slice(right, None, None), ast.Load())
        kind = _OPERATED[symbol]
        if symbol == "/" and type_.name in ("int", "size"):
            kind = ast.FloorDiv
        return ast.BinOp(left, kind(), right)

    def _unary(self, node: Node) -> ast.expr:
        symbol, operand = _text(_child(node, "operator")), self.read(_child(node, "argument"))
        return ast.UnaryOp(_SIGNS[symbol](), operand)

    def _choice(self, node: Node) -> ast.expr:
        return ast.IfExp(
            self.read(_child(node, "condition")),
            self.read(_child(node, "consequence")),
            self.read(_child(node, "alternative")),
        )

    def _cast(self, node: Node) -> ast.expr:
        kind, value = _text(_child(node, "type")), _child(node, "value")
        if (kind, _text(value)) == ("double", "NAN"):
            return ast.Name("nan", ast.Load())
        if kind not in _CAST:
            raise self._refuse(node)
        return _call(_CAST[kind], self.read(value))

    def _call(self, node: Node) -> ast.expr:
        function = _child(node, "function")
        given = [x for x in _child(node, "arguments").named_children if x.type != "comment"]
        name = _text(function)
        if name == "UINT64_C":
            return self.read(given[0])
        read = [self.read(one) for one in given]
        if function.type != "identifier":
            return ast.Call(self.read(function), read, [])
        if CALLS.get(name, name) != name:
            raise self._refuse(function)
        return _call(self.functions.get(name) or _CALLED.get(name, name), *read)

    def _sizeof(self, node: Node) -> ast.expr:
        kind = _text(node.named_children[0]).strip("()")
        if kind not in self.kinds:
            raise self._refuse(node)
        return _call("sizeof", ast.Name(self.kinds[kind], ast.Load()))


def _child(node: Node, name: str) -> Node:
    found = node.child_by_field_name(name)
    if found is None:
        raise InputError("C", _text(node)[:60], f"has no {name}")
    return found


def _call(name: str, *arguments: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(arguments), [])
