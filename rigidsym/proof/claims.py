"""Facts with the hypotheses they rest on, as notebooks show them: hypotheses |- statement."""

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, is_dataclass
from itertools import chain
from typing import Any

from rigidsym.language.latex import (
    hypotheses,
    listed,
    point,
    statements,
    symbol,
    turnstile,
    word,
)
from rigidsym.view.html.cards import (
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

# More hypotheses than these go by the name of their context; more components are folded.
FEW = 4
MOST_ROWS = 40


@dataclass(frozen=True, slots=True)
class Claim:
    """A fact and its context, as a ledger has them in JSON; the context may be left open."""

    fact: Mapping[str, Any]
    context: Mapping[str, Any] | None = None

    @property
    def id(self) -> str:
        """The name of the fact."""
        return self.fact["id"]

    @property
    def grade(self) -> str:
        """How the statement is known."""
        return str(self.fact["grade"])

    @property
    def latex(self) -> str:
        """hypotheses |- statement, the hypotheses by their context's name where they are many."""
        kind = self.fact["kind"]
        return f"{self._assumed()} {turnstile(kind)} {listed(statements(self.fact))}"

    def _repr_latex_(self) -> str:
        return f"${self.latex}$"

    def _repr_html_(self) -> str:
        shown = statements(self.fact)
        first = rf"{word(self.fact['context'])} {turnstile(self.fact['kind'])} {shown[0]}"
        more = [formula(rf"\qquad {text}") for text in shown[1:]]
        rest = [folded(muted(counted(len(more) - FEW + 1, "more component")), *more[FEW - 1 :])]
        lines = [formula(first), *more[: FEW - 1], *(rest if len(more) >= FEW else [])]
        title = head(code(self.id), badge(self.grade), muted(_source(self.fact)))
        return card(title, *lines, *self._remarks(shown), *self._folds())

    def _assumed(self) -> str:
        parts = [*chain(*hypotheses(self.context).values())] if self.context else []
        by_name = not 0 < len(parts) <= FEW or self.fact["kind"] in ("model", "partition")
        return word(self.fact["context"]) if by_name else listed(parts)

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
        yield folded(summary, entries(_fold_row(*part) for part in parts.items()))
        if self.context["reading"]:
            named = ((math(_name(k)), text) for k, text in self.context["reading"].items())
            yield folded("what the names stand for", entries(named))


class Claims(Mapping[str, Claim]):
    """The facts of a ledger by their ids, each with its context."""

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
        """Those that name an equation of the paper as their source."""
        return Claims(c for c in self.values() if equation in c.fact["source"])

    def behind(self, verdict: Any) -> "Claims":
        """Those that a verdict rests on: what proves, refutes and repairs a printed equation."""
        return Claims(self[name] for name in verdict.facts())

    def _repr_html_(self) -> str:
        rows = [_row(claim) for claim in list(self.values())[:MOST_ROWS]]
        rest = len(self) - len(rows)
        more = [muted(f"and {rest} more")] if rest else []
        return card(head(counted(len(self), "fact")), table(("fact", "", "statement"), rows), *more)


def claims(ledger: Any = None) -> Claims:
    """The facts of a ledger: of the sealed one, of the kernel's, or of one as text or data."""
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
    """A fact of the kernel by itself, its hypotheses by the name of the context."""
    return Claim(asdict(fact))._repr_html_()


def _row(claim: Claim) -> tuple[Any, ...]:
    shown = statements(claim.fact)
    rest = [muted(f" and {len(shown) - 1} more")] if len(shown) > 1 else []
    return code(claim.id), badge(claim.grade), join(math(shown[0]), *rest)


def _fold_row(kind: str, lines: list[str]) -> tuple[Markup, Markup]:
    return muted(f"{kind}s"), join(*(formula(line) for line in lines))


def _name(name: str) -> str:
    return symbol(name).latex


def _source(fact: Mapping[str, Any]) -> str:
    numbers = [f"({x})" if x[:1].isdigit() else x for x in fact["source"]]
    return ", ".join((*numbers, fact["rule"]))


def load_ipython_extension(ipython: Any) -> None:
    """Let IPython show bare facts and ledgers of the kernel, which knows nothing of showing."""
    html = ipython.display_formatter.formatters["text/html"]
    html.for_type_by_name("rigidsym.proof.kernel.statement", "Fact", fact_html)
    html.for_type_by_name(
        "rigidsym.proof.kernel.ledger", "Ledger", lambda x: claims(x)._repr_html_()
    )
