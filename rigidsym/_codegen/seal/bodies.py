"""Comparison of functions read back from a printed file with the routines that they print.

What stands outside the bodies of functions is compared word for word, bodies statement by
statement; a derived statement is the one of its assignment in the representation.
"""

import ast
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import zip_longest

from rigidsym._codegen.ir import Function, Let, is_extended
from rigidsym._codegen.lines import comment
from rigidsym._codegen.passes import fuse, unfused
from rigidsym._codegen.routines import KINDS, OF_PAIRS, Routine, copied, is_same, let_of, syntax
from rigidsym._codegen.seal.equality import DIFFERS, is_equal
from rigidsym.errors import InputError
from rigidsym.language._expression import Call, Expression, children, rebuild

_SYMBOLS: dict[str, type[ast.operator]] = {
    **{"add": ast.Add, "sub": ast.Sub},
    **{"mul": ast.Mult, "div": ast.Div},
}
_PRIMITIVES = {routine: primitive for primitive, routine in OF_PAIRS.items()}


def check_function(function: Function, printed: Iterable[Routine]) -> None:
    """Raise InputError unless the statements of routines are a function's assignments."""
    for one in printed:
        assert one.function is not None
        fused = fuse(one.function)
        if tuple(filter(None, map(let_of, one.statements()))) != fused:
            raise InputError(one.name, function.name, "has other assignments")
        for let, changed in zip(function.lets, fused, strict=True):
            if not is_equal(unfused(changed.expression), let.expression):
                raise InputError(function.name, changed, f"{let}: not what was fused")


def check_outside(
    file: str, found: Iterable[tuple[int, str]], wanted: Iterable[tuple[int, str]]
) -> None:
    """Raise InputError for the first line outside the bodies of functions that differs."""
    ends = zip_longest(found, wanted, fillvalue=(0, "the end of the file"))
    for (number, line), (_, other) in ends:
        if line != other:
            rule = f"is not {other.strip()[:80] or 'an empty line'}"
            raise InputError(f"{file}:{number}", line.strip() or "an empty line", rule)


@dataclass(frozen=True, slots=True)
class Body:
    """Body of a function in a file, compared with the statements of its routine.

    plain: returns trees that are equal where the language says the same.  marks: what stands
    before and after the comment on a derived line.
    """

    file: str
    text: Sequence[str]
    one: Routine
    plain: Callable[[ast.AST], ast.AST] = lambda node: node
    marks: tuple[str, str] = ("; /* ", " */")

    def check(self, read: Sequence[ast.stmt], wanted: Sequence[ast.stmt]) -> int:
        """Compare statements, and return the number of derived ones.

        Raises InputError for the first that differs.
        """
        decided = 0
        for one, other in zip_longest(read, [x for x in wanted if not isinstance(x, ast.Pass)]):
            place = f"{self.file}:{one.lineno}" if one else f"{self.file}: {self.one.name}"
            if one is None or other is None or type(one) is not type(other):
                raise InputError(place, _said(one), f"is not {_said(other)}")
            if isinstance(one, ast.If | ast.For) and isinstance(other, ast.If | ast.For):
                for name in ("test",) if isinstance(one, ast.If) else ("target", "iter"):
                    self._check_same(place, getattr(one, name), getattr(other, name, None))
                decided += self.check(one.body, other.body)
                decided += self.check(one.orelse, other.orelse)
                continue
            self._check_same(place, one, other)
            # Routines without a derived function are compared as they stand.
            if (let := let_of(other)) and self.one.function:
                self._check_derived(place, one, let)
                decided += 1
        return decided

    def _check_same(self, place: str, read: ast.AST, wanted: ast.AST | None) -> None:
        read, wanted = self.plain(read), wanted and self.plain(wanted)
        words = (getattr(node, "type_comment", None) for node in (read, wanted))
        if not is_same(read, wanted) or len({*words}) > 1:
            raise InputError(place, _said(read), f"is not {_said(wanted)}: {DIFFERS}")

    def _check_derived(self, place: str, read: ast.stmt, let: Let) -> None:
        """Raise InputError unless a statement, and its comment, are those of an assignment."""
        assert self.one.function is not None
        wanted = syntax(_without_rounding(let.expression, self.one.function.all_extended()))
        match read:
            case ast.AnnAssign(target=target, value=ast.expr() as value):
                targets: list[ast.expr] = [target]
            case ast.Assign(targets=[ast.Tuple(elts=targets)], value=value):
                pass
            case ast.Expr(value=ast.Call(func=called, args=given)):
                count = len(given) - len(let.targets)
                targets, value = given[count:], ast.Call(called, given[:count], [])
            case _:
                raise InputError(place, _said(read), f"sets no name: {let}")
        names = tuple(target.id for target in targets if isinstance(target, ast.Name))
        # The statement was compared as it is before.
        if names != let.targets or not is_same(Raised().visit(value), wanted):
            raise InputError(place, _said(read), f"{let}: {DIFFERS}")
        before, after = self.marks
        _, _, note = self.text[read.lineno - 1].partition(before)
        if note.removesuffix(after) != comment(let):
            raise InputError(place, f"{let}{before}{note}", f"is by {comment(let)}")


def _without_rounding(expression: Expression, extended: frozenset[str]) -> Expression:
    """Drop the rounding of what is a double already."""
    parts = tuple(_without_rounding(part, extended) for part in children(expression))
    match rebuild(expression, parts):
        case Call("rounded", (part,)) if not is_extended(part, extended):
            return part
        case other:
            return other


class Raised(ast.NodeTransformer):
    """Operations in place of calls of the functions for extended numbers."""

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """Replace a call whose name begins with that of a kind of numbers."""
        self.generic_visit(node)
        name = ast.unparse(node.func)
        kind, _, verb = name.partition("_")
        operation, _, _ = verb.partition("_")
        if kind not in KINDS:
            return node
        if operation in _SYMBOLS:
            left, right = node.args
            return ast.BinOp(left, _SYMBOLS[operation](), right)
        if verb == "of":
            return node.args[0]
        if verb == "neg":
            return ast.UnaryOp(ast.USub(), node.args[0])
        if name not in _PRIMITIVES:
            return node
        return ast.Call(ast.Name(_PRIMITIVES[name], ast.Load()), node.args, [])


def _said(node: ast.AST | None) -> str:
    """Return the text of a statement or an expression, in one line."""
    if node is None:
        return "the end"
    return " ".join(ast.unparse(ast.fix_missing_locations(copied(node))).split())[:160]
