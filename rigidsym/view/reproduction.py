"""What the main job found, as pages: the report, and the errata that it links."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from rigidsym.view.html.markup import Markup, join, tag
from rigidsym.view.markdown import table as markdown_table
from rigidsym.view.validation.document import document
from rigidsym.view.validation.table import column, row, table

CHAPTERS = ("chapter", "", "facts")
FILES = ("file", "what it is")


@dataclass(frozen=True, slots=True)
class Found:
    """What is told: whether all is well, sentences about it, and tables.

    chapters: name, title and number of facts.  modules: the digest of each generated file.
    motion: what the picture shows, and that picture as SVG.  versions: of what it ran with.
    """

    passed: bool
    sentences: Sequence[str]
    chapters: Sequence[tuple[str, str, str]]
    modules: Mapping[str, str]
    motion: tuple[str, str]
    versions: Mapping[str, str]

    @property
    def headline(self) -> str:
        """The verdict, in a sentence."""
        if self.passed:
            return "All that is claimed is proved, and the generated code is valid."
        return "NOT all that is claimed is proved, current and valid."


@dataclass(frozen=True, slots=True)
class Printed:
    """A printed equation: its number, the verdict, and what is said of it by what it is."""

    number: str
    verdict: str
    said: Sequence[tuple[str, str]]


def report_markdown(found: Found) -> str:
    """One page: what is proved, what the paper's equations are worth, how good the module is."""
    return "\n".join(
        [
            "# rigidsym reproduce",
            "",
            f"**{found.headline}**  Written by `rigidsym reproduce`; as a page of its own: "
            "[report.html](report.html).",
            "",
            *(f"* {sentence}" for sentence in found.sentences),
            "",
            found.motion[0],
            "",
            "![attitude and rates](motion.svg)",
            "",
            "## Proved",
            "",
            *markdown_table(CHAPTERS, found.chapters),
            "",
            "## Generated",
            "",
            *(f"* `{name}`, sha256 {digest}" for name, digest in found.modules.items()),
            "",
            "`numpy.map.json` and `c.map.json` give the equations of each line.",
            "",
            "## Versions",
            "",
            ", ".join(f"{name} {version}" for name, version in found.versions.items()) + ".",
            "",
        ]
    )


def report_page(found: Found) -> str:
    """The same as a page, which links what was measured and the errata."""
    word, kind = ("Passed", "passed") if found.passed else ("Failed", "failed")
    links = {
        "validation.html": "what was measured",
        "errata.html": "the paper's equations, one by one",
        "ledger.json": "the proofs, as certificates",
        **dict.fromkeys(found.modules, "generated code"),
    }
    told, drawing = found.motion
    # A document of its own begins with a size; in a page it is as wide as there is room.
    picture = Markup(drawing.replace("<svg ", '<svg style="max-width:100%;height:auto" ', 1))
    return document(
        f"rigidsym reproduce: {kind}",
        tag(
            "header",
            tag("p", "rigidsym reproduce", class_="kind"),
            tag("h1", tag("span", word, class_=f"verdict {kind}"), " ", found.headline),
            tag("ul", *(tag("li", sentence) for sentence in found.sentences)),
            tag("nav", *(tag("a", name, href=name) for name in links), aria_label="Files"),
        ),
        _section("The motion", tag("p", told), picture),
        _section("Proved", _table("Facts by chapter", CHAPTERS, found.chapters)),
        _section("Generated", _table("sha256", ("file", "digest"), found.modules.items())),
        _section("Files", _table("Beside this page", FILES, links.items())),
        _section("Versions", _table("What it ran with", ("", "version"), found.versions.items())),
    )


def errata_page(counted: str, printed: Iterable[Printed]) -> str:
    """Every printed equation with its verdict and all that is said of it."""
    return document(
        "rigidsym errata",
        tag(
            "header",
            tag("p", "rigidsym errata", class_="kind"),
            tag("h1", f"Of what the paper prints, {counted}."),
            tag("p", tag("a", "The report", href="report.html")),
        ),
        *(_printed(one) for one in printed),
    )


def _printed(one: Printed) -> Markup:
    head = tag("h2", f"({one.number}) ", tag("small", one.verdict))
    pairs = (tag("tr", row(name), tag("td", _broken(text))) for name, text in one.said)
    body = table(f"What is said of ({one.number})", [], pairs, "words")
    return tag("section", head, body)


def _broken(text: str) -> Markup:
    """Lines below each other."""
    first, *others = text.split("\n")
    return join(first, *(join(tag("br"), other) for other in others))


def _section(title: str, *children: object) -> Markup:
    return tag("section", tag("h2", title), *children)


def _table(caption: str, names: Sequence[str], rows: Iterable[Sequence[str]]) -> Markup:
    head = tag("tr", *map(column, names))
    cells = (tag("tr", row(first), *(tag("td", x) for x in rest)) for first, *rest in rows)
    return table(caption, [head], cells, "words")
