"""Readers of observations in TOML, CSV and CCSDS files."""

import csv
import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym._engines import batches
from rigidsym.errors import InputError
from rigidsym.fitting._observations import KINDS, Attitudes, Observations, Rates
from rigidsym.fitting._published import TOUTATIS_EPOCH, text, toutatis
from rigidsym.io import _attitude_ephemeris as attitude_ephemeris
from rigidsym.io import _epochs as epochs
from rigidsym.io import _files as files

DAY = 86400.0
OWN = ("toutatis", "t-handle")
"Names of the observations that come with the package."
_OPTIONS = (
    *("inertia", "moments", "moments_sigma", "scale", "loss", "starts", "fastest"),
    "delta_chi2",
)
_TABLES = {name: kind for name, kind in KINDS.items() if kind.keys}
_COLUMNS = {name: kind for name, kind in KINDS.items() if kind.columns}


@dataclass(frozen=True, slots=True)
class File:
    """The content of an observation file.

    It has the observations by kind, the options of the fit, and the epoch of t = 0.
    """

    observations: Mapping[str, list[Observations]]
    options: Mapping[str, Any] = field(default_factory=dict)
    epoch: str | None = None

    def arguments(self) -> dict[str, Any]:
        """Return the content of the file as keyword arguments of `rigidsym.fit`."""
        return {**self.observations, **self.options}


def load(name: str, sigma: Mapping[str, float] | None = None) -> File:
    """Load observations from a file or from the package.

    The suffix of a file tells its format.

    name: a path, or one of OWN. sigma: standard deviations by kind, rad and rad/s, for files that
    have no errors.  Raises InputError about the first mistake in the file.
    """
    errors = sigma or {}
    path = Path(name)
    ending = path.suffix.lower()
    if name == "toutatis" or ending == ".toml":
        check_sigma((), errors, f"{name} has errors of its own: leave it")
    if name == "toutatis":
        radar = toutatis()
        seen: list[Observations] = [Attitudes(radar.times, radar.q, radar.sigma)]
        return File({"attitudes": seen}, epoch=TOUTATIS_EPOCH)
    if name == "t-handle":
        return parse_csv(text("t-handle.csv"), errors)
    if ending not in (".toml", ".csv", ".aem"):
        rule = f"must end in .toml, .csv or .aem, or be one of: {', '.join(OWN)}"
        raise InputError("observations", name, rule)
    content = files.read_text("observations", path)
    if ending == ".toml":
        return parse_toml(content)
    return (parse_csv if ending == ".csv" else parse_message)(content, errors)


def parse_toml(content: str) -> File:
    """Parse observations and fit options in TOML.

    Observations are in the tables [[attitudes]], [[rates]] and [[vectors]].

    With `degrees`, rates, angles and their errors are in degrees; with `days`, times are in days
    and rates per day.  Times are numbers, or epochs if `epoch` gives the epoch of t = 0.
    """
    data = files.parse_toml("observations", content)
    files.check_keys("observations", data, (*_OPTIONS, "epoch", "days", "degrees", *_TABLES))
    second = DAY if inputs.is_true("days", data.get("days", False)) else 1.0
    angle = np.pi / 180 if inputs.is_true("degrees", data.get("degrees", False)) else 1.0
    units = {"rad": angle, "rad/s": angle / second}
    epoch = data.get("epoch")
    found: dict[str, list[Observations]] = {}
    for name, kind in _TABLES.items():
        tables = data.get(name, [])
        if not isinstance(tables, list) or not all(isinstance(x, Mapping) for x in tables):
            raise InputError(name, type(tables).__name__, f"must be tables [[{name}]]")
        for k, table in enumerate(tables):
            where = f"{name}[{k}]"
            known = ("times", "sigma", *kind.keys)
            files.check_keys(where, table, known, ("times", "sigma"))
            times = _times(where, table["times"], epoch, second)
            sigma, unit = batches.array(f"{where}.sigma", table["sigma"]), units[kind.unit]
            # Standard deviations are in the unit, covariances in its square.
            errors = sigma * (unit if sigma.ndim < 2 else unit**2)
            found.setdefault(name, []).append(kind.from_table(where, table, times, errors, unit))
    options = {name: data[name] for name in _OPTIONS if name in data}
    if "moments_sigma" in options:
        options["sigma"] = {"moments": options.pop("moments_sigma")}
    return File(found, options, epoch)


def _times(where: str, values: Any, epoch: str | None, second: float) -> np.ndarray:
    """Convert times to seconds from numbers or epochs."""
    if not isinstance(values, list) or not any(isinstance(x, str) for x in values):
        return batches.array(f"{where}.times", values) * second
    if epoch is None:
        raise InputError("epoch", "missing", f"{where}.times are epochs: say when they are 0")
    zero = epochs.parse("epoch", epoch, "UTC")
    ticks = [epochs.parse(f"{where}.times[{k}]", x, "UTC") for k, x in enumerate(values)]
    return np.array([(tick - zero) / epochs.SECOND for tick in ticks])


