"""Tables of a comparison, and comparison.md with its conclusions.

Tables and text are made from `Comparison.summary`.  A spread is shown as median [quartiles]
least..most.  Every statement about costs is computed, so that it holds for any sample.
"""

from collections.abc import Callable, Mapping, Sequence
from textwrap import fill
from typing import Any

from rigidsym.manoeuvre._comparison import cases
from rigidsym.manoeuvre._comparison.collocation import Cost, Mesh, Model, Task
from rigidsym.manoeuvre._comparison.flights import FAMILIES, HOLD
from rigidsym.manoeuvre._comparison.optima import SAME
from rigidsym.manoeuvre.flight import _actuators as actuators
from rigidsym.manoeuvre.flight._settings import Controller, Wheels

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
    """Format a spread in full."""
    low, q1, median, q3, high = (
        f"{one[name] / unit:.{digits}g}" for name in ("min", "q1", "median", "q3", "max")
    )
    return f"{median} [{q1}, {q3}] {low}..{high}"


def _median(one: Spread, unit: float = 1.0) -> str:
    return f"{one['median'] / unit:.3g}"


def _flown(model: str, methods: Mapping[str, Any], short: Callable[..., str]) -> Table:
    """Return the ways flown with the same actuators; `short` formats peaks and errors."""
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


def _ideal(models: Mapping[str, Mapping[str, Spread]]) -> Table:
    rows = [
        (model, way, spread(one, digits=4))
        for model, ways in models.items()
        for way, one in ways.items()
    ]
    title = "ideal bursts, over the least fuel of unlimited torques"
    return title, ("actuators", "way", "ratio"), rows


def _optimal(tasks: Mapping[str, Any]) -> Table:
    rows = [
        (
            *(task, setting, guess),
            spread(one["iterations"]) if one["iterations"] else "none",
            *(str(one[name]) for name in ("converged", "best", "fewest")),
        )
        for task, solved in tasks.items()
        for setting, guesses in solved["attempts"].items()
        for guess, one in guesses.items()
    ]
    return "optimal control", _OPTIMAL, rows


def tables(summary: Mapping[str, Any]) -> list[Table]:
    """Return the tables for terminals: medians where a spread says little more."""
    parts = [_flown(model, methods, _median) for model, methods in summary["flown"].items()]
    return [*parts, _ideal(summary["ideal"]), _optimal(summary["optimal"])]


def conclusion(summary: Mapping[str, Any], manoeuvres: int) -> str:
    """Return the cost of the natural motion beside the least fuel and beside all other ways."""
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
    """Return comparison.md."""
    wheels, thrusters = (summary["flown"][model] for model in (Model.WHEELS, Model.THRUSTERS))
    parts = [
        "# Natural motions, quaternion feedback, optimal control",
        f"Written by `{command}`.",
        _head(),
        "![Spreads](comparison.svg)",
        "## Flown with wheels",
        _markdown(_flown(Model.WHEELS, wheels, spread)),
        _wheels(count, wheels),
        "## Flown with thrusters",
        _markdown(_flown(Model.THRUSTERS, thrusters, spread)),
        _thrusters(count, thrusters, summary["ideal"][Model.THRUSTERS]),
        "## Ideal bursts",
        _markdown(_ideal(summary["ideal"])),
        _bursts(summary["ideal"]),
        "## First guesses of an optimiser",
        _markdown(_optimal(summary["optimal"])),
        _optimiser(count, summary["optimal"]),
    ]
    whole = "\n\n".join(parts).split("\n\n")
    return (
        "\n\n".join(
            x if x.startswith(("|", "#")) else fill(x, 100, break_on_hyphens=False) for x in whole
        )
        + "\n"
    )


def _markdown(table: Table) -> str:
    _, columns, rows = table
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _head() -> str:
    wheels = Wheels()
    return f"""Random manoeuvres from rest to rest, every other one of the paper's body, the others
of random bodies of up to {cases.LARGEST_MOMENTS[1]:g} kg m^2; attitudes are random.  The duration
is that in which the whole angle can be turned about the axis of the largest moment with
{cases.IMPULSE:g} N m s, in whole {cases.ROUNDED} s, at least {cases.SHORTEST} s.  It is the same
for all ways, as are the wheels ({wheels.max_torque:g} N m), the PD controller
({Controller().natural_frequency:g} rad/s), the disturbances and the hold of {HOLD} s; only the slow
step has gains of its own.

Ways: the cheapest `natural` motion, and the same by `feedback alone`; the `eigenaxis` at constant
rate, and `smooth`, by a cubic; the `optimum` of least fuel by collocation; quaternion feedback in
one `step` straight to the target with the same gains, and with gains so low that it takes the
duration (`step, slow`).  The torque of a track is fed forward, its bursts as
{actuators.WHEELS * wheels.max_torque:g} N m centred on their instants, while feedback waits; in the
steps and by `feedback alone` nothing is fed forward.  Spreads are median [quartiles] least..most;
the integrals of squared torques are also given over the least that optimal control found.
"Cheaper" counts the manoeuvres in which a way has a smaller torque integral, summed over the axes,
than the natural motion; "saturated" those in which a wheel reaches its limit.

Wheels store the momentum of the body, so that the total momentum is zero and the body feels no
gyroscopic torque.  Coasting then is a turn at constant rates, and a natural motion has to be
driven.  Thrusters push against the outside: there a natural motion is free, and a turn at constant
rates is not.  They are flown with wheels that cancel the gyroscopic torque of their own momentum;
that part is not counted.  Optimal control has the same two models, without disturbances."""


