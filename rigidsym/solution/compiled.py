"""Programmes made ready once, for numbers that are evaluated many times.

Powers are calls of `power` in them, which the functions have to bring.
"""

from collections.abc import Callable, Mapping
from functools import cache
from types import CodeType
from typing import Any

from rigidsym.language.expression import Expression, by_products, names, to_text
from rigidsym.solution.formulas import sealed

# A quantity, the code of its expression, and the names that uses.
Step = tuple[str, CodeType, tuple[str, ...]]


def run(
    programme: str, values: Mapping[str, Any], functions: Mapping[str, Callable[..., Any]]
) -> dict[str, Any]:
    """All quantities of a programme, over any numbers that mix with integers.

    Raises NameError for a value or function that is not given.
    """
    known: dict[str, Any] = {"__builtins__": {}, **functions, **values}
    exec(_code(programme), known)
    return known


@cache
def steps(programme: str) -> tuple[Step, ...]:
    """Each quantity of a programme in order, as code that may be evaluated alone."""
    return tuple(
        (f.name, compile(_text(f.expression), f"<{f.name}>", "eval"), tuple(names(f.expression)))
        for f in sealed().programmes[programme]
    )


@cache
def steps_to(wanted: frozenset[str], programme: str) -> tuple[Step, ...]:
    """The steps of a programme that some quantities need, in order."""
    needed, kept = set(wanted), []
    for step in reversed(steps(programme)):
        if step[0] in needed:
            needed.update(step[2])
            kept.append(step)
    return tuple(reversed(kept))


@cache
def used(*programmes: str) -> frozenset[str]:
    """The names that the formulas of some programmes use."""
    return frozenset(
        name for programme in programmes for step in steps(programme) for name in step[2]
    )


@cache
def _code(programme: str) -> CodeType:
    lines = [f"{f.name} = {_text(f.expression)}" for f in sealed().programmes[programme]]
    return compile("\n".join(lines), f"<{programme}>", "exec")


def _text(expression: Expression) -> str:
    return to_text(by_products(expression))
