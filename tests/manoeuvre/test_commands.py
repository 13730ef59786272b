"""`rigidsym plan`, `track` and `figures`: what they print, leave behind and refuse."""

import json
import os
import re
import subprocess
import sys

import numpy as np
import pytest

from rigidsym._cli import main

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
TARGET = np.array([0.9, 0.1, -0.2, 0.3]) / np.linalg.norm([0.9, 0.1, -0.2, 0.3])


@pytest.fixture
def short(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text(SHORT)
    return path


def run(code, *words, cwd=None, **environment):
    """Run Python code in a process of its own."""
    command = [sys.executable, "-W", "error", "-c", code, *map(str, words)]
    environment = {**os.environ, **environment}
    return subprocess.run(
        command, env=environment, capture_output=True, text=True, check=False, cwd=cwd
    )


def contents(directory):
    return {path.name: path.read_bytes() for path in directory.iterdir()}


COMMANDS = """
import sys
from rigidsym._cli import main
for command in sys.argv[1].split(","):
    assert main([command, *sys.argv[2:]]) == 0
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


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """The files of `rigidsym plan` and `rigidsym track`, and what they print."""
    directory = tmp_path_factory.mktemp("flown")
    short = directory / "short.toml"
    short.write_text(SHORT)
    own = {"PYTHONHASHSEED": "0", "OMP_NUM_THREADS": "1"}
    done = run(COMMANDS, "plan,track", short, "-o", directory / "out", **own)
    assert done.returncode == 0, done.stderr
    return directory / "out", done


@pytest.fixture(scope="module")
def figures(tmp_path_factory):
    """The files of `rigidsym figures`, and what it prints."""
    directory = tmp_path_factory.mktemp("figures")
    done = run(COMMANDS, "figures", "-o", directory)
    assert done.returncode == 0, done.stderr
    return directory, done.stdout


def test_plan(short, capsys):
    assert main(["plan", str(short), "--all", "3"]) == 0
    printed = capsys.readouterr()
    assert "rigidsym plan: 20 s" in printed.out
    assert "miss (rad)" in printed.out
    assert printed.out.count("< 1e-1") == 3  # rounding, whose digits differ between processors
    assert printed.err == ""


def test_json_is_the_same_each_time(short, capsys):
    texts = []
    for _ in range(2):
        assert main(["plan", str(short), "--all", "2", "--json"]) == 0
        texts.append(capsys.readouterr().out)
    assert texts[0] == texts[1]
    data = json.loads(texts[0])
    assert data["schema"] == "rigidsym.plan/1"
    assert len(data["transfers"]) == 2


def test_its_case_files_reach_the_target(flown, capsys):
    directory, done = flown
    assert f"wrote {directory / 'plan.json'}" in done.stderr
    assert main(["propagate", str(directory / "transfer-1.toml")]) == 0
    last = capsys.readouterr().out.strip().splitlines()[-1]
    numbers = [float(x) for x in last.replace(",", " ").split()]
    assert numbers[0] == 20
    assert abs(np.array(numbers[1:5]) @ TARGET) == pytest.approx(1, abs=1e-9)


def test_its_picture_has_a_row_for_each_of_the_cheapest(short, tmp_path, capsys):
    for count in (2, 8):
        assert main(["plan", str(short), "--all", str(count), "-o", str(tmp_path)]) == 0
        text = (tmp_path / "transfers.svg").read_text("utf-8")
        titles = [f"transfer {k}: " in text for k in range(1, 9)]
        assert titles == [True] * min(count, 6) + [False] * (8 - min(count, 6))
        assert (tmp_path / "transfers.png").stat().st_size > 10_000
    capsys.readouterr()


def test_the_file_of_the_package_can_be_planned(capsys):
    assert main(["plan", "paper", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["transfers"][0]["residual"] <= 1e-12


def test_nothing_to_do_is_said(short, capsys):
    short.write_text(PLANNED.replace("[0.9, 0.1, -0.2, 0.3]", "[-1, 0, 0, 0]"))
    assert main(["plan", str(short)]) == 0
    assert "start equals target, nothing to do" in capsys.readouterr().out


def test_track(flown):
    directory, done = flown
    assert "settled at the target" in done.stdout
    assert "nothing to do" not in done.stdout
    assert len(re.findall(r"unexplained.* below \de-", done.stdout)) == 2
    assert f"wrote {directory / 'summary.json'}" in done.stderr
    with np.load(directory / "run.npz") as states:
        q = states["q"][-1]
    assert q @ TARGET == pytest.approx(1, abs=1e-6)


def test_track_as_json(flown, short, capsys):
    assert main(["track", str(short), "--json"]) == 0
    text = capsys.readouterr().out
    summary = json.loads(text)
    assert summary["schema"] == "rigidsym.track/1"
    assert summary["transfer"]["duration"] == 20
    assert summary["flight"]["run"]["length"] == 50
    assert text == (flown[0] / "summary.json").read_text()


@pytest.mark.parametrize(
    ("changed", "status", "message"),
    [
        (("length = 50", "length = 21"), 1, r"not within 0\.1 deg at the end"),
        (("[0.9, 0.1, -0.2, 0.3]", "[-2, 0, 0, 0]"), 0, r"start equals target\W+nothing to do"),
    ],
)
def test_a_target_that_is_missed_or_is_the_start_is_told(short, changed, status, message, capsys):
    short.write_text(SHORT.replace(*changed))
    assert main(["track", str(short)]) == status
    assert re.search(message, capsys.readouterr().out)


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
]


@pytest.mark.parametrize(
    ("command", "text", "message"),
    [("plan", *one) for one in BOTH + BY_PLAN] + [("track", *one) for one in BOTH + BY_TRACK],
)
def test_bad_files_are_refused_in_one_line(short, command, text, message, capsys):
    short.write_text(text)
    assert main([command, str(short)]) == 2
    printed = capsys.readouterr()
    assert printed.err.startswith(f"rigidsym {command}: {message}")
    assert printed.err.count("\n") == 1
    assert printed.out == ""


def test_a_file_that_is_not_there(capsys):
    assert main(["track", "nowhere.toml"]) == 2
    assert "manoeuvre = nowhere.toml: cannot be read" in capsys.readouterr().err


WITHOUT = """
import sys
sys.modules[sys.argv[1]] = None
from rigidsym._cli import main
for command in sys.argv[2:]:
    assert main(command.split()) == 2
"""


@pytest.mark.parametrize("package", ["scipy", "erfa", "ppigrf", "pydantic", "matplotlib"])
def test_missing_packages_are_named_in_one_line(package, tmp_path):
    commands = ["track paper", "figures"] + (["plan paper"] if package == "scipy" else [])
    done = run(WITHOUT, package, *commands, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    lines = done.stderr.splitlines()
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
    low, high = map(float, re.search(r"from (\S+) to (\S+) N m over 180 s", text).groups())
    assert -5e-4 < low < -3e-4
    assert 3e-4 < high < 5e-4
    bursts = r"first burst peaks at (\S+), the last at (\S+); between them (\S+) at most"
    first, last, coast = map(float, re.search(bursts, text).groups())
    assert coast < 0.1 * min(first, last)
    settled, final = map(
        float, re.search(r"\(from (\S+) s on\) and ends (\S+) degrees", text).groups()
    )
    assert 120 < settled < 180
    assert final < 0.1
    assert float(re.search(r"quaternions to (\S+) degrees", text)[1]) < 1e-10


def test_the_figures_are_the_same_each_time(figures, tmp_path, capsys):
    assert main(["figures", "-o", str(tmp_path)]) == 0
    for path in tmp_path.iterdir():
        assert path.read_bytes() == (figures[0] / path.name).read_bytes(), path.name


def test_files_are_the_same_in_all_environments(flown, short, tmp_path):
    """Whatever the order of sets, the number of threads and the user's settings of matplotlib."""
    settings = tmp_path / "matplotlibrc"
    settings.write_text(SETTINGS)
    own = {"MATPLOTLIBRC": str(settings), "PYTHONHASHSEED": "7", "OMP_NUM_THREADS": "2"}
    done = run(COMMANDS, "plan,track", short, "-o", tmp_path / "other", **own)
    assert done.returncode == 0, done.stderr
    one, other = contents(flown[0]), contents(tmp_path / "other")
    assert {"plan.json", "run.npz", "attitude.svg", "attitude.png", "torques.svg"} <= set(one)
    assert one.keys() == other.keys()
    assert [name for name in one if one[name] != other[name]] == []