def _wheels(count: int, methods: Mapping[str, Any]) -> str:
    squares = {way: one["over_least_square"] for way, one in methods.items()}
    dearest = max(squares, key=lambda way: squares[way]["median"])
    peaks = {way: one["torque_peak"]["median"] for way, one in methods.items()}
    step = methods["step"]
    return f"""{_against("eigenaxis", methods, count)}  {_against("optimum", methods, count)}

In the integral of the squared torque, to which the heat of wheels' motors is proportional, the
natural motion costs {_times(squares["natural"])} the least, the smooth eigenaxis
{_times(squares["eigenaxis, smooth"])}.  {_NAMES[dearest]} costs the most,
{_times(squares[dearest])} the least.  The median peak of torque is {peaks["natural"]:.2g} N m for
the natural motion, and {peaks["eigenaxis, smooth"]:.2g} N m for the smooth eigenaxis.

{_against("step", methods, count)}  A wheel saturates in {step["saturated"]}; when the duration is
over, the error is {_median(step["error_at_duration"])} degrees (median).
{_against("step, slow", methods, count)}"""


def _thrusters(count: int, methods: Mapping[str, Any], ideal: Mapping[str, Spread]) -> str:
    spent = {way: one["over_least_fuel"] for way, one in methods.items()}
    return f"""{_against("eigenaxis", methods, count)}  {_against("step, slow", methods, count)}

The natural motion as flown costs {_times(spent["natural"])} the least fuel, the motion of least
fuel {_times(spent["optimum"])}.  This includes the torque against the disturbances, that during the
{HOLD} s at the target as well; ideal bursts of the natural motion, undisturbed, cost
{_times(ideal["natural"])} the least.  By feedback alone, without torques fed forward, the same
motion costs {_times(spent["natural, feedback alone"])}.  Where a wheel saturates, the torque
that is counted may be above its limit."""


def _against(method: str, methods: Mapping[str, Any], count: int) -> str:
    one = methods[method]
    return (
        f"{_NAMES[method]} costs {_times(one['over_natural'])} what the natural motion does, and "
        f"less in {one['cheaper_than_natural']} of {count}."
    )


def _bursts(models: Mapping[str, Mapping[str, Spread]]) -> str:
    thrusters, wheels = (models[model] for model in Model)
    best = thrusters[f"natural, best of {FAMILIES}"]
    return f"""For thrusters the natural motion costs {_times(thrusters["natural"])} the least fuel,
the eigenaxis {_times(thrusters["eigenaxis"])}: for thrusters the paper presumes its motions "close"
to those of minimum fuel.  For wheels without momentum they cost {_times(wheels["natural"])} and
{_times(wheels["eigenaxis"])}.

Fuel is summed over the axes, as of thrusters along them; the planner ranks motions by the size of
their bursts, which is the fuel of one thruster that is turned.  The best of {FAMILIES} in the sum
over the axes costs {_times(best)}.  Ratios may be below 1, since the bursts of the optimum take
{Mesh().steps[0]:.1g} of the duration."""


def _optimiser(count: int, tasks: Mapping[str, Any]) -> str:
    fuel = tasks[Task(Model.THRUSTERS, Cost.FUEL).name]["attempts"]
    wheels = tasks[Task(Model.WHEELS, Cost.FUEL).name]["attempts"]
    miss = max(one["miss"] for one in tasks.values())
    best = ", ".join(f"{one['best']} from {_GUESSES[k]}" for k, one in fuel["default"].items())
    return f"""For the least fuel of thrusters IPOPT by default takes, in the median,
{_iterations(fuel["default"])}: an interior-point method moves away from its guess first.  With
settings that stay near the guess it takes {_iterations(fuel["near the guess"])}; for wheels
{_iterations(wheels["near the guess"])}.

By default the best is found in {best}, of {count}.  "Best" are those within {SAME:g} of the least
cost of all attempts; attempts that converge and are not among them end in other local optima.  The
torques found lead within {miss:.1e} degrees of the target by another integrator."""


def _iterations(guesses: Mapping[str, Any]) -> str:
    return ", ".join(
        f"{one['iterations']['median']:g} iterations from {_GUESSES[guess]}"
        for guess, one in guesses.items()
        if one["iterations"]
    )


def _times(one: Spread) -> str:
    return f"{one['median']:.4g} times (from {one['min']:.4g} to {one['max']:.4g})"
