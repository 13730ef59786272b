"""Engines of targets that run in a process of their own, which is asked through pipes.

A target brings the command that starts the process, in its folder of `rigidsym._codegen.targets`:
`server.command(module, home, cache)` returns it, or raises InputError where it cannot run on this
machine.

The process first writes a line of JSON, the field and the rule of each code.  A question is five
doubles (its kind, the number of bodies B and of times N, the stride from a body's times to the
next one's, and whether refused bodies and times have states of NaN), then arrays of doubles:

* kind 0: inertia (B, 3), omega0 (B, 3), attitude0 (B, 4), t (N) or (B, N)
* kind 1: inertia (3, 2), differences (3, 2), omega0 (3, 2), attitude0 (4, 2), discriminant (2),
  unit, t (N)
* kind 2, a step: inertia (B, 3), q (B, 4), omega (B, 3), dt (B)

The answer is a code, the body that it is about, and the last time of the last motion, then q
(B, N, 4) and omega (B, N, 3), or for steps (B, 4) and (B, 3).
"""

import json
import os
import subprocess
import tempfile
import threading
import weakref
from collections.abc import Iterable, Sequence
from contextlib import suppress
from importlib import resources
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from rigidsym._codegen.forms import split
from rigidsym._codegen.targets import server
from rigidsym._engines import arrays
from rigidsym._engines.arrays import Batch, Outputs, Sensitivities, States
from rigidsym._engines.base import Engine
from rigidsym._engines.build import CacheError, cache_directory
from rigidsym._engines.steps import Moments, Stepper
from rigidsym.errors import EngineError, InputError

if TYPE_CHECKING:
    from rigidsym._engines.exact_inputs import ExactInputs

_MOTIONS, _EXACT, _STEPS = range(3)
_INSTALLED = resources.files("rigidsym.generated")


class Prepared(NamedTuple):
    """Inputs of a motion, with the kind of question that they are for, and its last time."""

    kind: int
    numbers: np.ndarray
    last: float


class _Process:
    """Process that answers one question at a time; each process of Python has its own."""

    def __init__(self, name: str, home: Traversable) -> None:
        target, _ = split(name)
        try:
            cache = cache_directory()
        except CacheError:
            cache = Path(tempfile.gettempdir(), "rigidsym")
        # What was changed on purpose is built beside its files, and goes with them.
        cache = home if home != _INSTALLED and isinstance(home, Path) else cache
        self._command = server(target)(name, home, cache)
        self._lock, self._owner = threading.Lock(), 0
        self._start()

    def _start(self) -> None:
        pipe = subprocess.PIPE
        process = subprocess.Popen(self._command, stdin=pipe, stdout=pipe)
        self._owner = os.getpid()
        weakref.finalize(self, _end, process, self._owner)
        assert process.stdin is not None
        assert process.stdout is not None
        self._process, self._pipes = process, (process.stdin, process.stdout)
        line = process.stdout.readline()
        if not line:
            raise InputError("engine", " ".join(self._command), "does not start")
        self.words: list[tuple[str, str]] = json.loads(line)

    def ask(
        self, question: Sequence[float], given: Iterable[np.ndarray], shape: tuple[int, ...]
    ) -> tuple[int, int, float, np.ndarray, np.ndarray]:
        """Return code, body, last time, q (*shape, 4) and omega (*shape, 3)."""
        count = int(np.prod(shape))
        parts = [np.ascontiguousarray(x, float).tobytes() for x in (question, *given)]
        with self._lock:
            if self._owner != os.getpid():
                # That of the parent is not this process's to wait for.
                self._process.returncode = 0
                self._start()
            given_to, taken_from = self._pipes
            try:
                given_to.write(b"".join(parts))
                given_to.flush()
                answer = taken_from.read(8 * (3 + 7 * count))
            except BrokenPipeError:
                answer = b""
        if len(answer) < 8 * (3 + 7 * count):
            raise EngineError("engine", f"{' '.join(self._command)} has ended")
        (code, body, last), states = np.split(np.frombuffer(answer), [3])
        q, omega = np.split(states, [4 * count])
        return int(code), int(body), float(last), q.reshape(*shape, 4), omega.reshape(*shape, 3)


def _end(process: "subprocess.Popen[bytes]", owner: int) -> None:
    """End a process, which does so when its input ends, unless it is that of another process."""
    if os.getpid() == owner:
        with suppress(BrokenPipeError):
            process.communicate()


