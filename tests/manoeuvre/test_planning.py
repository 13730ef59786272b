"""Plans: known answers, scaling, determinism, both engines, and what they are written as."""

import json
from fractions import Fraction

import numpy as np
import pytest
from random_manoeuvres import BODIES, TARGETS, manoeuvre

import rigidsym
from rigidsym.errors import InputError
from rigidsym.io.cases import parse_case
from rigidsym.manoeuvre import plan, solve

BODY = (0.0109, 0.04, 0.0506)
START = (1, 0, 0, 0)
TARGET = (0.5, 0.5, 0.5, 0.5)
AXES = np.eye(3)
KINDS = len(BODIES) * len(TARGETS)
PICTURE = ("transfers.svg", "transfers.png")


def turn(axis, angle):
    return (np.cos(angle / 2), *(np.sin(angle / 2) * np.asarray(axis)))


def test_the_package_offers_the_function():
    """Each time: the first import of a module of the same name would hide it."""
    from rigidsym import plan as first

    assert first is plan is rigidsym.plan is rigidsym.manoeuvre.plan


@pytest.mark.parametrize("angle", [1e-3, 1.0, 3.0])
def test_a_sphere_turns_about_the_axis_of_the_turn(angle):
    axis = np.array([2.0, -1.0, 2.0]) / 3
    best = plan((2, 2, 2), START, turn(axis, angle), 8).best
    assert best.omega0 == pytest.approx(angle / 8 * axis, abs=1e-14)
    assert best.cost == pytest.approx(4 * angle / 8)
    assert best.peak_rate == pytest.approx(angle / 8)


@pytest.mark.parametrize("inertia", [(1, 1, 1.6), (1, 1, 0.4)])
@pytest.mark.parametrize("angle", [0.5, 2.0, 3.0])
def test_a_symmetric_body_turns_about_its_axis_by_spinning(inertia, angle):
    best = plan(inertia, START, turn(AXES[2], angle), 8).best
    assert best.omega0 == pytest.approx(angle / 8 * AXES[2], abs=1e-13)


@pytest.mark.parametrize("axis", [0, 2])
@pytest.mark.parametrize("angle", [0.3, 1.0])
def test_short_turns_about_stable_axes_are_spins(axis, angle):
    best = plan(BODY, START, turn(AXES[axis], angle), 10).best
    assert best.omega0 == pytest.approx(angle / 10 * AXES[axis], abs=1e-13)
    assert best.cost == pytest.approx(2 * BODY[axis] * angle / 10)


@pytest.mark.parametrize("axis", range(3))
def test_half_turns_about_principal_axes_cost_no_more_than_spins(axis):
    best = plan(BODY, START, (0, *AXES[axis]), 10).best
    assert best.cost <= 2 * BODY[axis] * np.pi / 10 * (1 + 1e-12)
    assert best.residual <= 1e-12


@pytest.mark.parametrize("target", [START, (-1, 0, 0, 0), (3, 0, 0, 0)])
def test_nothing_to_do_costs_nothing(target):
    found = plan(BODY, START, target, 10)
    assert found.best.cost == 0
    assert "start equals target, nothing to do" in found.title


@pytest.mark.parametrize("index", range(KINDS))
def test_plans_arrive_and_are_sorted(index):
    found = solve(manoeuvre(index, 51), 8).transfers
    costs = np.array([one.cost for one in found])
    assert len(found) == 8
    assert np.all(np.diff(costs) >= -1e-9 * costs[-1])
    assert max(one.residual for one in found) <= 1e-12
    target = np.array([float(x) for x in found[0].manoeuvre.target])
    for one in found:
        q, _ = one.motion(one.duration)
        assert abs(q @ target) / np.linalg.norm(target) == pytest.approx(1, abs=1e-12)


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


def test_the_same_bytes_twice():
    texts = {plan(BODY, START, (0.9, 0.1, -0.2, 0.3), 20, families=5).to_json() for _ in range(3)}
    assert len(texts) == 1


