"""Tests of plans: known answers, scaling, determinism, both engines, and the files."""

import json
from fractions import Fraction

import numpy as np
import pytest
from random_manoeuvres import BODY, KINDS, SKEW, START, manoeuvre, turn

import rigidsym
from rigidsym._inputs import exact_text
from rigidsym.errors import InputError
from rigidsym.io.cases import parse_case
from rigidsym.manoeuvre import plan, solve

TARGET, OTHER = (0.5, 0.5, 0.5, 0.5), (0.9, 0.1, -0.2, 0.3)
AXES = np.eye(3)
SPINS = [
    *(((2, 2, 2), SKEW, angle, 8, 1e-14) for angle in (1e-3, 1.0, 3.0)),
    *((body, AXES[2], angle, 8, 1e-13) for body in ((1, 1, 1.6), (1, 1, 0.4))
      for angle in (0.5, 2.0, 3.0)),
    *((BODY, AXES[k], angle, 10, 1e-13) for k in (0, 2) for angle in (0.3, 1.0)),
]  # fmt: skip


def aligned(q, target):
    """Return |cos| of half the angle between an attitude and a target of any length."""
    return abs(q @ np.asarray(target)) / np.linalg.norm(np.asarray(target, float))


def test_the_package_offers_the_function():
    """The first import of a module of the same name would hide the function."""
    from rigidsym import plan as first

    assert first is plan is rigidsym.plan is rigidsym.manoeuvre.plan


@pytest.mark.parametrize(("inertia", "axis", "angle", "duration", "within"), SPINS)
def test_spheres_symmetric_bodies_and_short_turns_about_stable_axes_spin(
    inertia, axis, angle, duration, within
):
    best, rate = plan(inertia, START, turn(axis, angle), duration).best, angle / duration
    assert best.omega0 == pytest.approx(rate * axis, abs=within)
    assert best.cost == pytest.approx(2 * rate * np.linalg.norm(inertia * axis))
    assert best.peak_rate == pytest.approx(rate)


@pytest.mark.parametrize("axis", range(3))
def test_half_turns_about_principal_axes_cost_no_more_than_spins(axis):
    best = plan(BODY, START, (0, *AXES[axis]), 10).best
    assert best.cost <= 2 * BODY[axis] * np.pi / 10 * (1 + 1e-12)
    assert best.residual <= 1e-12


@pytest.mark.parametrize("target", [START, (-1, 0, 0, 0), (3, 0, 0, 0)])
def test_nothing_to_do_costs_nothing(target):
    found = plan(BODY, START, target, 10)
    assert found.best.cost == 0
    assert found.title.endswith("start equals target, nothing to do")


def test_a_motion_that_costs_nothing_is_not_nothing_to_do():
    spin = (0, 0, np.pi)
    half = plan((1, 2, 3), START, (0, 0, 0, 1), 1, start_spin=spin, target_spin=spin)
    assert half.best.cost < 1e-12
    assert "nothing to do" not in half.title


@pytest.mark.parametrize("index", range(KINDS))
def test_plans_arrive_and_are_sorted(index):
    found = solve(manoeuvre(index, 51), 8).transfers
    costs = np.array([one.cost for one in found])
    assert len(found) == 8
    assert np.all(np.diff(costs) >= -1e-9 * costs[-1])
    assert max(one.residual for one in found) <= 1e-12
    target = [float(x) for x in found[0].manoeuvre.target]
    for one in found:
        assert aligned(one.motion(one.duration)[0], target) == pytest.approx(1, abs=1e-12)


@pytest.mark.parametrize("index", range(0, KINDS, 3))
def test_durations_and_inertias_only_scale(index):
    asked = manoeuvre(index, 51)
    given = (asked.start, asked.target)
    inertia = [float(x) for x in asked.inertia]
    one = plan(inertia, *given, 1).best
    other = plan([1024 * c for c in inertia], *given, "1e9").best
    assert other.omega0 * 1e9 == pytest.approx(one.omega0, rel=1e-9, abs=1e-9)
    assert other.cost * 1e9 == pytest.approx(1024 * one.cost, rel=1e-12)


@pytest.mark.parametrize("index", range(1, KINDS, 8))
def test_engines_give_the_same_plan(index):
    one, other = (solve(manoeuvre(index, 51), 3, engine).transfers for engine in ("c", "numpy"))
    for a, b in zip(one, other, strict=True):
        assert a.cost == pytest.approx(b.cost, rel=1e-10)
        assert b.residual <= 1e-12


