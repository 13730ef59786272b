"""The commands `plan`, `track`, `figures` and `compare`."""

from argparse import Namespace

from rigidsym.cli.arguments import Command, as_count, as_path
from rigidsym.cli.output import packages, progress, say_written, table


def add(command: Command) -> None:
    """Give the command line its commands about manoeuvres."""
    plan = command(
        "plan", _plan, "natural motions from one attitude to another", "plan paper --all 3"
    )
    plan.add_argument("manoeuvre", metavar="MANOEUVRE.toml", help="a file, or `paper`")
    plan.add_argument("--all", metavar="N", type=as_count, default=1, help="the N cheapest")
    plan.add_argument("-o", "--output", metavar="DIR", type=as_path, help="for JSON and case files")
    plan.add_argument("--json", action="store_true", help="to stdout alone")

    track = command("track", _track, "fly a manoeuvre in closed loop", "track paper -o flight")
    track.add_argument("manoeuvre", metavar="MANOEUVRE.toml", help="a file, or `paper`")
    track.add_argument(
        "-o", "--output", metavar="DIR", type=as_path, help="for states and pictures"
    )
    track.add_argument("--json", action="store_true", help="to stdout alone")

    figures = command("figures", _figures, "the paper's Figures 1 to 3", "figures -o figures")
    figures.add_argument(
        "-o", "--output", metavar="DIR", default="figures", type=as_path, help="for the pictures"
    )

    compare = command(
        "compare",
        _compare,
        "natural motions, quaternion feedback, optimal control",
        "compare --manoeuvres 5 -o comparison",
    )
    compare.add_argument(
        "--manoeuvres",
        metavar="N",
        type=as_count,
        default=20,
        help="random ones; 20 take some minutes",
    )
    compare.add_argument("--seed", metavar="S", type=as_count, default=1, help="of the manoeuvres")
    compare.add_argument(
        "--workers", metavar="W", type=as_count, help="processes; one for each core by default"
    )
    compare.add_argument(
        "-o", "--output", metavar="DIR", type=as_path, help="for JSON, Markdown and a picture"
    )
    compare.add_argument("--json", action="store_true", help="to stdout alone")


def _plan(options: Namespace) -> int:
    from rigidsym.io.files import probe
    from rigidsym.manoeuvre.manoeuvre import open_manoeuvre

    asked, _ = open_manoeuvre(options.manoeuvre)
    if options.output:
        probe(options.output)
    with packages():
        from rigidsym.manoeuvre import solve
    found = solve(asked, options.all)
    written = found.write(options.output) if options.output else []
    if options.json:
        print(found.to_json(), end="")
    else:
        table(found.title, *found.table())
    say_written(written)
    return 0


def _track(options: Namespace) -> int:
    with packages():
        from rigidsym.manoeuvre.flight.results import track
    from rigidsym.io.files import probe

    if options.output:
        probe(options.output)
    with packages():
        found = track(options.manoeuvre, progress("track"))
        written = found.write(options.output) if options.output else []
    if options.json:
        print(found.to_json(), end="")
    else:
        table("rigidsym track", ("", "flown"), found.rows())
    say_written(written)
    return 1 if found.missed else 0


def _figures(options: Namespace) -> int:
    with packages():
        from rigidsym.manoeuvre.figures import figures
    from rigidsym.io.files import probe

    probe(options.output)
    with packages():
        found = figures(progress("figures"))
        written = found.write(options.output)
    table("rigidsym figures", ("figure", "this shows"), found.rows())
    say_written(written)
    return 0


def _compare(options: Namespace) -> int:
    with packages():
        from rigidsym.manoeuvre.comparison import compare
    from rigidsym.io.files import probe

    if options.output:
        probe(options.output)
    found = compare(
        options.manoeuvres, options.seed, workers=options.workers, progress=progress("compare")
    )
    written = found.write(options.output) if options.output else []
    if options.json:
        print(found.to_json(), end="")
    else:
        for title, columns, rows in found.tables():
            table(title, columns, rows)
        print(found.conclusion)
    say_written(written)
    return 0
