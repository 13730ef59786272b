"""comparison.md: what was compared, the tables, and what they say."""

from collections.abc import Mapping
from textwrap import fill

from rigidsym.manoeuvre.comparison import tables
from rigidsym.manoeuvre.comparison.collocation import Cost, Model, Task
from rigidsym.manoeuvre.comparison.statistics import AttemptSpread, FlownSpread, Spread, Summary


def page(command: str, count: int, summary: Summary) -> str:
    """Markdown, from `statistics.summary`."""
    parts = [
        "# Natural motions, quaternion feedback, optimal control",
        f"Written by `{command}`.",
        _HEAD,
        "![Spreads](comparison.svg)",
        "## Flown with wheels",
        _flown(summary, Model.WHEELS),
        _wheels(count, summary),
        "## Flown with thrusters",
        _flown(summary, Model.THRUSTERS),
        _thrusters(count, summary),
        "## Ideal bursts",
        _table(tables.ideal(summary["ideal"])),
        _ideal(summary),
        "## First guesses of an optimiser",
        _table(tables.optimal(summary["optimal"])),
        _guesses(count, summary),
    ]
    whole = "\n\n".join(parts).split("\n\n")
    return "\n\n".join(x if x.startswith(("|", "#")) else _filled(x) for x in whole) + "\n"


def _filled(text: str) -> str:
    return fill(text, 100, break_on_hyphens=False)


def _flown(summary: Summary, model: Model) -> str:
    return _table(tables.flown(model, summary["flown"][model.value], tables.spread))


def _table(found: tables.Table) -> str:
    _, columns, rows = found
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


_HEAD = """Random manoeuvres from rest to rest, every other one of the paper's body, the others of
random bodies of up to 0.06 kg m^2; attitudes are random.  The duration is that in which the whole
angle can be turned about the axis of the largest moment with 1e-3 N m s, in whole 10 s, at least
60 s.  It is the same for all ways, as are the wheels (1e-3 N m), the PD controller (0.3 rad/s), the
disturbances and the hold of 60 s; only the slow step has gains of its own.

Ways: the cheapest `natural` motion, and the same by `feedback alone`; the `eigenaxis` at constant
rate, and `smooth`, by a cubic; the `optimum` of least fuel by collocation; quaternion feedback in
one `step` straight to the target with the same gains, and with gains so low that it takes the
duration (`step, slow`).  The torque of a track is fed forward, its bursts as 8e-4 N m centred on
their instants, while feedback waits; steps and `feedback alone` know nothing ahead.  Spreads are
median [quartiles] least..most; the integrals of squared torques are told over the least that
optimal control found, too.  "Cheaper" counts the manoeuvres in which a way has a smaller torque
integral, summed over the axes, than the natural motion; "saturated" those in which a wheel reaches
its limit.

Wheels store what the body turns with: both together have no momentum, and the body feels no
gyroscopic torque.  Coasting then is a turn at constant rates, and a natural motion has to be
driven.  Thrusters push against the outside: there a natural motion is free, and a turn at constant
rates is not.  They are flown with wheels that cancel what is felt of their own momentum; that part
is not counted.  Optimal control has the same two models, without disturbances."""


def _wheels(count: int, summary: Summary) -> str:
    methods = summary["flown"][Model.WHEELS.value]
    squares = {way: methods[way]["over_least_square"] for way in ("natural", "eigenaxis, smooth")}
    peaks = {way: methods[way]["torque_peak"]["median"] for way in squares}
    return f"""{_against("eigenaxis", methods, count)}  {_against("optimum", methods, count)}

In the integral of the squared torque, which is what wheels' motors heat with, the natural motion
costs {_times(squares["natural"])} the least, the smooth eigenaxis
{_times(squares["eigenaxis, smooth"])}; bursts are the dearest there is to it.  Torques peak at
{peaks["natural"]:.2g} N m, and at {peaks["eigenaxis, smooth"]:.2g} N m.

{_against("step", methods, count)}  A wheel saturates in {methods["step"]["saturated"]}; the target
is reached long before the duration is over.  {_against("step, slow", methods, count)}"""


