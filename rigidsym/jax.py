"""Torque-free motion in JAX: states and their derivatives under jit, vmap, grad, jacfwd and jacrev.

XLA calls the compiled engine.  The formulas themselves are not traced: they need the exact errors
of sums and products, which XLA does not promise to keep.  Derivatives are the sensitivities in
closed form, in forward and in reverse mode, of first order.  Arrays are float64, on the CPU;
`jax_enable_x64` has to be on.

Bad input raises InputError.  Under jit and vmap, where numbers are not known, the states of refused
bodies and times are NaN, and so are derivatives beyond binary64.
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from typing import Any

import numpy as np

from rigidsym import _tangents, steps
from rigidsym import motion as motions
from rigidsym._engines import arrays, batches, xla
from rigidsym.errors import InputError, package

jax: Any = package("jax", "rigidsym.jax", "jax")
jnp: Any = jax.numpy

__all__ = ["propagate", "states", "step"]

States = tuple[Any, Any]
# Bits of the columns, as in torque_free.h.
_OMEGA0, _INERTIA, _T = 2, 4, 8
_NAMES = {_OMEGA0: "omega0", _INERTIA: "inertia", _T: "t"}


def propagate(
    inertia: Any,
    omega0: Any,
    t: Any,
    attitude0: Any = motions.IDENTITY,
    *,
    allow_nonphysical: bool = False,
) -> States:
    """Return the states of many torque-free bodies at given times.

    Derivatives exist by all four arrays.  Leading shapes broadcast.

    Parameters
    ----------
    inertia : array_like (..., 3)
        Principal moments, kg m^2.
    omega0 : array_like (..., 3)
        Body rates at t = 0, rad/s.
    t : number or array_like (N,) or (..., N)
        Times, s: a number or (N,) for all bodies, (B, N) a row for each.
    attitude0 : array_like (..., 4)
        Attitude quaternions at t = 0, scalar first, body to inertial; they are normalised.
    allow_nonphysical : bool
        Accept moments that no body has.

    Returns
    -------
    q : array (..., N, 4)
        Attitude quaternions, (..., 4) for a number t.
    omega : array (..., N, 3)
        Body rates, rad/s.

    Raises
    ------
    InputError
        As `rigidsym.propagate` does, for arrays whose numbers are known; for shapes always.

    Examples
    --------
    >>> import jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> q, omega = propagate((1, 2, 2.5), (0.1, 0.2, 0.3), [0.0, 0.5, 1.0])
    >>> q.shape, omega.shape
    ((3, 4), (3, 3))
    """
    given = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0, "t": t}
    doubles = {name: _array(name, value) for name, value in given.items()}
    # Shapes alone decide this.
    shape = arrays.batch(*(np.broadcast_to(0.0, x.shape) for x in doubles.values())).leading
    bodies = (jnp.broadcast_to(x, (*shape, x.shape[-1])) for x in [*doubles.values()][:3])
    times = doubles["t"]
    if times.ndim > 1:
        times = jnp.broadcast_to(times, (*shape, times.shape[-1]))
    found = _propagate(bool(allow_nonphysical), *bodies, jnp.atleast_1d(times))
    return found if times.ndim else (found[0][..., 0, :], found[1][..., 0, :])


def step(inertia: Any, q: Any, omega: Any, dt: Any, *, allow_nonphysical: bool = False) -> States:
    """Return the states of bodies after dt seconds of torque-free motion.

    Derivatives exist by all four arrays.  Leading shapes broadcast.

    Parameters
    ----------
    inertia : array_like (..., 3)
        Principal moments, kg m^2.
    q : array_like (..., 4)
        Attitude quaternions, scalar first, body to inertial, of any length but zero.
    omega : array_like (..., 3)
        Body rates, rad/s.
    dt : number or array_like (...)
        Time, s, forwards or back; |omega dt| may be up to 8 rad.
    allow_nonphysical : bool
        Accept moments that no body has.

    Returns
    -------
    q : array (..., 4)
        Unit quaternions, continuous in the double cover.
    omega : array (..., 3)
        Body rates, rad/s.

    Raises
    ------
    InputError
        As `rigidsym.step` does, for arrays whose numbers are known; for shapes always.

    Examples
    --------
    >>> import jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> q, omega = step((1, 2, 2.5), (1, 0, 0, 0), (0.1, 0.2, 0.3), 0.5)
    >>> q.shape, omega.shape
    ((4,), (3,))
    """
    given = {"inertia": inertia, "q": q, "omega": omega, "dt": dt}
    doubles = {name: _array(name, value) for name, value in given.items()}
    shape = steps._shape({name: np.broadcast_to(0.0, x.shape) for name, x in doubles.items()})
    *bodies, time = doubles.values()
    rows = (jnp.broadcast_to(x, (*shape, x.shape[-1])) for x in bodies)
    return _step(bool(allow_nonphysical), *rows, jnp.broadcast_to(time, shape))


def states(motion: motions.TorqueFreeMotion, t: Any) -> States:
    """Return the states of one known motion at times.

    The constants of the motion are computed once, from its exact numbers; derivatives exist by the
    times.  Use `propagate` for derivatives by what the motion is given by.

    Parameters
    ----------
    motion : TorqueFreeMotion
        The motion.
    t : number or array_like (...)
        Times, s.

    Returns
    -------
    q : array (..., 4)
        Attitude quaternions.
    omega : array (..., 3)
        Body rates, rad/s.

    Raises
    ------
    InputError
        As a call of the motion does, for times that are known.

    Examples
    --------
    >>> import jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> motion = motions.TorqueFreeMotion(("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"))
    >>> states(motion, [[0.0, 90.0, 180.0]])[0].shape
    (1, 3, 4)
    """
    if not isinstance(motion, motions.TorqueFreeMotion):
        raise InputError("motion", repr(motion), "must be a TorqueFreeMotion")

    def found(columns: int, times: Any) -> tuple[Any, ...]:
        shapes = [(*times.shape, width) for width in (4, 3, *(3, 3) * bool(columns))]

        def on_host(times: np.ndarray) -> list[np.ndarray]:
            rows = _motion_on_host(motion, columns, np.ravel(times))
            return [x.reshape(*np.shape(times), x.shape[-1]) for x in rows]

        if xla.registered():
            prepared = np.frombuffer(motion.replace(engine="c")._prepared, np.uint8)
            rows = _in_c(xla.STATES, shapes, prepared, times, columns=columns, spread="expand_dims")
        else:
            rows = _on_host(on_host, shapes, times)
        return _checked(rows, lambda times: motion(np.ravel(times)), times)

    @jax.custom_jvp
    def at(times: Any) -> States:
        q, omega = found(0, times)
        return q, omega

    @at.defjvp
    def _at_jvp(primals: Any, tangents: Any) -> tuple[States, States]:
        q, omega, turn, rates = found(_T, *primals)
        by_time = tangents[0][..., None]
        return (q, omega), (_tangents.change(jnp, turn * by_time, q), rates * by_time)

    return at(_array("t", t))


def _array(name: str, value: Any) -> Any:
    """Convert user input to an array of doubles.

    Raises InputError for what is no array of numbers, and without `jax_enable_x64`.
    """
    if not jax.config.jax_enable_x64:
        rule = "must be on, because states are float64"
        step = 'jax.config.update("jax_enable_x64", True) before the first array'
        raise InputError("jax_enable_x64", False, rule, next_step=step)
    # Lists may have JAX's arrays in them.
    if not any(isinstance(x, jax.Array) for x in jax.tree.leaves(value)):
        value = batches.array(name, value, lenient=True)
    found = jnp.asarray(value)
    if not (jnp.issubdtype(found.dtype, jnp.integer) or jnp.issubdtype(found.dtype, jnp.floating)):
        raise InputError(name, f"an array of {found.dtype}", "must be an array of numbers")
    return found.astype(jnp.float64)


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _propagate(nonphysical: bool, inertia: Any, omega0: Any, attitude0: Any, t: Any) -> States:
    """Return the states of bodies of one leading shape.

    t is (N,) or has a row for each body.
    """
    q, omega = _found(nonphysical, 0, inertia, omega0, attitude0, t)
    return q, omega


@partial(_propagate.defjvp, symbolic_zeros=True)
def _propagate_jvp(nonphysical: bool, primals: Any, tangents: Any) -> tuple[States, States]:
    q, omega, *derivatives = _found(nonphysical, _columns(tangents), *primals)
    turn, rates = _changes(derivatives, primals[2], tangents)
    return (q, omega), (_tangents.change(jnp, turn, q), rates + jnp.zeros_like(omega))


@partial(jax.custom_jvp, nondiff_argnums=(0,))
def _step(nonphysical: bool, inertia: Any, q: Any, omega: Any, dt: Any) -> States:
    """Return the states of bodies of one leading shape after a step."""
    given, shapes = (inertia, q, omega, dt), [q.shape, omega.shape]
    if xla.registered():
        found = _in_c(xla.STEP, shapes, *given, nonphysical=nonphysical)
    else:
        found = _on_host(partial(_steps_on_host, nonphysical), shapes, *given)
    again = partial(steps.step, allow_nonphysical=nonphysical)
    after, rates = _checked(found, again, *given)
    return after, rates


@partial(_step.defjvp, symbolic_zeros=True)
def _step_jvp(nonphysical: bool, primals: Any, tangents: Any) -> tuple[States, States]:
    inertia, q, omega, dt = primals
    after = _step(nonphysical, *primals)
    # A step is a motion at one time.
    by_inertia, by_q, by_omega, by_dt = tangents
    by_t = by_dt if _is_zero(by_dt) else by_dt[..., None]
    changes = by_inertia, by_omega, by_q, by_t
    columns = _columns(changes)
    motion = _found(nonphysical, columns, inertia, omega, q, dt[..., None]) if columns else ()
    turn, rates = (x[..., 0, :] for x in _changes(motion[2:], q, changes))
    return after, (_tangents.change(jnp, turn, after[0]), rates + jnp.zeros_like(omega))


def _is_zero(tangent: Any) -> bool:
    """Return True for a tangent that JAX has found to be zero."""
    return isinstance(tangent, jax.custom_derivatives.SymbolicZero)


def _columns(tangents: Any) -> int:
    """Return the bits of the columns that the changes of inertia, omega0, ..., t are along."""
    by_inertia, by_omega0, _, by_t = (not _is_zero(x) for x in tangents)
    return _INERTIA * by_inertia + _OMEGA0 * by_omega0 + _T * by_t


def _changes(derivatives: Sequence[Any], attitude0: Any, tangents: Any) -> States:
    """Return the small rotations and the changes of the rates, at all times of each body.

    tangents: of inertia, omega0, attitude0 and t.  They are linear in these, so that JAX transposes
    them for reverse mode.
    """
    by_inertia, by_omega0, by_attitude0, by_t = tangents
    turn = rates = jnp.zeros((1, 3))
    # A small rotation at the start turns the whole motion in space.
    if not _is_zero(by_attitude0):
        turn = turn + _tangents.rotation(jnp, by_attitude0, attitude0)[..., None, :]
    by_bodies = [x for x in (by_omega0, by_inertia) if not _is_zero(x)]
    if by_bodies:
        vector = jnp.concatenate(by_bodies, axis=-1)
        turn = turn + jnp.einsum("...nij,...j->...ni", derivatives[0], vector)
        rates = rates + jnp.einsum("...nij,...j->...ni", derivatives[1], vector)
    if not _is_zero(by_t):
        turn = turn + derivatives[2] * by_t[..., None]
        rates = rates + derivatives[3] * by_t[..., None]
    return turn, rates


def _found(
    nonphysical: bool, columns: int, inertia: Any, omega0: Any, attitude0: Any, t: Any
) -> tuple[Any, ...]:
    """Return q and omega of bodies at times and, by columns, arrays as of `Sensitivity`."""
    given = inertia, omega0, attitude0, t
    leading = *inertia.shape[:-1], t.shape[-1]
    width = 3 * (columns & (_OMEGA0 | _INERTIA)).bit_count()
    by_t = 3 * bool(columns & _T)
    ends = (4,), (3,), *((3, width), (3, width), (by_t,), (by_t,)) * bool(columns)
    shapes = [(*leading, *end) for end in ends]
    if xla.registered():
        found = _in_c(xla.PROPAGATE, shapes, *given, columns=columns, nonphysical=nonphysical)
    else:
        found = _on_host(partial(_bodies_on_host, nonphysical, columns), shapes, *given)

    def again(
        inertia: np.ndarray, omega0: np.ndarray, attitude0: np.ndarray, t: np.ndarray
    ) -> None:
        options: Any = {"allow_nonphysical": nonphysical}
        motions.propagate(inertia, omega0, t, attitude0, **options)

    return _checked(found, again, *given)


def _in_c(
    name: str,
    shapes: Sequence[tuple[int, ...]],
    *given: Any,
    columns: int = 0,
    nonphysical: bool = False,
    spread: str = "broadcast_all",
) -> Sequence[Any]:
    """Let XLA call the engine in C."""
    results = [jax.ShapeDtypeStruct(shape, jnp.float64) for shape in shapes]
    call = jax.ffi.ffi_call(name, results, vmap_method=spread)
    options = {"columns": np.int32(columns), "nonphysical": np.int32(nonphysical)}
    return _once(lambda *arrays: call(*arrays, **options))(*given)


def _on_host(
    function: Callable[..., Sequence[np.ndarray]], shapes: Sequence[tuple[int, ...]], *given: Any
) -> Sequence[Any]:
    """Let XLA call Python, where there is no C compiler."""
    results = [jax.ShapeDtypeStruct(shape, jnp.float64) for shape in shapes]

    def called(*arrays: Any) -> list[np.ndarray]:
        return [np.asarray(x) for x in function(*map(np.asarray, arrays))]

    call = partial(jax.pure_callback, called, results, vmap_method="broadcast_all")
    return _once(call)(*given)


def _once(call: Callable[..., Any]) -> Callable[..., Any]:
    """Refuse to differentiate a call of the engine: its derivatives are computed beside states."""
    found = jax.custom_jvp(call)

    @found.defjvp
    def _refused(primals: Any, tangents: Any) -> Any:
        raise NotImplementedError("rigidsym.jax: states have derivatives of first order alone")

    return found


def _checked(found: Sequence[Any], again: Callable[..., object], *given: Any) -> tuple[Any, ...]:
    """Return what was found, if it is good.

    Where it has NaN and the numbers given are known, compute the states again, by a function that
    raises InputError.
    """
    known = not any(isinstance(x, jax.core.Tracer) for x in (*given, *found))
    if known and any(bool(jnp.isnan(x).any()) for x in found[:2]):
        again(*map(np.asarray, given))
    return tuple(found)


def _motion_on_host(
    motion: motions.TorqueFreeMotion, columns: int, t: np.ndarray
) -> Sequence[np.ndarray]:
    if not columns:
        return motion(t, errors="nan")
    q, omega, S = motion.sensitivity(t, "nan", ["t"])
    return q, omega, S.attitude_t, S.rates_t


def _bodies_on_host(
    nonphysical: bool,
    columns: int,
    inertia: np.ndarray,
    omega0: np.ndarray,
    attitude0: np.ndarray,
    t: np.ndarray,
) -> Sequence[np.ndarray]:
    # The leading shape of t begins as that of the bodies does.
    ones = (1,) * (inertia.ndim - t.ndim)
    times = t.reshape(*t.shape[:-1], *ones, t.shape[-1]) if t.ndim > 1 else t
    options: Any = {"errors": "nan", "allow_nonphysical": nonphysical}
    if not columns:
        return motions.propagate(inertia, omega0, times, attitude0, **options)
    names = [name for bit, name in _NAMES.items() if columns & bit]
    options |= {"sensitivity": True, "columns": names}
    q, omega, S = motions.propagate(inertia, omega0, times, attitude0, **options)
    return q, omega, S.attitude, S.rates, S.attitude_t, S.rates_t


def _steps_on_host(
    nonphysical: bool, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray
) -> Sequence[np.ndarray]:
    after = np.full(q.shape, np.nan), np.full(omega.shape, np.nan)
    for k in np.ndindex(dt.shape):
        with suppress(InputError):
            options: Any = {"allow_nonphysical": nonphysical}
            after[0][k], after[1][k] = steps.step(inertia[k], q[k], omega[k], dt[k], **options)
    return after
