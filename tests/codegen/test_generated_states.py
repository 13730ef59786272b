"""States of the generated modules in every regime and at limits, and refused input."""

import math
import tracemalloc

import numpy as np
import pytest
from compilers import ATTITUDE, BUILDS, PLAIN, PORTABLE, RATES, Library, either, needed
from regimes import are_right, cases

from rigidsym._engines.build import ANY_MOMENTS
from rigidsym.generated import torque_free, torque_free_pi

NAN, INF, MOST = math.nan, math.inf, 1.7e308
FROM_NUMPY = {
    f"{way}{form}": (module, way == "arrays")
    for form, module in (("", torque_free), (" pi", torque_free_pi))
    for way in ("arrays", "floats")
}


class InNumpy:
    """A module of NumPy, which computes one body's states together or one by one."""

    def __init__(self, module, together):
        self.module, self.together = module, together

    def made(self, *given):
        return self.module.prepare(*given)

    def rows(self, prepared, times):
        if self.together:
            return np.hstack(self.module.states(prepared, np.array(times)))
        return np.array([np.hstack(self.module.states(prepared, float(t))) for t in times])

    def refusal(self, prepared, times):
        with pytest.raises(ValueError, match=": ") as caught:
            self.rows(prepared, times)
        return str(caught.value)


class InC(Library):
    """A build of the C module."""

    def made(self, *given):
        code, prepared = self.prepare(*given)
        assert code == 0, given
        return prepared

    def rows(self, prepared, times):
        code, found = self.states(prepared, times)
        assert code == 0
        return found

    def refusal(self, prepared, times):
        code, found = self.states(prepared, times)
        assert np.isnan(found).all(), "a refused call writes nothing"
        return self.message(code)


@pytest.fixture(scope="module")
def module(here):
    """Return a generated module by its name; each build is made and loaded once."""
    made = {}

    def get(name):
        if name not in made:
            if name in FROM_NUMPY:
                made[name] = InNumpy(*FROM_NUMPY[name])
            elif name in BUILDS:
                kind, machine, flags = BUILDS[name]
                compiler = needed(kind)
                made[name] = InC(compiler, here, *flags, *compiler.machine(machine))
            else:
                flags = PORTABLE if name == "C" else (*PLAIN, ANY_MOMENTS)
                made[name] = InC(either(), here, *flags)
        return made[name]

    return get


@pytest.mark.parametrize("name", [*FROM_NUMPY, *BUILDS])
def test_states_are_right_in_every_regime(name, module, exact_motions):
    one = module(name)
    assert len(exact_motions) > 100
    for case, exact in exact_motions:
        assert are_right(one.rows(one.made(*case.given), case.times), exact), case


@pytest.fixture(params=["arrays", "floats", "C"])
def any_module(request, module):
    return module(request.param)


@pytest.mark.parametrize("omega0", [RATES, (0.75, 0.5, 1.0), (0, 0, 0), (0, 2.0, 0)])
@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_a_motion_begins_at_its_start_to_the_last_bit(omega0, zero, any_module):
    prepared = any_module.made((1, 2, 2.25), omega0, (3.0, 0, -4.0, 0))
    assert any_module.rows(prepared, [zero]).tolist() == [[0.6, 0, -0.8, 0, *omega0]]


def test_faint_rates_are_there_at_the_start_whatever_the_largest(any_module):
    omega0 = (1e300, 1e-20, -3e-17)
    prepared = any_module.made((1, 2, 2.5), omega0, ATTITUDE)
    assert any_module.rows(prepared, [0.0])[0, 4:].tolist() == list(omega0)


def test_a_body_at_rest_rests_for_ever(any_module):
    prepared = any_module.made((1, 2, 2.5), (0, 0, 0), (0, 1, 0, 0))
    found = any_module.rows(prepared, [1e300, -MOST, 0.0])
    assert found.tolist() == [[0, 1, 0, 0, 0, 0, 0]] * 3
    assert "finite" in any_module.refusal(prepared, [INF])


@pytest.mark.parametrize("name", ["arrays", "floats", "C of any moments"])
def test_bodies_that_cannot_exist_are_refused_times_they_turn_too_often_by(name, module):
    one = module(name)
    prepared = one.made((1.0, 2.0**-60, 2.0**-90), (1.0, 0.5, 0.1), ATTITUDE)
    assert "the angle is lost in binary64" in one.refusal(prepared, [2.0**40])
    (found,) = one.rows(prepared, [2.0**-40])
    assert abs(np.linalg.norm(found[:4]) - 1) < 1e-15


@pytest.mark.parametrize(
    ("message", "inertia", "omega0", "attitude0"),
    [
        ("inertia: every number must be finite", (NAN, 1, 1), (0, 0, 1), (1, 0, 0, 0)),
        ("omega0: every number must be finite", (1, 1, 1), (0, -INF, 1), (1, 0, 0, 0)),
        ("attitude0: every number must be finite", (1, 1, 1), (0, 0, 1), (1, 0, 0, INF)),
        ("inertia: principal moments must be positive", (1, 0.0, 1), (0, 0, 1), (1, 0, 0, 0)),
        ("inertia: principal moments must be positive", (1, 1, -5e-324), (0, 0, 1), (1, 0, 0, 0)),
        ("inertia: principal moments differ by", (1, 1, 2.0**-201), (0, 0, 1), (1, 0, 0, 0)),
        ("inertia: principal moments differ by", (5e-324, 1e308, 1e308), (0, 0, 1), (1, 0, 0, 0)),
        ("attitude0: a zero quaternion", (1, 1, 1), (0, 0, 1), (0, -0.0, 0, 0)),
        ("omega0: rates beyond what", (1, 2, 2.5), (MOST, MOST, MOST), (1, 0, 0, 0)),
    ],
)
def test_what_no_motion_is_made_of(message, inertia, omega0, attitude0, module):
    with pytest.raises(ValueError, match=message) as caught:
        torque_free.prepare(inertia, omega0, attitude0)
    code, prepared = module("C").prepare(inertia, omega0, attitude0)
    assert code > 0
    assert str(caught.value).endswith(module("C").message(code))
    assert prepared.raw == bytes(len(prepared)), "a refused call writes nothing"


