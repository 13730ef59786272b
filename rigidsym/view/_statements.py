"""Contexts and facts of a ledger as paragraphs of an article.

A paragraph is a sentence with equations below it.  Its words, formulas and names have types of
their own, so that each format of an article can write them in its own way.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from textwrap import wrap
from typing import TYPE_CHECKING, Any, TypeAlias

from rigidsym.language import _latex as language
from rigidsym.language._expression import Name, names, parse
from rigidsym.language._lines import rows, width

if TYPE_CHECKING:
    from rigidsym.proof.kernel import Context, Fact

# The width of a line of LaTeX, in widths of a digit, and of a line of a terminal.
WIDE, COLUMNS = 62.0, 96
# A statement of more rows of LaTeX than these is shown in part.
MOST_ROWS = 24
# A context is described by earlier ones, if each of them says at least this much of it.
_LEAST_SHARED, _MOST_BASES = 4, 3
# The most exceptions with which an earlier context describes another one.
_MOST_EXCEPTIONS = 12
# A proof by more relations than these does not quote them.
_MOST_QUOTED = 3
# Conditions on quantities, as they are written.
_CONDITIONS = {"relation": "{} = 0", "unit": "{} != 0", "sign": "{} >= 0", "start": "{} = 0"}
NOTATION = {
    "jacobi_sn": ("jacobi_sn(u, m)", "Jacobi's elliptic function sn with the parameter m = k^2"),
    "jacobi_cn": ("jacobi_cn(u, m)", "Jacobi's elliptic function cn"),
    "jacobi_dn": ("jacobi_dn(u, m)", "Jacobi's elliptic function dn"),
    "jacobi_am": ("jacobi_am(u, m)", "Jacobi's amplitude; its sine is sn, its cosine cn"),
    "jacobi_argument": (
        "jacobi_argument(x, y, z)",
        "the argument at which Jacobi's functions sn, cn and dn are x, y and z",
    ),
    "elliptic_k": ("elliptic_k(m)", "the complete elliptic integral of the first kind"),
    "elliptic_pi": (
        "elliptic_pi(n, m)",
        "the elliptic integral of the third kind with 1 - n sin^2; with three arguments, the "
        "second is its upper end",
    ),
    "elliptic_j": (
        "elliptic_j(u, n, m)",
        "the integral of sn^2/(1 - n sn^2) from 0 to u, with the parameter m",
    ),
    "nome": ("nome(m)", "the nome of the parameter m, exp(-pi K(1 - m)/K(m))"),
    "arcsc": ("arcsc(x, m)", "the inverse of sn/cn"),
    "arcsn": ("arcsn(x, m)", "the inverse of sn"),
    **{
        f"theta{k}": (f"theta{k}(z, q)", f"Jacobi's theta function {k} with the nome q (DLMF 20.2)")
        for k in (1, 2, 3, 4)
    },
    **{
        f"dtheta{k}": (f"dtheta{k}(z, q)", f"the derivative of theta function {k} by z")
        for k in (1, 2, 3, 4)
    },
    "re": ("re(z)", "the real part of z"),
    "im": ("im(z)", "the imaginary part of z"),
}
"Functions that names are read as: how they are written, and what they are."


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula in LaTeX, and as text for a terminal."""

    latex: str
    text: str


@dataclass(frozen=True, slots=True)
class Code:
    """The name of a fact, of a context or of an operation.

    `anchor` is the place in the article where it is said what has this name.
    """

    name: str
    anchor: str = ""


def context_named(name: str) -> Code:
    """Return the name of a context, with the place where it is introduced."""
    return Code(name, f"context-{name}")


def fact_named(name: str) -> Code:
    """Return the name of a fact, with the place where it is stated."""
    return Code(name, f"fact-{name}")


# A name or a hypothesis of a context: its kind, and texts.
Item: TypeAlias = tuple[str, ...]
Words: TypeAlias = tuple[str | Formula | Code, ...]


@dataclass(frozen=True, slots=True)
class Paragraph:
    """A sentence, a list, equations below it, and sentences after them.

    `rows` are aligned rows of LaTeX and `texts` the same for a terminal.  `numbers` are those of
    the paper's equations.  `fact` is the id of the fact that proves it, `context` the name of the
    context that begins here.
    """

    sentence: Words
    entries: tuple[Words, ...] = ()
    rows: tuple[str, ...] = ()
    texts: tuple[str, ...] = ()
    after: tuple[Words, ...] = ()
    numbers: str = ""
    fact: str = ""
    context: str = ""


