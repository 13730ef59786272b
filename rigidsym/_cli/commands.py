"""Table of all commands with their arguments and options, in the order of the help.

The parser, the completion of shells and the reference on the site are computed from this table.
Functions are named as "module:function" of `rigidsym._cli` and imported when they run.  Nothing
here imports a heavy module, which keeps `rigidsym --help` fast.
"""

import argparse
import re
from pathlib import Path
from typing import Any

_MOST = 999_999_999


class Argument:
    """One command-line argument, with the parameters of `ArgumentParser.add_argument`."""

    def __init__(self, *names: str, **keywords: Any) -> None:
        self.names, self.keywords = names, keywords


class Group:
    """A group of command-line arguments.

    With a title, they have a section of their own in the help.  Without one, they are mutually
    exclusive.
    """

    def __init__(self, *arguments: Argument, title: str = "") -> None:
        self.arguments, self.title = arguments, title


class Command:
    """One command, with its function, summary, example and arguments."""

    def __init__(
        self, name: str, run: str, summary: str, example: str, *arguments: Argument | Group
    ) -> None:
        self.name, self.run, self.summary, self.example = name, run, summary, example
        self.arguments = arguments

    @property
    def output(self) -> str:
        """What -o names: DIR or FILE, or nothing where the command has no such option."""
        grouped = (x.arguments if isinstance(x, Group) else (x,) for x in self.arguments)
        each = (one for group in grouped for one in group if "-o" in one.names)
        return next((one.keywords["metavar"] for one in each), "")


def as_path(text: str) -> Path:
    """Parse a path that must not be empty.

    Raises ArgumentTypeError for an empty text.
    """
    return Path(as_text(text))


def as_text(text: str) -> str:
    """Return a path as it is written, with a slash at its end.

    Raises ArgumentTypeError for an empty text.
    """
    if not text:
        raise argparse.ArgumentTypeError("'' must name a file or directory")
    return text


def as_count(text: str) -> int:
    """Parse a positive whole number.

    Raises ArgumentTypeError for other text.
    """
    if not re.fullmatch(r"[0-9]+(_[0-9]+)*", text) or not 1 <= int(text[:20]) <= _MOST:
        rule = f"must be a whole number, at least 1 and at most {_MOST}"
        raise argparse.ArgumentTypeError(f"{text!r:.40} {rule}")
    return int(text)


def as_seconds(text: str) -> float:
    """Parse a positive number of seconds.

    Raises ArgumentTypeError for other text.
    """
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0 < seconds < float("inf"):
        raise argparse.ArgumentTypeError(f"{text!r:.40} must be a positive number of seconds")
    return seconds


def _value(name: str, metavar: str, help: str, **keywords: Any) -> Argument:
    return Argument(name, metavar=metavar, help=help, **keywords)


def _count(name: str, metavar: str, help: str, **keywords: Any) -> Argument:
    return Argument(name, metavar=metavar, help=help, type=as_count, **keywords)


def _switch(name: str, help: str) -> Argument:
    return Argument(name, action="store_true", help=help)


def _choice(name: str, choices: tuple[str, ...], help: str, **keywords: Any) -> Argument:
    return Argument(name, choices=choices, help=help, **keywords)


def _output(metavar: str, help: str, **keywords: Any) -> Argument:
    return Argument("-o", "--output", metavar=metavar, type=as_text, help=help, **keywords)


_JSON = _switch("--json", "print JSON and nothing else to stdout")
_ANY_BODY = _switch("--allow-nonphysical", "accept moments of bodies that cannot exist")
_MANOEUVRE = _value("manoeuvre", "MANOEUVRE.toml", "a file, or `paper`")
_LEDGER = "a ledger; the sealed one by default"
_WORKERS = _count("--workers", "W", "processes; one for each core by default")

