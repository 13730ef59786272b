"""Hand-written runtime of sensitivities: order of axes, scaling, blocks and shapes.

Its text is printed into the generated module of the theta form, after `runtime`.
"""

import math

import numpy as np

from rigidsym._codegen.targets.numpy.double_double import _DoubleDouble
from rigidsym._codegen.targets.numpy.runtime import (
    _BLOCK,
    _called,
    _differences,
    _of,
    _plain,
    _RefusedError,
    states,
)
from rigidsym._codegen.targets.numpy.stubs import MAX_REAL, SENSITIVITY, never

# --- runtime ---
# The changes at t = 0: of the attitude with a small turn, of the rates with those.
_AT_ONCE = np.eye(3, 9), np.eye(3, 9, 3)
# What there are columns for, in their order.
COLUMNS = ("attitude0", "omega0", "inertia", "t")


@np.errstate(all="ignore")
def sensitivities(prepared, t, errors="raise", columns=COLUMNS):
    """Return the states at the times t in s and their derivatives by the inputs.

    (q, omega, attitude, rates, attitude_t, rates_t): q (..., 4) and omega (..., 3) are those of
    `states`.  attitude and rates (..., 3, 9): a small turn in space, eta with delta R = [eta] R,
    and the body rates, by a small turn at t = 0, the rates there, and the principal moments;
    attitude_t and rates_t (..., 3): by the time.  What leaves binary64 in these units is infinite.
    Raises ValueError as `states` does, and for times at which binary64 does not hold the squares of
    changes in any; with errors="nan" there are no numbers then.  With `columns`, some of the names
    in COLUMNS, there are no others: three for each of the first three names, in their order.
    """
    asked = [name for name in COLUMNS if name in columns]
    if len(asked) != len(columns):
        raise _RefusedError("columns", f"must be some of {', '.join(COLUMNS)}, each once")
    # Where in a row the columns of each begin, and which those are of all nine.
    first = {name: 3 * k for k, name in enumerate(asked) if name != "t"}
    chosen = [3 * COLUMNS.index(name) + k for name in first for k in range(3)]
    by_t = (3,) if "t" in asked else (0,)
    # One time of one body as a number, which has the shortest way.
    if np.ndim(t) == 0 and prepared["shape"] == ():
        t = float(t)
    q, omega = states(prepared, t, None, errors)
    given, count = np.asarray(t, float), len(prepared["unit"])
    # One row of times for all motions, or one for each.
    given = given.reshape(count if given.ndim > 1 else 1, given.shape[-1] if given.ndim else 1)
    shapes = (4,), (3,), (3, len(chosen)), (3, len(chosen)), by_t, by_t
    found = _together(omega.shape[:-1], shapes[2:])
    rows = [
        x.reshape(count, given.shape[1], *shape)
        for x, shape in zip((q, omega, *found), shapes, strict=True)
    ]
    if "elapsed" not in prepared:
        prepared["elapsed"] = _elapsed(prepared)
    # While blocks are in the cache it is seen whether any number is lost.
    lost = [
        _fill_sensitivities(prepared, group, given, rows, first) for group in prepared["elapsed"]
    ]
    at_once = [x[:, chosen] for x in _AT_ONCE]
    _at_rest(prepared, given, rows, first, at_once)
    _unchanged(given, rows, at_once)
    if any(lost):
        _check_held(rows, errors)
    return (q, omega, *found)


def _together(shape, ends):
    """Allocate arrays of zeros of several shapes in one block of memory.

    Allocators keep one piece where they would return several to the system, page by page.
    """
    sizes = [math.prod((*shape, *end)) for end in ends]
    piece, found, begin = np.zeros(sum(sizes)), [], 0
    for end, size in zip(ends, sizes, strict=True):
        found.append(piece[begin : begin + size].reshape(*shape, *end))
        begin += size
    return found


