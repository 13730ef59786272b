"""States and derivatives in PyTorch: the engine's own, in both modes and under torch.func."""

import doctest
from functools import partial

import numpy as np
import pytest
from followed_motions import BODY, MOTIONS, T, arrays

import rigidsym
from rigidsym import InputError, TorqueFreeMotion, _tangents

torch = pytest.importorskip("torch")

from torch.autograd import gradcheck  # noqa: E402

from rigidsym import torch as rigid  # noqa: E402

# What PyTorch says of itself when forward mode is first used.
pytestmark = pytest.mark.filterwarnings("ignore:.*torch.jit.script:DeprecationWarning")


def followed(*given):
    return [torch.tensor(x, dtype=torch.float64, requires_grad=True) for x in given]


@pytest.mark.parametrize("name", MOTIONS)
def test_derivatives_are_the_sensitivities(name):
    inertia, omega0, attitude0 = arrays(name)
    q, omega, S = rigidsym.propagate(inertia, omega0, T, attitude0, engine="c", sensitivity=True)
    given = tuple(map(torch.tensor, (inertia, omega0, T, attitude0)))
    found = rigid.propagate(*given)
    assert np.array_equal(found[0], q)
    assert np.array_equal(found[1], omega)
    by_q, by_omega = forward = torch.func.jacfwd(rigid.propagate, argnums=(0, 1, 3))(*given)
    changes = (x.numpy().swapaxes(-1, -2) for x in by_q)
    turns = [_tangents.rotation(np, x, q[:, None]) for x in changes]
    columns = np.concatenate([np.swapaxes(x, -1, -2) for x in (turns[1], turns[0])], -1)
    assert np.allclose(columns, S.attitude[..., 3:], rtol=1e-14, atol=1e-14)
    assert np.allclose(torch.cat(by_omega[1::-1], -1), S.rates[..., 3:], rtol=1e-15, atol=0)
    reverse = torch.func.jacrev(rigid.propagate, argnums=(0, 1, 3))(*given)
    for x, y in zip(sum(forward, ()), sum(reverse, ()), strict=True):
        assert np.allclose(x, y, rtol=1e-13, atol=1e-13 * x.abs().max())


@pytest.mark.parametrize("name", MOTIONS)
def test_derivatives_are_those_of_differences(name):
    inertia, omega0, attitude0 = arrays(name)
    size = np.linalg.norm(attitude0) / 2
    given = followed(inertia, omega0, T, attitude0 / size)

    def bodies(inertia, omega0, t, attitude0):
        return rigid.propagate(inertia, omega0, t, size * attitude0, allow_nonphysical=True)

    def after_step(inertia, omega, dt, q):
        return rigid.step(inertia, size * q, omega, dt, allow_nonphysical=True)

    assert gradcheck(bodies, given, check_forward_ad=True)
    given[2] = followed(1.7)[0]
    assert gradcheck(after_step, given, check_forward_ad=True)
    motion = TorqueFreeMotion(inertia, omega0, attitude0)
    assert gradcheck(partial(rigid.states, motion), followed(T), check_forward_ad=True)


def test_batches_have_the_bits_of_the_engine():
    random = np.random.default_rng(1)
    inertia = BODY * random.uniform(0.95, 1.05, (2, 1, 3))
    omega0, attitude0 = random.normal(size=(2, 3, 3)), random.normal(size=(3, 4))
    rows, dt = random.uniform(-9, 9, (3, 2)), random.uniform(-1, 1, (2, 1))
    given = followed(inertia, omega0, rows, attitude0)
    expected = rigidsym.propagate(inertia, omega0, rows, attitude0, engine="c")
    twice = torch.func.vmap(torch.func.vmap(rigid.propagate), in_dims=(0, 0, None, None))
    spread = given[0].expand(2, 3, 3)
    for found in (rigid.propagate(*given), twice(spread, *given[1:])):
        for x, true in zip(found, expected, strict=True):
            assert np.array_equal(x.detach(), true)
    assert gradcheck(rigid.propagate, given, check_batched_grad=True)
    again = followed(inertia, attitude0, omega0, dt)
    true = rigidsym.step(inertia, attitude0, omega0, dt, engine="c")[0]
    assert np.array_equal(rigid.step(*again)[0].detach(), true)
    assert gradcheck(rigid.step, again)
    motion = TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"), engine="c")
    true = motion(rows.ravel())[1].reshape(3, 2, 3)
    assert np.array_equal(rigid.states(motion, rows)[1], true)
    assert np.array_equal(
        torch.func.vmap(partial(rigid.states, motion))(given[2])[1].detach(), true
    )


