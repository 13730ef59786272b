"""Tests of `rigidsym compare`: what it prints, writes and refuses, and that it stays the same."""

import json
import re
import subprocess
import sys
from copy import deepcopy
from dataclasses import asdict
from fractions import Fraction
from functools import partial

import extra_optimal  # noqa: F401
import pytest

from rigidsym.errors import InputError
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._comparison import compare, flights, optimiser
from rigidsym.manoeuvre._comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre._comparison.flights import draw
from rigidsym.manoeuvre._comparison.optimiser import Optimum, attempt
from rigidsym.manoeuvre._comparison.page import page
from rigidsym.manoeuvre._comparison.results import results, spread
from rigidsym.validate._executors import local

# Control at long periods makes flights quick.
COMMAND = """
import sys
from fractions import Fraction
from rigidsym._cli import main
from rigidsym.manoeuvre._comparison import flights
flights.PERIOD = Fraction(2)
sys.exit(main(["compare", "--manoeuvres", "1", "--workers", "1", "-o", "files"]))
"""


@pytest.fixture(scope="session")
def compared(once):
    """The files of a comparison on one manoeuvre, and what it prints."""

    def run(folder):
        command = [sys.executable, "-W", "error", "-c", COMMAND]
        done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
        assert done.returncode == 0, done.stderr
        (folder / "stdout").write_text(done.stdout)

    folder = once("compared", run)
    return folder / "files", (folder / "stdout").read_text()


@pytest.fixture(scope="session")
def data(compared):
    return json.loads((compared[0] / "comparison.json").read_text())


def test_files_and_tables(compared, data):
    directory, printed = compared
    names = {f"comparison.{suffix}" for suffix in ("json", "md", "svg", "png")}
    assert {path.name for path in directory.iterdir()} == names
    assert data["schema"] == "rigidsym.comparison/1"
    assert data["command"] == "rigidsym compare --manoeuvres 1 --seed 1"
    for title in ("flown with wheels", "flown with thrusters", "ideal bursts", "optimal control"):
        assert title in printed
    text = (directory / "comparison.md").read_text()
    assert "| natural | " in text
    assert "near the guess" in text


@pytest.mark.parametrize(("way", "name"), [("natural", "natural motion"), ("step", "step with")])
def test_conclusions_follow_the_numbers(data, way, name):
    summary = deepcopy(data["summary"])
    summary["flown"]["wheels"][way]["over_least_square"]["median"] = 1e9
    assert re.search(rf"The {name}[^.]* costs the most, 1e\+09 times", page("", 1, summary))


def test_what_holds_of_any_manoeuvre(data):
    (one,) = data["manoeuvres"]
    for task, solved in one["optimal"].items():
        assert solved["miss"] < 1e-3, task
        for attempts in solved["attempts"].values():
            assert all(x["converged"] and x["iterations"] < 500 for x in attempts.values())
    # No way of turning is cheaper than the cheapest, but for the width of a burst.
    for model, ways in one["ideal"].items():
        least = one["optimal"][f"{model}, fuel, unlimited"]["best"]
        assert least <= one["optimal"][f"{model}, fuel"]["best"]
        assert all(x > least * (1 - 1e-3) for x in ways.values())
    for model in ("wheels", "thrusters"):
        flown = one["flown"][model]
        assert flown["step"]["saturated"]
        assert flown["step"]["torque_integral"] > 2 * flown["natural"]["torque_integral"]
        assert flown["natural"]["error_after_hold"] < 0.1
    # To thrusters natural motions are free, to wheels turns at constant rates.
    natural, eigenaxis = ([one["ideal"][m][w] for m in Model] for w in ("natural", "eigenaxis"))
    assert natural[0] < eigenaxis[0]
    assert natural[1] > eigenaxis[1]


def test_the_same_each_time(data, monkeypatch):
    monkeypatch.setattr(flights, "PERIOD", Fraction(2))
    (one,) = data["manoeuvres"]
    case = draw(0, 1)
    transfer = solve(case.manoeuvre).best
    task = Task(Model.THRUSTERS, Cost.ENERGY)
    solved, impulses = optimiser.solved(case, transfer, task)
    assert json.loads(json.dumps(solved)) == one["optimal"][task.name]
    flown = flights.flown(case, transfer, Model.THRUSTERS, "natural", impulses)
    assert asdict(flown) == one["flown"]["thrusters"]["natural"]


@pytest.mark.parametrize(
    ("cost", "iterations", "converged", "best"),
    [(1.0, 10, True, True), (1.1, 5, True, False), (0.5, 500, False, False)],
)
def test_attempts_that_end_elsewhere_are_not_the_best(cost, iterations, converged, best):
    found = attempt(Optimum(cost, iterations, converged, None), unit=1.0, least=1.0)
    assert found["best"] == best


def test_a_task_that_is_not_solved_is_told(monkeypatch):
    monkeypatch.setattr(optimiser, "guesses", lambda case, transfer: {})
    with pytest.raises(InputError, match="manoeuvre = 0: wheels, energy: no optimum was found"):
        optimiser.solved(draw(0, 1), None, Task(Model.WHEELS, Cost.ENERGY))


def test_pieces_of_work_keep_their_order_and_tell_how_many_are_done():
    told = []
    with local(1) as place:
        calls = [partial(pow, 2, k) for k in range(3)]
        assert results(place, lambda: told.append(len(told)), calls) == [1, 2, 4]
    assert told == [0, 1, 2]


def test_progress_is_how_many_pieces_are_done_of_all(monkeypatch):
    def records(work, seed, indices):
        work([partial(pow, 2, k) for k in range(2)])
        work([partial(pow, 2, 2)])
        return ()

    told, module = [], "rigidsym.manoeuvre._comparison.results"
    monkeypatch.setattr(f"{module}._records", records)
    monkeypatch.setattr(f"{module}.TASKS", ())
    monkeypatch.setattr(f"{module}._WAYS", (None, None))
    compare(1, workers=1, progress=lambda done, total: told.append((done, total)))
    assert told == [(1, 3), (2, 3), (3, 3)]


def test_spreads():
    assert spread([3, 1, 2]) == {"min": 1, "q1": 1.5, "median": 2, "q3": 2.5, "max": 3}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"manoeuvres": 0}, "manoeuvres = 0: must be a whole number"),
        ({"manoeuvres": 2.5}, "manoeuvres = 2.5: must be a whole number"),
        ({"seed": -1}, "seed = -1: must be a whole number"),
    ],
)
def test_bad_numbers_are_refused(arguments, message):
    with pytest.raises(InputError) as refused:
        compare(**arguments)
    assert str(refused.value).startswith(message)


@pytest.mark.parametrize("option", ["--manoeuvres=0", "--seed=x", "--workers=-1"])
def test_bad_options_are_refused_in_one_line(option, refused):
    assert "must be a whole number" in refused("compare", option)
