"""Motions for other programs: CCSDS attitude ephemeris messages and SciPy splines."""

from rigidsym.io.aem import aem
from rigidsym.io.splines import rotation_spline
from rigidsym.io.track import Track, sampled

__all__ = ["Track", "aem", "rotation_spline", "sampled"]