class PipedEngine(Engine):
    """Engine that computes states in another process.  It has no sensitivities."""

    __slots__ = ("_process",)

    def __init__(self, name: str, home: Traversable = _INSTALLED) -> None:
        self._process = _Process(name, home)

    @property
    def has_sensitivities(self) -> bool:
        """False: the process computes no derivatives."""
        return False

    def prepare(self, inertia: ArrayLike, omega0: ArrayLike, attitude0: ArrayLike) -> Prepared:
        """Check the inputs of one motion, and copy them."""
        given = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0}
        bodies = {name: np.array(value, float) for name, value in given.items()}
        for name, array in bodies.items():
            if array.shape != (arrays.SIZES[name],):
                rule = f"shape {array.shape}: one body's must be {(arrays.SIZES[name],)}"
                raise EngineError(name, rule)
            if not np.all(np.isfinite(array)):
                raise EngineError(name, "every number must be finite")
        return self._checked(_MOTIONS, np.concatenate([*bodies.values()]))

    def _prepare_pairs(self, given: "ExactInputs") -> Prepared:
        numbers = [np.ravel(np.array(x, float)) for x in given]
        return self._checked(_EXACT, np.concatenate(numbers))

    def _checked(self, kind: int, numbers: np.ndarray) -> Prepared:
        code, _, last, *_ = self._process.ask((kind, 1, 0, 0, 0), [numbers], (0,))
        if code:
            field, rule = self._process.words[code]
            raise EngineError(field or "engine", rule)
        return Prepared(kind, numbers, last)

    def states(
        self, prepared: Prepared, t: ArrayLike, out: Outputs = None, errors: str = "raise"
    ) -> States:
        """Compute states at times by the process."""
        times = arrays.times(t)
        found = arrays.outputs(out, times.shape, times)
        flat = times.reshape(-1)
        near = np.isfinite(flat) & (np.abs(flat) <= prepared.last)
        asked = np.where(near, flat, 0.0) if arrays.is_lenient(errors) else flat
        question = prepared.kind, 1, flat.size, 0, 0
        code, _, _, *states = self._process.ask(question, [prepared.numbers, asked], times.shape)
        if code:
            raise self._refused(code, flat, near, prepared.last)
        for array, values in zip(found, states, strict=True):
            array[...] = values
            array.reshape(flat.size, -1)[~near] = np.nan
        return found

    def _refused(self, code: int, t: np.ndarray, near: np.ndarray, last: float) -> EngineError:
        """Return the exception for refused times, with the index of the first."""
        infinite, late = np.flatnonzero(~np.isfinite(t)), np.flatnonzero(~near)
        if infinite.size:
            return EngineError("t", arrays.BAD_TIMES, time=int(infinite[0]))
        _, rule = self._process.words[code]
        if "separatrix" in rule:
            rule = f"nearer to the separatrix than binary64 can follow beyond {last} s"
        return EngineError("t", rule, time=int(late[0]))

    def sensitivities(
        self,
        prepared: Prepared,
        t: ArrayLike,
        errors: str = "raise",
        columns: Iterable[str] | None = None,
    ) -> Sensitivities:
        """Raise EngineError: the process computes no derivatives."""
        self._check_has_sensitivities()
        raise NotImplementedError

    def grid(
        self, prepared: Prepared, start: float, step: float, count: int, out: Outputs = None
    ) -> States:
        """Compute states at the doubles nearest to the times start + k step."""
        return self.states(prepared, start + step * np.arange(count), out)

    def _fill(
        self,
        batch: Batch,
        found: States | Sensitivities,
        lenient: bool,
        columns: tuple[str, ...] | None,
    ) -> None:
        t, count = batch.times, batch.number
        bodies = [arrays.rows(array, batch.leading) for array in batch.bodies.values()]
        stride = t.shape[1] if len(t) > 1 else 0
        question = _MOTIONS, count, t.shape[1], stride, lenient
        code, body, _, *states = self._process.ask(question, [*bodies, t], batch.shape)
        if code:
            try:
                own = t[body if stride else 0]
                self.states(self.prepare(*(array[body] for array in bodies)), own)
            except EngineError as error:
                raise EngineError(error.field, error.rule, body, error.time) from None
            raise AssertionError("a body that was refused is not")
        for array, values in zip(found, states, strict=True):
            array[...] = values


class PipedStepper(Stepper):
    """Stepper that advances bodies in another process."""

    __slots__ = ("_process",)

    def __init__(self, name: str, home: Traversable = _INSTALLED) -> None:
        self._process = _Process(name, home)

    def _ask(self, *given: np.ndarray) -> tuple[int, int, np.ndarray, np.ndarray]:
        count = len(given[1])
        question = _STEPS, count, 1, 0, 0
        code, body, _, q, omega = self._process.ask(question, given, (count,))
        return code, body, q, omega

    def _steps(
        self, inertia: np.ndarray, q: np.ndarray, omega: np.ndarray, dt: np.ndarray, out: States
    ) -> None:
        count = len(q)
        moments, times = np.broadcast_to(inertia, (count, 3)), np.broadcast_to(dt, (count,))
        code, body, *after = self._ask(moments, q, omega, times)
        if code:
            field, rule = self._process.words[code]
            raise EngineError(field or "omega", rule, body)
        for array, values in zip(out, after, strict=True):
            array[...] = values

    def one(
        self,
        inertia: Moments,
        q: Sequence[float],
        omega: Sequence[float],
        dt: float,
        out: Outputs = None,
    ) -> States | None:
        """Advance one body by one time step in the process.

        Returns None for a body that it refuses.
        """
        given = (np.array([x], float) for x in (inertia, q, omega))
        code, _, q_after, omega_after = self._ask(*given, np.array([dt], float))
        if code:
            return None
        if out is None:
            return q_after[0].copy(), omega_after[0].copy()
        out[0][...], out[1][...] = q_after[0], omega_after[0]
        return out
