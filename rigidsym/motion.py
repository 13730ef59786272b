"""Torque-free motion of a rigid body: the public class, on an engine."""

import math
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from numbers import Integral
from typing import TYPE_CHECKING, Any, Literal, NoReturn, TypeGuard, TypeVar, Unpack, overload

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import engines, inputs
from rigidsym.engines import batches
from rigidsym.errors import InputError
from rigidsym.inputs import MotionInputs, Number, Quaternion, Times, Vector3
from rigidsym.sensitivity import Sensitivity

if TYPE_CHECKING:
    from flint import arb
    from mpmath import mpf
    from pandas import DataFrame
    from scipy.spatial.transform import Rotation
    from xarray import Dataset

    from rigidsym.engines.sensitivities import Sensitive
    from rigidsym.precise import PreciseMotion
    from rigidsym.precise.boxed import BoxedMotion
    from rigidsym.precise.evaluation import State
    from rigidsym.precise.motion import DecimalState
    from rigidsym.precise.quantities import Quantities
    from rigidsym.solution.polhode import Mode, Regime
    from rigidsym.solution.symbolic import Symbolic
    from rigidsym.view.plots.figure import Figure

IDENTITY = (1, 0, 0, 0)
_IDENTITY = tuple(map(float, IDENTITY))
_OF_THIS_PROCESS = ("_prepared", "_in_doubles", "_engine", "_precise", "_boxed", "_quantities")
# Whole numbers up to here are doubles.
_MOST = 2**53
# Of a state with its sensitivities: q, omega, attitude, rates, attitude_t, rates_t.
_WIDTHS = (4, 3, 27, 27, 3, 3)
Value = TypeVar("Value")


