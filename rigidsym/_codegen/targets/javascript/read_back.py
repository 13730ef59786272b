"""Check of the printed JavaScript: it is read back, and compared with its routines."""

import ast
import re
from collections.abc import Iterator, Mapping
from typing import ClassVar

import tree_sitter_javascript
from tree_sitter import Node

from rigidsym._codegen.forms import THETA, key
from rigidsym._codegen.ir import Constant, Function
from rigidsym._codegen.objects import members
from rigidsym._codegen.printer import SIGNS
from rigidsym._codegen.routines import Program
from rigidsym._codegen.seal.trees import (
    Definition,
    Reader,
    call,
    check_files,
    child,
    parts,
    text_of,
)
from rigidsym._codegen.targets.javascript import module
from rigidsym._codegen.targets.javascript.printer import CALLS, COMPARISONS, NAMES

_NAMES = {text: name for name, text in {**NAMES, **CALLS}.items()}
_SIGNED = {text: kind for kind, text in SIGNS.items()}
_CONSTANTS = {"null": None, "true": True, "false": False}


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
    made = module.program(functions, constants, form)
    return check_files(files, wanted, of, made, (functions, constants), JavaScriptReader)


class JavaScriptReader(Reader):
    """Reader of JavaScript."""

    language, grammar = "JavaScript", tree_sitter_javascript.language
    function, words = "function_declaration", module.WORDS
    compared: ClassVar = {
        text: kind for kind, text in COMPARISONS.items() if kind not in (ast.Is, ast.IsNot)
    }

    def __init__(self, file: str) -> None:
        super().__init__(file)
        self.statements |= {
            "lexical_declaration": self._declaration,
            "assignment_expression": self.assignment,
            "augmented_assignment_expression": self.change,
            "call_expression": lambda node: ast.Expr(self.read(node)),
            "if_statement": self.choice_of_blocks,
            "for_statement": self._for,
            "return_statement": self._return,
            "break_statement": lambda _: ast.Break(),
            "continue_statement": lambda _: ast.Continue(),
        }
        self.expressions |= {
            **dict.fromkeys(("identifier", "undefined"), self._name),
            **dict.fromkeys(_CONSTANTS, lambda node: ast.Constant(_CONSTANTS[text_of(node)])),
            "number": self._number,
            "string": lambda node: ast.Constant(ast.literal_eval(text_of(node))),
            "member_expression": self._member,
            "subscript_expression": lambda node: ast.Subscript(
                self.read(child(node, "object")), self.read(child(node, "index")), ast.Load()
            ),
            "unary_expression": lambda node: ast.UnaryOp(
                _SIGNED[text_of(child(node, "operator"))](), self.read(child(node, "argument"))
            ),
            "ternary_expression": lambda node: ast.IfExp(
                *(self.read(child(node, x)) for x in ("condition", "consequence", "alternative"))
            ),
            "call_expression": self._call,
            "array": lambda node: ast.List([*map(self.read, parts(node))], ast.Load()),
            "object": self._members,
            "array_pattern": self.several,
        }

    # --- definitions

    def wanted(self, made: Program) -> Iterator[tuple[str, Definition]]:
        """Yield what functions, structs and numbers are: names, members with zeros, values."""
        for one in made.enumerations.values():
            yield from ((x.name, ("export", x.value)) for x in one.numbers)
        yield from ((x.name, ("", x.value)) for x in made.numbers.values())
        for one in made.structs.values():
            yield f"new_{one.name}", ("export" * one.is_public, members(one))
        for one in made.routines.values():
            yield one.name, ("export" * one.is_public, *one.parameters)

    @classmethod
    def name_of(cls, node: Node) -> str:
        """Return the name that a function or a constant defines, if any."""
        if node.type == "lexical_declaration":
            (node,) = (x for x in parts(node) if x.type == "variable_declarator")
        return super().name_of(node)

    def defined(self, node: Node, name: str) -> Definition:
        """Read a value, the members of a struct, or the parameters of a function."""
        mark = "export" if node.parent and node.parent.type == "export_statement" else ""
        if node.type == "lexical_declaration":
            match self._declaration(node):
                case ast.AnnAssign(annotation=ast.Name(id="const"), value=ast.expr() as value):
                    return mark, value
        elif node.type == self.function and name.startswith("new_"):
            match list(self.block(child(node, "body"))):
                case [ast.Return(value=ast.Dict() as value)]:
                    return mark, value
        elif node.type == self.function:
            return mark, *map(text_of, parts(child(node, "parameters")))
        raise self.refusal(node)

    # --- statements

    def _declaration(self, node: Node) -> ast.stmt:
        word = text_of(child(node, "kind"))
        (declarator,) = (x for x in node.named_children if x.type == "variable_declarator")
        name, value = child(declarator, "name"), declarator.child_by_field_name("value")
        read = self.read(value) if value is not None else None
        if name.type == "array_pattern" and word == module.LET and read is not None:
            return ast.Assign([self.several(name)], read, type_comment=word, lineno=1)
        target = ast.Name(text_of(name), ast.Store())
        return ast.AnnAssign(target, ast.Name(word, ast.Load()), read, simple=1)

    def _for(self, node: Node) -> ast.stmt:
        begin = self._declaration(child(node, "initializer"))
        test, step = self.read(child(node, "condition")), child(node, "increment")
        match begin, test:
            case (
                ast.AnnAssign(target=ast.Name(id=name), value=ast.expr() as start),
                ast.Compare(left=ast.Name(id=same), ops=[ast.Lt()], comparators=[end]),
            ) if name == same and ast.unparse(begin.annotation) == module.LET:
                given = [end] if ast.unparse(start) == "0" else [start, end]
            case _:
                raise self.refusal(node)
        if step.type == "augmented_assignment_expression" and text_of(step).startswith(
            f"{name} +="
        ):
            given = [start, end, self.read(child(step, "right"))]
        elif text_of(step) != f"{name}++":
            raise self.refusal(step)
        body = list(self.block(child(node, "body")))
        return ast.For(ast.Name(name, ast.Store()), call("range", *given), body, [], lineno=1)

    def _return(self, node: Node) -> ast.stmt:
        match node.named_children:
            case []:
                return ast.Return(None)
            case [several] if several.type == "array":
                return ast.Return(self.several(several))
            case [value]:
                return ast.Return(self.read(value))
        raise self.refusal(node)

    # --- expressions

    def _members(self, node: Node) -> ast.expr:
        both = [(child(x, "key"), self.read(child(x, "value"))) for x in parts(node)]
        return ast.Dict([ast.Constant(text_of(x)) for x, _ in both], [x for _, x in both])

    def _name(self, node: Node) -> ast.expr:
        return ast.Name(_NAMES.get(text_of(node), text_of(node)), ast.Load())

    def _number(self, node: Node) -> ast.expr:
        text = text_of(node)
        is_whole = re.fullmatch(r"(0x[0-9a-f]+|\d+)n?", text)
        return ast.Constant(int(text.removesuffix("n"), 0) if is_whole else float(text))

    def _member(self, node: Node) -> ast.expr:
        if text_of(node) in _NAMES:
            return self._name(node)
        whole = self.read(child(node, "object"))
        return ast.Attribute(whole, text_of(child(node, "property")), ast.Load())

    def _call(self, node: Node) -> ast.expr:
        function = child(node, "function")
        given = [self.read(x) for x in child(node, "arguments").named_children]
        if function.type == "member_expression" and text_of(child(function, "property")) == (
            "subarray"
        ):
            (first,) = given
            array = self.read(child(function, "object"))
            return ast.Subscript(array, ast.Slice(first, None, None), ast.Load())
        return ast.Call(self.read(function), given, [])
