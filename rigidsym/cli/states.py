"""The commands `propagate` and `methods`."""

import sys
from argparse import Namespace
from typing import TYPE_CHECKING, Any

from rigidsym.cli.arguments import Command, as_count, as_path, as_seconds
from rigidsym.cli.output import progress, table
from rigidsym.errors import InputError

if TYPE_CHECKING:
    from rigidsym.io.cases import Case
    from rigidsym.io.tables import Table

_FORMATS = ("csv", "json", "npz", "aem")
_ANY_BODY = "bodies that cannot exist, too"
# The arguments of `rigidsym.io.attitude_ephemeris` that are text.
_MESSAGE = {
    "epoch": ("EPOCH", "when t is 0, YYYY-MM-DDThh:mm:ss[.d…]; needed here or there"),
    "time-system": ("T", "UTC, TAI, TT or GPS; UTC by default"),
    "object-name": ("NAME", "UNKNOWN by default"),
    "object-id": ("ID", "such as 2000-052A; UNKNOWN by default"),
    "originator": ("NAME", "who makes the message; RIGIDSYM by default"),
    "creation-date": ("DATE", "UTC; the time of writing by default"),
    "ref-frame-a": ("FRAME", "the inertial one, EME2000 by default"),
    "ref-frame-b": ("FRAME", "the axes of the body, SC_BODY_1 by default"),
}


def add(command: Command) -> None:
    """Give the command line its commands about states."""
    propagate = command(
        "propagate", _propagate, "states of one motion", "propagate paper --digits 50 -o states.csv"
    )
    propagate.add_argument("case", metavar="CASE.toml", help="a case file, or `paper`")
    propagate.add_argument(
        "--digits",
        metavar="D",
        type=as_count,
        help="significant ones, all certain; float64 by default",
    )
    propagate.add_argument(
        "--enclose", action="store_true", help="balls: middles and radii, to 50 digits or D"
    )
    propagate.add_argument(
        "--method",
        metavar="M",
        help="theta by default, carlson, landen, quadrature, mpmath or theorem1 (both without "
        "balls); flow for uncertain inputs",
    )
    propagate.add_argument(
        "--max-seconds",
        metavar="S",
        type=as_seconds,
        help="for all the digits; no limit by default",
    )
    propagate.add_argument(
        "--format",
        choices=_FORMATS,
        help="npz holds doubles, aem is the CCSDS attitude ephemeris message; by default what the "
        "name of FILE ends in, csv to stdout",
    )
    propagate.add_argument("-o", "--output", metavar="FILE", type=as_path, help="instead of stdout")
    propagate.add_argument("--allow-nonphysical", action="store_true", help=_ANY_BODY)
    message = propagate.add_argument_group("of --format aem, over what the case's [message] says")
    for name, (metavar, summary) in _MESSAGE.items():
        message.add_argument(f"--{name}", metavar=metavar, help=summary)
    message.add_argument(
        "--no-rates", dest="rates", action="store_false", default=None, help="quaternions only"
    )

    methods = command(
        "methods",
        _methods,
        "cost and accuracy of the methods for many digits",
        "methods paper --digits 50 200",
    )
    methods.add_argument("case", metavar="CASE", nargs="?", default="paper", help="a case file")
    methods.add_argument(
        "--digits", metavar="D", type=as_count, nargs="+", help="15 50 200 1000 by default"
    )
    methods.add_argument("-o", "--output", metavar="DIR", type=as_path, help="for JSON and a plot")
    methods.add_argument("--json", action="store_true", help="to stdout alone")
    methods.add_argument("--allow-nonphysical", action="store_true", help=_ANY_BODY)


def _propagate(options: Namespace) -> int:
    from rigidsym.io.files import write_bytes
    from rigidsym.io.tables import FORMATS

    options.format = _format(options)
    certain = options.digits or options.enclose
    if options.format == "npz" and (options.output is None or certain):
        rule = "holds doubles and goes to a file: give -o FILE, no --digits and no --enclose"
        raise InputError("format", "npz", rule)
    for name in ("method", "max_seconds"):
        if getattr(options, name) is not None and not certain:
            rule = "is for many digits: give --digits D or --enclose"
            raise InputError(name.replace("_", "-"), getattr(options, name), rule)
    heading = _heading(options)
    if options.format == "aem":
        data = _message(_case(options), heading)
    else:
        data = FORMATS[options.format](_states(_case(options), options))
    if options.output:
        write_bytes(options.output, data)
    else:
        sys.stdout.write(data.decode())
    return 0


def _format(options: Namespace) -> str:
    """What is said, else what the name of the file says; InputError where it says nothing."""
    if options.format or not options.output:
        return options.format or _FORMATS[0]
    ending = options.output.suffix.removeprefix(".").lower()
    if ending not in _FORMATS:
        rule = f"ends in none of .{', .'.join(_FORMATS)}: give --format"
        raise InputError("output", options.output, rule)
    return ending


def _heading(options: Namespace) -> dict[str, Any]:
    """The options that a message takes, by name; another format takes none of them."""
    names = [name.replace("-", "_") for name in _MESSAGE]
    given = {name: getattr(options, name) for name in (*names, "rates")}
    given = {name: value for name, value in given.items() if value is not None}
    if options.format != "aem":
        for name in given:
            option = "no-rates" if name == "rates" else name.replace("_", "-")
            value = "given" if name == "rates" else given[name]
            raise InputError(option, value, "is for --format aem")
    elif options.digits or options.enclose:
        rule = "has 16 digits by its standard: no --digits and no --enclose"
        raise InputError("format", "aem", rule)
    return given


def _message(case: "Case", heading: dict[str, Any]) -> bytes:
    from rigidsym import inputs
    from rigidsym.io import aem, sampled
    from rigidsym.io.messages import UNNAMED

    whole: dict[str, Any] = {**UNNAMED, **case.message, **heading}
    if "epoch" not in whole:
        rule = "--format aem needs --epoch YYYY-MM-DDThh:mm:ss[.d...], or the case's [message] one"
        raise InputError("epoch", "missing", rule)
    track = sampled(case.motion, inputs.doubles("times", case.times))
    return aem(track, **whole).encode()


def _case(options: Namespace) -> "Case":
    from rigidsym.io.cases import load_case, paper_case

    if options.case == "paper":
        return paper_case()
    return load_case(options.case, options.allow_nonphysical)


def _states(case: "Case", options: Namespace) -> "Table":
    from rigidsym.io import tables as states

    given = {"method": options.method, "max_seconds": options.max_seconds}
    how = {name: value for name, value in given.items() if value is not None}
    if options.enclose:
        return states.balls(case, options.digits or 50, **how)
    if options.digits:
        return states.decimals(case, options.digits, **how)
    return states.doubles(case)


def _methods(options: Namespace) -> int:
    from rigidsym.io.files import probe, write_text
    from rigidsym.precise.comparison import DIGITS, compare

    if options.output:
        probe(options.output)
    found = compare(_case(options), options.digits or DIGITS, progress("methods"))
    if options.json:
        print(found.to_json(), end="")
    else:
        columns = ("method", "first state", "one more", "error below", "radius")
        rows = [m.row(str(m.digits)) for m in found.by_digits]
        table("rigidsym methods", ("digits", *columns), rows)
        if found.by_distance:
            rows = [m.row(str(m.distance)) for m in found.by_distance]
            table("rigidsym methods: near the separatrix", ("distance", *columns), rows)
        print(found.conclusion)
    if options.output:
        write_text(options.output / "methods.json", found.to_json())
        write_text(options.output / "methods.svg", found.to_svg())
    return 0
