"""Drift of H and K^2 over many free steps, for bodies of several kinds.

    python tests/benchmarks/drift.py [STEPS] [--quick] [--json]     --quick: 2000 steps

Bodies of several kinds take STEPS (10^6) steps of 0.1 to 1 rad in C, in place.  A figure is the
root mean square, over the bodies of a kind, of the relative difference of H or K^2 from its first
value, both in extended precision, in units of 2^-53.  A random walk of roundings grows with the
square root of the number of steps: `slope` is that of a line through the logarithms of all figures,
and `mean` the mean over the root mean square at the end, 1 where all bodies drift alike.
"""

import argparse
import json
from dataclasses import asdict, dataclass
from random import Random

import numpy as np

from rigidsym._engines import exact_stepper
from rigidsym.validate.strata import draw

KINDS = (
    *("uniform", "separatrix", "near separatrix", "symmetric", "near sphere"),
    *("near spin, middle", "rod", "flat"),
)
BODIES, STEPS = 32, 10**6
UNIT = 2.0**-53


@dataclass(frozen=True, slots=True)
class Drift:
    """Root mean square drift of a kind of bodies by number of steps, its growth and its mean."""

    kind: str
    quantity: str
    rms: dict[int, float]
    exponent: float
    mean: float

    def row(self) -> str:
        """Return a line of the table."""
        figures = " ".join(f"{x:8.1f}" for x in self.rms.values())
        return f"{self.kind:18} {self.quantity:3} {figures}  {self.exponent:5.2f}  {self.mean:5.2f}"


def drifts(steps: int = STEPS, bodies: int = BODIES, kinds: tuple[str, ...] = KINDS) -> list[Drift]:
    """Return the drift of H and of K^2 for each kind of bodies."""
    motions = [draw(kind, k, 7) for kind in kinds for k in range(bodies)]
    inertia, omega, q = (
        np.array([list(map(float, x)) for x in values])
        for values in zip(*((m.inertia, m.omega0, m.attitude0) for m in motions), strict=True)
    )
    random = Random(7)
    angles = np.array([0.1 * 10 ** random.random() for _ in motions])
    dt = angles / np.linalg.norm(omega, axis=1)
    first, found = _integrals(inertia, omega), {}
    stepper, marks = exact_stepper("c-step"), _marks(steps)
    for step in range(1, steps + 1):
        stepper.step(inertia, q, omega, dt, (q, omega))
        if step in marks:
            found[step] = (_integrals(inertia, omega) / first - 1).astype(float) / UNIT
    return [_drift(found, n, k, kinds[k], bodies) for k in range(len(kinds)) for n in (0, 1)]


def _integrals(inertia: np.ndarray, omega: np.ndarray) -> np.ndarray:
    """Return 2 H and K^2 of bodies (2, B)."""
    c, w = inertia.astype(np.longdouble), omega.astype(np.longdouble)
    return np.stack([np.sum(c * w * w, axis=1), np.sum((c * w) ** 2, axis=1)])


def _marks(steps: int) -> list[int]:
    """Return the numbers of steps at which drifts are computed."""
    return sorted({*(10**k for k in range(3, 10) if 10**k <= steps), steps})


def _drift(found: dict[int, np.ndarray], n: int, k: int, kind: str, bodies: int) -> Drift:
    own = {step: drift[n][k * bodies : (k + 1) * bodies] for step, drift in found.items()}
    rms = {step: float(np.sqrt(np.mean(x**2))) for step, x in own.items()}
    slope = np.polyfit(np.log(list(rms)), np.log(list(rms.values())), 1)[0] if len(rms) > 1 else 0
    last = own[max(own)]
    mean = float(np.mean(last)) / rms[max(own)]
    return Drift(kind, ("H", "K^2")[n], rms, float(slope), mean)


def main() -> None:
    """Print the drifts as a table or as JSON."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("steps", nargs="?", type=int, default=STEPS)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    found = drifts(2000 if options.quick else options.steps)
    if options.json:
        print(json.dumps([asdict(one) for one in found], indent=1))
        return
    heads = " ".join(f"{step:8.0e}" for step in found[0].rms)
    print(f"{'':22} {heads}  slope   mean")
    print("\n".join(one.row() for one in found))


if __name__ == "__main__":
    main()
