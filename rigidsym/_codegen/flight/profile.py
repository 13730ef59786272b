"""Files of the flight profile: code, unit tests, checks, and records."""

import json
from collections.abc import Mapping
from importlib import resources

from rigidsym._codegen.flight import driver, read_back, trace
from rigidsym._codegen.flight.module import SOURCE, code
from rigidsym._codegen.flight.program import PREFIX
from rigidsym._codegen.flight.records import DEVIATIONS, UNREACHED
from rigidsym._codegen.flight.vectors import vectors
from rigidsym.solution import Solution, sealed

# Files that are written as they are.
_PLAIN = ("report.py", "Makefile")


def files(solution: Solution | None = None) -> Mapping[str, str]:
    """Return the texts of the profile's files by their names.

    Raises InputError unless the source reads back as the routines that it is printed from.
    """
    solution = solution or sealed()
    made, found = code(solution), vectors()
    read_back.check(made)
    public = [PREFIX + one.name for one in made.program.routines.values() if one.is_public]
    profile = {
        "about": [f"`{SOURCE}`, digest {made.digest}.", "", "Written by `make report`."],
        "public": public,
        "deviations": DEVIATIONS,
        "unreached": UNREACHED,
        "trace": trace.table(solution, made.program, found),
    }
    home = resources.files("rigidsym._codegen.flight")
    return {
        **made.files,
        driver.NAME: driver.text(made.program, found),
        "DEVIATIONS.md": _record(),
        "profile.json": json.dumps(profile, indent=1) + "\n",
        **{name: home.joinpath(name).read_text("utf-8") for name in _PLAIN},
    }


def _record() -> str:
    """Return the record of deviations, in Markdown."""
    rows = (f"| {rule} | {reason} |" for rule, reason in DEVIATIONS.items())
    head = [
        "# Deviations from MISRA C:2012",
        "",
        f"`{SOURCE}` keeps the mandatory and required rules that cppcheck's MISRA addon checks,",
        "except for these.  `make report` counts the reports of each rule, advisory ones included.",
        "",
        "| rule | reason |",
        "| --- | --- |",
    ]
    return "\n".join([*head, *rows]) + "\n"
