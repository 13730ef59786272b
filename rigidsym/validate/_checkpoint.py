"""The file from which an interrupted campaign is resumed."""

import hashlib
import json
import time
from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path

from rigidsym.errors import InputError
from rigidsym.io._files import write_text
from rigidsym.validate._campaign import Campaign, Progress
from rigidsym.validate._tally import Tally

NAME = "campaign.json"
SCHEMA = "rigidsym.campaign/2"
# Seconds of work that are lost at most when a machine is switched off.
INTERVAL = 10.0


class Checkpoint:
    """A campaign's progress in a directory: written every few seconds, whole or not at all."""

    def __init__(self, directory: Path, campaign: Campaign, progress: Progress) -> None:
        self.path, self.campaign, self.progress = directory / NAME, campaign, progress
        self._last = time.monotonic()

    def now_and_then(self) -> None:
        """Write if the last time was INTERVAL ago."""
        if time.monotonic() - self._last >= INTERVAL:
            self.write()

    def write(self) -> None:
        """Write now; raise InputError where that fails, and keep the old file."""
        data = {
            "campaign": self.campaign.to_data(),
            "done": self.progress.done,
            "tally": self.progress.tally.to_data(),
        }
        write_text(self.path, json.dumps({**_seal(data), **data}, sort_keys=True) + "\n")
        self._last = time.monotonic()

    def remove(self) -> None:
        """Remove the file of a campaign whose report is written."""
        self.path.unlink(missing_ok=True)


def load(directory: Path) -> tuple[Campaign, Progress]:
    """Load the campaign of a directory; raise InputError where it has none, or a damaged one."""
    path = directory / NAME
    try:
        data = json.loads(path.read_text("utf-8"))
        seal = {name: data.pop(name) for name in ("schema", "sha256")}
    except FileNotFoundError:
        raise InputError("resume", directory, f"holds no unfinished campaign ({NAME})") from None
    except (OSError, ValueError, KeyError, AttributeError, TypeError, RecursionError):
        seal, data = {}, {}
    if not seal or seal != _seal(data):
        raise InputError("resume", path, "is not what a campaign of this version left there")
    done = {
        name: [(start, stop) for start, stop in ranges] for name, ranges in data["done"].items()
    }
    return Campaign.from_data(data["campaign"]), Progress(Tally.from_data(data["tally"]), done)


def _seal(data: Mapping[str, object]) -> dict[str, str]:
    """Return the schema, and a digest that shows any change."""
    text = json.dumps(data, sort_keys=True)
    return {"schema": SCHEMA, "sha256": hashlib.sha256(text.encode()).hexdigest()}


def check_same(directory: Path, found: Campaign, expected: Campaign) -> None:
    """Raise InputError if the campaign of a directory is not the expected one."""
    for field in fields(Campaign):
        theirs, ours = (getattr(x, field.name) for x in (found, expected))
        if theirs != ours:
            rule = f"is another campaign: its {field.name} {_short(theirs)}, not {_short(ours)}"
            raise InputError("resume", directory, rule)


def _short(value: object) -> str:
    if isinstance(value, tuple):
        return ", ".join(str(x)[:12] for x in value) or "none"
    return str(value)
