"""Check of the printed JavaScript: it is read back, and compared with its routines."""

import ast
import re
from collections.abc import Callable, Iterator, Mapping
from functools import cache

import tree_sitter
import tree_sitter_javascript
from tree_sitter import Node

from rigidsym._codegen import header
from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.printer import OPERATIONS, SIGNS
from rigidsym._codegen.seal.bodies import Body, check_function, check_outside
from rigidsym._codegen.targets.javascript import module
from rigidsym._codegen.targets.javascript.printer import CALLS, COMPARISONS, NAMES
from rigidsym.errors import InputError

_NAMES = {text: name for name, text in {**NAMES, **CALLS}.items()}
_COMPARED = {text: kind for kind, text in COMPARISONS.items() if kind not in (ast.Is, ast.IsNot)}
_OPERATED = {text: kind for kind, (text, _) in OPERATIONS.items() if kind is not ast.FloorDiv}
_SIGNED = {text: kind for kind, text in SIGNS.items()}
_CONSTANTS = {"null": None, "true": True, "false": False}
_LOGICAL: dict[str, type[ast.boolop]] = {"&&": ast.And, "||": ast.Or}


def check(
    files: Mapping[str, str],
    functions: tuple[Function, ...],
    constants: tuple[Constant, ...],
    form: str = THETA,
) -> int:
    """Check the printed files against their routines, and return the number of derived lines.

    Raises InputError for a statement that differs, and for other text that does.
    """
    wanted, of = module.build(functions, constants, form), key("javascript", form)
    if files.keys() != wanted.files.keys():
        raise InputError("files", ", ".join(files), f"are not {', '.join(wanted.files)}")
    routines = module.program(functions, constants, form).routines
    file, decided = module.FILES[form], 0
    own = header.unsealed(files[file], of, header.digest_in(file, files[file]))
    texts = {**files, file: own}
    expected = {**wanted.files, file: header.unsealed(wanted.files[file], of, wanted.digest)}
    for name, text in texts.items():
        outside = (list(_outside(name, x, routines)) for x in (text, expected[name]))
        check_outside(name, *outside)
    for name, node in _bodies(file, own, routines):
        body = Body(file, own.split("\n"), routines[name])
        decided += body.check(list(_Reader(file).block(node)), routines[name].body)
    for function in functions:
        check_function(function, [one for one in routines.values() if one.prints(function)])
    return decided


@cache
def _parser() -> tree_sitter.Parser:
    return tree_sitter.Parser(tree_sitter.Language(tree_sitter_javascript.language()))


def _bodies(file: str, text: str, names: Mapping[str, object]) -> Iterator[tuple[str, Node]]:
    """Yield the names and bodies of the functions that print routines."""
    for node in _parser().parse(text.encode()).root_node.named_children:
        one = node.named_children[0] if node.type == "export_statement" else node
        name = _text(one.child_by_field_name("name"))
        if one.type == "function_declaration" and name in names:
            if one.has_error:
                raise InputError(f"{file}:{one.start_point.row + 1}", name, "is no JavaScript")
            yield name, _child(one, "body")


def _outside(file: str, text: str, names: Mapping[str, object]) -> Iterator[tuple[int, str]]:
    """Yield the lines outside the bodies of routines, with their numbers."""
    inside = {
        number
        for _, body in (_bodies(file, text, names) if file.endswith(".mjs") else ())
        for number in range(body.start_point.row + 2, body.end_point.row + 2)
    }
    lines = enumerate(text.split("\n"), 1)
    yield from ((number, line) for number, line in lines if number not in inside)


def _text(node: Node | None) -> str:
    return node.text.decode() if node is not None and node.text is not None else ""


def _child(node: Node, name: str) -> Node:
    found = node.child_by_field_name(name)
    if found is None:
        raise InputError("JavaScript", _text(node)[:60], f"has no {name}")
    return found


def _call(name: str, *given: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(given), [])


