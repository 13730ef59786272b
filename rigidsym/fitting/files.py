"""Files of observations: TOML for all kinds, CSV for attitudes and rates, CCSDS messages."""

import csv
import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from rigidsym import inputs
from rigidsym.engines import batches
from rigidsym.errors import InputError
from rigidsym.fitting.angles import euler_313
from rigidsym.fitting.observations import Attitudes, Directions, Observations, Rates
from rigidsym.fitting.published import TOUTATIS_EPOCH, text, toutatis
from rigidsym.io import attitude_messages, epochs
from rigidsym.io import toml as toml_file
from rigidsym.io.files import read_text

DAY = 86400.0
OWN = ("toutatis", "t-handle")
"Observations that the package has, by name."
_OPTIONS = ("inertia", "moments", "moments_sigma", "scale", "loss", "starts", "fastest")
_KEYS = (*_OPTIONS, "delta_chi2", "epoch", "days", "degrees", "attitudes", "rates", "vectors")
_TABLES: Mapping[str, tuple[str, ...]] = {
    "attitudes": ("times", "sigma", "q", "euler_313"),
    "rates": ("times", "sigma", "omega"),
    "vectors": ("times", "sigma", "seen", "known", "seen_in"),
}
_COLUMNS = {
    "attitudes": ("q0", "q1", "q2", "q3"),
    "rates": ("omega1", "omega2", "omega3"),
}
_SIGMAS = {"attitudes": "sigma_q", "rates": "sigma_omega"}

# Of a table: the numbers of its lines, and their cells by column.
Rows = list[tuple[int, dict[str, str]]]


@dataclass(frozen=True, slots=True)
class File:
    """Observations by kind, what the file says of the fit, and when its times are zero."""

    observations: Mapping[str, list[Observations]]
    options: Mapping[str, Any] = field(default_factory=dict)
    epoch: str | None = None

    def arguments(self) -> dict[str, Any]:
        """Of `rigidsym.fit`."""
        return {**self.observations, **self.options}


def load(name: str, sigma: Mapping[str, float] | None = None) -> File:
    """A file by what its name ends in, or one of OWN.

    sigma: by kind, rad and rad/s, of files that have no errors.  Raises InputError about the first
    thing that is wrong.
    """
    given = sigma or {}
    path = Path(name)
    ending = path.suffix.lower()
    if name == "toutatis" or ending == ".toml":
        check_sigma((), given, f"{name} has errors of its own: leave it")
    if name == "toutatis":
        looks = toutatis()
        seen = Attitudes(looks.times, looks.q, looks.sigma)
        return File({"attitudes": [seen]}, epoch=TOUTATIS_EPOCH)
    if name == "t-handle":
        return parse_csv(text("t-handle.csv"), given)
    if ending == ".toml":
        return parse_toml(read_text("observations", path))
    if ending == ".csv":
        return parse_csv(read_text("observations", path), given)
    if ending == ".aem":
        return parse_message(read_text("observations", path), given)
    rule = f"must end in .toml, .csv or .aem, or be one of: {', '.join(OWN)}"
    raise InputError("observations", name, rule)


def parse_toml(content: str) -> File:
    """Tables [[attitudes]], [[rates]], [[vectors]], and the arguments of the fit.

    `degrees`: rates, angles and their errors are in degrees; `days`: times are in days, rates per
    day.  Times are numbers, or epochs where `epoch` says when they are zero.
    """
    data = toml_file.parse("observations", content)
    toml_file.check_keys("observations", data, _KEYS)
    units = _Units(
        data.get("epoch"),
        DAY if inputs.is_true("days", data.get("days", False)) else 1.0,
        np.pi / 180 if inputs.is_true("degrees", data.get("degrees", False)) else 1.0,
    )
    found = {name: _tables(name, data.get(name, []), units) for name in _TABLES}
    options = {name: data[name] for name in (*_OPTIONS, "delta_chi2") if name in data}
    if "moments_sigma" in options:
        options["sigma"] = {"moments": options.pop("moments_sigma")}
    return File({name: sets for name, sets in found.items() if sets}, options, units.epoch)


@dataclass(frozen=True, slots=True)
class _Units:
    epoch: str | None
    time: float
    angle: float

    def times(self, where: str, values: Any) -> np.ndarray:
        """In s."""
        if isinstance(values, list) and any(isinstance(x, str) for x in values):
            return self._since(where, values)
        return batches.array(f"{where}.times", values) * self.time

    def _since(self, where: str, values: list[Any]) -> np.ndarray:
        if self.epoch is None:
            raise InputError("epoch", "missing", f"{where}.times are epochs: say when they are 0")
        zero = epochs.parse("epoch", self.epoch, "UTC")
        ticks = [epochs.parse(f"{where}.times[{k}]", x, "UTC") for k, x in enumerate(values)]
        return np.array([(tick - zero) / epochs.SECOND for tick in ticks])


def _tables(name: str, tables: Any, units: _Units) -> list[Observations]:
    if not isinstance(tables, list) or not all(isinstance(x, Mapping) for x in tables):
        raise InputError(name, type(tables).__name__, f"must be tables [[{name}]]")
    return [_table(name, f"{name}[{k}]", table, units) for k, table in enumerate(tables)]


def _table(name: str, where: str, table: Mapping[str, Any], units: _Units) -> Observations:
    toml_file.check_keys(where, table, _TABLES[name], ("times", "sigma"))
    times = units.times(where, table["times"])
    rate = units.angle / units.time
    sigma = batches.array(f"{where}.sigma", table["sigma"])
    errors = _scaled(sigma, rate if name == "rates" else units.angle)
    if name == "attitudes":
        return Attitudes(times, _attitudes(where, table), errors)
    if name == "rates":
        return Rates(
            times, batches.array(f"{where}.omega", _one(where, table, "omega")) * rate, errors
        )
    seen, known = (_one(where, table, key) for key in ("seen", "known"))
    return Directions(times, seen, errors, known, table.get("seen_in", "body"))


