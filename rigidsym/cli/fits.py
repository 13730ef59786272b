"""The command `fit`."""

from argparse import Namespace
from typing import Any

from rigidsym.cli.arguments import Command, as_count, as_path
from rigidsym.cli.output import packages, progress, say, say_written, table

# Arguments of `rigidsym.fit` that are options too.
_NAMES = ("inertia", "moments", "loss", "starts", "fastest", "delta_chi2")


def add(command: Command) -> None:
    """Give the command line its command about fits."""
    fit = command("fit", _fit, "the free motion that observations show", "fit toutatis -o toutatis")
    fit.add_argument(
        "observations",
        metavar="OBSERVATIONS",
        help="a file: .toml, .csv or .aem; or `toutatis` or `t-handle`",
    )
    fit.add_argument("--inertia", metavar="HOW", help="ratios by default, known or tensor")
    fit.add_argument(
        "--moments", metavar="C", type=float, nargs=3, help="kg m^2; needed where they are known"
    )
    for kind, unit in (("attitudes", "RAD"), ("rates", "RAD/S")):
        said = f"of {kind} in files that have no errors, and needed there"
        fit.add_argument(f"--sigma-{kind}", metavar=unit, type=float, help=said)
    losses = "linear by default, soft_l1, huber, cauchy or arctan"
    fit.add_argument("--loss", metavar="L", help=losses)
    fit.add_argument("--starts", metavar="N", type=as_count, help="of the search; 2000 by default")
    fastest = "rate to look for; by default what the observations ask for"
    fit.add_argument("--fastest", metavar="RAD/S", type=float, help=fastest)
    fit.add_argument("--delta-chi2", metavar="X", type=float, help="for alternatives; 9 by default")
    fit.add_argument(
        "-o", "--output", metavar="DIR", type=as_path, help="for JSON, a case file and a page"
    )
    fit.add_argument("--json", action="store_true", help="to stdout alone")


def _fit(options: Namespace) -> int:
    with packages():
        from rigidsym.fitting import fit
        from rigidsym.fitting.files import load
    from rigidsym.io.files import probe

    if options.output:
        probe(options.output)
    errors = {"attitudes": options.sigma_attitudes, "rates": options.sigma_rates}
    given = load(options.observations, {k: x for k, x in errors.items() if x is not None})
    asked = {name: getattr(options, name) for name in _NAMES}
    own = {name: value for name, value in asked.items() if value is not None}
    arguments: dict[str, Any] = {**given.arguments(), **own, "progress": progress("fit")}
    found = fit(**arguments)
    with packages():
        written = found.write(options.output) if options.output else []
    if options.json:
        print(found.to_json(), end="")
        if found.agreement.message or found.nonlinearity.flagged:
            say(found.title)
    else:
        print(found.title)
        for one in found.tables():
            table(*one)
    say_written(written)
    return 0 if found.converged and not found.agreement.hopeless else 1
