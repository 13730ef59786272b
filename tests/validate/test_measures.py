"""Measures of states, calls and steps: each detects the faults that it is for."""

import json
import math
from fractions import Fraction

import numpy as np
import pytest

from rigidsym import InputError
from rigidsym import _inputs as inputs
from rigidsym._engines import ENGINES, EngineError, batches, engine, exact_stepper, exactly
from rigidsym._engines.numpy_engine import NumpyEngine
from rigidsym.precise import PreciseMotion
from rigidsym.precise._balls import ball, bits_of, working
from rigidsym.validate import _entry_points as entry_points
from rigidsym.validate import validate
from rigidsym.validate._bounds import BOUNDS, MEASURES, bounds_of
from rigidsym.validate._finding import Finding, measure_case
from rigidsym.validate._implementations import Steps
from rigidsym.validate._measure import measure
from rigidsym.validate._oracle import distance, enclose
from rigidsym.validate._tally import Tally
from rigidsym.validate.faults import by_hand
from rigidsym.validate.faults._detection import mutated_engine
from rigidsym.validate.strata import STRATA, Sample, draw, stepped

UNIFORM = draw("uniform", 3, 5)
# An interval begins there.
MIDDLE = UNIFORM.times[len(UNIFORM.times) // 2]
SCALAR = np.array([1.0, 0.0, 0.0, 0.0])


class Altered:
    """NumPy's engine with something done to its states."""

    def __init__(self, change):
        self.engine, self.change = engine("numpy"), change

    def prepare(self, *state):
        return self.engine.prepare(*state)

    def states(self, prepared, t):
        return self.change(t, *self.engine.states(prepared, t))


def refused(t, q, omega):
    raise EngineError("t", "not today")


@pytest.mark.parametrize(
    ("change", "noticed", "not_noticed"),
    [
        # Longer, faster, turned, with the other sign, drifting, and no numbers.
        (lambda t, q, w: (q * (1 + 2e-15), w), {"angle", "norm"}, {"omega", "energy"}),
        (lambda t, q, w: (q, w * (1 + 4e-15)), {"omega"}, {"angle", "norm", "jump"}),
        (lambda t, q, w: (q[:, [1, 0, 2, 3]] * (1, -1, 1, 1), w),
         {"angle", "residual"}, {"omega", "norm", "jump"}),
        (lambda t, q, w: (np.where(t > MIDDLE, -1, 1)[:, None] * q, w),
         {"jump", "residual"}, {"omega", "norm"}),
        (lambda t, q, w: (q + 1e-14 * np.sin(20 * t)[:, None] * SCALAR, w),
         {"angle", "residual", "norm"}, {"omega"}),
        (lambda t, q, w: (np.vstack([np.full(4, np.nan), q[1:]]), w),
         {"angle", "norm", "jump"}, {"omega"}),
        (refused, set(MEASURES), set()),
    ],
)  # fmt: skip
def test_each_measure_notices_what_it_is_for(change, noticed, not_noticed):
    found = measure(enclose(UNIFORM, 40), Altered(change))
    beyond = {name for name, errors in found.items() if np.any(errors.share > 1)}
    assert noticed <= beyond
    assert not_noticed.isdisjoint(beyond)


def test_errors_of_states_that_are_refused_are_infinite_and_still_json(monkeypatch):
    from rigidsym.validate import _implementations as implementations

    monkeypatch.setattr(implementations.engines, "exactly", lambda name: Altered(refused))
    report = validate(["numpy"], cases=1, strata=["uniform"])
    assert not report.passed
    data = json.loads(report.to_json())
    assert data["implementations"][0]["strata"]["uniform"]["angle"]["units"] == "inf"
    (failure,) = report.failures
    assert failure.line.startswith("numpy: uniform:0: angle inf")


def test_drifts_are_judged_by_what_errors_of_the_rates_make_of_them():
    tenth = Altered(lambda t, q, omega: (q, 1.1 * omega))
    found = measure(enclose(UNIFORM, 40), tenth)
    for name in ("energy", "momentum"):
        np.testing.assert_allclose(found[name].units * 2**-53, 0.21, rtol=1e-9)
        assert np.all(found[name].condition >= 2)


def test_the_distance_from_the_separatrix():
    assert distance((1, 2, 3), (1, 0, 0)) == 1
    assert distance((1, 2, 3), (0, 0, 0)) == 1
    assert 0 < distance((4, 5, 9), (3, 1, 1 + 1e-9)) < 1e-8


def test_bounds_are_stated_for_every_measure():
    assert set(BOUNDS) == set(MEASURES)
    assert BOUNDS["angle"] == BOUNDS["omega"] == 2e-15


# Condition numbers are the norms of what differences of states tend to.

STEP, DIGITS = Fraction(1, 10**100), 250
# Differences of later states need more digits.
EARLY = 3


def differences(sample, time):
    """Return derivatives (7, 7) of q and omega by relative changes of rates, moments and time."""
    inertia, omega, attitude = sample.exact
    given, found = [*omega, *inertia, Fraction(time)], []
    for k, value in enumerate(given):
        ends = []
        for step in (STEP, -STEP):
            given[k] = value * (1 + step)
            motion = PreciseMotion(tuple(given[3:6]), tuple(given[:3]), attitude)
            ((q, rates),) = motion.enclosures([given[6]], DIGITS)
            ends.append([*q, *rates])
        given[k] = value
        with working(bits_of(DIGITS)):
            changes = [(x - y) / ball(2 * STEP) for x, y in zip(*ends, strict=True)]
        found.append(list(map(float, changes)))
    return np.array(found)


@pytest.mark.parametrize(
    "stratum",
    ["uniform", "near spin, middle", "separatrix", "needle", "large scales", "spin", "sphere",
     "rest"],
)  # fmt: skip
def test_condition_numbers_are_norms_of_derivatives(stratum):
    reference = enclose(draw(stratum, 1, seed=3), 40)
    for k, time in enumerate(reference.sample.times[:EARLY]):
        by_inputs = differences(reference.sample, time)
        angle = 2 * np.linalg.norm(by_inputs[:, :4])
        np.testing.assert_allclose(reference.condition["angle"][k], angle, rtol=1e-13, atol=1e-30)
        size = np.linalg.norm(reference.omega[0][k]) or 1.0
        rates = np.linalg.norm(by_inputs[:, 4:]) / size
        np.testing.assert_allclose(reference.condition["omega"][k], rates, rtol=1e-13, atol=1e-30)


def test_the_condition_tells_ill_conditioning_from_sloppiness():
    """The angle of a spin is omega t, and on the separatrix errors of the inputs grow like e^t."""
    body = (1.0, 2.0, 2.5), (0.0, 0.0, 0.5), (1.0, 0.0, 0.0, 0.0)
    spin = enclose(Sample("spin", 0, *body, (0.0, 30.0)), 40).condition
    assert spin["angle"][0] == 0
    assert 15 <= spin["angle"][1] < 150
    body = ((1.0, 2.0, 2.25), (0.75, 0.5, 1.0), (1.0, 0.0, 0.0, 0.0), (10.0, 20.0, 30.0))
    steep = enclose(Sample("separatrix", 0, *body), 40)
    growth = np.diff(np.log(steep.condition["angle"])) / 10
    # lambda of the rates, from H and K^2.
    expected = math.sqrt(0.25 * 3.3125 / 4.5)
    np.testing.assert_allclose(growth, expected, rtol=1e-3)
    assert steep.distance == 0
    found = measure_case(steep.sample, 40, ["numpy"])
    assert found.share("numpy") < 1


@pytest.mark.parametrize("digits", [20, 700])
def test_the_condition_is_there_at_any_digits(digits):
    found, expected = (enclose(UNIFORM, d).condition["angle"] for d in (digits, 40))
    np.testing.assert_allclose(found, expected, rtol=1e-14)


def test_conditions_beyond_binary64_are_infinite_and_still_json():
    reference = enclose(draw("separatrix", 0, seed=1), 40)
    found = {"c": measure(reference, engine("c"))}
    assert np.isinf(reference.condition["angle"]).any()
    assert not np.isnan(reference.condition["omega"]).any()
    data = json.loads(json.dumps(Finding(reference, found).to_data(), allow_nan=False))
    assert "inf" in data["condition"]["angle"]
    tally = Tally()
    tally.add("c", reference, found["c"])
    assert "inf" in tally.view("c", "angle", "condition")


def test_states_without_condition_numbers_are_the_same():
    sample = draw("uniform", 0, seed=1)
    found, alone = enclose(sample, 40), enclose(sample, 40, with_condition=False)
    assert np.array_equal(found.q[0], alone.q[0])
    assert np.isnan(alone.condition["angle"]).all()
    share = [measure(x, engine("numpy"))["angle"].share.max() for x in (found, alone)]
    assert share[0] == pytest.approx(share[1])


# What callers do is noticed where it changes states.

BODY = tuple(map(np.array, ((1.0, 2.0, 2.5), (0.3, -0.2, 0.9), (0.5, -1.0, 2.0, 0.25))))
TIMES = np.array([0.0, 1.0, -30.0])
KEEPS_RATES = next(
    f for f in by_hand() if f.line == "numpy: the caller's rates kept in a prepared motion"
)


class Unchecked(NumpyEngine):
    """Engine that does not check for shared memory, as NumPy's once did."""

    def propagate(self, inertia, omega0, attitude0, t, out=None, errors="raise"):
        states = self.module.states(self.module.prepare(inertia, omega0, attitude0, errors), t)
        for given, found in zip(out or states, states, strict=True):
            given[...] = found
        return out or states


class Reading(Unchecked):
    """Unchecked engine that writes states before all inputs are read."""

    def propagate(self, inertia, omega0, attitude0, t, out=None, errors="raise"):
        if out is None or errors == "nan":
            return super().propagate(inertia, omega0, attitude0, t, out, errors)
        for k in range(len(omega0)):
            prepared = self.module.prepare(inertia[k], omega0[k], attitude0[k])
            out[0][k], out[1][k] = self.module.states(prepared, t)
        return out


class Keeping(NumpyEngine):
    """Engine that does not write states of bodies that are refused."""

    def propagate(self, inertia, omega0, attitude0, t, out=None, errors="raise"):
        found = super().propagate(inertia, omega0, attitude0, t, None, errors)
        for given, states in zip(out or found, found, strict=True):
            np.copyto(given, states, where=~np.isnan(states))
        return out or found


def apart(engine, body=BODY):
    return [entry_points._apart(*both) for both in entry_points.by_callers(engine, body, TIMES)]


@pytest.mark.parametrize("name", ENGINES)
def test_engines_refuse_outputs_that_are_inputs_and_change_nothing(name):
    overwritten, mixed = apart(exactly(name))
    assert overwritten == 0
    assert mixed < 4e-15


@pytest.mark.parametrize("size", [2.0**-1073, 2.0**-300, 2.0**1018])
@pytest.mark.parametrize("name", ENGINES)
def test_bodies_of_every_size_have_company(name, size):
    body = (np.array([16.0, 16.0, 1.0]) * size, *BODY[1:])
    assert max(apart(exactly(name), body)) < 4e-15


def test_states_that_are_not_written_are_noticed():
    assert np.isnan(apart(Keeping())[-1])


def test_a_plan_that_keeps_memory_is_noticed():
    assert apart(mutated_engine(KEEPS_RATES))[0] > 1


def test_outputs_that_are_read_after_they_are_written_are_noticed():
    _, *aliased, _ = apart(Reading())
    # Rates written over moments are no moments, and refused.
    assert len(aliased) == 2
    assert max(aliased) > 0.1
    # An engine may as well compute all before it writes any.
    _, *aliased, _ = apart(Unchecked())
    assert max(aliased) < 4e-15


def only_the_first(inertia, allow_nonphysical, lenient):
    """Examine only the first of the bodies that rounding makes look impossible, as it was once."""
    scaled = inertia / np.max(inertia, axis=-1, keepdims=True)
    for place in np.argwhere((inertia > 0).all(-1) & (np.sum(scaled, axis=-1) < 2))[:1]:
        inputs.inertia(inertia[tuple(place)].tolist())
    return inertia


def test_an_impossible_body_behind_a_flat_one_is_noticed(monkeypatch):
    monkeypatch.setattr(batches, "possible", only_the_first)
    assert np.isnan(apart(exactly("numpy"))[-1])


# Steps are measured in every stratum, at times within a turn.

STEPS = ("numpy-step", "c-step")


@pytest.mark.parametrize(
    "drawn",
    [
        {"cases": 1, "strata": ["rod", "scales"]},
        pytest.param({"cases": 60, "workers": None}, marks=pytest.mark.slow),
    ],
)
def test_steps_are_within_every_bound(drawn):
    report = validate(STEPS, seed=5, **drawn)
    for target in STEPS:
        for stratum in report.campaign.strata:
            for name in MEASURES:
                cell = report.tally.cells[target, name, "share", stratum]
                assert (cell.count, cell.worst <= 1) == (0, True), (target, stratum, name)


def test_the_bounds_of_steps_are_half_of_those_of_motions():
    for target in STEPS:
        assert bounds_of(target)["angle"] == bounds_of(target)["omega"] == 1e-15
        assert bounds_of(target)["norm"] == BOUNDS["norm"]


def test_samples_of_steps_are_doubles_within_a_turn():
    for stratum in STRATA:
        given, made = draw(stratum, 0, 1), stepped(draw(stratum, 0, 1))
        assert made.in_doubles
        rate = math.hypot(*made.omega0) or 1.0
        assert all(abs(t) * rate <= 2 * math.pi for t in made.times)
        for before, after in zip(given.times, made.times, strict=True):
            assert math.frexp(before)[0] == math.frexp(after)[0]
            assert before == after or abs(after) * rate > 3
        assert stepped(made) == made


@pytest.mark.parametrize(
    ("targets", "line"),
    [
        (["numpy", "c-step"], r"^target = numpy, c-step: steps are measured within a turn"),
        (["c_single", "c_single-step"], r"^target = c_single, c_single-step: steps are"),
        (["fortran"], r"^target = 'fortran'|^target = fortran: must be one of"),
    ],
)
def test_steps_and_motions_are_measured_apart(targets, line):
    with pytest.raises(InputError, match=line):
        validate(targets, cases=1)


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
    reference = enclose(stepped(draw("uniform", 0, 5)), 30)
    found = measure(reference, Steps(Worse(change)), bounds_of("numpy-step"))
    assert np.max(found[name].share) > 1


def test_a_case_of_a_step_has_what_the_step_was_asked():
    sample = Sample("mine", 0, (1.0, 2.0, 2.5), (0.3, 0.5, -0.7), (1.0, 0.0, 0.0, 0.0), (0.0, 90.0))
    found = measure_case(sample, 30, ["numpy-step"])
    assert found.sample.times == (0.0, 90.0 / 16)
    assert found.share("numpy-step") <= 1