def test_transformations_agree():
    func, omega0 = torch.func, torch.tensor([[0.1, 0.2, 1.3], [0.4, -0.3, 0.2]])

    def loss(omega0):
        q, omega = rigid.propagate(BODY, omega0, T)
        return (q[..., 1] * omega[..., 2]).sum()

    each = [func.grad(loss)(row) for row in omega0]
    assert each[0].dtype == torch.float32
    each = torch.stack([func.grad(loss)(row) for row in omega0.double()])
    omega0 = omega0.double().requires_grad_()
    (by_autograd,) = torch.autograd.grad(loss(omega0), omega0)
    ways = (
        by_autograd,
        func.vmap(func.grad(loss))(omega0),
        func.grad(lambda x: func.vmap(loss)(x).sum())(omega0),
        func.vmap(func.jacfwd(loss))(omega0),
        func.jacrev(lambda x: func.vmap(loss)(x).sum())(omega0),
    )
    for found in ways:
        assert torch.allclose(found, each, rtol=1e-14)
    along = func.jvp(func.vmap(loss), (omega0,), (torch.ones_like(omega0),))[1]
    assert torch.allclose(along, each.sum(-1), rtol=1e-13)
    with torch.no_grad():
        assert not loss(omega0).requires_grad


def test_second_derivatives_are_refused():
    def loss(omega0):
        return rigid.propagate(BODY, omega0, T)[0].sum()

    given = torch.tensor([0.1, 0.2, 0.3], dtype=torch.float64, requires_grad=True)
    (first,) = torch.autograd.grad(loss(given), given, create_graph=True)
    with pytest.raises(NotImplementedError, match="of first order alone"):
        first.sum().backward()
    jacfwd, jacrev = torch.func.jacfwd, torch.func.jacrev
    for second in (jacrev(jacrev(loss)), jacrev(jacfwd(loss)), jacfwd(jacfwd(loss))):
        with pytest.raises(NotImplementedError, match="of first order alone"):
            second(given)
    assert jacfwd(jacrev(loss))(given).isnan().all()


REFUSED = {
    "motion = 'paper': must be a TorqueFreeMotion": lambda: rigid.states("paper", 1.0),
    "t[1] = nan: must be finite": lambda: rigid.propagate(BODY, (1, 0, 0), [0.0, np.nan]),
    "inertia = [1. 2. 4.]: no body has": lambda: rigid.propagate((1, 2, 4), (1, 0, 0), T),
    "dt = 100.0: |omega dt| must": lambda: rigid.step(BODY, (1, 0, 0, 0), (1, 0, 0), 100),
    "t[0] = 1e+300: beyond": lambda: rigid.states(TorqueFreeMotion(BODY, (1, 0, 0)), 1e300),
    "omega0 = an array of shape (2,)": lambda: rigid.propagate(BODY, torch.ones(2), T),
    "q = an array of shape (3,)": lambda: rigid.step(BODY, (1, 0, 0), (1, 0, 0), 1),
    "omega0 = 'abc': must be": lambda: rigid.propagate(BODY, "abc", T),
    "omega0 = a tensor of torch.bool": lambda: rigid.propagate(BODY, torch.ones(3) > 0, T),
    "omega0 = a tensor on meta: must be on the CPU (": lambda: rigid.propagate(
        BODY, torch.ones(3, device="meta"), T
    ),
}


@pytest.mark.parametrize("message", REFUSED)
def test_bad_input_is_refused_in_one_line(message):
    with pytest.raises(InputError) as refused:
        REFUSED[message]()
    assert str(refused.value).startswith(message)
    assert "\n" not in str(refused.value)


def test_no_bodies_and_no_times():
    (omega0,) = followed(np.ones(3))
    assert rigid.propagate(torch.ones(0, 3), omega0, T)[0].shape == (0, 4, 4)
    rigid.propagate(BODY, omega0, [])[0].sum().backward()
    assert omega0.grad.tolist() == [0] * 3
    assert rigid.states(TorqueFreeMotion(BODY, (1, 0, 0)), torch.ones(2, 0))[1].shape == (2, 0, 3)
    one = rigid.propagate([omega0[0], 2, 2.5], omega0, 1.0)[1]
    assert one.requires_grad


def test_the_examples_run():
    found = doctest.testmod(rigid)
    assert found.attempted
    assert not found.failed
