"""What notebooks alone need: books and ledgers to read from, and ways to show what is in them.

Nothing is derived here.  Statements come from the ledger of a builder, in which chapters of
`derivations` ran, or from the sealed one, replayed; `steps` has what shows the lines of a builder.
"""

from collections.abc import Iterable, Mapping
from importlib import import_module
from typing import Any

from IPython.display import HTML, Markdown, Math

from derivations import CHAPTERS
from derivations.setting import Setting
from rigidsym.io.ledger import ledger_data, ledger_text
from rigidsym.language._latex import latex, symbol
from rigidsym.proof.algebra._computation import plain
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.claims import Claim, claims
from rigidsym.proof.kernel import Grade, Ledger, replay
from rigidsym.proof.paper import EQUATIONS, Verdict, verdicts
from rigidsym.view._article import latex as in_letters
from support.steps import begun


def derived(*chapters: str) -> Ledger:
    """Run chapters of `derivations`, and those before the last of them, in a new ledger."""
    builder = begun(Setting())
    for name in CHAPTERS[: max(map(CHAPTERS.index, chapters)) + 1]:
        import_module(f"derivations.{name}").derive(builder)
    return builder.ledger


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


def judged() -> dict[str, Verdict]:
    """The verdicts on the printed equations by their numbers, as the sealed ledger has them."""
    return {v.equation.number: v for v in verdicts(ledger_data(ledger_text()))}


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
    """Two sides, SymPy's, a chapter's or LaTeX, as one displayed equation."""
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
    return side if isinstance(side, str) else in_letters(plain(side))
