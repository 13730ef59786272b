"""The HTML report in Chromium: layout, colours, links, and no requests."""

import json

import pytest
from browsers import chromium, needs_browser
from validation_reports import failed, passed, with_peer

from rigidsym.view._validation import page

pytestmark = needs_browser
PAGES = {"passed": passed, "failed": failed, "peers": lambda: with_peer(passed())}
WIDTHS, SCHEMES = (400, 1280), ("light", "dark")

# Pictures of no size, and marks or bars that are not within theirs.
MISPLACED = """
return [...document.querySelectorAll('svg.plot')].flatMap(plot => {
  const outer = plot.getBoundingClientRect();
  const area = (plot.querySelector('.area') ?? plot).getBoundingClientRect();
  const marks = [...plot.querySelectorAll('.mark, .bar')];
  const outside = marks.filter(mark => {
    const box = mark.getBoundingClientRect(), x = (box.left + box.right) / 2;
    const y = (box.top + box.bottom) / 2, rest = 0.5;
    return !(box.width > 0 && box.height > 0 && x >= area.left - rest && x <= area.right + rest
      && y >= area.top - rest && y <= area.bottom + rest);
  });
  const empty = !(outer.width > 100 && outer.height > 50) || !marks.length;
  return empty || outside.length ? [plot.getAttribute('aria-label')] : [];
});
"""
# Words of a picture that lie over each other.
COLLIDING = """
return [...document.querySelectorAll('svg.plot')].flatMap(plot => {
  const boxes = [...plot.querySelectorAll('text')].map(x => [x, x.getBoundingClientRect()]);
  return boxes.flatMap(([x, a], k) => boxes.slice(k + 1)
    .filter(([, b]) => a.left < b.right - 1 && b.left < a.right - 1
      && a.top < b.bottom - 3 && b.top < a.bottom - 3)
    .map(([y]) => `${x.textContent} | ${y.textContent}`));
});
"""
HIDDEN_TABLES = """
return [...document.querySelectorAll('table')].filter(table => {
  const box = table.getBoundingClientRect();
  return !table.closest('details:not([open])') && !(box.width > 50 && box.height > 20);
}).length;
"""
# The colours of words, and of what is behind them.
COLOURS = """
const style = getComputedStyle(document.body);
return [style.color, style.backgroundColor];
"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    with chromium(tmp_path_factory.mktemp("profile")) as driver:
        yield driver


@pytest.fixture(scope="module")
def addresses(tmp_path_factory):
    """The URLs of the pages, by name."""
    folder, found = tmp_path_factory.mktemp("pages"), {}
    for name, make in PAGES.items():
        path = folder / f"{name}.html"
        path.write_text(page(make()), encoding="utf-8")
        found[name] = path.as_uri()
    return found


def show(browser, address, width, scheme):
    size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    features = [{"name": "prefers-color-scheme", "value": scheme}]
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
    for log in ("browser", "performance"):
        browser.get_log(log)
    browser.get(address)


def requests(browser, address):
    """Return the URLs that a page requested, its own included."""
    told = (json.loads(entry["message"])["message"] for entry in browser.get_log("performance"))
    sent = (one["params"] for one in told if one["method"] == "Network.requestWillBeSent")
    return {params["request"]["url"] for params in sent if params["documentURL"] == address}


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("name", PAGES)
def test_the_page_is_shown_whole(browser, addresses, name, width, scheme):
    show(browser, addresses[name], width, scheme)
    assert browser.get_log("browser") == []
    assert requests(browser, addresses[name]) == {addresses[name]}
    assert browser.execute_script(
        "return document.documentElement.scrollWidth <= window.innerWidth"
    )
    assert browser.execute_script(MISPLACED) == []
    assert browser.execute_script(COLLIDING) == []
    assert browser.execute_script(HIDDEN_TABLES) == 0


def luminance(colour):
    return sum(map(int, colour[colour.index("(") + 1 : -1].split(",")[:3]))


@pytest.mark.parametrize("scheme", SCHEMES)
def test_the_page_follows_the_colour_scheme(browser, addresses, scheme):
    show(browser, addresses["passed"], 1280, scheme)
    ink, ground = map(luminance, browser.execute_script(COLOURS))
    assert (ink < ground) == (scheme == "light")
    assert abs(ink - ground) > 450


def test_a_figure_of_a_table_leads_to_its_case(browser, addresses):
    show(browser, addresses["passed"], 1280, "light")
    link = browser.execute_script("return document.querySelector('td a').getAttribute('href')")
    browser.get(addresses["passed"] + link)
    opened = "return document.getElementById(arguments[0]).closest('details').open"
    assert browser.execute_script(opened, link.removeprefix("#"))