def formula(text: str) -> Formula:
    """Return an expression or an equation of the ledger as a formula."""
    return Formula(language.condition(text) or language.latex(text), text)


def listed(parts: Iterable[str | Formula | Code], last: str = ", ") -> Words:
    """Join parts of a sentence by commas, and the last two by another word."""
    found = [*parts]
    between = [*[", "] * (len(found) - 2), last][: max(len(found) - 1, 0)]
    pairs = zip_longest(found, between)
    return tuple(x for pair in pairs for x in pair if x is not None)


def aligned_rows(equations: Iterable[tuple[str, str, str]]) -> list[str]:
    """Return equations in LaTeX as aligned rows, none of which is too wide.

    An equation is its left side, its sign and its right side.  A long left side stands in the
    column of the right ones, so that it does not move them.
    """
    found = [*equations]
    short = [width(left) for left, _, _ in found if width(left) < WIDE / 3]
    room = WIDE - max(short, default=0.0) - 3.0
    return [row for left, sign, right in found for row in _aligned(left, sign, right, room)]


def _aligned(left: str, sign: str, right: str, room: float) -> list[str]:
    """Return an equation as aligned rows, with so much room on the right."""
    first, *others = rows(right, room)
    below = [rf"&\quad {row}" for row in others]
    if width(left) < WIDE / 3:
        return [f"{left} &{sign} {first}", *below]
    start, *more = rows(left, room)
    if not more and not below and width(left) + width(right) < room:
        return [f"&{left} {sign} {right}"]
    return [f"&{start}", *(rf"&\quad {row}" for row in more), rf"&\quad {sign} {first}", *below]


def text_rows(left: str, right: str, sign: str = "=") -> str:
    """Return an equation as lines of text."""
    lines = wrap(f"{left} {sign} {right}", COLUMNS, subsequent_indent="    ")
    return "\n".join(lines)


# Contexts


def notation(contexts: Iterable["Context"]) -> list[Words]:
    """Return what the functions are that the names of contexts are read as."""
    called: set[str] = set()
    for context in contexts:
        for text in (*context.reading.values(), *context.thetas.values()):
            called |= {*re.findall(r"\w+(?=\()", text)} if _is_formula(text) else set()
    return [
        (formula(form), f": {said}") for name, (form, said) in NOTATION.items() if name in called
    ]


@dataclass(frozen=True, slots=True)
class Description:
    """What is said of a context: by contexts that came before, and what is new.

    It has what `bases` say, but what the first of them says of `names`, and its `conditions`.
    """

    bases: tuple["Context", ...] = ()
    names: tuple[str, ...] = ()
    conditions: tuple[Item, ...] = ()
    new: tuple[Item, ...] = ()


def introduction(
    context: "Context", known: Iterable["Context"], hidden: Iterable[str] = ()
) -> Iterator[Paragraph]:
    """Yield the paragraphs that define the names of a context and state its hypotheses.

    known: contexts that have been introduced; what they say is not said again.
    hidden: definitions that need not be shown, such as entries of matrices.
    """
    found = described(context, known)
    yield Paragraph(_opening(context, found), context=context.name)
    yield from _names(context, found.new)
    yield from _displays(context, found.new, {*hidden})
    yield from _rates(context, found.new)


def _opening(context: "Context", found: Description) -> Words:
    """Return the sentence that begins a context."""
    instant = "" if context.rates is not None else ", at one instant"
    said: Words = ()
    for base in found.bases[:1]:
        said = (": all that is said of ", context_named(base.name))
        if found.names:
            said = (*said, ", except for ", *listed(map(formula, found.names), " and "))
        if found.conditions:
            forms = [_CONDITIONS[kind].format(text) for kind, text in found.conditions]
            said = (*said, ", without ", *listed(map(formula, forms), " and "))
    if others := [context_named(base.name) for base in found.bases[1:]]:
        said = (*said, ", and all that is said of ", *listed(others, " and "))
    more = ", and" if found.bases and found.new else ""
    return ("Context ", Code(context.name), instant, *said, f"{more}:" if found.new else ".")


def described(context: "Context", known: Iterable["Context"]) -> Description:
    """Describe a context by those that have been introduced, and by what is new."""
    left, told = {*items(context)}, [*known]
    found = Description()
    best = max(told, key=lambda other: _gain(other, context), default=None)
    if best is not None and _gain(best, context) >= _LEAST_SHARED:
        found = Description((best,), *_differences(best, context))
        left -= taken(best, found.names)
    exact = [other for other in told if not any(_differences(other, context))]
    while exact and 0 < len(found.bases) < _MOST_BASES:
        best = max(exact, key=lambda other: len({*items(other)} & left))
        if len({*items(best)} & left) < _LEAST_SHARED:
            break
        found = replace(found, bases=(*found.bases, best))
        left -= {*items(best)}
    return replace(found, new=tuple(item for item in items(context) if item in left))


