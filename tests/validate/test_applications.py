"""Campaigns of applications: cases, goals, and the truth about torques."""

from random import Random

import numpy as np
import pytest

from rigidsym._cli import main
from rigidsym.errors import InputError
from rigidsym.splitting import Trajectory
from rigidsym.validate import _torques as torques
from rigidsym.validate._applications import Application, Goal, Outcome
from rigidsym.validate._torques import APPLICATION, Case, reference

GOAL = Goal(refused=0.02, most=3.0, part=0.99, worst=10.0)


def outcomes(*shares):
    return [Outcome("some", k, share) for k, share in enumerate(shares)]


@pytest.mark.parametrize(
    ("shares", "sentence"),
    [
        ([0.5] * 98 + [None] * 2 + [2.9], ""),
        ([0.5] * 99 + [3.1], ""),
        ([0.5] * 97 + [None] * 3, "3 of 100 cases are refused, above 2%"),
        ([0.5] * 98 + [3.1] * 2, "2 of 100 errors are above 3 times the promised"),
        ([0.5] * 99 + [11.0], "the worst error is 11 times the promised, above 10"),
        ([0.5] * 199 + [np.nan], "the worst error is nan times the promised, above 10"),
        ([None], "1 of 1 cases are refused, above 2%"),
    ],
)
def test_a_goal_is_kept_or_not(shares, sentence):
    assert "; ".join(GOAL.broken(outcomes(*shares))) == sentence


def test_rows_say_how_strata_do():
    found = Application("some", {}, lambda case: None, GOAL).rows(outcomes(0.5, None, 4.0, 0.1))
    assert list(found) == [("some", "4", "1", "0.5", "4", "some:2", "1 above 3")]


def test_cases_are_those_of_a_seed_and_differ():
    one, same, other = (APPLICATION.draw("pulse", 3, seed) for seed in (1, 1, 2))
    assert one.omega0 == same.omega0 != other.omega0
    assert one.torque(0.1, np.array(one.q0), np.zeros(3)).tolist() == pytest.approx(
        same.torque(0.1, np.array(one.q0), np.zeros(3)).tolist()
    )


def test_a_stratum_that_does_not_exist_is_refused():
    with pytest.raises(InputError, match=r"^stratum = storm: must be one of: 'smooth'"):
        list(APPLICATION.outcomes(1, 1, ["storm"]))


def test_the_truth_about_a_jump_on_a_sphere():
    """About an axis a sphere turns by the integral of its rates."""

    def torque(t, q, omega):
        return np.array([0.0, 0.0, 6.0 if t < 0.7 else -2.0])

    still = (0.0, 0.0, 0.0)
    case = Case((2.0,) * 3, (1, 0, 0, 0), still, torque, (0.0, 2.0), (0.7,), (), "saba2", 1e-6)
    q, omega = reference(case)
    assert omega[-1] == pytest.approx([0, 0, 3 * 0.7 - 1.3], abs=1e-12)
    half = (1.5 * 0.7**2 + 2.1 * 1.3 - 0.5 * 1.3**2) / 2
    assert q[-1] == pytest.approx([np.cos(half), 0, 0, np.sin(half)], abs=1e-12)


def test_strata_are_what_they_say():
    """Torques of several strata at the breaks that they say."""
    for index in range(20):
        random = Random(index)
        case = torques.jump(random)
        q, zero = np.array(case.q0), np.zeros(3)
        for t in case.breaks:
            before, after = (case.torque(s, q, zero) for s in (t * (1 - 1e-12), t * (1 + 1e-12)))
            assert np.linalg.norm(after - before) > 1e-6 * np.linalg.norm(after + before)
    widths = []
    for index in range(60):
        case = torques.pulse(Random(index))
        q, zero = np.array(case.q0), np.zeros(3)
        times = np.linspace(0, case.times[-1], 4001)
        sizes = [np.linalg.norm(case.torque(t, q, zero)) for t in times]
        widths.append(np.mean(np.array(sizes) > max(sizes) / 2))
    assert 0 < min(widths) < 0.01
    assert torques.rest(Random(1)).omega0 == (0.0, 0.0, 0.0)


def test_torques_are_measured_by_the_command(capsys):
    assert main(["validate", "--torques", "--cases", "1", "--stratum", "jump"]) == 0
    printed = capsys.readouterr().out
    assert "rigidsym validate --torques" in printed
    assert "jump:0" in printed


def test_an_estimate_that_is_wrong_is_noticed(monkeypatch, capsys):
    """Steps that are a hundredth of those that the tolerance asks for."""
    true = torques.integrate

    def careless(*arguments, step, tolerance, **options) -> Trajectory:
        return true(*arguments, step=step, tolerance=1e3 * tolerance, **options)

    monkeypatch.setattr(torques, "integrate", careless)
    command = ["validate", "--torques", "--cases", "3", "--stratum", "kink", "--stratum", "smooth"]
    assert main(command) == 1
    assert "broken: " in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "line"),
    [
        (["numpy"], "targets = given: is not for --torques"),
        (["--digits", "30"], "digits = given: is not for --torques"),
        (["--stratum", "storm"], "stratum = storm: must be one of"),
    ],
)
def test_options_that_mean_nothing_are_refused(options, line, capsys):
    assert main(["validate", "--torques", *options]) == 2
    assert line in capsys.readouterr().err
