"""Traceability of the flight profile: requirement, theorem, functions and tests, computed.

Functions follow from the facts behind their lines, theorems from the formulas that they justify in
the specification, and tests from the regime of each reference vector.
"""

import ast
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fractions import Fraction

from rigidsym._codegen.flight.program import PREFIX, names, plain
from rigidsym._codegen.flight.vectors import Vectors
from rigidsym._codegen.forms import STEP, THETA
from rigidsym._codegen.routines import Program, Routine, let_of
from rigidsym._codegen.targets.c import codes
from rigidsym.io.ledger import specification_text
from rigidsym.language._specification import Theorem, read
from rigidsym.solution import Solution
from rigidsym.solution._polhode import classify

# Theorems that state what functions compute; the partition of motions is that of `sorted_body`.
_STATES = ("theta_form", "hyperbolic_form", "rates_start", "attitude_start", "start_signs")
_THEOREMS = (
    *("steady", "steady_start", *_STATES, "any_motion", "landen", "scaling"),
    *("step_motion", "step_motion_start", "doubling", "doubling_start", "halves", "halves_start"),
)
_PARTITION = "sorted_body"
_STEADY = ("steady", "steady_start")
_FORMS = {"separatrix_motion": "separatrix_form", "oblate_motion": "symmetric_form"}
_FORMS["prolate_motion"] = _FORMS["oblate_motion"]


@dataclass(frozen=True, slots=True)
class Row:
    """Requirement, with the theorems, functions and tests behind it."""

    name: str
    requirement: str
    theorems: tuple[str, ...]
    functions: tuple[str, ...]
    tests: str

    def __str__(self) -> str:
        behind = ", ".join(self.theorems) or "none"
        functions = ", ".join(f"`{name}`" for name in self.functions)
        requirement = self.requirement.replace("|", "\\|")
        return f"| {self.name} | {requirement} | {behind} | {functions} | {self.tests} |"


def table(solution: Solution, program: Program, vectors: Vectors) -> list[str]:
    """Return the traceability table in Markdown."""
    head = ["| | requirement | theorems | functions | tests |", "| --- | --- | --- | --- | --- |"]
    return [*head, *map(str, rows(solution, program, vectors))]


def rows(solution: Solution, program: Program, vectors: Vectors) -> Iterator[Row]:
    """Yield the requirements: regimes of motions, formulas, interface, and refusals."""
    theorems = read(specification_text())
    behind = {one.name: facts(one) for one in program.routines.values()}
    proved = {name: _justified(theorems[name], solution) for name in (*_THEOREMS, *_FORMS.values())}
    known = set().union(*(proved[name] for name in _THEOREMS))
    partition = {fact for found in behind.values() for fact in found} - known
    proved[_PARTITION] = partition

    def functions(*wanted: str) -> tuple[str, ...]:
        every = set().union(*(proved[name] for name in wanted))
        return tuple(name for name, found in behind.items() if found & every)

    states = Counter(_leaf(vector.given) for vector in vectors.states)
    steps = Counter(_leaf(vector.given) for vector in vectors.steps)
    for number, leaf in enumerate(theorems[_PARTITION].cases, 1):
        is_steady = leaf not in _FORMS and leaf not in ("largest", "smallest")
        own = _STEADY if is_steady else (*filter(None, [_FORMS.get(leaf)]), *_STATES)
        yield Row(
            f"M{number}",
            f"states of motions `{leaf}`: {theorems[leaf].title}",
            (leaf, *own),
            functions(*own),
            f"{states[leaf]} states, {steps[leaf]} steps",
        )
    total = {"states": len(vectors.states), "steps": len(vectors.steps)}
    for number, name in enumerate((_PARTITION, *_THEOREMS), 1):
        found = functions(name)
        kinds = ["steps"] if all(x.startswith("step_") for x in found) else ["states"]
        yield Row(
            f"F{number}",
            f"formulas of {name}: {theorems[name].title}",
            (name,),
            found,
            ", ".join(f"{total[kind]} {kind}" for kind in kinds),
        )
    for number, one in enumerate((x for x in program.routines.values() if x.is_public), 1):
        reached = _reached(one, program)
        own = tuple(
            name
            for name in (_PARTITION, *_THEOREMS)
            if any(behind[other] & proved[name] for other in reached)
        )
        is_step = any(other.startswith("step_") for other in reached) or "body" in one.parameters
        kind = "steps" if is_step else "states"
        tests = f"{total[kind]} {kind}" if own else "words and refusals"
        yield Row(f"I{number}", _sentence(one.summary), own, (PREFIX + one.name,), tests)
    yield from _refusals(program, vectors)


def _refusals(program: Program, vectors: Vectors) -> Iterator[Row]:
    counts = Counter(f"STEP_{x.code}" for x in vectors.refused_steps)
    counts += Counter(x.code for x in vectors.refused_motions)
    rules = {
        f"{'STEP_' if form == STEP else ''}{number.name}": plain(number.comment)
        for form in (THETA, STEP)
        for number in codes.enumeration(form).numbers
    }
    named = {one.name: _names(one) for one in program.routines.values()}
    for number, (name, rule) in enumerate(rules.items(), 1):
        by = tuple(function for function, found in named.items() if name in found)
        if by and not name.endswith("OK"):
            tests = f"{counts[name]} refusals" if counts[name] else "1 refusal"
            yield Row(f"R{number}", f"`{names()[name]}`: {rule}", (), by, tests)


def facts(one: Routine) -> set[str]:
    """Return the facts behind the lines of a routine."""
    lets = (
        let_of(node) for part in one.body for node in ast.walk(part) if isinstance(node, ast.stmt)
    )
    return {fact for let in lets if let is not None for fact in let.facts}


def _justified(theorem: Theorem, solution: Solution) -> set[str]:
    """Return the facts of the formulas that a theorem justifies."""
    return {
        formula.fact
        for sequence, wanted in theorem.formulas
        for formula in solution.sequences[sequence]
        if not wanted or formula.name in wanted
    }


def _leaf(given: tuple[tuple[float, ...], ...]) -> str:
    inertia, omega0, _ = given
    return classify([*map(Fraction, inertia)], [*map(Fraction, omega0)]).leaf


def _reached(one: Routine, program: Program) -> set[str]:
    found, queue = {one.name}, [one.name]
    while queue:
        new = program.routines[queue.pop()].calls() & program.routines.keys() - found
        found |= new
        queue += new
    return found


def _names(one: Routine) -> set[str]:
    nodes: Iterable[ast.AST] = (node for part in one.body for node in ast.walk(part))
    return {node.id for node in nodes if isinstance(node, ast.Name)}


def _sentence(text: str) -> str:
    return " ".join(text.split()).split(". ")[0].split(".  ")[0].rstrip(".")
