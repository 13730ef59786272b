"""Functions that run the commands `propagate` and `methods`."""

import sys
from argparse import Namespace
from dataclasses import replace
from itertools import chain, cycle
from typing import TYPE_CHECKING, Any

from rigidsym._cli.commands import MESSAGE, STATE_FORMATS
from rigidsym._cli.output import entries_text, progress, table
from rigidsym.errors import InputError
from rigidsym.io._files import probe, write_bytes, write_text

if TYPE_CHECKING:
    from rigidsym.io._tables import Table
    from rigidsym.io.cases import Case

# States at either end of a table for a reader.
_ENDS = 5


def propagate(options: Namespace) -> int:
    """Compute the states of a case file, and write them to stdout or to a file."""
    from rigidsym.io._tables import FORMATS

    shortened = not (options.format or options.output) and sys.stdout.isatty()
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
        found = _states(_case(options), options)
        if shortened:
            _excerpt(found, options)
            return 0
        data = FORMATS[options.format](found)
    if options.output:
        write_bytes(options.output, data)
    else:
        sys.stdout.write(data.decode())
    return 0


def _excerpt(states: "Table", options: Namespace) -> None:
    """Print a few of the states for a reader, and say how to get all of them.

    Doubles are columns of a table.  Numbers with many digits, and balls, are one below the other.
    """
    from rigidsym.io._tables import COLUMNS
    from rigidsym.view._tables import columns

    rows, many = states.rows, bool(options.digits or options.enclose)
    ends = 1 if many else _ENDS
    chosen = rows if len(rows) <= 2 * ends else [*rows[:ends], *rows[-ends:]]
    title = f"rigidsym propagate {options.case}: t in s, omega in rad/s"
    if many:
        every = chain.from_iterable((t, *q, *omega) for t, q, omega in chosen)
        texts = (x if isinstance(x, str) else f"{x['mid']} +/- {x['rad']}" for x in every)
        sys.stdout.write(entries_text(title, zip(cycle(COLUMNS), texts, strict=False)))
    else:
        forms = ("g", *(".6f",) * 4, *(".5g",) * 3)
        cells = [
            [f"{float(str(x)):{form}}" for x, form in zip((t, *q, *omega), forms, strict=True)]
            for t, q, omega in chosen
        ]
        if len(chosen) < len(rows):
            cells.insert(ends, ["..."] * len(COLUMNS))
        print(columns(title, COLUMNS, cells))
    print(
        f"{len(chosen)} of {len(rows)} states are shown. "
        "Write all: -o states.csv (or .json, .npz). Print all: --format csv"
    )


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
