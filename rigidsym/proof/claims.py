"""Facts of a ledger with their hypotheses, as displayed in notebooks."""

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, is_dataclass
from itertools import chain
from typing import Any

from rigidsym.language._latex import (
    hypotheses,
    listed,
    point,
    statements,
    symbol,
    turnstile,
    word,
)
from rigidsym.view._cards import (
    Markup,
    badge,
    card,
    code,
    counted,
    entries,
    folded,
    formula,
    formulas,
    head,
    join,
    math,
    muted,
    table,
)

# The largest numbers of hypotheses and of components that are shown in full.
FEW = 4
MOST_ROWS = 40


@dataclass(frozen=True, slots=True)
class Claim:
    """A fact of a ledger in JSON form, optionally with its context."""

    fact: Mapping[str, Any]
    context: Mapping[str, Any] | None = None

    @property
    def id(self) -> str:
        """The id of the fact."""
        return self.fact["id"]

    @property
    def grade(self) -> str:
        """The grade of the fact: PROVED, ENCLOSED or ASSUMED."""
        return str(self.fact["grade"])

    @property
    def latex(self) -> str:
        """LaTeX of the fact in the form hypotheses |- statement.

        The context's name replaces many hypotheses.
        """
        kind = self.fact["kind"]
        parts = [*chain(*hypotheses(self.context).values())] if self.context else []
        by_name = not 0 < len(parts) <= FEW or kind in ("model", "partition")
        assumed = word(self.fact["context"]) if by_name else listed(parts)
        return f"{assumed} {turnstile(kind)} {listed(statements(self.fact))}"

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"

    def _repr_html_(self) -> str:
        shown = statements(self.fact)
        first = rf"{word(self.fact['context'])} {turnstile(self.fact['kind'])} {shown[0]}"
        more = [formula(rf"\qquad {text}") for text in shown[1:]]
        rest = [folded(muted(counted(len(more) - FEW + 1, "more component")), *more[FEW - 1 :])]
        lines = [formula(first), *more[: FEW - 1], *(rest if len(more) >= FEW else [])]
        source = [f"({x})" if x[:1].isdigit() else x for x in self.fact["source"]]
        origin = ", ".join((*source, self.fact["rule"]))
        title = head(code(self.id), badge(self.grade), muted(origin))
        return card(title, *lines, *self._remarks(shown), *self._folds())

    def _remarks(self, shown: list[str]) -> Iterator[Markup]:
        left_out = len(self.fact["lhs"]) - len(shown)
        if self.fact["kind"] not in ("model", "partition") and left_out:
            yield muted(f"and {counted(left_out, 'more component')}, alike or there already")
        if any(r"\cdots" in text for text in shown):
            yield join(" ", muted("long sums are shown in part"))
        if self.fact["kind"] == "unequal":
            yield join(muted("at"), formulas(point(self.fact["certificate"]["point"])))

    def _folds(self) -> Iterator[Markup]:
        if self.context is None:
            return
        parts = {kind: lines for kind, lines in hypotheses(self.context).items() if lines}
        counts = ", ".join(counted(len(lines), kind) for kind, lines in parts.items())
        summary = join("hypotheses of ", code(self.fact["context"]), muted(f" {counts or 'none'}"))
        rows = ((muted(f"{k}s"), join(*map(formula, lines))) for k, lines in parts.items())
        yield folded(summary, entries(rows))
        if self.context["reading"]:
            named = ((math(symbol(k).latex), x) for k, x in self.context["reading"].items())
            yield folded("what the names stand for", entries(named))


class Claims(Mapping[str, Claim]):
    """Mapping from ids to the facts of a ledger, each with its context."""

    def __init__(self, found: Iterable[Claim]) -> None:
        self._found = {claim.id: claim for claim in found}

    def __getitem__(self, fact_id: str) -> Claim:
        return self._found[fact_id]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def __repr__(self) -> str:
        return f"<Claims: {counted(len(self), 'fact')}>"

    def citing(self, equation: str) -> "Claims":
        """Return the facts that cite an equation of the paper as their source."""
        return Claims(c for c in self.values() if equation in c.fact["source"])

    def behind(self, verdict: Any) -> "Claims":
        """Return the facts that support a verdict on a printed equation."""
        return Claims(self[name] for name in verdict.facts())

    def _repr_html_(self) -> str:
        rows = []
        for claim in list(self.values())[:MOST_ROWS]:
            first, *others = statements(claim.fact)
            note = [muted(f" and {len(others)} more")] if others else []
            rows.append((code(claim.id), badge(claim.grade), join(math(first), *note)))
        rest = len(self) - len(rows)
        more = [muted(f"and {rest} more")] if rest else []
        return card(head(counted(len(self), "fact")), table(("fact", "", "statement"), rows), *more)


def claims(ledger: Any = None) -> Claims:
    """Return the facts of a ledger.

    Without an argument, they are the facts of the sealed ledger.
    The ledger is the kernel's, or JSON as text or data.
    """
    data = _data(ledger)
    contexts = {context["name"]: context for context in data["contexts"]}
    return Claims(Claim(fact, contexts[fact["context"]]) for fact in data["facts"])


def _data(ledger: Any) -> Mapping[str, Any]:
    if ledger is None:
        from rigidsym.io.ledger import ledger_text

        return json.loads(ledger_text())
    if is_dataclass(ledger):
        found: Any = ledger
        return {
            "contexts": [asdict(context) for context in found.contexts.values()],
            "facts": [asdict(fact) for fact in found.facts.values()],
        }
    return json.loads(ledger) if isinstance(ledger, str) else ledger


def fact_html(fact: Any) -> str:
    """Return an HTML card for a fact of the kernel."""
    return Claim(asdict(fact))._repr_html_()


def load_ipython_extension(ipython: Any) -> None:
    """Register HTML displays for the kernel's facts and ledgers in IPython."""
    html = ipython.display_formatter.formatters["text/html"]
    html.for_type_by_name("rigidsym.proof.kernel._rules", "Fact", fact_html)
    html.for_type_by_name(
        "rigidsym.proof.kernel._rules", "Ledger", lambda x: claims(x)._repr_html_()
    )