def _scaled(sigma: np.ndarray, unit: float) -> np.ndarray:
    """Standard deviations go with the unit, covariances with its square."""
    return sigma * (unit if sigma.ndim < 2 else unit**2)


def _one(where: str, table: Mapping[str, Any], key: str) -> Any:
    if key not in table:
        raise InputError(f"{where}.{key}", "missing", "is needed")
    return table[key]


def _attitudes(where: str, table: Mapping[str, Any]) -> np.ndarray:
    """Quaternions, or 3-1-3 angles in degrees: R = Rz(a) Rx(b) Rz(c)."""
    if ("q" in table) == ("euler_313" in table):
        raise InputError(where, sorted(table), "must have q or euler_313, and not both")
    if "q" in table:
        return batches.array(f"{where}.q", table["q"])
    angles = batches.array(f"{where}.euler_313", table["euler_313"])
    if angles.ndim != 2 or angles.shape[1] != 3:
        rule = "must have three angles in each row"
        raise InputError(f"{where}.euler_313", f"an array of shape {angles.shape}", rule)
    return euler_313(np.deg2rad(angles))


def parse_csv(content: str, sigma: Mapping[str, float]) -> File:
    """Columns t, q0 ... q3, omega1 ... omega3, and errors sigma_q, sigma_omega, each once.

    In s, rad and rad/s.  A line has the cells of attitudes, of rates, or of both; those of the
    other kind are empty.  sigma: of what has no column of errors.
    """
    lines = [
        (number, next(csv.reader([line], skipinitialspace=True)))
        for number, line in enumerate(content.removeprefix("\ufeff").splitlines(), 1)
        if line.strip() and not line.startswith("#")
    ]
    header = [name.strip() for name in lines[0][1]] if lines else []
    _check_names(header)
    for number, cells in lines[1:]:
        if len(cells) > len(header):
            rule = f"a line has more cells: line {number} has {len(cells)}; name or remove them"
            raise InputError("header", f"{len(header)} columns", rule)
        if len(cells) < len(header):
            rule = f"must be {len(header)} as in the header: fill in cells, or leave them empty"
            raise InputError(f"line {number}", f"{len(cells)} cells", rule)
    _check_groups(header)
    rows: Rows = []
    for number, cells in lines[1:]:
        row = {name: cell.strip() for name, cell in zip(header, cells, strict=True)}
        if not any(row.get(name) for names in _COLUMNS.values() for name in names):
            rule = "has neither an attitude nor rates: fill it in, or remove the line"
            raise InputError(f"line {number}", ",".join(cells), rule)
        rows.append((number, row))
    kinds: dict[str, type[Observations]] = {"attitudes": Attitudes, "rates": Rates}
    found = {kind: _columns(kind, rows, sigma) for kind in kinds}
    check_sigma([kind for kind, (times, *_) in found.items() if len(times)], sigma)
    return File({kind: [kinds[kind](*x)] for kind, x in found.items() if len(x[0])})


def _check_names(header: list[str]) -> None:
    """Raise InputError for columns that are unknown or given twice."""
    known = ("t", *_COLUMNS["attitudes"], *_COLUMNS["rates"], *_SIGMAS.values())
    for place, name in enumerate(header):
        if name not in known:
            raise InputError("header", name, f"is not one of: {', '.join(known)}")
        if name in header[:place]:
            rule = "is the name of two columns: remove or rename one of them"
            raise InputError("header", name, rule)


def _check_groups(header: list[str]) -> None:
    """Raise InputError for columns that lack others they need."""
    for kind, names in _COLUMNS.items():
        has = [name for name in (*names, _SIGMAS[kind]) if name in header]
        for name in ("t", *names):
            if has and name not in header:
                raise InputError("header", f"no {name}", f"is needed with {', '.join(has)}")


def _columns(
    kind: str, rows: Rows, sigma: Mapping[str, float]
) -> tuple[list[float], list[list[float]], list[float] | float | None]:
    """Times, values and errors of the lines that have values of a kind; all of them or none."""
    names, own = _COLUMNS[kind], _SIGMAS[kind]
    lines = [(k, row) for k, row in rows if any(row.get(name) for name in names)]
    times = [_number(k, row, "t") for k, row in lines]
    values = [[_number(k, row, name) for name in names] for k, row in lines]
    if not lines or own not in lines[0][1]:
        return times, values, sigma.get(kind)
    if kind in sigma:
        rule = f"the file has errors of its own, {own}: give one of the two"
        raise InputError(f"sigma.{kind}", sigma[kind], rule)
    return times, values, [_number(k, row, own) for k, row in lines]


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
    """Raise InputError for errors of kinds that a file does not have, or has errors of."""
    for kind, value in sigma.items():
        if kind not in kinds:
            raise InputError(f"sigma.{kind}", value, rule or f"the file has no {kind}: leave it")


def parse_message(content: str, sigma: Mapping[str, float]) -> File:
    """The states of a CCSDS attitude ephemeris message, in KVN; its times are zero at the first.

    Messages have no errors: sigma gives them.
    """
    found = attitude_messages.read(content)
    kinds = ("attitudes",) if found.rates is None else ("attitudes", "rates")
    check_sigma(kinds, sigma)
    sets: dict[str, list[Observations]] = {
        "attitudes": [Attitudes(found.times, found.q, sigma.get("attitudes"))]
    }
    if found.rates is not None and "rates" in sigma:
        sets["rates"] = [Rates(found.times, found.rates, sigma["rates"])]
    return File(sets, epoch=found.epoch)
