"""The faults, by target."""

from rigidsym.validate.faults.fault import Fault
from rigidsym.validate.faults.tables import c, numpy

FAULTS: tuple[Fault, ...] = (*numpy.FAULTS, *c.FAULTS)
