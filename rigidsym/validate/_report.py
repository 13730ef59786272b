"""Validation reports as data, as Markdown and as tables for terminals."""

import json
import re
import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from rigidsym.errors import unknown
from rigidsym.validate._bounds import (
    BOUNDS,
    CONDITIONED,
    HEADS,
    MEANINGS,
    MEASURES,
    ULP,
    bounds_of,
)
from rigidsym.validate._campaign import DISAGREEMENT, ORACLES, Campaign
from rigidsym.validate._finding import Finding, file_name, hexadecimal
from rigidsym.validate._implementations import PEER
from rigidsym.validate._measure import Errors
from rigidsym.validate._oracle import AGREEMENT
from rigidsym.validate._tally import DRAWN, Cell, Tally
from rigidsym.validate.strata import STRATA, count, in_doubles
from rigidsym.view import _report_data as report_data
from rigidsym.view._report_data import COLUMNS, columns_of
from rigidsym.view._tables import columns as aligned
from rigidsym.view._tables import table
from rigidsym.view._validation import BROKEN, PASSED, report_html

SCHEMA = "rigidsym.validation/3"
FAILURES = "failures"
Table = tuple[Sequence[str], Sequence[Sequence[str]]]


@dataclass(frozen=True, slots=True)
class Failure:
    """Error beyond its documented bound, with the simplest case found in which it occurs.

    said: the message with which a user's integrator refused the case, if it did.
    """

    target: str
    measure: str
    share: float
    stratum: str
    index: int
    simplest: Finding
    said: str = ""

    @property
    def file(self) -> str:
        """The path of the case file of the failure, relative to the report's directory."""
        return f"{FAILURES}/{self.target}/{file_name(self.simplest.sample)}"

    @property
    def line(self) -> str:
        """A line of text with the target, case, measure and error of the broken bound."""
        bound = bounds_of(self.target)[self.measure]
        condition = " times its condition" if self.measure in CONDITIONED else ""
        return (
            f"{self.target}: {self.stratum}:{self.index}: {self.measure} "
            f"{self.share * bound:.2g}{condition}, {self.share:.3g} of its bound {bound:g}"
        ) + (f" ({self.said})" if self.said else "")


@dataclass(frozen=True, slots=True)
class Worst:
    """Worst error by one measure in a stratum.

    error: rad, or relative (MEANINGS says which).  condition: the condition number there.
    case: (stratum, index), which `draw` takes.  time: s.
    """

    error: float
    condition: float
    case: tuple[str, int]
    time: float


