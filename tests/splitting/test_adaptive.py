"""`rigidsym.integrate` with a tolerance: errors, jumps, refusals, and states in between."""

import numpy as np
import pytest

import rigidsym
from rigidsym.errors import InputError, PrecisionError
from rigidsym.splitting import METHODS, FieldPotential, GravityGradient, KeplerOrbit
from rigidsym.validate._torques import APPLICATION, Case, error, measured


def rotation(p, q):
    return np.max(2 * np.linalg.norm(p - q, axis=-1))


def run(pushed, tolerance=None, step=None):
    return rigidsym.integrate(*pushed.arguments, step=step, tolerance=tolerance, method="bm4")


@pytest.mark.parametrize("tolerance", [1e-3, 1e-6])
def test_the_error_is_below_the_tolerance_and_near_its_estimate(pushed, reference, tolerance):
    found = run(pushed, tolerance)
    truth = rotation(found.q, reference[0])
    assert found.error <= tolerance
    assert truth <= tolerance
    assert found.error / 10 < truth < 3 * found.error


def test_a_step_is_as_long_as_the_tolerance_lets_it(pushed, reference):
    found = run(pushed, 1e-5)
    assert rotation(run(pushed, step=2 * found.step).q, reference[0]) > 1e-5


def test_all_evaluations_are_counted(pushed):
    found = run(pushed, 1e-3)
    last = run(pushed, step=found.step)
    assert last.evaluations < found.evaluations < 3 * last.evaluations
    assert last.error is None


def test_a_body_at_rest_is_moved_by_its_torque(pushed):
    start = pushed.inertia, pushed.q0, (0.0, 0.0, 0.0), pushed.torque
    found = rigidsym.integrate(*start, [0.0, 1.0], step=None)
    assert found.error <= 1e-6
    assert np.all(found.omega[-1] != 0)


def noise():
    """Return a random torque, which no step resolves."""
    random = np.random.default_rng(1)
    return lambda t, q, omega: random.normal(size=omega.shape)


def test_what_no_step_reaches_is_refused_and_the_best_is_kept(pushed):
    start = pushed.inertia, pushed.q0, pushed.omega0, noise(), [0.0, 0.5]
    with pytest.raises(PrecisionError, match="tolerance = 1e-09: no step reaches it") as refused:
        rigidsym.integrate(*start, step=None, tolerance=1e-9, method="strang", rate_dependent=True)
    best = refused.value.trajectory
    assert 1e-9 < best.error < 0.1
    assert best.times.tolist() == [0.0, 0.5]


BODY, START, RATES, REST = (2.0, 3.0, 4.0), (1.0, 0.0, 0.0, 0.0), (0.5, 0.3, -0.2), (0.0,) * 3
SPIN = np.array([0.0, 0.0, 1.0])


def kink(t, q, omega):
    return max(0.0, np.sin(2 * t)) * SPIN + 0 * omega


def jump(t, q, omega):
    return (t > 3.3) * SPIN + 0 * omega


def bell(t, q, omega):
    """Return a smooth pulse of one second."""
    return np.exp(-((t - 37.3) ** 2)) * np.array([1.0, 0.3, 0.0]) + 0 * omega


FIELD = FieldPotential((0.0, 0.0, 1.0), linear=(0.5, 0.7, 0.2))


def shaken(t, q, omega):
    """Return the torque of a lever in a trembling field, which makes motions chaotic."""
    return (20 + 18 * np.sin(1.3 * t)) * FIELD(t, q, omega)


def adaptive(torque, times, omega0=RATES, **options):
    return rigidsym.integrate(BODY, START, omega0, torque, times, step=None, engine="c", **options)


def case(torque, times, breaks=(), omega0=RATES):
    """Return a case of the validation, whose reference is another integrator."""
    return Case(BODY, START, omega0, torque, times, breaks, (), "saba2", 1e-6)


KINKS = tuple(np.pi / 2 * np.arange(1, 7))
ROUGH = {
    "kinks, 1e-4": (kink, KINKS, "bm6", 1e-4),
    "kinks, 1e-6": (kink, KINKS, "bm6", 1e-6),
    "a jump, 1e-4": (jump, (3.3,), "saba2", 1e-4),
    "a jump, 1e-7": (jump, (3.3,), "aba84", 1e-7),
}


@pytest.mark.parametrize(("torque", "breaks", "method", "tolerance"), ROUGH.values(), ids=ROUGH)
def test_jumps_and_kinks_do_not_break_the_tolerance(torque, breaks, method, tolerance):
    found = adaptive(torque, (0.0, 10.0), method=method, tolerance=tolerance)
    truth = error(case(torque, (0.0, 10.0), breaks), found.q, found.omega)
    assert found.error <= tolerance
    assert truth <= tolerance
    for t in breaks:
        assert min(abs(np.array(found.rough) - t)) < 1e-3