@pytest.mark.parametrize("rates", [(0, 1, 1e-130), (1e-125, 1, 1e-130), (5e-324, 1, 0)])
def test_times_after_which_a_spin_may_have_turned_over(rates, module):
    prepared = module("C").made((1, 2, 2.5), rates, ATTITUDE)
    found = module("C").rows(prepared, [1.0, -400.0])
    np.testing.assert_array_equal(found[:, 4:], [rates, rates])
    assert "separatrix" in module("C").refusal(prepared, [1.0, 4000.0])
    assert module("C").grid(prepared, 0.0, 1000.0, 5)[0] == module("C").c.raw.SEPARATRIX


@pytest.mark.parametrize(
    ("bad", "expected"), [(NAN, 1), (INF, 1), (-INF, 1), (MOST, 6), (-(2.0**46) - 1, 6)]
)
@pytest.mark.parametrize("place", [0, 191, 192, 400])
def test_times_that_are_none_or_too_far(bad, expected, place, module):
    prepared = module("C").made((1, 2, 2.5), (0.3, 0.5, -1.0), ATTITUDE)
    times = np.linspace(0, 1, 401)
    times[place] = bad
    assert module("C").refusal(prepared, times) == module("C").message(expected)
    # Numbers that are none come first, wherever they stand.
    times[200] = MOST
    assert module("C").states(prepared, times)[0] == expected


def test_many_bodies_are_each_right():
    """Bodies of all regimes in one batch have the states of each alone, in order."""
    listed = [case for case in cases() if 0 < max(map(abs, case.omega0)) < 1e3]
    assert len(listed) > 60
    prepared = torque_free.prepare(*map(np.array, zip(*(x.given for x in listed), strict=True)))
    t = np.array([0.0, 0.7, -31.0])
    q, omega = torque_free.states(prepared, t)
    for k, case in enumerate(listed):
        one = torque_free.states(torque_free.prepare(*case.given), t)
        np.testing.assert_allclose(q[k], one[0], rtol=0, atol=2e-15)
        size = max(map(abs, case.omega0))
        np.testing.assert_allclose(omega[k], one[1], rtol=0, atol=4e-15 * size)


def test_a_body_that_is_refused_leaves_those_beside_it():
    inertia = np.array([[np.nan] * 3, [1.0, 2.0, 2.5], [2.5, 1.0, 2.0]])
    rates, start = np.full((3, 3), 0.3), np.tile([1.0, 0.0, 0.0, 0.0], (3, 1))
    together = torque_free_pi.prepare(inertia, rates, start, errors="nan")
    q, omega = torque_free_pi.states(together, [0.0, 7.0])
    assert np.isnan(q[0]).all()
    others = torque_free_pi.prepare(inertia[1:], rates[1:], start[1:])
    alone = torque_free_pi.states(others, [0.0, 7.0])
    assert np.array_equal(q[1:], alone[0])
    assert np.array_equal(omega[1:], alone[1])


def test_out_is_filled_and_returned():
    prepared = torque_free.prepare((1, 2, 2.5), [(1, 2, 3), (0, 1, 0)])
    t = np.linspace(-3, 3, 50)
    out = np.empty((2, 50, 4)), np.empty((2, 50, 3))
    found = torque_free.states(prepared, t, out)
    assert all(a is b for a, b in zip(found, out, strict=True))
    for a, b in zip(found, torque_free.states(prepared, t), strict=True):
        np.testing.assert_array_equal(a, b)
    for wrong in ((out[0], out[1][:, :-1]), (out[0].astype("f4"), out[1]), (out[0],), out[::-1]):
        with pytest.raises(ValueError, match="out: must be C-contiguous float64 arrays of shapes"):
            torque_free.states(prepared, t, wrong)


def test_blocks_do_not_show():
    """Many times, many bodies and single calls give nearly the same bits, by the same lines."""
    t = np.linspace(0.5, 400, 20_001)
    prepared = torque_free.prepare((1, 2, 2.5), (0.1, 1, 0.2))
    q, omega = torque_free.states(prepared, t)
    for k in (0, 8191, 8192, 20_000):
        one = torque_free.states(prepared, float(t[k]))
        np.testing.assert_allclose(one[0], q[k], rtol=0, atol=5e-16)
        np.testing.assert_allclose(one[1], omega[k], rtol=0, atol=5e-16)
    many = torque_free.prepare(np.tile((1, 2, 2.5), (500, 1)), (0.1, 1, 0.2))
    batch, _ = torque_free.states(many, t[:30])
    np.testing.assert_array_equal(batch[0], batch[-1])
    np.testing.assert_allclose(batch[0], q[:30], rtol=0, atol=5e-16)


def test_memory_beyond_the_output_does_not_grow_with_the_number_of_times():
    prepared = torque_free.prepare((1, 2, 2.5), (0.1, 1, 0.2))
    t = np.linspace(0, 100, 1_000_000)
    out = np.empty((t.size, 4)), np.empty((t.size, 3))
    tracemalloc.start()
    torque_free.states(prepared, t, out)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 16e6
