"""Steps as an implementation: measured in every stratum, at times within a turn, and noticed."""

import math

import numpy as np
import pytest

from rigidsym import InputError
from rigidsym._engines import exact_stepper
from rigidsym.validate import validate
from rigidsym.validate._bounds import BOUNDS, MEASURES, bounds_of
from rigidsym.validate._finding import measure_case
from rigidsym.validate._implementations import Steps
from rigidsym.validate._measure import measure
from rigidsym.validate._oracle import enclose
from rigidsym.validate.strata import STRATA, Sample, draw, stepped

TARGETS = ("numpy-step", "c-step")
UNIFORM = draw("uniform", 0, 5)


def within(report):
    for target in TARGETS:
        for stratum in report.campaign.strata:
            for name in MEASURES:
                cell = report.tally.cells[target, name, "share", stratum]
                assert (cell.count, cell.worst <= 1) == (0, True), (target, stratum, name)


def test_steps_are_within_every_bound():
    within(validate(TARGETS, cases=1, seed=5, strata=["rod", "scales"]))


@pytest.mark.slow
def test_steps_are_within_every_bound_in_every_stratum():
    within(validate(TARGETS, cases=60, seed=5, workers=None))


def test_the_bounds_of_steps_are_half_of_those_of_motions():
    for target in TARGETS:
        assert bounds_of(target)["angle"] == bounds_of(target)["omega"] == 1e-15
        assert bounds_of(target)["norm"] == BOUNDS["norm"]


def test_samples_are_doubles_within_a_turn():
    for stratum in STRATA:
        given, made = draw(stratum, 0, 1), stepped(draw(stratum, 0, 1))
        assert made.in_doubles
        rate = math.hypot(*made.omega0) or 1.0
        assert all(abs(t) * rate <= 2 * math.pi for t in made.times)
        for before, after in zip(given.times, made.times, strict=True):
            assert math.frexp(before)[0] == math.frexp(after)[0]
            assert before == after or abs(after) * rate > 3
        assert stepped(made) == made


def test_steps_and_motions_are_measured_apart():
    with pytest.raises(InputError, match=r"^target = numpy, c-step: steps go a turn at most"):
        validate(["numpy", "c-step"], cases=1)
    with pytest.raises(InputError, match=r"^target = 'fortran'|^target = fortran: must be one of"):
        validate(["fortran"], cases=1)


class Worse:
    """NumPy's steps with something done to what they give."""

    def __init__(self, change):
        self.stepper, self.change = exact_stepper("numpy-step"), change

    def step(self, inertia, q, omega, dt, out):
        self.stepper.step(inertia, q, omega, dt, out)
        self.change(q, out)


@pytest.mark.parametrize(
    ("change", "name"),
    [
        (lambda q, out: np.multiply(out[0], (1, *3 * [1 + 1.5e-15]), out[0]), "angle"),
        (lambda q, out: out[0] is q and np.multiply(out[1], 1 + 4e-15, out[1]), "entry_points"),
        (lambda q, out: len(q) == 1 and np.multiply(out[1], 1 + 4e-15, out[1]), "entry_points"),
    ],
    ids=["turned", "slow in place", "wrong alone"],
)
def test_what_is_wrong_with_steps_is_noticed(change, name):
    reference = enclose(stepped(UNIFORM), 30)
    found = measure(reference, Steps(Worse(change)), bounds_of("numpy-step"))
    assert np.max(found[name].share) > 1


def test_a_case_of_a_step_has_what_the_step_was_asked():
    sample = Sample("mine", 0, (1.0, 2.0, 2.5), (0.3, 0.5, -0.7), (1.0, 0.0, 0.0, 0.0), (0.0, 90.0))
    found = measure_case(sample, 30, ["numpy-step"])
    assert found.sample.times == (0.0, 90.0 / 16)
    assert found.share("numpy-step") <= 1