MESSAGE = {
    "epoch": ("EPOCH", "time of t = 0, YYYY-MM-DDThh:mm:ss[.d…]; needed here or in the case file"),
    "time-system": ("T", "UTC, TAI, TT or GPS; UTC by default"),
    "object-name": ("NAME", "UNKNOWN by default"),
    "object-id": ("ID", "such as 2000-052A; UNKNOWN by default"),
    "originator": ("NAME", "maker of the message; RIGIDSYM by default"),
    "creation-date": ("DATE", "UTC; the time of writing by default"),
    "ref-frame-a": ("FRAME", "the inertial frame, EME2000 by default"),
    "ref-frame-b": ("FRAME", "the axes of the body, SC_BODY_1 by default"),
}
"Options of `propagate --format aem` that are text: arguments of `rigidsym.io.aem`."
STATE_FORMATS = ("csv", "json", "npz", "aem")
RULINGS = ("holds", "holds-if", "misprint", "ambiguous", "open")
ARTICLES = ("text", "markdown", "latex", "html")
TEMPLATES = ("motion.toml", "slew.toml", "observations.csv", "observations.toml")
SHELLS = ("bash", "zsh", "tcsh")
SETTING = {
    "sequence": ("I-J-K", "axes of the rotations; 1-2-1 by default"),
    "axis": ("I", "axis to which the momentum is rotated; the first axis by default"),
    "factor": ("F", "factor of the basis (4), 1/2 or 1; 1/2 by default"),
    "sign": ("S", "sign of the basis (4), 1 or -1; 1 by default"),
    "order": ("I-J-K", "order of i, j, k in the basis; 1-2-3 by default"),
    "lagrangian": (
        "L",
        "a Lagrangian: equal moments, products of inertia, wheels (... + h1*Omega1)",
    ),
    "group": ("G", "group of the attitude matrices, SU2 or SO3; SU2 by default"),
}
"Options of `derive` for another derivation."

_LINE: dict[str, Any] = {"type": as_count}
TABLE: dict[str, tuple[str, str, dict[str, Any]]] = {
    "sigma": (
        "KIND=X,…",
        "errors, as attitudes=0.1deg,rates=0.01deg/s; needed without columns of errors",
        {},
    ),
    "columns": ("NAME=COLUMN,…", "columns, as time=UTC,q0=qs; those named t, q0… by default", {}),
    "units": ("NAME=UNIT,…", "as time=ms,rate=deg/s,angle=deg; by default the header's, or SI", {}),
    "time-format": ("F", "seconds by default, iso, jd, mjd or unix", {}),
    "epoch": ("EPOCH", "of t = 0, in UTC, or `first`; by default the first for dates", {}),
    "attitude": (
        "FORM",
        "quaternion by default, quaternion-scalar-last, matrix, euler321 or another sequence",
        {},
    ),
    "direction": ("D", "of attitudes: body-to-inertial by default, or inertial-to-body", {}),
    "axis": (
        "AXIS",
        "what directions show, needed for them: spin or, in the body, as --axis=-1,0,0",
        {},
    ),
    "allow": ("A,…", "missing, unsorted, repeated: what lines may be; by default none", {}),
    "delimiter": ("C", "a comma by default; a character, tab or space", {}),
    "decimal": ("C", "decimal mark, a point by default, or a comma", {}),
    "header-line": ("N", "line of the names; by default the first that is no comment", _LINE),
    "data-line": ("N", "line where data may begin; by default after the header", _LINE),
    "encoding": ("E", "utf-8 by default, or another such as cp1252", {}),
}
"Options of `fit` for tables: arguments of `rigidsym.fitting.load`."

