"""Widths of the balls of uncertain inputs, over the ranges that the inputs leave open.

    python tests/benchmarks/uncertain.py [--quick]

The ratio of a state is the radius of a ball over half the range of 2000 motions of its box:
corners, points of faces and points inside, by the C engine in doubles.  It is taken of the widest
component of the attitude (q), of the widest component of the rates (omega), and of each of the
seven components by itself (each).  `missed` counts sampled values outside of their balls.  Seconds
are processor time, median and most.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from time import process_time

import bench
import numpy as np
from flint import arb

import rigidsym
from rigidsym import TorqueFreeMotion
from rigidsym._inputs import Uncertain, middle, radius

SAMPLES = 2000
# Parts of the largest moment and rate, and of 1 for the attitude.
WIDTHS = (1e-9, 1e-6, 1e-4, 1e-3, 1e-3, 3e-3, 8e-3, 1e-2)
TIMES = (0.4, 3, 6, 12, 25, 50, 100, 1000)
# Which numbers are uncertain: inertia, rates, attitude, or one of all.
KINDS = ("ir", "i", "r", "ira", "one")
# What doubles leave open, as a part of the size of a component; sampled ranges below say nothing.
ROUNDING = 4e-14
GOALS = "goals: median 1.5, worst 5, 1 s"


@dataclass(frozen=True)
class Measured:
    """Ratios of one state and its components, values missed, and processor time."""

    parts: tuple[float, float]
    components: tuple[float, ...]
    missed: int
    seconds: float


def _body(random: np.random.Generator) -> np.ndarray:
    moments = random.uniform(0.5, 1.5, 3)
    while 2 * max(moments) > sum(moments) * 0.98 or min(abs(np.diff(np.sort(moments)))) < 0.05:
        moments = random.uniform(0.5, 1.5, 3)
    return moments


def _middles(regime: str, random: np.random.Generator) -> tuple[np.ndarray, np.ndarray]:
    """Draw moments and rates in the middle of a box."""
    moments, rates = _body(random), random.uniform(-1, 1, 3)
    order = np.argsort(moments)
    if regime == "symmetric":
        moments[order[1]] = moments[order[random.choice([0, 2])]]
    elif regime == "near-symmetric":
        other = order[random.choice([0, 2])]
        moments[order[1]] = moments[other] * (1 + 10.0 ** random.uniform(-5, -2))
    elif regime == "sphere":
        moments[:] = moments[0]
    elif regime in ("middle-axis spin", "spin"):
        axis = order[1] if regime == "middle-axis spin" else order[random.choice([0, 2])]
        rates = np.where(np.arange(3) == axis, np.sign(rates) * 0.5 + rates / 2, 0)
    elif regime in ("separatrix", "near separatrix"):
        a, b, d = order[::-1]
        ratio = moments[d] * (moments[b] - moments[d]) / (moments[a] * (moments[a] - moments[b]))
        rates[a] = np.sign(rates[a]) * np.sqrt(ratio) * abs(rates[d])
        if regime == "near separatrix":
            rates[a] *= 1 + random.choice([-1, 1]) * 10.0 ** random.uniform(-5, -1)
    elif regime == "rest":
        rates[:] = 0
    return moments, rates


REGIMES = (
    *("general", "symmetric", "near-symmetric", "sphere", "middle-axis spin", "separatrix"),
    *("near separatrix", "spin", "rest"),
)


def boxes(regime: str, count: int, seed: int = 0) -> Iterator[TorqueFreeMotion]:
    """Yield motions whose inputs are boxes of a regime."""
    for k in range(count):
        random = np.random.default_rng([seed, REGIMES.index(regime), k])
        moments, rates = _middles(regime, random)
        width, kind = WIDTHS[k % len(WIDTHS)], KINDS[k % len(KINDS)]
        sizes = {"i": moments, "r": np.full(3, max(abs(rates)) or 1.0), "a": np.ones(4)}
        vectors = {"i": moments, "r": rates, "a": random.normal(size=4)}
        vectors["a"] /= np.linalg.norm(vectors["a"])
        single = ("i" if regime != "rest" else "r", random.integers(3))
        given = []
        for name, values in vectors.items():
            radii = width * sizes[name] * random.uniform(0.3, 1, len(values))
            if kind == "one":
                radii *= [(name, j) == single for j in range(len(values))]
            elif name not in (kind if regime != "rest" else "r" + kind):
                radii *= 0
            given.append(
                [
                    Uncertain(Fraction(x), Fraction(r)) if r else Fraction(x)
                    for x, r in zip(values.tolist(), radii.tolist(), strict=True)
                ]
            )
        yield TorqueFreeMotion(*given, allow_nonphysical=True)


def samples(motion: TorqueFreeMotion, count: int, seed: int = 1) -> np.ndarray:
    """Draw inputs (count, 10) in a box: at corners, on faces and inside."""
    random = np.random.default_rng(seed)
    given = (*motion.inertia, *motion.omega0, *motion.attitude0)
    middles, radii = (np.array([float(f(x)) for x in given]) for f in (middle, radius))
    inside = random.uniform(-1, 1, (count, 10))
    signs = np.sign(inside)
    corners, faces = np.arange(count) % 4 < 2, np.arange(count) % 4 == 2
    shift = np.where(corners[:, None], signs, inside)
    on_face = random.choice([0, 1, 2], (count, 10))
    shift = np.where(faces[:, None], np.choose(on_face, [inside, signs, 0 * inside]), shift)
    # A little inside, so that rounding to doubles does not lead out of the box.
    return middles + shift * radii * (1 - 1e-7)


def ranges(motion: TorqueFreeMotion, times: tuple[float, ...], count: int) -> np.ndarray:
    """Return states (count, N, 7) of sampled motions in doubles."""
    found = samples(motion, count)
    inertia, omega, attitude = found[:, :3], found[:, 3:6], found[:, 6:]
    states = rigidsym.propagate(
        inertia, omega, np.array(times), attitude, engine="c", allow_nonphysical=True
    )
    return np.concatenate(states, axis=2)


def measured(motion: TorqueFreeMotion, time: float, states: np.ndarray) -> Measured:
    """Compare the ball of one state with the states (count, 7) of sampled motions."""
    start = process_time()
    balls = [x for part in motion.enclose(time, 15) for x in part]
    seconds = process_time() - start
    middles, radii = (np.array([float(f(x)) for x in balls]) for f in (arb.mid, arb.rad))
    half = (states.max(0) - states.min(0)) / 2
    size = np.array([1.0] * 4 + [max(abs(states[:, 4:]).max(), 1e-300)] * 3)
    allowance = ROUNDING * size * (1 + abs(time))
    missed = int((abs(states - middles) > radii + allowance).sum())
    known = half > 1e3 * allowance
    components = tuple(np.where(known, radii / np.where(known, half, 1), np.nan).tolist())
    q, omega = (
        float(max(radii[part]) / max(half[part])) if known[part].any() else np.nan
        for part in (slice(4), slice(4, 7))
    )
    return Measured((q, omega), components, missed, seconds)


def main() -> None:
    """Print a line for each regime, and one for all of them."""
    options = bench.options(
        __doc__,
        boxes={"type": int, "default": 8, "help": "of each regime"},
        regime={"choices": REGIMES, "nargs": "+", "default": REGIMES},
        each={"action": "store_true", "help": "print a line for each state, too"},
    )
    count, most, times = (1, 200, TIMES[1:2]) if options.quick else (options.boxes, SAMPLES, TIMES)
    head = f"{'':18}{'states':>7}{'q':>8}{'worst':>9}{'omega':>8}{'worst':>9}"
    print(head + f"{'each':>8}{'worst':>9}{'missed':>8}{'seconds':>9}{'most':>7}")
    everything: list[Measured] = []
    for regime in options.regime:
        found = []
        for k, motion in enumerate(boxes(regime, count)):
            states = ranges(motion, times, most)
            for j, time in enumerate(times):
                found.append(measured(motion, time, states[:, j]))
                if options.each:
                    one = found[-1]
                    print(
                        f"  {k} {WIDTHS[k % len(WIDTHS)]:.0e} {KINDS[k % len(KINDS)]:4}{time:7}"
                        f"{one.parts[0]:9.2f}{one.parts[1]:9.2f}"
                        f" each {np.nanmax([*one.components, 0]):9.2f} {one.missed:3}"
                        f"{one.seconds:7.2f} s",
                        flush=True,
                    )
        _show(regime, found)
        everything += found
    _show("all", everything)
    print(GOALS)


def _show(name: str, found: list[Measured]) -> None:
    line = f"{name:18}{len(found):7}"
    for values in (
        *zip(*(x.parts for x in found), strict=True),
        [y for x in found for y in x.components],
    ):
        known = [x for x in values if not np.isnan(x)] or [np.nan]
        line += f"{np.median(known):8.2f}{max(known):9.2f}"
    seconds = [x.seconds for x in found]
    missed = sum(x.missed for x in found)
    print(f"{line}{missed:8}{np.median(seconds):9.2f}{max(seconds):7.2f}", flush=True)


if __name__ == "__main__":
    main()
