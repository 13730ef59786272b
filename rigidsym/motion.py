"""Torque-free motion of one rigid body or of many."""

import math
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from numbers import Integral
from typing import TYPE_CHECKING, Literal, NoReturn, Unpack, overload

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import _engines as engines
from rigidsym import _inputs as inputs
from rigidsym import _layers as layers
from rigidsym._engines import EngineError, batches, blocks
from rigidsym._frames import Sampled
from rigidsym._inputs import MotionInputs, Number, Quaternion, Times, Vector3
from rigidsym.errors import InputError, unknown
from rigidsym.principal import TensorMotion, principal_axes
from rigidsym.sensitivity import Sensitivity

if TYPE_CHECKING:
    from flint import arb
    from mpmath import mpf

    from rigidsym.precise import PreciseMotion
    from rigidsym.precise._boxed import BoxedMotion
    from rigidsym.precise._quantities import Quantities
    from rigidsym.solution._polhode import Mode, Regime
    from rigidsym.solution._symbolic import Symbolic
    from rigidsym.view._plots.figure import Figure

IDENTITY = (1, 0, 0, 0)
_IDENTITY = tuple(map(float, IDENTITY))
_CACHED = ("_prepared", "_in_doubles", "_engine", "_precise", "_boxed", "_quantities")
# Whole numbers up to here are doubles.
_MOST = 2**53


