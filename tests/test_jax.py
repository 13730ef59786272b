"""States and derivatives in JAX: the engine's own, under every transformation."""

import doctest
from functools import partial

import numpy as np
import pytest
from followed_motions import BODY, MOTIONS, T, arrays

import rigidsym
from rigidsym import InputError, TorqueFreeMotion, _tangents
from rigidsym._engines import xla

jax = pytest.importorskip("jax")
jnp = jax.numpy

from jax.test_util import check_grads  # noqa: E402

from rigidsym import jax as rigid  # noqa: E402

FORWARD = jax.jit(jax.jacfwd(rigid.propagate, argnums=(0, 1, 3)))
REVERSE = jax.jit(jax.jacrev(rigid.propagate, argnums=(0, 1, 3)))


@pytest.fixture(autouse=True)
def double_precision():
    with jax.enable_x64(True):
        yield


@pytest.fixture(params=["in C", "on the host"])
def calls(request, monkeypatch):
    """Let XLA call the engine in C, and by Python as it does without a compiler."""
    if request.param == "in C" and not xla.registered():
        pytest.skip("needs a C compiler")
    if request.param != "in C":
        monkeypatch.setattr(xla, "registered", lambda: False)


@pytest.mark.parametrize("name", MOTIONS)
def test_derivatives_are_the_sensitivities(name):
    inertia, omega0, attitude0 = arrays(name)
    q, omega, S = rigidsym.propagate(inertia, omega0, T, attitude0, engine="c", sensitivity=True)
    given = inertia, omega0, T, attitude0
    found = rigid.propagate(*given)
    assert np.array_equal(found[0], q)
    assert np.array_equal(found[1], omega)
    by_q, by_omega = forward = FORWARD(*given)
    turns = [_tangents.rotation(np, np.swapaxes(x, -1, -2), q[:, None]) for x in by_q]
    # By the moments, the rates and a turn of the quaternion itself.
    own = np.array([_tangents.change(np, x, attitude0) for x in np.eye(3)]).T
    columns = np.concatenate(
        [turns[2].swapaxes(-1, -2) @ own, *np.swapaxes(turns[1::-1], -1, -2)], -1
    )
    assert np.allclose(columns, S.attitude, rtol=1e-14, atol=1e-14)
    assert np.allclose(np.concatenate(by_omega[1::-1], -1), S.rates[..., 3:], rtol=1e-15, atol=0)
    assert not np.any(by_omega[2])
    # Quaternions are normalised.
    assert np.allclose(by_q[2] @ attitude0, 0, atol=1e-14)
    for x, y in zip(*map(jax.tree.leaves, (forward, REVERSE(*given))), strict=True):
        assert np.allclose(x, y, rtol=1e-13, atol=1e-13 * np.abs(x).max())


@jax.jit
def bodies(inertia, omega0, t, attitude0, size):
    return rigid.propagate(inertia, omega0, t, size * attitude0, allow_nonphysical=True)


@jax.jit
def after_step(inertia, omega, dt, q, size):
    return rigid.step(inertia, size * q, omega, dt, allow_nonphysical=True)


@pytest.mark.parametrize("name", MOTIONS)
def test_derivatives_are_those_of_differences(name):
    inertia, omega0, attitude0 = arrays(name)
    # A length of the attitude that is not one, with differences of its size.
    size = np.linalg.norm(attitude0) / 2
    for function, t in ((bodies, T), (after_step, 1.7)):
        one, given = partial(function, size=size), (inertia, omega0, t, attitude0 / size)
        check_grads(one, given, 1, ("fwd", "rev"))
    motion = TorqueFreeMotion(inertia, omega0, attitude0)
    check_grads(partial(rigid.states, motion), (T,), 1, ("fwd", "rev"))


