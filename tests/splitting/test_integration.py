"""`rigidsym.integrate` with given steps: closed forms, states between times, bad input."""

import numpy as np
import pytest
from pushed_bodies import LEVER

import rigidsym
from rigidsym.errors import InputError
from rigidsym.quaternions import rotated
from rigidsym.splitting import METHODS, ConstantInBody, ConstantInSpace, FieldPotential

BODY = (2.0, 3.0, 4.0)
START = (1.0, 0.0, 0.0, 0.0)
RATES = (0.5, 0.3, -0.2)


def rotation(p, q):
    """Return the largest angle between quaternions, rad, sign included."""
    return np.max(2 * np.linalg.norm(p - q, axis=-1))


def free(t, q, omega):
    return np.zeros_like(omega)


def damping(t, q, omega):
    """Return a torque that damps the momentum by 0.1 per second."""
    return -0.1 * np.array(BODY) * omega


@pytest.mark.parametrize("name", METHODS)
def test_errors_fall_with_the_order_of_the_method(name, pushed, reference):
    coarse, fine = (
        rotation(rigidsym.integrate(*pushed.arguments, step=step, method=name).q, reference[0])
        for step in (1.0, 0.5)
    )
    assert coarse < 0.2
    assert np.log2(coarse / fine) > METHODS[name].order - 0.3


def test_rates_are_those_of_another_integrator(pushed, reference):
    found = rigidsym.integrate(*pushed.arguments, step=0.25, method="bm6")
    assert np.allclose(found.omega, reference[1], rtol=0, atol=1e-7)


@pytest.mark.parametrize(
    ("options", "rates", "times", "bound"),
    [
        *(({"step": 4.0, "method": x}, RATES, [0.0, 3.0, 10.0], 1e-14) for x in METHODS),
        # Short steps, and steps of more than 8 rad.
        *(({"step": step, "engine": x}, [RATES, (0.02, 0.01, 0.03)], [0.0, 80.0], 1e-13)
          for step in (4.0, 40.0) for x in ("numpy", "c")),
    ],
)  # fmt: skip
def test_without_a_torque_the_motion_is_free(options, rates, times, bound):
    found = rigidsym.integrate(BODY, START, rates, free, times, **options)
    q, omega = rigidsym.propagate(BODY, rates, times, START)
    assert rotation(found.q, q) < bound
    assert np.allclose(found.omega, omega, rtol=0, atol=bound)


@pytest.mark.parametrize("name", METHODS)
def test_a_constant_torque_in_space_adds_to_the_momentum(name):
    torque, times = np.array([0.3, -0.1, 0.2]), np.array([0.0, 1.0, 4.0])
    found = rigidsym.integrate(
        BODY, START, RATES, ConstantInSpace(torque), times, step=0.7, method=name
    )
    momentum = rotated(found.q, BODY * found.omega)
    assert np.allclose(momentum, momentum[0] + times[:, None] * torque, rtol=0, atol=1e-13)


def test_a_constant_torque_in_a_sphere_adds_to_its_rates():
    torque, times = np.array([0.3, -0.1, 0.2]), np.array([0.0, 1.0, 4.0])
    sphere = (2.0, 2.0, 2.0)
    found = rigidsym.integrate(sphere, START, RATES, ConstantInBody(torque), times, step=0.7)
    assert np.allclose(found.omega, RATES + times[:, None] * torque / 2, rtol=0, atol=1e-14)


def test_a_damped_body_moves_freely_in_a_time_that_slows_down():
    times = np.array([0.0, 2.0, 6.0])
    found = rigidsym.integrate(
        BODY, START, RATES, damping, times, step=0.5, method="bm4", rate_dependent=True
    )
    q, omega = rigidsym.propagate(BODY, RATES, (1 - np.exp(-0.1 * times)) / 0.1, START)
    assert rotation(found.q, q) < 1e-6
    assert np.allclose(found.omega, omega * np.exp(-0.1 * times)[:, None], rtol=0, atol=1e-6)