class TorqueFreeMotion(Sampled):
    """The motion of a torque-free rigid body from its state at t = 0.

    A motion is a value: equal to others with the same numbers and engine, hashable, and immutable.
    Numbers may be floats (exact binary64 values) or strings, Fraction, Decimal and mpf, which are
    taken exactly; `enclose` also takes uncertain ones, "0.0109 +/- 1e-6" or balls of python-flint.

    Parameters
    ----------
    inertia : array_like (3,)
        Principal moments, kg m^2: positive, none larger than the sum of the other two unless
        `allow_nonphysical`.
    omega0 : array_like (3,)
        Body rates at t = 0, rad/s.
    attitude0 : array_like (4,) or Rotation
        Attitude quaternion at t = 0, scalar first, body to inertial; it is normalised.
    engine : {"auto", "c", "c-portable", "numpy"}
        `c` is the generated C source, compiled in wheels, else once on this machine; without a
        compiler NumPy computes, with a warning.  `auto` is `c`, and without a compiler NumPy,
        without a warning.  `c-portable` is C with the same bits on every processor.
    allow_nonphysical : bool
        Accept moments that no body has.
    degrees : bool
        omega0 is in deg/s.  Returned rates are in rad/s all the same.

    Raises
    ------
    InputError
        Names the first number that is refused.

    Examples
    --------
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
        engine: str = engines.DEFAULT,
        allow_nonphysical: bool = False,
        degrees: bool = False,
    ) -> None:
        in_degrees = inputs.is_true("degrees", degrees)
        floats = {} if in_degrees else _floats(inertia, omega0, attitude0)
        # Past __setattr__, which refuses.
        fields = vars(self)
        fields["_floats"], fields["allow_nonphysical"] = floats, allow_nonphysical
        fields["engine"] = engines.checked(engine)
        if not floats:
            fields["inertia"] = inputs.inertia(inertia, allow_nonphysical)
            fields["omega0"] = inputs.in_radians(inputs.vector("omega0", omega0, 3), in_degrees)
            fields["attitude0"] = inputs.attitude(attitude0)

    @classmethod
    def from_tensor(
        cls,
        tensor: ArrayLike,
        omega0: Vector3,
        attitude0: Quaternion = IDENTITY,
        *,
        engine: str = engines.DEFAULT,
        allow_nonphysical: bool = False,
        degrees: bool = False,
    ) -> TensorMotion:
        """Return the motion of a body with a given inertia tensor, in the axes of the tensor.

        Parameters
        ----------
        tensor : array_like (3, 3)
            The inertia tensor in the body's own axes, kg m^2, as for `principal_axes`.
        omega0 : array_like (3,)
            Rates along these axes at t = 0, rad/s.
        attitude0 : array_like (4,) or Rotation
            Attitude of these axes at t = 0, scalar first, body to inertial.
        engine, allow_nonphysical, degrees
            As for the class.

        Returns
        -------
        TensorMotion
            Its states are along the axes of the tensor.

        Raises
        ------
        InputError
            As `principal_axes` and the class do, and for uncertain numbers.

        Examples
        --------
        >>> tensor = [[2, 0, 0.1], [0, 3, 0], [0.1, 0, 4]]
        >>> motion = TorqueFreeMotion.from_tensor(tensor, (0.1, 0.2, 0.3))
        >>> motion(0.0)[1].round(12)
        array([0.1, 0.2, 0.3])
        >>> print(motion.regime)
        circulation about the axis of largest inertia
        """
        body, rule = principal_axes(tensor), "is uncertain; a motion from a tensor takes numbers"
        rates = inputs.in_radians(
            inputs.vector("omega0", omega0, 3), inputs.is_true("degrees", degrees)
        )
        given = inputs.certain("attitude0", inputs.attitude(attitude0), rule)
        largest = max(map(abs, given))  # so that no product overflows
        omega, q = body.to_principal(
            inputs.doubles("omega0", inputs.certain("omega0", rates, rule)),
            inputs.doubles("attitude0", [x / largest for x in given]),
        )
        motion = cls(body.moments, omega, q, engine=engine, allow_nonphysical=allow_nonphysical)
        return TensorMotion(motion, body)

    # Lazily, because making fractions of floats takes longer than preparing a motion.
    @cached_property
    def inertia(self) -> tuple[Number, ...]:
        """The exact principal moments of inertia, in kg m^2."""
        return tuple(map(Fraction, self._floats["inertia"]))

    @cached_property
    def omega0(self) -> tuple[Number, ...]:
        """The exact body rates at t = 0, in rad/s."""
        return tuple(map(Fraction, self._floats["omega0"]))

    @cached_property
    def attitude0(self) -> tuple[Number, ...]:
        """The exact attitude quaternion at t = 0, not normalised."""
        return tuple(map(Fraction, self._floats["attitude0"]))

    def replace(self, **changes: Unpack[MotionInputs]) -> "TorqueFreeMotion":
        """Return a copy of the motion with some arguments changed.

        `degrees` is about an omega0 among the changes.  Raises InputError as the class does.
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
        if not isinstance(other, TorqueFreeMotion):
            return NotImplemented
        return self._value == other._value

    def __hash__(self) -> int:
        return hash(self._value)

    @property
    def _value(self) -> tuple[str, *tuple[tuple[Number, ...], ...]]:
        """The engine and the inputs, by which motions are compared and hashed."""
        return self.engine, self.inertia, self.omega0, self.attitude0

    def __copy__(self) -> "TorqueFreeMotion":
        return self

    def __deepcopy__(self, memo: dict[int, object]) -> "TorqueFreeMotion":
        return self

    def __repr__(self) -> str:
        from rigidsym.view._motions import motion_text

        return motion_text(self)

    def _repr_html_(self) -> str:
        from rigidsym.view._motions import motion_html

        return motion_html(self)

    def _repr_latex_(self) -> str:
        from rigidsym.view._motions import motion_latex

        return motion_latex(self)

    def __getstate__(self) -> dict[str, object]:
        """Return the attributes to pickle, which exclude caches."""
        return {name: value for name, value in self.__dict__.items() if name not in _CACHED}

    def __call__(
        self, t: ArrayLike, out: tuple[np.ndarray, np.ndarray] | None = None, errors: str = "raise"
    ) -> tuple[np.ndarray, np.ndarray]:
        """Return the attitude and the body rates at times.

        Parameters
        ----------
        t : number or array_like (N,)
            Times, s.  Dates (datetime64, DatetimeIndex) count from the first one; for another epoch
            give `t - epoch`.  Arrays of xarray and Dask are taken as `propagate` does.
        out : pair of arrays
            C-contiguous float64 arrays of the shapes returned, to fill; they share no memory with
            each other or t.  Memory maps, Zarr arrays and others that take slices are written
            block by block.
        errors : {"raise", "nan"}
            "nan": times that are refused have states of NaN.

        Returns
        -------
        q : array (4,) or (N, 4)
            Attitude quaternions, continuous in the double cover.  Rotation angles have errors
            below 2e-15 rad for bodies that can exist, as `rigidsym validate` measures.
        omega : array (3,) or (N, 3)
            Body rates, rad/s, with errors below 2e-15 of their size.

        Raises
        ------
        InputError
            For times that are not finite, not at most one-dimensional or beyond |omega0 t| = 2^46
            rad; and for times after which a motion may have left the separatrix, or spin about the
            middle axis, where binary64 cannot tell them apart; `precise` follows all motions.
        """
        prepared = self._prepared
        if type(t) is float and math.isfinite(t):
            times = t
        elif layers.is_layered(t):
            return layers.called(self, {"t": t}, out=out, errors=errors)
        else:
            times = batches.times(t, errors)
        try:
            if out is not None and blocks.are_streams(out):

                def compute(part: blocks.Part, states: engines.States) -> None:
                    self._engine.states(prepared, np.asarray(times)[part], states, errors)

                return blocks.fill(out, np.shape(times), (times,), compute, 0)
            return self._engine.states(prepared, times, out, errors)
        except EngineError as error:
            raise batches.input_error(error, {"t": times, "errors": errors}) from None

    def sensitivity(
        self, t: ArrayLike, errors: str = "raise", columns: Iterable[str] | None = None
    ) -> tuple[np.ndarray, np.ndarray, Sensitivity]:
        """Return the states at times, and their derivatives with respect to all inputs.

        The derivatives are in closed form, at all times and in every regime.  Errors are below
        1e-13 of a column: of the rotation, and of the rates over |omega0|, by a change of omega0 or
        of a moment.  Columns by the moments start at zero; until the body has turned by 1 rad the
        bound is 1e-13 of their size then.  Five strata of motions have wider bounds: 1e-12 beside
        the separatrix, near spin about the middle axis and where derivatives are near the least
        double; 1e-9 where a rate of a nearly symmetric body is zero (`rigidsym validate
        --sensitivity`).

        Parameters
        ----------
        t, errors
            As for a call.
        columns : some of "attitude0", "omega0", "inertia" and "t"
            The derivatives to return, all by default.  Only these are refused for growth.

        Returns
        -------
        q, omega
            As a call returns.
        sensitivity : Sensitivity
            The derivatives; see there for shapes and frames.

        Raises
        ------
        InputError
            As a call does, and for times at which a motion that leaves spin about the middle axis
            has derivatives whose squares leave binary64; with errors="nan" they are NaN then.

        Examples
        --------
        >>> motion = TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
        >>> q, omega, S = motion.sensitivity([0.0, 180.0])
        >>> S.attitude.shape, S.rates_t.shape
        ((2, 3, 9), (2, 3))
        >>> motion.sensitivity([0.0, 180.0], columns=["omega0"])[2].rates.shape
        (2, 3, 3)
        """
        prepared, names = self._prepared, engines.columns(columns)
        times = t if type(t) is float and math.isfinite(t) else batches.times(t, errors)
        try:
            found = self._engine.sensitivities(prepared, times, errors, names)
        except EngineError as error:
            given = {"t": times, "errors": errors, "engine": self.engine}
            raise batches.input_error(error, given) from None
        if not self._in_doubles and "inertia" in names:
            from rigidsym._engines.exact_inputs import by_exact_moments

            by_exact_moments(found, self.exact["inertia"])
        return found[0], found[1], Sensitivity(*found[2:], names)

    def state_transition(self, t0: float, t: ArrayLike) -> np.ndarray:
        """Return the state transition matrices from t0 to each time.

        Parameters
        ----------
        t0 : number
            The time of the initial state, s.
        t : number or array_like (N,)
            Times, s.

        Returns
        -------
        array (..., 6, 6)
            The derivative of the small rotation in space and the rates at t by those at t0, as
            vectors of `Sensitivity`: Phi(t2, t0) = Phi(t2, t1) Phi(t1, t0).

        Raises
        ------
        InputError
            As `sensitivity` does.
        """
        begin, times = batches.number("t0", t0), batches.times(t)
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
        """Return the states at equally spaced times.

        Times are start + k step for k = 0 ... count - 1.

        C takes these times exactly and computes sines once in 64 samples; NumPy takes the doubles
        nearest to them.

        Parameters
        ----------
        start, step : number
            Times, s; a step may be negative or zero.
        count : int
            The number of samples.
        out : pair of arrays
            As for a call.

        Returns
        -------
        q : array (count, 4)
            Attitude quaternions, as a call returns.
        omega : array (count, 3)
            Body rates, rad/s.

        Raises
        ------
        InputError
            As a call does.

        Examples
        --------
        >>> motion = TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))
        >>> q, omega = motion.grid(0.0, 0.5, 361)
        >>> bool(np.allclose(q[-1], motion(180.0)[0], rtol=0, atol=2e-15))
        True
        """
        first, apart = batches.number("start", start), batches.number("step", step)
        if isinstance(count, bool) or not isinstance(count, Integral) or not 0 <= count <= _MOST:
            raise InputError("count", repr(count), "must be a whole number from 0 to 2^53")
        prepared = self._prepared
        try:
            return self._engine.grid(prepared, first, apart, int(count), out)
        except EngineError as error:
            k = error.time or 0
            raise InputError(f"t[{k}]", first + k * apart, error.rule, time=k) from None

    @cached_property
    def _engine(self) -> engines.Engine:
        return engines.engine(self.engine)

    @property
    def _given(self) -> dict[str, tuple[Number, ...]]:
        return {"inertia": self.inertia, "omega0": self.omega0, "attitude0": self.attitude0}

    @cached_property
    def exact(self) -> dict[str, tuple[Fraction, ...]]:
        """The exact inputs inertia, omega0 and attitude0, by name.

        Raises InputError if one is uncertain.
        """
        return {name: inputs.certain(name, values) for name, values in self._given.items()}

    @cached_property
    def _in_doubles(self) -> dict[str, tuple[float, ...]]:
        """The inputs inertia, omega0 and attitude0 as floats, by name.

        Empty unless all numbers are doubles.
        """
        if self._floats:
            return self._floats
        given = self.exact
        doubles = {n: tuple(inputs.doubles(n, values)) for n, values in given.items()}
        same = all(tuple(map(Fraction, doubles[n])) == given[n] for n in given)
        return doubles if same else {}

    @cached_property
    def _prepared(self) -> engines.Prepared:
        numbers = doubles = self._in_doubles
        try:
            if doubles:
                return self._engine.prepare(**doubles)
            numbers = {name: inputs.doubles(name, values) for name, values in self.exact.items()}
            return self._engine.prepare_exactly(**self.exact)
        except EngineError as error:
            raise batches.input_error(error, numbers) from None

    @property
    def regime(self) -> "Regime":
        """The regime of the motion, decided exactly from the inputs."""
        return self._by("theta", self._given).polhode.regime

    @property
    def mode(self) -> "Mode | None":
        """The body axis, long or short, that stays near the angular momentum.

        It is decided exactly from the inputs.  None where there is none: on the separatrix, in spin
        about the middle axis, for spheres, and at rest.
        """
        from rigidsym.solution._polhode import mode

        polhode = self._by("theta", self._given).polhode
        # The polhode has checked that the middles decide for all numbers within the radii.
        inertia, omega0 = ([*map(inputs.middle, x)] for x in (self.inertia, self.omega0))
        return mode(polhode, inertia, omega0)

    @cached_property
    def _quantities(self) -> "Quantities":
        from rigidsym.precise._quantities import Quantities

        rule = "is uncertain, so that its motion has no one energy, period or angle: give a number"
        given = {name: inputs.certain(name, x, rule) for name, x in self._given.items()}
        return Quantities(self._by("theta", given))

    @property
    def energy(self) -> float:
        """The kinetic energy, in J.

        Formulas call it H.
        """
        return self._quantities.energy

    @property
    def momentum(self) -> float:
        """The magnitude of the angular momentum, in N m s.

        Formulas call it K.
        """
        return self._quantities.momentum

    @property
    def parameter(self) -> float | None:
        """The parameter m = k^2 of the solution's Jacobi elliptic functions.

        0 for symmetric bodies, 1 on the separatrix, None where the rates are constant.
        """
        return self._quantities.parameter

    @property
    def modulus(self) -> float | None:
        """The modulus k of the solution's Jacobi elliptic functions.

        None where the rates are constant.
        """
        return self._quantities.modulus

    @property
    def period(self) -> float | None:
        """The period of the body rates, in s.

        Infinite on the separatrix, None where the rates are constant.

        >>> round(TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02)).period, 6)
        165.897574
        """
        return self._quantities.period

    @property
    def mean_rates(self) -> tuple[float, float, float]:
        """The body rates averaged over a period, in rad/s.

        On the separatrix they are averaged over all times.  Only the rate about the circulation
        axis has a mean other than zero, unless all are constant.

        >>> [round(x, 6) for x in TorqueFreeMotion((1, 2, 2.5), (1, 1, 3)).mean_rates]
        [0.0, 0.0, 2.974532]
        """
        return self._quantities.mean_rates

    @property
    def circulation_rate(self) -> float | None:
        """The mean rate at which the angular momentum circulates in the body, in rad/s.

        It is 2 pi/period.  Zero on the separatrix, None where the rates are constant.
        """
        return self._quantities.circulation_rate

    @property
    def precession_rate(self) -> float | None:
        """The mean rate at which the body turns about its angular momentum, in rad/s.

        None on the separatrix.  Where the rates are constant it is the rate about their axis.
        """
        return self._quantities.precession_rate

    @property
    def phase_per_period(self) -> float | None:
        """The angle by which the body turns about its angular momentum in one period, in rad.

        It has whole turns: 2 H period/K less the solid angle that the momentum sweeps in the body
        (Montgomery, American Journal of Physics 59, 394-398).  None on the separatrix, and where
        the rates are constant.
        """
        return self._quantities.phase_per_period

    @property
    def nutation(self) -> tuple[float, float]:
        """The smallest and largest angle of the circulation axis from the angular momentum, in rad.

        That axis has the largest or the smallest moment; the angle is from its end that is nearer
        to the momentum.  Both are equal for symmetric bodies, and zero where the rates are
        constant.
        """
        return self._quantities.nutation

    def _by(self, method: str, given: Mapping[str, tuple[Number, ...]]) -> "PreciseMotion":
        """Return the arbitrary-precision motion that uses a given method, and cache it."""
        from rigidsym.precise import ESTIMATED, METHODS, PreciseMotion

        known = (*METHODS, *ESTIMATED)
        if not isinstance(method, str) or method not in known:
            raise unknown("method", method, known)
        # Kept, because it keeps its constants from one call to the next.
        return self._precise.setdefault(method, PreciseMotion(**given, method=method))

    @cached_property
    def _precise(self) -> dict[str, "PreciseMotion"]:
        return {}

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
        """Return states as mpmath numbers with `digits` correct significant digits.

        The numbers print these digits; results computed from them have mpmath's precision at the
        time.  A number whose ball has shrunk around zero to less than 2^-4000 is zero.

        Parameters
        ----------
        t : number or array_like (N,)
            Times, s, taken exactly as the other inputs are.
        digits : int
            The number of significant digits.
        method : {"theta", "carlson", "landen", "quadrature", "mpmath", "theorem1"}
            The first four compute by Arb's balls.  `mpmath` computes each state by two of the
            ledger's forms with mpmath's functions, and returns the digits on which they agree.
            `theorem1` is the paper's own form, corrected, for the motions that it covers.
        max_seconds : float
            The time limit.
        sensitivity : bool
            Also return a `Sensitivity` of such numbers, by the first four methods.

        Returns
        -------
        q, omega : object arrays
            Of the shapes of a call.

        Raises
        ------
        PrecisionError
            If the time limit is reached before the digits are; the message says how many were.
        InputError
            For bad input.
        """
        times, single = inputs.times(t)
        limits = inputs.digits(digits), inputs.seconds(max_seconds)
        from rigidsym.precise._printed import certain

        if inputs.is_true("sensitivity", sensitivity):
            _ = self.exact
            rows = self._by_balls(method).decimal_sensitivities(times, *limits)
            return _with_sensitivities((certain(row, digits) for row in rows), single)
        states = self._by(method, self.exact).states(times, *limits)
        return _split(([*certain(q, digits), *certain(w, digits)] for q, w in states), single)

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
        """Return states as balls (`flint.arb`) that contain the true values.

        Radii are at most 10^-digits max(1, |value|) if the inputs are exact; otherwise they follow
        from the uncertainty of the inputs.

        Parameters
        ----------
        t : number or array_like (N,)
            Times, s, taken exactly.
        digits : int
            The number of significant digits for exact inputs.
        method : str
            A method of `precise` that computes by balls.  It raises InputError, which names the
            boundary, for a box of inputs across a boundary between regimes.  For uncertain inputs
            there are two more methods, which accept boxes with any regimes.  `mean` is the mean
            value form with the sensitivities of all motions of the box; it divides the box if
            it is too wide.  `flow` integrates the equations of motion over the box.  The default
            for uncertain inputs is `mean`, and `flow` where `mean` does not serve all of the box.
            If both lose the attitude, its balls are [-1, 1], and rates obey the conservation of
            energy and momentum.
        max_seconds : float
            The time limit.
        sensitivity : bool
            Also return a `Sensitivity` of balls, for uncertain inputs of all motions of their box.

        Returns
        -------
        q, omega : object arrays
            Of the shapes of a call.

        Raises
        ------
        PrecisionError
            As `precise` does, and where sensitivities are too uncertain.
        InputError
            For bad input.
        """
        times, single = inputs.times(t)
        limits = inputs.digits(digits), inputs.seconds(max_seconds)
        derivatives = inputs.is_true("sensitivity", sensitivity)
        boxed = (None, "mean") if derivatives else (None, "mean", "flow")
        is_boxed = self._is_uncertain and method in boxed
        motion = self._boxed if is_boxed else self._by_balls(method)
        if derivatives:
            return _with_sensitivities(motion.sensitivities(times, *limits), single)
        by = {"method": method} if is_boxed else {}
        return _split(([*q, *w] for q, w in motion.enclosures(times, *limits, **by)), single)

    @property
    def _is_uncertain(self) -> bool:
        return inputs.is_uncertain(*self.inertia, *self.omega0, *self.attitude0)

    def _by_balls(self, method: str | None) -> "PreciseMotion":
        """Return the arbitrary-precision motion for a method that has error bounds.

        Raises InputError for other methods.
        """
        from rigidsym.precise import ESTIMATED, METHODS

        if isinstance(method, str) and method in ESTIMATED:
            rule = f"has no error bounds; balls and sensitivities take {', '.join(METHODS)}"
            raise InputError("method", repr(method), rule)
        if method in ("mean", "flow") and not self._is_uncertain:
            raise InputError("method", method, "is for uncertain inputs, and these are exact")
        return self._by(method or "theta", self._given)

    @cached_property
    def _boxed(self) -> "BoxedMotion":
        from rigidsym.precise._boxed import BoxedMotion

        return BoxedMotion(**self._given)

    def symbolic(self, form: str | None = None) -> "Symbolic":
        """Return the motion as exact SymPy expressions of the time.

        Parameters
        ----------
        form : str
            "pi" or "theta", between the edges; "separatrix", "symmetric", "sphere" or "spin";
            "theorem1", the paper's; by default the one that serves the regime.  Each holds at all
            times, but "theorem1" not where Omega3 = 0.

        Raises
        ------
        InputError
            For other forms, for one that the regime has not, and for uncertain inputs.

        Examples
        --------
        >>> motion = TorqueFreeMotion((1, 2, 2.5), (0, 1, 0))
        >>> motion.symbolic().q().T
        Matrix([[cos(t/2), 0, sin(t/2), 0]])
        """
        from rigidsym.solution._symbolic import of_motion

        return of_motion(form, **self.exact)

    def plot(self, times: Times | None = None) -> "Figure":
        """Plot the body rates, the attitude and the momentum sphere.

        Rates and attitude are plotted against time.  Needs matplotlib.  The figure shows itself in
        a notebook, and has `savefig`.

        Parameters
        ----------
        times : array_like (N,)
            Times, s; by default some periods of the rates.

        Raises
        ------
        InputError
            For times as a call does, and for fewer than two of them.
        """
        from rigidsym.view._plots.motions import plot

        return plot(self, times)


