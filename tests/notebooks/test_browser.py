"""Notebooks in JupyterLab in a browser: all cells run, and formulas and pictures are seen."""

import importlib.util
import json
import os
import secrets
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import pytest
from browsers import HANGS, chromium, needs_browser

from support.executed import is_current

nbformat = pytest.importorskip("nbformat", reason="needs nbformat (extra lab)")
# Looked for, not imported: they run in a process of their own.
MISSING = [
    name
    for name in ("jupyterlab", "plotly", "ipykernel", "ipywidgets")
    if importlib.util.find_spec(name) is None
]
pytestmark = [
    needs_browser,
    pytest.mark.skipif(bool(MISSING), reason=f"needs {', '.join(MISSING)} (extra lab)"),
    # Sockets of servers and drivers that are told to stop are left to the collector.
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
]
ROOT = Path(__file__).parents[2]
# What is opened of the notebooks that are there, unless they are as they were when they were
# executed; a sample is opened in any case.
STEMS = ("05_edges", "10_a_manoeuvre_from_start_to_stop")
SAMPLE, PLAY = "sample", "00_start_here"
SETTINGS = {
    # The question whether news are wanted would lie over the page.
    "@jupyterlab/apputils-extension:notification": {
        "fetchNews": "false", "checkForUpdates": False, "doNotDisturbMode": True
    },
    # Else only the cells in sight are there at all.
    "@jupyterlab/notebook-extension:tracker": {"windowingMode": "none"},
}  # fmt: skip

# The notebook; a page without focus has no current widget.
PANEL = """
const open = [...(window.jupyterapp?.shell?.widgets('main') ?? [])];
const panel = open.find(widget => widget.content?.model?.cells);
"""
# What the model of the notebook says of its code cells, once it is connected to a kernel.
CELLS = f"""{PANEL}
return [...panel.content.model.cells].filter(cell => cell.type === 'code').map(cell => ({{
  source: cell.sharedModel.getSource(),
  count: cell.executionCount,
  state: cell.executionState ?? null,
  errors: cell.outputs.toJSON().filter(output => output.output_type === 'error'),
  kinds: cell.outputs.toJSON().flatMap(output => Object.keys(output.data ?? {{}})),
}}));
"""
READY = f"""{PANEL}
const context = panel?.sessionContext;
return !!(panel?.content?.model?.cells?.length && context?.isReady
  && context.session?.kernel?.status === 'idle');
"""
RUN = f"""{PANEL}
const app = window.jupyterapp;
app.shell.activateById(panel.id);
const first = [...panel.content.model.cells].findIndex(cell => cell.type === 'code');
panel.content.activeCellIndex = first;
return (async () => {{
  await app.commands.execute('notebook:clear-all-cell-outputs');
  await app.commands.execute(arguments[0]);
}})();
"""
RUN_ALL, RUN_FIRST = "notebook:run-all-cells", "notebook:run-cell"
DIALOGS = "return [...document.querySelectorAll('.jp-Dialog-content')].map(x => x.innerText);"
# Formulas that have a size, and those that MathJax could not read.
FORMULAS = """
const shown = [...document.querySelectorAll('.jp-Notebook mjx-container')];
const sized = shown.filter(x => x.getBoundingClientRect().width > 0);
return [sized.length, shown.length, document.querySelectorAll('.jp-Notebook mjx-merror').length];
"""
# For each 3-D scene, whether its canvas has a size and more than one colour.
SCENES = """
return [...document.querySelectorAll('.jp-Notebook .js-plotly-plot')]
  .filter(plot => plot._fullLayout?._subplots?.gl3d?.length)
  .map(plot => {
    const canvas = plot.querySelector('.gl-container canvas');
    if (!canvas || canvas.width < 100 || canvas.height < 100) return false;
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const picture = copy.getContext('2d', {willReadFrequently: true});
    plot._fullLayout.scene._scene.glplot.redraw();
    picture.drawImage(canvas, 0, 0);
    const pixels = new Uint32Array(picture.getImageData(0, 0, copy.width, copy.height).data.buffer);
    return new Set(pixels).size > 3;
  });
"""
# JupyterLab asks whether there is a language server, and takes no for an answer.
HARMLESS = ("/lsp/status",)


