"""The HTML report is complete, escaped and reproducible, and loads nothing."""

import copy
import re

import pytest
from html_cards import Elements
from validation_reports import STRATA, direct, failed, passed, whole, with_peer

from rigidsym.validate import _report as reports
from rigidsym.view import _report_data as report_data
from rigidsym.view._report_data import COLUMNS, Column
from rigidsym.view._validation import page
from rigidsym.view._validation.figures import fitted

HOSTILE = """</title><script src="https://x.example/y.js">&'"""
VIEWS, DRAWN = ("distance", "turned", "condition"), ("angle", "omega")
INF = float("inf")


@pytest.fixture
def data():
    return passed()


def words(data):
    return "".join(Elements(page(data)).words)


@pytest.fixture(scope="module")
def peers():
    """Data with a peer, their page, and its elements."""
    data = with_peer(passed())
    text = page(data)
    return data, text, Elements(text)


def test_a_page_is_well_formed_and_loads_nothing(peers):
    _, text, elements = peers
    assert text.startswith("<!DOCTYPE html>\n<html lang=")
    assert not {"script", "link", "img", "iframe", "object"} & {name for name, _ in elements.found}
    links = [given["href"] for _, given in elements.found if "href" in given]
    anchors = [given["id"] for _, given in elements.found if "id" in given]
    assert links
    assert {link.removeprefix("#") for link in links} <= set(anchors)
    assert len(anchors) == len(set(anchors))
    assert not any("src" in given for _, given in elements.found)
    assert not re.search(r"url\(|@import|https?:", text)


def test_everybody_and_every_stratum_and_plot_is_there(peers):
    data, _, elements = peers
    shown = set(map(str.strip, elements.words))
    assert {"numpy", "peer rk", *STRATA} <= shown
    assert {stratum["about"] for stratum in data["strata"]} <= shown
    assert {f"plot-{v}" for v in VIEWS} <= {given.get("id") for given in elements.all("figure")}
    plots = elements.all("svg", "plot")
    assert len(plots) == 2 * 3 + 2 * len(STRATA)
    cells = [one[v][m] for one in data["implementations"] for v in VIEWS for m in DRAWN]
    assert len(elements.all("path", "mark")) == sum(map(len, cells))
    assert len(elements.all("path", "bound")) == len(plots)
    assert all("scope" in given for given in elements.all("th"))
    assert len(elements.all("table")) == len(elements.all("caption"))
    bars = [given["style"] for given in elements.all("span") if "style" in given]
    assert bars
    assert all(re.fullmatch(r"--part:(\d\d?|100)%", bar) for bar in bars)


def test_worst_cases_come_with_inputs_and_a_command(data):
    shown = words(data)
    for case in data["worst"]:
        assert case["replay"] in shown
        assert all(number in shown for number in (*case["inertia"], *case["times"]))
    assert data["command"] in shown
    assert "Passed numpy stays within every documented bound" in shown
    assert "Failures" not in shown


def test_failures_come_first():
    data = failed()
    text = page(data)
    assert text.index('id="failures"') < text.index('id="regimes"')
    shown = words(data)
    assert "Failed numpy: 1 failure" in shown
    assert data["failures"][0]["line"] in shown
    assert data["failures"][0]["simplest"]["replay"] in shown


def test_a_campaign_that_proves_nothing_says_why_it_fails(data):
    data["passed"], data["complaints"] = False, ["uniform: nothing was tested"]
    shown = words(data)
    assert "Failed numpy: 1 failure" in shown
    assert shown.count("uniform: nothing was tested") == 2


def test_names_cannot_break_out(data):
    with_peer(data, HOSTILE)
    data["strata"][0]["about"] = data["run"]["python"] = data["command"] = HOSTILE
    data["worst"][0]["regime"] = data["worst"][0]["replay"] = HOSTILE
    elements = Elements(page(data))
    assert not elements.all("script")
    assert "".join(elements.words).count(HOSTILE) > 5


def test_the_same_data_give_the_same_page(data):
    text = page(data)
    assert text == page(copy.deepcopy(data))
    assert text == page(direct())


def test_nothing_measured_is_no_reason_to_break(data):
    """The campaign was stopped before anything was measured."""
    for one in data["implementations"]:
        one |= {view: {} for view in ("strata", "shares", "regimes", "sizes")}
        one |= {view: {measure: {} for measure in DRAWN} for view in VIEWS}
    data |= {"worst": [], "passed": False}
    assert "not measured" in words(data)


def test_an_axis_has_places_for_what_logarithms_have_not():
    axis = fitted([-3.5, 2.0, -INF, INF], 0.1)
    assert (axis.low, axis.high) == (-4, 2)
    assert [*map(axis.at, (-INF, -4, 2, INF))] == [0.05, 0.1, 0.9, 0.95]
    assert fitted([1.0, 2.0], 0.1).at(1.0) == 0


def test_an_axis_keeps_room_for_what_is_not_tiny():
    axis = fitted([-250.0, 0.0], 0.1)
    assert axis.at(-250) == 0
    assert [*map(axis.at, (-20, -10))] == pytest.approx([0.22, 0.61])
    assert axis.ticks == [-200, -20, -15, -10, -5, 0]


def test_a_new_column_on_strata_is_one_entry(monkeypatch):
    tables = ("page", "card", "markdown", "terminal")
    new = Column("used", "part used", lambda x, name: x.share("numpy", name), str, bool, tables)
    for module in (report_data, reports):
        monkeypatch.setattr(module, "COLUMNS", (*COLUMNS, new))
    report = whole()
    data = report.to_data()
    assert all(0 < stratum["used"] <= 1 for stratum in data["strata"])
    shown = (page(data), report._repr_html_(), report.to_markdown(), report.summary()[0])
    assert all("part used" in text for text in shown)