def _gain(other: "Context", context: "Context") -> int:
    """Return how much shorter a context is described by another one."""
    names, conditions = _differences(other, context)
    cost = len(names) + len(conditions)
    shared = len(taken(other, names) & {*items(context)})
    return shared - 3 * cost if cost <= _MOST_EXCEPTIONS else 0


def _differences(other: "Context", context: "Context") -> tuple[tuple[str, ...], tuple[Item, ...]]:
    """Return the names of which another context says something else, and its other conditions.

    Meanings may be left out here.  At one instant nothing is said of time derivatives.
    """
    here = {*items(context)}
    names = {item[1]: None for item in items(other) if _is_other(item, here, context)}
    if other.rates is not None:  # its other names are constant
        moving = (name for name in context.rates or {} if name in other.generators)
        names |= dict.fromkeys(name for name in moving if name not in other.rates)
    conditions = (item for item in items(other) if item[0] in _CONDITIONS and item not in here)
    return tuple(names), tuple(dict.fromkeys(conditions))


def _is_other(item: Item, here: set[Item], context: "Context") -> bool:
    """Return whether what another context says of a name does not hold here."""
    kind, name = item[:2]
    if kind in _CONDITIONS or item in here:
        return False
    if kind == "meaning":
        return name in context.reading
    return kind != "rate" or context.rates is not None


def taken(other: "Context", names: Iterable[str]) -> set[Item]:
    """Return what a context says, except of some names."""
    excepted = {*names}
    return {x for x in items(other) if x[0] in _CONDITIONS or x[1] not in excepted}


def items(context: "Context") -> list[Item]:
    """Return the names and hypotheses of a context, in order."""
    names = (*context.generators, *context.definitions)
    return [
        *(("name", name) for name in context.generators),
        *(("meaning", x, context.reading[x]) for x in names if x in context.reading),
        *(("theta", name, text) for name, text in context.thetas.items()),
        *(("definition", name, text) for name, text in context.definitions.items()),
        *(("relation", text) for text in context.relations),
        *(("unit", text) for text in context.units),
        *(("sign", text) for text in context.nonnegative),
        *(("start", text) for text in context.start),
        *(("rate", name, text) for name, text in (context.rates or {}).items()),
    ]


def _names(context: "Context", new: Sequence[Item]) -> Iterator[Paragraph]:
    """Yield what the names of a context mean, and which have no meaning of their own."""
    meant = {**context.thetas, **context.reading}
    fresh = {item[1] for item in new if item[0] in ("name", "theta", "meaning")}
    new_meanings = {name: text for name, text in meant.items() if name in fresh}
    entries = [_entry(name, text) for name, text in new_meanings.items()]
    if entries:
        yield Paragraph((), entries=tuple(entries))
    free = [item[1] for item in new if item[0] == "name" and item[1] not in meant]
    own = {*context.generators, *context.definitions, "I", "pi"}
    texts = (text for text in new_meanings.values() if _is_formula(text))
    other = dict.fromkeys(x for text in texts for x in names(parse(text)) if x not in own)
    if found := [*dict.fromkeys((*free, *other))]:
        yield Paragraph(
            (
                *listed(map(formula, found), " and "),
                f" {'are' if found[1:] else 'is'} arbitrary, within what follows.",
            )
        )


def _entry(name: str, meaning: str) -> Words:
    """Return a name with what it means: a formula, or words."""
    if not _is_formula(meaning):
        return (formula(name), f": {meaning}")
    shown = formula(name)
    meant = formula(meaning)
    if _bare(shown.latex) == _bare(meant.latex):  # cos_phi1 is printed as the cosine that it is
        return (Formula(shown.latex, f"{name} = {meaning}"),)
    return (Formula(f"{shown.latex} = {meant.latex}", f"{name} = {meaning}"),)


def _bare(latex: str) -> str:
    return re.sub(r"[{}\s]", "", latex)


def _is_formula(text: str) -> bool:
    """Return whether the meaning of a name is a formula and not words."""
    try:
        tree = parse(text)
    except (ValueError, SyntaxError):
        return False
    return not isinstance(tree, Name) or len(text) < _LEAST_SHARED


