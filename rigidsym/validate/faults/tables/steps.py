"""Faults of the modules of steps: of the runtimes, which no derived line has."""

from functools import partial

from rigidsym.validate.faults.fault import Fault
from rigidsym.validate.faults.tables.c import REORDERED

_numpy, _c = partial(Fault, "numpy-step"), partial(Fault, "c-step")
_SOME = "def _some(bodies, q, omega, dt, out):"
_STEPPED = "    All are lists of columns: arrays (B,)"
_SET, _GET = "static int set_state(", "static void get_state("

_NUMPY = (
    _numpy(
        "axis",
        "the third rate left on its axis where two change places",
        _STEPPED,
        "start[0]), *start[1:]]",
        "start[0]), start[1], rates[2]]",
    ),
    _numpy(
        "quadrant",
        "a rotation backwards taken for one forwards",
        "def _moved(",
        "start[0] < 0, -1.0",
        "start[0] < 0, 1.0",
    ),
    _numpy(
        "scale",
        "the time in other units than the rates",
        _STEPPED,
        "t = _ldexp(dt, exponent)",
        "t = dt * 1.0",
    ),
    _numpy(
        "special",
        "no look for bodies at rest",
        _STEPPED,
        "still = rest | (t == 0)",
        "still = t == 0",
    ),
    _numpy(
        "double_cover_sign",
        "the attitude whose scalar part is positive",
        _STEPPED,
        "_unit([_where(still",
        "_unit([_where(found[0] < 0, -1.0, 1.0) * _where(still",
    ),
    _numpy(
        "entry_points",
        "the axes of the first body of a batch, for all its bodies",
        _SOME,
        "np.broadcast_to(np.stack(axes, -1), ",
        "np.broadcast_to(np.stack(axes, -1)[:1], ",
    ),
    _numpy(
        "ulps",
        "a quaternion too long by 2e-15",
        "def _unit(parts):",
        "(rest.hi + rest.lo) / 2",
        "((rest.hi + rest.lo) / 2 + 2e-15)",
    ),
)
_C = (
    _c(
        "axis",
        "the vector of the attitude left on its axes where two change places",
        "static void circulating(",
        "SWAP_IF(turned, x->q_a[i], x->q_d[i]);",
        "SWAP_IF(0, x->q_a[i], x->q_d[i]);",
    ),
    _c(
        "scale",
        "rates up to 2^100 not scaled, by whose powers a series overflows",
        "static double scale(",
        "largest <= 1099511627776.0",
        "largest <= 1.2676506002282294e+30",
    ),
    _c(
        "special",
        "a body at rest that has no momentum to divide by",
        _SET,
        "rates[0] = 1.0;",
        "rates[0] = 0.0;",
    ),
    _c(
        "double_cover_sign",
        "the attitude whose scalar part is positive",
        _GET,
        "q[0] = x->q_0[i];",
        "q[0] = fabs(x->q_0[i]);",
    ),
    _c(
        "entry_points",
        "the axes of the first body of a batch, for all its bodies",
        "int torque_free_steps(",
        "inertia_stride ? axis[i] : body.axis",
        "inertia_stride ? axis[0] : body.axis",
    ),
    _c(
        "entry_points",
        "the time of the first body of a batch, for all its bodies",
        "int torque_free_steps(",
        "dt[k * dt_stride]",
        "dt[0]",
    ),
    _c(
        "ulps",
        "a quaternion too long by 2e-15",
        "static INLINED void divide(",
        "(rest.hi + rest.lo) / 2.0",
        "((rest.hi + rest.lo) / 2.0 + 2e-15)",
    ),
    _c(
        "build",
        "sums reordered by the compiler, and not asked for",
        "int torque_free_body_init(",
        "if (!is_rounded_once())",
        "if (0)",
        REORDERED,
    ),
)

FAULTS = (*_NUMPY, *_C)
