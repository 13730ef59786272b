"""Tables of states, and their text as CSV, JSON and NPZ."""

import io
import json
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym.io.cases import Case

COLUMNS = ("t", "q0", "q1", "q2", "q3", "omega1", "omega2", "omega3")
SCHEMA = "rigidsym.states/1"

if TYPE_CHECKING:
    from mpmath import mpf

Time = TypeVar("Time")


# A decimal string, or a ball: `mid` and `rad` as decimal strings.
Number = str | dict[str, str]
Row = tuple[Number, list[Number], list[Number]]


@dataclass(frozen=True, slots=True)
class Table:
    """Table with the time, the attitude and the body rates of each state.

    Numbers are decimal strings or balls; `parts` has the names of a ball's parts.
    """

    rows: list[Row]
    parts: tuple[str, ...] = ()


def doubles(case: Case) -> Table:
    """Compute the table of a case's states in float64.

    Numbers are written as the shortest decimals of the doubles.
    """
    times = inputs.doubles("times", case.times)
    return _table(times, case.motion(times), repr, lambda x: repr(float(x)))


def decimals(case: Case, digits: int, **how: Any) -> Table:
    """Compute the table of a case's states to `digits` significant digits.

    how: other arguments of `precise`.
    """
    from mpmath import mp

    def text(x: "mpf") -> str:
        return mp.nstr(x, digits, strip_zeros=False, min_fixed=-4, max_fixed=digits + 1)

    states = case.motion.precise(list(case.times), digits, **how)
    return _table(case.times, states, lambda t: inputs.decimal(t, digits), text)


def balls(case: Case, digits: int, **how: Any) -> Table:
    """Compute the table of a case's states as decimal balls that contain the true values.

    how: other arguments of `enclose`.
    """
    from rigidsym.precise._printed import printed_ball, printed_rational

    states = case.motion.enclose(list(case.times), digits, **how)
    return _table(
        case.times, states, lambda t: printed_rational(t, digits), printed_ball, ("mid", "rad")
    )


def _table(
    times: Iterable[Time],
    states: tuple[np.ndarray, np.ndarray],
    time: Callable[[Time], Number],
    number: Callable[[Any], Number],
    parts: tuple[str, ...] = (),
) -> Table:
    rows: list[Row] = [
        (time(t), [number(x) for x in q], [number(x) for x in omega])
        for t, q, omega in zip(times, *states, strict=True)
    ]
    return Table(rows, parts)


def to_csv(table: Table) -> bytes:
    """Convert a table of states to CSV.

    A ball takes two columns, such as q0_mid and q0_rad.
    """
    columns = [f"{c}_{part}" for c in COLUMNS for part in table.parts] or COLUMNS
    lines = [",".join(columns)]
    for t, q, omega in table.rows:
        numbers = ((x,) if isinstance(x, str) else x.values() for x in (t, *q, *omega))
        lines.append(",".join(text for number in numbers for text in number))
    return ("\n".join(lines) + "\n").encode()


def to_json(table: Table) -> bytes:
    """Convert a table of states to JSON.

    The schema is rigidsym.states/1.  Numbers are decimal strings, or balls with two of them.
    """
    states = [{"t": t, "q": q, "omega": omega} for t, q, omega in table.rows]
    return (json.dumps({"schema": SCHEMA, "states": states}, indent=1) + "\n").encode()


def to_npz(table: Table) -> bytes:
    """Convert a table of states to a NumPy archive (NPZ).

    The archive has float64 arrays t (N,), q (N, 4) and omega (N, 3).
    """
    t, q, omega = (np.array([row[k] for row in table.rows], dtype=float) for k in range(3))
    buffer = io.BytesIO()
    np.savez(buffer, t=t, q=q.reshape(-1, 4), omega=omega.reshape(-1, 3))
    return buffer.getvalue()


FORMATS = {"csv": to_csv, "json": to_json, "npz": to_npz}
