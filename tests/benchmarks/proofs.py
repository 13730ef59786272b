"""How long the proofs take, each command in a process of its own, against its goal.

    python tests/benchmarks/proofs.py [ROUNDS]
    python tests/benchmarks/proofs.py --quick       one chapter, one round, goals not judged

The rounds take turns, so that a busy minute of the machine spoils one round and not one command;
the fastest round counts.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

# Seconds that the command may take, start of the interpreter included.
GOALS = {"derive": 10.0, "check": 2.0, "check --independent": 1.0}


def main() -> int:
    """Print the fastest and the slowest round of each command; return 1 where a goal is missed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("rounds", nargs="?", type=int, default=5)
    parser.add_argument("--quick", action="store_true")
    options = parser.parse_args()
    quick, rounds = options.quick, 1 if options.quick else options.rounds
    times = {name: [] for name in GOALS}
    with tempfile.TemporaryDirectory() as directory:
        ledger = str(Path(directory) / "ledger.json")
        derived, checked = (["euler_lax"], [ledger, "--facts"]) if quick else ([], [])
        for _ in range(rounds):
            for name in GOALS:
                more = [*derived, "-o", ledger] if name == "derive" else checked
                times[name].append(_seconds([*name.split(), *more]))
    print(f"{'rigidsym':22}{'goal':>8}{'fastest':>9}{'slowest':>9}{'used':>7}")
    for name, goal in GOALS.items():
        fastest, slowest = min(times[name]), max(times[name])
        print(f"{name:22}{goal:6.1f} s{fastest:7.2f} s{slowest:7.2f} s{fastest / goal:7.0%}")
    return int(not quick and any(min(times[name]) > goal for name, goal in GOALS.items()))


def _seconds(arguments: list[str]) -> float:
    start = perf_counter()
    command = [sys.executable, "-m", "rigidsym", *arguments]
    subprocess.run(command, check=True, capture_output=True)
    return perf_counter() - start


if __name__ == "__main__":
    sys.exit(main())
