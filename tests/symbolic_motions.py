"""A motion for each symbolic form."""

from rigidsym import TorqueFreeMotion

ATTITUDE = ("0.5", "-0.1", "0.7", "0.3")
MOTIONS = {
    "theorem1": ((3, 2, 4), (1, 1, 2)),
    "pi": ((2, 4, 3), (1, 2, 1)),
    "theta": ((4, 3, 2), (1, -1, 2)),
    "separatrix": ((1, 2, "9/4"), (3, 1, 4)),
    "symmetric": ((2, 3, 2), (1, -1, "1/2")),
    "sphere": ((2, 2, 2), (1, 2, 2)),
    "spin": ((1, 2, "5/2"), (0, -2, 0)),
}


def motion_of(form):
    return TorqueFreeMotion(*MOTIONS[form], ATTITUDE)