def _elapsed(prepared):
    """Compute the constants of sensitivities, grouped by nome and order of axes."""
    c, apart, omega, discriminant = prepared["given"]
    axes, rows = prepared["axes"], np.arange(len(prepared["axes"]))
    # Where rates are constant, too, a is the axis with p >= r.
    apart = [apart[:, k] for k in range(3)]
    turned = _differences(apart, axes.T)[1].hi * discriminant.hi < 0
    axes = np.where(turned[:, None], axes[:, ::-1], axes)
    known = {"E_b": discriminant}
    for k, x in enumerate("abd"):
        known[f"c_{x}"] = c[rows, axes[:, k]]
        known[f"Omega_{x}0"] = omega[rows, axes[:, k]]
        known[f"axis_{x}"] = axes[:, k]
    known |= dict(zip(("c_ab", "c_ad", "c_bd"), _differences(apart, axes.T), strict=True))
    for k in range(3):
        known |= {f"c{k + 1}": c.hi[:, k], f"Omega{k + 1}_0": omega.hi[:, k]}
    for name, x in zip(("c12", "c13", "c23"), _differences(apart, range(3)), strict=True):
        known[name] = x.hi
    # At rest nothing comes of it.
    known["Omega1_0"] = np.where(prepared["unit"] == 0, 1.0, known["Omega1_0"])
    known |= {f"p{k}": prepared["q0"][:, k] for k in range(4)}
    known |= _phases(prepared)
    if len(axes) == 1:
        known = {name: _plain(value) for name, value in known.items()}
    known |= _called(SENSITIVITY["moduli"], known)
    small = np.reshape(known["modulus"].hi ** 2 <= MAX_REAL, -1)
    groups = []
    for order in sorted(set(map(tuple, axes.tolist()))):
        ordered = np.all(axes == order, axis=-1)
        for name, chosen in (("real", small & ordered), ("imaginary", ~small & ordered)):
            if np.any(chosen):
                groups.append((name, order, *_of_group(name, np.flatnonzero(chosen), known)))
    return groups


def _phases(prepared):
    """Return the phases at t = 0, and limits of p t^2 above which these phases are used."""
    reach, y0 = np.full(len(prepared["axes"]), never), np.zeros((2, len(prepared["axes"])))
    for name, index, constants in prepared["groups"]:
        if name == "hyperbolic":
            reach[index] = 1.0
            y0[:, index] = constants["y0_hi"], constants["y0_lo"]
    return {"reach": reach, "y0": _DoubleDouble(*y0)}


def _of_group(name, index, known):
    """Return the indices of a group's bodies, and its constants by the function using them.

    Constants are arrays, or Python's floats of one body.
    """
    if len(np.shape(known["c1"])):
        known = {key: value[index] for key, value in known.items()}
    made = {}
    for part in (name, "along", "columns", "turn"):
        constants = _called(SENSITIVITY[part], known)
        made[part] = {
            key: np.full(index.size, value, float) if np.ndim(value) == 0 else value
            for key, value in constants.items()
        }
    return index, _of_one(made, 0) if index.size == 1 else made


def _of_one(made, number):
    """Return the constants of one body as Python floats."""
    return {
        part: {key: float(x[number]) for key, x in known.items()} for part, known in made.items()
    }