class TorqueFreeMotion:
    """The motion of a free rigid body from its state at t = 0.

    inertia: three principal moments in kg m^2, positive, none larger than the sum of the other
    two unless `allow_nonphysical`.  omega0: body rates in rad/s.  attitude0: quaternion, scalar
    first, body to inertial, normalised here.  Numbers may be floats (exact binary64 values) or
    strings, Fraction, Decimal and mpf, which are taken exactly; `enclose` also takes uncertain
    ones, "0.0109 +/- 1e-6" or balls of python-flint.  engine: `numpy`, or `c`, the generated C
    source compiled once on this machine (NumPy with a warning where there is no compiler).
    degrees: omega0 is in deg/s; what is returned has radians all the same.  Raises InputError.  A
    motion is a value: equal to others with the same numbers and engine, hashable,
    and never changed.

    >>> motion = TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
    >>> q, omega = motion(180.0)
    >>> q.shape, omega.shape
    ((4,), (3,))
    >>> print(motion.regime)
    circulation about the axis of smallest inertia
    """

    engine: str
    allow_nonphysical: bool
    _floats: dict[str, tuple[float, ...]]

    def __init__(
        self,
        inertia: Vector3,
        omega0: Vector3,
        attitude0: Quaternion = IDENTITY,
        *,
        engine: str = "numpy",
        allow_nonphysical: bool = False,
        degrees: bool = False,
    ) -> None:
        turned = inputs.is_true("degrees", degrees)
        floats = {} if turned else _floats(inertia, omega0, attitude0)
        # Past __setattr__, which refuses.
        fields = vars(self)
        fields["_floats"], fields["allow_nonphysical"] = floats, allow_nonphysical
        fields["engine"] = engines.checked(engine)
        if not floats:
            fields["inertia"] = inputs.inertia(inertia, allow_nonphysical)
            fields["omega0"] = inputs.in_radians(inputs.vector("omega0", omega0, 3), turned)
            fields["attitude0"] = inputs.attitude(attitude0)

    # Engines need no fractions of floats, which take longer to make than a motion is prepared.
    @cached_property
    def inertia(self) -> tuple[Number, ...]:
        """The principal moments exactly, in kg m^2."""
        return tuple(map(Fraction, self._floats["inertia"]))

    @cached_property
    def omega0(self) -> tuple[Number, ...]:
        """The rates at t = 0 exactly, in rad/s."""
        return tuple(map(Fraction, self._floats["omega0"]))

    @cached_property
    def attitude0(self) -> tuple[Number, ...]:
        """The attitude at t = 0 as it was given, exactly."""
        return tuple(map(Fraction, self._floats["attitude0"]))

    def replace(self, **changes: Unpack[MotionInputs]) -> "TorqueFreeMotion":
        """Another motion, with some of the arguments changed; raises as the class does.

        `degrees` is about the omega0 that is given with it.
        """
        if changes.get("degrees") and "omega0" not in changes:
            raise InputError("degrees", True, "is about omega0, which is not given")
        own: MotionInputs = {
            "inertia": self.inertia,
            "omega0": self.omega0,
            "attitude0": self.attitude0,
            "engine": self.engine,
            "allow_nonphysical": self.allow_nonphysical,
        }
        return TorqueFreeMotion(**{**own, **changes})

    def __setattr__(self, name: str, value: object) -> NoReturn:
        raise AttributeError(f"{name}: a motion does not change; motion.replace gives another")

    def __delattr__(self, name: str) -> NoReturn:
        self.__setattr__(name, None)

    def __eq__(self, other: object) -> bool:
        return (
            self._value == other._value if isinstance(other, TorqueFreeMotion) else NotImplemented
        )

    def __hash__(self) -> int:
        return hash(self._value)

    @property
    def _value(self) -> tuple[str, *tuple[tuple[Number, ...], ...]]:
        """What tells motions apart."""
        return self.engine, self.inertia, self.omega0, self.attitude0

    def __copy__(self) -> "TorqueFreeMotion":
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> "TorqueFreeMotion":
        return self

    def __repr__(self) -> str:
        from rigidsym.view.text import motion_text

        return motion_text(self)

    def _repr_html_(self) -> str:
        from rigidsym.view.html.motions import motion_html

        return motion_html(self)

    def _repr_latex_(self) -> str:
        from rigidsym.view.html.motions import motion_latex

        return motion_latex(self)

    def __call__(
        self, t: ArrayLike, out: tuple[np.ndarray, np.ndarray] | None = None, errors: str = "raise"
    ) -> tuple[np.ndarray, np.ndarray]:
        """Attitude and body rates at t (s): (4,), (3,) for a number, (N, 4), (N, 3) for N of them.

        `out`: a pair of C-contiguous float64 arrays of these shapes to fill and return, which share
        no memory with each other or t.  Rotation angles are right to 2e-15 rad and rates to 2e-15
        of their size for bodies that can exist, as `rigidsym validate` measures.  Raises InputError
        for times that are not finite, not at most one-dimensional or beyond |omega0 t| = 2^46 rad,
        and for those after which a motion that binary64 cannot tell from the separatrix, or from
        spin about the middle axis, may have left it; `precise` follows all.  With errors="nan" such
        times have states of NaN.
        """
        prepared = self._prepared
        times = t if type(t) is float and math.isfinite(t) else _doubles(t, errors)
        try:
            return self._engine.states(prepared, times, out, errors)
        except ValueError as error:
            raise _refused(error, {"t": times, "errors": errors}) from None

    def sensitivity(
        self, t: ArrayLike, errors: str = "raise", columns: Iterable[str] | None = None
    ) -> tuple[np.ndarray, np.ndarray, Sensitivity]:
        """Return q and omega at t (s), as a call does, and their derivatives by all inputs.

        In closed form and at all times, in every regime; see `Sensitivity` for shapes and frames.
        Errors are below 1e-13 of a column: of the turn and the rates over |omega0|, by a change of
        omega0 or of a moment.  Columns by the moments start at zero; until the body has turned by
        1 rad the bound is 1e-13 of what they are then.  Five strata of motions have wider bounds:
        1e-12 beside the separatrix, near spin about the middle axis and where derivatives are near
        the least double; 1e-9 where a rate of a nearly symmetric body is zero (`rigidsym validate
        --sensitivity`).
        Raises InputError as a call does, and for times at which a motion on its way to spin about
        the middle axis has derivatives whose squares leave binary64; with errors="nan" there are
        no numbers then.

        columns: some of "attitude0", "omega0", "inertia" and "t"; there are no others then, and
        only these are refused for growth.

        >>> motion = TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
        >>> q, omega, S = motion.sensitivity([0.0, 180.0])
        >>> S.attitude.shape, S.rates_t.shape
        ((2, 3, 9), (2, 3))
        >>> motion.sensitivity([0.0, 180.0], columns=["omega0"])[2].rates.shape
        (2, 3, 3)
        """
        prepared, asked = self._prepared, _columns(columns)
        times = t if type(t) is float and math.isfinite(t) else _doubles(t, errors)
        found = _refusing(
            lambda: _sensitive(self._engine).sensitivities(prepared, times, errors, asked),
            t=times,
            errors=errors,
            engine=self.engine,
        )
        if not self._in_doubles:
            from rigidsym.engines.sensitivities import by_exact_moments

            if "inertia" in asked:
                by_exact_moments(found, self.exact["inertia"])
        return found[0], found[1], Sensitivity(*found[2:], asked)

    def state_transition(self, t0: float, t: ArrayLike) -> np.ndarray:
        """(..., 6, 6): what a small turn in space and a change of the rates at t0 (s) are at t.

        Phi(t2, t0) = Phi(t2, t1) Phi(t1, t0).  Vectors are those of `Sensitivity`; raises as
        `sensitivity` does.
        """
        begin, times = _number("t0", t0), _times(t)
        q, omega = self(begin)
        there = self.replace(omega0=omega.tolist(), attitude0=q.tolist()) if begin else self
        return there.sensitivity(times - begin)[2].transition

    def grid(
        self,
        start: float,
        step: float,
        count: int,
        out: tuple[np.ndarray, np.ndarray] | None = None,
    ) -> tuple[np.ndarray, np.ndarray]:
        """The states at start + k step (s), k = 0 ... count - 1: (count, 4) and (count, 3).

        With engine="c" these times are exact and sines are taken once in 64 samples; NumPy takes
        the doubles nearest to them.  `out`, accuracy and errors are those of a call; a step may be
        negative or zero.

        >>> motion = TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
        >>> q, omega = motion.grid(0.0, 0.5, 361)
        >>> bool(np.array_equal(q[-1], motion(180.0)[0]))
        True
        """
        times = {"start": _number("start", start), "step": _number("step", step)}
        if isinstance(count, bool) or not isinstance(count, Integral) or not 0 <= count <= _MOST:
            raise InputError("count", repr(count), "must be a whole number from 0 to 2^53")
        prepared, count = self._prepared, int(count)
        run = self._engine.grid
        return _refusing(lambda: run(prepared, *times.values(), count, out), t=_Samples(**times))

    @cached_property
    def _engine(self) -> engines.Engine:
        return engines.engine(self.engine)

    def __getstate__(self) -> dict[str, object]:
        """Without what belongs to this process."""
        kept = self.__dict__.items()
        return {name: value for name, value in kept if name not in _OF_THIS_PROCESS}

    @cached_property
    def exact(self) -> dict[str, tuple[Fraction, ...]]:
        """Inertia, omega0 and attitude0 by name; raises InputError where one is uncertain."""
        return {name: inputs.certain(name, values) for name, values in self._given.items()}

    @cached_property
    def _in_doubles(self) -> dict[str, tuple[float, ...]]:
        """Inertia, omega0 and attitude0 by name where doubles say all of them."""
        if self._floats:
            return self._floats
        given = self.exact
        doubles = {n: tuple(inputs.doubles(n, values)) for n, values in given.items()}
        same = all(tuple(map(Fraction, doubles[n])) == given[n] for n in given)
        return doubles if same else {}

    @cached_property
    def _prepared(self) -> engines.Prepared:
        if doubles := self._in_doubles:
            return _refusing(lambda: self._engine.prepare(*doubles.values()), **doubles)
        given = self.exact
        said = {name: inputs.doubles(name, values) for name, values in given.items()}
        return _refusing(lambda: self._engine.prepare_exactly(*given.values()), **said)

    @property
    def regime(self) -> "Regime":
        """The kind of motion, decided exactly from the numbers given."""
        return self._by("theta", **self._given).polhode.regime

    @property
    def mode(self) -> "Mode | None":
        """Which axis keeps to the momentum, the long one or the short one, decided exactly.

        None where there is none that does: on the separatrix, in spin about the middle axis, for
        spheres, and at rest.
        """
        from rigidsym.solution.polhode import mode

        polhode = self._by("theta", **self._given).polhode
        # That the middles decide for all numbers within the radii is what the polhode has seen to.
        inertia, omega0 = ([*map(inputs.middle, x)] for x in (self.inertia, self.omega0))
        return mode(polhode, inertia, omega0)

    @cached_property
    def _quantities(self) -> "Quantities":
        from rigidsym.precise.quantities import Quantities

        rule = "is uncertain, so that its motion has no one energy, period or angle: give a number"
        given = {name: inputs.certain(name, x, rule) for name, x in self._given.items()}
        return Quantities(self._by("theta", **given))

    @property
    def energy(self) -> float:
        """The kinetic energy H, J."""
        return self._quantities.energy

    @property
    def momentum(self) -> float:
        """The size K of the angular momentum, N m s."""
        return self._quantities.momentum

    @property
    def parameter(self) -> float | None:
        """m = k^2 of Jacobi's functions: 0 for symmetric bodies, 1 on the separatrix.

        None where the rates are constant.
        """
        return self._quantities.parameter

    @property
    def modulus(self) -> float | None:
        """k of Jacobi's functions; None where the rates are constant."""
        return self._quantities.modulus

    @property
    def period(self) -> float | None:
        """Of the rates, s: infinite on the separatrix, None where they are constant.

        >>> round(TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)).period, 6)
        165.897574
        """
        return self._quantities.period

    @property
    def mean_rates(self) -> tuple[float, float, float]:
        """The body rates averaged over a period, rad/s; over all times on the separatrix.

        That about the circulation axis alone has a mean, unless all are constant.

        >>> [round(x, 6) for x in TorqueFreeMotion((1, 2, 2.5), (1, 1, 3)).mean_rates]
        [0.0, 0.0, 2.974532]
        """
        return self._quantities.mean_rates

    @property
    def circulation_rate(self) -> float | None:
        """2 pi/period: how fast the momentum goes round in the body, on the average, rad/s.

        Zero on the separatrix, None where the rates are constant.
        """
        return self._quantities.circulation_rate

    @property
    def precession_rate(self) -> float | None:
        """The mean rate at which the body turns about its momentum, rad/s; None on the separatrix.

        Where the rates are constant it is the rate about their axis.
        """
        return self._quantities.precession_rate

    @property
    def phase_per_period(self) -> float | None:
        """The angle that the body has turned about its momentum after one period, rad.

        Whole turns included: 2 H period/K less the solid angle that the momentum sweeps in the body
        (Montgomery, American Journal of Physics 59, 394-398).  None on the separatrix, and where
        the rates are constant.
        """
        return self._quantities.phase_per_period

    @property
    def nutation(self) -> tuple[float, float]:
        """The least and the largest angle of the circulation axis from the momentum, rad.

        The axis of the largest or the smallest moment, at its end that is nearer to the momentum;
        both are equal for symmetric bodies, and zero where the rates are constant.
        """
        return self._quantities.nutation

    def _by(self, method: str, **given: tuple[Number, ...]) -> "PreciseMotion":
        from rigidsym.precise import ESTIMATED, METHODS, PreciseMotion

        known = (*METHODS, *ESTIMATED)
        if not isinstance(method, str) or method not in known:
            raise InputError("method", repr(method), f"must be one of: {', '.join(known)}")
        # Kept, because it keeps its constants from one call to the next.
        return self._precise.setdefault(method, PreciseMotion(*given.values(), method))

    @cached_property
    def _precise(self) -> dict[str, "PreciseMotion"]:
        return {}

    @property
    def _given(self) -> dict[str, tuple[Number, ...]]:
        return {"inertia": self.inertia, "omega0": self.omega0, "attitude0": self.attitude0}

    @overload
    def precise(
        self,
        t: Times,
        digits: int = 50,
        *,
        method: str = "theta",
        max_seconds: float | None = None,
        sensitivity: Literal[False] = False,
    ) -> tuple[np.ndarray, np.ndarray]: ...
    @overload
    def precise(
        self,
        t: Times,
        digits: int = 50,
        *,
        method: str = "theta",
        max_seconds: float | None = None,
        sensitivity: Literal[True],
    ) -> tuple[np.ndarray, np.ndarray, Sensitivity]: ...
    def precise(
        self,
        t: Times,
        digits: int = 50,
        *,
        method: str = "theta",
        max_seconds: float | None = None,
        sensitivity: bool = False,
    ) -> "tuple[np.ndarray, ...] | tuple[np.ndarray, np.ndarray, Sensitivity]":
        """Like a call, as object arrays of mpmath numbers, `digits` significant digits certain.

        They print these digits, and what is computed from them has mpmath's precision at the time.
        A number whose ball has shrunk around zero to less than 2^-4000 is given as zero.

        Times are taken exactly, as the other inputs are.  `method` is theta, carlson, landen or
        quadrature, by Arb's balls; or mpmath, by its functions alone: it computes each state
        twice, and gives the digits on which two of the ledger's forms agree; or theorem1, the
        paper's own form as mended, for motions that it is about.  sensitivity: also return a
        `Sensitivity` of such numbers, by the first four methods.  Raises
        PrecisionError where `max_seconds` are over before the digits are reached, saying how many
        were, and InputError for bad input.
        """
        times, single = inputs.times(t)
        limits = inputs.digits(digits), inputs.seconds(max_seconds)
        from rigidsym.precise.printed import certain

        if inputs.is_true("sensitivity", sensitivity):
            _ = self.exact
            rows = self._certainly(method).decimal_sensitivities(times, *limits)
            return _with_sensitivities((certain(row, digits) for row in rows), single)
        states = self._by(method, **self.exact).states(times, *limits)
        return _objects(((certain(q, digits), certain(w, digits)) for q, w in states), single)

    @overload
    def enclose(
        self,
        t: Times,
        digits: int = 50,
        *,
        method: str | None = None,
        max_seconds: float | None = None,
        sensitivity: Literal[False] = False,
    ) -> tuple[np.ndarray, np.ndarray]: ...
    @overload
    def enclose(
        self,
        t: Times,
        digits: int = 50,
        *,
        method: str | None = None,
        max_seconds: float | None = None,
        sensitivity: Literal[True],
    ) -> tuple[np.ndarray, np.ndarray, Sensitivity]: ...
    def enclose(
        self,
        t: Times,
        digits: int = 50,
        *,
        method: str | None = None,
        max_seconds: float | None = None,
        sensitivity: bool = False,
    ) -> "tuple[np.ndarray, ...] | tuple[np.ndarray, np.ndarray, Sensitivity]":
        """Like a call, as object arrays of Arb's balls (`flint.arb`) that contain the true values.

        Radii are at most 10^-digits max(1, |value|) where the inputs are exact, and what the
        inputs leave uncertain where they are not.  Uncertain inputs also have the methods `mean`,
        the mean value form by the sensitivities of all their motions, over parts of the box where
        it is too wide over the whole, and `flow`, which carries the equations of motion over the
        box; both whatever the regimes in it.  By default it is `mean`, and `flow` where that does
        not serve all of the box.  Where both have lost the attitude, its balls are [-1, 1], and
        rates keep to energy and momentum.  The other methods raise InputError for boxes across a
        boundary between regimes, which they name.
        sensitivity: also return a `Sensitivity` of balls, for uncertain inputs those of all motions
        of their box; they raise PrecisionError where these are too uncertain.  Else as `precise`.
        """
        times, single = inputs.times(t)
        limits = inputs.digits(digits), inputs.seconds(max_seconds)
        if inputs.is_true("sensitivity", sensitivity):
            rows = self._sensitivities(method)(times, *limits)
            return _with_sensitivities(rows, single)
        return _objects(self._enclosing(method)(times, *limits), single)

    def _enclosing(
        self, method: str | None
    ) -> "Callable[[Sequence[Fraction], int, float | None], Iterator[State]]":
        boxed = {None: "enclosures", "mean": "mean_values", "flow": "flows"}
        if self._is_uncertain and method in boxed:
            return getattr(self._boxed, boxed[method])
        return self._certainly(method).enclosures

    def _sensitivities(
        self, method: str | None
    ) -> "Callable[[Sequence[Fraction], int, float | None], Iterator[list[arb]]]":
        if self._is_uncertain and method in (None, "mean"):
            return self._boxed.sensitivities
        return self._certainly(method).sensitivities

    @property
    def _is_uncertain(self) -> bool:
        return inputs.is_uncertain(*self.inertia, *self.omega0, *self.attitude0)

    def _certainly(self, method: str | None) -> "PreciseMotion":
        """The motion by one of the methods that have error bounds."""
        from rigidsym.precise import ESTIMATED, METHODS

        if isinstance(method, str) and method in ESTIMATED:
            rule = f"has no error bounds; balls and sensitivities take {', '.join(METHODS)}"
            raise InputError("method", repr(method), rule)
        if method in ("mean", "flow") and not self._is_uncertain:
            raise InputError("method", method, "is for uncertain inputs, and these are exact")
        return self._by(method or "theta", **self._given)

    @cached_property
    def _boxed(self) -> "BoxedMotion":
        from rigidsym.precise.boxed import BoxedMotion

        return BoxedMotion(*self._given.values())

    def symbolic(self, form: str | None = None) -> "Symbolic":
        """Return the motion as SymPy's expressions of the time, with its exact numbers put in.

        form: "pi" or "theta", between the edges; "separatrix", "symmetric", "sphere" or "spin";
        "theorem1", the paper's; by default the one that serves the regime.  Each holds at all
        times, "theorem1" but where Omega3 = 0.  Raises InputError for other forms, for one that the
        regime has not, and for uncertain inputs.

        >>> motion = TorqueFreeMotion((1, 2, 2.5), (0, 1, 0))
        >>> motion.symbolic().q().T
        Matrix([[cos(t/2), 0, sin(t/2), 0]])
        """
        from rigidsym.solution.symbolic import of_motion

        return of_motion(form, *self.exact.values())

    def rotation(self, t: ArrayLike) -> "Rotation":
        """The attitude as scipy.spatial.transform.Rotation, body to inertial (needs SciPy)."""
        try:
            from scipy.spatial.transform import Rotation
        except ImportError:
            raise ImportError("rotation needs SciPy: pip install 'rigidsym[app]'") from None
        return Rotation.from_quat(np.roll(self(t)[0], -1, axis=-1))

    def to_dataframe(self, t: ArrayLike, *, degrees: bool = False) -> "DataFrame":
        """States at times (N,), s: index t, columns q0 ... q3, omega1 ... omega3 (needs pandas).

        Rates are in rad/s, or in deg/s with `degrees`.  Raises as a call does.
        """
        from rigidsym.io.frames import dataframe

        return dataframe(*self._sampled(t, degrees))

    def to_xarray(self, t: ArrayLike, *, degrees: bool = False) -> "Dataset":
        """States at times (N,), s: variables q (t, component), omega (t, axis) (needs xarray).

        Rates are in rad/s, or in deg/s with `degrees`, as their attribute `units` says.  Raises as
        a call does.
        """
        from rigidsym.io.frames import dataset

        return dataset(*self._sampled(t, degrees), "deg/s" if degrees else "rad/s")

    def _sampled(self, t: ArrayLike, degrees: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        times = np.atleast_1d(_times(t))
        q, omega = self(times)
        return times, q, np.rad2deg(omega) if inputs.is_true("degrees", degrees) else omega

    def plot(self, times: Times | None = None) -> "Figure":
        """Rates and attitude against time, and the momentum sphere (needs matplotlib).

        `times` (N,) in s; some periods of the rates where None.  The figure shows itself in a
        notebook, and has `savefig`.  Raises InputError for times as a call does, and for fewer
        than two of them.
        """
        from rigidsym.view.plots.motion import plot

        return plot(self, times)


@overload
def propagate(
    inertia: ArrayLike,
    omega0: ArrayLike,
    t: ArrayLike,
    attitude0: ArrayLike = IDENTITY,
    *,
    engine: str = "numpy",
    out: tuple[np.ndarray, np.ndarray] | None = None,
    allow_nonphysical: bool = False,
    errors: str = "raise",
    degrees: bool = False,
    sensitivity: Literal[False] = False,
    columns: None = None,
) -> tuple[np.ndarray, np.ndarray]: ...
@overload
def propagate(
    inertia: ArrayLike,
    omega0: ArrayLike,
    t: ArrayLike,
    attitude0: ArrayLike = IDENTITY,
    *,
    engine: str = "numpy",
    out: None = None,
    allow_nonphysical: bool = False,
    errors: str = "raise",
    degrees: bool = False,
    sensitivity: Literal[True],
    columns: Iterable[str] | None = None,
) -> tuple[np.ndarray, np.ndarray, Sensitivity]: ...
def propagate(
    inertia: ArrayLike,
    omega0: ArrayLike,
    t: ArrayLike,
    attitude0: ArrayLike = IDENTITY,
    *,
    engine: str = "numpy",
    out: tuple[np.ndarray, np.ndarray] | None = None,
    allow_nonphysical: bool = False,
    errors: str = "raise",
    degrees: bool = False,
    sensitivity: bool = False,
    columns: Iterable[str] | None = None,
) -> tuple[np.ndarray, np.ndarray] | tuple[np.ndarray, np.ndarray, Sensitivity]:
    """Many bodies at once: inertia (B, 3), omega0 (B, 3), t (N,) -> q (B, N, 4), omega (B, N, 3).

    Leading shapes broadcast, those of attitude0 (..., 4) and t (..., N) among them; all numbers are
    float64.  So t (N,) are times of all bodies, t (B, N) a row for each, t (B, 1) one time for
    each; a number is a time of all, and its states (B, 4) and (B, 3).  Arrays of float64 in one
    piece of memory are read where they are.  `out` is a
    pair of arrays of the shapes returned, to fill, which share no memory with each other or an
    input.  errors: "raise" InputError for the first body or time that is refused, named by its
    index, or "nan" for their states.  degrees: omega0 is in deg/s.  sensitivity: also return a
    `Sensitivity`, as `TorqueFreeMotion.sensitivity` does, by omega0 in rad/s and with its
    `columns`; then there is no `out`.  Units, conventions and engines are those of
    `TorqueFreeMotion`.
    """
    arrays = {"inertia": inertia, "omega0": omega0, "attitude0": attitude0}
    lenient = _is_lenient(errors)
    given = {name: batches.array(name, value, lenient) for name, value in arrays.items()}
    if inputs.is_true("degrees", degrees):
        given["omega0"] = np.deg2rad(given["omega0"])
    bodies = {"inertia": batches.possible(given["inertia"], allow_nonphysical, lenient)}
    chosen, times = engines.engine(engine), batches.array("t", t, lenient)
    arguments, said = (given | bodies).values(), {**given, "t": times, "errors": errors}
    if inputs.is_true("sensitivity", sensitivity):
        if out is not None:
            raise InputError("out", "given", "sensitivities have arrays of their own")
        asked = _columns(columns)
        found = _refusing(
            lambda: _sensitive(chosen).propagate(*arguments, times, errors, asked),
            engine=engine,
            **said,
        )
        return found[0], found[1], Sensitivity(*found[2:], asked)
    if columns is not None:
        raise InputError("columns", repr(columns), "are of sensitivities: set sensitivity=True")
    return _refusing(lambda: chosen.propagate(*arguments, times, out, errors), **said)


def _columns(columns: Iterable[str] | None) -> tuple[str, ...]:
    return _refusing(lambda: engines.columns(columns), columns=repr(columns))


def _sensitive(engine: engines.Engine) -> "Sensitive":
    # Here, because who asks for states alone needs nothing of it.
    from rigidsym.engines.sensitivities import sensitive

    return sensitive(engine)


def _objects(
    states: "Iterable[State | DecimalState]", single: bool
) -> tuple[np.ndarray, np.ndarray]:
    listed = list(states)
    q, omega = np.empty((len(listed), 4), dtype=object), np.empty((len(listed), 3), dtype=object)
    for k, (attitude, rates) in enumerate(listed):
        q[k], omega[k] = attitude, rates
    return (q[0], omega[0]) if single else (q, omega)


def _with_sensitivities(
    rows: "Iterable[Sequence[arb | mpf]]", single: bool
) -> tuple[np.ndarray, np.ndarray, Sensitivity]:
    """Of rows of 67 numbers: q, omega, both changes (3, 9), and both by the time."""
    listed = list(rows)
    table = np.empty((len(listed), sum(_WIDTHS)), dtype=object)
    for k, row in enumerate(listed):
        table[k] = row
    table = table[0] if single else table
    parts = np.split(table, np.cumsum(_WIDTHS)[:-1], axis=-1)
    q, omega, turns, rates, turns_t, rates_t = parts
    attitude, changes = (x.reshape(*x.shape[:-1], 3, 9) for x in (turns, rates))
    return q, omega, Sensitivity(attitude, changes, turns_t, rates_t)


@dataclass(frozen=True, slots=True)
class _Samples:
    """The times of a grid, which nobody makes an array of to name one."""

    start: float
    step: float
    ndim = 1

    def __getitem__(self, k: int) -> float:
        return self.start + k * self.step


# What an engine was given, by the names it refuses it by.
Argument = np.ndarray | Sequence[float] | float | str | _Samples
Given = Mapping[str, Argument]


def _refusing(compute: Callable[[], Value], **given: Argument) -> Value:
    """What `compute` returns; what an engine refuses becomes an InputError with the value."""
    try:
        return compute()
    except ValueError as error:
        raise _refused(error, given) from None


def _refused(error: Any, given: Given) -> ValueError:
    """The InputError with the value for what an engine refuses; other errors as they are."""
    if isinstance(error, InputError) or not hasattr(error, "field"):
        return error
    return InputError(*_named(error.field, error.rule, given, error.body, error.time))


def _named(
    field: str, rule: str, given: Given, body: int | None, time: int | None
) -> tuple[str, object, str]:
    """A field, with the index of the body in a batch or of the time; its value; and the rule."""
    value = given.get(field, "as given")
    if field == "t":
        if isinstance(value, np.ndarray) and value.ndim > 1:
            return _of_rows(field, rule, given, body, time)
        where = f" (body {_place(body, given)})" if body is not None and _batch(given) else ""
        if time is not None and isinstance(value, np.ndarray | _Samples) and value.ndim:
            field, value = f"t[{time}]", value[time]
        return field, value, rule + where
    if not isinstance(value, np.ndarray) or value.ndim < 2:
        return field, value, rule
    if body is None:
        return field, f"an array of shape {value.shape}", rule
    return _of_rows(field, rule, given, body)


def _of_rows(
    field: str, rule: str, given: Given, body: int | None, time: int | None = None
) -> tuple[str, object, str]:
    """The same for a field that is an array with a row for each body."""
    value = np.asarray(given[field])
    if body is None:
        return field, f"an array of shape {value.shape}", rule
    shape, which = _batch(given), () if time is None else (time,)
    place = *np.unravel_index(body, shape), *which
    row = np.broadcast_to(value, (*shape, value.shape[-1]))[place]
    return f"{field}[{', '.join(map(str, place))}]", row, rule


def _batch(given: Given) -> tuple[int, ...]:
    """The leading shape of a batch; () for one motion."""
    arrays = (given[name] for name in (*engines.SIZES, "t") if name in given)
    return np.broadcast_shapes(*(np.shape(x)[:-1] for x in arrays if not isinstance(x, _Samples)))


def _place(body: int, given: Given) -> str:
    return ", ".join(map(str, np.unravel_index(body, _batch(given))))


def _is_lenient(errors: str) -> bool:
    return _refusing(lambda: engines.is_lenient(errors), errors=errors)


def _number(name: str, value: ArrayLike) -> float:
    """One finite number."""
    array = batches.array(name, value)
    if array.ndim:
        raise InputError(name, f"an array of shape {array.shape}", "must be one number")
    return float(array)


def _is_one_double(t: object) -> TypeGuard[float]:
    """A finite number that needs no array on its way."""
    is_number = isinstance(t, float) or (isinstance(t, int) and not isinstance(t, bool))
    return is_number and abs(t) <= sys.float_info.max


def _doubles(t: ArrayLike, errors: str) -> float | np.ndarray:
    """A float or an array of floats."""
    return float(t) if _is_one_double(t) else _times(t, errors)


def _floats(
    inertia: Vector3, omega0: Vector3, attitude0: Quaternion
) -> dict[str, tuple[float, ...]]:
    """Inertia, omega0 and attitude0 by name where they are nothing but good doubles."""
    moments, rates = batches.moments(inertia), batches.floats(omega0, 3)
    start = _IDENTITY if attitude0 is IDENTITY else batches.floats(attitude0, 4)
    if moments is None or rates is None or start is None or not any(start):
        return {}
    return {"inertia": moments, "omega0": rates, "attitude0": start}


def _times(t: ArrayLike, errors: str = "raise") -> np.ndarray:
    times = batches.array("t", t, _is_lenient(errors))
    if times.ndim > 1:
        raise InputError("t", f"an array of shape {times.shape}", "must be one-dimensional")
    return times
