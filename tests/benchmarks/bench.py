"""Options of benchmarks, and heyoka's equations of motion."""

import argparse
from collections.abc import Mapping
from importlib.util import find_spec
from typing import Any

from rigidsym.validate.peers._integrators import rates

HEYOKA = find_spec("heyoka") is not None


def options(doc: str, rounds: int = 0, **more: Mapping[str, Any]) -> argparse.Namespace:
    """Parse --quick, a number of rounds, which is 1 if it is quick, and more options by name."""
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("--quick", action="store_true")
    if rounds:
        parser.add_argument("rounds", nargs="?", type=int, default=rounds)
    for name, settings in more.items():
        parser.add_argument(f"--{name}", **settings)
    found = parser.parse_args()
    if rounds and found.quick:
        found.rounds = 1
    return found


def say_if_heyoka_is_missing() -> None:
    """Print that heyoka's rows are left out, if it is not installed."""
    if not HEYOKA:
        print("heyoka is not installed (extra bench): its rows are left out")


def heyoka_system(moments: Any, half: Any = 0.5) -> tuple[list[Any], list[tuple[Any, Any]]]:
    """Return heyoka's names of q and omega, and each name with its derivative."""
    import heyoka as hy

    names = list(hy.make_vars("q0", "q1", "q2", "q3", "w1", "w2", "w3"))
    return names, list(zip(names, rates(names, moments, half), strict=True))
