"""The loop in C gives the same states as steps and kicks from Python."""

import ctypes

import numpy as np
import pytest

import rigidsym
from rigidsym._engines.build import compile_library, find
from rigidsym.errors import InputError
from rigidsym.splitting import (
    METHODS,
    ConstantInBody,
    ConstantInSpace,
    FieldPotential,
    GravityGradient,
    KeplerOrbit,
    TorqueInC,
)
from rigidsym.splitting import _stepping as stepping

BODY, START, RATES = (2.0, 3.0, 4.0), (1.0, 0.0, 0.0, 0.0), (0.5, 0.3, -0.2)
MOMENT, TIMES = np.array([0.1, 0.2, 0.3]), [0.0, 2.0, 5.3]
QUADRATIC = np.array([[0.3, 0.1, 0.0], [0.1, -0.2, 0.4], [0.0, 0.4, 0.1]])
TILTED = {"inclination": 0.4, "node": 1.0, "argument": 2.0, "epoch": 0.5}
TORQUES = {
    "in the body": ConstantInBody((0.1, -0.2, 0.05)),
    "in space": ConstantInSpace((0.1, -0.2, 0.05)),
    "a dipole": FieldPotential((0.0, 0.3, 1.0), linear=(0.1, 0.2, 0.3)),
    "a quadrupole": FieldPotential((0.0, 0.3, 1.0), quadratic=QUADRATIC),
    "gravity on a circle": GravityGradient(BODY, KeplerOrbit(0.3, 1.5, **TILTED)),
    "gravity on an ellipse": GravityGradient(BODY, KeplerOrbit(0.3, 1.5, 0.6, **TILTED)),
    "gravity on a hyperbola": GravityGradient(BODY, KeplerOrbit(0.3, 1.5, 1.6, **TILTED)),
}


def by_python(torque):
    """Hide the class of a torque, so that C cannot integrate it."""
    return lambda t, q, omega: torque(t, q, omega)


def both(torque, inertia=BODY, rates=RATES, times=TIMES, reference=None, **options):
    """Integrate by the engine in C under a torque, and under its reference in Python."""
    options = {"step": 0.5, "engine": "c", **options}
    return (
        rigidsym.integrate(inertia, START, rates, x, times, **options)
        for x in (torque, reference or by_python(torque))
    )


def apart(one, other):
    return max(np.max(np.abs(x - y)) for x, y in zip(one, other, strict=True))


@pytest.fixture
def calls(monkeypatch):
    """Record the step numbers in each call of the loop."""
    found, advance = [], stepping._advance_in_c

    def counted(*arguments):
        found.append(arguments[-1])
        return advance(*arguments)

    monkeypatch.setattr(stepping, "_advance_in_c", counted)
    return found


@pytest.mark.parametrize("torque", TORQUES.values(), ids=TORQUES)
@pytest.mark.parametrize("count", [1, 3, 20])
def test_it_is_what_python_makes_of_the_torque(torque, count, calls):
    rates = np.array(RATES) * np.linspace(1.0, 2.0, count)[:, None]
    found, expected = both(torque, rates=rates, step=0.25)
    free = rigidsym.propagate(BODY, rates, TIMES, START)
    assert calls
    assert apart(found, expected) < 1e-13 < 1e-2 < apart(found, free)
    assert found.evaluations == expected.evaluations


@pytest.mark.parametrize("method", METHODS)
def test_every_method_is(method):
    torque = TORQUES["gravity on an ellipse"]
    assert apart(*both(torque, [BODY, (4.0, 3.0, 2.0)], method=method)) < 1e-13


def test_bodies_may_have_torques_and_fields_of_their_own():
    torque = FieldPotential([(0.0, 0.3, 1.0), (1.0, 0.0, 0.0)], linear=[(0.1, 0.2, 0.3)] * 2)
    assert apart(*both(torque, [BODY, (4.0, 3.0, 2.0)])) < 1e-13


@pytest.mark.parametrize(
    ("name", "value", "count", "bound"),
    [("rigidsym.splitting._stepping._AT_ONCE", 12, 2, 1e-13),
     ("rigidsym._engines.threads.threads", lambda states: 2, 150, 0)],
)  # fmt: skip
def test_steps_in_a_call_and_threads_change_nothing(name, value, count, bound, monkeypatch):
    rates = np.array(RATES) * np.linspace(1.0, 2.0, count)[:, None]
    start = BODY, START, rates, TORQUES["a dipole"], TIMES
    whole = rigidsym.integrate(*start, step=0.1, engine="c")
    monkeypatch.setattr(name, value)
    assert apart(whole, rigidsym.integrate(*start, step=0.1, engine="c")) <= bound


