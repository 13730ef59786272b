"""The site: it builds without a warning, needs no network, and agrees with the code."""

import importlib.util
import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path
from urllib.parse import quote

import numpy as np
import pytest
from browsers import HANGS, chromium, needs_browser
from ledgers import FACTS, LEDGER
from sample_notebook import notebook

from rigidsym import TorqueFreeMotion
from rigidsym.proof.kernel._rules import RULES
from rigidsym.proof.paper import verdicts

nbformat = pytest.importorskip("nbformat", reason="needs nbformat (extra docs)")
NEEDED = ("sphinx", "myst_nb", "furo", "sphinx_copybutton", "latex2mathml", "ziamath", "plotly",
          "matplotlib", "scipy", "erfa", "ppigrf")  # fmt: skip
MISSING = [name for name in NEEDED if importlib.util.find_spec(name) is None]
pytestmark = pytest.mark.skipif(bool(MISSING), reason=f"needs {', '.join(MISSING)} (extra docs)")
ROOT = Path(__file__).parents[2]
SITE = ROOT / "notebooks" / "site"
SCATTER = {"type": "scatter3d", "x": [0, 1], "y": [0, 1], "z": [0, 1]}
# With a title and names that are long for a phone.
NAMES = ("circulation about the axis of largest inertia", "separatrix", "momentum now")
FIGURE = {
    "data": [{**SCATTER, "name": name, "mode": "lines"} for name in NAMES],
    "layout": {
        "height": 400, "width": 760, "margin": {"t": 60, "b": 0, "l": 0, "r": 0},
        "title": {"text": "Tumbling: circulation about the axis of largest inertia", "x": 0.01},
        "legend": {"orientation": "h", "y": 1, "yanchor": "bottom"},
        "scene": {"domain": {"x": [0, 1], "y": [0, 1]}},
    },
}  # fmt: skip
STILL = (
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk"
    "+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)


def executed():
    """Return the sample with outputs as an execution leaves them."""
    sample, v4 = notebook(), nbformat.v4
    formula = {"text/latex": "$\\displaystyle \\dot q$", "text/plain": "q"}
    picture = {"application/vnd.plotly.v1+json": FIGURE, "image/png": STILL}
    card = {"text/html": r"<p>a card: \(a &lt; b\)</p>", "text/latex": "$a < b$"}
    table = {"text/markdown": "| of | is |\n| --- | --- |\n| $c_1$ | 2 |"}
    for number, data in ((2, formula), (3, picture)):
        output = v4.new_output("execute_result", data, execution_count=number)
        sample.cells[number].outputs = [output]
    sample.cells.append(v4.new_markdown_cell("## The angle $\\phi_1$ of $K\\cdot A_1$"))
    sample.cells[3].outputs += (v4.new_output("display_data", data) for data in (card, table))
    return sample


def run(*command, seed="1"):
    return subprocess.run(
        [sys.executable, *command], capture_output=True, text=True, check=False,
        cwd=ROOT, env={**os.environ, "PYTHONHASHSEED": seed},
    )  # fmt: skip


def build(output, notebooks, **how):
    return run(SITE / "build.py", "-o", output, "-n", notebooks, **how)


@pytest.fixture(scope="session")
def html(once):
    """Return the folder of a built site with a chapter and a how-to."""

    def make(folder):
        for name in ("01_sample.ipynb", "satellite.ipynb"):
            (folder / name).write_text(json.dumps(executed()))
        found = build(folder / "out", folder)
        assert found.returncode == 0, found.stderr

    return once("site", make) / "out" / "html"


@pytest.fixture(scope="module")
def pages(html):
    """Return the text of every page by its path, without the places where names may break."""
    paths = {path.relative_to(html).as_posix(): path for path in html.rglob("*.html")}
    return {name: path.read_text().replace("<wbr>", "") for name, path in paths.items()}


def test_all_pages_are_there(pages):
    expected = {
        *("index", "guide", "trust", "errata", "guide/01_sample", "guide/satellite", "use"),
        *("proofs", "digits", "code", "accuracy", "validation", "contributing", "glossary"),
        *("live",),
        *("stability", "manoeuvres", "reference/api", "reference/command", "reference/formats"),
        *("reference/kernel", "reference/api/rigidsym", "reference/api/rigidsym.manoeuvre"),
        "reference/api/rigidsym.io",
    }
    assert {f"{name}.html" for name in expected} <= set(pages)


def test_nothing_is_fetched_from_elsewhere(html, pages):
    for name, text in pages.items():
        loaded = re.findall(r"<(?:script|img|iframe|link rel=\"stylesheet\")[^>]*"
                            r"(?:src|href)=\"(https?:[^\"]+)", text)  # fmt: skip
        assert loaded == [], name
    for path in html.rglob("*.css"):
        assert not re.search(r"@import|url\([\"']?https?:", path.read_text()), path


def test_local_links_lead_somewhere(html, pages):
    for name, text in pages.items():
        for link in re.findall(r"(?:href|src)=\"([^\"#?]+)", text):
            if not re.match(r"[a-z]+:", link):
                assert ((html / name).parent / link).exists(), (name, link)


def test_formulas_are_mathematics_and_none_is_left_over(pages):
    assert pages["errata.html"].count("<math ") >= len(verdicts(LEDGER))
    words = re.sub(r"<script.*?</script>|<[^>]*>", "", pages["errata.html"], flags=re.DOTALL)
    assert not re.search(r"\\(?:frac|Omega|mathrm)|\$\$", words)


def test_a_notebook_has_its_formulas_tables_and_pictures(html, pages):
    text = pages["guide/01_sample.html"]
    assert text.partition("<article")[2].partition("</article>")[0].count("<math ") == 7
    assert re.search(r"<p>a card: <math ", text)
    assert re.search(r"<td><p><math |<td><math ", text)
    # A picture is drawn from files of the site.
    assert text.count('<script src="../_static/plotly.min.js">') == 1
    assert 'drawPicture("picture-01_sample-0", ' in text
    assert (html / "_static" / "pictures.js").is_file()
    assert (html / "_static" / "plotly.min.js").stat().st_size > 1e6


# Moments, rates and times of the live page, as its sliders have them.
LIVE = [
    ("1 2 2.5", "0.02 2 0", "12.34"),
    ("0.55 2.01 2.49", "-1.6 0.5 0.4", "99.99"),
    ("2 2 1", "0.5 0 2", "3.21"),
    ("0.7 0.7 0.7", "0.5 0.8 1", "50"),
    ("1 1 2", "0 0 0", "7"),
]
SLIDE = """
for (const [name, value] of Object.entries(arguments[0])) {
    document.getElementById(`live-${name}`).value = value;
}
document.getElementById("live-t").dispatchEvent(new Event("input", { bubbles: true }));
return ["q", "omega"].map((name) => document.getElementById(`live-${name}`).textContent);
"""


FAULTS = (Path(__file__).parent / "page_faults.js").read_text()
COLOUR = "return getComputedStyle(document.querySelector('#live-body .face')).stroke"


def slide(driver, moments, rates, t):
    """Set the sliders of the live page, and return its numbers: q and omega."""
    names = [*(f"c{k}" for k in (1, 2, 3)), *(f"omega{k}" for k in (1, 2, 3)), "t"]
    values = [*moments.split(), *rates.split(), t]
    shown = driver.execute_script(SLIDE, dict(zip(names, values, strict=True)))
    return [float(x) for text in shown for x in text.split()]


@needs_browser
@pytest.mark.filterwarnings("ignore::ResourceWarning")
@pytest.mark.parametrize("width", [1400, 390])
def test_the_live_page_computes_what_python_does(html, width, tmp_path):
    metrics = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 500}
    with chromium(tmp_path / "profile") as driver:
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        driver.get((html / "live.html").as_uri())
        assert driver.execute_script("return document.documentElement.scrollWidth") <= width
        for moments, rates, t in LIVE:
            inertia, omega0 = ([float(x) for x in text.split()] for text in (moments, rates))
            q, omega = TorqueFreeMotion(inertia, omega0)(float(t))
            found = slide(driver, moments, rates, t)
            assert np.max(np.abs(np.array(found) - [*q, *omega])) < 4e-15, moments
        # Every control has a name, and keys move it.
        controls = driver.find_elements("css selector", "#live input, #live select, #live button")
        assert len(controls) == 11
        assert all(control.accessible_name for control in controls)
        first = driver.find_element("id", "live-c1")
        before = driver.find_element("id", "live-momentum").text
        slide(driver, *LIVE[0])
        first.send_keys("\ue014")
        assert driver.find_element("css selector", "output[for=live-c1]").text == "1.01"
        assert driver.find_element("id", "live-momentum").text != before
        # What no body can have is refused in words.
        assert slide(driver, "3 1 1", "0 0 1", "1") == []
        words = "No body has a principal moment larger than the sum of the other two."
        assert driver.find_element("id", "live-refused").text == words
        assert slide(driver, *LIVE[0])
        assert driver.find_element("id", "live-refused").text == ""
        # It runs, in colours of either theme, without an error.
        driver.find_element("id", "live-run").send_keys(" ")
        colours = []
        for theme in ("light", "dark"):
            driver.execute_script(f"document.body.dataset.theme = '{theme}'")
            colours.append(driver.execute_script(COLOUR))
            driver.save_screenshot(str(tmp_path / f"{theme}.png"))
        assert len({*colours}) == 2
        assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []


