"""States of one motion to any number of digits, by mpmath.

Inputs are exact rationals, and the invariants, the parameter m and the regime are computed
exactly.  The rest is evaluated at two working precisions, which rise until both agree to the
digits asked for: a strong check, though not a proof.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

from mpmath import mp
from mpmath.ctx_mp import MPContext

from rigidsym.errors import PrecisionError
from rigidsym.precise.functions import EllipticFunctions
from rigidsym.solution import sealed
from rigidsym.solution.expression import evaluate, names
from rigidsym.solution.formulas import AXES
from rigidsym.solution.polhode import Polhode, Regime, classify

GUARD_DIGITS = 12
MOST_ROUNDS = 12
# A number that shrinks with the working precision for this many rounds is zero.
ZERO_ROUND = 5

State = tuple[list[Any], list[Any]]


@dataclass(frozen=True)
class PreciseMotion:
    """A motion given exactly: inertia (3), body rates (3) and attitude (4) as rationals."""

    inertia: tuple[Fraction, ...]
    omega0: tuple[Fraction, ...]
    attitude0: tuple[Fraction, ...]

    @cached_property
    def polhode(self) -> Polhode:
        """Regime and axes, decided exactly."""
        return classify(self.inertia, self.omega0)

    def states(self, times: Sequence[Fraction], digits: int) -> Iterator[State]:
        """(q, omega) at each time as mpf numbers, `digits` significant digits each.

        Raises PrecisionError where the working precision had to be raised too often.
        """
        evaluations: dict[int, Evaluation] = {}
        for time in times:
            what = f"t = {time}"
            numbers = self._rise(lambda e, t=time: e.numbers(t), digits, evaluations, what)
            yield numbers[:4], numbers[4:]

    def start(self, digits: int) -> list[float]:
        """The attitude at t = 0, normalised and rounded to doubles."""
        return [float(x) for x in Evaluation(self, digits).start[0]]

    def constants(self, names: Sequence[str], digits: int) -> dict[str, Any]:
        """Constants of the motion by name, `digits` digits each; the rates must not be constant."""
        numbers = self._rise(lambda e: [e.constant(n) for n in names], digits, {}, "constants")
        return dict(zip(names, numbers, strict=True))

    def _rise(
        self,
        read: Callable[["Evaluation"], list[Any]],
        digits: int,
        evaluations: dict[int, "Evaluation"],
        what: str,
    ) -> list[Any]:
        """Read numbers at rising precision until two rounds agree; rounds are kept and shared."""
        rough: list[Any] | None = None
        for round_ in range(MOST_ROUNDS):
            if round_ not in evaluations:
                evaluations[round_] = Evaluation(self, _working_digits(digits, round_))
            fine = read(evaluations[round_])
            settled = rough and _settled(rough, fine, digits, round_ >= ZERO_ROUND)
            if settled:
                return settled
            rough = fine
        raise PrecisionError(f"{what}: not settled to {digits} digits")


class Evaluation:
    """The formulas of the solution at one working precision, with the constants of one motion."""

    def __init__(self, motion: PreciseMotion, digits: int) -> None:
        self.ctx = MPContext()
        self.ctx.dps = digits
        self.motion = motion
        self.functions = EllipticFunctions(self.ctx).table()
        norm = self.ctx.sqrt(sum(x * x for x in motion.attitude0))
        attitude = [self._number(x) / norm for x in motion.attitude0]
        self.start = (attitude, list(map(self._number, motion.omega0)))

    def _number(self, value: Any) -> Any:
        return self.ctx.convert(value)

    def numbers(self, time: Fraction) -> list[Any]:
        """The four numbers of q and the three of omega at one time."""
        q, omega = self.state(time)
        return [*q, *omega]

    def state(self, time: Fraction) -> State:
        """(q, omega) at one time; the given state itself at t = 0."""
        if time == 0 or self.motion.polhode.regime == Regime.REST:
            return self.start
        return self._steady(time) if self.motion.polhode.regime.steady else self._moving(time)

    def _run(self, programme: str, values: Mapping[str, Any]) -> dict[str, Any]:
        """Every formula of a programme; exactly, as long as all it uses is rational."""
        known = dict(values)
        for formula in sealed().programmes[programme]:
            used = {name: known[name] for name in names(formula.expression)}
            if not all(isinstance(value, (int, Fraction)) for value in used.values()):
                used = {name: self._number(value) for name, value in used.items()}
            known[formula.name] = evaluate(formula.expression, used, self.functions)
        return known

    def constant(self, name: str) -> Any:
        """One constant of the plan as a number of this precision."""
        return self._number(self._constants[name])

    @cached_property
    def _constants(self) -> dict[str, Any]:
        polhode, motion = self.motion.polhode, self.motion
        q0, *vector = self.start[0]
        signs = {name: getattr(polhode, name) for name in ("epsilon", "sigma", "rho", "chi")}
        begin = {"t": 0, "cos_half_psi": 1, "sin_half_psi": 0, "q_0": q0}
        for x, k in zip(AXES, polhode.axes, strict=True):
            begin |= {f"c_{x}": motion.inertia[k], f"Omega_{x}": motion.omega0[k]}
            begin |= {f"q_{x}": vector[k]}
        return self._run("plan", {**signs, **begin})

    def _moving(self, time: Fraction) -> State:
        known = self._run("state", {**self._constants, "t": time})
        q, omega = [known["q_0"], 0, 0, 0], [0, 0, 0]
        for x, k in zip(AXES, self.motion.polhode.axes, strict=True):
            q[k + 1], omega[k] = known[f"q_{x}"], known[f"Omega_{x}"]
        return q, omega

    def _steady(self, time: Fraction) -> State:
        rates = {f"Omega{k + 1}": x for k, x in enumerate(self.motion.omega0)}
        begin = {f"p{k}": x for k, x in enumerate(self.start[0])}
        known = self._run("steady", {**rates, **begin, "t": time})
        return [self._number(known[f"q{k}"]) for k in range(4)], self.start[1]


def _working_digits(digits: int, round_: int) -> int:
    return int((digits + GUARD_DIGITS) * 1.5**round_)


def _settled(rough: list[Any], fine: list[Any], digits: int, zeros: bool) -> list[Any] | None:
    """The fine numbers as mpmath's own mpf, not rounded, where all agree with the rough ones.

    Where `zeros` are allowed, a number that fell with the working precision is one.
    """
    settled = []
    for x, y in zip(rough, fine, strict=True):
        if abs(x - y) * 10 ** (digits + 1) <= abs(y):
            settled.append(mp.make_mpf(y._mpf_))
        elif zeros and abs(y) * 10**digits <= abs(x):
            settled.append(mp.zero)
        else:
            return None
    return settled
