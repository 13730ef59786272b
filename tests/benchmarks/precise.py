"""Time that certain digits take, against their goals, against digits and against time.

    python tests/benchmarks/precise.py [ROUNDS]
    python tests/benchmarks/precise.py --quick      at most 1500 digits, one round, goals not judged

The rounds take turns, so that a busy minute of the machine spoils one round and not one figure;
the fastest round counts.  The motion is the paper's.
"""

import sys
from fractions import Fraction
from timeit import timeit

import bench

from rigidsym.precise import PreciseMotion

INERTIA, OMEGA0 = ("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02")
EXACT = tuple(tuple(map(Fraction, x)) for x in (INERTIA, OMEGA0, (1, 0, 0, 0)))
# Milliseconds that a new motion, and one more state of it, may take, by digits.
SET_UP = (50, 2.0)
STATES = {50: 0.2, 1000: 3.0, 10_000: 250.0}
DIGITS = (15, 50, 150, 500, 1500, 5000, 10_000)
EXPONENTS = (0, 3, 6, 9, 12, 15)


def main() -> int:
    """Print every figure; return 1 where a goal is missed."""
    asked = bench.options(__doc__, 3)
    quick, rounds = asked.quick, asked.rounds
    most = 1500 if quick else max(DIGITS)
    sizes = [d for d in sorted({*DIGITS, *STATES, SET_UP[0]}) if d <= most]
    cold, warm = _rounds(rounds, [(180, d) for d in sizes])
    figures = [(f"set-up, {SET_UP[0]} digits", SET_UP[1], cold[180, SET_UP[0]])]
    figures += [
        (f"one state, {d} digits", goal, warm[180, d]) for d, goal in STATES.items() if d <= most
    ]
    print(f"{'t = 180 s':26}{'goal':>12}{'fastest':>12}{'used':>7}")
    for name, goal, found in figures:
        print(f"{name:26}{goal:9.2f} ms{found:9.3f} ms{found / goal:7.0%}")

    print(f"\n{'one state at t = 180 s':26}{'fastest':>12}")
    for digits in (d for d in DIGITS if d <= most):
        print(f"{digits:7} digits            {warm[180, digits]:9.3f} ms")

    _, by_time = _rounds(rounds, [(10**k, 50) for k in EXPONENTS])
    print(f"\n{'one state, 50 digits':26}{'fastest':>12}")
    for k in EXPONENTS:
        print(f"t = 1e{k:<2} s                 {by_time[10**k, 50]:9.3f} ms")

    return int(not quick and any(found > goal for _, goal, found in figures))


def _rounds(rounds, settings):
    """Return the fastest times of a set-up and of one more state, ms, by t and digits."""
    cold, warm = {}, {}
    for _ in range(rounds):
        for t, digits in settings:
            times = [Fraction(t) + Fraction(k, 7) for k in range(2 if digits > 2000 else 6)]
            states = PreciseMotion(*EXACT).states(times, digits)
            first, *rest = (1000 * timeit(states.__next__, number=1) for _ in times)
            for found, value in ((warm, min(rest)), (cold, max(first - min(rest), 0.0))):
                found[t, digits] = min(found.get((t, digits), value), value)
    return cold, warm


if __name__ == "__main__":
    sys.exit(main())