def until(driver, script):
    """Wait for a script to return true, as long as a busy machine may take."""
    end = time.monotonic() + HANGS
    while not driver.execute_script(script):
        assert time.monotonic() < end, script
        time.sleep(0.1)


@needs_browser
@pytest.mark.filterwarnings("ignore::ResourceWarning")
@pytest.mark.parametrize("width", [1400, 390])
def test_what_is_drawn_is_seen_and_nothing_sticks_out(html, width, tmp_path):
    """Look at pages on a desk and on a phone: no picture is hidden, no page is wider."""
    from matplotlib.image import imread

    metrics = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 500}
    with chromium(tmp_path / "profile") as driver:
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)
        for name in ("index", "errata", "reference/formats", "reference/api/rigidsym", "trust",
                     "use", "search", "guide/01_sample"):  # fmt: skip
            query = f"?q={quote('the angle ϕ₁')}" if name == "search" else ""
            driver.get((html / f"{name}.html").as_uri() + query)
            if query:
                until(driver, "return !!document.querySelector('#search-results .search a')")
                found = driver.find_element("id", "search-results").text
                assert "The angle ϕ₁ of K·A₁" in found
            if name == "guide/01_sample":
                until(driver, "return !!document.querySelector('.plotly-picture .gtitle')")
            assert driver.execute_script(FAULTS) == [], name
        element = driver.find_element("css selector", ".plotly-picture")
        end = time.monotonic() + HANGS
        while time.monotonic() < end:
            element.screenshot(str(tmp_path / "seen.png"))
            # Darker than its ground: axes and their numbers.
            if imread(tmp_path / "seen.png")[..., :3].min() < 0.8:
                return
    pytest.fail("the picture is blank")


