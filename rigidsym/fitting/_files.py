"""Readers of observations in tables of text, TOML and CCSDS files."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _inputs as inputs
from rigidsym._engines import batches
from rigidsym.errors import InputError
from rigidsym.fitting._columns import Layout, check_sigma, read
from rigidsym.fitting._observations import KINDS, Attitudes, Observations, Rates
from rigidsym.fitting._published import TOUTATIS_EPOCH, text, toutatis
from rigidsym.io import _attitude_ephemeris as attitude_ephemeris
from rigidsym.io import _epochs as epochs
from rigidsym.io import _files as files

DAY = 86400.0
OWN = ("toutatis", "t-handle")
"Names of the observations that come with the package."
TABLES = (".csv", ".tsv", ".txt", ".dat")
"Endings of tables of text."
_OPTIONS = (
    *("inertia", "moments", "moments_sigma", "scale", "loss", "starts", "fastest"),
    "delta_chi2",
)
_TABLES = {name: kind for name, kind in KINDS.items() if kind.keys}
_LAYOUT = tuple(one.name for one in fields(Layout) if one.init)


@dataclass(frozen=True, slots=True)
class ObservationFile:
    """The content of an observation file.

    It has the observations by kind, the options of the fit, the epoch of t = 0, and notes on what
    was not read.  is_table: whether it was a table of text.
    """

    observations: Mapping[str, list[Observations]]
    options: Mapping[str, Any] = field(default_factory=dict)
    epoch: str | None = None
    notes: tuple[str, ...] = ()
    is_table: bool = False

    def arguments(self) -> dict[str, Any]:
        """Return the content of the file as keyword arguments of `rigidsym.fit`."""
        return {**self.observations, **self.options}


def load(
    name: str | Path,
    *,
    columns: str | Mapping[str, str] | None = None,
    units: str | Mapping[str, str] | None = None,
    sigma: str | Mapping[str, float | str] | None = None,
    time_format: str | None = None,
    epoch: str | None = None,
    attitude: str = "quaternion",
    direction: str = "body-to-inertial",
    axis: str | ArrayLike | None = None,
    allow: str | Sequence[str] = (),
    delimiter: str = ",",
    decimal: str = ".",
    header_line: int | None = None,
    data_line: int = 1,
    encoding: str = "utf-8",
) -> ObservationFile:
    """Load observations from a file, or from the package.

    The suffix tells the format of a file: .csv, .tsv, .txt and .dat are tables of text, .toml and
    .aem the formats of this package and of CCSDS.  Only `sigma` is for messages, too; the others
    describe tables, also as keys of `[[files]]` in TOML.

    Parameters
    ----------
    name : str or Path
        A path, "toutatis" or "t-handle".
    columns : str or mapping
        The file's names of columns, as "time=UTC,q0=qs": t (or time), t2 (added to t); q0 ... q3;
        q1 ... q4; angle1 ... angle3; r11 ... r33; omega1 ... omega3; v1 ... v3; lon, lat; errors
        sigma_q, sigma_q1 ... sigma_q3, sigma_omega, sigma_omega1 ... sigma_omega3, sigma_v,
        sigma_lon, sigma_lat.  A name ends before a unit in brackets; "#3" is the third column.
        Columns with these names need not be listed.
    units : str or mapping
        Units by quantity or column, as "time=ms,rate=deg/s,angle=deg,sigma_q=arcsec"; those in
        brackets in the header by default, and then s, rad and rad/s.  Angles need a unit, and so do
        rates and errors in columns of other names.
    sigma : str or mapping
        Errors by kind, as "attitudes=0.1deg,rates=0.01deg/s"; numbers are in rad and rad/s.
    time_format : {"seconds", "iso", "jd", "mjd", "unix"}
        Format of times; numbers in the unit of the time by default.
    epoch : str
        The epoch of t = 0 in UTC, or "first"; by default the first time for all formats but
        seconds.
    attitude : {"quaternion", "quaternion-scalar-last", "matrix", "euler321", ...}
        Form of attitudes; Euler angles are R = R_3(angle1) R_2(angle2) R_1(angle3), and so on for
        all twelve sequences.
    direction : {"body-to-inertial", "inertial-to-body"}
        Axes that the attitudes rotate from and to.
    axis : "spin" or (3,)
        Axis of the body that directions v or lon, lat show in space; "spin" is that of rotation.
    allow : str or list of {"missing", "unsorted", "repeated"}
        Leave out lines with missing numbers; sort lines; keep the first line of each time.
    delimiter, decimal : str
        Delimiter, one character, "tab" or "space"; decimal mark, "." or ",".
    header_line, data_line : int
        Number of the line of names, which may be a comment, and of the first that may have data.
    encoding : str
        Encoding of the text, such as "cp1252".

    Returns
    -------
    ObservationFile
        Its `arguments()` are those of `rigidsym.fit`.

    Raises
    ------
    InputError
        For the first mistake in the file, with the option that would read it.
    """
    given = locals()
    layout = Layout(**{key: given[key] for key in _LAYOUT})
    path = Path(name)
    ending = path.suffix.lower()
    if ending not in TABLES:
        for key in _LAYOUT:
            if key != "sigma" and getattr(layout, key) != getattr(Layout(), key):
                rule = f"describes tables ({', '.join(TABLES)}); {name} is none: leave it"
                raise InputError(key, given[key], rule)
    if str(name) == "toutatis" or ending == ".toml":
        check_sigma((), layout.errors, f"{name} has errors of its own: leave it")
    if str(name) == "toutatis":
        radar = toutatis()
        seen: list[Observations] = [Attitudes(radar.times, radar.q, radar.sigma)]
        return ObservationFile({"attitudes": seen}, epoch=TOUTATIS_EPOCH)
    if str(name) == "t-handle":
        return parse_table(text("t-handle.csv"), layout)
    if ending not in (*TABLES, ".toml", ".aem"):
        rule = f"must end in {', '.join(TABLES)}, .toml or .aem, or be one of: {', '.join(OWN)}"
        raise InputError("observations", name, rule)
    step = "add --encoding cp1252, utf-16 or another" if ending in TABLES else ""
    content = files.read_text("observations", path, encoding, step)
    if ending == ".toml":
        return parse_toml(content, path.parent)
    return parse_table(content, layout) if ending in TABLES else parse_message(content, layout)


def parse_table(content: str, layout: Layout | None = None) -> ObservationFile:
    """Parse observations in a table of text."""
    found = read(content, layout or Layout())
    return ObservationFile(found.observations, {}, found.epoch, found.notes, True)


def parse_toml(content: str, folder: Path | None = None) -> ObservationFile:
    """Parse observations and fit options in TOML.

    Observations are in the tables [[attitudes]], [[rates]] and [[vectors]], and in text files that
    [[files]] name; these lie in the folder of the TOML file.

    With `degrees`, rates, angles and their errors are in degrees; with `days`, times are in days
    and rates per day.  Times are numbers, or epochs if `epoch` gives the epoch of t = 0.
    """
    data = files.parse_toml("observations", content)
    files.check_keys(
        "observations", data, (*_OPTIONS, "epoch", "days", "degrees", "files", *_TABLES)
    )
    second = DAY if inputs.is_true("days", data.get("days", False)) else 1.0
    angle = np.pi / 180 if inputs.is_true("degrees", data.get("degrees", False)) else 1.0
    units = {"rad": angle, "rad/s": angle / second}
    epoch = data.get("epoch")
    found: dict[str, list[Observations]] = {}
    for name, kind in _TABLES.items():
        for k, table in enumerate(_tables(data, name)):
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
    notes: list[str] = []
    for k, table in enumerate(_tables(data, "files")):
        files.check_keys(f"files[{k}]", table, ("file", *_LAYOUT), ("file",))
        how = {key: value for key, value in table.items() if key != "file"}
        path = (folder or Path()) / str(table["file"])
        if path.suffix.lower() == ".toml":
            raise InputError(f"files[{k}].file", table["file"], "must not be TOML itself")
        if epoch and how.get("time_format", "seconds") != "seconds":
            how = {"epoch": epoch, **how}
        one = load(path, **how)  # ty: ignore[invalid-argument-type]
        epoch = epoch or one.epoch
        notes += [f"{table['file']}: {note}" for note in one.notes]
        for kind, sets in one.observations.items():
            found.setdefault(kind, []).extend(sets)
    return ObservationFile(found, options, epoch, tuple(notes))


def _tables(data: Mapping[str, Any], name: str) -> list[Mapping[str, Any]]:
    """Return the tables of a name; raise InputError if they are something else."""
    tables = data.get(name, [])
    if not isinstance(tables, list) or not all(isinstance(x, Mapping) for x in tables):
        raise InputError(name, type(tables).__name__, f"must be tables [[{name}]]")
    return tables


def _times(where: str, values: Any, epoch: str | None, second: float) -> np.ndarray:
    """Convert times to seconds from numbers or epochs."""
    if not isinstance(values, list) or not any(isinstance(x, str) for x in values):
        return batches.array(f"{where}.times", values) * second
    if epoch is None:
        raise InputError("epoch", "missing", f"{where}.times are epochs: say when they are 0")
    zero = epochs.parse("epoch", epoch, "UTC")
    ticks = [epochs.parse(f"{where}.times[{k}]", x, "UTC") for k, x in enumerate(values)]
    return np.array([(tick - zero) / epochs.SECOND for tick in ticks])


def parse_message(content: str, layout: Layout | None = None) -> ObservationFile:
    """Parse observations in a CCSDS attitude ephemeris message in KVN.

    Times are zero at the first state.  The layout has the errors, which messages do not have.
    """
    sigma = layout.errors if layout else {}
    found = attitude_ephemeris.read(content)
    kinds = ("attitudes",) if found.rates is None else ("attitudes", "rates")
    check_sigma(kinds, sigma)
    sets: dict[str, list[Observations]] = {
        "attitudes": [Attitudes(found.times, found.q, sigma.get("attitudes"))]
    }
    if found.rates is not None and "rates" in sigma:
        sets["rates"] = [Rates(found.times, found.rates, sigma["rates"])]
    return ObservationFile(sets, epoch=found.epoch)