class _Reader:
    """Reader of the bodies of functions; what is not in its tables is refused."""

    def __init__(self, file: str) -> None:
        self.file = file
        self._statements: dict[str, Callable[[Node], ast.stmt]] = {
            "lexical_declaration": self._declaration,
            "expression_statement": self._alone,
            "if_statement": self._if,
            "for_statement": self._for,
            "return_statement": self._return,
            "break_statement": lambda _: ast.Break(),
            "continue_statement": lambda _: ast.Continue(),
        }
        self._expressions: dict[str, Callable[[Node], ast.expr]] = {
            **dict.fromkeys(("identifier", "undefined"), self._name),
            **dict.fromkeys(_CONSTANTS, lambda node: ast.Constant(_CONSTANTS[_text(node)])),
            "number": self._number,
            "string": lambda node: ast.Constant(ast.literal_eval(_text(node))),
            "member_expression": self._member,
            "subscript_expression": lambda node: ast.Subscript(
                self.read(_child(node, "object")), self.read(_child(node, "index")), ast.Load()
            ),
            "binary_expression": self._operation,
            "unary_expression": lambda node: ast.UnaryOp(
                _SIGNED[_text(_child(node, "operator"))](), self.read(_child(node, "argument"))
            ),
            "parenthesized_expression": lambda node: self.read(node.named_children[0]),
            "ternary_expression": lambda node: ast.IfExp(
                *(self.read(_child(node, x)) for x in ("condition", "consequence", "alternative"))
            ),
            "call_expression": self._call,
            "array": lambda node: ast.List([*map(self.read, node.named_children)], ast.Load()),
            "array_pattern": self._several,
        }

    def _refuse(self, node: Node) -> InputError:
        place = f"{self.file}:{node.start_point.row + 1}"
        return InputError(place, _text(node)[:80], f"is nothing that a routine has ({node.type})")

    def block(self, node: Node) -> Iterator[ast.stmt]:
        """Read the statements of a block; each knows its line."""
        if node.type != "statement_block":
            raise self._refuse(node)
        for child in node.named_children:
            if child.type == "comment":
                continue
            if child.type not in self._statements:
                raise self._refuse(child)
            statement = self._statements[child.type](child)
            statement.lineno = child.start_point.row + 1
            yield statement

    def read(self, node: Node) -> ast.expr:
        """Read an expression."""
        if node.type not in self._expressions:
            raise self._refuse(node)
        return self._expressions[node.type](node)

    # --- statements

    def _declaration(self, node: Node) -> ast.stmt:
        word = _text(_child(node, "kind"))
        (declarator,) = (x for x in node.named_children if x.type == "variable_declarator")
        name, value = _child(declarator, "name"), declarator.child_by_field_name("value")
        read = self.read(value) if value is not None else None
        if name.type == "array_pattern" and word == module.LET and read is not None:
            return ast.Assign([self._several(name)], read, type_comment=word, lineno=1)
        target = ast.Name(_text(name), ast.Store())
        return ast.AnnAssign(target, ast.Name(word, ast.Load()), read, simple=1)

    def _alone(self, node: Node) -> ast.stmt:
        inner = node.named_children[0]
        if inner.type == "call_expression":
            return ast.Expr(self.read(inner))
        target, value = self.read(_child(inner, "left")), self.read(_child(inner, "right"))
        if inner.type == "assignment_expression":
            return ast.Assign([target], value, lineno=1)
        symbol = _text(_child(inner, "operator")).removesuffix("=")
        if symbol in _OPERATED and isinstance(target, ast.Name | ast.Attribute | ast.Subscript):
            return ast.AugAssign(target, _OPERATED[symbol](), value)
        raise self._refuse(inner)

    def _if(self, node: Node) -> ast.stmt:
        test = self.read(_child(node, "condition"))
        then, other = list(self.block(_child(node, "consequence"))), node
        rest = node.child_by_field_name("alternative")
        if rest is None:
            return ast.If(test, then, [])
        other = rest.named_children[-1]
        if other.type != "if_statement":
            return ast.If(test, then, list(self.block(other)))
        inner = self._if(other)
        inner.lineno = other.start_point.row + 1
        return ast.If(test, then, [inner])

    def _for(self, node: Node) -> ast.stmt:
        begin = self._declaration(_child(node, "initializer"))
        test, step = self.read(_child(node, "condition")), _child(node, "increment")
        match begin, test:
            case (
                ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as start),
                ast.Compare(left=ast.Name(id=same), ops=[ast.Lt()], comparators=[end]),
            ) if name == same and ast.unparse(begin.annotation) == module.LET:
                given = [end] if ast.unparse(start) == "0" else [start, end]
            case _:
                raise self._refuse(node)
        if step.type == "augmented_assignment_expression" and _text(step).startswith(f"{name} +="):
            given = [start, end, self.read(_child(step, "right"))]
        elif _text(step) != f"{name}++":
            raise self._refuse(step)
        body = list(self.block(_child(node, "body")))
        return ast.For(ast.Name(name, ast.Store()), _call("range", *given), body, [], lineno=1)

    def _return(self, node: Node) -> ast.stmt:
        match node.named_children:
            case []:
                return ast.Return(None)
            case [several] if several.type == "array":
                return ast.Return(self._several(several))
            case [value]:
                return ast.Return(self.read(value))
        raise self._refuse(node)

    # --- expressions

    def _several(self, node: Node) -> ast.expr:
        return ast.Tuple([*map(self.read, node.named_children)], ast.Load())

    def _name(self, node: Node) -> ast.expr:
        return ast.Name(_NAMES.get(_text(node), _text(node)), ast.Load())

    def _number(self, node: Node) -> ast.expr:
        text = _text(node)
        is_whole = re.fullmatch(r"(0x[0-9a-f]+|\d+)n?", text)
        return ast.Constant(int(text.removesuffix("n"), 0) if is_whole else float(text))

    def _member(self, node: Node) -> ast.expr:
        if _text(node) in _NAMES:
            return self._name(node)
        whole = self.read(_child(node, "object"))
        return ast.Attribute(whole, _text(_child(node, "property")), ast.Load())

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
            kinds = {"===": ast.Is, "!==": ast.IsNot} if right.type == "null" else _COMPARED
            return ast.Compare(one, [kinds[symbol]()], [other])
        if symbol not in _OPERATED:
            raise self._refuse(node)
        return ast.BinOp(one, _OPERATED[symbol](), other)

    def _call(self, node: Node) -> ast.expr:
        function = _child(node, "function")
        given = [self.read(x) for x in _child(node, "arguments").named_children]
        if function.type == "member_expression" and _text(_child(function, "property")) == (
            "subarray"
        ):
            (first,) = given
            array = self.read(_child(function, "object"))
            return ast.Subscript(array, ast.Slice(first, None, None), ast.Load())
        return ast.Call(self.read(function), given, [])
