"""Display of verdicts as text, in an overview and one by one."""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence

from rigidsym.language._unicode import in_unicode
from rigidsym.proof.paper._counterexample import Counterexample
from rigidsym.proof.paper._equation import Flaw, Root
from rigidsym.proof.paper._verdicts import Ruling, Verdict

COLUMNS = ("equation", "verdict", "repair, or how it is read", "fails at")
_COUNTED = {
    Ruling.HOLDS: "{} hold",
    Ruling.CONDITIONAL: "{} hold under a condition",
    Ruling.MISPRINT: "{} are misprints",
    Ruling.AMBIGUOUS: "{} ambiguous",
    Ruling.OPEN: "{} open",
}


def counted(ruled: Sequence[Verdict]) -> str:
    """Return a phrase that counts the verdicts of each kind."""
    counts = Counter(verdict.ruling for verdict in ruled)
    said = (form.format(counts[ruling]) for ruling, form in _COUNTED.items() if counts[ruling])
    return ", ".join(said)


def causes(ruled: Sequence[Verdict]) -> dict[Root, list[str]]:
    """Return the fewest root errors that explain all misprints, with the numbers of their lines.

    Each is the one that explains the most of the lines that those before it leave.
    """
    misprints = [verdict for verdict in ruled if verdict.ruling is Ruling.MISPRINT]
    rest, found = [verdict for verdict in misprints if verdict.roots], {}
    while rest:
        root = max(Root, key=lambda one: sum(one in verdict.roots for verdict in rest))
        found[root] = [verdict.equation.number for verdict in misprints if root in verdict.roots]
        rest = [verdict for verdict in rest if root not in verdict.roots]
    return found


def explained(ruled: Sequence[Verdict]) -> str:
    """Return a text that says which root errors explain the misprints, and which come on top."""
    found = causes(ruled)
    parts = [f"{root} ({', '.join(numbers)})" for root, numbers in found.items()]
    for verdict in ruled:
        others = [root for root in verdict.roots if root not in found]
        parts += [f"besides, {root} ({verdict.equation.number})" for root in others if found]
    return f"the misprints have {len(found)} causes: {'; '.join(parts)}" if found else ""


def row(verdict: Verdict) -> tuple[str, str, str, str]:
    """Return the row of a verdict in the overview table."""
    point, misprint = verdict.counterexample, verdict.ruling == Ruling.MISPRINT
    shown = in_unicode(verdict.equation.repair) if misprint else verdict.equation.reading
    fails = "" if point is None else str(point.motion) if point.motion else _values(point)
    return f"({verdict.equation.number})", _ruling(verdict), shown, fails


def details(verdict: Verdict) -> Iterator[tuple[str, str]]:
    """Yield each detail of a verdict as a label and a text."""
    equation = verdict.equation
    yield "printed", in_unicode(equation.latex)
    yield "verdict", _ruling(verdict)
    yield "read as", equation.reading
    if equation.repair:
        yield "as derived", in_unicode(equation.repair)
    if verdict.ruling == Ruling.MISPRINT and verdict.conditions:
        yield "which holds if", ", ".join(verdict.conditions)
    for repair in verdict.repairs:
        yield "found by search", repair
    yield from (("root cause", root) for root in verdict.roots)
    for number in verdict.right_with:
        yield "right as printed", f"once ({number}) is mended"
    if found := verdict.counterexample:
        motion = [f"in the motion {found.motion}"] if found.motion else []
        yield "fails at", "\n".join([_values(found), *motion, *found.sides])
    for read in verdict.readings:
        fate = "holds" if read.holds else "fails"
        yield "reading", f"{read.reading.text}: {fate}; {read.reading.implies}"
    for flaw, text in equation.flaws.items():
        yield "flaw", f"{flaw}: {in_unicode(text) if flaw == Flaw.UNDEFINED else text}"
    needed = dict.fromkeys(name for by in verdict.needed_by.values() for name in by)
    every: dict[str, Collection[str]] = {
        "proved by": verdict.proved_by,
        "refuted by": verdict.refuted_by,
        "repaired by": verdict.repaired_by,
        "conditions needed by": needed,
    }
    yield from ((what, ", ".join(names)) for what, names in every.items() if names)


def _ruling(verdict: Verdict) -> str:
    conditional = verdict.ruling == Ruling.CONDITIONAL
    return " ".join((verdict.ruling, *([", ".join(verdict.conditions)] if conditional else [])))


def _values(found: Counterexample) -> str:
    return ", ".join(f"{name} = {value}" for name, value in found.point.items())
