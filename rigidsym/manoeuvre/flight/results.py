"""A flight as files and tables."""

import io
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from datetime import datetime
from fractions import Fraction
from math import radians
from pathlib import Path
from typing import Any, Protocol, TypedDict

import numpy as np

from rigidsym.io import Track, aem
from rigidsym.io.files import remove, write_bytes
from rigidsym.io.messages import UNNAMED
from rigidsym.manoeuvre.flight import saturation
from rigidsym.manoeuvre.flight.run import Run
from rigidsym.manoeuvre.flight.settings import Flight
from rigidsym.manoeuvre.flight.summary import (
    Arrival,
    Effort,
    Holding,
    Tracking,
    checks,
    predicted,
    rows,
)
from rigidsym.manoeuvre.manoeuvre import Manoeuvre, ManoeuvreTables
from rigidsym.manoeuvre.robustness import Robustness
from rigidsym.motion import TorqueFreeMotion
from rigidsym.view.plots import flights as pictures
from rigidsym.view.plots import histories as drawing
from rigidsym.view.text import columns

SCHEMA = "rigidsym.track/1"
_UTC_BEGINS = 1972
_MESSAGE = "attitude.aem"
_FRAME = "GCRF"
"The geocentric celestial frame, in which the sky is, by its name in CCSDS's registry (SANA)."
# Settings of a flight, and the same as JSON can hold them.
Setting = (
    Mapping[str, "Setting"]
    | list["Setting"]
    | tuple["Setting", ...]
    | datetime
    | Fraction
    | float
    | str
    | None
)
Plain = dict[str, "Plain"] | list["Plain"] | float | str | None
_PICTURES = {
    "attitude": pictures.attitude,
    "error": pictures.error,
    "rates": pictures.rates,
    "torques": pictures.torques,
    "disturbances": pictures.disturbances,
}


class TransferData(TypedDict):
    """The natural motion that is followed, of the schema rigidsym.track/1."""

    duration: float
    omega0: list[float]
    omega1: list[float]
    regime: str
    miss_burst_size: float
    miss_burst_direction: float


class BurnsData(TypedDict):
    """What thrusters burn, by burst and axis: when (s) and how much (N m s); and where it leads."""

    spans: list[list[list[float]]]
    impulses: list[list[float]]
    last: Arrival | None


class Summary(Effort):
    """The schema rigidsym.track/1."""

    schema: str
    transfer: TransferData
    tracking_error: Tracking
    target: Holding
    thrusters: "BurnsData | None"
    saturation: saturation.Saturation
    disturbance_peak: dict[str, float]
    checks: dict[str, float]
    manoeuvre: ManoeuvreTables
    flight: "Plain"


class Natural(Protocol):
    """A track that is a natural motion."""

    @property
    def duration(self) -> float:
        """From the start to the target, s."""
        ...

    @property
    def motion(self) -> TorqueFreeMotion:
        """From the start, with the rates after the first burst."""
        ...

    @property
    def sensitivity(self) -> Robustness:
        """What it misses by with errors at the start, corrected by nobody."""
        ...


