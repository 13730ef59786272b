"""A verdict as one row of text: equation, verdict and flaws, what mends or explains it, a point."""

from collections.abc import Iterator

from rigidsym.proof.paper.verdicts import Ruling, Verdict


def row(verdict: Verdict) -> tuple[str, str, str, str]:
    """The four columns of `rigidsym errata`."""
    point = (verdict.counterexample or {}).items()
    return (
        f"({verdict.equation.number})",
        "\n".join(_ruling(verdict)),
        "\n".join(_explanation(verdict)),
        ", ".join(f"{name} = {value}" for name, value in point),
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
    for reading in equation.readings:
        yield f"* {reading.text}: {'fails' if reading.refuted_by else 'holds'}; {reading.implies}"