def _fill_sensitivities(prepared, group, t, rows, first_of):
    """Write the sensitivities of one group to the output arrays block by block.

    Blocks are of times, or of bodies where times are few.  Returns True if any number is lost.
    """
    name, order, index, made = group
    size, lost = t.shape[1], False
    if index.size > 1 and size < _BLOCK // 4:
        step = max(1, _BLOCK // max(1, size))
        for first in range(0, index.size, step):
            some = slice(first, first + step)
            constants = {
                part: {key: x[some, None] for key, x in known.items()}
                for part, known in made.items()
            }
            units = [prepared[x][index[some], None] for x in ("unit", "moment_unit")]
            times = _of(t, index[some])
            place = (index[some],)
            lost |= _write_sensitivities(
                name, order, constants, units, times, rows, place, first_of
            )
        return lost
    for number, body in enumerate(index):
        constants = made if index.size == 1 else _of_one(made, number)
        units = [float(prepared[x][body]) for x in ("unit", "moment_unit")]
        step = max(1, -(-size // max(1, -(-size // _BLOCK))))
        for first in range(0, size, step):
            some = slice(first, first + step)
            # One time as a number: operations on such arrays take ten times as long.
            where = some if size > 1 else 0
            times = t[body if len(t) > 1 else 0, where]
            place = body, where
            lost |= _write_sensitivities(
                name, order, constants, units, times, rows, place, first_of
            )
    return lost


def _write_sensitivities(name, order, constants, units, t, rows, place, first_of):
    """Write the sensitivities of one body at a block of times, or of several at all times.

    Returns True if any number is lost.
    """
    unit, moment_unit = units
    known = {"t": unit * t}
    q, omega = (x[place] for x in rows[:2])
    scale = unit + (unit == 0)
    for k in range(3):
        known[f"Omega{k + 1}"] = omega[..., k] / scale
    known |= {f"q{k}": q[..., k][()] for k in range(4)}
    known |= {f"Omega_{x}": known[f"Omega{axis + 1}"] for x, axis in zip("abd", order, strict=True)}
    entry = SENSITIVITY[name]
    by_time = entry["angles"](known["t"], *(constants[name][n] for n in entry["rates"]))
    known |= dict(zip(entry["timed"], by_time, strict=False))
    known |= _stated(entry, known, constants[name])
    known |= _stated(SENSITIVITY["along"], known, constants["along"])
    columns = _stated(SENSITIVITY["columns"], known, constants["columns"])
    for one, i in zip("abd", order, strict=True):
        known[f"excess{i + 1}"] = columns[f"excess_{one}"]
        for other, j in zip("abd", order, strict=True):
            for of in ("Omega", "c"):
                change = columns[f"Omega_{one}_by_{of}_{other}"]
                known[f"Omega{i + 1}_by_{of}{j + 1}"] = change
    known |= _stated(SENSITIVITY["turn"], known, constants["turn"])
    # A unit of rates over one of moments may leave binary64 where no rate by a moment does.
    half = np.ldexp(1.0, (np.frexp(scale)[1] - np.frexp(moment_unit)[1]) // 2)
    scales = {
        ("eta", "Omega"): 1 / scale,
        ("eta", "c"): 1 / moment_unit,
        ("Omega", "Omega"): 1.0,
        ("Omega", "c"): scale / half / moment_unit,
    }
    lost = False
    for changed, found in (("eta", rows[2]), ("Omega", rows[3])):
        block = found[place]
        for of, first in (("Omega", first_of.get("omega0")), ("c", first_of.get("inertia"))):
            if first is None:
                continue
            factor = scales[changed, of]
            for i in range(3):
                for j in range(3):
                    value = known[f"{changed}{i + 1}_by_{of}{j + 1}"]
                    value = value * half if (changed, of) == ("Omega", "c") else value
                    np.multiply(value, factor, out=block[..., i, first + j])
        if changed == "eta" and "attitude0" in first_of:
            for k in range(3):
                block[..., k, k] = 1.0
        lost |= bool(np.isnan(np.min(block, initial=0.0)))
        # Of several bodies it is a copy.
        if isinstance(place[0], np.ndarray):
            found[place] = block
    for i in range(rows[4].shape[-1]):
        rows[4][(*place, ..., i)] = unit * known[f"eta{i + 1}_by_t"]
        rows[5][(*place, ..., i)] = unit * (unit * known[f"Omega{i + 1}_by_t"])
    return lost


def _stated(entry, known, constants):
    """Call a function of the elapsed time and return its results by name."""
    given = (*(known[n] for n in entry["timed"]), *(constants[n] for n in entry["shape"]))
    return dict(zip(entry["results"], entry["state"](*given), strict=True))


def _at_rest(prepared, t, rows, first_of, at_once):
    """Write the sensitivities of bodies at rest, whose rates and attitude change with omega0."""
    for body in np.flatnonzero(prepared["unit"] == 0):
        w, x, y, z = prepared["q0"][body]
        start = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
        for found, rest in zip(rows[2:], (*at_once, 0.0, 0.0), strict=True):
            found[body] = rest
        if (k := first_of.get("omega0")) is not None:
            times = t[body if len(t) > 1 else 0, :, None, None]
            rows[2][body, :, :, k : k + 3] = times * np.array(start)


def _unchanged(t, rows, at_once):
    """Write the exact initial derivatives where t = 0."""
    for body, time in np.argwhere(t == 0):
        some = slice(None) if len(t) == 1 else body
        rows[2][some, time], rows[3][some, time] = at_once


def _check_held(rows, errors):
    """Refuse times at which squares of derivatives overflow binary64, or write NaN there."""
    lost = np.any([np.any(np.isnan(x), axis=tuple(range(2, x.ndim))) for x in rows], axis=0)
    if not np.any(lost):
        return
    if errors == "raise":
        body, time = np.argwhere(lost)[0]
        rule = "on the way to spin about the middle axis squares of changes leave binary64"
        raise _RefusedError("t", rule, int(body), int(time))
    for found in rows[2:]:
        found[lost] = np.nan
