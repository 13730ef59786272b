"""Functions that run the commands `plan`, `track`, `figures`, `compare` and `fit`.

Packages that a command needs are imported when it runs: `main` reports those that are missing.
"""

from argparse import Namespace
from typing import Any

from rigidsym._cli.commands import TABLE
from rigidsym._cli.output import deliver, progress, say, say_written, table
from rigidsym.io._files import probe


def plan(options: Namespace) -> int:
    """Print the cheapest torque-free motions of a manoeuvre."""
    from rigidsym.manoeuvre._manoeuvre import open_manoeuvre

    asked, _ = open_manoeuvre(options.manoeuvre)
    if options.output:
        probe(options.output)
    from rigidsym.manoeuvre import solve

    found = solve(asked, options.all)
    deliver(options, found, lambda: table(found.title, *found.table()))
    return 0


def track(options: Namespace) -> int:
    """Simulate a manoeuvre under closed-loop control.

    Returns 1 if the flight misses the target.
    """
    from rigidsym.manoeuvre.flight._results import track

    if options.output:
        probe(options.output)
    found = track(options.manoeuvre, progress("track"))
    deliver(options, found, lambda: table("rigidsym track", ("", "flown"), found.rows()))
    return 1 if found.missed else 0


def figures(options: Namespace) -> int:
    """Draw the paper's figures."""
    from rigidsym.manoeuvre._figures import figures

    probe(options.output)
    found = figures(progress("figures"))
    written = found.write(options.output)
    table("rigidsym figures", ("figure", "this shows"), found.rows())
    say_written(written)
    return 0


def compare(options: Namespace) -> int:
    """Compare control methods on random manoeuvres."""
    from rigidsym.manoeuvre._comparison import compare

    if options.output:
        probe(options.output)
    found = compare(
        options.manoeuvres, options.seed, workers=options.workers, progress=progress("compare")
    )

    def show() -> None:
        for one in found.tables():
            table(*one)
        print(found.conclusion)

    deliver(options, found, show)
    return 0


def fit(options: Namespace) -> int:
    """Fit a motion to a file of observations.

    Returns 1 if the fit does not converge or does not agree with the observations.
    """
    from rigidsym.fitting import fit, load
    from rigidsym.fitting._layout import options_for

    if options.output:
        probe(options.output)
    keys = [name.replace("-", "_") for name in TABLE]
    layout = {key: getattr(options, key) for key in keys if getattr(options, key) is not None}
    file = load(options.observations, **layout)
    for note in [*file.notes, *([f"t = 0 is {file.epoch}"] if file.epoch else [])]:
        say(note)
    names = ("inertia", "moments", "loss", "starts", "fastest", "delta_chi2")
    asked = {name: getattr(options, name) for name in names if getattr(options, name) is not None}
    arguments: dict[str, Any] = {**file.arguments(), **asked, "progress": progress("fit")}
    found = fit(**arguments)

    def show() -> None:
        print(found.title)
        for one in found.tables():
            table(*one)

    for reading in found.agreement.readings if file.is_table and not options.units else ():
        if proposed := options_for(reading.name):
            say(f"to read {reading.name}, add {proposed}")
    if options.json and (found.agreement.message or found.nonlinearity.flagged):
        say(found.title)
    deliver(options, found, show)
    return 0 if found.converged and not found.agreement.hopeless else 1