@overload
def propagate(
    inertia: ArrayLike,
    omega0: ArrayLike,
    t: ArrayLike,
    attitude0: ArrayLike = IDENTITY,
    *,
    engine: str = engines.DEFAULT,
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
    engine: str = engines.DEFAULT,
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
    engine: str = engines.DEFAULT,
    out: tuple[np.ndarray, np.ndarray] | None = None,
    allow_nonphysical: bool = False,
    errors: str = "raise",
    degrees: bool = False,
    sensitivity: bool = False,
    columns: Iterable[str] | None = None,
) -> tuple[np.ndarray, np.ndarray] | tuple[np.ndarray, np.ndarray, Sensitivity]:
    """Return the states of many torque-free bodies at given times.

    Leading shapes broadcast; all numbers are float64.  Contiguous float64 arrays are read in place.
    For DataArrays of xarray the results are DataArrays with their dimensions and coordinates, for
    arrays of Dask they are lazy.

    Parameters
    ----------
    inertia : array_like (..., 3)
        Principal moments, kg m^2.
    omega0 : array_like (..., 3)
        Body rates at t = 0, rad/s.
    t : number or array_like (N,) or (..., N)
        Times, s: a number or (N,) for all bodies, (B, N) a row for each.  Dates (N,) count from the
        first one, and timedeltas are times.
    attitude0 : array_like (..., 4) or Rotation
        Attitude quaternions at t = 0, scalar first, body to inertial; they are normalised.
    engine : {"auto", "c", "c-portable", "numpy"}
        As for `TorqueFreeMotion`.
    out : pair of arrays
        Arrays of the shapes returned, to fill, which share no memory with each other or an input.
        Memory maps, Zarr arrays and others that take slices are written block by block.
    allow_nonphysical : bool
        Accept moments that no body has.
    errors : {"raise", "nan"}
        "nan": bodies and times that are refused have states of NaN.
    degrees : bool
        omega0 is in deg/s.
    sensitivity : bool
        Also return the derivatives, as `TorqueFreeMotion.sensitivity` does, by omega0 in rad/s;
        then there is no `out`.
    columns : some of "attitude0", "omega0", "inertia" and "t"
        The derivatives to return, all by default.

    Returns
    -------
    q : array (..., N, 4)
        Attitude quaternions, (..., 4) for a number t.
    omega : array (..., N, 3)
        Body rates, rad/s.
    sensitivity : Sensitivity
        With `sensitivity` alone.

    Raises
    ------
    InputError
        Names the first body or time that is refused by its index.

    Examples
    --------
    >>> q, omega = propagate([(1, 2, 2.5), (2, 3, 4)], (0.1, 0.2, 0.3), [0.0, 0.5, 1.0])
    >>> q.shape, omega.shape
    ((2, 3, 4), (2, 3, 3))
    """
    if layers.is_layered(inertia, omega0, t, attitude0):
        given = {"inertia": inertia, "omega0": omega0, "t": t, "attitude0": attitude0}
        options = {"engine": engine, "out": out, "allow_nonphysical": allow_nonphysical}
        more = {"errors": errors, "degrees": degrees, "sensitivity": sensitivity}
        return layers.called(propagate, given, **options, **more, columns=columns)
    lenient, chosen = engines.is_lenient(errors), engines.engine(engine)
    batch = batches.batch(inertia, omega0, attitude0, t, lenient, degrees, allow_nonphysical)
    with_sensitivity = inputs.is_true("sensitivity", sensitivity)
    if with_sensitivity and out is not None:
        raise InputError("out", "given", "sensitivities have arrays of their own")
    if not with_sensitivity and columns is not None:
        raise InputError("columns", repr(columns), "are of sensitivities: set sensitivity=True")
    try:
        if not with_sensitivity:
            return chosen.batch_states(batch, lenient, out)
        names = engines.columns(columns)
        found = chosen.batch_sensitivities(batch, lenient, names)
        return found[0], found[1], Sensitivity(*found[2:], names)
    except EngineError as error:
        given = {**batch.bodies, "t": batch.t, "engine": engine}
        raise batches.input_error(error, given) from None