def parse_csv(content: str, sigma: Mapping[str, float]) -> File:
    """Parse observations of attitudes and rates in CSV.

    The columns are t, q0 ... q3, omega1 ... omega3, and the errors sigma_q and sigma_omega.

    Units are s, rad and rad/s.  A line has the cells of attitudes, of rates, or of both; those of
    the other kind are empty. sigma: errors by kind, for kinds without a column of errors.
    """
    lines = [
        (number, next(csv.reader([line], skipinitialspace=True)))
        for number, line in enumerate(content.removeprefix("\ufeff").splitlines(), 1)
        if line.strip() and not line.startswith("#")
    ]
    header = [name.strip() for name in lines[0][1]] if lines else []
    values = [name for kind in _COLUMNS.values() for name in kind.columns]
    known = ("t", *values, *(kind.sigma_column for kind in _COLUMNS.values()))
    for place, name in enumerate(header):
        if name not in known:
            raise InputError("header", name, f"is not one of: {', '.join(known)}")
        if name in header[:place]:
            rule = "is the name of two columns: remove or rename one of them"
            raise InputError("header", name, rule)
    for number, cells in lines[1:]:
        if len(cells) > len(header):
            rule = f"a line has more cells: line {number} has {len(cells)}; name or remove them"
            raise InputError("header", f"{len(header)} columns", rule)
        if len(cells) < len(header):
            rule = f"must be {len(header)} as in the header: fill in cells, or leave them empty"
            raise InputError(f"line {number}", f"{len(cells)} cells", rule)
    for kind in _COLUMNS.values():
        has = [name for name in (*kind.columns, kind.sigma_column) if name in header]
        for name in ("t", *kind.columns):
            if has and name not in header:
                raise InputError("header", f"no {name}", f"is needed with {', '.join(has)}")
    rows = {k: dict(zip(header, map(str.strip, x), strict=True)) for k, x in lines[1:]}
    for number, cells in lines[1:]:
        if not any(rows[number].get(name) for name in values):
            rule = "has neither an attitude nor rates: fill it in, or remove the line"
            raise InputError(f"line {number}", ",".join(cells), rule)
    found: dict[str, tuple[Any, ...]] = {}
    for name, kind in _COLUMNS.items():
        own = {k: row for k, row in rows.items() if any(row.get(x) for x in kind.columns)}
        if not own:
            continue
        t = [_number(k, row, "t") for k, row in own.items()]
        seen = [[_number(k, row, x) for x in kind.columns] for k, row in own.items()]
        errors: Any = sigma.get(name)
        if kind.sigma_column in header:
            if name in sigma:
                rule = f"the file has errors of its own, {kind.sigma_column}: give one of the two"
                raise InputError(f"sigma.{name}", errors, rule)
            errors = [_number(k, row, kind.sigma_column) for k, row in own.items()]
        found[name] = t, seen, errors
    check_sigma(found, sigma)
    return File({name: [_COLUMNS[name](*x)] for name, x in found.items()})


def _number(line: int, row: Mapping[str, str], name: str) -> float:
    cell = row[name]
    try:
        number = float(cell)
    except ValueError:
        number = math.nan
    if not math.isfinite(number) or "_" in cell:
        filled = ", ".join(x for x in row if row[x])
        rule = f"must be a number where the line has {filled}"
        raise InputError(f"line {line}, {name}", repr(cell), rule)
    return number


def check_sigma(kinds: Collection[str], sigma: Mapping[str, float], rule: str = "") -> None:
    """Raise InputError if errors are given for kinds of observations that do not need them."""
    for kind, value in sigma.items():
        if kind not in kinds:
            raise InputError(f"sigma.{kind}", value, rule or f"the file has no {kind}: leave it")


def parse_message(content: str, sigma: Mapping[str, float]) -> File:
    """Parse observations in a CCSDS attitude ephemeris message in KVN.

    Times are zero at the first state. sigma: errors by kind, which messages do not have.
    """
    found = attitude_ephemeris.read(content)
    kinds = ("attitudes",) if found.rates is None else ("attitudes", "rates")
    check_sigma(kinds, sigma)
    sets: dict[str, list[Observations]] = {
        "attitudes": [Attitudes(found.times, found.q, sigma.get("attitudes"))]
    }
    if found.rates is not None and "rates" in sigma:
        sets["rates"] = [Rates(found.times, found.rates, sigma["rates"])]
    return File(sets, epoch=found.epoch)