def test_the_data_are_those_of_the_transfers():
    found = plan(BODY, START, (0.9, 0.1, -0.2, 0.3), 20, families=2, start_spin=(0.01, 0, 0))
    data = json.loads(found.to_json())
    assert data["schema"] == "rigidsym.plan/1"
    assert data["manoeuvre"]["spin"]["start"] == [inexact(0.01), "0", "0"]
    first, best = data["transfers"][0], found.best
    assert tuple(map(Fraction, map(float.fromhex, first["rates"]))) == best.rates
    assert first["cost"] == best.cost
    begin = np.array(BODY) * (best.omega0 - [0.01, 0, 0])
    assert np.array(first["bursts"][0]) == pytest.approx(begin, rel=1e-12)


def inexact(number):
    from rigidsym._inputs import exact_text

    return exact_text(Fraction(number))


def test_case_files_lead_to_the_target(tmp_path):
    target = np.array([0.9, 0.1, -0.2, 0.3])
    found = plan(BODY, (1, 2, 3, 4), target, "12.5", families=3)
    paths = found.write(tmp_path)
    assert [path.name for path in paths] == [
        "plan.json",
        *(f"transfer-{k}.toml" for k in (1, 2, 3)),
        *PICTURE,
    ]
    for path in paths[1:4]:
        case = parse_case(path.read_text())
        q, _ = case.motion(case.times[-1])
        assert abs(q @ target) / np.linalg.norm(target) == pytest.approx(1, abs=1e-14)


@pytest.mark.parametrize("count", [0, -1, 1001, 1.5, True, "2", None])
def test_counts_of_families_are_whole(count):
    with pytest.raises(InputError, match=r"families = .*: must be a whole number"):
        plan(BODY, START, (0, 1, 0, 0), 1, families=count)


def test_more_families_than_a_sphere_has_in_a_few_turns():
    found = plan((1, 1, 1), START, turn(AXES[0], 1), 1, families=250).transfers
    assert len(found) == 250
    assert max(one.residual for one in found) <= 1e-12


def test_another_duration_is_a_matter_of_scale():
    found = plan(BODY, START, TARGET, 180, families=4)
    faster = found.at("60")
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


def test_what_costs_nothing_says_why():
    assert plan(BODY, START, (-1, 0, 0, 0), 10).title.endswith("start equals target, nothing to do")
    spin = (0, 0, np.pi)
    half = plan((1, 2, 3), START, (0, 0, 0, 1), 1, start_spin=spin, target_spin=spin)
    assert half.best.cost < 1e-12
    assert "nothing to do" not in half.title


def test_case_files_of_an_earlier_plan_go(tmp_path):
    for families in (3, 1):
        plan(BODY, START, TARGET, 180, families=families).write(tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {
        "plan.json",
        "transfer-1.toml",
        *PICTURE,
    }


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"duration": 10_800, "start_spin": ("0.2",) * 3},
            r"^spin\.start = .0\.2, 0\.2",
        ),
        ({"duration": 1, "inertia": ("1e-6", 1, 1)}, r"^inertia = \[0\.000001, 1, 1\]: a needle"),
    ],
)
def test_too_many_motions_are_refused_by_the_users_own_numbers(given, message):
    asked = {"inertia": BODY, "start": START, "target": (0.8, 0.3, 0.3, 0.2)} | given
    with pytest.raises(InputError, match=message):
        plan(**asked)


def test_a_body_that_cannot_exist_is_refused_without_a_way_out():
    with pytest.raises(InputError, match=r"the sum of the other two$"):
        plan((1, 1, 3), START, TARGET, 1)


def test_a_momentum_that_never_comes_back_arrives_once():
    """An arc may touch the separatrix: no turns of an endless period took no time but NaN."""
    body = (1.5614618325857683, 0.9442333873922403, 0.8275281761617398)
    start = (0.4211459948828172, -0.36191427026915857, -1.7221082322007564, 1.2177924171983394)
    target = (1.5432495368389407, 1.7878151306613748, 0.2170367220342138, 0.34622010602059483)
    with np.errstate(all="raise", under="ignore"):
        best = plan(body, start, target, 18.093347219088198).best
    assert best.cost > 0
