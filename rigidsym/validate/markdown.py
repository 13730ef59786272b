"""The validation report as Markdown."""

from collections.abc import Iterable, Sequence

from rigidsym.validate.bounds import CONDITIONED, MEASURES, ULP
from rigidsym.validate.tally import DRAWN
from rigidsym.view.markdown import table
from rigidsym.view.report_data import Cell, Failure, Figure, Implementation, Report, Stratum

HEADS = ("angle", "omega", "norm", "H", "K^2", "residual", "jump", "start", "entry points")


def markdown(data: Report) -> str:
    """Tables a person can read, of data of the schema rigidsym.validation/3."""
    lines = [
        "# Validation",
        "",
        f"Written by `{data['command']}`: {'passed' if data['passed'] else 'NOT PASSED'}.",
        "",
        "Worst errors against enclosures, in units of 2^-53 (1.1e-16).  In brackets the condition "
        "number there: how many times a relative change of the inputs comes out.  Share: the "
        "largest part of a documented bound that is used.",
        "",
        *table(
            ("measure", "meaning", "bound"),
            (
                (head, data["meanings"][name], _bound(data, name))
                for head, name in zip(HEADS, MEASURES, strict=True)
            ),
        ),
    ]
    lines += ["", "The second oracle, Taylor series, agrees with the enclosures to "]
    apart = [stratum["disagreement"] for stratum in data["strata"]]
    lines[-1] += f"{_worst(apart) * data['agreement']:.1g} and has to agree to "
    lines[-1] += f"{data['agreement']:g}."
    lines += _failures(data["failures"])
    for implementation in data["implementations"]:
        lines += _implementation(implementation, data["strata"])
    lines += _regimes(data["implementations"])
    return "\n".join(lines) + "\n"


def _bound(data: Report, name: str) -> str:
    bound = f"{data['bounds'][name] * ULP:.2g}"
    return f"{bound} times the condition" if name in CONDITIONED else bound


def _failures(failures: Sequence[Failure]) -> list[str]:
    if not failures:
        return []
    lines = ["", "## Broken bounds", ""]
    for failure in failures:
        lines += [f"* {failure['line']}; replay: `{failure['simplest']['replay']}`"]
    return lines


def _implementation(implementation: Implementation, strata: Iterable[Stratum]) -> list[str]:
    columns = ["stratum", "cases", "states", *HEADS, "share", ""]
    rows = (_stratum(implementation, stratum) for stratum in strata)
    return ["", f"## {implementation['name']}", "", *table(columns, rows)]


def _stratum(implementation: Implementation, stratum: Stratum) -> list[str]:
    name = stratum["name"]
    found = implementation["strata"].get(name, {})
    share = float(implementation["share"][name])
    cells = [_shown(found.get(measure), measure in DRAWN) for measure in MEASURES]
    beyond = "beyond" if implementation["peer"] else "BROKEN"
    mark = "ok" if share <= 1 else beyond if found else "not asked"
    return [name, str(stratum["cases"]), str(stratum["states"]), *cells, f"{share:.2g}", mark]


def _regimes(implementations: Sequence[Implementation]) -> list[str]:
    """Targets x regimes: angle and rates."""
    names = [implementation["name"] for implementation in implementations]
    regimes = sorted(
        {regime for implementation in implementations for regime in implementation["regimes"]}
    )
    rows = (
        [
            regime,
            *(
                " / ".join(_shown(found["regimes"].get(regime, {}).get(m), False) for m in DRAWN)
                for found in implementations
            ),
        ]
        for regime in regimes
    )
    head = ["", "## By regime", "", "Angle, and rates after the stroke.", ""]
    return [*head, *table(["regime", *names], rows)]


def _shown(cell: Cell | None, conditioned: bool) -> str:
    if cell is None:
        return ""
    units = f"{float(cell['units']):.3g}"
    return f"{units} ({float(cell['condition']):.1g})" if conditioned else units


def _worst(figures: Iterable[Figure]) -> float:
    return max(map(float, figures), default=0.0)
