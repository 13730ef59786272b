"""Hashes of the states of a fixed set of motions, by C without fused multiply-add.

This arithmetic has the same bits on every processor and from every compiler, and so have the
languages in `SAME_BITS` of the engines.  `same_bits/` holds the motions and their hashes in files
that programs in any language can read:

    motions.txt    a line `= stratum`, then a line for each of its motions: inertia (3), omega0
                   (3), attitude0 (4), the time of a step, and times up to 1e9 s, each double as 16
                   hexadecimal digits of its bits
    expected.txt   for each stratum the hashes of states, steps and sensitivities, and its name

A hash h starts as 0 and takes the 64 bits x of one double after the other, modulo 2^64: h becomes
(h xor x) times FACTOR, then h xor h >> 32.  NaN counts as 7ff8000000000000.  States and steps are
q (n, 4) and omega (n, 3) of each motion at its n times, or after its step from the start;
sensitivities are the four arrays of `torque_free_states_with_sensitivity`.
"""

from collections.abc import Iterable
from functools import reduce
from importlib import resources
from typing import Any

import numpy as np

from rigidsym import _engines as engines
from rigidsym.io._files import write_text
from rigidsym.validate.strata import STRATA, count, draw, stepped

FACTOR, _MODULUS, _NAN = 0x9E3779B97F4A7C15, 1 << 64, 0x7FF8000000000000
KINDS = ("states", "steps", "sensitivities")
_FOLDER = resources.files("rigidsym.validate") / "same_bits"
# Motions of a stratum, times of a motion, and the latest of these, s.
_CASES, _TIMES, _LATEST = 6, 8, 1e9


def hashes(strata: Iterable[str] = tuple(STRATA), language: str = "c") -> dict[str, str]:
    """Compute the lines of some strata in expected.txt, by name.

    Languages other than C compute no sensitivities.  Raises InputError without a C compiler, or
    without what runs the language.
    """
    if language == "c":
        engine, stepper = engines.exactly(engines.PORTABLE), engines.stepper(engines.PORTABLE)
    else:
        engine, stepper = engines.exactly(language), engines.exact_stepper(f"{language}-step")
    every, found = motions(), {}
    for stratum in strata:
        hashed = dict.fromkeys(KINDS if engine.has_sensitivities else KINDS[:2], 0)
        for numbers in every[stratum]:
            inertia, omega0, q0, dt, times = np.split(numbers, [3, 6, 10, 11])
            prepared = engine.prepare(inertia, omega0, q0)
            after = q0[None].copy(), omega0[None].copy()
            stepper.step(inertia[None], *after, dt, after)
            values = {
                "states": engine.states(prepared, times),
                "steps": after,
            }
            if "sensitivities" in hashed:
                values["sensitivities"] = engine.sensitivities(prepared, times, "nan")[2:]
            hashed = {kind: mixed(hashed[kind], values[kind]) for kind in hashed}
        found[stratum] = " ".join((*(f"{x:016x}" for x in hashed.values()), stratum))
    return found


def mixed(start: int, arrays: Iterable[np.ndarray]) -> int:
    """Return a hash after the bits of some arrays, one double after the other."""
    numbers = np.concatenate([x.reshape(-1) for x in arrays])
    bits = np.where(np.isnan(numbers), np.uint64(_NAN), numbers.view(np.uint64)).tolist()

    def next_hash(h: int, x: int) -> int:
        h = (h ^ x) * FACTOR % _MODULUS
        return h ^ h >> 32

    return reduce(next_hash, bits, start)


def differences(strata: Iterable[str], language: str = "c") -> tuple[str, ...]:
    """Return a line for each of the strata whose bits in a language are not the expected ones."""
    wanted, lines, of = expected(), [], "" if language == "c" else f" of {language}"
    for stratum, line in hashes(strata, language).items():
        due = wanted.get(stratum, "").split()[:3] or ["none"] * 3
        found = line.removesuffix(stratum).split()
        for kind, was, now in zip(KINDS, due, found, strict=False):
            if was != now:
                said = f"the hash of {kind} is {now}, expected {was}"
                lines.append(f"same bits{of}: {stratum}: {said}")
    return tuple(lines)


def expected() -> dict[str, str]:
    """Read the line of each stratum in expected.txt, by name."""
    lines = (_FOLDER / "expected.txt").read_text("utf-8").splitlines()
    return {line.split(maxsplit=3)[3]: line for line in lines}


def record() -> None:
    """Write expected.txt anew, for code that has other bits on purpose."""
    with resources.as_file(_FOLDER / "expected.txt") as path:
        write_text(path, "".join(f"{line}\n" for line in hashes().values()))


def motions() -> dict[str, list[np.ndarray]]:
    """Read the numbers of the motions of each stratum in motions.txt."""
    found, numbers = dict[str, list[np.ndarray]](), list[np.ndarray]()
    for line in (_FOLDER / "motions.txt").read_text("utf-8").splitlines():
        if line.startswith("= "):
            numbers = found[line[2:]] = []
        else:
            numbers.append(np.array([int(x, 16) for x in line.split()], np.uint64).view(float))
    return found


def drawn_motions() -> str:
    """Draw the text of motions.txt: the first motions of each stratum, at times C accepts."""
    # Only C's engine has a library.
    engine: Any = engines.exactly(engines.PORTABLE)
    lines = []
    for stratum in STRATA:
        lines.append(f"= {stratum}")
        for index in range(count(stratum, _CASES)):
            sample = draw(stratum, index, 1)
            body = [np.array(x, float) for x in (sample.inertia, sample.omega0, sample.attitude0)]
            latest = min(_LATEST, engine.library.last_time(engine.prepare(*body)))
            times = sorted((t for t in sample.times if abs(t) <= latest), key=abs)
            some = [times[k * (len(times) - 1) // (_TIMES - 2)] for k in range(_TIMES - 1)]
            dt = stepped(sample).times[1 + index % _TIMES]
            numbers = np.hstack([*body, dt, *some, (-1) ** index * latest])
            lines.append(" ".join(f"{x:016x}" for x in numbers.view(np.uint64).tolist()))
    return "".join(f"{line}\n" for line in lines)