@dataclass(frozen=True, slots=True, repr=False)
class ValidationReport:
    """Report of a validation campaign, with its results, worst cases and broken bounds.

    other_bits: a line on each hash of states that is not the one expected on every processor.
    """

    campaign: Campaign
    tally: Tally
    worst: tuple[Finding, ...] = ()
    failures: tuple[Failure, ...] = ()
    run: Mapping[str, report_data.Figure | None] = field(default_factory=dict)
    other_bits: tuple[str, ...] = ()

    @property
    def passed(self) -> bool:
        """True if all strata were tested, bounds and bits are kept, and the oracles agree."""
        return not self.complaints

    @property
    def complaints(self) -> tuple[str, ...]:
        """The reasons why the validation did not pass, one line each."""
        listed = {(failure.target, failure.stratum) for failure in self.failures}
        lines = [failure.line for failure in self.failures]
        for stratum in self.campaign.strata:
            tested, wanted = self.tally.cases.get(stratum, 0), count(stratum, self.campaign.cases)
            if tested != wanted or not tested:
                lines.append(f"{stratum}: {tested} of {wanted} cases were tested")
            elif not self.agreement(stratum) <= 1:
                apart = self.agreement(stratum) * AGREEMENT
                lines.append(f"{stratum}: the oracles disagree by {apart:.2g}")
            lines += [
                f"{target}: {stratum}: a bound is broken, or was not tested"
                for target in self.campaign.judged
                if not self.share(target, stratum) <= 1 and (target, stratum) not in listed
            ]
        return (*lines, *self.other_bits)

    def share(self, name: str, stratum: str) -> float:
        """Return an implementation's largest ratio of error to bound in a stratum.

        It is infinite for a stratum that was not tested.
        """
        expected = [m for m in MEASURES if m != "entry_points" or not name.startswith(PEER)]
        cells = (self.tally.cells.get((name, m, "share", stratum)) for m in expected)
        return max(float("inf") if cell is None else cell.worst for cell in cells)

    def agreement(self, stratum: str) -> float:
        """Return the difference of Taylor series from enclosures in a stratum, over its limit."""
        cell = self.tally.cells.get((ORACLES, DISAGREEMENT, "stratum", stratum))
        return float("inf") if cell is None else cell.worst

    @property
    def command(self) -> str:
        """The command that reproduces this report, or the Python call for a user's integrator."""
        campaign = self.campaign
        if user := campaign.user_integrator:
            drawn = f"cases={campaign.cases}, digits={campaign.digits}, seed={campaign.seed}"
            chosen = "" if campaign.strata == in_doubles() else f", strata={[*campaign.strata]}"
            return f"examine({_variable(user)}, {drawn}{chosen})"
        return f"rigidsym validate {self.options}"

    @property
    def options(self) -> str:
        """The targets and options of the campaign, as on the command line."""
        campaign = self.campaign
        partial = len(campaign.strata) < len(STRATA)
        chosen = [f"--stratum '{name}'" for name in campaign.strata] if partial else []
        return self._options(f"--cases {campaign.cases}", *chosen)

    def _options(self, first: str, *last: str) -> str:
        """Return the campaign's targets and options as part of a command line.

        first, last: those before and after the common options.
        """
        campaign = self.campaign
        drawn = f"--digits {campaign.digits} --seed {campaign.seed}"
        peers = [f"--peer {name}" for name in campaign.peers]
        return " ".join([*campaign.targets, first, drawn, *peers, *last])

    @property
    def conclusion(self) -> str:
        """A sentence that states the result."""
        strata = self.campaign.strata
        shares = {x: max(self.share(x, name) for name in strata) for x in self.campaign.judged}
        used = ", ".join(f"{name} uses {share:.0%}" for name, share in shares.items())
        states = sum(self.tally.states.values())
        kept = "Every bound is kept" if self.passed else "BOUNDS ARE BROKEN"
        return f"{kept} at {states} states of {len(strata)} strata: of what is allowed, {used}."

    def by_stratum(self, measure: str = "angle", name: str | None = None) -> dict[str, Worst]:
        """Return the worst error of an implementation in each stratum.

        Parameters
        ----------
        measure : a key of `BOUNDS`
        name : the implementation, the first by default

        Raises
        ------
        InputError
            For other measures, and for implementations that were not measured.
        """
        if measure not in MEASURES:
            raise unknown("measure", measure, MEASURES, plain=True)
        known = {x.removeprefix(PEER): x for x in self.campaign.implementations}
        who = next(iter(known)) if name is None else name.removeprefix(PEER)
        if who not in known:
            raise unknown("name", name, known, plain=True)
        cells = self.tally.view(known[who], measure, "stratum")
        found = ((x, cells[x], *cells[x].place) for x in self.campaign.strata if x in cells)
        return {
            stratum: Worst(cell.worst * ULP, cell.condition, (stratum, index), time)
            for stratum, cell, _, index, time in found
        }

    def __repr__(self) -> str:
        return f"<ValidationReport, {PASSED if self.passed else BROKEN}: {self.command}>"

    def __str__(self) -> str:
        title = f"{self.command}: worst errors in units of 2^-53"
        return "\n".join([aligned(title, *self.summary()), self.conclusion])

    def _repr_html_(self) -> str:
        return report_html(self)

    def to_data(self) -> report_data.Data:
        """Return the report as plain data.

        The schema is rigidsym.validation/3; errors are in units of 2^-53.
        """
        campaign = self.campaign
        return {
            "schema": SCHEMA,
            "campaign": campaign.to_data(),
            "command": self.command,
            "passed": self.passed,
            "complaints": list(self.complaints),
            "unit": "2**-53",
            "bounds": {name: bound / ULP for name, bound in BOUNDS.items()},
            "meanings": MEANINGS,
            "strata": [
                {
                    "name": name,
                    "about": STRATA[name].about,
                    **{column.key: _figure(column.value(self, name)) for column in COLUMNS},
                }
                for name in campaign.strata
            ],
            "agreement": AGREEMENT,
            "implementations": [self._implementation(name) for name in campaign.implementations],
            "worst": [self._case(finding) for finding in self.worst],
            "failures": [
                {
                    "line": failure.line,
                    "target": failure.target,
                    "measure": failure.measure,
                    "stratum": failure.stratum,
                    "index": failure.index,
                    "share": _figure(failure.share),
                    # A user's integrator has no files: its cases are drawn.
                    "simplest": self._case(
                        failure.simplest, None if campaign.user_integrator else failure.file
                    ),
                }
                for failure in self.failures
            ],
            "run": dict(self.run),
        }

    def _implementation(self, name: str) -> report_data.Data:
        campaign, view = self.campaign, self.tally.view
        peer = name.startswith(PEER)

        def by_group(kind: str) -> report_data.Data:
            """Return the worst errors as nested dictionaries, by group of cases, then measure."""
            parts: dict[str, dict[str, report_data.Data]] = {}
            for measure in MEASURES:
                for part, cell in view(name, measure, kind).items():
                    parts.setdefault(part, {})[measure] = _cell(cell)
            return parts

        def by_measure(kind: str) -> report_data.Data:
            """Return the worst errors as nested dictionaries, by measure, then group of cases."""
            return {m: {x: _cell(y) for x, y in view(name, m, kind).items()} for m in DRAWN}

        return {
            "name": name,
            "peer": peer,
            "digest": None if peer else campaign.digests[campaign.targets.index(name)],
            "passed": all(self.share(name, stratum) <= 1 for stratum in campaign.strata),
            "strata": by_group("stratum"),
            "shares": by_group("share"),
            "share": {stratum: _figure(self.share(name, stratum)) for stratum in campaign.strata},
            "regimes": by_group("regime"),
            "sizes": {
                stratum: {
                    m: {x: y.count for x, y in view(name, m, f"sizes: {stratum}").items()}
                    for m in DRAWN
                }
                for stratum in campaign.strata
            },
            "distance": by_measure("distance"),
            "turned": by_measure("turned"),
            "condition": by_measure("condition"),
        }

    def _case(self, finding: Finding, file: str | None = None) -> report_data.Data:
        """Convert a case to plain data, with the command that measures it again."""
        sample, reference, campaign = finding.sample, finding.reference, self.campaign
        if user := campaign.user_integrator:
            drawn = f"draw({sample.stratum!r}, {sample.index}, {campaign.seed})"
            replay = f"measure_case({drawn}, {campaign.digits}, {{{user!r}: {_variable(user)}}})"
        else:
            case = self._options(f"--case {shlex.quote(file or sample.name)}")
            replay = f"rigidsym validate {case}"
        return {
            "case": sample.name,
            "regime": reference.regime.value,
            "distance": _figure(reference.distance),
            **hexadecimal(sample),
            "errors": {
                implementation: {measure: _worst(found) for measure, found in errors.items()}
                for implementation, errors in finding.errors.items()
            },
            "replay": replay,
        }

    def to_json(self) -> str:
        """Return the report as JSON.

        Equal campaigns give equal text, apart from `run`.
        """
        return as_json(self.to_data())

    def to_markdown(self) -> str:
        """Return the report as Markdown."""
        return markdown(self.to_data())

    def summary(self) -> Table:
        """Return a table of the validation results, with a row for each stratum.

        For each implementation: worst angle and rates, and the part of a bound used.
        """
        campaign, tally = self.campaign, self.tally
        own = columns_of("terminal")
        columns = ["stratum", *(column.title for column in own)]
        for name in campaign.implementations:
            columns += [f"{name}: angle", "rates", "share"]
        rows = []
        for stratum in campaign.strata:
            row = [stratum, *(column.shown(column.value(self, stratum)) for column in own)]
            for name in campaign.implementations:
                cells = (tally.cells.get((name, measure, "stratum", stratum)) for measure in DRAWN)
                row += ["not asked" if cell is None else _short(cell.worst) for cell in cells]
                share = self.share(name, stratum)
                row.append(f"{share:.0%}" if share < 10 else f"{share:.1e}")
            rows.append(row)
        return columns, rows