@dataclass(frozen=True, slots=True)
class Tracked:
    """A flight with what was asked for."""

    manoeuvre: Manoeuvre
    flight: Flight
    transfer: Natural
    run: Run

    def summary(self) -> Summary:
        """Numbers of the flight: SI units and radians, settings in the units of the file."""
        run = self.run
        return {
            "schema": SCHEMA,
            "transfer": {
                "duration": run.arrival,
                "omega0": run.track.omega[0].tolist(),
                "omega1": self.transfer.motion(run.arrival)[1].tolist(),
                "regime": str(self.transfer.motion.regime),
                "miss_burst_size": self.transfer.sensitivity.size,
                "miss_burst_direction": self.transfer.sensitivity.direction,
            },
            "tracking_error": run.tracking(),
            "target": run.holding(radians(self.flight.run.settled)),
            "thrusters": self._burns(),
            "saturation": saturation.saturation(run, self.flight.wheels),
            **run.effort(),
            "disturbance_peak": run.disturbance_peak(),
            "checks": {
                "momentum_defect": run.momentum_defect(),
                "energy_defect": run.energy_defect(),
            },
            "manoeuvre": self.manoeuvre.to_data(),
            "flight": _plain(asdict(self.flight)),
        }

    def _burns(self) -> BurnsData | None:
        burns = self.run.burns
        if burns is None:
            return None
        spans, impulses = burns.spans.tolist(), burns.impulses.tolist()
        return {"spans": spans, "impulses": impulses, "last": self.run.last_burn()}

    def to_json(self) -> str:
        """The summary, as the schema rigidsym.track/1."""
        return json.dumps(self.summary(), indent=1) + "\n"

    @property
    def missed(self) -> bool:
        """Whether there was time to settle at the target, and it did not.

        Of thrusters alone, which nobody corrects: whether their last burn leads beside it.
        """
        settled, last = radians(self.flight.run.settled), self.run.last_burn()
        if last is not None and not self.flight.controller.natural_frequency:
            return last["error"] > settled
        target = self.run.holding(settled)
        return target["final_error"] is not None and target["settled_at"] is None

    def rows(self) -> list[tuple[str, str]]:
        """What a reader wants to know first."""
        return [*self._told(), *checks(self.run)]

    def _told(self) -> list[tuple[str, str]]:
        told = rows(self.run, self.flight.run.settled)
        missed = self.transfer.sensitivity
        flown = [name for name, _ in told].index("error at arrival")
        told.insert(flown + 1, predicted(missed.size, missed.direction))
        told += saturation.rows(self.run, self.flight.wheels, self.missed)
        nothing = ("start equals target", "nothing to do: the target is held")
        return [nothing, *told] if self.manoeuvre.trivial else told

    def __repr__(self) -> str:
        return columns("Flight: missed" if self.missed else "Flight", ("", ""), self.rows())

    def _repr_html_(self) -> str:
        from rigidsym.view.html.flights import tracked_html

        return tracked_html(self, self._told())

    def to_npz(self) -> bytes:
        """float64 arrays, a row for each sample; names as those of `Run`."""
        run = self.run
        # Any, because `savez` has an argument by name of another type.
        arrays: dict[str, Any] = {
            "t": run.t,
            "q": run.q,
            "omega": run.omega,
            "reference_q": run.reference.q,
            "reference_omega": run.reference.omega,
            "natural_q": run.track.q,
            "natural_omega": run.track.omega,
            "error": run.error,
            "torque": run.torque,
            "wheel_momentum": run.wheel_momentum,
            "impulse": run.impulse,
            "work": run.work,
        }
        arrays |= {f"disturbance_{name}": torque for name, torque in run.disturbances.items()}
        buffer = io.BytesIO()
        np.savez(buffer, **arrays)
        return buffer.getvalue()

    def to_aem(self) -> str:
        """What was flown as a CCSDS attitude ephemeris message, in UTC from the orbit's epoch.

        Raises InputError for epochs before 1972, when seconds of UTC had other lengths, and for
        flights beyond the year 9999.
        """
        run, epoch = self.run, self.flight.orbit.epoch.replace(tzinfo=None).isoformat()
        track = Track(run.t, run.q, run.omega)
        # Any, because `aem` has an argument by name of another type.
        names: dict[str, Any] = {**UNNAMED, **self.flight.message}
        return aem(track, epoch, ref_frame_a=_FRAME, **names)

    def contents(self) -> dict[str, bytes]:
        """By file name: run.npz, from 1972 on attitude.aem, pictures, summary.json.

        Raises InputError as `to_aem` does.
        """
        found = {"run.npz": self.to_npz()}
        if self.flight.orbit.epoch.year >= _UTC_BEGINS:
            found[_MESSAGE] = self.to_aem().encode()
        drawn = {name: draw(self.run) for name, draw in _PICTURES.items()}
        drawn["wheels"] = pictures.wheels(self.run, self.flight.wheels.rotor_inertia)
        for name, figure in drawn.items():
            for suffix, data in drawing.rendered(figure).items():
                found[f"{name}.{suffix}"] = data
        return found | {"summary.json": self.to_json().encode()}

    def write(self, directory: Path) -> list[Path]:
        """Write `contents`, all of them made before the first; raises InputError.

        An attitude.aem of an earlier flight is removed where this one has none: beside the other
        files it would be taken for this flight's.
        """
        contents = self.contents()
        if _MESSAGE not in contents:
            remove(directory / _MESSAGE)
        return [write_bytes(directory / name, data) for name, data in contents.items()]


def _plain(value: Setting) -> Plain:
    """What JSON can hold."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, datetime):
        return value.isoformat()
    return float(value) if isinstance(value, Fraction) else value
