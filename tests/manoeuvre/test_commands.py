"""`rigidsym track` and `rigidsym figures`: what they print, leave behind and refuse."""

import json
import os
import re
import subprocess
import sys
from itertools import product

import numpy as np
import pytest

from rigidsym.cli import main

SHORT = """
inertia = ["0.0109", "0.04", "0.0506"]
start = [1, 0, 0, 0]
target = [0.9, 0.1, -0.2, 0.3]
duration = 20
[run]
length = 50

[message]
creation_date = 2026-01-01T00:00:00Z
"""


@pytest.fixture
def short(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text(SHORT)
    return path


@pytest.fixture(scope="module")
def figures(tmp_path_factory):
    """What `rigidsym figures` leaves and prints."""
    directory = tmp_path_factory.mktemp("figures")
    command = [sys.executable, "-W", "error", "-m", "rigidsym", "figures", "-o", str(directory)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return directory, done.stdout


def test_track(short, tmp_path, capsys):
    assert main(["track", str(short), "-o", str(tmp_path / "flown")]) == 0
    printed = capsys.readouterr()
    assert "settled at the target" in printed.out
    assert "nothing to do" not in printed.out
    assert len(re.findall(r"unexplained.* below \de-", printed.out)) == 2
    assert f"wrote {tmp_path / 'flown' / 'summary.json'}" in printed.err
    with np.load(tmp_path / "flown" / "run.npz") as states:
        q = states["q"][-1]
    target = np.array([0.9, 0.1, -0.2, 0.3])
    assert q @ target / np.linalg.norm(target) == pytest.approx(1, abs=1e-6)


def test_track_as_json(short, capsys):
    assert main(["track", str(short), "--json"]) == 0
    summary = json.loads(capsys.readouterr().out)
    assert summary["schema"] == "rigidsym.track/1"
    assert summary["transfer"]["duration"] == 20
    assert summary["flight"]["run"]["length"] == 50


def test_a_target_that_is_missed_is_told(short, capsys):
    short.write_text(SHORT.replace("length = 50", "length = 21"))
    assert main(["track", str(short)]) == 1
    assert "not within 0.1 deg at the end" in capsys.readouterr().out


def test_a_start_that_is_the_target_is_told(short, capsys):
    short.write_text(SHORT.replace("[0.9, 0.1, -0.2, 0.3]", "[-2, 0, 0, 0]"))
    assert main(["track", str(short)]) == 0
    printed = capsys.readouterr().out
    assert re.search(r"start equals target\W+nothing to do", printed)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (SHORT + "[orbit]\naltitude = -1", "orbit.altitude = -1: must be above the surface, km"),
        (SHORT + "[engine]\nthrust = 1", "manoeuvre = engine: is not one of: "),
        (SHORT.replace("start", "begin"), "manoeuvre = begin: is not one of: "),
        (SHORT.replace("start = [1, 0, 0, 0]", ""), "start = missing: a manoeuvre needs it"),
        (SHORT.replace("duration = 20", ""), "duration = missing: give one, or a limit"),
        (SHORT.replace("0.9", "nan"), "target[0] = nan: must be finite"),
        ("inertia = [", "manoeuvre = the file: is not TOML"),
    ],
)
def test_bad_files_are_refused_in_one_line(short, text, message, capsys):
    short.write_text(text)
    assert main(["track", str(short)]) == 2
    error = capsys.readouterr().err
    assert error.startswith(f"rigidsym track: {message}")
    assert error.count("\n") == 1


def test_a_file_that_is_not_there(capsys):
    assert main(["track", "nowhere.toml"]) == 2
    assert "manoeuvre = nowhere.toml: cannot be read" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("package", "command"),
    [
        ("scipy", "plan paper"),
        *product(("scipy", "erfa", "ppigrf", "matplotlib"), ("track paper", "figures")),
    ],
)
def test_missing_packages_are_named_in_one_line(package, command, tmp_path):
    code = (
        f"import sys\nsys.modules[{package!r}] = None\nfrom rigidsym.cli import main\n"
        f"sys.exit(main({command.split()!r}))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, cwd=tmp_path
    )
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert f"packages = {package}: " in done.stderr
    assert "pip install 'rigidsym[app]'" in done.stderr


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


# Settings that change lines, texts, backgrounds, sizes and ids.
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


PLAN_AND_TRACK = """
import sys
from rigidsym.cli import main
for command in ("plan", "track"):
    assert main([command, *sys.argv[1:]]) == 0
"""


def flown(short, directory, **environment):
    """The files of `rigidsym plan` and `rigidsym track` in an environment, by name."""
    words = ["-W", "error", "-c", PLAN_AND_TRACK, str(short), "-o", str(directory)]
    subprocess.run(
        [sys.executable, *words], env={**os.environ, **environment}, capture_output=True, check=True
    )
    return {path.name: path.read_bytes() for path in directory.iterdir()}


def test_files_are_the_same_in_all_environments(short, tmp_path):
    """Whatever the order of sets, the number of threads and the user's settings of matplotlib."""
    settings = tmp_path / "matplotlibrc"
    settings.write_text(SETTINGS)
    own = {"MATPLOTLIBRC": str(settings), "PYTHONHASHSEED": "7", "OMP_NUM_THREADS": "2"}
    one = flown(short, tmp_path / "one", PYTHONHASHSEED="0", OMP_NUM_THREADS="1")
    other = flown(short, tmp_path / "other", **own)
    assert {"plan.json", "run.npz", "attitude.svg", "attitude.png", "torques.svg"} <= set(one)
    assert one.keys() == other.keys()
    assert [name for name in one if one[name] != other[name]] == []
