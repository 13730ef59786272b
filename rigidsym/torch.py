"""Torque-free motion in PyTorch: states with derivatives in forward and in reverse mode.

The engine computes them, as it does for `rigidsym.propagate`.  Derivatives are
the sensitivities in closed form; those that are needed are computed beside the states.  They work
with `torch.autograd`, its forward mode, and `torch.func` (vmap, grad, jacfwd, jacrev).  Second
derivatives raise NotImplementedError, or are NaN in forward mode over reverse mode.  Tensors are
float64, on the CPU.  Bad input raises InputError.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np

from rigidsym import _tangents, steps
from rigidsym import motion as motions
from rigidsym._engines import arrays, batches
from rigidsym.errors import InputError, package
from rigidsym.sensitivity import Sensitivity

torch: Any = package("torch", "rigidsym.torch", "torch")

__all__ = ["propagate", "states", "step"]

States = tuple[Any, Any]
# What computes states, and derivatives by the columns named.
_Compute = Callable[..., Sequence[np.ndarray]]
_FIRST = "rigidsym.torch: states have derivatives of first order alone"


def propagate(
    inertia: Any,
    omega0: Any,
    t: Any,
    attitude0: Any = motions.IDENTITY,
    *,
    allow_nonphysical: bool = False,
) -> States:
    """Return the states of many torque-free bodies at given times.

    Derivatives exist by all four tensors.  Leading shapes broadcast.

    Parameters
    ----------
    inertia : tensor or array_like (..., 3)
        Principal moments, kg m^2.
    omega0 : tensor or array_like (..., 3)
        Body rates at t = 0, rad/s.
    t : number, tensor or array_like (N,) or (..., N)
        Times, s: a number or (N,) for all bodies, (B, N) a row for each.
    attitude0 : tensor or array_like (..., 4)
        Attitude quaternions at t = 0, scalar first, body to inertial; they are normalised.
    allow_nonphysical : bool
        Accept moments that no body has.

    Returns
    -------
    q : tensor (..., N, 4)
        Attitude quaternions, (..., 4) for a number t.
    omega : tensor (..., N, 3)
        Body rates, rad/s.

    Raises
    ------
    InputError
        As `rigidsym.propagate` does.

    Examples
    --------
    >>> import torch
    >>> omega0 = torch.tensor([0.1, 0.2, 0.3], dtype=torch.float64, requires_grad=True)
    >>> q, omega = propagate((1, 2, 2.5), omega0, [0.0, 0.5, 1.0])
    >>> q.shape, omega.shape
    (torch.Size([3, 4]), torch.Size([3, 3]))
    >>> omega.sum().backward()
    >>> omega0.grad.shape
    torch.Size([3])
    """
    given = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0, "t": t}
    doubles = {name: _tensor(name, value) for name, value in given.items()}
    # Shapes alone decide this.
    shape = arrays.batch(*(np.broadcast_to(0.0, x.shape) for x in doubles.values())).leading
    *bodies, times = doubles.values()
    bodies = [x.expand(*shape, x.shape[-1]) for x in bodies]
    rows = (times if times.ndim else times[None]).expand(*shape, -1)
    q, omega = _followed(partial(_bodies, bool(allow_nonphysical)), *bodies, rows)[:2]
    return (q, omega) if times.ndim else (q[..., 0, :], omega[..., 0, :])


def step(inertia: Any, q: Any, omega: Any, dt: Any, *, allow_nonphysical: bool = False) -> States:
    """Return the states of bodies after dt seconds of torque-free motion.

    Derivatives exist by all four tensors.  Leading shapes broadcast.

    Parameters
    ----------
    inertia : tensor or array_like (..., 3)
        Principal moments, kg m^2.
    q : tensor or array_like (..., 4)
        Attitude quaternions, scalar first, body to inertial, of any length but zero.
    omega : tensor or array_like (..., 3)
        Body rates, rad/s.
    dt : number, tensor or array_like (...)
        Time, s, forwards or back; |omega dt| may be up to 8 rad.
    allow_nonphysical : bool
        Accept moments that no body has.

    Returns
    -------
    q : tensor (..., 4)
        Unit quaternions, continuous in the double cover.
    omega : tensor (..., 3)
        Body rates, rad/s.

    Raises
    ------
    InputError
        As `rigidsym.step` does.

    Examples
    --------
    >>> q, omega = step((1, 2, 2.5), (1, 0, 0, 0), (0.1, 0.2, 0.3), 0.5)
    >>> q.shape, omega.shape
    (torch.Size([4]), torch.Size([3]))
    """
    given = {"inertia": inertia, "q": q, "omega": omega, "dt": dt}
    doubles = {name: _tensor(name, value) for name, value in given.items()}
    shape = steps._shape({name: np.broadcast_to(0.0, x.shape) for name, x in doubles.items()})
    moments, attitudes, rates = (doubles[x].expand(*shape, -1) for x in ("inertia", "q", "omega"))
    times = doubles["dt"].expand(shape)[..., None]
    compute = partial(_bodies_after_step, bool(allow_nonphysical))
    after, rates_after = _followed(compute, moments, rates, attitudes, times)[:2]
    return after[..., 0, :], rates_after[..., 0, :]


def states(motion: motions.TorqueFreeMotion, t: Any) -> States:
    """Return the states of one known motion at times.

    The constants of the motion are computed once, from its exact numbers; derivatives exist by the
    times.  Use `propagate` for derivatives by what the motion is given by.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion.
    t : number, tensor or array_like (...)
        Times, s.

    Returns
    -------
    q : tensor (..., 4)
        Attitude quaternions.
    omega : tensor (..., 3)
        Body rates, rad/s.

    Raises
    ------
    InputError
        As a call of the motion does.

    Examples
    --------
    >>> motion = motions.TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
    >>> states(motion, [[0.0, 90.0, 180.0]])[0].shape
    torch.Size([1, 3, 4])
    """
    if not isinstance(motion, motions.TorqueFreeMotion):
        raise InputError("motion", repr(motion), "must be a TorqueFreeMotion")
    times = _tensor("t", t)
    compute = partial(_motion, motion)
    q, omega = _followed(compute, None, None, None, times[..., None])[:2]
    return q[..., 0, :], omega[..., 0, :]


def _tensor(name: str, value: Any) -> Any:
    """Convert user input to a float64 tensor on the CPU.

    Raises InputError for what is no array of numbers, and for other devices.
    """
    if isinstance(value, (tuple, list)) and any(isinstance(x, torch.Tensor) for x in value):
        value = torch.stack([torch.as_tensor(x) for x in value])
    if not isinstance(value, torch.Tensor):
        return torch.tensor(batches.array(name, value, lenient=True))
    if value.is_complex() or value.dtype == torch.bool:
        raise InputError(name, f"a tensor of {value.dtype}", "must be a tensor of numbers")
    if value.device.type != "cpu":
        raise InputError(
            name, f"a tensor on {value.device}", "must be on the CPU", next_step="x.cpu()"
        )
    return value.to(torch.float64)


def _followed(
    compute: _Compute, inertia: Any, omega0: Any, attitude0: Any, t: Any, columns: Any = ()
) -> tuple[Any, ...]:
    """Return states and derivatives by the inputs that autograd follows or that are named."""
    # Forward mode over forward mode would lose the derivatives of derivatives without a word.
    transforms = torch._functorch.pyfunctorch.retrieve_all_functorch_interpreters()
    if sum(x.key() == torch._C._functorch.TransformType.Jvp for x in transforms) > 1:
        raise NotImplementedError(_FIRST)
    names = {"omega0": omega0, "inertia": inertia, "t": t}
    wanted = [name for name, x in names.items() if name in columns or _is_followed(x)]
    return _Motion.apply(compute, wanted, inertia, omega0, attitude0, t)


def _is_followed(tensor: Any) -> bool:
    """Return True if derivatives by a tensor are being computed.

    Inside vmap this is not known; `_Motion.vmap` asks again.
    """
    if tensor is None:
        return False
    try:
        tangent = torch.autograd.forward_ad.unpack_dual(tensor).tangent
    except RuntimeError:
        return False
    return tangent is not None or (tensor.requires_grad and torch.is_grad_enabled())


class _Motion(torch.autograd.Function):
    """States and, beside them, derivatives as of `Sensitivity`, which have no derivatives.

    Bodies and the rows of their times have one leading shape.
    """

    @staticmethod
    def forward(compute: _Compute, columns: list[str], *given: Any) -> tuple[Any, ...]:
        """Return the states, and the derivatives in the columns."""
        doubles = (None if x is None else x.detach().numpy() for x in given)
        return tuple(torch.from_numpy(x) for x in compute(columns, *doubles))

    @staticmethod
    def setup_context(ctx: Any, inputs: Sequence[Any], output: Sequence[Any]) -> None:
        """Keep what derivatives need."""
        _, ctx.columns, _, _, attitude0, _ = inputs
        q, _, *derivatives = output
        ctx.set_materialize_grads(False)
        ctx.save_for_backward(q, attitude0, *derivatives)
        ctx.save_for_forward(q, attitude0, *derivatives)

    @staticmethod
    def jvp(ctx: Any, *changes: Any) -> tuple[Any, ...]:
        """Return the changes of states by those of the inputs."""
        q, attitude0, *derivatives = ctx.saved_tensors
        attitude, rates, attitude_t, rates_t = derivatives
        _, _, by_inertia, by_omega0, by_attitude0, by_t = changes
        turn = by_rates = torch.zeros_like(q[..., 1:])
        if by_attitude0 is not None:
            turn = turn + _tangents.rotation(torch, by_attitude0, attitude0)[..., None, :]
        # In the order of the columns.
        for name, by in (("omega0", by_omega0), ("inertia", by_inertia)):
            if name in ctx.columns:
                if by is not None:
                    vector = by[..., None, None, :]
                    turn = turn + (attitude[..., :3] * vector).sum(-1)
                    by_rates = by_rates + (rates[..., :3] * vector).sum(-1)
                attitude, rates = attitude[..., 3:], rates[..., 3:]
        if by_t is not None:
            turn = turn + attitude_t * by_t[..., None]
            by_rates = by_rates + rates_t * by_t[..., None]
        # There are no second derivatives.
        unknown = (torch.full_like(x, torch.nan) for x in derivatives)
        return (_tangents.change(torch, turn, q), by_rates, *unknown)

    @staticmethod
    def backward(ctx: Any, by_q: Any, by_omega: Any, *others: Any) -> tuple[Any, ...]:
        """Return the gradients by the inputs from those by the states."""
        if any(x is not None for x in others):
            raise NotImplementedError(_FIRST)
        q, attitude0, attitude, rates, attitude_t, rates_t = ctx.saved_tensors
        turn = torch.zeros_like(q[..., 1:])
        if by_q is not None:
            turn = _tangents.transposed_change(torch, by_q, q)
        if by_omega is None:
            by_omega = torch.zeros_like(turn)
        found: dict[str, Any] = {}
        by_columns = _summed(turn, attitude) + _summed(by_omega, rates)
        # In the order of the columns.
        names = [name for name in ("omega0", "inertia") if name in ctx.columns]
        found |= zip(names, by_columns.split(3, dim=-1), strict=False)
        if "t" in ctx.columns:
            found["t"] = (attitude_t * turn + rates_t * by_omega).sum(-1)
        if attitude0 is not None:
            found["q"] = _tangents.transposed_rotation(torch, turn.sum(-2), attitude0)
        return (None, None, *(found.get(name) for name in ("inertia", "omega0", "q", "t")))

    @staticmethod
    def vmap(info: Any, dims: Sequence[Any], compute: _Compute, columns: Any, *given: Any) -> Any:
        """Compute a batch of inputs at once."""
        moved = []
        for x, dim in zip(given, dims[2:], strict=True):
            if x is not None:
                x = x.expand(info.batch_size, *x.shape) if dim is None else x.movedim(dim, 0)
            moved.append(x)
        return _followed(compute, *moved, columns=columns), (0,) * 6


def _summed(gradient: Any, derivatives: Any) -> Any:
    """Return gradients (..., M) by columns, from those by states (..., N, 3) at all times.

    derivatives: (..., N, 3, M).
    """
    *leading, count, _, columns = derivatives.shape
    rows = derivatives.reshape(*leading, 3 * count, columns)
    return (gradient.reshape(*leading, 1, 3 * count) @ rows)[..., 0, :]


def _bodies(
    nonphysical: bool,
    columns: list[str],
    inertia: np.ndarray,
    omega0: np.ndarray,
    attitude0: np.ndarray,
    t: np.ndarray,
) -> Sequence[np.ndarray]:
    """Compute the states of bodies at times, and derivatives by the columns named."""
    options: Any = {"allow_nonphysical": nonphysical}
    if not columns:
        return _without(*motions.propagate(inertia, omega0, t, attitude0, **options))
    options |= {"sensitivity": True, "columns": columns}
    return _with(*motions.propagate(inertia, omega0, t, attitude0, **options))


def _bodies_after_step(
    nonphysical: bool,
    columns: list[str],
    inertia: np.ndarray,
    omega: np.ndarray,
    q: np.ndarray,
    dt: np.ndarray,
) -> Sequence[np.ndarray]:
    """Compute the states of bodies after a step, which is a motion at one time."""
    options: Any = {"allow_nonphysical": nonphysical}
    after = [x[..., None, :] for x in steps.step(inertia, q, omega, dt[..., 0], **options)]
    if not columns:
        return _without(*after)
    return (*after, *_bodies(nonphysical, columns, inertia, omega, q, dt)[2:])


def _motion(
    motion: motions.TorqueFreeMotion, columns: list[str], *given: Any
) -> Sequence[np.ndarray]:
    """Compute the states of one motion, with one row for each time."""
    t = given[-1]
    found = (
        _with(*motion.sensitivity(t.ravel(), columns=["t"]))
        if columns
        else _without(*motion(t.ravel()))
    )
    return [x.reshape(*t.shape, *x.shape[1:]) for x in found]


def _with(q: np.ndarray, omega: np.ndarray, S: Sensitivity) -> Sequence[np.ndarray]:
    return q, omega, S.attitude, S.rates, S.attitude_t, S.rates_t


def _without(q: np.ndarray, omega: np.ndarray) -> Sequence[np.ndarray]:
    """Return states with derivatives of no columns."""
    none, no_t = np.empty((*omega.shape, 0)), np.empty((*omega.shape[:-1], 0))
    return q, omega, none, none.copy(), no_t, no_t.copy()
