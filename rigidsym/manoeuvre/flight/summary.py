"""A flight in words: what a reader wants to know first."""

from collections.abc import Mapping
from math import degrees, radians
from typing import Any, Protocol

from rigidsym.manoeuvre.flight.settings import Timing

_SETTLED = Timing().settled


class Measured(Protocol):
    """A flight, by what is measured on it."""

    @property
    def arrival(self) -> float:
        """When the target takes the track's place, s."""
        ...

    def tracking(self) -> dict[str, float]:
        """Angles of error until arrival, rad."""
        ...

    def holding(self, settled: float) -> dict[str, Any]:
        """Angles of error after arrival, rad, and since when they stay within `settled`, s."""
        ...

    def effort(self) -> dict[str, list[float]]:
        """Peaks and integrals of the wheels' torques, by axis."""
        ...

    def disturbance_peak(self) -> dict[str, float]:
        """The greatest size of each disturbing torque, N m."""
        ...

    def momentum_defect(self) -> float:
        """What the disturbances leave unexplained, N m s."""
        ...

    def energy_defect(self) -> float:
        """What the work of torques leaves unexplained, J."""
        ...


def rows(run: Measured, settled: float = _SETTLED) -> list[tuple[str, str]]:
    """Pairs of name and figure; `settled` is what counts as settled, degrees from the target."""
    error, target, effort = run.tracking(), run.holding(radians(settled)), run.effort()
    return [
        ("natural motion", f"{run.arrival:g} s"),
        ("tracking error, greatest and rms", f"{_deg(error['max'])}, {_deg(error['rms'])}"),
        ("error at arrival", _deg(error["last"])),
        ("settled at the target", _settled(target, settled)),
        ("error at the end", _deg(target["final_error"])),
        ("torque peaks", _three(effort["torque_peak"], "N m")),
        ("torque integrals", _three(effort["torque_integral"], "N m s")),
        ("wheels' momentum peaks", _three(effort["wheel_momentum_peak"], "N m s")),
        *(
            (f"{name.replace('_', ' ')}, peak", f"{peak:.2e} N m")
            for name, peak in run.disturbance_peak().items()
        ),
    ]


def checks(run: Measured) -> list[tuple[str, str]]:
    """What physics leaves to explain: rounding, which differs from machine to machine."""
    return [
        ("momentum unexplained", f"{run.momentum_defect():.1e} N m s"),
        ("energy unexplained", f"{run.energy_defect():.1e} J"),
    ]


def _deg(angle: float | None) -> str:
    return "not flown" if angle is None else f"{degrees(angle):.3f} deg"


def _settled(target: Mapping[str, Any], within: float) -> str:
    if target["final_error"] is None:
        return "not flown"
    if target["settled_at"] is None:
        return f"not within {within:g} deg at the end"
    return f"from {target['settled_at']:.1f} s on, within {within:g} deg"


def _three(values: list[float], unit: str) -> str:
    return f"{', '.join(f'{value:.2e}' for value in values)} {unit}"