COMMANDS = (
    Command(
        "reproduce",
        "general:reproduce",
        "derive, check, generate, validate and report",
        "reproduce -o reproduce",
        _output("DIR", "directory of the results", default="reproduce"),
    ),
    Command(
        "errata",
        "proofs:errata",
        "the verdict on each printed equation",
        "errata --verdict misprint",
        _value(
            "equations",
            "EQUATION",
            "equations to show in full, as 10 or 'Lemma 1'; a table of all by default",
            nargs="*",
        ),
        _choice("--verdict", RULINGS, "show only these; all by default"),
        _JSON,
    ),
    Command(
        "derive",
        "proofs:derive",
        "prove the claims and write the ledger",
        "derive -o ledger.json",
        _value(
            "chapters",
            "CHAPTER",
            "chapters, as `rigidsym derive` names them; all by default",
            nargs="*",
        ),
        Group(
            _output("FILE", "file of the ledger, or of the article"),
            _switch("--in-place", "seal the ledger of the package itself anew"),
        ),
        _JSON,
        _switch(
            "--mutants",
            "count all mutants again; without it, and unless --in-place is given, facts that are "
            "unchanged keep the counts of the sealed ledger",
        ),
        _switch("--show", "print the derivation line by line in the terminal"),
        _switch("--guesses", "list guesses and laws under their reasons"),
        _choice("--format", ARTICLES, "write an article, to stdout or --output"),
        Group(
            *(_value(f"--{name}", *texts) for name, texts in SETTING.items()),
            title="another derivation, up to Theorem 1",
        ),
    ),
    Command(
        "check",
        "proofs:check",
        "replay the certificates of a ledger in a fresh kernel",
        "check --independent",
        _value("ledger", "LEDGER", _LEDGER, nargs="?", type=as_path),
        _switch("--independent", "use the second checker, on python-flint"),
        _switch("--facts", "check no specification, as for another derivation"),
        _switch("--mutants", "count changed ledgers that would be accepted, which takes minutes"),
    ),
    Command(
        "export",
        "proofs:export",
        "write a ledger for another prover",
        "export coq -o coq",
        _choice("prover", ("coq",), "coq", metavar="PROVER"),
        _output("DIR", "directory of its files", required=True),
        _value("--ledger", "LEDGER", _LEDGER, type=as_path),
        _switch("--check", "run the prover by make, which takes minutes"),
    ),
    Command(
        "audit",
        "proofs:audit",
        "what is trusted and not decided, theorem by theorem",
        "audit",
        _JSON,
    ),
    Command(
        "codegen",
        "code:codegen",
        "write a numeric module",
        "codegen c -o attitude",
        _value(
            "target",
            "TARGET",
            "numpy, c, javascript, c_single or rust; --check alone checks all",
            nargs="?",
        ),
        _value("--form", "FORM", "theta by default; pi, the paper's; or step, one free step"),
        _value("--profile", "NAME", "none by default; flight: C for flight software, with checks"),
        _switch("--single-file", "C: one header and one source, for copies by -o or --stdout"),
        Group(
            _output("DIR", "directory of the files"),
            _switch("--in-place", "replace the modules of the package itself"),
        ),
        Group(
            _switch("--check", "compare with the files in DIR, or in the package"),
            _switch("--stdout", "print the module"),
        ),
    ),
    Command(
        "trace",
        "code:trace",
        "a generated line's facts and equations; an equation's lines",
        "trace --equation 34",
        _value("place", "FILE[:LINE]", "a generated file, or a line of it", nargs="?"),
        _value("--equation", "NUMBER", "an equation, as the paper numbers it"),
    ),
    Command(
        "compare-forms",
        "validation:compare_forms",
        "theta functions, the third kind and Fourier series, side by side",
        "compare-forms -o forms",
        _output("DIR", "directory of JSON, Markdown and a figure"),
        _JSON,
    ),
    Command(
        "validate",
        "validation:validate",
        "measure generated modules against the derivation",
        "validate numpy --stratum separatrix --cases 50",
        _value(
            "targets",
            "TARGET",
            "numpy, c; by default both, or numpy alone where there is no C compiler",
            nargs="*",
        ),
        _count("--cases", "N", "samples of each stratum; 15 by default"),
        _count("--digits", "D", "digits of the oracle; 40 by default"),
        _value("--seed", "S", "seed of the cases; 1 by default", type=int),
        _value(
            "--stratum", "NAME", "only this stratum, repeatable; all by default", action="append"
        ),
        _value(
            "--peer",
            "NAME",
            "heyoka, dop853, lsoda…, beside the targets; none by default",
            action="append",
        ),
        Group(
            _value("--case", "CASE", "one case, STRATUM:INDEX or FILE.toml, at each time"),
            _switch("--faults", "test which injected faults are detected"),
            _switch("--sensitivity", "measure sensitivities, column by column"),
            _switch("--fits", "measure the errors of fits"),
            _switch("--torques", "measure the tolerances of integrate, torque by torque"),
            _switch("--resume", "continue the campaign in -o DIR"),
        ),
        Group(_WORKERS, _value("--scheduler", "ADDRESS", "a Dask cluster, as tcp://…")),
        _output("DIR", "directory of JSON, Markdown and a page"),
        _JSON,
        _switch("--record", "record the results for the modules that codegen writes next"),
    ),
    Command(
        "propagate",
        "states:propagate",
        "states of one motion",
        "propagate paper --digits 50 -o states.csv",
        _value("case", "CASE.toml", "a case file, or `paper`"),
        _count("--digits", "D", "significant digits, all certain; float64 by default"),
        _switch("--enclose", "compute balls, middles and radii, to 50 digits or D"),
        _value(
            "--method",
            "M",
            "theta by default, carlson, landen, quadrature, mpmath or theorem1 (both without "
            "balls); flow for uncertain inputs",
        ),
        _value(
            "--max-seconds",
            "S",
            "time limit for all the digits; no limit by default",
            type=as_seconds,
        ),
        _choice(
            "--format",
            STATE_FORMATS,
            "npz holds doubles, aem is the CCSDS attitude ephemeris message; by default the suffix "
            "of FILE, and csv for stdout",
        ),
        _output("FILE", "file to write instead of stdout"),
        _ANY_BODY,
        Group(
            *(_value(f"--{name}", *texts) for name, texts in MESSAGE.items()),
            Argument(
                "--no-rates",
                dest="rates",
                action="store_false",
                default=None,
                help="write quaternions only",
            ),
            title="options of --format aem, which override [message] of the case file",
        ),
    ),
    Command(
        "methods",
        "states:methods",
        "cost and accuracy of the methods for many digits",
        "methods paper --digits 50 200",
        _value("case", "CASE", "a case file", nargs="?", default="paper"),
        _count("--digits", "D", "15 50 200 1000 by default", nargs="+"),
        _output("DIR", "directory of JSON and a plot"),
        _JSON,
        _ANY_BODY,
    ),
    Command(
        "plan",
        "applications:plan",
        "natural motions from one attitude to another",
        "plan paper --all 3",
        _MANOEUVRE,
        _count("--all", "N", "number of motions, the cheapest first", default=1),
        _output("DIR", "directory of JSON and case files"),
        _JSON,
    ),
    Command(
        "track",
        "applications:track",
        "fly a manoeuvre in closed loop",
        "track paper -o flight",
        _MANOEUVRE,
        _output("DIR", "directory of states and pictures"),
        _JSON,
    ),
    Command(
        "figures",
        "applications:figures",
        "the paper's Figures 1 to 3",
        "figures -o figures",
        _output("DIR", "directory of the pictures", default="figures"),
    ),
    Command(
        "compare",
        "applications:compare",
        "natural motions, quaternion feedback, optimal control",
        "compare --manoeuvres 5 -o comparison",
        _count("--manoeuvres", "N", "random manoeuvres; 20 take some minutes", default=20),
        _count("--seed", "S", "seed of the manoeuvres", default=1),
        _WORKERS,
        _output("DIR", "directory of JSON, Markdown and a picture"),
        _JSON,
    ),
    Command(
        "fit",
        "applications:fit",
        "the free motion that observations show",
        "fit gyro.csv --columns time=T,omega1=gx,omega2=gy,omega3=gz --units time=ms,rate=deg/s "
        "--sigma rates=0.05deg/s --delimiter ';' --decimal ,",
        _value(
            "observations",
            "OBSERVATIONS",
            "a file: .toml, .aem, or a table .csv, .tsv, .txt or .dat; or `toutatis` or `t-handle`",
        ),
        _value("--inertia", "HOW", "ratios by default, known or tensor"),
        _value(
            "--moments",
            "C",
            "principal moments, kg m^2; needed where they are known",
            type=float,
            nargs=3,
        ),
        _value("--loss", "L", "linear by default, soft_l1, huber, cauchy or arctan"),
        _count("--starts", "N", "starts of the search; 2000 by default"),
        _value(
            "--fastest",
            "RAD/S",
            "the largest rate to search; by default derived from the observations",
            type=float,
        ),
        _value(
            "--delta-chi2",
            "X",
            "limit of chi2 of alternatives above the best; 9 by default",
            type=float,
        ),
        _output("DIR", "directory of JSON, a case file and a page"),
        _JSON,
        Group(
            *(
                _value(f"--{name}", metavar, help, **how)
                for name, (metavar, help, how) in TABLE.items()
            ),
            title="how a table is read; messages propose what to add",
        ),
    ),
    Command(
        "init",
        "general:init",
        "write a template with comments",
        "init motion.toml",
        _choice("template", TEMPLATES, ", ".join(TEMPLATES), metavar="TEMPLATE"),
        _output("FILE", "file to write; TEMPLATE in this directory by default"),
    ),
    Command(
        "doctor",
        "doctor:doctor",
        "which engine computes and why, with compiler, extras and versions",
        "doctor",
        _JSON,
    ),
    Command(
        "completion",
        "general:completion",
        "a script by which a shell completes this command",
        "completion bash > ~/.local/share/bash-completion/completions/rigidsym",
        _choice("shell", SHELLS, ", ".join(SHELLS), metavar="SHELL"),
    ),
)
