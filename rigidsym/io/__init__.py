"""Case files, tables of states, CCSDS attitude messages, and attitude splines."""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rigidsym.io._attitude_ephemeris import aem
    from rigidsym.io._tracks import Track, rotation_spline, sampled

__all__ = ["Track", "aem", "rotation_spline", "sampled"]


def __getattr__(name: str) -> object:
    """Import a public name of this package when it is first used.

    Modules that only read files are then imported without those of motions.
    """
    if name not in __all__:
        raise AttributeError(f"module 'rigidsym.io' has no attribute {name!r}")
    home = "attitude_ephemeris" if name == "aem" else "tracks"
    return getattr(import_module(f"rigidsym.io._{home}"), name)
