"""Evaluation of the closed-form solution for one motion at one precision.

Numbers are balls, or any other kind that the functions and `number` compute with.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from typing import Any, Generic, TypeVar

from flint import arb

from rigidsym import _inputs as inputs
from rigidsym.language._sequence import FormulaSequence
from rigidsym.precise._regime import MotionInputs
from rigidsym.precise._sensitivity.columns import Point
from rigidsym.solution._formulas import AXES, sequence
from rigidsym.solution._polhode import Regime

State = tuple[list[arb], list[arb]]
# A number of an evaluation.
Value = TypeVar("Value")
# m and 1 - m where they follow from the regime, however uncertain the rates are.
PARAMETER = {Regime.SYMMETRIC: {"m": 0, "m_1": 1}, Regime.SEPARATRIX: {"m": 1, "m_1": 0}}

_OF_PERIODS = ("period", "psi_mean", "Omega_mean")
_BY_THETA = ("theta", "theta_state", "pull_back")


@dataclass(frozen=True, slots=True)
class Sensitive:
    """A request for the state at a time and for its sensitivities."""

    time: Fraction


# A request: for the state at a time, for that with sensitivities, or for constants by name.
Request = Fraction | Sensitive | tuple[str, ...]


def exactly(
    formulas: FormulaSequence,
    values: Mapping[str, Any],
    functions: Mapping[str, Any],
    number: Callable[[Any], Any],
) -> dict[str, Any]:
    """Evaluate formulas, using exact arithmetic wherever all inputs are rational."""

    def of(function: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *arguments: function(*map(number, arguments))

    def power(x: Any, exponent: int) -> Any:
        exact = isinstance(x, int | Fraction)
        return x**exponent if exact else functions["power"](number(x), exponent)

    converting = {name: of(known) for name, known in functions.items() if callable(known)}
    return formulas.evaluate_exactly(values, {**converting, "power": power}, number)


class Evaluation(Generic[Value]):
    """The evaluation of one motion at the working precision by one method.

    With theta_4 among the functions it is computed by the theta form, wherever that exists: neither
    on the separatrix nor for symmetric bodies.  `number` converts any number to their kind.
    """

    def __init__(
        self, given: MotionInputs, functions: Mapping[str, Any], number: Callable[[Any], Value]
    ) -> None:
        self.given, self.functions, self.number = given, functions, number
        regime = given.polhode.regime
        self.by_theta = "theta4" in functions and regime in (Regime.LARGEST, Regime.SMALLEST)
        quaternion: list[Any] = list(map(number, given.attitude0))
        norm = functions["sqrt"](sum(x * x for x in quaternion))
        self.start = [x / norm for x in quaternion], list(map(number, given.omega0))

    def numbers(self, request: Request) -> list[Value]:
        """Return the requested numbers of the motion.

        These are a state with or without sensitivities, or constants.
        """
        if isinstance(request, tuple):
            return [self.constant(name) for name in request]
        if isinstance(request, Sensitive):
            q, omega = self.state(request.time)
            return [*q, *omega, *self._point.at(request.time, q)]
        return [*chain(*self.state(request))]

    def state(self, time: Fraction) -> tuple[list[Value], list[Value]]:
        """Return attitude and rates at one time.

        At t = 0, it is the given state itself.
        """
        regime = self.given.polhode.regime
        if time == 0 or regime == Regime.REST:
            return self.start
        return self._steady(time) if regime.steady else self._moving(self.number(time))

    def constant(self, name: str) -> Value:
        """Return a constant of the motion by name.

        Those of periods exist where the rates change and m_c < 1.
        """
        if name in _OF_PERIODS:
            return self._periods[name]
        return self.number(self._computed(frozenset([name]))[name])

    @cached_property
    def _point(self) -> Any:
        inertia, omega0 = (inputs.certain("", x) for x in (self.given.inertia, self.given.omega0))
        return Point(inertia, omega0, self.start[0])

    @cached_property
    def _periods(self) -> dict[str, Value]:
        periods = sequence("periods")
        found = self._computed(periods.inputs)
        given = {name: self.number(found[name]) for name in periods.inputs}
        return periods.evaluate(given, self.functions)

    @cached_property
    def _exact(self) -> dict[str, Any]:
        """The constants that the formulas of a state need, exact where they are rational."""
        wanted = [sequence(n).used for n in (_BY_THETA if self.by_theta else ("state",))]
        return self._computed(frozenset().union(*wanted))

    def _computed(self, wanted: frozenset[str]) -> dict[str, Any]:
        polhode, given = self.given.polhode, self.given
        q0, *vector = self.start[0]
        signs = {name: getattr(polhode, name) for name in ("epsilon", "sigma", "rho", "chi")}
        begin: dict[str, Any] = {"t": 0, "cos_half_psi": 1, "sin_half_psi": 0, "q_0": q0}
        for x, k in zip(AXES, polhode.axes, strict=True):
            begin |= {f"c_{x}": given.inertia[k], f"Omega_{x}": given.omega0[k]}
            begin |= {f"q_{x}": vector[k]}
        known = {**signs, **begin, **PARAMETER.get(polhode.regime, {})}
        formulas = sequence("constants").up_to(wanted)
        return exactly(formulas, known, self.functions, self.number)

    @cached_property
    def _constants(self) -> dict[str, Any]:
        """The constants that the formulas of a state need, converted to one kind of number.

        Those of the theta form are among them.
        """
        constants = {
            name: value if isinstance(value, int) else self.number(value)
            for name, value in self._exact.items()
        }
        if not self.by_theta:
            return constants
        constants |= sequence("theta").evaluate(constants, self.functions)
        # psi of the theta form does not start at zero; the quaternion in front makes up for it.
        identity = {"p_0": 1, "p_a": 0, "p_b": 0, "p_d": 0}
        begin = sequence("theta_state").evaluate(
            {**constants, **identity, "t": self.number(0)}, self.functions
        )
        start = {f"q_{x}": constants[f"q_{x}"] for x in ("0", *AXES)}
        front = sequence("pull_back").evaluate({**begin, **start}, self.functions)
        return constants | {name: front[name] for name in identity}

    def _moving(self, time: Value) -> tuple[list[Value], list[Value]]:
        formulas = sequence("theta_state" if self.by_theta else "state")
        known = formulas.evaluate({**self._constants, "t": time}, self.functions)
        zero = self.number(0)
        q, omega = [self.number(known["q_0"]), *[zero] * 3], [zero] * 3
        for x, k in zip(AXES, self.given.polhode.axes, strict=True):
            q[k + 1], omega[k] = self.number(known[f"q_{x}"]), self.number(known[f"Omega_{x}"])
        return q, omega

    def _steady(self, time: Fraction) -> tuple[list[Value], list[Value]]:
        rates = {f"Omega{k + 1}": x for k, x in enumerate(self.given.omega0)}
        begin = {f"p{k}": x for k, x in enumerate(self.start[0])}
        given = {**rates, **begin, "t": time}
        known = exactly(sequence("steady"), given, self.functions, self.number)
        return [self.number(known[f"q{k}"]) for k in range(4)], self.start[1]
