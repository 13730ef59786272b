"""The colour of each regime."""

from rigidsym.solution.polhode import Regime
from rigidsym.view.palette import BLUE, GOLD, GREEN, MAGENTA, OPEN, ORANGE

REGIMES = {
    Regime.LARGEST: BLUE,
    Regime.SMALLEST: ORANGE,
    Regime.SEPARATRIX: MAGENTA,
    Regime.SYMMETRIC: GREEN,
    Regime.SPIN: GOLD,
    Regime.SPHERICAL: GOLD,
    Regime.REST: OPEN,
}
