"""Program of the flight profile: motions and steps of one body, in short functions."""

import ast
from collections.abc import Mapping
from dataclasses import replace

from rigidsym._codegen import scalar
from rigidsym._codegen.flight.printer import FlightPrinter
from rigidsym._codegen.formats import BINARY64
from rigidsym._codegen.forms import STEP, THETA, limits
from rigidsym._codegen.functions import constants, functions
from rigidsym._codegen.pieces import shortened
from rigidsym._codegen.routines import Program, Routine, read
from rigidsym._codegen.targets.c import codes
from rigidsym._codegen.targets.c.pointers import with_pointers
from rigidsym.solution import Solution

PREFIX = "torque_free_"
MOST_LINES = 60
# Functions of one body and one time; others are loops over these, or compute sensitivities.
PUBLIC = (
    *(
        "motion_init",
        "state_at",
        "state_at_sum",
        "last_time",
        "message",
        "field",
        "rule",
        "self_test",
    ),
    *("body_init", "step", "step_message", "step_field", "step_rule"),
)
_KNOWN = {"ALLOW_NONPHYSICAL": False, "BITS_ARE_CHOSEN": True}


def program(solution: Solution) -> Program:
    """Return all structs, numbers and routines of the profile, in an order that C can read."""
    motions, steps = (
        scalar.program(functions(solution, form), constants(), form) for form in (THETA, STEP)
    )
    steps = _apart(steps, motions)
    made = replace(motions)
    made.known = {**motions.known, **steps.known}
    made.structs = {**motions.structs, **steps.structs}
    made.numbers = {**motions.numbers, **steps.numbers}
    made.routines = {**motions.routines, **steps.routines}
    known = {**BINARY64.numbers(), **_KNOWN}
    tests = read(("arithmetic", "self_test", "built_in_test"), Program(), known)
    made.numbers |= tests.numbers
    for name, number in made.numbers.items():
        made.numbers[name] = replace(number, value=_Plain().visit(number.value))
    made.routines |= tests.routines
    for name, one in made.routines.items():
        marks = one.decorators if name in PUBLIC else one.decorators - {"public"}
        made.routines[name] = replace(_folded(one, _KNOWN), decorators=marks)
    plain = with_pointers(_specialised(made.without_idle()).in_order())
    short = shortened(plain, lines, MOST_LINES)
    return short.without_idle().in_order()


def names() -> dict[str, str]:
    """Map names of the program to their names in C."""
    found = codes.names(THETA)
    return found | {f"STEP_{name}": text for name, text in codes.names(STEP).items()}


def plain(text: str) -> str:
    """Fill in the limits that a text names, and leave out a switch that the profile lacks."""
    for limit in (*limits(THETA), *limits(STEP)):
        text = text.replace(f"@{limit.name}@", str(limit.exponent))
    return text.replace(" (-DALLOW_NONPHYSICAL lets it pass)", "")


def lines(one: Routine, program: Program) -> int:
    """Return the lines that a routine takes in C, its description aside."""
    text = FlightPrinter(program, PREFIX, names()).routine(one).text
    return len(text) - next(k for k, line in enumerate(text) if "(" in line and line[0] != "/") - 1


def _apart(steps: Program, motions: Program) -> Program:
    """Rename what is not the same in the program of motions under the same name."""
    new = {name: f"STEP_{name}" for name in codes.names(STEP)}
    for name, number in steps.numbers.items():
        other = motions.numbers.get(name)
        if other is not None and ast.dump(other.value) != ast.dump(number.value):
            new[name] = f"STEP_{name}"
    # Others follow from these: what calls them, or names them, is not the same either.
    count = -1
    while count != len(new):
        count = len(new)
        for name, one in steps.routines.items():
            if name in motions.routines and (
                _dump(one) != _dump(motions.routines[name]) or new.keys() & _names(one)
            ):
                new[name] = f"step_{name}"
    made = replace(steps)
    made.known = {new.get(name, name): type_ for name, type_ in steps.known.items()}
    renamed = _Renamed(new)
    made.numbers = {
        new.get(name, name): replace(
            one,
            name=new.get(name, name),
            type=replace(one.type, shape=tuple(new.get(x, x) for x in one.type.shape)),
        )
        for name, one in steps.numbers.items()
    }
    made.routines = {
        new.get(name, name): replace(
            one, name=new.get(name, name), body=tuple(renamed.visit(part) for part in one.body)
        )
        for name, one in steps.routines.items()
    }
    return made


