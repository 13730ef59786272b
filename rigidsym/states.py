"""States of a case as tables: CSV, JSON and NPZ."""

import io
import json
from collections.abc import Callable, Iterable
from typing import Any

import numpy as np

from rigidsym import inputs
from rigidsym.cases import Case

COLUMNS = ("t", "q0", "q1", "q2", "q3", "omega1", "omega2", "omega3")
SCHEMA = "rigidsym.states/1"

Row = tuple[str, list[str], list[str]]


def rows(case: Case, digits: int | None) -> list[Row]:
    """Time, attitude and rates as decimal strings: repr of the doubles, or `digits` digits."""
    if digits is None:
        times = inputs.doubles("times", case.times)
        q, omega = case.motion(times)
        return [
            (repr(t), [repr(float(x)) for x in a], [repr(float(x)) for x in w])
            for t, a, w in zip(times, q, omega, strict=True)
        ]
    text = _printer(digits)
    q, omega = case.motion.precise(list(case.times), digits)
    return [
        (inputs.decimal(t, digits), [text(x) for x in a], [text(x) for x in w])
        for t, a, w in zip(case.times, q, omega, strict=True)
    ]


def _printer(digits: int) -> Callable[[Any], str]:
    from mpmath import mp

    return lambda x: mp.nstr(x, digits, strip_zeros=False, min_fixed=-4, max_fixed=digits + 1)


def to_csv(table: Iterable[Row]) -> bytes:
    """One line per time under a header."""
    lines = [",".join(COLUMNS), *(",".join((t, *q, *omega)) for t, q, omega in table)]
    return ("\n".join(lines) + "\n").encode()


def to_json(table: Iterable[Row]) -> bytes:
    """The schema rigidsym.states/1: every number a decimal string."""
    states = [{"t": t, "q": q, "omega": omega} for t, q, omega in table]
    return (json.dumps({"schema": SCHEMA, "states": states}, indent=1) + "\n").encode()


def to_npz(table: Iterable[Row]) -> bytes:
    """float64 arrays t (N,), q (N, 4) and omega (N, 3)."""
    listed = list(table)
    buffer = io.BytesIO()
    t = np.array([float(row[0]) for row in listed])
    q = np.array([list(map(float, row[1])) for row in listed]).reshape(-1, 4)
    omega = np.array([list(map(float, row[2])) for row in listed]).reshape(-1, 3)
    np.savez(buffer, t=t, q=q, omega=omega)
    return buffer.getvalue()


FORMATS = {"csv": to_csv, "json": to_json, "npz": to_npz}
