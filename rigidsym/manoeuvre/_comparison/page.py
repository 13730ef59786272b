"""Tables of a comparison, and the report comparison.md.

Tables and text are made from `Comparison.summary`.  A spread is shown as median [quartiles]
least..most.  Every statement about costs is computed, so that it holds for any sample.
"""

from collections.abc import Callable, Mapping, Sequence
from textwrap import fill
from typing import Any

from rigidsym.manoeuvre._comparison import flights
from rigidsym.manoeuvre._comparison.collocation import MESH, Cost, Model, Task
from rigidsym.manoeuvre._comparison.optimiser import SAME
from rigidsym.manoeuvre.flight._actuators import WHEELS
from rigidsym.manoeuvre.flight._settings import Controller, Wheels
from rigidsym.view._pages import render

Table = tuple[str, Sequence[str], Sequence[Sequence[str]]]
Spread = Mapping[str, float]

# Columns of spreads: the measure of flights, its unit, and whether terminals get it in full.
_FLOWN = {
    "torque integral, 1e-3 N m s": ("torque_integral", 1e-3, True),
    "over natural's": ("over_natural", 1.0, True),
    "torque^2, 1e-7 N^2 m^2 s": ("torque_square", 1e-7, False),
    "over the least": ("over_least_square", 1.0, False),
    "torque peak, 1e-4 N m": ("torque_peak", 1e-4, False),
    "error at duration, deg": ("error_at_duration", 1.0, False),
    "after hold, deg": ("error_after_hold", 1.0, False),
}
_OPTIMAL = ("task", "optimiser", "guess", "iterations", "converged", "best", "quickest")
_NAMES = {
    "natural": "The natural motion",
    "natural, feedback alone": "The natural motion by feedback alone",
    "eigenaxis": "The eigenaxis at constant rate",
    "eigenaxis, smooth": "The smooth eigenaxis",
    "optimum": "The motion of least fuel",
    "step": "The step with the same gains",
    "step, slow": "The slow step",
}
_GUESSES = {
    "natural": "the natural motion",
    "eigenaxis": "the eigenaxis",
    "still": "no motion at all",
}


def spread(one: Spread, unit: float = 1.0, digits: int = 3) -> str:
    """Format a spread as its median, quartiles and extremes."""
    low, q1, median, q3, high = (
        f"{one[name] / unit:.{digits}g}" for name in ("min", "q1", "median", "q3", "max")
    )
    return f"{median} [{q1}, {q3}] {low}..{high}"


def _median(one: Spread, unit: float = 1.0) -> str:
    return f"{one['median'] / unit:.3g}"


def _flown(model: str, methods: Mapping[str, Any], short: Callable[..., str]) -> Table:
    """Return the table of all flights with the same actuators.

    `short` formats the spreads of peaks and errors.
    """
    rows = [
        (
            method,
            *((spread if full else short)(one[name], unit) for name, unit, full in _FLOWN.values()),
            f"{one['cheaper_than_natural']} / {one['dearer_than_natural']}",
            str(one["saturated"]),
        )
        for method, one in methods.items()
    ]
    return f"flown with {model}", ("way", *_FLOWN, "cheaper / dearer", "saturated"), rows


def _tables(summary: Mapping[str, Any], short: Callable[..., str]) -> dict[str, Table]:
    """Return the tables of a comparison by name.

    `short` formats spreads that say little more than a median.
    """
    ideal = [
        (model, way, spread(one, digits=4))
        for model, ways in summary["ideal"].items()
        for way, one in ways.items()
    ]
    optimal = [
        (
            *(task, setting, guess),
            spread(one["iterations"]) if one["iterations"] else "none",
            *(str(one[name]) for name in ("converged", "best", "fewest")),
        )
        for task, solved in summary["optimal"].items()
        for setting, guesses in solved["attempts"].items()
        for guess, one in guesses.items()
    ]
    title = "ideal bursts, over the least fuel of unlimited torques"
    return {
        **{model: _flown(model, methods, short) for model, methods in summary["flown"].items()},
        "ideal": (title, ("actuators", "way", "ratio"), ideal),
        "optimal": ("optimal control", _OPTIMAL, optimal),
    }


def tables(summary: Mapping[str, Any]) -> list[Table]:
    """Return the tables of a comparison for terminals.

    They have medians where a spread says little more.
    """
    return [*_tables(summary, _median).values()]


def conclusion(summary: Mapping[str, Any], manoeuvres: int) -> str:
    """Return sentences that compare the cost of torque-free motions with other methods."""
    parts = []
    for model, methods in summary["flown"].items():
        beaten = ", ".join(
            f"{one['dearer_than_natural']} of {manoeuvres} times less than {name}"
            for name, one in methods.items()
            if name != "natural"
        )
        over = methods["natural"]["over_least_fuel"]["median"]
        parts.append(
            f"With {model} a natural motion, flown, costs {over:.3g} times the least fuel "
            f"(median), {beaten}."
        )
    return "  ".join(parts)


def page(command: str, count: int, summary: Mapping[str, Any]) -> str:
    """Return the text of the report comparison.md."""
    flown, optimal = summary["flown"], summary["optimal"]
    wheels = flown[Model.WHEELS]
    fuel = {model: optimal[Task(model, Cost.FUEL).name]["attempts"] for model in Model}

    def against(method: str, methods: Mapping[str, Any]) -> str:
        one = methods[method]
        return (
            f"{_NAMES[method]} costs {_times(one['over_natural'])} what the natural motion does, "
            f"and less in {one['cheaper_than_natural']} of {count}."
        )

    text = render(
        "comparison.md",
        command=command,
        count=count,
        tables={name: _markdown(table) for name, table in _tables(summary, spread).items()},
        wheels=wheels,
        thrusters=flown[Model.THRUSTERS],
        ideal=summary["ideal"],
        dearest=max(wheels, key=lambda way: wheels[way]["over_least_square"]["median"]),
        fuel=fuel,
        miss=max(one["miss"] for one in optimal.values()),
        names=_NAMES,
        guesses=_GUESSES,
        against=against,
        times=_times,
        iterations=_iterations,
        cases=flights,
        limits=Wheels(),
        controller=Controller(),
        burst=WHEELS,
        hold=flights.HOLD,
        families=flights.FAMILIES,
        first_step=MESH.steps[0],
        same=SAME,
    )
    parts = text.rstrip("\n").split("\n\n")
    filled = (
        x if x.startswith(("|", "#")) else fill(x, 100, break_on_hyphens=False) for x in parts
    )
    return "\n\n".join(filled) + "\n"


def _markdown(table: Table) -> str:
    _, columns, rows = table
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _iterations(guesses: Mapping[str, Any]) -> str:
    return ", ".join(
        f"{one['iterations']['median']:g} iterations from {_GUESSES[guess]}"
        for guess, one in guesses.items()
        if one["iterations"]
    )


def _times(one: Spread) -> str:
    return f"{one['median']:.4g} times (from {one['min']:.4g} to {one['max']:.4g})"
