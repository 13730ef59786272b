"""Tests of `rigidsym plan`, `track` and `figures`: what they print, write and refuse."""

import json
import os
import re
import subprocess
import sys

import numpy as np
import pytest

PLANNED = """
inertia = ["0.0109", "0.04", "0.0506"]
start = [1, 0, 0, 0]
target = [0.9, 0.1, -0.2, 0.3]
duration = 20
"""
SHORT = f"""{PLANNED}
[run]
length = 50

[message]
creation_date = 2026-01-01T00:00:00Z
"""
AT_TARGET = ("[0.9, 0.1, -0.2, 0.3]", "[-2, 0, 0, 0]")
TARGET = np.array([0.9, 0.1, -0.2, 0.3]) / np.linalg.norm([0.9, 0.1, -0.2, 0.3])
WRITING = "plan short.toml -o out", "track short.toml -o out", "figures -o figures"
COMMANDS = """
import sys
from rigidsym._cli import main
for command in sys.argv[2:]:
    assert main(command.split()) == int(sys.argv[1])
"""
# Settings of matplotlib that change lines, texts, backgrounds, sizes and ids.
SETTINGS = """
axes.facecolor: black
axes.linewidth: 5
font.size: 20
figure.facecolor: red
lines.markersize: 20
savefig.facecolor: yellow
svg.fonttype: none
svg.hashsalt: another
"""