def until(ask, what):
    """Call `ask` until its result is true, and return that; fail with `what` after a time."""
    end = time.monotonic() + HANGS
    while time.monotonic() < end:
        if found := ask():
            return found
        time.sleep(0.25)
    pytest.fail(f"{what}: not within {HANGS} s")


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Return a folder with copies of the notebooks, and the sample."""
    place = tmp_path_factory.mktemp("notebooks")
    for path in (ROOT / "notebooks").glob("*.ipynb"):
        shutil.copyfile(path, place / path.name)
    for name in ("text", "support"):
        shutil.copytree(ROOT / "notebooks" / name, place / name)
    from sample_notebook import notebook

    nbformat.write(notebook(), place / f"{SAMPLE}.ipynb")
    return place


@pytest.fixture(scope="module")
def lab(folder, tmp_path_factory):
    """Start a JupyterLab with our configuration alone; return its address and token."""
    home = tmp_path_factory.mktemp("jupyter")
    settings = home / "app_settings"
    settings.mkdir()
    (settings / "overrides.json").write_text(json.dumps(SETTINGS))
    port, token = free_port(), secrets.token_hex(16)
    own = {"HOME": home, "IPYTHONDIR": home / "ipython", "JUPYTER_NO_CONFIG": "1"}
    own |= {f"JUPYTER_{x}_DIR": home / x.lower() for x in ("CONFIG", "DATA", "RUNTIME")}
    own |= {f"JUPYTERLAB_{x}_DIR": home / x.lower() for x in ("SETTINGS", "WORKSPACES")}
    own["PYTHONPATH"] = os.pathsep.join([str(ROOT), os.environ.get("PYTHONPATH", "")])
    options = (
        *("--no-browser", "--allow-root", "--expose-app-in-browser", "--LabApp.news_url=None"),
        *("--ServerApp.ip=127.0.0.1", f"--ServerApp.port={port}", "--ServerApp.port_retries=0"),
        *(f"--IdentityProvider.token={token}", f"--ServerApp.root_dir={folder}"),
        *(f"--LabApp.app_settings_dir={settings}", "--LabApp.extension_manager=readonly"),
    )
    log = home / "log"
    with log.open("w") as told:
        server = subprocess.Popen(
            [sys.executable, "-m", "jupyterlab", *options],
            stdout=told, stderr=told, cwd=folder,
            env={**os.environ, **{name: str(value) for name, value in own.items()}},
        )  # fmt: skip
    try:
        address = f"http://127.0.0.1:{port}"
        until(lambda: answers(f"{address}/api?token={token}", server, log), "JupyterLab")
        yield address, token
    finally:
        server.terminate()
        try:
            server.wait(20)
        except subprocess.TimeoutExpired:
            server.kill()
            server.wait()


def answers(url, server, log):
    if server.poll() is not None:
        pytest.fail(f"JupyterLab ended: {log.read_text()[-2000:]}")
    try:
        with urllib.request.urlopen(url, timeout=HANGS) as reply:
            return reply.status == 200
    except OSError:
        return False


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    with chromium(tmp_path_factory.mktemp("profile")) as driver:
        yield driver


def source_of(folder, stem):
    path = folder / f"{stem}.ipynb"
    if not path.exists():
        pytest.skip(f"notebooks/{stem}.ipynb is not there")
    return nbformat.read(path, as_version=4)


def opened(browser, lab, stem):
    """Open a notebook in a workspace of its own, and wait for its kernel."""
    address, token = lab
    # What the page before says about being left is not this one's.
    browser.get("about:blank")
    for log in ("browser", "performance"):
        browser.get_log(log)
    browser.get(f"{address}/lab/workspaces/{stem}/tree/{stem}.ipynb?token={token}&reset")
    until(lambda: browser.execute_script(READY), f"{stem}: a kernel that is ready")
    assert browser.execute_script(DIALOGS) == []


def ran(browser):
    """Return the code cells once all have run, else None."""
    cells = browser.execute_script(CELLS)
    written = [cell for cell in cells or [] if cell["source"].strip()]
    done = all(cell["count"] and cell["state"] in ("idle", None) for cell in written)
    failed = any(cell["errors"] for cell in written)
    return written if written and (done or failed) else None


@pytest.mark.parametrize(
    "stem",
    [*(pytest.param(x, marks=pytest.mark.slow if is_current(x) else ()) for x in STEMS), SAMPLE],
)
def test_a_notebook_runs_in_jupyterlab(browser, lab, folder, stem):
    notebook = source_of(folder, stem)
    opened(browser, lab, stem)
    browser.execute_script(RUN, RUN_ALL)
    cells = until(lambda: ran(browser), f"{stem}: all cells")
    assert [cell["errors"] for cell in cells if cell["errors"]] == []
    expected = [c for c in notebook.cells if c.cell_type == "code" and c.source.strip()]
    assert [cell["source"] for cell in cells] == [cell.source for cell in expected]
    assert sorted(cell["count"] for cell in cells) == list(range(1, len(cells) + 1))
    assert browser.execute_script(DIALOGS) == []
    check_mathematics(browser, stem)
    check_pictures(browser, stem, cells)
    check_log(browser, lab)


# What the sliders' notebook says, and whether the scenes below have a size.
SAID = """
const said = document.querySelector('.jp-Notebook .widget-html-content b')?.innerText;
const scenes = document.querySelectorAll('.jp-Notebook .js-plotly-plot .gl-container canvas');
return [said ?? '', [...scenes].filter(x => x.getBoundingClientRect().width > 100).length];
"""


@pytest.mark.parametrize(
    "stem", [pytest.param(PLAY, marks=pytest.mark.slow if is_current(PLAY) else ())]
)
def test_sliders_change_the_motion(browser, lab, folder, stem):
    """Move sliders to their ends: the body turns about another axis, and pictures follow."""
    source_of(folder, stem)
    opened(browser, lab, stem)
    # Without the checks, which let go of the sliders.
    until(lambda: browser.execute_script(RUN, RUN_FIRST) or True, stem)

    def said(words, scenes):
        found = browser.execute_script(SAID)
        return words in found[0] and found[1] >= scenes

    until(lambda: said("smallest inertia", 2), f"{stem}: a motion")
    handles = browser.find_elements("css selector", ".jp-Notebook .noUi-handle")
    assert len(handles) == 6
    handles[-1].send_keys("\ue011")  # Home
    until(lambda: said("largest inertia", 2), f"{stem}: another motion")
    handles[2].send_keys("\ue010")  # End: c3 is more than c1 + c2
    until(lambda: said("larger than the sum", 2), f"{stem}: a body that cannot be")
    check_log(browser, lab)


def check_mathematics(browser, stem):
    sized, shown, wrong = until(
        lambda: (found := browser.execute_script(FORMULAS))[0] and found, f"{stem}: a formula"
    )
    assert sized == shown
    assert wrong == 0


def check_pictures(browser, stem, cells):
    """Wait for Plotly's 3-D scenes, where a cell has one."""
    if not any("application/vnd.plotly.v1+json" in cell["kinds"] for cell in cells):
        assert stem != SAMPLE
        return

    def drawn():
        scenes = browser.execute_script(SCENES)
        return scenes and all(scenes)

    plots = "return document.querySelectorAll('.jp-Notebook .js-plotly-plot .main-svg').length;"
    until(lambda: browser.execute_script(plots), f"{stem}: a picture")
    if stem == SAMPLE or browser.execute_script(SCENES):
        until(drawn, f"{stem}: a 3-D picture")


def check_log(browser, lab):
    """Assert that the page had no error, and sent requests to JupyterLab alone."""
    told = [entry for entry in browser.get_log("browser") if entry["level"] == "SEVERE"]
    assert [x["message"] for x in told if not any(word in x["message"] for word in HARMLESS)] == []
    events = (json.loads(entry["message"])["message"] for entry in browser.get_log("performance"))
    urls = [e["params"]["request"]["url"] for e in events
            if e["method"] == "Network.requestWillBeSent"]  # fmt: skip
    assert [x for x in urls if x.startswith("http") and not x.startswith(f"{lab[0]}/")] == []