def test_many_bodies_are_as_each_alone(pushed):
    inertia = np.array([BODY, (1.0, 1.5, 2.0), (4.0, 3.0, 2.0)])
    omega0 = np.array([[RATES], [(0.1, 0.7, 0.2)]])
    times = [0.0, 1.0, 1.75]
    every = rigidsym.integrate(inertia, START, omega0, pushed.torque, times, step=0.5)
    assert every.q.shape == (2, 3, 3, 4)
    assert every.omega.shape == (2, 3, 3, 3)
    for i, j in ((0, 1), (1, 2)):
        alone = rigidsym.integrate(inertia[j], START, omega0[i, 0], pushed.torque, times, step=0.5)
        assert rotation(every.q[i, j], alone.q) < 1e-14


def test_the_times_asked_for_change_no_step(pushed):
    few, many = (
        rigidsym.integrate(*pushed.arguments[:4], times, step=0.4)
        for times in ([0.0, 4.0], [0.0, 0.1, 0.8, 1.3, 4.0])
    )
    assert rotation(few.q[-1], many.q[-1]) < 1e-14


def test_evaluations_are_counted(pushed):
    calls = []

    def counted(t, q, omega):
        calls.append(t)
        return pushed.torque(t, q, omega)

    found = rigidsym.integrate(*pushed.arguments[:3], counted, [0.0, 4.0], step=0.5)
    assert found.evaluations == len(calls) == 2 * 8 + 2


def test_the_attitude_begins_as_it_is_given_of_size_one():
    found = rigidsym.integrate(BODY, (-2.0, 0.0, 0.0, 0.0), RATES, free, [0.0], step=1.0)
    assert found.q.tolist() == [[-1.0, 0.0, 0.0, 0.0]]


def failing(t, q, omega):
    """Return no torque until t = 1 s, and NaN for the last body then."""
    torque = np.zeros_like(omega)
    torque[..., -1, 2] = np.nan if t > 1 else 0.0
    return torque


def stopping(t, q, omega):
    if t > 1:
        raise KeyboardInterrupt
    return np.zeros_like(omega)


@pytest.mark.parametrize(
    ("torque", "error"), [(failing, InputError), (stopping, KeyboardInterrupt)]
)
def test_what_is_interrupted_keeps_what_it_has(torque, error):
    times = [0.0, 0.3, 0.9, 2.0]
    with pytest.raises(error) as stop:
        rigidsym.integrate([BODY] * 2, START, RATES, torque, times, step=0.5, method="strang")
    kept = stop.value.trajectory
    assert kept.times.tolist() == times[:3]
    q, omega = rigidsym.propagate([BODY] * 2, [RATES] * 2, times[:3], START)
    assert rotation(kept.q, q) < 1e-14
    assert np.allclose(kept.omega, omega, rtol=0, atol=1e-14)


def test_a_torque_that_is_not_finite_is_named_by_body_time_and_value():
    line = r"^torque\[2\] = nan: must be finite \(body 1, t = 1.25 s\)"
    with pytest.raises(InputError, match=line):
        rigidsym.integrate([BODY] * 2, START, RATES, failing, [0.0, 2.0], step=0.5, method="strang")


BAD = {
    "a body that cannot exist": ({"inertia": (1.0, 1.0, 3.0)}, "^inertia = .*no body"),
    "a second one": ({"inertia": [BODY, (1.0, -1.0, 1.0)]}, r"^inertia\[1, 1\] = -1.0: .*positive"),
    "a short inertia": ({"inertia": (1.0, 2.0)}, r"^inertia = an array of shape \(2,\)"),
    "no attitude": ({"q0": (0.0, 0.0, 0.0, 0.0)}, "^q0 = .*must not be zero"),
    "rates that are no numbers": ({"omega0": (1.0, np.inf, 0.0)}, r"^omega0\[1\] = inf"),
    "batches": ({"inertia": [BODY] * 2, "omega0": [RATES] * 3}, "leading shapes must broadcast"),
    "no torque": ({"torque": None}, "^torque = None: must be a function"),
    "a torque of the time alone": ({"torque": lambda t: t}, r"^torque = a function of \(t\): must"),
    "a torque of a wrong shape": (
        {"torque": lambda *_: np.zeros(2)},
        r"^torque = an array of shape \(2,\)",
    ),
    "a torque that is none": (
        {"torque": lambda *_: "none"},
        "^torque = 'none': must be an array of numbers",
    ),
    "a torque of rates": ({"torque": damping}, "^torque = .*say rate_dependent=True"),
    "times that do not grow": ({"times": [0.0, 1.0, 1.0]}, r"^times\[2\] = 1.0: must be after"),
    "no times": ({"times": []}, "^times = .*one time at least"),
    "a number as times": ({"times": 1.0}, "^times = .*one-dimensional"),
    "a step of zero": ({"step": 0.0}, "^step = 0.0: must be positive"),
    "a step back": ({"step": -1.0}, "^step = -1.0: must be positive"),
    "many steps": ({"step": [1.0, 2.0]}, "^step = .*one number"),
    "a step that is lost": ({"step": 1e-17}, "^step = 1e-17: is lost beside times"),
    "an unknown method": ({"method": "euler"}, "^method = 'euler': must be one of"),
    "an unknown engine": ({"engine": "fortran"}, "^engine = "),
    "a tolerance beside a step": ({"tolerance": 1e-3}, "^tolerance = 0.001: is for step=None"),
    "a tolerance of zero": ({"step": None, "tolerance": 0.0}, "^tolerance = 0.0: must be positive"),
    "a discontinuity": ({"discontinuities": 0.5}, r"^discontinuities = an array of shape \(\)"),
    "no discontinuities": ({"discontinuities": None}, "^discontinuities = None: must be an array"),
    "a discontinuity at no time": (
        {"discontinuities": [0.5, np.nan]},
        r"^discontinuities\[1\] = nan: must be finite",
    ),
    "a switch that is none": ({"rate_dependent": 1}, "^rate_dependent = 1: must be true or false"),
}