@pytest.fixture
def short(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text(SHORT)
    return path


def process(cwd, status, *commands, before="", **environment):
    """Run commands in a process of its own; each has to end with a status."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", before + COMMANDS, str(status), *commands],
        env={**os.environ, **environment}, capture_output=True, text=True, check=False, cwd=cwd,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done


def contents(directory):
    return {path.name: path.read_bytes() for path in directory.iterdir()}


@pytest.fixture(scope="session")
def made(once):
    """A folder with the files of plan and track (`out`) and of figures, and what they print."""

    def run(folder):
        (folder / "short.toml").write_text(SHORT)
        done = process(folder, 0, *WRITING, PYTHONHASHSEED="0", OMP_NUM_THREADS="1")
        (folder / "stdout").write_text(done.stdout)
        (folder / "stderr").write_text(done.stderr)

    return once("manoeuvres", run)


@pytest.fixture(scope="session")
def printed(made):
    return (made / "stdout").read_text(), (made / "stderr").read_text()


def test_plan(short, run):
    found = run("plan", short, "--all", "3")
    assert "rigidsym plan: 20 s" in found.out
    assert "miss (rad)" in found.out
    assert found.out.count("< 1e-1") == 3  # rounding, whose digits differ between processors
    assert found.err == ""


def test_json_is_the_same_each_time(short, run):
    texts = [run("plan --all 2 --json", short).out for _ in range(2)]
    assert texts[0] == texts[1]
    data = json.loads(texts[0])
    assert data["schema"] == "rigidsym.plan/1"
    assert len(data["transfers"]) == 2


def test_its_case_files_reach_the_target(made, printed, run):
    assert "wrote out/plan.json" in printed[1]
    last = run("propagate", made / "out" / "transfer-1.toml").out.strip().splitlines()[-1]
    numbers = [float(x) for x in last.replace(",", " ").split()]
    assert numbers[0] == 20
    assert abs(np.array(numbers[1:5]) @ TARGET) == pytest.approx(1, abs=1e-9)


@pytest.mark.parametrize("count", [2, 8])
def test_its_picture_has_a_row_for_each_of_the_cheapest(count, short, tmp_path, run):
    run("plan", short, "--all", count, "-o", tmp_path)
    text = (tmp_path / "transfers.svg").read_text("utf-8")
    titles = [f"transfer {k}: " in text for k in range(1, 9)]
    assert titles == [True] * min(count, 6) + [False] * (8 - min(count, 6))
    assert (tmp_path / "transfers.png").stat().st_size > 10_000


def test_the_file_of_the_package_can_be_planned(run):
    assert json.loads(run("plan paper --json").out)["transfers"][0]["residual"] <= 1e-12


def test_track(made, printed):
    out, err = printed
    assert "settled at the target" in out
    assert "nothing to do" not in out
    assert len(re.findall(r"unexplained.* below \de-", out)) == 2
    assert "wrote out/summary.json" in err
    with np.load(made / "out" / "run.npz") as states:
        q = states["q"][-1]
    assert q @ TARGET == pytest.approx(1, abs=1e-6)


def test_track_as_json(made, short, run):
    text = run("track --json", short).out
    summary = json.loads(text)
    assert summary["schema"] == "rigidsym.track/1"
    assert summary["transfer"]["duration"] == 20
    assert summary["flight"]["run"]["length"] == 50
    assert text == (made / "out" / "summary.json").read_text()


@pytest.mark.parametrize(
    ("command", "changed", "status", "message"),
    [
        ("track", ("length = 50", "length = 21"), 1, r"not within 0\.1 deg at the end"),
        ("plan", AT_TARGET, 0, "start equals target, nothing to do"),
        ("track", AT_TARGET, 0, r"start equals target\W+nothing to do"),
    ],
)
def test_a_target_that_is_missed_or_is_the_start_is_told(
    short, command, changed, status, message, run
):
    short.write_text(SHORT.replace(*changed))
    assert re.search(message, run(command, short, status=status).out)


BOTH = [
    (PLANNED + "[engine]\nthrust = 1", "manoeuvre = engine: is not one of: "),
    (PLANNED.replace("start = [1, 0, 0, 0]", ""), "start = missing: a manoeuvre needs it"),
    (PLANNED.replace("duration = 20", ""), "duration = missing: give one, or a limit"),
    ("inertia = [", "manoeuvre = the file: is not TOML"),
]
BY_PLAN = [
    (PLANNED.replace("duration = 20", "duration = 0"), "duration = 0: must be above zero"),
    (PLANNED.replace("duration = 20", "duration = nan"), "duration = nan: must be finite"),
    (PLANNED.replace("0.9", "inf"), "target[0] = inf: must be finite"),
    (PLANNED + "[limits]\nmax_rate = 1e-3", "max_rate = 0.001: no natural motion of 20 s keeps"),
    (PLANNED + "[limits]\nmax_rate = '1'\nx = 1", "limits = x: is not one of: max_burst,"),
    (PLANNED + "spin = 3", "spin = 3: must be a table of start, target"),
]
BY_TRACK = [
    (SHORT + "[orbit]\naltitude = -1", "orbit.altitude = -1: must be above the surface, km"),
    (SHORT.replace("start", "begin"), "manoeuvre = begin: is not one of: "),
    (SHORT.replace("0.9", "nan"), "target[0] = nan: must be finite"),
    (None, "manoeuvre = {path}: cannot be read"),
]


@pytest.mark.parametrize(
    ("command", "text", "message"),
    [("plan", *one) for one in BOTH + BY_PLAN] + [("track", *one) for one in BOTH + BY_TRACK],
)
def test_bad_files_are_refused_in_one_line(short, command, text, message, run):
    if text is None:
        short.unlink()
    else:
        short.write_text(text)
    found = run(command, short, status=2)
    assert found.err.startswith(f"rigidsym {command}: {message.format(path=short)}")
    assert found.err.count("\n") == 1
    assert found.out == ""


FLIGHTS = ("track paper", "figures")


@pytest.mark.parametrize(
    ("package", "commands", "extra"),
    [
        ("scipy", (*FLIGHTS, "plan paper"), "app"),
        ("erfa", (*FLIGHTS, "compare"), "app"),
        *((package, FLIGHTS, "app") for package in ("ppigrf", "pydantic", "matplotlib")),
        ("casadi", ("compare",), "optimal"),
    ],
)
def test_missing_packages_are_named_in_one_line(package, commands, extra, tmp_path):
    hidden = f"import sys\nsys.modules[{package!r}] = None\n"
    lines = process(tmp_path, 2, *commands, before=hidden).stderr.splitlines()
    assert len(lines) == len(commands)
    for line in lines:
        assert f"packages = {package}: " in line
        assert f"pip install 'rigidsym[{extra}]'" in line


def test_the_figures(made, printed):
    names = {f"figure{k}.{suffix}" for k in (1, 2, 3) for suffix in ("svg", "png")}
    assert {path.name for path in (made / "figures").iterdir()} == names | {"figures.md"}
    jumps = r"jumps of Euler's angles in 180 s: precession [1-9], .* spin [1-9]"
    assert re.search(jumps, printed[0])


def test_the_figures_show_what_the_papers_show(made):
    text = " ".join((made / "figures" / "figures.md").read_text().split())

    def numbers(pattern):
        return map(float, re.search(pattern, text).groups())

    low, high = numbers(r"from (\S+) to (\S+) N m over 180 s")
    assert -5e-4 < low < -3e-4
    assert 3e-4 < high < 5e-4
    first, last, coast = numbers(
        r"first burst peaks at (\S+), the last at (\S+); between them (\S+) at most"
    )
    assert coast < 0.1 * min(first, last)
    settled, final = numbers(r"\(from (\S+) s on\) and ends (\S+) degrees")
    assert 120 < settled < 180
    assert final < 0.1
    assert next(numbers(r"quaternions to (\S+) degrees")) < 1e-10


def test_files_are_the_same_in_all_environments(made, short):
    """The order of sets, the number of threads and settings of matplotlib have no effect."""
    folder = short.parent
    settings = folder / "matplotlibrc"
    settings.write_text(SETTINGS)
    own = {"MATPLOTLIBRC": str(settings), "PYTHONHASHSEED": "7", "OMP_NUM_THREADS": "2"}
    process(folder, 0, *WRITING, **own)
    assert {"plan.json", "run.npz", "attitude.svg", "attitude.png", "torques.svg"} <= set(
        contents(made / "out")
    )
    for name in ("out", "figures"):
        one, other = contents(made / name), contents(folder / name)
        assert one.keys() == other.keys()
        assert [name for name in one if one[name] != other[name]] == []
