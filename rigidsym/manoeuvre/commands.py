"""The commands `plan`, `track` and `figures`: parse, call, print."""

import argparse
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from rigidsym.errors import InputError


@dataclass(frozen=True, slots=True)
class Tools:
    """What the command line lends to its commands."""

    path: Callable[[str], Path]
    "Type of an argument."
    positive: Callable[[str], int]
    "Type of an argument."
    table: Callable[[str, Sequence[str], Sequence[Sequence[str]]], None]
    "Prints a title, columns and rows."
    progress: Callable[[str], Callable[[int, int], None]]
    "A progress bar of a name."
    say: Callable[[str], None]
    "To standard error."


def add(command: Callable[..., argparse.ArgumentParser], tools: Tools) -> None:
    """Give the command line its commands about manoeuvres."""
    plan = command("plan", partial(_plan, tools), "natural motions from one attitude to another")
    plan.add_argument("manoeuvre", metavar="MANOEUVRE.toml", help="a file, or `paper`")
    plan.add_argument(
        "--all", metavar="N", type=tools.positive, default=1, help="the N cheapest; one by default"
    )
    plan.add_argument("-o", "--output", metavar="DIR", type=tools.path, help="JSON and case files")
    plan.add_argument("--json", action="store_true", help="to stdout alone")

    track = command("track", partial(_track, tools), "fly a manoeuvre in closed loop")
    track.add_argument("manoeuvre", metavar="MANOEUVRE.toml", help="a file, or `paper`")
    track.add_argument("-o", "--output", metavar="DIR", type=tools.path, help="states and pictures")
    track.add_argument("--json", action="store_true", help="to stdout alone")

    figures = command("figures", partial(_figures, tools), "the paper's Figures 1 to 3")
    figures.add_argument(
        "-o", "--output", metavar="DIR", default="figures", type=tools.path, help="for the pictures"
    )


def _plan(tools: Tools, options: Any) -> int:
    from rigidsym.files import probe
    from rigidsym.manoeuvre.files import open_manoeuvre

    asked, _ = open_manoeuvre(options.manoeuvre)
    if options.output:
        probe(options.output)
    with _app():
        from rigidsym.manoeuvre.plan import solve
    found = solve(asked, options.all)
    written = found.write(options.output) if options.output else []
    if options.json:
        print(found.to_json(), end="")
    else:
        tools.table(found.title, *found.table())
    for path in written:
        tools.say(f"wrote {path}")
    return 0


def _track(tools: Tools, options: Any) -> int:
    with _app():
        from rigidsym.manoeuvre.flight.track import track
    from rigidsym.files import probe

    if options.output:
        probe(options.output)
    with _app():
        found = track(options.manoeuvre, tools.progress("track"))
        written = found.write(options.output) if options.output else []
    if options.json:
        print(found.to_json(), end="")
    else:
        tools.table("rigidsym track", ("", "flown"), found.rows())
    for path in written:
        tools.say(f"wrote {path}")
    return 1 if found.missed else 0


def _figures(tools: Tools, options: Any) -> int:
    with _app():
        from rigidsym.manoeuvre.figures import figures
    from rigidsym.files import probe

    probe(options.output)
    with _app():
        found = figures(tools.progress("figures"))
        written = found.write(options.output)
    tools.table("rigidsym figures", ("figure", "this shows"), found.rows())
    for path in written:
        tools.say(f"wrote {path}")
    return 0


@contextmanager
def _app() -> Generator[None]:
    """A package that is not installed becomes one line."""
    try:
        yield
    except ImportError as error:
        raise InputError("packages", error.name or "missing", str(error)) from None
