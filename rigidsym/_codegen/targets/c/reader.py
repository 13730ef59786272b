"""Reading of C functions back as syntax trees of routines.

The text is parsed by tree-sitter.  One table says what each node of C's grammar is in a routine;
what is not in it is refused.
"""

import ast
from collections.abc import Collection, Iterator
from functools import cache

import tree_sitter
import tree_sitter_c
from tree_sitter import Node

from rigidsym._codegen.routines import Routine, Scope, Type, annotation
from rigidsym._codegen.seal.trees import BodyReader, call, child, parts, text_of
from rigidsym._codegen.targets.c.printer import CALLS, CASTS, TYPES, Printer
from rigidsym.errors import InputError

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
            raise InputError(f"{file}:{node.start_point.row + 1}", text_of(node)[:60], "is no C")
        declarator = node.child_by_field_name("declarator")
        while declarator is not None and declarator.type != "identifier":
            declarator = declarator.child_by_field_name("declarator")
        if declarator is not None:
            yield text_of(declarator), node


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
    own = [text_of(node)] if node.type == "comment" else []
    return [*own, *(text for one in node.children for text in comments(one))]


def numbers(root: Node) -> dict[str, str]:
    """Return the value of each named number, as text with single spaces."""
    found = {}
    for node in _all(root, "declaration"):
        for place in node.children_by_field_name("declarator"):
            if place.type == "init_declarator":
                name = child(place, "declarator")
                while name.type != "identifier":
                    name = next(x for x in name.named_children if x.type != "type_qualifier")
                found[text_of(name)] = " ".join(text_of(child(place, "value")).split())
    for node in _all(root, "enum_specifier"):
        for place in child(node, "body").named_children:
            if place.type == "enumerator" and (value := place.child_by_field_name("value")):
                found[text_of(child(place, "name"))] = " ".join(text_of(value).split())
    return found


def structs(root: Node) -> dict[str, list[tuple[str, str]]]:
    """Return the members of each struct: type and declarator."""
    found = {}
    for node in _all(root, "type_definition"):
        body = child(node, "type").child_by_field_name("body")
        fields = body.named_children if body is not None else []
        found[text_of(child(node, "declarator"))] = [
            (text_of(child(field, "type")), text_of(child(field, "declarator")))
            for field in fields
            if field.type == "field_declaration"
        ]
    return found


def head(node: Node) -> tuple[str, list[str]]:
    """Return the type of a function's value, and its parameters, each with single spaces."""
    declarator, kind = child(node, "declarator"), text_of(child(node, "type"))
    while declarator.type == "pointer_declarator":
        declarator, kind = child(declarator, "declarator"), f"{kind} *"
    given = child(declarator, "parameters").named_children
    words = (" ".join(text_of(x).split()) for x in given if x.type != "comment")
    return kind, [word for word in words if word != "void"]


def _all(node: Node, kind: str) -> Iterator[Node]:
    """Yield the nodes of a kind outside of functions."""
    for one in node.children:
        if one.type == kind:
            yield one
        elif one.type in (
            "linkage_specification",
            "declaration_list",
            "preproc_ifdef",
            "preproc_if",
        ):
            yield from _all(one, kind)


