"""Names of the columns of a table of observations, and proposals for columns of other names.

A proposal is text for an option, in an error message.  No column is read without being named.
"""

import csv
import re
import shlex
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from rigidsym.errors import InputError, nearest
from rigidsym.fitting._units import factor


@dataclass(frozen=True, slots=True)
class Form:
    """One form of the values of a kind of observations.

    kind: of the observations. name: of the form. columns: their names. quantity: of their unit, if
    they have one. scale: quantity of the errors. errors: groups of columns that may have these, one
    standard deviation or one for each component.
    """

    kind: str
    name: str
    columns: tuple[str, ...]
    quantity: str
    scale: str
    errors: tuple[tuple[str, ...], ...]


def _split(*texts: str) -> tuple[tuple[str, ...], ...]:
    return tuple(tuple(text.split()) for text in texts)


_Q = _split("sigma_q", "sigma_q1 sigma_q2 sigma_q3")
_OMEGA = _split("sigma_omega", "sigma_omega1 sigma_omega2 sigma_omega3")
_V = _split("sigma_v", "sigma_lon sigma_lat")
_FIRST, _LAST, _ANGLES, _RATES, _VECTORS, _SPHERE = _split(
    "q0 q1 q2 q3", "q1 q2 q3 q4", "angle1 angle2 angle3", "omega1 omega2 omega3", "v1 v2 v3",
    "lon lat",
)  # fmt: skip
FORMS = (
    Form("attitudes", "quaternion", _FIRST, "", "angle", _Q),
    Form("attitudes", "quaternion-scalar-last", _LAST, "", "angle", _Q),
    Form("attitudes", "euler", _ANGLES, "angle", "angle", _Q),
    Form("attitudes", "matrix", tuple(f"r{i}{j}" for i in "123" for j in "123"), "", "angle", _Q),
    Form("rates", "rates", _RATES, "rate", "rate", _OMEGA),
    Form("vectors", "vectors", _VECTORS, "", "angle", _V[:1]),
    Form("vectors", "angles", _SPHERE, "angle", "angle", _V),
)
TIMES = ("t", "t2")
SEQUENCES = tuple("".join(x) for x in product("123", repeat=3) if x[1] not in (x[0], x[2]))
ATTITUDES = ("quaternion", "quaternion-scalar-last", "matrix", *(f"euler{x}" for x in SEQUENCES))
QUANTITIES: dict[str, str] = {
    **dict.fromkeys(TIMES, "time"),
    **{name: form.quantity for form in FORMS for name in form.columns},
    **{name: form.scale for form in FORMS for group in form.errors for name in group},
}
"The quantity of each column by its name, empty where it has no unit."
LISTED = (
    "t (or time), t2, q0 … q3, q1 … q4, angle1 … angle3, r11 … r33, omega1 … omega3, v1 … v3, lon, "
    "lat, and errors: sigma_q, sigma_q1 … sigma_q3, sigma_omega, sigma_omega1 … sigma_omega3, "
    "sigma_v, sigma_lon, sigma_lat"
)
"All names of columns, for messages."
_ALIASES = {"time": "t", "time2": "t2"}

# Other names of columns, in lower case and without blanks, underscores, dots and units.  {k}, {x},
# {i}, {p} and {roll} are the number of the component and the letters by which others call it.
_ERROR = "(sigma|sig|error|err|e|std|unc|d|s)"
_LIKE = {
    "t": r"(time|zeit|utc|tai|gps|date|datetime|timestamp|epoch|m?jd|[bh]jd|seconds?|sec|t)"
    r"(utc|tdb|tt|tai|gps|stamp)?(since\w+)?",
    "q0": r"(q|quat|quaternion)(0|w|s|r|scalar|real)|scalar|w",
    "q": r"(q|quat|quaternion)({x}|{i}|{k})",
    "omega": r"(w|omega|om|gyro?|g|rate|angvel|angularvelocity|angularrate|angrate)({x}|{k})"
    r"|{p}|{roll}rate",
    "v": r"(v|u|n|dir|direction|axis|pole|spin)({x}|{k})",
    "r": r"(r|m|a|c|rot|dcm|rotation|matrix)({row}{column}|{row0}{column0})",
    "lon": r"ra|rightascension|ra2000|raj2000|alpha|lambda|lam|l|lon|longitude|elon|eclon",
    "lat": r"dec|decl|declination|dej2000|delta|beta|bet|b|lat|latitude|elat|eclat",
    "sigma_q": f"{_ERROR}(q|att|attitude|angle|rot|rotation|pointing)|sigma|sig|error|err|std",
    "sigma_omega": f"{_ERROR}(w|omega|rate|rates|gyro)",
    "sigma_v": f"{_ERROR}(v|dir|direction|pole|axis)|sigma|sig|error|err|std",
}
_LIKE |= {f"sigma_{name}": f"{_ERROR}({_LIKE[name]})" for name in ("lon", "lat")}
# Names of Euler angles, by the axis.
_TURNS = {"1": "roll|phi|bank", "2": "pitch|theta|elevation", "3": "yaw|heading|psi|azimuth"}