def _dump(one: Routine) -> str:
    return "\n".join(ast.dump(part) for part in one.body)


def _names(one: Routine) -> set[str]:
    nodes = (node for part in one.body for node in ast.walk(part))
    return {node.id for node in nodes if isinstance(node, ast.Name)}


class _Renamed(ast.NodeTransformer):
    """Replacement of names."""

    def __init__(self, new: Mapping[str, str]) -> None:
        self.new = new

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Replace a name."""
        return ast.Name(self.new.get(node.id, node.id), node.ctx)


class _Folding(ast.NodeTransformer):
    """Replacement of what is known by its value."""

    def __init__(self, known: Mapping[str, bool]) -> None:
        self.known = known

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a known name by its value."""
        return ast.Constant(self.known[node.id]) if node.id in self.known else node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        """Negate what is known."""
        self.generic_visit(node)
        match node:
            case ast.UnaryOp(op=ast.Not(), operand=ast.Constant(value=bool(value))):
                return ast.Constant(not value)
        return node

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        """Compute differences of whole numbers."""
        self.generic_visit(node)
        match node:
            case ast.BinOp(
                op=ast.Sub(),
                left=ast.Constant(value=int(left)),
                right=ast.Constant(value=int(right)),
            ):
                return ast.Constant(left - right)
        return node

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """Leave out what decides nothing."""
        self.generic_visit(node)
        decides = isinstance(node.op, ast.Or)
        kept: list[ast.expr] = []
        for part in node.values:
            known = part.value if isinstance(part, ast.Constant) else None
            if known is decides:
                return ast.Constant(decides)
            if known is None:
                kept.append(part)
        return kept[0] if len(kept) == 1 else ast.BoolOp(node.op, kept)

    def visit_If(self, node: ast.If) -> ast.stmt | list[ast.stmt]:
        """Keep one branch where the condition is known."""
        self.generic_visit(node)
        match node.test:
            case ast.Constant(value=bool(value)):
                return node.body if value else node.orelse
        return node


class _Plain(ast.NodeTransformer):
    """Replacement of texts by those of the profile."""

    def visit_Constant(self, node: ast.Constant) -> ast.Constant:
        """Replace a text."""
        return ast.Constant(plain(node.value)) if isinstance(node.value, str) else node


def _folded(one: Routine, known: Mapping[str, bool]) -> Routine:
    folding = _Folding(known)
    whole = ast.Module([folding.visit(part) for part in one.body], [])
    statements = (x for part in whole.body for x in (part if isinstance(part, list) else [part]))
    return replace(one, body=tuple(statements))


def _specialised(program: Program) -> Program:
    """Drop the parameters of private routines that have the same truth value in every call."""
    calls: dict[str, list[list[ast.expr]]] = {}
    for one in program.routines.values():
        for node in (node for part in one.body for node in ast.walk(part)):
            match node:
                case ast.Call(func=ast.Name(id=name), args=given) if name in program.routines:
                    calls.setdefault(name, []).append(given)
    made = replace(program, routines={**program.routines})
    for name, every in calls.items():
        one = program.routines[name]
        known: dict[str, bool] = {}
        for place, parameter in reversed([*enumerate(one.parameters)]):
            texts = {ast.unparse(given[place]) for given in every}
            if not one.is_public and texts in ({"True"}, {"False"}):
                known[parameter] = texts == {"True"}
                for given in every:
                    del given[place]
        left = {key: type_ for key, type_ in one.parameters.items() if key not in known}
        made.routines[name] = replace(_folded(made.routines[name], known), parameters=left)
    return made