def _thrusters(count: int, summary: Summary) -> str:
    methods = summary["flown"][Model.THRUSTERS.value]
    ways = ("natural", "natural, feedback alone", "optimum")
    spent = {way: methods[way]["over_least_fuel"] for way in ways}
    return f"""{_against("eigenaxis", methods, count)}  {_against("step, slow", methods, count)}

The natural motion as flown costs {_times(spent["natural"])} the least fuel, the motion of least
fuel {_times(spent["optimum"])}.  By feedback alone the natural motion costs
{_times(spent["natural, feedback alone"])}: a controller that knows attitudes and rates, not
torques, falls behind and catches up; that is the controller, not the motion.  Most of what else is
above 1 holds against the disturbances, the 60 s at the target included.  Where a wheel saturates,
the torque that counts may be above its limit."""


def _against(method: str, methods: Mapping[str, FlownSpread], count: int) -> str:
    one = methods[method]
    return (
        f"{_NAMES[method]} costs {_times(one['over_natural'])} what the natural motion does, and "
        f"less in {one['cheaper_than_natural']} of {count}."
    )


_NAMES = {
    "eigenaxis": "The eigenaxis at constant rate",
    "optimum": "The motion of least fuel",
    "step": "The step with the same gains",
    "step, slow": "The slow step",
}


def _ideal(summary: Summary) -> str:
    thrusters, wheels = (summary["ideal"][model.value] for model in Model)
    return f"""For thrusters the natural motion costs {_times(thrusters["natural"])} the least fuel,
the eigenaxis {_times(thrusters["eigenaxis"])}: this is where the paper presumes its motions "close"
to those of minimum fuel.  For wheels without momentum they cost {_times(wheels["natural"])} and
{_times(wheels["eigenaxis"])}.

Fuel is summed over the axes, as of thrusters along them; the planner ranks motions by the size of
their bursts, which is that of a thruster that is turned.  The best of ten in the sum over the axes
costs {_times(thrusters["natural, best of 10"])}.  Ratios may be below 1 by what a burst of the
optimum takes, 1e-4 of the duration."""


def _guesses(count: int, summary: Summary) -> str:
    fuel = summary["optimal"][Task(Model.THRUSTERS, Cost.FUEL).name]["attempts"]
    wheels = summary["optimal"][Task(Model.WHEELS, Cost.FUEL).name]["attempts"]
    miss = max(one["miss"] for one in summary["optimal"].values())
    return f"""For the least fuel of thrusters IPOPT by its default takes, in the median,
{_iterations(fuel["default"])}: an interior-point method moves away from its guess before anything
else.  Told to stay near the guess it takes {_iterations(fuel["near the guess"])}; for wheels
{_iterations(wheels["near the guess"])}.

{_found(fuel["default"], count)}  "Best" are those within 1e-4 of the least cost of all
attempts: where fewer are, there are other local optima.  The torques found lead within {miss:.1e}
degrees of the target by another integrator."""


def _iterations(guesses: Mapping[str, AttemptSpread]) -> str:
    parts = [
        f"{one['iterations']['median']:g} iterations from {_GUESSES[guess]}"
        if one["iterations"]
        else ""
        for guess, one in guesses.items()
    ]
    return ", ".join(part for part in parts if part)


_GUESSES = {
    "natural": "the natural motion",
    "eigenaxis": "the eigenaxis",
    "still": "no motion at all",
}


def _found(guesses: Mapping[str, AttemptSpread], count: int) -> str:
    parts = [f"{one['best']} from {_GUESSES[guess]}" for guess, one in guesses.items()]
    return f"By default the best is found in {', '.join(parts)}, of {count}."


def _times(one: Spread) -> str:
    return f"{one['median']:.4g} times (from {one['min']:.4g} to {one['max']:.4g})"