def case_table(finding: Finding) -> Table:
    """Return a table of the errors of one case, with a row for each time."""
    columns = ["t (s)", "turned (rad)", "condition"]
    for name in finding.errors:
        columns += [f"{name}: angle", "rates"]
    reference = finding.reference
    rows = []
    for k, time in enumerate(finding.sample.times):
        condition = reference.condition["angle"][k]
        row = [repr(time), f"{reference.turned[k]:.3g}", f"{condition:.1g}"]
        for errors in finding.errors.values():
            row += [
                _short(x) for m in DRAWN for x in errors[m].units[errors[m].times == time][:1]
            ] or ["not asked", ""]
        rows.append(row)
    return columns, rows


def markdown(data: report_data.Data) -> str:
    """Convert the data of a validation report to Markdown."""
    bounds = (
        (
            head,
            data["meanings"][name],
            f"{data['bounds'][name] * ULP:.2g}" + " times the condition" * (name in CONDITIONED),
        )
        for head, name in zip(HEADS, MEASURES, strict=True)
    )
    apart = max((float(stratum["disagreement"]) for stratum in data["strata"]), default=0.0)
    lines = [
        "# Validation",
        "",
        f"Written by `{data['command']}`: {'passed' if data['passed'] else 'NOT PASSED'}.",
        "",
        "Worst errors against enclosures, in units of 2^-53 (1.1e-16).  In brackets the condition "
        "number there: how many times a relative change of the inputs comes out.  Share: the "
        "largest part of a documented bound that is used.",
        "",
        *table(("measure", "meaning", "bound"), bounds),
        "",
        "The second oracle, Taylor series, agrees with the enclosures to "
        f"{apart * data['agreement']:.1g} and has to agree to {data['agreement']:g}.",
    ]
    if data["failures"]:
        lines += ["", "## Broken bounds", ""]
        lines += [f"* {x['line']}; replay: `{x['simplest']['replay']}`" for x in data["failures"]]
    own = (column.title for column in columns_of("markdown"))
    columns = ["stratum", *own, *HEADS, "share", ""]
    for found in data["implementations"]:
        rows = (_row(found, stratum) for stratum in data["strata"])
        lines += ["", f"## {found['name']}", "", *table(columns, rows)]
    every = data["implementations"]
    regimes = (
        [
            regime,
            *(
                " / ".join(_shown(found["regimes"].get(regime, {}).get(m), False) for m in DRAWN)
                for found in every
            ),
        ]
        for regime in sorted({regime for found in every for regime in found["regimes"]})
    )
    lines += ["", "## By regime", "", "Angle, and rates after the stroke.", ""]
    lines += table(["regime", *(found["name"] for found in every)], regimes)
    return "\n".join(lines) + "\n"