@pytest.mark.parametrize(("changes", "line"), BAD.values(), ids=BAD)
def test_bad_input_is_refused_in_one_line(changes, line):
    good = {"inertia": BODY, "q0": START, "omega0": RATES, "torque": free, "times": [0.0, 1.0]}
    with pytest.raises(InputError, match=line) as refused:
        rigidsym.integrate(**{**good, "step": 0.5, **changes})
    assert "\n" not in str(refused.value)


def test_bodies_that_cannot_exist_are_taken_where_that_is_meant():
    found = rigidsym.integrate(
        (1.0, 1.0, 3.0), START, RATES, free, [0.0, 1.0], step=0.5, allow_nonphysical=True
    )
    assert np.isfinite(found.q).all()


def test_energy_does_not_drift():
    """Compare the energy of a lever in a field in the first and last of 10^5 steps."""
    field = FieldPotential((0.0, 0.0, 1.0), linear=-LEVER)
    times = np.linspace(0.0, 50_000.0, 2001)
    found = rigidsym.integrate(BODY, START, RATES, field, times, step=0.5, engine="c")
    kept = np.sum(BODY * found.omega**2, axis=-1) / 2 + field.energy(0.0, found.q)
    first, last = np.mean(kept[:200]), np.mean(kept[-200:])
    assert 1e-6 < np.ptp(kept) < 1e-2
    assert abs(last - first) < np.ptp(kept) / 10


@pytest.fixture(scope="module")
def trajectory(pushed):
    return rigidsym.integrate(*pushed.arguments, step=0.5, method="bm6")


def test_a_trajectory_is_its_states_and_a_function_of_time(trajectory):
    q, omega = trajectory
    assert (q is trajectory.q, omega is trajectory.omega) == (True, True)
    assert all(map(np.array_equal, trajectory(trajectory.times), trajectory))
    times = np.array([4.0, 1.2, 2.6, 1.2])
    assert np.array_equal(trajectory(times)[0][::-1], trajectory(times[::-1])[0])
    one = trajectory(2.0)
    assert [x.shape for x in one] == [(4,), (3,)]
    assert np.array_equal(one[0], trajectory([2.0])[0][0])


def test_between_times_it_is_as_good_as_at_them(trajectory, pushed):
    times = np.array([1.1, 1.5, 2.4, 2.5, 3.3, 5.0])
    every = rigidsym.integrate(*pushed.arguments[:4], [1.0, *times], step=0.5, method="bm6")
    q, omega = trajectory(times)
    assert np.allclose(q, every.q[1:], rtol=0, atol=1e-5)
    assert np.allclose(omega, every.omega[1:], rtol=0, atol=1e-5)


@pytest.mark.parametrize("t", [0.5, [2.0, 5.5], [[2.0]], "soon"])
def test_other_times_are_refused(trajectory, t):
    with pytest.raises(InputError, match=r"^t(\[\d\])? = "):
        trajectory(t)
