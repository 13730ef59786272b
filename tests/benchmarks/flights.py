"""Error and time of a controlled flight by DOP853 and by splitting methods.

    nice uv run python tests/benchmarks/flights.py
    python tests/benchmarks/flights.py --quick              three seconds of flight, one rival

The paper's flight of a minute.  Kicks have the disturbances and the wheels: their torque, and the
gyroscopic one, which is linear in the rates, by Runge and Kutta's method of order four at fixed
attitude and time.  Times are of the processor, errors the largest rotation and difference of rates
from DOP853 at 1e-13; needs the extra `app` and a C compiler.
"""

import importlib
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import numpy as np

from rigidsym.manoeuvre._manoeuvre import open_manoeuvre
from rigidsym.manoeuvre._planning import solve
from rigidsym.manoeuvre.flight import Flight, Run
from rigidsym.manoeuvre.flight._rotation import cross, matrix
from rigidsym.manoeuvre.flight._settings import read
from rigidsym.splitting import METHODS
from rigidsym.splitting._stepping import Bodies, State

# The module, whose name is that of its function in the package.
fly = importlib.import_module("rigidsym.manoeuvre.flight._fly")
LENGTH = 60
WAYS = [
    ("dop853", 1),
    ("saba2", 1),
    ("aba84", 1),
    ("aba84", 2),
    ("aba84", 4),
    ("bm6", 1),
    ("bm6", 2),
]
Flown = Callable[..., np.ndarray | None]
BY_DOP853: Flown = fly._Loop.flown


def by_splitting(name: str, count: int) -> Flown:
    """Return a function that flies from one control sample to the next by splitting."""
    method = METHODS[name]

    def flown(loop, ramp):
        inertia, environment = loop.inertia, loop.environment
        bodies, h = Bodies(inertia, "c"), (ramp.end - ramp.begin) / count
        q, omega = ramp.now.state[:4], ramp.now.state[4:7]
        impulse, work = ramp.now.state[7:10], ramp.now.state[10]
        for k in range(count):
            into = 0.0
            for drift, kick in zip(method.drifts, method.kicks, strict=False):
                moved = bodies.drift(State(q, omega), drift * h)
                q, omega, into = moved.q, moved.omega, into + drift
                t, dt = ramp.begin + (k + into) * h, kick * h
                (torque, stored), outer = ramp.at(t), environment.total(t, q)
                after = _kicked(inertia, omega, torque + outer, stored, dt)
                impulse = impulse + dt * (matrix(q) @ outer)
                work = work + dt * ((omega + after) / 2 @ (torque + outer))
                omega = after
            moved = bodies.drift(State(q, omega), method.drifts[-1] * h)
            q, omega = moved.q, moved.omega
        return np.concatenate([q, omega, impulse, [work]])

    return flown


def _kicked(inertia, omega, torque, stored, dt):
    def rate(omega):
        return (torque - cross(omega, stored)) / inertia

    k1 = rate(omega)
    k2 = rate(omega + dt / 2 * k1)
    k3 = rate(omega + dt / 2 * k2)
    return omega + dt / 6 * (k1 + 2 * k2 + 2 * k3 + rate(omega + dt * k3))


def timed(flown: Flown, flight: Flight, plan) -> tuple[Run, float]:
    fly._Loop.flown = flown
    begin = time.process_time()
    run = fly.fly(plan.manoeuvre, flight, plan.best)
    return run, time.process_time() - begin


def main() -> None:
    """Print the errors and times of each method."""
    manoeuvre, tables = open_manoeuvre("paper")
    flight, plan = read(tables), solve(manoeuvre)
    quick = "--quick" in sys.argv
    length = Fraction(3 if quick else LENGTH)
    flight = replace(flight, run=replace(flight.run, length=length))
    tight = replace(flight, run=replace(flight.run, tolerance=1e-13))
    truth, _ = timed(BY_DOP853, tight, plan)
    print(f"{'':10}{'steps':>6}{'rotation':>12}{'rates':>10}{'time, s':>10}")
    for name, count in WAYS[:2] if quick else WAYS:
        flown = BY_DOP853 if name == "dop853" else by_splitting(name, count)
        run, seconds = timed(flown, flight, plan)
        rotation = np.max(2 * np.linalg.norm(run.q - truth.q, axis=1))
        rates = np.max(np.linalg.norm(run.omega - truth.omega, axis=1))
        print(f"{name:10}{count:6}{rotation:12.1e}{rates:10.1e}{seconds:10.2f}")


if __name__ == "__main__":
    main()