def _floats(
    inertia: Vector3, omega0: Vector3, attitude0: Quaternion
) -> dict[str, tuple[float, ...]]:
    """Convert the inputs of a motion to floats, without the full checks.

    Returns them by name, or {} if they need these checks.
    """
    moments, rates = batches.moments(inertia), batches.floats(omega0, 3)
    start = _IDENTITY if attitude0 is IDENTITY else batches.floats(attitude0, 4)
    if moments is None or rates is None or start is None or not any(start):
        return {}
    return {"inertia": moments, "omega0": rates, "attitude0": start}


def _with_sensitivities(
    rows: "Iterable[Sequence[arb | mpf]]", single: bool
) -> tuple[np.ndarray, np.ndarray, Sensitivity]:
    """Split rows of 67 numbers into arrays of states and their derivatives."""
    q, omega, *changes, turns_t, rates_t = _split(rows, single, (4, 3, 27, 27, 3, 3))
    attitude, rates = (x.reshape(*x.shape[:-1], 3, 9) for x in changes)
    return q, omega, Sensitivity(attitude, rates, turns_t, rates_t)


def _split(
    rows: "Iterable[Sequence[arb | mpf]]", single: bool, widths: tuple[int, ...] = (4, 3)
) -> tuple[np.ndarray, ...]:
    """Split rows of numbers into object arrays of given widths.

    The axis of a single time is dropped.
    """
    listed = [*rows]
    arrays = [np.empty((len(listed), width), dtype=object) for width in widths]
    for k, row in enumerate(listed):
        end = 0
        for array in arrays:
            start, end = end, end + array.shape[1]
            array[k] = row[start:end]
    return tuple(array[0] if single else array for array in arrays)
