"""A verdict as one row of text: equation, verdict and flaws, cause, what mends it, a point."""

from collections.abc import Iterator

from rigidsym.proof.paper.counterexample import Counterexample
from rigidsym.proof.paper.verdicts import Ruling, Verdict


def row(verdict: Verdict) -> tuple[str, str, str, str, str]:
    """The five columns of `rigidsym errata`."""
    point = verdict.counterexample
    return (
        f"({verdict.equation.number})",
        "\n".join(_ruling(verdict)),
        "\n".join(verdict.roots),
        "\n".join(_explanation(verdict)),
        "\n".join(_point(point)) if point else "",
    )


def _ruling(verdict: Verdict) -> Iterator[str]:
    conditional = verdict.ruling == Ruling.CONDITIONAL
    yield " ".join((verdict.ruling, *([", ".join(verdict.conditions)] if conditional else [])))
    for flaw, text in verdict.equation.flaws.items():
        yield f"* {flaw}: {text}"


def _explanation(verdict: Verdict) -> Iterator[str]:
    equation = verdict.equation
    if verdict.ruling != Ruling.MISPRINT:
        yield equation.reading
    else:
        yield equation.repair
        if verdict.conditions:
            yield f"if {', '.join(verdict.conditions)}"
        yield from (f"found: {repair}" for repair in verdict.repairs)
    for number in verdict.right_with:
        yield f"right as printed once ({number}) is mended"
    for read in verdict.readings:
        fate = "holds" if read.holds else "fails"
        yield f"* {read.reading.text}: {fate}; {read.reading.implies}"


def _point(found: Counterexample) -> Iterator[str]:
    if found.motion:
        yield str(found.motion)
    yield from found.sides
    yield ", ".join(f"{name} = {value}" for name, value in found.point.items())