LEVER = """
void lever(double t, const double q[4], double torque[3], void *data)
{
    const double *m = data, a = q[0], b = q[1], c = q[2], d = q[3];
    const double x = 2.0 * (b * d - a * c), y = 2.0 * (c * d + a * b);
    const double z = a * a - b * b - c * c + d * d;
    torque[0] += m[1] * z - m[2] * y;
    torque[1] += m[2] * x - m[0] * z;
    torque[2] += m[0] * y - m[1] * x;
}
"""


@pytest.fixture(scope="module")
def lever(tmp_path_factory):
    """Compile a C function for a dipole in a field along z."""
    place = tmp_path_factory.mktemp("lever")
    return ctypes.CDLL(str(compile_library(find(), {"lever.c": LEVER}, place))).lever


def test_a_function_of_c_is_a_torque(lever, engine):
    torque, field = TorqueInC(lever, MOMENT.ctypes.data), FieldPotential((0, 0, 1), linear=MOMENT)
    rates = np.array(RATES) * np.linspace(1.0, 2.0, 3)[:, None]
    assert apart(*both(torque, rates=rates, reference=field, engine=engine)) < 1e-13


def test_it_may_be_an_address(lever):
    address = ctypes.cast(lever, ctypes.c_void_p).value
    q, omega = np.array([[0.1, -0.7, 0.5, 0.5]]), np.zeros((1, 3))
    found = [TorqueInC(x, MOMENT.ctypes.data)(0.0, q, omega) for x in (lever, address)]
    assert np.array_equal(*found)
    assert np.all(found[0] != 0)


@pytest.mark.parametrize(
    ("arguments", "line"),
    [
        (("lever",), "^function = 'lever': must be a function of ctypes"),
        ((0,), "^function = 0: must be a function of ctypes"),
        ((None,), "^function = None: must be a function of ctypes"),
        ((4096, 1.5), "^data = 1.5: must be an address"),
        ((4096, True), "^data = True: must be an address"),
    ],
)
def test_what_is_no_function_of_c_is_refused(arguments, line):
    with pytest.raises(InputError, match=line):
        TorqueInC(*arguments)


def test_what_it_refuses_is_done_by_python(calls):
    """Drifts of 25 rad are too long for a step."""
    torque = TORQUES["in the body"]
    found, expected = both(torque, times=[0.0, 80.0], step=40.0)
    assert calls
    assert apart(found, expected) == 0
    assert found.evaluations == expected.evaluations


def test_a_torque_that_overflows_is_named_by_body_and_time():
    """At the start the body is aligned with the field, and has no torque."""
    torque = FieldPotential((0.0, 0.0, 1e3), linear=[(0.0, 0.0, 1e-3), (0.0, 0.0, 1e308)])
    line = r"^torque\[0\] = .*must be finite \(body 1, t = 0.25 s\)"
    options = {"step": 0.5, "engine": "c", "method": "strang"}
    with pytest.raises(InputError, match=line), np.errstate(over="ignore"):
        rigidsym.integrate([BODY] * 2, START, RATES, torque, TIMES, **options)


def test_ctrl_c_is_heard_between_calls_and_keeps_what_was_reached(monkeypatch):
    advance = stepping._advance_in_c

    def stopping(found, state, begin, step, numbers):
        if numbers[1] > 4:
            raise KeyboardInterrupt
        return advance(found, state, begin, step, numbers)

    monkeypatch.setattr(stepping, "_advance_in_c", stopping)
    start = BODY, START, RATES, TORQUES["a dipole"]
    with pytest.raises(KeyboardInterrupt) as stop:
        rigidsym.integrate(*start, [0.0, 1.0, 2.0, 3.0], step=0.5, engine="c")
    assert stop.value.trajectory.times.tolist() == [0.0, 1.0, 2.0]


def test_it_serves_where_there_is_no_compiler(monkeypatch):
    start = BODY, START, RATES, TORQUES["a dipole"], TIMES
    expected = rigidsym.integrate(*start, step=0.5, engine="c")
    monkeypatch.setattr("rigidsym._engines.integrator", lambda: None)
    found = rigidsym.integrate(*start, step=0.5, engine="c")
    assert 0 < apart(found, expected) < 1e-13
