"""Motions for other programs: CCSDS attitude ephemeris messages and SciPy splines."""

from rigidsym.export.aem import aem
from rigidsym.export.splines import rotation_spline
from rigidsym.export.track import Track, sampled

__all__ = ["Track", "aem", "rotation_spline", "sampled"]