def _row(found: report_data.Data, stratum: report_data.Data) -> list[str]:
    """Return a table row with the errors of an implementation in a stratum."""
    name, share = stratum["name"], float(found["share"][stratum["name"]])
    errors = found["strata"].get(name, {})
    cells = [_shown(errors.get(measure), measure in DRAWN) for measure in MEASURES]
    beyond = "beyond" if found["peer"] else "BROKEN"
    mark = "ok" if share <= 1 else beyond if errors else "not asked"
    own = [column.shown(stratum[column.key]) for column in columns_of("markdown")]
    return [name, *own, *cells, f"{share:.2g}", mark]


def _shown(cell: report_data.Data | None, conditioned: bool) -> str:
    if cell is None:
        return ""
    units = f"{float(cell['units']):.3g}"
    return f"{units} ({float(cell['condition']):.1g})" if conditioned else units


def _variable(name: str) -> str:
    """Convert the name of an integrator to a Python identifier."""
    return re.sub(r"\W", "_", name)


def as_json(data: report_data.Data) -> str:
    """Convert the data of a report to JSON with sorted keys."""
    return json.dumps(data, indent=1, sort_keys=True, allow_nan=False) + "\n"


def _cell(cell: Cell) -> report_data.Data:
    """Convert a cell of a tally to plain data.

    In cells of shares, `units` is the share of the bound, and `count` the errors beyond it.
    """
    stratum, index, time = cell.place
    return {
        "count": cell.count,
        "units": _figure(cell.worst),
        "condition": _figure(cell.condition),
        "case": f"{stratum}:{index}",
        "t": float(time).hex(),
    }


def _worst(found: Errors) -> report_data.Data:
    k = int(found.units.argmax())
    return {
        "units": _figure(found.units[k]),
        "condition": _figure(found.condition[k]),
        "share": _figure(found.share[k]),
        "t": float(found.times[k]).hex(),
    }


def _figure(value: report_data.Figure) -> report_data.Figure:
    """Round a float to three digits for JSON, with text for infinity and NaN."""
    if not isinstance(value, float):
        return value
    text = f"{value:.3g}"
    return text if text in ("inf", "nan") else float(text)


def _short(units: float) -> str:
    return f"{units:.2f}" if units < 1000 else f"{units:.1e}"