def _displays(context: "Context", new: Sequence[Item], hidden: set[str]) -> Iterator[Paragraph]:
    """Yield the definitions, relations and conditions of a context."""
    of_kind = {kind: [x for x in new if x[0] == kind] for kind in ("definition", "relation")}
    shown = [(name, text) for _, name, text in of_kind["definition"] if name not in hidden]
    if shown:
        how: dict[tuple[str, ...], list[str]] = {}
        for name, _ in shown:
            if done := operations([context.definitions[name]]):
                how.setdefault(done, []).append(name)
        parts = [
            (*listed(map(formula, names), " and "), " by ", *listed(map(Code, done)))
            for done, names in how.items()
        ]
        said = (x for k, part in enumerate(parts) for x in ("; " if k else "Computed: ", *part))
        after = ((*said, "."),) if parts else ()
        yield _display(("Definitions:",), shown, after=after)
    if of_kind["relation"]:
        pairs = [(text, "0") for _, text in of_kind["relation"]]
        yield _display(("Relations:",), pairs)
    for kind in ("unit", "sign", "start"):
        texts = [item[1] for item in new if item[0] == kind]
        if texts:
            head = "At one instant " if kind == "start" else "With "
            found = [formula(_CONDITIONS[kind].format(text)) for text in texts]
            if max(width(x.latex) for x in found) < WIDE / 2:
                yield Paragraph((head, *listed(found, " and "), "."))
            else:
                sign = {"unit": r"\neq", "sign": r"\geq", "start": "="}[kind]
                yield _display((f"{head.strip()}:",), [(text, "0") for text in texts], sign)


def _rates(context: "Context", new: Sequence[Item]) -> Iterator[Paragraph]:
    """Yield the time derivatives of the names of a context."""
    if (along := derived_by(context)) is not None:
        yield Paragraph(("The derivative here is the one with respect to ", formula(along), "."))
        return
    rates = {item[1]: item[2] for item in new if item[0] == "rate"}
    known = {name: text for name, text in rates.items() if text != "?"}
    unknown = [formula(name) for name, text in rates.items() if text == "?"]
    if unknown:
        yield Paragraph(("Nothing is said on the rates of ", *listed(unknown, " and "), "."))
    if known:
        pairs = [(f"D({name})", text) for name, text in known.items()]
        said = (
            "Time derivatives"
            if len(rates) == len(context.rates or {})
            else "More time derivatives"
        )
        yield _display((f"{said}; other names without a definition are constant:",), pairs)


def derived_by(context: "Context") -> str | None:
    """Return the name by which a context differentiates, or None if it is the time."""
    rates = context.rates or {}
    (name,) = rates if len(rates) == 1 else (None,)
    return name if name not in (None, "t") and rates[str(name)] == "1" else None


def _display(
    sentence: Words,
    pairs: Iterable[tuple[str, str]],
    sign: str = "=",
    after: tuple[Words, ...] = (),
) -> Paragraph:
    """Return a paragraph with equations of the ledger."""
    pairs = [*pairs]
    shown = aligned_rows((_whole(x), sign, _whole(y)) for x, y in pairs)
    plain = {r"\neq": "!=", r"\geq": ">="}.get(sign, sign)
    texts = tuple(text_rows(x, y, plain) for x, y in pairs)
    return Paragraph(sentence, (), tuple(shown), texts, after)


def _whole(text: str, along: str | None = None) -> str:
    """Return an expression in LaTeX with all terms of its sums."""
    return language.latex(text, along, most=None)


# Facts


def operations(texts: Iterable[str]) -> tuple[str, ...]:
    """Return the operations by which texts of a ledger were computed."""
    origins = (getattr(text, "origin", None) for text in texts)
    found = (x for origin in origins if origin is not None for x in origin.operations)
    return tuple(dict.fromkeys(x.lstrip("_") for x in found))


def stated(fact: "Fact", context: "Context", shown: set[str]) -> Paragraph:
    """Return the paragraph that states a fact.

    shown: facts that the article has stated, so that they need not be repeated elsewhere.
    """
    if fact.kind == "model":
        (other,) = fact.rhs
        sentence = (
            "All hypotheses of ",
            context_named(other),
            " hold in ",
            context_named(fact.context),
        )
        return Paragraph((*sentence, ", so what is proved there holds here."), fact=fact.id)
    if fact.kind == "partition":
        cases = listed(map(context_named, fact.rhs), " and ")
        sentence = (
            "Each point of ",
            context_named(fact.context),
            " lies in exactly one of ",
            *cases,
        )
        return Paragraph((*sentence, ", by the sign of ", formula(fact.lhs[0]), "."), fact=fact.id)
    if fact.rule == "transfer":
        first = fact.premises[0]
        if first in shown:
            sentence = (fact_named(first), " holds here, too.")
            return Paragraph(sentence, numbers=numbers(fact.source), fact=fact.id)
    found, left_out = _statement(fact, derived_by(context))
    after = [*_grounds(fact, context)]
    if left_out:
        more = f"And {left_out} more {'component' if left_out == 1 else 'components'}."
        after.insert(0, (more,))
    return replace(
        found,
        sentence=_head(fact),
        after=tuple(after),
        numbers=numbers(fact.source),
        fact=fact.id,
    )


