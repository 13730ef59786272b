"""Functions that run the commands `propagate` and `methods`."""

import sys
from argparse import Namespace
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from rigidsym._cli.commands import MESSAGE, STATE_FORMATS
from rigidsym._cli.output import progress, table
from rigidsym.errors import InputError
from rigidsym.io._files import probe, write_bytes, write_text

if TYPE_CHECKING:
    from rigidsym.io._tables import Table
    from rigidsym.io.cases import Case


def propagate(options: Namespace) -> int:
    """Compute the states of a case file, and write them to stdout or to a file."""
    from rigidsym.io._tables import FORMATS

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
    """Return the output format that the option or the file name's suffix selects.

    Raises InputError if neither does.
    """
    if options.format or not options.output:
        return options.format or STATE_FORMATS[0]
    ending = options.output.suffix.removeprefix(".").lower()
    if ending not in STATE_FORMATS:
        rule = f"ends in none of .{', .'.join(STATE_FORMATS)}: give --format"
        raise InputError("output", options.output, rule)
    return ending


def _heading(options: Namespace) -> dict[str, Any]:
    """Return the user's options for the heading of a message in the format `aem`.

    Raises InputError if one of them is given with another format.
    """
    names = [name.replace("-", "_") for name in MESSAGE]
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
    from rigidsym import _inputs as inputs
    from rigidsym.io import aem, sampled
    from rigidsym.io._attitude_ephemeris import UNNAMED

    whole: dict[str, Any] = {**UNNAMED, **case.message, **heading}
    if "epoch" not in whole:
        rule = "--format aem needs --epoch YYYY-MM-DDThh:mm:ss[.d...], or the case's [message] one"
        raise InputError("epoch", "missing", rule)
    track = sampled(case.motion, inputs.doubles("times", case.times))
    return aem(track, **whole).encode()


def _case(options: Namespace) -> "Case":
    """Read the case, whose states then have the same bits on every processor."""
    from rigidsym._engines import PORTABLE
    from rigidsym.io.cases import load_case, paper_case

    if options.case == "paper":
        found = paper_case()
    else:
        found = load_case(options.case, options.allow_nonphysical)
    return replace(found, motion=found.motion.replace(engine=PORTABLE))


def _states(case: "Case", options: Namespace) -> "Table":
    from rigidsym.io import _tables as states

    given = {"method": options.method, "max_seconds": options.max_seconds}
    how = {name: value for name, value in given.items() if value is not None}
    if options.enclose:
        return states.balls(case, options.digits or 50, **how)
    if options.digits:
        return states.decimals(case, options.digits, **how)
    return states.doubles(case)


def methods(options: Namespace) -> int:
    """Print the cost and accuracy of the arbitrary-precision methods."""
    from rigidsym.precise._comparison import DIGITS, compare

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
