"""What the turn since t = 0 changes by, seen in the body: there no wide number meets another.

The columns of numbers are those of `Columns.turned`, seen in space, where all that the rates leave
open is turned by what the attitude does.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from rigidsym.precise.sensitivity.columns import NUMBERS, Columns, Named
from rigidsym.solution.formulas import sequence

ROTATION = frozenset(f"R{i}{k}" for i in NUMBERS for k in NUMBERS)
TURN = [f"q{k}" for k in range(4)]


def changes(
    columns: Columns,
    t: Any,
    rates: Mapping[str, Any],
    turn: Sequence[Any],
    names: Sequence[str],
) -> list[list[Any]]:
    """Rows (4, n) of the turn, a quaternion (4), by inputs of these names."""
    given = dict(zip(TURN, turn, strict=True))
    known: Named = {**given, **sequence("turn").up_to(ROTATION).evaluate(given, columns.functions)}
    known["K"] = columns.begun["K_squared"].sqrt()
    for k in NUMBERS:
        known |= {f"c{k}": columns.inertia[k - 1], f"Omega{k}": rates[f"Omega{k}"]}
    found = [_column(columns, t, rates, known, name) for name in names]
    return [list(row) for row in zip(*found, strict=True)]


def _column(
    columns: Columns, t: Any, rates: Mapping[str, Any], known: Named, name: str
) -> list[Any]:
    """By one input: a rate or a moment about axis k moves the momentum along that axis."""
    kind, k = name[:-1], int(name[-1])
    c, w = columns.inertia[k - 1], columns.omega0[k - 1]
    momentum, along = (c, t * (c * w)) if kind == "Omega" else (w, -rates[f"excess{k}"] / 2)
    change: Named = {"s": along}
    for i in NUMBERS:
        change |= {f"dc{i}": int(name == f"c{i}"), f"dOmega{i}": rates[f"Omega{i}_by_{name}"]}
        change[f"l{i}"] = known[f"R{k}{i}"] * momentum
    found = sequence("turned_body").evaluate({**known, **change}, columns.functions)
    return [found[f"d{x}"] for x in TURN]