def test_transformations_have_the_bits_of_the_engine(calls):
    random = np.random.default_rng(1)
    inertia = BODY * random.uniform(0.95, 1.05, (4, 3, 3))
    omega0, attitude0 = random.normal(size=(4, 3, 3)), random.normal(size=(3, 4))
    rows, dt = random.uniform(-9, 9, (3, 5)), random.uniform(-1, 1, (4, 1))
    expected = rigidsym.propagate(inertia, omega0, rows, attitude0, engine="c")
    inner = jax.vmap(rigid.propagate, in_axes=(0, 0, 0, 0))
    ways = [
        rigid.propagate,
        jax.jit(jax.vmap(rigid.propagate, in_axes=(0, 0, None, None))),
        jax.vmap(inner, in_axes=(0, 0, None, None)),
        jax.vmap(jax.vmap(rigid.propagate, (0, 0, None, None)), (1, 1, 0, 0), (1, 1)),
    ]
    for way in ways:
        for found, true in zip(way(inertia, omega0, rows, attitude0), expected, strict=True):
            assert np.array_equal(found, true)
    # One row of times for all bodies of an example, and none.
    by_row = jax.vmap(rigid.propagate, in_axes=(1, 1, 0))(inertia, omega0, rows)[1]
    alone = [
        rigidsym.propagate(inertia[:, k], omega0[:, k], rows[k], engine="c")[1] for k in range(3)
    ]
    assert np.array_equal(by_row, alone)
    after = rigidsym.step(inertia, attitude0, omega0, dt, engine="c")
    assert np.array_equal(rigid.step(inertia, attitude0, omega0, dt)[0], after[0])
    stepped = jax.vmap(rigid.step, in_axes=(1, 0, 1, None), out_axes=1)
    assert np.array_equal(stepped(inertia, attitude0, omega0, dt[:, 0])[1], after[1])
    motion = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"), engine="c")
    true = motion(rows.ravel())[0].reshape(3, 5, 4)
    assert np.array_equal(rigid.states(motion, rows)[0], true)
    assert np.array_equal(jax.jit(jax.vmap(partial(rigid.states, motion)))(rows)[0], true)


def test_a_gradient_is_that_of_each_body(calls):
    omega0 = np.array([[0.1, 0.2, 1.3], [0.4, -0.3, 0.2]])

    def loss(omega0, t):
        q, omega = rigid.propagate(BODY, omega0, t)
        return jnp.sum(q[..., 1] * omega[..., 2])

    gradient, by_time = jax.jit(jax.grad(loss)), jax.jit(jax.grad(loss, 1))
    each = [gradient(row, T) for row in omega0]
    for way in (jax.vmap(gradient, (0, None)), gradient):
        assert np.allclose(way(omega0, T), each, rtol=1e-14)
    assert np.allclose(jax.grad(loss)(omega0[0], T), each[0], rtol=1e-14)
    # A time for all bodies takes the derivatives of all.
    both = [by_time(row, T) for row in omega0]
    assert np.allclose(by_time(omega0, T), np.sum(both, axis=0), rtol=1e-14)
    assert by_time(omega0[0], 0.5).shape == ()
    assert gradient(omega0.astype(np.float32), T).dtype == np.float32
    assert rigid.propagate((1, 2, 2), (0, 1, 0), 1)[0].dtype == np.float64
    in_a_list = jax.grad(lambda x: rigid.propagate(BODY, [x, 0.0, 1], 1.0)[1][0])
    assert (
        in_a_list(0.0) == rigidsym.propagate(BODY, (0, 0, 1), 1.0, sensitivity=True)[2].rates[0, 3]
    )


def test_many_bodies_are_shared_among_threads(calls):
    random = np.random.default_rng(2)
    omega0 = random.normal(size=(3000, 3))
    q, omega, S = rigidsym.propagate(BODY, omega0, T, engine="c", sensitivity=True)
    found = rigid.propagate(BODY, omega0, T)
    assert np.array_equal(found[0], q)
    assert np.array_equal(found[1], omega)
    by = jax.jit(jax.grad(lambda omega0: rigid.propagate(BODY, omega0, T)[1].sum()))(omega0)
    assert np.allclose(by, S.rates[..., 3:6].sum((1, 2)), rtol=1e-12, atol=1e-12)


