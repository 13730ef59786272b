"""Time of the commands that prove, each in its own process, against its goal.

    python tests/benchmarks/proofs.py [ROUNDS]
    python tests/benchmarks/proofs.py --quick       one chapter, one round, goals not judged

Processor time is user and system time of a command and of all that it starts; it hardly depends on
what else the machine does.  The goals are for an idle machine of two cores.  They are compared with
the processor time, or with the time by the clock where that is less: `reproduce` uses both cores.
The rounds take turns, and the fastest counts.  The first also writes bytecode, which is kept in a
temporary folder; with --quick, bytecode stays where it is.
"""

import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path
from time import perf_counter

import bench

# The arguments of each command, and the seconds that it may take with the start of the interpreter;
# the campaign of all mutants has no goal.
COMMANDS = {
    "derive": (["derive"], 5.0),
    "derive --mutants": (["derive", "--mutants"], None),
    "check": (["check"], 3.0),
    "check --independent": (["check", "--independent"], 1.0),
    "reproduce": (["reproduce"], 15.0),
}
QUICK = {
    "derive euler_lax": (["derive", "euler_lax"], None),
    "check --independent": (["check", "--independent"], None),
}


def main() -> int:
    """Print the fastest and the slowest round of each command; return 1 where a goal is missed."""
    asked = bench.options(__doc__, 3)
    commands = QUICK if asked.quick else COMMANDS
    times = {name: [] for name in commands}
    with tempfile.TemporaryDirectory() as directory:
        environment = dict(os.environ)
        if not asked.quick:
            environment["PYTHONPYCACHEPREFIX"] = f"{directory}/bytecode"
            environment.pop("PYTHONDONTWRITEBYTECODE", None)
        for _ in range(asked.rounds):
            for name, (arguments, _) in commands.items():
                times[name].append(_seconds(arguments, Path(directory), environment))
    missed = False
    print(f"{'rigidsym':22}{'goal':>8}{'processor':>11}{'clock':>10}{'slowest clock':>15}")
    for name, (_, goal) in commands.items():
        processor, clock = map(min, zip(*times[name], strict=True))
        missed |= goal is not None and min(processor, clock) > goal
        told = "-" if goal is None else f"{goal:.1f} s"
        slowest = max(clock for _, clock in times[name])
        print(f"{name:22}{told:>8}{processor:9.2f} s{clock:8.2f} s{slowest:13.2f} s")
    return int(missed)


def _seconds(
    arguments: list[str], directory: Path, environment: dict[str, str]
) -> tuple[float, float]:
    """Return the processor's and the clock's seconds of a command that writes to a directory."""
    command = [sys.executable, "-m", "rigidsym", *arguments]
    command += ["-o", str(directory / arguments[0])] if arguments[0] != "check" else []
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), perf_counter()
    subprocess.run(command, check=True, capture_output=True, env=environment)
    clock, after = perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, clock


if __name__ == "__main__":
    sys.exit(main())
