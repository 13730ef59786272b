"""How wide the balls of uncertain inputs are, beside what the inputs do leave open.

    python tests/benchmarks/uncertain.py [--quick]          --quick: the first two times alone

Largest radius of a quaternion's components and of the rates; the effect is the largest distance of
the motions in the middle and at the ends of the one uncertain number, which balls cannot go below.
"""

import sys
from time import perf_counter

from rigidsym import TorqueFreeMotion
from rigidsym.inputs import Uncertain

BODY = ("0.0109", "0.04", "0.0506")
BOXES = {
    "a spin whose tilt is uncertain": (BODY, ("0 +/- 1e-9", 0, "0.5")),
    "a moment about another one": (("1 +/- 1e-9", 1, "1.5"), (1, 2, 3)),
    "across the separatrix": ((4, 5, 9), (3, 1, "1 +/- 1e-9")),
    "the paper's smallest moment": (
        ("0.0109 +/- 1e-6", "0.04", "0.0506"),
        ("0.05", "0.03", "-0.02"),
    ),
}
TIMES = (1, 10, 100, 10_000)


def main() -> None:
    """Print a line for each box and time."""
    print(f"{'':32}{'t':>7}{'q':>10}{'effect':>10}{'omega':>10}{'effect':>10}{'seconds':>9}")
    for name, given in BOXES.items():
        motion = TorqueFreeMotion(*given)
        for time in TIMES[:2] if "--quick" in sys.argv else TIMES:
            start = perf_counter()
            state = motion.enclose(time, 15)
            seconds = perf_counter() - start
            radii = [max(float(x.rad()) for x in part) for part in state]
            q, omega = zip(radii, _effects(motion, time), strict=True)
            widths = "".join(f"{x:10.1e}" for x in (*q, *omega))
            print(f"{name:32}{time:7}{widths}{seconds:9.2f}")


def _effects(motion: TorqueFreeMotion, time: int) -> list[float]:
    middle, *ends = (_moved(motion, side).enclose(time, 40) for side in (0, -1, 1))
    return [
        max(float(abs(x - y).mid()) for end in ends for x, y in zip(end[k], middle[k], strict=True))
        for k in range(2)
    ]


def _moved(motion: TorqueFreeMotion, side: int) -> TorqueFreeMotion:
    return TorqueFreeMotion(
        *(
            [x.middle + side * x.radius if isinstance(x, Uncertain) else x for x in values]
            for values in (motion.inertia, motion.omega0)
        )
    )


if __name__ == "__main__":
    main()