def test_refused_bodies_are_nan_under_jit(calls):
    inertia = np.tile(BODY, (9, 1))
    inertia[1], inertia[3] = (1, 2, 4), (-1, 2, 2)
    # The sum of moments as a double is a body's.
    inertia[4] = (0.1, 0.2, 0.1 + 0.2)
    omega0 = np.tile([0.1, 0.2, 0.3], (9, 1))
    omega0[6, 1] = np.inf
    attitude0 = np.tile([1.0, 0, 0, 0], (9, 1))
    attitude0[8] = 0
    times = np.array([1.0, np.nan, 1e300])
    bad = [1, 3, 6, 8]
    good = [k for k in range(9) if k not in bad]
    q, omega = jax.jit(rigid.propagate)(inertia, omega0, times, attitude0)
    assert np.isnan(q[np.array(bad)]).all()
    assert np.isnan(omega[:, 1:]).all()
    true = rigidsym.propagate(inertia[good], omega0[good], 1.0, engine="c")
    assert np.array_equal(q[np.array(good), 0], true[0])
    after = jax.jit(rigid.step)(inertia, attitude0, omega0, 1.0)
    assert np.isnan(after[0][np.array(bad)]).all()
    alone = rigidsym.step(inertia[good], attitude0[good], omega0[good], 1.0, engine="c")
    assert np.array_equal(after[0][np.array(good)], alone[0])
    assert np.isnan(jax.jit(rigid.step)(BODY, attitude0[0], omega0[0], 1e3)[1]).all()
    allowed = partial(rigid.step, allow_nonphysical=True)
    assert np.isfinite(jax.jit(allowed)((1, 2, 4), attitude0[0], omega0[0], 1.0)[1]).all()
    motion = TorqueFreeMotion(BODY, omega0[0])
    assert np.isnan(jax.jit(partial(rigid.states, motion))(times)[0]).any(-1).tolist() == [
        *(False, True, True)
    ]


def test_derivatives_beyond_binary64_are_nan():
    """A motion leaves its spin about the middle axis so late that derivatives overflow before."""
    omega0, late = np.array([1e-250, 1.0, 0.0]), np.array([1.0, 1100.0])
    assert np.isfinite(rigid.propagate(BODY, omega0, late)[0]).all()
    _, _, S = rigidsym.propagate(
        BODY, omega0, late, engine="c", errors="nan", sensitivity=True, columns=["omega0"]
    )
    assert np.isnan(S.rates[1]).any()
    found = jax.jit(jax.jacfwd(rigid.propagate, 1))(BODY, omega0, late)[1]
    assert np.array_equal(found, S.rates, equal_nan=True)


