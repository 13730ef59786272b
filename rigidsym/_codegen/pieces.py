"""Division of long routines into short ones, which are called one after another.

Numbers that several pieces need are members of a struct, `<name>_work`, which a routine passes to
its pieces.  A statement that ends a routine or a loop stays where it is.
"""

import ast
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import replace
from itertools import pairwise

from rigidsym._codegen.routines import (
    SIZE,
    Field,
    Program,
    Routine,
    Scope,
    Struct,
    Type,
    declaration,
    let_of,
)

# Returns the number of lines that a routine of a program has in some target.
Lines = Callable[[Routine, Program], int]
# Lines of a piece beside its statements, and the fewest statements' lines that are worth a piece.
_FRAME, _LEAST = 10, 8
# The cost of a piece, in names that pieces share.
_PIECE = 2
_ENDS = (ast.Return, ast.Break, ast.Continue)


def shortened(program: Program, lines: Lines, most: int) -> Program:
    """Cut all routines that are too long.

    Input: a program, the number of lines that a routine takes, and how many it may have.  Output: a
    program that computes the same.  Raises ValueError where a routine cannot be cut.
    """
    made = replace(program, structs={**program.structs}, routines={**program.routines})
    for name, one in program.routines.items():
        short = one if lines(one, made) <= most else read_in_place(one)
        if lines(short, made) <= most:
            made.routines[name] = short
            continue
        struct, routines = pieces(short, made, lines, most)
        made.structs[struct.name] = struct
        made.routines |= {piece.name: piece for piece in routines}
    return made


def read_in_place(one: Routine) -> Routine:
    """Replace names that only copy members of structs by these members.

    Input: a routine that begins by reading members.  Output: the same without these statements.
    """
    members: dict[str, ast.expr] = {}
    kept = []
    for statement in one.body:
        match statement:
            case ast.AnnAssign(
                target=ast.Name(id=name),
                value=ast.Attribute(value=ast.Name(id=struct)) as member,
            ) if struct in one.parameters and not one.parameters[struct].is_out:
                members[name] = member
            case _:
                kept.append(statement)
    return replace(one, body=tuple(_put(statement, members) for statement in kept))


