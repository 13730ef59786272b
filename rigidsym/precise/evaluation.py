"""The formulas of the solution over balls, with the constants of one motion at one precision."""

from collections.abc import Mapping
from fractions import Fraction
from functools import cached_property
from typing import Protocol

from flint import acb, arb

from rigidsym.inputs import Number
from rigidsym.language.sequence import FormulaSequence, Functions
from rigidsym.precise.amplitude import Function, Table
from rigidsym.precise.balls import Quantity, ball, power
from rigidsym.solution.formulas import AXES, sequence
from rigidsym.solution.polhode import Polhode, Regime

State = tuple[list[arb], list[arb]]
# m and 1 - m where the regime says them, however uncertain the rates are.
PARAMETER = {Regime.SYMMETRIC: {"m": 0, "m_1": 1}, Regime.SEPARATRIX: {"m": 1, "m_1": 0}}

_BY_THETA = ("theta", "theta_state", "pull_back")


class Given(Protocol):
    """A motion as it is given, rationals or uncertain numbers, and its kind."""

    @property
    def inertia(self) -> tuple[Number, ...]:
        """Principal moments (3,)."""
        ...

    @property
    def omega0(self) -> tuple[Number, ...]:
        """Body rates at t = 0 (3,)."""
        ...

    @property
    def attitude0(self) -> tuple[Number, ...]:
        """Attitude at t = 0 (4,), of any length but zero."""
        ...

    @property
    def polhode(self) -> Polhode:
        """Regime and axes."""
        ...


def _power(x: Quantity, exponent: int) -> Quantity:
    """Of balls, or exactly."""
    return x**exponent if isinstance(x, int | Fraction) else power(ball(x), exponent)


class Evaluation:
    """One motion at the working precision, by the table of functions of a method.

    `functions` that include theta_4 make it the theta form, wherever that exists: it knows
    neither the separatrix nor symmetric bodies.
    """

    def __init__(self, given: Given, functions: Table) -> None:
        self.given, self.functions = given, functions
        regime = given.polhode.regime
        self._by_theta = "theta4" in functions and regime in (Regime.LARGEST, Regime.SMALLEST)
        quaternion = list(map(ball, given.attitude0))
        norm = sum((x * x for x in quaternion), arb(0)).sqrt()
        self.start: State = ([x / norm for x in quaternion], list(map(ball, given.omega0)))

    def state(self, time: Fraction) -> State:
        """(q, omega) at one time; the given state itself at t = 0."""
        regime = self.given.polhode.regime
        if time == 0 or regime == Regime.REST:
            return self.start
        return self._steady(time) if regime.steady else self._moving(ball(time))

    def constant(self, name: str) -> arb:
        """One constant of the motion."""
        return ball(self._computed(frozenset([name]))[name])

    @cached_property
    def _converting(self) -> Functions:
        """The functions, of exact numbers too."""

        def of(function: Function) -> Function:
            return lambda *arguments: function(*map(ball, arguments))

        functions = {
            name: of(known)
            for name, known in self.functions.items()
            if not isinstance(known, arb | acb)
        }
        return {**functions, "power": _power}

    @cached_property
    def _exact(self) -> dict[str, Quantity]:
        """What the formula sequences of a state need of it."""
        wanted = [sequence(n).used for n in (_BY_THETA if self._by_theta else ("state",))]
        return self._computed(frozenset().union(*wanted))

    def _computed(self, wanted: frozenset[str]) -> dict[str, Quantity]:
        polhode, given = self.given.polhode, self.given
        q0, *vector = self.start[0]
        signs = {name: getattr(polhode, name) for name in ("epsilon", "sigma", "rho", "chi")}
        begin: dict[str, Quantity] = {"t": 0, "cos_half_psi": 1, "sin_half_psi": 0, "q_0": q0}
        for x, k in zip(AXES, polhode.axes, strict=True):
            begin |= {f"c_{x}": given.inertia[k], f"Omega_{x}": given.omega0[k]}
            begin |= {f"q_{x}": vector[k]}
        known = {**signs, **begin, **PARAMETER.get(polhode.regime, {})}
        return self._exactly(sequence("constants").up_to(wanted), known)

    @cached_property
    def _constants(self) -> dict[str, arb | int]:
        """The constants as numbers of this kind, with what the theta form adds to it."""
        constants = {
            name: value if isinstance(value, int) else ball(value)
            for name, value in self._exact.items()
        }
        if not self._by_theta:
            return constants
        constants |= sequence("theta").evaluate(constants, self.functions)
        # psi of the theta form does not start at zero: the quaternion in front has to make up.
        identity = {"p_0": 1, "p_a": 0, "p_b": 0, "p_d": 0}
        begin = sequence("theta_state").evaluate(
            {**constants, **identity, "t": ball(0)}, self.functions
        )
        start = {f"q_{x}": constants[f"q_{x}"] for x in ("0", *AXES)}
        front = sequence("pull_back").evaluate({**begin, **start}, self.functions)
        return constants | {name: front[name] for name in identity}

    def _exactly(
        self, formulas: FormulaSequence, values: Mapping[str, Quantity]
    ) -> dict[str, Quantity]:
        """Every formula; exactly, as long as all it uses is rational."""
        return formulas.evaluate_exactly(values, self._converting, ball)

    def _moving(self, time: arb) -> State:
        formulas = sequence("theta_state" if self._by_theta else "state")
        known = formulas.evaluate({**self._constants, "t": time}, self.functions)
        q, omega = [ball(known["q_0"]), *[arb(0)] * 3], [arb(0)] * 3
        for x, k in zip(AXES, self.given.polhode.axes, strict=True):
            q[k + 1], omega[k] = ball(known[f"q_{x}"]), ball(known[f"Omega_{x}"])
        return q, omega

    def _steady(self, time: Fraction) -> State:
        rates = {f"Omega{k + 1}": x for k, x in enumerate(self.given.omega0)}
        begin = {f"p{k}": x for k, x in enumerate(self.start[0])}
        known = self._exactly(sequence("steady"), {**rates, **begin, "t": time})
        return [ball(known[f"q{k}"]) for k in range(4)], self.start[1]