@pytest.mark.parametrize("method", ["saba2", "aba84", "bm6"])
def test_a_pulse_on_a_body_at_rest_is_found_and_followed(method):
    found = adaptive(bell, (0.0, 50.0, 100.0), REST, method=method, tolerance=1e-6)
    truth = error(case(bell, (0.0, 50.0, 100.0), (34.0, 40.0), REST), found.q, found.omega)
    assert truth <= found.error <= 1e-6
    assert min(found.mesh.steps) < 0.5 < 2 < found.step


def test_pulses_of_a_two_hundredth_of_the_span_are_found():
    for begin in np.linspace(0.3, 99.0, 12):

        def box(t, q, omega, begin=begin):
            return 0.3 * (begin <= t < begin + 0.5) * SPIN + 0 * omega

        found = adaptive(box, (0.0, 100.0), REST, tolerance=1e-4)
        assert found.omega[-1] == pytest.approx(SPIN * 0.15 / 4, abs=1e-5)


def by_hash(t, q, omega):
    """Return a torque that is reproducible, but varies as fast as noise."""
    return np.sin(1e9 * t * np.arange(1.0, 4.0)) + 0 * omega


HOPELESS = {
    "noise": (noise(), 10.0, 1e-6, "the torque is not smooth anywhere near t = "),
    "as good as noise": (by_hash, 10.0, 1e-6, "the torque varies within .* s near t = "),
    "chaos": (shaken, 50.0, 1e-6, "motions that begin 1e-15 rad apart are .* rad apart"),
    "less than rounding": (kink, 20.0, 1e-15, "rounding alone amounts to .* rad"),
    "far less": (kink, 20.0, 1e-300, "rounding alone amounts to .* rad"),
}


@pytest.mark.parametrize(("torque", "end", "tolerance", "reason"), HOPELESS.values(), ids=HOPELESS)
def test_the_impossible_is_refused_by_its_reason_in_the_time_of_a_run(
    torque, end, tolerance, reason
):
    calls = 0

    def counted(t, q, omega):
        nonlocal calls
        calls += 1
        return torque(t, q, omega)

    with pytest.raises(PrecisionError, match=f"no step reaches it: {reason}") as refused:
        adaptive(counted, (0.0, end), method="bm6", tolerance=tolerance, rate_dependent=True)
    best = refused.value.trajectory
    assert "\n" not in str(refused.value)
    assert best.error > tolerance
    lengths = np.diff([*best.mesh.edges, end])
    steps = np.sum(np.ceil(lengths / best.mesh.steps))
    assert calls < 6 * max(steps * 4 * len(METHODS["bm6"].kicks), 5000)


def test_an_order_below_the_methods_is_said():
    def trembling(t, q, omega):
        return 1e-7 * by_hash(t, q, omega)

    assert adaptive(kink, (0.0, 10.0)).order == pytest.approx(2, abs=0.1)
    found = adaptive(trembling, (0.0, 10.0))
    assert found.order < 1.9
    assert found.error <= 1e-6


def test_a_jump_by_the_attitude_is_where_the_last_run_has_it():
    """The coarse first run has the jump, and the short panels, elsewhere."""
    drawn = APPLICATION.draw("facing", 60, 1)
    assert drawn.method == "strang"
    assert measured(drawn) < 3


def test_calls_are_evaluations_and_probes():
    calls = []

    def counted(t, q, omega):
        calls.append(t)
        return kink(t, q, omega)

    found = adaptive(counted, (0.0, 4.0))
    assert len(calls) == found.evaluations + found.probes
    assert 0 <= min(calls) <= max(calls) <= 4


def test_between_times_it_is_followed_by_its_own_steps():
    times = np.array([0.7, 3.2, 3.3, 3.4, 9.9])
    few, many = (adaptive(jump, t, method="bm6") for t in ((0.0, 10.0), (0.0, *times, 10.0)))
    assert rotation(few(times)[0], many.q[1:-1]) < 1e-6
    assert np.allclose(few(times)[1], many.omega[1:-1], rtol=0, atol=1e-6)


def test_many_bodies_are_as_good_as_each_alone():
    rates = [RATES, (0.1, 0.7, 0.2), REST]
    every = adaptive(kink, (0.0, 5.0, 10.0), rates)
    for k, omega0 in enumerate(rates):
        truth = error(case(kink, (0.0, 5.0, 10.0), KINKS, omega0), every.q[k], every.omega[k])
        assert truth <= 1e-6


def test_one_time_needs_no_step():
    found = adaptive(kink, [3.0])
    assert (found.q.tolist(), found.error) == ([list(START)], 0)


