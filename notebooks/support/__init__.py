"""What notebooks alone need: books and ledgers to read from, and ways to show what is in them.

Nothing is derived here.  Steps come from a builder, whether the cells of a notebook or chapters of
`derivations` wrote it; statements from its ledger, or from the sealed one, replayed.
"""

from collections.abc import Iterable, Mapping
from importlib import import_module
from typing import Any

from IPython.display import HTML, Markdown, Math

from derivations import CHAPTERS, FORWARD
from derivations.setting import Setting
from rigidsym.io.ledger import ledger_text
from rigidsym.language._latex import latex, symbol
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.claims import Claim, claims
from rigidsym.proof.kernel import Grade, Ledger, replay
from rigidsym.proof.paper import EQUATIONS
from rigidsym.proof.steps import Step
from rigidsym.view._article import latex as in_letters
from rigidsym.view._article import line_html


def begun(setting: Setting, *chapters: str) -> LedgerBuilder:
    """A builder with this setting, and in it forward chapters up to the last of these."""
    builder = LedgerBuilder()
    builder.keep(setting)
    for name in FORWARD[: max(map(FORWARD.index, chapters), default=-1) + 1]:
        import_module(f"derivations.{name}").derive(builder)
    return builder


def derived(*chapters: str) -> Ledger:
    """Run chapters of `derivations`, and those before the last of them, in a new ledger."""
    builder = begun(Setting())
    for name in CHAPTERS[: max(map(CHAPTERS.index, chapters)) + 1]:
        import_module(f"derivations.{name}").derive(builder)
    return builder.ledger


def step(builder: LedgerBuilder, fact: str) -> Step:
    """The step of a builder that found a fact; KeyError where none did."""
    return {step.fact.id: step for step in builder.steps}[fact]


def lines(builder: LedgerBuilder, *numbers: str) -> HTML:
    """The steps of a builder that are about equations of the paper, under each other."""
    found = (step for step in builder.steps if {*step.source} & {*numbers})
    return HTML("\n".join(map(line_html, found)))


def sealed() -> Ledger:
    """The ledger that comes with the project, every certificate replayed in a fresh kernel."""
    return replay(ledger_text(), encloses)


def grades(ledger: Ledger, *facts: str) -> set[Grade]:
    """The grades that facts have in a ledger; KeyError for one that is not there."""
    return {ledger.facts[fact].grade for fact in facts}


def show(ledger: Ledger, *facts: str) -> HTML:
    """Facts of a ledger under each other, as each shows itself; the hypotheses that several have
    in common come with the first."""
    found = claims(ledger)
    first = {ledger.facts[fact].context: fact for fact in reversed(facts)}
    shown = (found[x] if x in first.values() else Claim(found[x].fact) for x in facts)
    return HTML("\n".join(claim._repr_html_() for claim in shown))


def printed(*numbers: str) -> HTML:
    """Equations of the paper under each other, exactly as printed."""
    found = {equation.number: equation for equation in EQUATIONS}
    return HTML("\n".join(found[number]._repr_html_() for number in numbers))


def definitions(ledger: Ledger, context: str, *names: str) -> Math:
    """What names abbreviate in a context."""
    defined = ledger.contexts[context].definitions
    lines = r" \\ ".join(rf"{symbol(n).latex} &= {latex(defined[n])}" for n in names)
    return Math(rf"\begin{{aligned}} {lines} \end{{aligned}}")


def equation(left: Any, right: Any) -> Math:
    """Two sides, SymPy's or LaTeX, as one displayed equation."""
    return Math(f"{_side(left)} = {_side(right)}")


def table(rows: Iterable[Mapping[str, Any]]) -> Markdown:
    """Rows with the same keys as a table."""
    listed = list(rows)
    lines = [
        list(listed[0]),
        ["---"] * len(listed[0]),
        *([*map(str, row.values())] for row in listed),
    ]
    return Markdown("\n".join(f"| {' | '.join(line)} |" for line in lines))


def _side(side: Any) -> str:
    return side if isinstance(side, str) else in_letters(side)