def pieces(
    one: Routine, program: Program, lines: Lines, most: int
) -> tuple[Struct, tuple[Routine, ...]]:
    """Cut a routine into pieces.

    Input: a routine, its program, the number of lines that a routine takes, and how many it may
    have.  Output: the struct that they share, the pieces, and the routine that calls them, last.

    Raises ValueError where it cannot be cut.
    """
    for threshold in (most - _FRAME, most // 2, most // 4, _LEAST):
        cut = _Cut(one, program, lines, most)
        whole = cut.block(one.body, threshold, {})
        struct, routines = cut.joined(whole)
        found = replace(program, structs={**program.structs, struct.name: struct})
        found.routines = {**program.routines, **{piece.name: piece for piece in routines}}
        longest = max(lines(piece, found) for piece in routines)
        if longest <= most:
            return struct, routines
    raise ValueError(f"{one.name}: {longest} lines in a piece, of {most} at most")


class _Cut:
    """Cut of one routine: its names, and the statements of its pieces."""

    def __init__(self, one: Routine, program: Program, lines: Lines, most: int) -> None:
        self.one, self.program, self.lines, self.most = one, program, lines, most
        self.types, self.loops = _locals(one, program)
        self.parts: list[list[ast.stmt]] = []
        self.uses = Counter(name for statement in one.body for name in _in_order(statement))

    def block(
        self, body: Sequence[ast.stmt], threshold: int, known: Mapping[str, Type]
    ) -> list[ast.stmt]:
        """Return the statements of a block, with calls in place of pieces.

        threshold: blocks within statements of more lines are cut, too.  known: the names that are
        declared before the block.
        """
        scope = Scope(self.one, self.program)
        scope.types |= known
        found: list[ast.stmt] = []
        run: list[ast.stmt] = []
        heights: list[int] = []
        for statement in body:
            before = {name: scope.types[name] for name in self.types if name in scope.types}
            scope.declare(statement)
            height = self._height(statement, before)
            inside = isinstance(statement, ast.If | ast.For) and height > threshold
            if inside or _ends(statement):
                found += self._cut_run(run, heights)
                run, heights = [], []
                found.append(self._within(statement, threshold, dict(scope.types)))
            else:
                run.append(statement)
                heights.append(height)
        return [*found, *self._cut_run(run, heights)]

    def _within(self, statement: ast.stmt, threshold: int, known: Mapping[str, Type]) -> ast.stmt:
        """Return a statement with the blocks within it cut."""
        match statement:
            case ast.If(test=test, body=body, orelse=other):
                rest = self.block(other, threshold, known)
                return ast.If(test, self.block(body, threshold, known), rest)
            case ast.For(target=target, iter=over, body=body):
                inside = self.block(body, threshold, known)
                return ast.For(target, over, inside, [])
        return statement

    def _height(self, statement: ast.stmt, before: Mapping[str, Type]) -> int:
        """Return the lines that a statement takes."""
        alone = replace(self.one, parameters={**self.one.parameters, **before}, body=(statement,))
        empty = replace(alone, body=(ast.Pass(),))
        return self.lines(alone, self.program) - self.lines(empty, self.program)

    def _cut_run(self, run: list[ast.stmt], heights: list[int]) -> list[ast.stmt]:
        """Cut statements that follow each other into pieces that hand on as few names as can be."""
        if sum(heights) < _LEAST:
            return run
        room = self.most - _FRAME
        counts = [Counter(_in_order(statement)) for statement in run]
        # For each end, the least number of names that pieces up to there share, and the last cut.
        best: dict[int, tuple[int, int]] = {0: (0, 0)}
        for end in range(1, len(run) + 1):
            height, inside = 0, Counter[str]()
            for begin in range(end - 1, -1, -1):
                height += heights[begin]
                if height > room and begin < end - 1:
                    break
                inside += counts[begin]
                cost = best[begin][0] + _PIECE + self._shared(inside)
                best[end] = min(best.get(end, (cost, begin)), (cost, begin))
        cuts = [len(run)]
        while cuts[-1]:
            cuts.append(best[cuts[-1]][1])
        calls: list[ast.stmt] = []
        for begin, end in pairwise(reversed(cuts)):
            self.parts.append(run[begin:end])
            calls.append(_place(len(self.parts) - 1))
        return calls

    def _shared(self, inside: Mapping[str, int]) -> int:
        """Count the names of a piece that are parameters, or stand elsewhere, too.

        inside: how often the piece has each name.
        """
        return sum(
            name in self.one.parameters or (name in self.types and count < self.uses[name])
            for name, count in inside.items()
        )

    def joined(self, whole: list[ast.stmt]) -> tuple[Struct, tuple[Routine, ...]]:
        """Return the struct of shared names, the pieces, and the routine that calls them."""
        regions = [set().union(*map(_names, part)) for part in (*self.parts, whole)]
        shared = {
            name: type_
            for name, type_ in self.types.items()
            if sum(name in region for region in regions) > 1
        }
        place = f"{self.one.name}_work"
        fields = tuple(Field(name, type_) for name, type_ in shared.items())
        struct = Struct(place, f"Numbers that the pieces of `{self.one.name}` share.", fields)
        members = {
            name: ast.Attribute(ast.Name("work", ast.Load()), name, ast.Load()) for name in shared
        }
        changed = [_changed(part, members) for part in self.parts]
        made = tuple(
            self._piece(number, part, bool(regions[number - 1] & shared.keys()), place)
            for number, part in enumerate(changed, 1)
        )
        calls = {number: _called(piece) for number, piece in enumerate(made)}
        body = _changed(whole, members, calls)
        if shared:
            body.insert(0, declaration("work", place, None))
        return struct, (*made, replace(self.one, body=tuple(map(ast.fix_missing_locations, body))))

    def _piece(self, number: int, part: list[ast.stmt], takes_work: bool, place: str) -> Routine:
        used = set().union(*map(_names, part))
        written = _written(part, self.program)
        parameters = {
            name: replace(type_, is_out=type_.is_out and name in written)
            for name, type_ in self.one.parameters.items()
            if name in used
        }
        parameters |= dict.fromkeys(sorted(self.loops & used - _own_loops(part)), SIZE)
        if takes_work:
            parameters["work"] = Type(place, is_out="work" in written)
        body = tuple(map(ast.fix_missing_locations, part))
        summary = f"Compute part {number} of `{self.one.name}`."
        return Routine(f"{self.one.name}_{number}", summary, parameters, (), body)


def _place(number: int) -> ast.stmt:
    """Return a statement in the place of a piece that is called."""
    made = ast.Pass()
    setattr(made, "piece", number)  # noqa: B010
    return made


def _called(piece: Routine) -> ast.stmt:
    arguments: list[ast.expr] = [ast.Name(name, ast.Load()) for name in piece.parameters]
    return ast.Expr(ast.Call(ast.Name(piece.name, ast.Load()), arguments, []))


def _locals(one: Routine, program: Program) -> tuple[dict[str, Type], set[str]]:
    """Return the types of the names that a routine declares, and the variables of its loops.

    Raises ValueError where a name has two types.
    """
    found: dict[str, Type] = {}
    loops: set[str] = set()

    def collect(body: Sequence[ast.stmt], scope: Scope) -> None:
        for statement in body:
            known = dict(scope.types)
            scope.declare(statement)
            for name in scope.types.keys() - known.keys():
                if isinstance(statement, ast.For):
                    loops.add(name)
                elif found.setdefault(name, scope.types[name]) != scope.types[name]:
                    raise ValueError(f"{one.name}: {name} has two types")
            for inside in (getattr(statement, "body", ()), getattr(statement, "orelse", ())):
                within = Scope(one, program)
                within.types = dict(scope.types)
                collect(inside, within)

    collect(one.body, Scope(one, program))
    ordered = dict.fromkeys(
        name for statement in one.body for name in _in_order(statement) if name in found
    )
    return {name: found[name] for name in ordered}, loops


def _in_order(statement: ast.stmt) -> Iterator[str]:
    return (node.id for node in ast.walk(statement) if isinstance(node, ast.Name))


def _names(statement: ast.stmt) -> set[str]:
    return {*_in_order(statement)}


def _own_loops(part: Sequence[ast.stmt]) -> set[str]:
    nodes = (node for statement in part for node in ast.walk(statement))
    return {ast.unparse(node.target) for node in nodes if isinstance(node, ast.For)}


def _ends(statement: ast.stmt) -> bool:
    """Return True if a statement may end a routine, or a loop around it."""
    return any(isinstance(node, _ENDS) for node in ast.walk(statement))


def _written(part: Sequence[ast.stmt], program: Program) -> set[str]:
    """Return the names that statements write to, or to members or elements of."""
    found: set[str] = set()
    for node in (node for statement in part for node in ast.walk(statement)):
        match node:
            case ast.Assign(targets=targets):
                written = [
                    x for y in targets for x in (y.elts if isinstance(y, ast.Tuple) else [y])
                ]
            case ast.AugAssign(target=target):
                written = [target]
            case ast.Call(func=ast.Name(id="cleared"), args=arguments):
                written = arguments
            case ast.Call(func=ast.Name(id=name), args=arguments) if name in program.routines:
                types = program.routines[name].parameters.values()
                both = zip(arguments, types, strict=True)
                written = [argument for argument, type_ in both if type_.is_out]
            case _:
                continue
        found |= set(map(_root, written))
    return found


def _root(node: ast.expr) -> str:
    while isinstance(node, ast.Attribute | ast.Subscript):
        node = node.value
    return ast.unparse(node)


# --- changes of statements


class _Put(ast.NodeTransformer):
    """Replacement of names by expressions; a declaration becomes an assignment."""

    def __init__(self, meaning: Mapping[str, ast.expr], calls: Mapping[int, ast.stmt]) -> None:
        self.meaning, self.calls = meaning, calls

    def visit_Name(self, node: ast.Name) -> ast.expr:
        """Replace a name."""
        return deepcopy(self.meaning.get(node.id, node))

    def visit_Pass(self, node: ast.Pass) -> ast.stmt:
        """Replace the place of a piece by its call."""
        number = getattr(node, "piece", None)
        return node if number is None else self.calls[number]

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.stmt | None:
        """Assign to what is declared elsewhere."""
        if node.value is not None:
            node.value = self.visit(node.value)
        if ast.unparse(node.target) not in self.meaning:
            return node
        if node.value is None:
            return None
        made = ast.Assign([self.visit(node.target)], node.value)
        if (let := let_of(node)) is not None:
            setattr(made, "let", let)  # noqa: B010
        return made


def _put(statement: ast.stmt, meaning: Mapping[str, ast.expr]) -> ast.stmt:
    return _Put(meaning, {}).visit(deepcopy(statement))


def _changed(
    body: Sequence[ast.stmt],
    meaning: Mapping[str, ast.expr],
    calls: Mapping[int, ast.stmt] | None = None,
) -> list[ast.stmt]:
    changed = (_Put(meaning, calls or {}).visit(deepcopy(statement)) for statement in body)
    return [statement for statement in changed if statement is not None]