REFUSED = {
    "motion = 'paper': must be a TorqueFreeMotion": lambda: rigid.states("paper", 1.0),
    "t[1] = nan: must be finite": lambda: rigid.propagate(BODY, (1, 0, 0), [0.0, np.nan]),
    "inertia = [1. 2. 4.]: no body has": lambda: rigid.propagate((1, 2, 4), (1, 0, 0), T),
    "inertia = [1. 2. 4.]: no body ": lambda: rigid.step((1, 2, 4), (1, 0, 0, 0), (1, 0, 0), 1),
    "omega0[0] = nan": lambda: jax.grad(lambda w: rigid.propagate(BODY, w, 1.0)[0].sum())(
        jnp.array([jnp.nan, 0, 0])
    ),
    "dt = 100.0: |omega dt| must": lambda: rigid.step(BODY, (1, 0, 0, 0), (1, 0, 0), 100),
    "t[0] = 1e+300: beyond": lambda: rigid.states(TorqueFreeMotion(BODY, (1, 0, 0)), 1e300),
    "attitude0 = [0. 0. 0. 0.]: a zero": lambda: rigid.propagate(BODY, (1, 0, 0), 1, (0,) * 4),
    "omega0 = an array of shape (2,)": lambda: jax.jit(rigid.propagate)(BODY, (1.0, 2.0), T),
    "omega0, attitude0 = leading": lambda: rigid.propagate(
        BODY, np.ones((2, 3)), T, np.ones((3, 4))
    ),
    "t = an array of shape (2, 1)": lambda: rigid.propagate(BODY, np.ones((3, 3)), np.ones((2, 1))),
    "q = an array of shape (3,)": lambda: rigid.step(BODY, (1, 0, 0), (1, 0, 0), 1),
    "omega0 = None: must be": lambda: rigid.propagate(BODY, None, T),
    "omega0 = ['a', 'b', 'c']: must": lambda: rigid.propagate(BODY, ["a", "b", "c"], T),
    "omega0 = 'abc': must be": lambda: rigid.propagate(BODY, "abc", T),
    "omega0 = an array of bool": lambda: rigid.propagate(BODY, jnp.ones(3, bool), T),
    "omega0 = [1j, 0, 0]: must be": lambda: rigid.propagate(BODY, [1j, 0, 0], T),
    "omega0 = [[1, 2, 3], [1]]": lambda: rigid.propagate(BODY, [[1, 2, 3], [1]], T),
    "t[0] = --: is masked": lambda: rigid.propagate(BODY, (1, 0, 0), np.ma.masked_all(2) + 1),
}


@pytest.mark.parametrize("message", REFUSED)
def test_bad_input_is_refused_in_one_line(message):
    with pytest.raises(InputError) as refused:
        REFUSED[message]()
    assert str(refused.value).startswith(message)
    assert "\n" not in str(refused.value)


def test_single_precision_is_refused():
    with jax.enable_x64(False), pytest.raises(InputError, match=r"jax_enable_x64 = False: must"):
        rigid.propagate(BODY, (1, 0, 0), T)


def test_second_derivatives_are_refused(calls):
    loss = lambda omega0: rigid.propagate(BODY, omega0, T)[0].sum()  # noqa: E731
    for second in (jax.hessian(loss), jax.jacfwd(jax.jacfwd(loss)), jax.jacrev(jax.jacrev(loss))):
        with pytest.raises(NotImplementedError, match="of first order alone"):
            second(jnp.ones(3))
    # A derivative by something else is not of second order.
    assert (
        jax.grad(lambda x: x * jax.grad(loss)(jnp.ones(3))[0])(2.0)
        == jax.grad(loss)(jnp.ones(3))[0]
    )


def test_callers_arrays_are_left_alone(calls):
    given = [np.ones(3) * [1, 2, 2.5], np.ones(3), np.ones(2), np.ones(4)]
    before = [x.copy() for x in given]
    found = rigid.propagate(*given)
    true = [np.array(x) for x in found]
    for x, y in zip(given, before, strict=True):
        assert np.array_equal(x, y)
        x[...] = 7
    assert all(np.array_equal(x, y) for x, y in zip(found, true, strict=True))


def test_no_bodies_and_no_times(calls):
    assert rigid.propagate(np.ones((0, 3)), np.ones(3), T)[0].shape == (0, 4, 4)
    assert (
        jax.grad(lambda w: rigid.propagate(BODY, w, [])[0].sum())(jnp.ones(3)).tolist() == [0] * 3
    )
    assert rigid.step(np.ones((0, 3)), (1, 0, 0, 0), np.ones(3), 1.0)[1].shape == (0, 3)
    motion = TorqueFreeMotion(BODY, (1, 0, 0))
    assert rigid.states(motion, np.ones((2, 0)))[1].shape == (2, 0, 3)


def test_the_examples_run():
    assert doctest.testmod(rigid).failed == 0
    assert doctest.testmod(rigid).attempted