def pairs(field: str, value: str | Mapping[str, Any] | None) -> dict[str, Any]:
    """Convert "name=value,name=value", where "name" is "name=name", or a mapping to a dictionary.

    Raises InputError.
    """
    if isinstance(value, str):
        parts = (x.partition("=") for x in next(csv.reader([value], skipinitialspace=True), []))
        return {name.strip(): (text if mark else name).strip() for name, mark, text in parts}
    if value is not None and not isinstance(value, Mapping):
        raise InputError(field, repr(value), "must be NAME=VALUE,NAME=VALUE, or a table of these")
    return dict(value or {})


@dataclass(frozen=True, slots=True)
class Column:
    """A column of a file: its place, title, name and unit.

    name: the title without a unit in brackets. unit: the text in brackets. hint: a unit at the end
    of the name, as in time_ms, which is only proposed.
    """

    place: int
    title: str
    name: str
    unit: str
    hint: str

    @classmethod
    def of(cls, place: int, title: str) -> "Column":
        """Split the title of a column into its name and its unit."""
        found = re.fullmatch(r"(.+?)\s*[\[(]\s*(.*?)\s*[\])]\s*", title)
        name, unit = (found[1], found[2]) if found else (title, "")
        ending = re.fullmatch(r"(.+?)[_ ]([^\W\d_]+(?:(?:/|_per_|_)[^\W\d_]+)?)", name)
        hint = re.sub("_per_|_", "/", ending[2]) if ending else ""
        known = any(factor(x, hint) for x in ("time", "angle", "rate"))
        return cls(place, title, name, unit, hint if known else "")

    @property
    def plain(self) -> str:
        """Return the name in lower case, without its unit, blanks and punctuation."""
        stem = self.name[: -len(self.hint) - 1] if self.hint else self.name
        return re.sub(r"[\s_.\-]", "", stem).lower()


def named(
    listed: Sequence[Column], columns: Mapping[str, Any], sample: Sequence[str], attitude: str
) -> dict[str, Column]:
    """Return the columns of a file by their names in QUANTITIES.

    listed: all columns. columns: the user's names of columns, by name; "#3" is the third. sample:
    the first line of data. attitude: its form.  Raises InputError, with a proposal.
    """
    found: dict[str, Column] = {}
    for given, title in columns.items():
        name = _ALIASES.get(given, given)
        if name not in QUANTITIES:
            near = nearest(name, QUANTITIES)
            step = f"did you mean {near}?" if near else ""
            raise InputError("columns", given, f"is not one of: {LISTED}", next_step=step)
        one = _chosen(listed, f"columns.{given}", str(title))
        twice = next((x for x, other in found.items() if other.place == one.place), "sigma")
        if not (name.startswith("sigma") or twice.startswith("sigma")):
            rule = f"is the column of {twice}, too: give each its own"
            raise InputError(f"columns.{given}", title, rule)
        found[name] = one
    used = {one.place for one in found.values()}
    for one in listed:
        if one.place in used or not one.title:
            continue
        name = _ALIASES.get(one.name, one.name)
        if name not in QUANTITIES:
            if not columns:
                _refuse(one, listed, sample, attitude)
        elif name not in found:
            found[name] = one
        elif not columns:
            rule = "is the name of two columns: remove or rename one of them, or take one by its "
            rule += f"place: --columns {name}=#{one.place + 1}"
            raise InputError("header", name, rule)
    return found


def _chosen(listed: Sequence[Column], field: str, title: str) -> Column:
    """Return the column that a user names by its title, its name without a unit, or its place."""
    place = re.fullmatch(r"#(\d+)", title)
    if place and 1 <= int(place[1]) <= len(listed):
        return listed[int(place[1]) - 1]
    same = [x for x in listed if x.title == title] or [x for x in listed if x.name == title]
    if len(same) == 1:
        return same[0]
    if same:
        places = " or ".join(f"#{x.place + 1}" for x in same)
        raise InputError(field, title, f"is the name of {len(same)} columns: take {places}")
    names = [x.name for x in listed]
    near = nearest(title, names)
    step = f"did you mean {near}?" if near else ""
    rule = f"is no column of the file, which has {', '.join(names)}"
    raise InputError(field, title, rule, next_step=step)


