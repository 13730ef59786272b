"""One motion of every regime, and pictures of them that several tests share."""

from functools import cache

from rigidsym import TorqueFreeMotion
from rigidsym.io.cases import paper_case

MOTIONS = {
    "paper": paper_case().motion,
    "largest": TorqueFreeMotion((2.5, 1, 2), (1, 0.2, 0.1), (0, 0, 1, 0)),
    "flip": TorqueFreeMotion((1, 2, 2.5), ("1e-4", 1, "1e-4")),
    "separatrix": TorqueFreeMotion((1, 2, 2.25), (0.75, 0.5, 1)),
    "oblate": TorqueFreeMotion((1, 1, 1.5), (1, 0.2, 0.5), (1, 2, 3, 4)),
    "prolate": TorqueFreeMotion((1.5, 1, 1.5), (1, 0.2, 0.5)),
    "spherical": TorqueFreeMotion((1, 1, 1), (1, 0.2, 0.5)),
    "spin": TorqueFreeMotion((1, 2, 2.5), (0, 0, -2)),
    "rest": TorqueFreeMotion((1, 2, 2.5), (0, 0, 0)),
}
MOVING = [name for name in MOTIONS if name != "rest"]


@cache
def picture(draw, name):
    """Draw a picture of a motion, and cache it.

    Tests that change the picture have to draw their own.
    """
    return draw(MOTIONS[name])
