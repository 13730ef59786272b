"""Files: case files, tables of states, and tracks for other programs (CCSDS messages, splines)."""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rigidsym.io.attitude_ephemeris import aem
    from rigidsym.io.splines import rotation_spline
    from rigidsym.io.tracks import Track, sampled

__all__ = ["Track", "aem", "rotation_spline", "sampled"]

# Imported at first use: rooms that only read and write files know nothing of motions.
_HOMES = {
    "Track": "rigidsym.io.tracks",
    "aem": "rigidsym.io.attitude_ephemeris",
    "rotation_spline": "rigidsym.io.splines",
    "sampled": "rigidsym.io.tracks",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'rigidsym.io' has no attribute {name!r}")
    return getattr(import_module(_HOMES[name]), name)
