"""How long the proofs take, each command in a process of its own, against its goal.

    python tests/benchmarks/proofs.py [ROUNDS]

The rounds take turns, so that a busy minute of the machine spoils one round and not one command;
the max_rate round counts.
"""

import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

# Seconds that the command may take, start of the interpreter included.
GOALS = {
    "derive": (["derive", "-o"], 10.0),
    "check": (["check"], 2.0),
    "check --independent": (["check", "--independent"], 1.0),
}


def main(rounds: int) -> int:
    """Print the max_rate and the slowest round of each command; 1 where a goal is missed."""
    with tempfile.TemporaryDirectory() as directory:
        ledger = str(Path(directory) / "ledger.json")
        times = {name: [] for name in GOALS}
        for _ in range(rounds):
            for name, (arguments, _) in GOALS.items():
                times[name].append(
                    _seconds([*arguments, ledger] if name == "derive" else arguments)
                )
    print(f"{'rigidsym':22}{'goal':>8}{'max_rate':>9}{'slowest':>9}{'used':>7}")
    for name, (_, goal) in GOALS.items():
        max_rate, slowest = min(times[name]), max(times[name])
        print(f"{name:22}{goal:6.1f} s{max_rate:7.2f} s{slowest:7.2f} s{max_rate / goal:7.0%}")
    return int(any(min(times[name]) > goal for name, (_, goal) in GOALS.items()))


def _seconds(arguments: list[str]) -> float:
    start = perf_counter()
    command = [sys.executable, "-m", "rigidsym", *arguments]
    subprocess.run(command, check=True, capture_output=True)
    return perf_counter() - start


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 5))
