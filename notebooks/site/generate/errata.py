"""The errata: every printed equation with its verdict, as the ledger gives it."""

import re
from collections.abc import Iterator, Mapping

from generate.text import code, plain, table
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.proof.paper import Counterexample, Flaw, Ruling, Verdict, judged, verdicts

_HEAD = """# The paper's errata

Everything the paper prints, equation by equation, with the verdict that the ledger gives. This page
is made from the verdicts of `rigidsym errata`; nothing on it is written by hand but these lines.
"""
MEANINGS = {
    Ruling.HOLDS: "proved as it is printed",
    Ruling.CONDITIONAL: "proved under a condition, which is shown to be necessary",
    Ruling.MISPRINT: "false as printed: an exact counterexample, and a proved repair",
    Ruling.AMBIGUOUS: "true in one reading and false in another",
    Ruling.OPEN: "neither proved nor refuted",
}


def page() -> str:
    """An overview, and a section for each equation."""
    ruled = verdicts(ledger_data(ledger_text()))
    return "\n".join([_HEAD, _overview(ruled), *map(_section, ruled), _prose()])


def _prose() -> str:
    """The paper's claims in words."""
    rows = (
        (
            plain(found.prose.claim),
            found.judgement,
            plain(found.prose.reason),
            ", ".join(map(code, (*found.facts, *found.prose.commands))),
        )
        for found in judged(ledger_data(ledger_text()))
    )
    head = "## Claims in words\n\nThese are judgements; what they rest on is named.\n"
    return f"{head}\n{table(('the paper says', 'judged', 'because', 'decided by'), rows)}\n"


def _overview(ruled: list[Verdict]) -> str:
    rows = [
        (badge(ruling), f"{len(found)}: {meaning}", ", ".join(map(_link, found)))
        for ruling, meaning in MEANINGS.items()
        if (found := [verdict for verdict in ruled if verdict.ruling == ruling])
    ]
    return table(("verdict", "", "where"), rows)


def badge(ruling: Ruling) -> str:
    """The verdict as a coloured word."""
    return f"{{bdg-{ruling.name.lower()}}}`{ruling.value}`"


def _link(verdict: Verdict) -> str:
    return f"[{title(verdict)}](#{label(verdict)})"


def label(verdict: Verdict) -> str:
    """What links to an equation's section name."""
    kept = "".join(x if x.isalnum() else "-" for x in verdict.equation.number.lower())
    return f"printed-{kept}"


def title(verdict: Verdict) -> str:
    """What an equation is called."""
    number = verdict.equation.number
    if number[0].isdigit():
        return f"({number})"
    return number.replace("R^-1 dR/dt", "The display before (30)")


def _section(verdict: Verdict) -> str:
    return (
        "\n\n".join(
            [
                f"({label(verdict)})=\n## {title(verdict)} {badge(verdict.ruling)}",
                *_parts(verdict),
            ]
        )
        + "\n"
    )


def _parts(verdict: Verdict) -> Iterator[str]:
    equation = verdict.equation
    yield display(equation.latex)
    if equation.reading:
        yield plain(f"{_capital(equation.reading)}.")
    if equation.repair:
        yield "**Repaired:**"
        yield display(equation.repair)
    if verdict.repairs:
        yield f"Found by search: {', '.join(map(code, verdict.repairs))}."
    if verdict.conditions:
        yield f"**Where:** {', '.join(map(code, verdict.conditions))}."
    for number in verdict.right_with:
        yield f"**Right as printed** once ({number}) is mended."
    if verdict.roots:
        yield f"**Root cause:** {plain('; '.join(verdict.roots))}."
    if verdict.counterexample:
        yield _fails(verdict.counterexample)
    if equation.flaws:
        yield "\n".join(map(_flaw, equation.flaws.items()))
    if verdict.readings:
        yield _readings(verdict)
    yield _facts(verdict)


def _flaw(item: tuple[Flaw, str]) -> str:
    """A flaw as an entry of a list; of a symbol that is not defined, the symbol."""
    flaw, text = item
    shown = f"${text}$" if flaw == Flaw.UNDEFINED else plain(text)
    return f"* {_capital(flaw.value)}: {shown}."


def _readings(verdict: Verdict) -> str:
    rows = (
        (plain(r.reading.text), "holds" if r.holds else "fails", plain(r.reading.implies))
        for r in verdict.readings
    )
    return table(("read so", "it", "which means"), rows)


def _point(point: Mapping[str, str]) -> str:
    return ", ".join(code(f"{name} = {value}") for name, value in point.items())


def _fails(found: Counterexample) -> str:
    """Where a line fails: both sides there, the motion, and the point."""
    sides = ", ".join(map(code, found.sides))
    motion = f" in the motion {code(str(found.motion))}" if found.motion else ""
    return f"**Fails as printed**{motion}, where {sides}: at {_point(found.point)}."


def _facts(verdict: Verdict) -> str:
    needed = tuple(dict.fromkeys(name for by in verdict.needed_by.values() for name in by))
    every = {
        "proved by": verdict.proved_by,
        "refuted by": verdict.refuted_by,
        "repaired by": verdict.repaired_by,
        "conditions needed by": needed,
    }
    said = [f"{words} {', '.join(map(code, ids))}" for words, ids in every.items() if ids]
    wrong = ", ".join(f"{count} {fate}" for fate, count in verdict.mutants.items())
    mutants = [f"made wrong on purpose: {wrong}"] if wrong else []
    return f":::{{container}} facts\n{_capital('; '.join([*said, *mutants]))}.\n:::"


def display(latex: str) -> str:
    """Formulas in one line where there is room, and else below each other."""
    shown = "\n\n".join(f"$$\n{part}\n$$" for part in statements(latex))
    return f":::{{container}} statements\n{shown}\n:::"


_OPENING = re.compile(r"\\(?:begin|left)\b|[{(\[]")
_MARK = re.compile(r"\\(?:begin|left|end|right)\b[(){}\[\].|]?|[(){}\[\]]|[,;]\\ ")


def statements(latex: str) -> list[str]:
    """The parts of a line of formulas, divided after commas that no bracket surrounds."""
    parts, depth, begin = [], 0, 0
    for found in _MARK.finditer(latex):
        if found[0][0] not in ",;":
            depth += 1 if _OPENING.match(found[0]) else -1
            # The brace of an environment's name closes by itself.
            depth += found[0].endswith("{") and len(found[0]) > 1
        elif not depth:
            parts.append(latex[begin : found.end() - 2])
            begin = found.end()
    return [*parts, latex[begin:]]


def _capital(text: str) -> str:
    return text if text[:1] in "`(" else text[:1].upper() + text[1:]