def _refuse(one: Column, listed: Sequence[Column], sample: Sequence[str], attitude: str) -> None:
    """Raise InputError about a column without a known name, with the options to add."""
    like, options = proposal(listed, sample, attitude)
    mine = next((name for name, x in like.items() if x is one), "")
    names = ",".join(name for name, x in like.items() if x.name == name)
    rule = f"is not one of: {LISTED}"
    if one.title.startswith("#"):
        rule = "is a column of a file without names: "
        rule += "name it by its place, as --columns t=#1,q0=#2,q1=#3,q2=#4,q3=#5"
    elif mine and options:
        rule = f"looks like {mine}: add {options}"
    elif options:
        rule = f"is not one of those that are read: add {options}"
    elif names:
        rule += f"; to leave it out, add --columns {names}"
    raise InputError("header", one.title, rule)


def proposal(
    listed: Sequence[Column], sample: Sequence[str], attitude: str
) -> tuple[dict[str, Column], str]:
    """Return the columns that look like known ones, by name, and the options that read them.

    The options are empty where all of them have the names expected.
    """
    found: dict[str, Column] = {}
    options: list[str] = []
    time = next((x for x in listed if re.fullmatch(_LIKE["t"], x.plain)), None)
    if time:
        found["t"] = time
    kinds: set[str] = set()
    units = {"time": time.hint} if time and time.hint not in ("", "s") else {}
    for form in FORMS:
        like = _matched(form, listed, attitude, found.values())
        if like is None or form.kind in kinds:
            continue
        kinds.add(form.kind)
        found |= like
        for one in like.values():
            if form.quantity and not one.unit and (one.hint or form.quantity == "angle"):
                units[form.quantity] = one.hint or "deg"
        if form.kind == "attitudes" and not attitude.startswith(form.name):
            options.append(f"--attitude {form.name}{'321' * (form.name == 'euler')}")
        elif form.kind == "vectors":
            options.append("--axis spin")
        for group in form.errors:
            errors = _match(
                dict(zip(group, map(_shape, group), strict=True)), listed, found.values()
            )
            if errors:
                found |= errors
                break
    if not kinds or all(x.name == name for name, x in found.items()):
        return found, ""
    text = ",".join(name if x.name == name else f"{name}={x.name}" for name, x in found.items())
    options.insert(0, f"--columns {shlex.quote(text)}")
    if time:
        layout = time_layout(time, sample[time.place] if time.place < len(sample) else "")
        options += [f"--time-format {layout}"] if layout else []
    if units:
        options.append("--units " + ",".join(f"{name}={unit}" for name, unit in units.items()))
    return found, " ".join(options)


def time_layout(column: Column, cell: str) -> str:
    """Return the format that a column of times looks like, or an empty text."""
    if re.match(r"\d{4}-\d\d", cell):
        return "iso"
    name = re.match(r"mjd|[bh]?jd|unix|posix", column.plain)
    return {"mjd": "mjd", "unix": "unix", "posix": "unix"}.get(name[0], "jd") if name else ""


def _matched(
    form: Form, listed: Sequence[Column], attitude: str, taken: Iterable[Column]
) -> dict[str, Column] | None:
    """Return the columns that look like all of a form, by name, or None."""
    shapes = [_shape(name) for name in form.columns]
    if form.name == "quaternion-scalar-last":
        shapes[-1] = "(q|quat|quaternion)4" + (f"|{_LIKE['q0']}" if attitude == form.name else "")
    if form.name == "euler":
        axes = attitude.removeprefix("euler") if attitude.startswith("euler") else "321"
        if len(set(axes)) < 3:
            return None
        shapes = [_TURNS[axis] for axis in axes]
    return _match(dict(zip(form.columns, shapes, strict=True)), listed, taken)


def _shape(name: str) -> str:
    """Return the regular expression of other names of a column."""
    stem, digits = name.rstrip("0123456789"), name[len(name.rstrip("0123456789")) :]
    if name in _LIKE or stem not in _LIKE:
        return _LIKE.get(name, re.escape(name))
    first, last = int(digits[0]) - 1, int(digits[-1])
    shape = _LIKE[stem] if "{" in _LIKE[stem] else f"({_LIKE[stem]})({{x}}|{{k}})"
    letters = {"x": "xyz", "k": "123", "i": "ijk", "p": "pqr", "row": "123", "row0": "012"}
    for key, each in letters.items():
        shape = shape.replace(f"{{{key}}}", each[first] if first < len(each) else "")
    shape = shape.replace("{roll}", ("roll", "pitch", "yaw")[min(first, 2)])
    return shape.replace("{column}", str(last)).replace("{column0}", str(last - 1))


def _match(
    shapes: Mapping[str, str], listed: Sequence[Column], taken: Iterable[Column]
) -> dict[str, Column] | None:
    """Return the columns of given names or shapes, by name; None unless each has one."""
    found: dict[str, Column] = {}
    for name, shape in shapes.items():
        free = [x for x in listed if x not in [*taken, *found.values()]]
        same = [x for x in free if x.name == name]
        same = same or [x for x in free if re.fullmatch(shape, x.plain)]
        if len(same) != 1:
            return None
        found[name] = same[0]
    return found
