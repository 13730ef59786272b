"""A flight in words: what a reader wants to know first."""

from math import degrees, radians
from typing import Protocol, TypedDict

from rigidsym.manoeuvre.flight.settings import Timing

_SETTLED = Timing().settled
# Of a flight's largest momentum or energy: what rounding and integration leave is far below it.
_ROUNDING = 1e-12


class Tracking(TypedDict):
    """Angles of error until arrival: the greatest, root mean square, and the last, rad."""

    max: float
    rms: float
    last: float


class Holding(TypedDict):
    """Angles of error after arrival (rad), None where nothing is flown by then; since when (s)
    they stay within what counts as settled, None where they do not."""

    final_error: float | None
    greatest_error: float | None
    settled_at: float | None


class Arrival(TypedDict):
    """When all burns are over (s), the angle from what is wanted (rad), and the rate (rad/s)."""

    t: float
    error: float
    rate: float


class Effort(TypedDict):
    """By axis: peak of |torque| (N m), its integral (N m s), peak of the wheels' momentum."""

    torque_peak: list[float]
    torque_integral: list[float]
    wheel_momentum_peak: list[float]


class Measured(Protocol):
    """A flight, by what is measured on it."""

    @property
    def arrival(self) -> float:
        """When the target takes the track's place, s."""
        ...

    def tracking(self) -> Tracking:
        """Angles of error until arrival, rad."""
        ...

    def holding(self, settled: float) -> Holding:
        """Angles of error after arrival, rad, and since when they stay within `settled`, s."""
        ...

    def effort(self) -> Effort:
        """Peaks and integrals of the wheels' torques, by axis."""
        ...

    def disturbance_peak(self) -> dict[str, float]:
        """The greatest size of each disturbing torque, N m."""
        ...

    def last_burn(self) -> Arrival | None:
        """How far from what is wanted the last burn of thrusters leads; None where none does."""
        ...

    def momentum_defect(self) -> float:
        """What the disturbances leave unexplained, N m s."""
        ...

    def energy_defect(self) -> float:
        """What the work of torques leaves unexplained, J."""
        ...

    def sizes(self) -> tuple[float, float]:
        """The largest momentum, N m s, and the largest energy of rotation, J."""
        ...


def rows(run: Measured, settled: float = _SETTLED) -> list[tuple[str, str]]:
    """Pairs of name and figure; `settled` is what counts as settled, degrees from the target."""
    error, target, effort = run.tracking(), run.holding(radians(settled)), run.effort()
    return [
        ("natural motion", f"{run.arrival:g} s"),
        ("tracking error, greatest and rms", f"{_deg(error['max'])}, {_deg(error['rms'])}"),
        ("error at arrival", _deg(error["last"])),
        *_burnt(run.last_burn()),
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


def predicted(size: float, direction: float) -> tuple[str, str]:
    """What the natural motion misses by with nobody to correct it: `size` (rad) by 1 % of the first
    burst, `direction` (rad per rad) by where it points."""
    told = f"{_deg(size)} by 1 % of the burst, {direction:.3f} deg by 1 deg of its direction"
    return "the same predicted, uncorrected", told


def checks(run: Measured) -> list[tuple[str, str]]:
    """Return pairs of name and figure: momentum and energy that nothing explains."""
    momentum, energy = run.sizes()
    return [
        ("momentum unexplained", f"{_unexplained(run.momentum_defect(), momentum)} N m s"),
        ("energy unexplained", f"{_unexplained(run.energy_defect(), energy)} J"),
    ]


def _unexplained(defect: float, size: float) -> str:
    """Return a bound where the defect is rounding, whose digits differ between processors."""
    bound = _ROUNDING * size
    return f"below {bound:.0e}" if bound and defect <= bound else f"{defect:.1e}"


def _burnt(last: Arrival | None) -> list[tuple[str, str]]:
    if last is None:
        return []
    off = f"{_deg(last['error'])} off, {degrees(last['rate']):.4f} deg/s left"
    return [("when thrusters end", f"{last['t']:g} s: {off}")]


def _deg(angle: float | None) -> str:
    return "not flown" if angle is None else f"{degrees(angle):.3f} deg"


def _settled(target: Holding, within: float) -> str:
    if target["final_error"] is None:
        return "not flown"
    if target["settled_at"] is None:
        return f"not within {within:g} deg at the end"
    return f"from {target['settled_at']:.1f} s on, within {within:g} deg"


def _three(values: list[float], unit: str) -> str:
    return f"{', '.join(f'{value:.2e}' for value in values)} {unit}"
