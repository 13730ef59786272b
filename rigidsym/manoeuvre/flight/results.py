"""A flight as files and tables."""

import io
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from datetime import datetime
from fractions import Fraction
from math import radians
from pathlib import Path
from typing import Any

import numpy as np

from rigidsym.export import Track, aem
from rigidsym.files import write_bytes, write_text
from rigidsym.manoeuvre import drawing
from rigidsym.manoeuvre.flight import pictures
from rigidsym.manoeuvre.flight.control import Transfer
from rigidsym.manoeuvre.flight.run import Run
from rigidsym.manoeuvre.flight.settings import Flight
from rigidsym.manoeuvre.flight.words import checks, rows
from rigidsym.manoeuvre.manoeuvre import Manoeuvre

SCHEMA = "rigidsym.track/1"
_UTC_BEGINS = 1972
_PICTURES = {
    "attitude": pictures.attitude,
    "torques": pictures.torques,
    "disturbances": pictures.disturbances,
}


@dataclass(frozen=True, slots=True)
class Tracked:
    """A flight with what was asked for."""

    manoeuvre: Manoeuvre
    flight: Flight
    transfer: Transfer
    run: Run

    def summary(self) -> dict[str, Any]:
        """Numbers of the flight: SI units and radians, settings in the units of the file."""
        run = self.run
        return {
            "schema": SCHEMA,
            "transfer": {
                "duration": run.arrival,
                "omega0": run.natural.omega[0].tolist(),
                "omega1": self.transfer.motion(run.arrival)[1].tolist(),
                "regime": str(self.transfer.motion.regime),
            },
            "tracking_error": run.tracking(),
            "target": run.holding(radians(self.flight.run.settled)),
            **run.effort(),
            "disturbance_peak": run.disturbance_peak(),
            "checks": {
                "momentum_defect": run.momentum_defect(),
                "energy_defect": run.energy_defect(),
            },
            "manoeuvre": self.manoeuvre.to_data(),
            "flight": _plain(asdict(self.flight)),
        }

    def to_json(self) -> str:
        """The summary, as the schema rigidsym.track/1."""
        return json.dumps(self.summary(), indent=1) + "\n"

    @property
    def missed(self) -> bool:
        """Whether there was time to settle at the target, and it did not."""
        target = self.run.holding(radians(self.flight.run.settled))
        return target["final_error"] is not None and target["settled_at"] is None

    def rows(self) -> list[tuple[str, str]]:
        """What a reader wants to know first."""
        return [*rows(self.run, self.flight.run.settled), *checks(self.run)]

    def _repr_html_(self) -> str:
        from rigidsym.display.flights import tracked_html

        return tracked_html(self, rows(self.run, self.flight.run.settled))

    def to_npz(self) -> bytes:
        """float64 arrays, a row for each sample; names as those of `Run`."""
        run = self.run
        arrays: dict[str, Any] = {
            "t": run.t,
            "q": run.q,
            "omega": run.omega,
            "reference_q": run.reference.q,
            "reference_omega": run.reference.omega,
            "natural_q": run.natural.q,
            "natural_omega": run.natural.omega,
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

        Raises InputError for epochs before 1972, when seconds of UTC had other lengths.
        """
        run, epoch = self.run, self.flight.orbit.epoch.replace(tzinfo=None).isoformat()
        track = Track(run.t, run.q, run.omega)
        return aem(track, epoch, object_name="UNKNOWN", object_id="UNKNOWN", originator="RIGIDSYM")

    def write(self, directory: Path) -> list[Path]:
        """run.npz, summary.json, pictures and, from 1972 on, attitude.aem.

        Raises InputError where that fails.
        """
        written = [write_bytes(directory / "run.npz", self.to_npz())]
        if self.flight.orbit.epoch.year >= _UTC_BEGINS:
            written.append(write_text(directory / "attitude.aem", self.to_aem()))
        for name, draw in _PICTURES.items():
            for suffix, data in drawing.rendered(draw(self.run)).items():
                written.append(write_bytes(directory / f"{name}.{suffix}", data))
        return [*written, write_text(directory / "summary.json", self.to_json())]


def _plain(value: Any) -> Any:
    """What JSON can hold."""
    if isinstance(value, Mapping):
        return {key: _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if isinstance(value, datetime):
        return value.isoformat()
    return float(value) if isinstance(value, Fraction) else value
