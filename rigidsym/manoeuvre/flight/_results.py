"""Results of a manoeuvre that is planned and flown from its file."""

import io
import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from datetime import datetime
from fractions import Fraction
from math import radians
from pathlib import Path
from typing import Any

import numpy as np

from rigidsym.errors import require
from rigidsym.io import Track, aem
from rigidsym.io._attitude_ephemeris import UNNAMED
from rigidsym.io._files import remove, write_all
from rigidsym.manoeuvre._manoeuvre import Manoeuvre, open_manoeuvre
from rigidsym.manoeuvre._planning import solve
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre.flight._fly import fly
from rigidsym.manoeuvre.flight._run import Rows, Run, predicted
from rigidsym.manoeuvre.flight._settings import Flight, read
from rigidsym.view._plots import figure as drawing
from rigidsym.view._plots import motions as pictures
from rigidsym.view._tables import columns

require("drawing", "matplotlib")

SCHEMA = "rigidsym.track/1"
_UTC_BEGINS = 1972
_MESSAGE = "attitude.aem"
_FRAME = "GCRF"
"The geocentric celestial frame, that of the sky, by its name in CCSDS's registry (SANA)."
_PICTURES = ("attitude", "error", "rates", "torques", "disturbances")


@dataclass(frozen=True, slots=True)
class Tracked:
    """A simulated flight with its manoeuvre, its settings and the motion that it follows."""

    manoeuvre: Manoeuvre
    flight: Flight
    transfer: Transfer
    run: Run

    def summary(self) -> dict[str, Any]:
        """Return the summary of the flight in the schema rigidsym.track/1.

        Numbers are in SI units and radians; settings are in the units of `Flight`.
        """
        run, burns, transfer = self.run, self.run.burns, self.transfer
        return {
            "schema": SCHEMA,
            "transfer": {
                "duration": run.arrival,
                "omega0": run.track.omega[0].tolist(),
                "omega1": transfer.motion(run.arrival)[1].tolist(),
                "regime": str(transfer.motion.regime),
                "miss_burst_size": transfer.sensitivity.size,
                "miss_burst_direction": transfer.sensitivity.direction,
            },
            "tracking_error": run.tracking(),
            "target": run.holding(radians(self.flight.run.settled)),
            "thrusters": burns
            and {
                "spans": burns.spans.tolist(),
                "impulses": burns.impulses.tolist(),
                "last": run.last_burn(),
            },
            "saturation": run.saturation(self.flight.wheels),
            **run.effort(),
            "disturbance_peak": run.disturbance_peak(),
            "checks": {
                "momentum_defect": run.momentum_defect(),
                "energy_defect": run.energy_defect(),
            },
            "manoeuvre": self.manoeuvre.to_data(),
            "flight": asdict(self.flight),
        }

    def to_json(self) -> str:
        """Return the summary as JSON in the schema rigidsym.track/1."""
        return json.dumps(self.summary(), indent=1, default=_plain) + "\n"

    @property
    def missed(self) -> bool:
        """True if the spacecraft had time to settle at the target and did not.

        With thrusters alone, without feedback: true where their last burn does not lead there.
        """
        settled, last = radians(self.flight.run.settled), self.run.last_burn()
        if last is not None and not self.flight.controller.natural_frequency:
            return last["error"] > settled
        target = self.run.holding(settled)
        return target["final_error"] is not None and target["settled_at"] is None

    def rows(self, checks: bool = True) -> Rows:
        """Return the table of measures as pairs of name and text.

        The checks are last.
        """
        rows = self.run.rows(self.flight.run.settled)
        missed = self.transfer.sensitivity
        flown = [name for name, _ in rows].index("error at arrival")
        rows.insert(flown + 1, predicted(missed.size, missed.direction))
        rows += self.run.saturation_rows(self.flight.wheels, self.missed)
        if self.manoeuvre.trivial:
            rows.insert(0, ("start equals target", "nothing to do: the target is held"))
        return rows + self.run.check_rows() if checks else rows

    def __repr__(self) -> str:
        return columns("Flight: missed" if self.missed else "Flight", ("", ""), self.rows())

    def _repr_html_(self) -> str:
        from rigidsym.view._motions import tracked_html

        return tracked_html(self, self.rows(checks=False))

    def to_npz(self) -> bytes:
        """Return the flight as the content of a NumPy file run.npz.

        Its float64 arrays have a row for each sample, and the names of `Run.arrays`.
        """
        buffer = io.BytesIO()
        np.savez(buffer, **self.run.arrays())
        return buffer.getvalue()

    def to_aem(self) -> str:
        """Return the flight as a CCSDS attitude ephemeris message.

        Times are in UTC, from the orbit's epoch on.

        Raises InputError for epochs before 1972, when seconds of UTC had other lengths, and for
        flights beyond the year 9999.
        """
        run, epoch = self.run, self.flight.orbit.epoch.replace(tzinfo=None).isoformat()
        # Any, because another keyword of `aem` is not text.
        names: dict[str, Any] = {**UNNAMED, **self.flight.message, "ref_frame_a": _FRAME}
        return aem(Track(run.t, run.q, run.omega), epoch, **names)

    def contents(self) -> dict[str, bytes]:
        """Return the contents of all files of a flight by name.

        They are data, a message, pictures and a summary.

        There is a message from 1972 on.  Raises InputError as `to_aem` does.
        """
        found = {"run.npz": self.to_npz()}
        if self.flight.orbit.epoch.year >= _UTC_BEGINS:
            found[_MESSAGE] = self.to_aem().encode()
        drawn = {name: getattr(pictures, name)(self.run) for name in _PICTURES}
        drawn["wheels"] = pictures.wheels(self.run, self.flight.wheels.rotor_inertia)
        return found | drawing.files(drawn) | {"summary.json": self.to_json().encode()}

    def write(self, directory: Path) -> list[Path]:
        """Write all files of `contents` to a directory.

        Raises InputError where that fails.

        All contents are made before the first is written.  An attitude.aem of an earlier flight is
        removed where this one has none: beside the other files it would be taken for this flight's.
        """
        contents = self.contents()
        if _MESSAGE not in contents:
            remove(directory / _MESSAGE)
        return write_all(directory, contents)


def track(name: str, progress: Callable[[int, int], None] = lambda done, total: None) -> Tracked:
    """Plan and fly the manoeuvre of a file.

    The name `paper` means the paper's manoeuvre.  Raises InputError for a bad file.

    `progress` is called with the samples done and all of them.
    """
    manoeuvre, tables = open_manoeuvre(name)
    flight = read(tables)
    plan = solve(manoeuvre)
    run = fly(plan.manoeuvre, flight, plan.best, progress)
    return Tracked(plan.manoeuvre, flight, plan.best, run)


def _plain(value: datetime | Fraction) -> str | float:
    """Convert a date or fraction for JSON."""
    return value.isoformat() if isinstance(value, datetime) else float(value)
