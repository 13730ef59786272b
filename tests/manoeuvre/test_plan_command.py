"""`rigidsym plan`: what it prints, leaves behind and refuses."""

import json

import numpy as np
import pytest

from rigidsym.cli import main

SHORT = """
inertia = ["0.0109", "0.04", "0.0506"]
start = [1, 0, 0, 0]
target = [0.9, 0.1, -0.2, 0.3]
duration = 20
"""


@pytest.fixture
def short(tmp_path):
    path = tmp_path / "short.toml"
    path.write_text(SHORT)
    return path


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


def test_its_case_files_reach_the_target(short, tmp_path, capsys):
    assert main(["plan", str(short), "-o", str(tmp_path / "found")]) == 0
    assert f"wrote {tmp_path / 'found' / 'plan.json'}" in capsys.readouterr().err
    case = tmp_path / "found" / "transfer-1.toml"
    assert main(["propagate", str(case)]) == 0
    last = capsys.readouterr().out.strip().splitlines()[-1]
    numbers = [float(x) for x in last.replace(",", " ").split()]
    target = np.array([0.9, 0.1, -0.2, 0.3]) / np.linalg.norm([0.9, 0.1, -0.2, 0.3])
    assert numbers[0] == 20
    assert abs(np.array(numbers[1:5]) @ target) == pytest.approx(1, abs=1e-9)


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
    short.write_text(SHORT.replace("[0.9, 0.1, -0.2, 0.3]", "[-1, 0, 0, 0]"))
    assert main(["plan", str(short)]) == 0
    assert "start equals target, nothing to do" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (SHORT + "[engine]\nthrust = 1", "manoeuvre = engine: is not one of: "),
        (SHORT.replace("start = [1, 0, 0, 0]", ""), "start = missing: a manoeuvre needs it"),
        (SHORT.replace("duration = 20", ""), "duration = missing: give one, or a limit"),
        (SHORT.replace("duration = 20", "duration = 0"), "duration = 0: must be above zero"),
        (SHORT.replace("duration = 20", "duration = nan"), "duration = nan: must be finite"),
        (SHORT.replace("0.9", "inf"), "target[0] = inf: must be finite"),
        (SHORT + "[limits]\nmax_rate = 1e-3", "max_rate = 0.001: no natural motion of 20 s keeps"),
        (SHORT + "[limits]\nmax_rate = '1'\nx = 1", "limits = x: is not one of: max_burst,"),
        (SHORT + "spin = 3", "spin = 3: must be a table of start, target"),
        ("inertia = [", "manoeuvre = the file: is not TOML"),
    ],
)
def test_bad_files_are_refused_in_one_line(short, text, message, capsys):
    short.write_text(text)
    assert main(["plan", str(short)]) == 2
    printed = capsys.readouterr()
    assert printed.err.startswith(f"rigidsym plan: {message}")
    assert printed.err.count("\n") == 1
    assert printed.out == ""