def test_the_reference_has_rules_assumptions_and_formats(pages):
    text = pages["reference/kernel.html"]
    assert all(f">{name}</span>" in text for name in RULES)
    assert all(name in text for name, fact in FACTS.items() if fact["rule"] == "assumption")
    text = pages["reference/formats.html"]
    assert all(f'id="{name}"' in text for name in ("rigidsym-plan-1", "rigidsym-track-1"))
    assert "natural_frequency" in text


def test_the_reference_has_what_plans_and_examines(pages):
    for name in ("rigidsym.plan", "rigidsym.principal_axes", "rigidsym.manoeuvre.Plan",
                 "rigidsym.manoeuvre.flight.fly", "rigidsym.io.aem",
                 "rigidsym.validate.examine"):  # fmt: skip
        page = pages[f"reference/api/{name.rpartition('.')[0]}.html"]
        assert f'id="{name}"' in page, name
    page = pages["reference/api/rigidsym.html"]
    assert "ArrayLike" in page
    assert not any("_SupportsArray" in page for page in pages.values())
    assert "<strong>allow_nonphysical</strong>" in page, "parameters are a list"


def test_links_into_the_repository_lead_to_pages_that_show_it(pages):
    article = {name: pages[f"{name}.html"].partition("<article")[2] for name in ("trust", "use")}
    for page in ("trust", "proofs", "digits", "code", "accuracy", "validation", "use"):
        assert f'href="{page}.html"' in pages["index.html"].partition("<article")[2], page
    assert 'href="reference/kernel.html"' in article["trust"]
    assert 'href="index.html"' in article["use"]
    assert re.search(r"<img[^>]*_images/\w+\.svg", pages["index.html"])


