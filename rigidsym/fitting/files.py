"""Files of observations: TOML for all kinds, CSV for attitudes and rates, CCSDS messages."""

import csv
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
from rigidsym.fitting.published import TOUTATIS_EPOCH, text, toutatis, without_comments
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
    if name == "toutatis":
        looks = toutatis()
        seen = Attitudes(looks.times, looks.q, looks.sigma)
        return File({"attitudes": [seen]}, epoch=TOUTATIS_EPOCH)
    if name == "t-handle":
        return parse_csv(text("t-handle.csv"), given)
    path = Path(name)
    ending = path.suffix.lower()
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
    """Columns t, q0 ... q3, omega1 ... omega3, and errors sigma_q, sigma_omega; cells may be empty.

    In s, rad and rad/s.  sigma: of what has no column of errors.
    """
    rows = list(csv.DictReader(without_comments(content), skipinitialspace=True))
    header = list(rows[0]) if rows else []
    known = ("t", *_COLUMNS["attitudes"], *_COLUMNS["rates"], *_SIGMAS.values())
    for name in header:
        if name is None:
            raise InputError("header", f"{len(header) - 1} columns", "a line has more cells")
        if name not in known:
            raise InputError("header", name, f"is not one of: {', '.join(known)}")
    found = {
        kind: _columns(kind, rows, sigma)
        for kind, names in _COLUMNS.items()
        if _has(header, ("t", *names), names)
    }
    kinds: dict[str, type[Observations]] = {"attitudes": Attitudes, "rates": Rates}
    sets: dict[str, list[Observations]] = {
        kind: [kinds[kind](times, values, errors)]
        for kind, (times, values, errors) in found.items()
        if len(times)
    }
    return File(sets)


def _has(header: list[str], needed: Collection[str], names: Collection[str]) -> bool:
    """Whether a table has some columns; raises InputError where it has a part of them."""
    if not any(name in header for name in names):
        return False
    for name in needed:
        if name not in header:
            raise InputError("header", f"no {name}", f"is needed with {', '.join(names)}")
    return True


def _columns(
    kind: str, rows: list[dict[str, str]], sigma: Mapping[str, float]
) -> tuple[np.ndarray, np.ndarray, np.ndarray | float | None]:
    """Times, values and errors of the rows that have values of a kind."""
    names, own = _COLUMNS[kind], _SIGMAS[kind]
    lines = [(k, row) for k, row in enumerate(rows, 2) if (row.get(names[0]) or "").strip()]
    times = np.array([_number(k, row, "t") for k, row in lines])
    values = np.array([[_number(k, row, name) for name in names] for k, row in lines])
    if rows and own in rows[0]:
        return times, values, np.array([_number(k, row, own) for k, row in lines])
    return times, values, sigma.get(kind)


def _number(line: int, row: Mapping[str, str], name: str) -> float:
    cell = row.get(name)
    try:
        return float(cell or "")
    except ValueError:
        raise InputError(f"line {line}, {name}", repr(cell), "must be a number") from None


def parse_message(content: str, sigma: Mapping[str, float]) -> File:
    """The states of a CCSDS attitude ephemeris message, in KVN; its times are zero at the first.

    Messages have no errors: sigma gives them.
    """
    found = attitude_messages.read(content)
    sets: dict[str, list[Observations]] = {
        "attitudes": [Attitudes(found.times, found.q, sigma.get("attitudes"))]
    }
    if found.rates is not None and "rates" in sigma:
        sets["rates"] = [Rates(found.times, found.rates, sigma["rates"])]
    return File(sets, epoch=found.epoch)
