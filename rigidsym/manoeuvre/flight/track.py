"""From a manoeuvre file to a flight: read, plan, fly."""

from collections.abc import Callable

from rigidsym.manoeuvre.files import open_manoeuvre
from rigidsym.manoeuvre.flight.fly import fly
from rigidsym.manoeuvre.flight.reading import read
from rigidsym.manoeuvre.flight.results import Tracked
from rigidsym.manoeuvre.planning import solve


def track(name: str, progress: Callable[[int, int], None] = lambda done, total: None) -> Tracked:
    """Plan and fly what a file asks for (`paper`: the paper's); raises InputError.

    `progress` is called with the samples done and all of them.
    """
    manoeuvre, tables = open_manoeuvre(name)
    flight = read(tables)
    plan = solve(manoeuvre)
    run = fly(plan.manoeuvre, flight, plan.best, progress)
    return Tracked(plan.manoeuvre, flight, plan.best, run)
