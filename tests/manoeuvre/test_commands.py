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
COMMANDS = """
import sys
from rigidsym._cli import main
status, commands, *words = sys.argv[1:]
for command in commands.split(","):
    assert main([*command.split(), *words]) == int(status)
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


def process(status, commands, *words, before="", cwd=None, **environment):
    """Run commands in a process of its own; each has to end with a status."""
    command = [sys.executable, "-W", "error", "-c", before + COMMANDS, str(status), commands]
    done = subprocess.run(
        [*command, *map(str, words)], env={**os.environ, **environment}, capture_output=True,
        text=True, check=False, cwd=cwd,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return done


def contents(directory):
    return {path.name: path.read_bytes() for path in directory.iterdir()}


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """The files of `rigidsym plan` and `rigidsym track`, and what they print."""
    directory = tmp_path_factory.mktemp("flown")
    short = directory / "short.toml"
    short.write_text(SHORT)
    own = {"PYTHONHASHSEED": "0", "OMP_NUM_THREADS": "1"}
    return directory / "out", process(0, "plan,track", short, "-o", directory / "out", **own)


@pytest.fixture(scope="module")
def figures(tmp_path_factory):
    """The files of `rigidsym figures`, and what it prints."""
    directory = tmp_path_factory.mktemp("figures")
    return directory, process(0, "figures", "-o", directory).stdout


def test_plan(short, run):
    printed = run("plan", short, "--all", "3")
    assert "rigidsym plan: 20 s" in printed.out
    assert "miss (rad)" in printed.out
    assert printed.out.count("< 1e-1") == 3  # rounding, whose digits differ between processors
    assert printed.err == ""


def test_json_is_the_same_each_time(short, run):
    texts = [run("plan --all 2 --json", short).out for _ in range(2)]
    assert texts[0] == texts[1]
    data = json.loads(texts[0])
    assert data["schema"] == "rigidsym.plan/1"
    assert len(data["transfers"]) == 2


def test_its_case_files_reach_the_target(flown, run):
    directory, done = flown
    assert f"wrote {directory / 'plan.json'}" in done.stderr
    last = run("propagate", directory / "transfer-1.toml").out.strip().splitlines()[-1]
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


def test_track(flown):
    directory, done = flown
    assert "settled at the target" in done.stdout
    assert "nothing to do" not in done.stdout
    assert len(re.findall(r"unexplained.* below \de-", done.stdout)) == 2
    assert f"wrote {directory / 'summary.json'}" in done.stderr
    with np.load(directory / "run.npz") as states:
        q = states["q"][-1]
    assert q @ TARGET == pytest.approx(1, abs=1e-6)


def test_track_as_json(flown, short, run):
    text = run("track --json", short).out
    summary = json.loads(text)
    assert summary["schema"] == "rigidsym.track/1"
    assert summary["transfer"]["duration"] == 20
    assert summary["flight"]["run"]["length"] == 50
    assert text == (flown[0] / "summary.json").read_text()


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
    printed = run(command, short, status=2)
    assert printed.err.startswith(f"rigidsym {command}: {message.format(path=short)}")
    assert printed.err.count("\n") == 1
    assert printed.out == ""


@pytest.mark.parametrize("package", ["scipy", "erfa", "ppigrf", "pydantic", "matplotlib"])
def test_missing_packages_are_named_in_one_line(package, tmp_path):
    commands = ["track paper", "figures"] + (["plan paper"] if package == "scipy" else [])
    hidden = f"import sys\nsys.modules[{package!r}] = None\n"
    lines = process(2, ",".join(commands), before=hidden, cwd=tmp_path).stderr.splitlines()
    assert len(lines) == len(commands)
    for line in lines:
        assert f"packages = {package}: " in line
        assert "pip install 'rigidsym[app]'" in line


def test_the_figures(figures):
    directory, printed = figures
    names = {f"figure{k}.{suffix}" for k in (1, 2, 3) for suffix in ("svg", "png")}
    assert {path.name for path in directory.iterdir()} == names | {"figures.md"}
    assert re.search(r"jumps of Euler's angles in 180 s: precession [1-9], .* spin [1-9]", printed)


def test_the_figures_show_what_the_papers_show(figures):
    text = " ".join((figures[0] / "figures.md").read_text().split())

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


def test_the_figures_are_the_same_each_time(figures, tmp_path, run):
    run("figures", "-o", tmp_path)
    for path in tmp_path.iterdir():
        assert path.read_bytes() == (figures[0] / path.name).read_bytes(), path.name


def test_files_are_the_same_in_all_environments(flown, short, tmp_path):
    """Whatever the order of sets, the number of threads and the user's settings of matplotlib."""
    settings = tmp_path / "matplotlibrc"
    settings.write_text(SETTINGS)
    own = {"MATPLOTLIBRC": str(settings), "PYTHONHASHSEED": "7", "OMP_NUM_THREADS": "2"}
    process(0, "plan,track", short, "-o", tmp_path / "other", **own)
    one, other = contents(flown[0]), contents(tmp_path / "other")
    assert {"plan.json", "run.npz", "attitude.svg", "attitude.png", "torques.svg"} <= set(one)
    assert one.keys() == other.keys()
    assert [name for name in one if one[name] != other[name]] == []