@pytest.mark.slow
def test_building_again_gives_the_same(html, tmp_path):
    assert build(tmp_path, html.parents[1], seed="2").returncode == 0
    again = tmp_path / "html"
    names = sorted(path.relative_to(html) for path in html.rglob("*") if path.is_file())
    assert names == sorted(path.relative_to(again) for path in again.rglob("*") if path.is_file())
    differ = [x for x in names if (html / x).read_bytes() != (again / x).read_bytes()]
    assert differ == []


RENDER = f"""
import sys
from pathlib import Path
sys.path.insert(0, {str(SITE)!r})
from build import render
sys.exit(render(Path(sys.argv[1])))
"""


def test_a_formula_that_is_not_understood_is_an_error(tmp_path):
    for part in ("static", "source"):
        (tmp_path / part).mkdir()
    page = "# One page\n\n$\\nu x$ and $\\nosuchthing x$\n"
    (tmp_path / "source" / "index.md").write_text(page)
    found = run("-c", RENDER, tmp_path)
    assert found.returncode != 0
    (line,) = found.stderr.splitlines()
    assert "nosuchthing" in line


def test_the_landing_page_has_a_picture_of_each_chapter_that_has_one(html, pages):
    tile = r'<a class="tile" href="([^"]+)"><img src="([^"]+)"[^>]*><span>([^<]+)</span>'
    ((link, picture, title),) = re.findall(tile, pages["index.html"])
    assert (link, title) == ("guide/01_sample.html", "A sample")
    assert (html / picture).read_bytes().startswith(b"\x89PNG")


def test_the_project_is_on_the_site_and_titles_of_pages_differ(pages):
    assert "MIT License" in pages["licence.html"]
    assert "cff-version" in pages["citation.html"]
    assert "0.1.0" in pages["changes.html"]
    # Both notebooks are the sample; modules have pages of their code beside those of their names.
    others = (text for name, text in pages.items() if name != "guide/satellite.html")
    found = [re.search(r"<title>(.*?)</title>", text)[1] for text in others]
    assert len(found) == len(set(found))


EXPORT = f"""
import sys
sys.path[:0] = [{str(SITE)!r}]
import nbformat
from export import exported
print(exported(nbformat.read(sys.argv[1], as_version=4)))
"""


def test_an_exported_notebook_is_one_file_with_its_mathematics(html):
    pytest.importorskip("nbconvert", reason="needs nbconvert (extra lab)")
    done = run("-c", EXPORT, html.parents[1] / "01_sample.ipynb")
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("<math") == 7
    assert not re.search(r"<(?:script|link|img)[^>]*(?:src|href)=\"https?:", done.stdout)
    words = re.sub(r"<(script|style).*?</\1>|<[^>]*>", "", done.stdout, flags=re.DOTALL)
    assert "$$" not in words
    assert "a card:" in words
