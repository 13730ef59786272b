"""Tables of a comparison, for terminals and pages; spreads: median [quartiles] least..most."""

from collections.abc import Callable, Mapping, Sequence

from rigidsym.manoeuvre.comparison.statistics import (
    AttemptSpread,
    FlownSpread,
    SolvedSpread,
    Spread,
    Summary,
)

Table = tuple[str, Sequence[str], Sequence[Sequence[str]]]

_FLOWN = (
    "way",
    "torque integral, 1e-3 N m s",
    "over natural's",
    "torque^2, 1e-7 N^2 m^2 s",
    "over the least",
    "torque peak, 1e-4 N m",
    "error at duration, deg",
    "after hold, deg",
    "cheaper / dearer",
    "saturated",
)
_OPTIMAL = ("task", "optimiser", "guess", "iterations", "converged", "best", "quickest")


def brief(summary: Summary) -> list[Table]:
    """For terminals, from `statistics.summary`: medians where a spread says little more."""
    parts = [flown(model, methods, _median) for model, methods in summary["flown"].items()]
    return [*parts, ideal(summary["ideal"]), optimal(summary["optimal"])]


def conclusion(summary: Summary, manoeuvres: int) -> str:
    """Whom the natural motion costs less than, and what it costs over the least fuel."""
    parts = []
    for model, methods in summary["flown"].items():
        others = {name: one for name, one in methods.items() if name != "natural"}
        beaten = (
            f"{one['dearer_than_natural']} of {manoeuvres} times less than {name}"
            for name, one in others.items()
        )
        over = methods["natural"]["over_least_fuel"]["median"]
        parts.append(
            f"With {model} a natural motion, flown, costs {over:.3g} times the least fuel "
            f"(median), {', '.join(beaten)}."
        )
    return "  ".join(parts)


def flown(model: str, methods: Mapping[str, FlownSpread], told: Callable[..., str]) -> Table:
    """Ways flown with the same actuators; `told` shows spreads of peaks and errors."""
    rows = [
        (
            method,
            spread(one["torque_integral"], 1e-3),
            spread(one["over_natural"]),
            told(one["torque_square"], 1e-7),
            told(one["over_least_square"]),
            told(one["torque_peak"], 1e-4),
            told(one["error_at_duration"]),
            told(one["error_after_hold"]),
            f"{one['cheaper_than_natural']} / {one['dearer_than_natural']}",
            str(one["saturated"]),
        )
        for method, one in methods.items()
    ]
    return f"flown with {model}", _FLOWN, rows


def ideal(models: Mapping[str, Mapping[str, Spread]]) -> Table:
    """Ideal bursts over the least fuel."""
    rows = [
        (model, way, spread(one, digits=4))
        for model, ways in models.items()
        for way, one in ways.items()
    ]
    return (
        "ideal bursts, over the least fuel of unlimited torques",
        ("actuators", "way", "ratio"),
        rows,
    )


def optimal(tasks: Mapping[str, SolvedSpread]) -> Table:
    """What guesses are worth to the optimiser."""
    rows = [
        (task, setting, guess, *_attempts(one))
        for task, solved in tasks.items()
        for setting, guesses in solved["attempts"].items()
        for guess, one in guesses.items()
    ]
    return "optimal control", _OPTIMAL, rows


def _attempts(one: AttemptSpread) -> tuple[str, ...]:
    iterations = spread(one["iterations"]) if one["iterations"] else "none"
    return iterations, str(one["converged"]), str(one["best"]), str(one["fewest"])


def _median(one: Spread, unit: float = 1.0) -> str:
    return f"{one['median'] / unit:.3g}"


def spread(one: Spread, unit: float = 1.0, digits: int = 3) -> str:
    """Median [quartiles] least..most."""
    low, q1, median, q3, high = (
        f"{one[name] / unit:.{digits}g}" for name in ("min", "q1", "median", "q3", "max")
    )
    return f"{median} [{q1}, {q3}] {low}..{high}"