@pytest.mark.parametrize("omega0", [RATES, REST])
def test_no_torque_is_no_error(omega0):
    found = adaptive(lambda t, q, omega: 0 * omega, (0.0, 100.0), omega0)
    q, _ = rigidsym.propagate(BODY, omega0, [0.0, 100.0], START)
    assert rotation(found.q, q) < 1e-12
    assert found.error < 1e-12


def raising(t, q, omega):
    if t > 1:
        raise LookupError("the table ends")
    return 0 * omega


def ending(t, q, omega):
    return (np.nan if t > 1 else 0.0) * SPIN + 0 * omega


@pytest.mark.parametrize(("torque", "error"), [(raising, LookupError), (ending, InputError)])
def test_states_before_a_torque_fails_are_kept(torque, error):
    with pytest.raises(error) as stop:
        adaptive(torque, (0.0, 0.3, 0.9, 2.0))
    assert stop.value.trajectory.times.tolist() == [0.0, 0.3, 0.9]
    assert stop.value.trajectory(0.5)[0].shape == (4,)


def test_steps_begin_anew_at_discontinuities():
    """Errors fall with the method's order if the discontinuity is given."""
    arguments = BODY, START, RATES, jump, (0.0, 3.3, 10.0)
    told, twice, fine = (
        rigidsym.integrate(*arguments, step=step, method="bm4", discontinuities=[3.3], engine="c")
        for step in (0.4, 0.2, 0.02)
    )
    untold = rigidsym.integrate(*arguments, step=0.2, method="bm4", engine="c")
    assert rotation(told.q, fine.q) > 12 * rotation(twice.q, fine.q)
    assert rotation(untold.q, fine.q) > 100 * rotation(twice.q, fine.q)


@pytest.mark.parametrize("step", [0.3, None])
def test_discontinuities_come_in_any_order_and_beyond_the_times(step):
    arguments = BODY, START, RATES, jump, (0.0, 3.3, 10.0)
    one, other = (
        rigidsym.integrate(*arguments, step=step, discontinuities=given, engine="c")
        for given in ([3.3, 5.0], (5, 20, 3.3, 3.3, 0, -1, 10))
    )
    assert np.array_equal(one.q, other.q)
    assert one.mesh.edges == other.mesh.edges


def test_a_ready_made_torque_is_probed_by_c():
    tide = GravityGradient(BODY, KeplerOrbit(0.3, 1.5, 0.6))
    found = adaptive(tide, (0.0, 20.0), tolerance=1e-5)
    by_python = adaptive(lambda t, q, omega: tide(t, q, omega), (0.0, 20.0), tolerance=1e-5)
    assert rotation(found.q, by_python.q) < 1e-10
    assert found.probes == by_python.probes


TUMBLING = (1.0, 2.0, 2.5), (1.0, 0.0, 0.0, 0.0), (0.1, 0.2, 0.3)


def late_jump(t, q, omega):
    return np.array([0.1 * (t > 3.3), 0.02, 0.0])


def test_a_torque_may_return_the_same_array_each_time():
    room = np.zeros(3)

    def buffered(t, q, omega):
        room[:] = late_jump(t, q, omega)
        return room

    times = [0.0, 5.0, 10.0]
    one, other = (rigidsym.integrate(*TUMBLING, f, times, step=None) for f in (late_jump, buffered))
    assert np.array_equal(one.q, other.q)
    assert (one.error, one.rough) == (other.error, other.rough)


def test_the_error_has_what_a_jump_is_misplaced_by():
    times = [0.0, 5.0, 10.0]
    found = rigidsym.integrate(*TUMBLING, late_jump, times, step=None, method="bm6", tolerance=1e-3)
    exact = rigidsym.integrate(
        *TUMBLING, late_jump, times, step=0.1, method="bm6", discontinuities=[np.nextafter(3.3, 4)]
    )
    assert rotation(found.q, exact.q) <= found.error <= 1e-3


@pytest.mark.parametrize("engine", ["numpy", "c"])
@pytest.mark.parametrize("step", [None, 0.1])
def test_no_bodies_have_no_motion(engine, step):
    q, omega = np.zeros((0, 4)), np.zeros((0, 3))
    found = rigidsym.integrate(
        TUMBLING[0], q, omega, lambda t, q, omega: 0 * omega, [0.0, 1.0], step=step, engine=engine
    )
    assert (found.q.shape, found.omega.shape) == ((0, 2, 4), (0, 2, 3))


@pytest.mark.parametrize("last", [5e-324, 1e-300])
def test_times_as_near_as_doubles_are(last):
    found = rigidsym.integrate(*TUMBLING, late_jump, [0.0, last], step=None)
    assert found.q[-1] == pytest.approx(TUMBLING[1], abs=1e-15)
    again = rigidsym.integrate(*TUMBLING, late_jump, [0.0, 5.0], step=None, discontinuities=[last])
    assert again.error <= 1e-6
