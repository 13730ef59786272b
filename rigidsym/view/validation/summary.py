"""What is seen first: the verdict, the figures that count, and what went wrong."""

import math
from collections.abc import Iterator

from rigidsym.view.html.markup import Markup, join, tag
from rigidsym.view.report_data import Figure, Implementation, Report
from rigidsym.view.validation.cases import case, replay
from rigidsym.view.validation.figures import (
    counted,
    measures,
    number,
    plain,
    scientific,
    share,
)
from rigidsym.view.validation.source import cells, modules, passed, peers, worst


def summary(data: Report) -> Markup:
    """Verdict, implementations, worst figures, and the command that writes them."""
    verdict, word = ("passed", "Passed") if passed(data) else ("failed", "Failed")
    return tag(
        "header",
        tag("p", "rigidsym validation", class_="kind"),
        tag("h1", tag("span", word, class_=f"verdict {verdict}"), " ", _headline(data)),
        _told(data),
        tag("p", _comparison(data), class_="about") if peers(data) else "",
        tag("dl", *_tiles(data), class_="tiles"),
        tag("p", "Written by", class_="about"),
        replay(data["command"]),
        tag("dl", *_campaign(data), class_="facts"),
    )


def failures(data: Report) -> Markup:
    """What broke, in full; nothing where nothing did."""
    if passed(data):
        return Markup("")
    broken = [
        tag(
            "article",
            tag("h3", failure["line"]),
            tag("p", "The simplest case found that breaks it:"),
            case(data, failure["simplest"]),
        )
        for failure in data["failures"]
    ]
    told = {failure["line"] for failure in data["failures"]}
    others = [tag("h3", line) for line in data["complaints"] if line not in told]
    return tag("section", tag("h2", "Failures"), *broken, *others, id="failures", class_="failures")


def _headline(data: Report) -> str:
    names = [one["name"] for one in modules(data)]
    if passed(data):
        within = "stays" if len(names) == 1 else "stay"
        return f"{_listed(names)} {within} within every documented bound"
    count = len(data["complaints"])
    return f"{_listed(names)}: {count} {'failure' if count == 1 else 'failures'}"


def _told(data: Report) -> Markup:
    """What failed, a line each."""
    if passed(data):
        return Markup("")
    listed = (tag("li", tag("a", line, href="#failures")) for line in data["complaints"])
    return tag("ul", *listed, class_="told")


def _listed(names: list[str]) -> str:
    *first, last = names or ["nothing"]
    return f"{', '.join(first)} and {last}" if first else last


def _comparison(data: Report) -> Markup:
    """What peers come to, in the same cases."""
    found = (worst([one], "strata", "angle") for one in peers(data))
    listed = (_peer(name, cell["units"]) for name, _, cell in filter(None, found))
    return join("Beside them, for comparison, by worst angle error: ", *listed)


def _peer(name: str, figure: Figure) -> Markup:
    unit = " rad" if math.isfinite(number(figure)) else ""
    return tag("span", f"{name} {plain(figure)}{unit}", class_="peer")


def _tiles(data: Report) -> Iterator[Markup]:
    yield _worst(data, "Worst angle error", "angle", " rad")
    yield _worst(data, "Worst rate error", "omega", " relative")
    yield _tightest(data)
    yield _oracles(data)
    total = {key: sum(one[key] for one in data["strata"]) for key in ("cases", "states")}
    states = f"{total['states']:,} states in {len(data['strata'])} strata"
    yield _tile("Tested", f"{total['cases']:,} cases", states)


def _worst(data: Report, title: str, measure: str, unit: str) -> Markup:
    found = worst(modules(data), "strata", measure)
    if found is None:
        return _tile(title, "not measured", "")
    name, stratum, cell = found
    bound = data["bounds"][measure]
    part = number(cell["units"]) / bound
    remark = (
        f"{counted(cell['units'])}, {share(part)} of the bound {plain(bound)}; {name} in {stratum}"
    )
    return _tile(title, scientific(cell["units"]) + unit, remark, beyond=part > 1)


def _tightest(data: Report) -> Markup:
    """The bound that is nearest to being broken."""
    found = [
        (number(cell["units"]), measure, name, stratum)
        for measure in measures(data)
        for name, stratum, cell in cells(modules(data), "shares", measure)
    ]
    if not found:
        return _tile("Nearest to its bound", "not measured", "")
    part, measure, name, stratum = max(found)
    remark = f"{measure}; {name} in {stratum}"
    return _tile("Nearest to its bound", share(part), remark, beyond=part > 1)


def _oracles(data: Report) -> Markup:
    """How far the two ways to the truth are apart."""
    title, allowed = "Oracles differ by", data["agreement"]
    apart = [(number(one["disagreement"]), one["name"]) for one in data["strata"]]
    if not apart:
        return _tile(title, "not compared", "")
    part, name = max(apart)
    shown = "not compared" if part == float("inf") else f"{part * allowed:.2g}"
    return _tile(title, shown, f"at most, of {allowed:g} allowed; {name}", beyond=part > 1)


def _tile(title: str, shown: str, remark: str, *, beyond: bool = False) -> Markup:
    value = tag("dd", shown, class_="value beyond" if beyond else "value")
    return tag("div", tag("dt", title), value, tag("dd", remark))


def _campaign(data: Report) -> Iterator[Markup]:
    """Who was measured, and what makes the same campaign again."""
    whole = data["campaign"]
    facts = [("version", whole["version"]), ("seed", whole["seed"]), ("digits", whole["digits"])]
    facts += [(f"module {one['name']}", _digest(one)) for one in modules(data)]
    for name, value in facts:
        yield tag("div", tag("dt", name), tag("dd", value))


def _digest(one: Implementation) -> Markup:
    digest = one["digest"] or ""
    return join(tag("code", digest[:12], title=digest))