def _statement(fact: "Fact", along: str | None) -> tuple[Paragraph, int]:
    """Return the equations of a fact, and how many of its components are left out.

    along: the name by which its context differentiates, if it is not the time.
    """
    every = dict.fromkeys(zip(fact.lhs, fact.rhs, strict=True))
    pairs = [pair for pair in every if pair[0] != pair[1]] or [*every]
    sign = {"unequal": r"\neq"}.get(fact.kind, "=")
    equations: list[tuple[str, str, str]] = []
    texts: list[str] = []
    for count, (left, right) in enumerate(pairs):
        value, plain = _whole(right, along), right
        if fact.kind == "root":
            value, plain = rf"\sqrt{{{value}}}", f"sqrt({right})"
        if fact.kind == "nonnegative":
            value, plain = rf"{value} \geq 0", f"{right} >= 0"
        more = (_whole(left, along), sign, value)
        if equations and len(aligned_rows([*equations, more])) > MOST_ROWS:
            return Paragraph((), (), tuple(aligned_rows(equations)), tuple(texts)), len(
                pairs
            ) - count
        equations.append(more)
        texts.append(text_rows(left, plain, "!=" if fact.kind == "unequal" else "="))
    return Paragraph((), (), tuple(aligned_rows(equations)), tuple(texts)), 0


def _head(fact: "Fact") -> Words:
    """Return the sentence before the equations of a fact: where its statement comes from."""
    texts = (*fact.lhs, *fact.rhs)
    if fact.kind == "unequal":
        return ("This does not hold:",)
    if fact.rule == "assumption":
        return (f"Taken from the literature, {fact.certificate['reference']}:",)
    if done := operations(texts):
        return ("Computed by ", *listed(map(Code, done)), ":")
    if all(type(text).__name__ == "Printed" for text in texts):
        return ("As it is printed:",)
    why: dict[str, None] = dict.fromkeys(getattr(text, "why", "") for text in texts)
    if said := "; ".join(filter(None, why)):
        law = any(type(text).__name__ == "Law" for text in texts)
        return (f"{'A law that holds' if law else 'Typed, and then proved'} ({said}):",)
    return ("Proved:",)


def _grounds(fact: "Fact", context: "Context") -> Iterator[Words]:
    """Yield the sentences on what a fact is proved by."""
    certificate: Mapping[str, Any] = fact.certificate
    match fact.rule:
        case "identity":
            used = _used(certificate["cofactors"], len(context.relations))
            relations = [formula(f"{context.relations[k]} = 0") for k in used]
            short = max((width(x.latex) for x in relations), default=0.0) < WIDE / 2
            if 0 < len(relations) <= _MOST_QUOTED and short:
                yield ("This uses ", *listed(relations, " and "), ".")
            elif relations:
                yield (f"This uses {len(relations)} of the {len(context.relations)} relations.",)
        case "counterexample":
            point = certificate["point"].items()
            yield ("It fails at ", *listed(formula(f"{k} = {v}") for k, v in point), ".")
        case "theta":
            forms = [formula(f"{k} = {v}") for k, v in certificate["forms"].items()]
            yield ("An addition theorem of theta functions, with ", *listed(forms, " and "), ".")
        case "start":
            yield ("Both sides are equal at one instant, and so are their time derivatives.",)
        case "transfer":
            yield ("Carried over from ", Code(fact.premises[0].split(".")[0]), ".")
        case "assumption" if certificate["points"]:
            points = len(certificate["points"])
            yield (f"It is not proved; balls enclose both sides at {points} points.",)
    if fact.kind == "root":
        yield ("The squares are equal, and the left side is not negative.",)


def _used(cofactors: Sequence[Sequence[str]], count: int) -> list[int]:
    """Return the indices of the relations of a context that a proof uses."""
    return [k for k in range(count) if any(len(row) > k and row[k] != "0" for row in cofactors)]


def numbers(source: Iterable[str]) -> str:
    """Return the numbers of the paper's equations, such as "(31), (32)", and other sources."""
    return ", ".join(f"({x})" if x[:1].isdigit() else x for x in source)
