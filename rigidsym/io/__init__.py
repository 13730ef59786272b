"""Case files, tables of states, CCSDS attitude messages, and attitude splines."""

from typing import TYPE_CHECKING

from rigidsym._lazy import lazily

if TYPE_CHECKING:
    from rigidsym.io._attitude_ephemeris import aem
    from rigidsym.io._tracks import Track, rotation_spline, sampled

__all__ = ["Track", "aem", "rotation_spline", "sampled"]

# At first use: modules that only read files are then imported without those of motions.
__getattr__, __dir__ = lazily(
    __name__,
    {
        "aem": "._attitude_ephemeris",
        **dict.fromkeys(("Track", "rotation_spline", "sampled"), "._tracks"),
    },
)