class Reader(BodyReader):
    """Reader of the body of one C function.

    one: the routine that it is said to be, whose types names have.
    """

    def __init__(self, file: str, one: Routine, printer: Printer) -> None:
        super().__init__(file)
        self.scope, self.printer = Scope(one, printer.program), printer
        self.names = {printed: name for name, printed in printer.names.items()}
        self.functions = {printer.function_name(name): name for name in printer.program.routines}
        self.pointers = {
            name for name, x in one.parameters.items() if x.is_struct or x.is_result or x.shape
        }
        self.kinds = {printer.type_name(name): name for name in printer.program.structs} | _KINDS
        self.statements |= {
            "declaration": self._declaration,
            "assignment_expression": self._change,
            "call_expression": self._alone,
            "if_statement": self.choice_of_blocks,
            "for_statement": self._for,
            "return_statement": self._return,
            "break_statement": lambda _: ast.Break(),
            "continue_statement": lambda _: ast.Continue(),
        }
        self.expressions |= {
            "identifier": self._name,
            "number_literal": self._number,
            "string_literal": lambda node: ast.Constant(text_of(node)[1:-1].replace('\\"', '"')),
            "null": lambda _: ast.Constant(None),
            "field_expression": self._member,
            "subscript_expression": self._element,
            "unary_expression": self._unary,
            "pointer_expression": lambda node: self.read(child(node, "argument")),
            "conditional_expression": self._choice,
            "cast_expression": self._cast,
            "call_expression": self._call,
            "sizeof_expression": self._sizeof,
            "initializer_list": lambda node: ast.List(
                [self.read(part) for part in node.named_children], ast.Load()
            ),
        }

    # --- statements

    def body(self, function: Node) -> list[ast.stmt]:
        """Read the statements of a function.

        Raises InputError for what no routine has.
        """
        try:
            return list(self.block(child(function, "body")))
        except (KeyError, IndexError, ValueError) as error:
            if isinstance(error, InputError):
                raise
            place = f"{self.file}:{function.start_point.row + 1}"
            raise InputError(place, text_of(function)[:60], f"is not read: {error}") from None

    def block(self, node: Node) -> Iterator[ast.stmt]:
        """Read the statements of a block, whose names are not known after it."""
        outside = dict(self.scope.types)
        yield from super().block(node)
        self.scope.types = outside

    def _declaration(self, node: Node) -> ast.stmt:
        kind = self.kinds.get(text_of(node.child_by_field_name("type")), "")
        declarators = node.children_by_field_name("declarator")
        others = [x for x in node.named_children if x not in declarators][:-1]
        if len(declarators) != 1 or not kind or any(text_of(x) != "const" for x in others):
            raise self.refusal(node)
        place, value = declarators[0], None
        if place.type == "init_declarator":
            value, place = child(place, "value"), child(place, "declarator")
        lengths: list[str] = []
        while place.type == "array_declarator":
            lengths.insert(0, ast.unparse(self.read(child(place, "size"))))
            place = child(place, "declarator")
        if place.type == "pointer_declarator":
            lengths, place = ["..."], child(place, "declarator")
        name = text_of(place)
        self.scope.types[name] = type_ = Type(kind, tuple(lengths))
        read = None
        if value is not None and value.type == "initializer_list" and type_.is_pair:
            read = call("pair", *(self.read(part) for part in value.named_children))
        elif value is not None:
            read = self.read(value)
        shape = f"[{', '.join(lengths)}]" if lengths else ""
        return ast.AnnAssign(ast.Name(name, ast.Store()), annotation(f"{kind}{shape}"), read, 1)

    def _change(self, node: Node) -> ast.stmt:
        place = child(node, "left")
        if place.type == "identifier" and text_of(place) in self.pointers:
            raise self.refusal(place)
        is_plain = text_of(child(node, "operator")) == "="
        return self.assignment(node) if is_plain else self.change(node)

    def _alone(self, node: Node) -> ast.stmt:
        name, given = text_of(child(node, "function")), parts(child(node, "arguments"))
        if name == "memcpy":
            self._check_whole(given)
            return ast.Assign([self.read(given[0])], self.read(given[1]), lineno=1)
        if name == "memset":
            struct = self.read(given[0])
            size = f"sizeof({self.printer.type_name(self.scope.of(struct).name)})"
            if [text_of(one) for one in given[1:]] != ["0", size]:
                raise self.refusal(node)
            return ast.Expr(call("cleared", struct))
        return ast.Expr(self.read(node))

    def _check_whole(self, given: list[Node]) -> None:
        """Raise InputError unless a copy of memory is of the whole array that it copies to."""
        type_ = self.scope.of(self.read(given[0]))
        size = f"{' * '.join(type_.shape)} * sizeof({self.printer.type_name(type_.name)})"
        if text_of(given[2]) != size:
            raise InputError(self.file, text_of(given[2]), f"is not {size}")

    def _for(self, node: Node) -> ast.stmt:
        begin = child(node, "initializer")
        first = self._declaration(begin)
        test, step = self.read(child(node, "condition")), child(node, "update")
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
                raise self.refusal(node)
        given = [end]
        if not (isinstance(start, ast.Constant) and start.value == 0):
            given = [start, end]
        if step.type == "assignment_expression":
            own = text_of(step.child_by_field_name("left"))
            if text_of(step.child_by_field_name("operator")) != "+=" or own != name:
                raise self.refusal(step)
            given = [start, end, self.read(child(step, "right"))]
        elif text_of(step) != f"{name}++":
            raise self.refusal(step)
        body = list(self.block(child(node, "body")))
        return ast.For(ast.Name(name, ast.Store()), call("range", *given), body, [], lineno=1)

    def _return(self, node: Node) -> ast.stmt:
        return ast.Return(self.read(node.named_children[0]) if node.named_children else None)

    # --- expressions

    def _name(self, node: Node) -> ast.expr:
        text = text_of(node)
        if self.printer.names.get(text, text) != text:
            raise self.refusal(node)
        return ast.Name(self.names.get(text, text), ast.Load())

    def _number(self, node: Node) -> ast.expr:
        text = text_of(node)
        try:
            size = text.removeprefix("-")
            number = ast.Constant(int(size, 0) if size.isalnum() else float(size))
            return ast.UnaryOp(ast.USub(), number) if size != text else number
        except ValueError:
            raise self.refusal(node) from None

    def _member(self, node: Node) -> ast.expr:
        return ast.Attribute(
            self.read(child(node, "argument")), text_of(child(node, "field")), ast.Load()
        )

    def _element(self, node: Node) -> ast.expr:
        array, place = self.read(child(node, "argument")), self.read(child(node, "index"))
        match array:
            case ast.Subscript(value=whole, slice=first) if len(self.scope.of(whole).shape) > 1:
                return ast.Subscript(whole, ast.Tuple([first, place], ast.Load()), ast.Load())
        return ast.Subscript(array, place, ast.Load())

    def _operation(self, node: Node) -> ast.expr:
        match super()._operation(node):
            case ast.BinOp(left=array, op=ast.Add(), right=first) if self.scope.of(array).shape:
                return ast.Subscript(array, ast.Slice(first, None, None), ast.Load())
            case ast.BinOp(left=whole, op=ast.Div(), right=by) if self.scope.of(whole).name in (
                "int",
                "size",
            ):
                return ast.BinOp(whole, ast.FloorDiv(), by)
            case found:
                return found

    def _unary(self, node: Node) -> ast.expr:
        symbol, operand = text_of(child(node, "operator")), self.read(child(node, "argument"))
        return ast.UnaryOp(_SIGNS[symbol](), operand)

    def _choice(self, node: Node) -> ast.expr:
        return ast.IfExp(
            self.read(child(node, "condition")),
            self.read(child(node, "consequence")),
            self.read(child(node, "alternative")),
        )

    def _cast(self, node: Node) -> ast.expr:
        kind, value = text_of(child(node, "type")), child(node, "value")
        if (kind, text_of(value)) == ("double", "NAN"):
            return ast.Name("nan", ast.Load())
        if kind not in _CAST:
            raise self.refusal(node)
        return call(_CAST[kind], self.read(value))

    def _call(self, node: Node) -> ast.expr:
        function = child(node, "function")
        given = parts(child(node, "arguments"))
        name = text_of(function)
        if name == "UINT64_C":
            return self.read(given[0])
        read = [self.read(one) for one in given]
        if function.type != "identifier":
            return ast.Call(self.read(function), read, [])
        if CALLS.get(name, name) != name:
            raise self.refusal(function)
        return call(self.functions.get(name) or _CALLED.get(name, name), *read)

    def _sizeof(self, node: Node) -> ast.expr:
        kind = text_of(node.named_children[0]).strip("()")
        if kind not in self.kinds:
            raise self.refusal(node)
        return call("sizeof", ast.Name(self.kinds[kind], ast.Load()))