def test_the_same_bytes_each_time():
    assert len({plan(BODY, START, OTHER, 20, families=5).to_json() for _ in range(3)}) == 1


def test_the_data_are_those_of_the_transfers():
    found = plan(BODY, START, OTHER, 20, families=2, start_spin=(0.01, 0, 0))
    data = json.loads(found.to_json())
    assert data["schema"] == "rigidsym.plan/1"
    assert data["manoeuvre"]["spin"]["start"] == [exact_text(Fraction(0.01)), "0", "0"]
    first, best = data["transfers"][0], found.best
    assert tuple(map(Fraction, map(float.fromhex, first["rates"]))) == best.rates
    assert first["cost"] == best.cost
    begin = np.array(BODY) * (best.omega0 - [0.01, 0, 0])
    assert np.array(first["bursts"][0]) == pytest.approx(begin, rel=1e-12)


def test_case_files_lead_to_the_target_and_those_of_an_earlier_plan_go(tmp_path):
    pictures = ["transfers.svg", "transfers.png"]
    paths = plan(BODY, (1, 2, 3, 4), OTHER, "12.5", families=3).write(tmp_path)
    cases = [f"transfer-{k}.toml" for k in (1, 2, 3)]
    assert [path.name for path in paths] == ["plan.json", *cases, *pictures]
    for path in paths[1:4]:
        case = parse_case(path.read_text())
        assert aligned(case.motion(case.times[-1])[0], OTHER) == pytest.approx(1, abs=1e-14)
    plan(BODY, START, TARGET, 180).write(tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {"plan.json", cases[0], *pictures}


def test_more_families_than_a_sphere_has_in_a_few_turns():
    found = plan((1, 1, 1), START, turn(AXES[0], 1), 1, families=250).transfers
    assert len(found) == 250
    assert max(one.residual for one in found) <= 1e-12


def test_another_duration_is_a_matter_of_scale():
    faster = plan(BODY, START, TARGET, 180, families=4).at("60")
    again = plan(BODY, START, TARGET, 60, families=4)
    for one, other in zip(faster.transfers, again.transfers, strict=True):
        np.testing.assert_allclose(one.omega0, other.omega0, rtol=1e-9)
        assert one.cost == pytest.approx(other.cost, rel=1e-12)
        assert one.peak_rate == pytest.approx(other.peak_rate, rel=1e-9)
        q, _ = one.motion.precise(60, 30)
        assert float(min(max(abs(q - s * np.array(TARGET))) for s in (1, -1))) < 1e-15


def test_another_duration_with_limits_is_planned():
    found = plan(BODY, START, TARGET, 180, max_rate=0.05)
    assert found.at(90).best.cost == pytest.approx(2 * found.best.cost, rel=1e-9)
    with pytest.raises(InputError, match=r"max_rate = 0\.05: no natural motion of 10 s"):
        found.at(10)
    with pytest.raises(InputError, match="duration = 0: must"):
        found.at(0)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"duration": 10_800, "start_spin": ("0.2",) * 3}, r"^spin\.start = .0\.2, 0\.2"),
        ({"inertia": ("1e-6", 1, 1)}, r"^inertia = \[0\.000001, 1, 1\]: a needle"),
        ({"inertia": (1, 1, 3)}, r"the sum of the other two$"),
        *(({"families": x}, r"families = .*: must be a whole number")
          for x in (0, -1, 1001, 1.5, True, "2", None)),
    ],
)  # fmt: skip
def test_impossible_plans_are_refused_with_the_users_own_numbers(given, message):
    asked = {"inertia": BODY, "start": START, "target": (0.8, 0.3, 0.3, 0.2), "duration": 1}
    with pytest.raises(InputError, match=message):
        plan(**(asked | given))


def test_a_momentum_that_never_comes_back_arrives_once():
    """Where an arc touches the separatrix, zero turns of an infinite period once took NaN."""
    body = (1.5614618325857683, 0.9442333873922403, 0.8275281761617398)
    start = (0.4211459948828172, -0.36191427026915857, -1.7221082322007564, 1.2177924171983394)
    target = (1.5432495368389407, 1.7878151306613748, 0.2170367220342138, 0.34622010602059483)
    with np.errstate(all="raise", under="ignore"):
        best = plan(body, start, target, 18.093347219088198).best
    assert best.cost > 0
