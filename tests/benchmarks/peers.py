"""Time of a 50-digit state of the paper's motion, beside other programs.

    python tests/benchmarks/peers.py            heyoka (extra `bench`), at t = 1000 s
    python tests/benchmarks/peers.py --odefun   mpmath.odefun too, at t = 100 s: a minute
    python tests/benchmarks/peers.py --quick    to shorter times, goals not judged

Each peer integrates (3) and (5) to the same digits; heyoka's compilation is not counted.
"""

import sys
from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from timeit import repeat, timeit

import mpmath
from bench import heyoka_system

from rigidsym import TorqueFreeMotion
from rigidsym.validate.peers._integrators import rates

INERTIA, OMEGA0, START = ("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.02"), (1, 0, 0, 0)
DIGITS, BITS = 50, 190


def main(names: list[str], quick: bool) -> int:
    """Print each peer's time and its ratio to ours; return 1 where a goal is missed."""
    missed = False
    for name in names:
        if not find_spec(name.partition(".")[0]):
            print(f"{name} is not installed (extra bench): it is left out")
            continue
        peer, time, goal = PEERS[name]
        time = max(1, time // 500) if quick else time
        ours = min(repeat(partial(_ours, time), number=1, repeat=20))
        seconds, state = peer(time)
        with mpmath.workdps(DIGITS + 10):
            gap = max(abs(x - y) for x, y in zip(state, _ours(time), strict=True))
        print(
            f"t = {time:<6}rigidsym {1000 * ours:.2f} ms, {name} {1000 * seconds:.0f} ms: "
            f"{seconds / ours:.0f} times as long (goal {goal}), difference {mpmath.nstr(gap, 2)}"
        )
        missed |= seconds < goal * ours
    return int(missed and not quick)


def _ours(time: int) -> list:
    q, omega = TorqueFreeMotion(INERTIA, OMEGA0).precise(time, DIGITS)
    return [*q, *omega]


def heyoka(time: int) -> tuple:
    """Return the time and state of heyoka's Taylor integrator in multiprecision."""
    import heyoka as hy

    def real(text):
        return hy.real(str(text), BITS)

    _, system = heyoka_system(list(map(real, INERTIA)), real("0.5"))
    start = [real(x) for x in (*START, *OMEGA0)]
    integrator = hy.taylor_adaptive(
        system, start, fp_type=hy.real, prec=BITS, tol=real(f"1e-{DIGITS + 2}"), compact_mode=True
    )

    def run():
        integrator.time = real(0)
        integrator.state[:] = start
        integrator.propagate_until(real(time))

    seconds = min(repeat(run, number=1, repeat=3))
    with mpmath.workdps(DIGITS + 10):
        return seconds, [mpmath.mpf(str(x)) for x in integrator.state]


def odefun(time: int) -> tuple:
    """Return the time and state of mpmath's Taylor integrator."""
    with mpmath.workdps(DIGITS):
        c, half = [mpmath.mpf(x) for x in INERTIA], mpmath.mpf("0.5")
        start = [mpmath.mpf(x) for x in (*START, *OMEGA0)]
        found = []
        solution = mpmath.odefun(lambda _, y: rates(y, c, half), 0, start)
        seconds = timeit(lambda: found.extend(solution(time)), number=1)
    return seconds, found


# By name: what runs it, to which time, and how many times as long it has to take.
PEERS: dict[str, tuple[Callable, int, int]] = {
    "heyoka": (heyoka, 1000, 100),
    "mpmath.odefun": (odefun, 100, 50_000),
}


if __name__ == "__main__":
    asked = ["heyoka", *(["mpmath.odefun"] if "--odefun" in sys.argv else [])]
    sys.exit(main(asked, "--quick" in sys.argv))
