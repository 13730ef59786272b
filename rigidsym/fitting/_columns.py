"""Observations from a table of text, read as a layout describes it.

The names of columns are in `_names`, units in `_units`, and options in `_layout`.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from decimal import Decimal
from itertools import pairwise
from typing import Any

import numpy as np

from rigidsym import _inputs as inputs
from rigidsym.errors import InputError
from rigidsym.fitting._conventions import covariances, directions, quaternions
from rigidsym.fitting._layout import ALLOWED, DIRECTIONS, FIRST, Layout
from rigidsym.fitting._names import FORMS, QUANTITIES, Column, Form, named, proposal, time_layout
from rigidsym.fitting._observations import KINDS, SPIN, Directions, Observations
from rigidsym.fitting._units import DEFAULTS, converted, factor, names, needed
from rigidsym.io import _delimited as delimited
from rigidsym.io import _epochs as epochs
from rigidsym.quaternions import conjugate

_MISSING = ("", "nan", "na", "n/a", "null", "none", "-", "--")
_LARGEST = 1e100
_WORDS = {"attitudes": "attitude", "rates": "rates", "vectors": "direction"}
# Quantities of columns that must have a unit: there is no usual one.
_STATED = ("angle1", "angle2", "angle3", "lon", "lat")


@dataclass(frozen=True, slots=True)
class Read:
    """What a table has: observations by kind, the epoch of t = 0, and notes on what was left."""

    observations: Mapping[str, list[Observations]]
    epoch: str | None
    notes: tuple[str, ...]


def read(content: str, layout: Layout) -> Read:
    """Read observations from the text of a table.

    Raises InputError about the first mistake, with the option that would read it.
    """
    table = delimited.parse(content, layout.delimiter, layout.header_line, layout.data_line)
    if table.title and not layout.names:
        rule = "is a column of a file without names: if the comment in line "
        rule += f"{table.title} has them, add --header-line {table.title}"
        raise InputError("header", "#1", rule)
    listed = [Column.of(k, title) for k, title in enumerate(table.header)]
    sample = table.rows[0][1] if table.rows else ()
    columns = named(listed, layout.names, sample, layout.attitude)
    forms = _forms(columns, listed, sample, layout.attitude)
    rows = _Rows(layout, columns, table)
    chosen = rows.telling(forms)
    times, epoch = rows.times(sorted({line for lines in chosen.values() for line in lines}))
    found = {}
    for form in forms:
        lines = rows.ordered(chosen[form.kind], times)
        if lines:
            t = np.array([times[line] for line in lines])
            found[form.kind] = [rows.observations(form, lines, t)]
    if not found:
        raise InputError("observations", "the file", "has no lines of data")
    check_sigma([*found], layout.errors)
    if layout.axis is not None and "vectors" not in found:
        raise InputError("axis", layout.axis, "the file has no directions: leave it")
    used = {one.place for one in columns.values()}
    rest = [one.title for one in listed if one.place not in used and one.title]
    left = [f"{count} {name}" for name, count in rows.changed.items() if count]
    notes = [f"columns not read: {', '.join(rest)}"] * bool(rest)
    notes += [f"lines left out or moved: {', '.join(left)}"] * bool(left)
    return Read(found, epoch, tuple(notes))


def check_sigma(kinds: Collection[str], sigma: Mapping[str, Any], rule: str = "") -> None:
    """Raise InputError if errors are given for kinds of observations that do not need them."""
    for kind, value in sigma.items():
        if kind not in kinds:
            raise InputError(f"sigma.{kind}", value, rule or f"the file has no {kind}: leave it")


def _forms(
    columns: Mapping[str, Column], listed: Sequence[Column], sample: Sequence[str], attitude: str
) -> list[Form]:
    """Return the forms of the observations in a file, one for each kind.

    Raises InputError if there are none, or if columns of one are missing.
    """
    chosen: dict[str, Form] = {}
    for form in FORMS:
        own = form.kind != "attitudes" or form.name == attitude.rstrip("123")
        if own and set(form.columns) <= {*columns}:
            chosen.setdefault(form.kind, form)
    like, options = proposal(listed, sample, attitude)
    for form in FORMS:
        if form.kind in chosen:
            continue
        if set(form.columns) <= {*columns}:
            name = "euler321, or another sequence" if form.name == "euler" else form.name
            rule = f"the file has {', '.join(form.columns)}: add --attitude {name}"
            raise InputError("attitude", attitude, rule)
        has = [x for group in (form.columns, *form.errors) for x in group if x in columns]
        for name in form.columns:
            if has and name not in columns:
                rule = f"is needed with {', '.join(has)}"
                if form.name == "quaternion" and "q4" in columns:
                    rule += "; if q4 is the scalar, add --attitude quaternion-scalar-last; if q1"
                    rule += " is, add --columns q0=q1,q1=q2,q2=q3,q3=q4"
                elif options and name in like:
                    rule += f"; {like[name].name!r} looks like it: add {options}"
                raise InputError("header", f"no {name}", rule)
    if not chosen:
        options = options or "--columns time=NAME,q0=NAME,…"
        rule = f"has no observations: name their columns, as by {options}"
        raise InputError("header", ", ".join(one.title for one in listed), rule)
    if "t" not in columns:
        rule = f"is needed with {', '.join(x for x in columns if x != 't2')}"
        rule += (
            f"; {like['t'].name!r} looks like it: add {options}" if options and "t" in like else ""
        )
        raise InputError("header", "no t", rule)
    return [*chosen.values()]


class _Rows:
    """The lines of a table by their numbers, and the numbers of lines left out or moved."""

    def __init__(
        self, layout: Layout, columns: Mapping[str, Column], table: delimited.Delimited
    ) -> None:
        self.layout, self.columns = layout, columns
        self.changed = dict.fromkeys(ALLOWED, 0)
        self.texts = dict(table.rows)
        self.cells = {
            line: {name: cells[one.place] for name, one in columns.items()}
            for line, cells in table.rows
        }

    def telling(self, forms: Sequence[Form]) -> dict[str, list[int]]:
        """Return the lines that have observations of each kind.

        A line has all numbers of a kind or none; those with some are left out if that is allowed.
        """
        lenient = "missing" in self.layout.allowed
        found: dict[str, list[int]] = {form.kind: [] for form in forms}
        for line, row in self.cells.items():
            begun = [form for form in forms if any(row[name] for name in form.columns)]
            if not begun and not lenient:
                has = " nor ".join(_WORDS[form.kind] for form in forms)
                rule = f"has {'neither' if len(forms) > 1 else 'no'} {has}: fill it in, remove the "
                rule += "line, or add --allow missing to leave it out"
                raise InputError(f"line {line}", ",".join(self.texts[line]), rule)
            lost = not begun
            for form in begun:
                lacks = [x for x in (*self._read(form), "t") if row[x].lower() in _MISSING]
                if lacks and not lenient:
                    self._refuse(line, lacks[0])
                lost |= bool(lacks)
                found[form.kind] += [] if lacks else [line]
            self.changed["missing"] += lost
        return found

    def times(self, lines: Sequence[int]) -> tuple[dict[int, float], str | None]:
        """Return the times of lines, in s, and the epoch of their zero, if they have one."""
        if not lines:
            return {}, None
        column, zero = self.columns["t"], self.layout.epoch
        looks = time_layout(column, self.cells[lines[0]]["t"])
        how = self.layout.time_format or ("" if looks else "seconds")
        if not how:
            rule = f"looks like a time of another format: add --time-format {looks}"
            cell = repr(self.cells[lines[0]]["t"])
            raise InputError(f"line {lines[0]}, {self._label('t')}", cell, rule)
        if how == "seconds":
            if zero not in (None, FIRST):
                rule = "is for times that are dates: add --time-format iso, jd, mjd or unix"
                raise InputError("epoch", zero, rule)
            unit = self._unit("t")
            ticks = {k: converted(self._time(k), unit) for k in lines}
            begin = min(ticks.values()) if zero == FIRST else 0
            return {k: float(x - begin) for k, x in ticks.items()}, None
        instants = {}
        for k in lines:
            text = f"{self.cells[k]['t']} {self.cells[k].get('t2', '')}".strip()
            number = None if how == "iso" else self._time(k)
            instants[k] = epochs.instant(f"line {k}, {self._label('t')}", text, how, number)
        system = "UTC" if how == "iso" else "TAI"
        if zero in (None, FIRST):
            start = min(instants.values())
            zero = epochs.printed(start, system, epochs.decimals([start]))
        else:
            start = epochs.parse("epoch", str(zero).removesuffix("Z"), system)
        return {k: (x - start) / epochs.SECOND for k, x in instants.items()}, zero

    def ordered(self, lines: list[int], times: Mapping[int, float]) -> list[int]:
        """Return lines in the order of their times, each time once.

        Raises InputError unless it is allowed to sort them, or to leave some out.
        """
        allowed = self.layout.allowed
        for before, line in pairwise(lines):
            if times[line] < times[before] and "unsorted" not in allowed:
                rule = (
                    f"is before the time of line {before}: sort the lines, or add --allow unsorted"
                )
                self._refuse(line, "t", rule)
        kept: list[int] = []
        for line in sorted(lines, key=lambda line: times[line]):
            if kept and times[line] == times[kept[-1]]:
                if "repeated" not in allowed:
                    rule = (
                        f"is the time of line {kept[-1]}, too: remove one of them, or add --allow "
                    )
                    self._refuse(line, "t", f"{rule}repeated to keep the first")
                self.changed["repeated"] += 1
            else:
                kept.append(line)
        self.changed["unsorted"] += sum(b < a for a, b in pairwise(kept))
        return kept

    def observations(self, form: Form, lines: list[int], t: np.ndarray) -> Observations:
        """Return the observations of a form in lines with times t (N,)."""
        columns = self._read(form)
        units = {name: self._unit(name) for name in columns}
        whole = np.array(
            [[float(converted(self._number(k, x), units[x])) for x in columns] for k in lines]
        )
        values, spread = np.split(whole, [len(form.columns)], axis=1)
        errors = columns[len(form.columns) :]
        for k, j in np.argwhere(spread <= 0)[:1]:
            self._refuse(lines[k], errors[j], "a standard deviation must be positive")
        sigma: Any = self._sigma(form, errors)
        if form.kind == "vectors":
            return self._directions(form, lines, t, values, spread if errors else sigma)
        if errors:
            sigma = spread[:, 0] if len(errors) == 1 else spread[:, :, None] ** 2 * np.eye(3)
        if form.kind == "attitudes":
            values = quaternions(self.layout.attitude, values, lines)
            values = values if self.layout.direction == DIRECTIONS[0] else conjugate(values)
        return KINDS[form.kind](t, values, sigma)

    def _directions(
        self, form: Form, lines: list[int], t: np.ndarray, values: np.ndarray, sigma: Any
    ) -> Observations:
        """Return directions in space of an axis of the body, or of the axis of rotation."""
        axis = self.layout.axis
        if axis is None:
            rule = (
                "add --axis spin if the directions are those of the axis of rotation, or, for an "
            )
            rule += "axis of the body, its components, as --axis 0,0,1"
            raise InputError("axis", "missing", rule)
        if isinstance(axis, str) and axis != SPIN:
            if axis.count(",") != 2:
                raise InputError("axis", repr(axis), "must be spin, or three numbers, as 0,0,1")
            axis = [float(inputs.exact(f"axis[{k}]", x)) for k, x in enumerate(axis.split(","))]
            if not any(axis):
                raise InputError("axis", self.layout.axis, "must not be zero")
        if form.name == "angles":
            for k in np.flatnonzero(np.abs(values[:, 1]) > np.pi / 2 * (1 + 1e-12))[:1]:
                self._refuse(lines[k], "lat", "is beyond the pole: check --columns and --units")
            if np.ndim(sigma) == 2 and np.shape(sigma)[1] == 2:
                sigma = covariances(*values.T, sigma)
            values = directions(*values.T)
        return Directions(t, values, sigma[:, 0] if np.ndim(sigma) == 2 else sigma, axis, "space")

    def _read(self, form: Form) -> tuple[str, ...]:
        """Return the columns of a form, and those of its errors, if it has some."""
        for group in form.errors:
            has = [name for name in group if name in self.columns]
            for name in group:
                if has and name not in self.columns:
                    raise InputError("header", f"no {name}", f"is needed with {', '.join(has)}")
            if has:
                return (*form.columns, *group)
        return form.columns

    def _sigma(self, form: Form, errors: Sequence[str]) -> Any:
        """Return the user's errors of a form; raise InputError if it has none, or two of them."""
        given = self.layout.errors.get(form.kind)
        if errors and given is not None:
            rule = f"the file has errors of its own, {', '.join(errors)}: give one of the two"
            raise InputError(f"sigma.{form.kind}", given, rule)
        if not errors and given is None:
            like = "0.1deg/s" if form.scale == "rate" else "0.1deg"
            rule = f"a standard deviation is needed: add --sigma {form.kind}={like}, or, if a "
            rule += f"column has it, --columns {form.errors[0][0]}=NAME"
            raise InputError(f"sigma.{form.kind}", "missing", rule)
        return given

    def _unit(self, name: str) -> Decimal:
        """Return the factor of the unit of a column: by an option, its header, or by default."""
        quantity, column, units = QUANTITIES[name], self.columns[name], self.layout.factors
        if not quantity:
            return Decimal(1)
        asked = units.get(name) or units.get(quantity)
        if asked:
            return needed(f"units.{name}", quantity, asked)
        if column.unit:
            found = factor(quantity, column.unit)
            if found is None:
                rule = f"has no unit of {quantity}: add --units {name}=UNIT; {names(quantity)}"
                raise InputError("header", column.title, rule)
            return found
        if column.hint not in ("", DEFAULTS[quantity]):
            proposed = f"{quantity}={column.hint}" if factor(quantity, column.hint) else ""
            rule = f"looks like another unit: add --units {proposed or f'{name}=UNIT'}"
            raise InputError("header", column.title, rule)
        stated = any(one.unit for x, one in self.columns.items() if QUANTITIES[x] == quantity)
        foreign = quantity != "time" and column.name != name
        if stated or foreign or name in _STATED:
            what = name if stated else quantity
            like = {"angle": "deg", "rate": "deg/s", "time": "ms"}[quantity]
            rule = f"{column.title} has none: add --units {what}={like} or {what}="
            raise InputError(f"units.{what}", "missing", f"{rule}{DEFAULTS[quantity]}")
        return Decimal(1)

    def _time(self, line: int) -> Decimal:
        """Return the number of a time, the exact sum of its columns."""
        whole = self._number(line, "t")
        return whole + self._number(line, "t2") if "t2" in self.columns else whole

    def _number(self, line: int, name: str) -> Decimal:
        cell = self.cells[line][name].replace("\u2212", "-")
        if self.layout.decimal == "," and "." not in cell:
            cell = cell.replace(",", ".")
        if not delimited.NUMBER.fullmatch(cell):
            self._refuse(line, name)
        cell = cell.upper().replace("D", "E")
        size = abs(float(cell))
        if size > _LARGEST:
            self._refuse(line, name, f"must be at most {_LARGEST:g}")
        # Decimals have fewer exponents than texts.
        return Decimal(cell) if size else Decimal(0)

    def _label(self, name: str) -> str:
        title = self.columns[name].name
        return name if title == name else f"{name} ({title})"

    def _refuse(self, line: int, name: str, rule: str = "") -> None:
        """Raise InputError about a cell; by default about one that is not a number."""
        row = self.cells[line]
        cell = row[name]
        if not rule:
            rule = f"must be a number where the line has {', '.join(x for x in row if row[x])}"
            if cell.lower() in _MISSING:
                rule += "; add --allow missing to leave out such lines"
            elif delimited.NUMBER.fullmatch(cell.replace(",", ".", 1)):
                mark = "," if self.layout.decimal == "." else "."
                rule += f"; add --decimal {mark} if that is the decimal mark"
        raise InputError(f"line {line}, {self._label(name)}", repr(cell), rule)
