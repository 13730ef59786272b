"""What each published sequence claims, compared with enclosures of the equations of motion.

A claim evaluates sequences of the ledger for one motion, and compares their outputs with numbers
that no formula of the ledger has made.  An output is compared if it is, or if one that it goes into
is.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any

from flint import acb, arb

from rigidsym._numbers._flow import (
    HALF,
    INPUTS,
    Course,
    Flow,
    conjugate,
    cross,
    kinematics,
    product,
    rotated,
)
from rigidsym._numbers._models import Model, solve
from rigidsym._numbers._motions import Motion
from rigidsym._numbers._values import Sequences, Values, number
from rigidsym.errors import LedgerError
from rigidsym.precise._balls import ball

# Balls of both sides have to be this small, relative to 1 or to their size.
WIDEST = arb(10) ** -5
AXES = ("a", "b", "d")
QUATERNION = ("0", *AXES)
# A far time is so many times the short one, in the other direction.
FAR = -3
# Terms of Fourier series below this are bounded together.
LEFT = arb(10) ** -14
IDENTITY = {"p_0": 1, "p_a": 0, "p_b": 0, "p_d": 0}
THIRD = Fraction(1, 3)
# What `shift` has to set, although another sequence has set a part of it.
SHIFTED = {"root_k", "x", "y", "z", "s_beta", "c_beta", "d_beta"}


class Case:
    """The claims about one motion."""

    def __init__(self, motion: Motion, sequences: Sequences) -> None:
        self.motion, self.sequences = motion, sequences
        self.flow, self.time = Flow(motion), motion.time
        names: dict[str, Any] = {**motion.signs, "t": 0}
        for x, k in zip(AXES, motion.axes, strict=True):
            names |= {f"c_{x}": motion.inertia[k], f"Omega_{x}": motion.omega0[k]}
            names |= {f"q_{x}": motion.attitude0[k + 1]}
        self.given = Values({**names, "q_0": motion.attitude0[0]}, {})

    # Comparison.

    def evaluate(
        self, sequence: str, given: Values, *others: Mapping[str, Any], **more: Any
    ) -> Values:
        """Evaluate a sequence on inputs, with more or other inputs by name."""
        try:
            return self.sequences.evaluate(sequence, given, *others, **more)
        except LedgerError as error:
            raise LedgerError(f"{error}, for {self.motion}") from None

    def same(self, values: Values, names: str, truth: Any, value: Any = None) -> None:
        """Refuse an output unless it, or a value made of several, may be the true one."""
        name, *others = names.split()
        for x in (name, *others):
            if x not in values.origins:
                raise LedgerError(f"ledger: no published sequence sets {x}, for {self.motion}")
        sequence, output = values.origins[name]
        value = values[name] if value is None else value
        place = f"sequence {sequence}: {output}"
        value, truth = (x if isinstance(x, acb) else ball(x) for x in (value, truth))
        if not acb(value).overlaps(acb(truth)):
            shown = " but ".join(x.str(12, radius=False) for x in (value, truth))
            motion = f"by the equations of motion, for {self.motion}"
            raise LedgerError(f"ledger: {place} is {shown} {motion}")
        for x in (value, truth):
            if not _radius(x) <= WIDEST * max(1, abs(x).mid()):
                raise LedgerError(f"ledger: {place} is not known to 5 digits, for {self.motion}")
        self.sequences.compared.update(values.origins[x] for x in (name, *others))

    def state(self, values: Values, course: Course, names: str = "q Omega") -> None:
        """Compare a state, or parts of it, by axes of the formulas."""
        kinds = names.split()
        for x, k in zip(AXES, self.motion.axes, strict=True):
            truths = {"q": course.q[k + 1], "Omega": course.omega[k]}
            truths["M"] = self.flow.c[k] * course.omega[k]
            for kind in kinds:
                self.same(values, f"{kind}_{x}", truths[kind])
        if "q" in kinds:
            self.same(values, "q_0", course.q[0])

    # The motion by the equations alone.

    @cached_property
    def near(self) -> Course:
        """The motion at the short time, with derivatives by the inputs."""
        return self.flow.after(self.time, varied=True)

    @cached_property
    def back(self) -> Course:
        """The motion at the opposite of the short time."""
        return self.flow.after(-self.time)

    @cached_property
    def far(self) -> Course:
        """The motion at a longer time in the other direction."""
        return self.flow.after(FAR * self.time)

    @property
    def times(self) -> list[tuple[Fraction, Course]]:
        """Three times with the motion there."""
        start = Course(arb(0), self.flow.omega0, self.flow.q0)
        return [(Fraction(0), start), (self.time, self.near), (FAR * self.time, self.far)]

    def half_psi(self, course: Course, begin: Course | None = None) -> acb:
        """Return exp(i psi/2), the turn about the momentum, since the start or another time."""
        begin = begin or Course(arb(0), self.flow.omega0, self.flow.q0)
        before, after = (self._shortest(x) for x in (begin, course))
        turn = product(product(product(before, conjugate(begin.q)), course.q), conjugate(after))
        sigma, a = self.motion.signs["sigma"], self.motion.axes[0]
        return acb(turn[0], sigma * turn[a + 1])

    # Values of sequences that several claims and contexts need.

    @cached_property
    def constants(self) -> Values:
        """The constants of the motion."""
        return self.evaluate("constants", self.given, cos_half_psi=1, sin_half_psi=0)

    @cached_property
    def theta_forms(self) -> dict[str, Values]:
        """The constants of each theta form, with the quaternion in front."""
        constants, found = self.constants, {}
        theta = self.evaluate("theta", constants)
        shift = self.evaluate("shift", theta.without(SHIFTED)).of(" ".join(sorted(SHIFTED)))
        shifted = constants.plus(shift, theta.of("B_a B_d beta"))
        forms = {"theta_state": constants.plus(theta)}
        for name in ("circular", "hyperbolic"):
            forms[f"{name}_state"] = shifted.plus(self.evaluate(name, shifted))
        for name, known in forms.items():
            begin = self.evaluate(name, known.plus(IDENTITY), t=0)
            given = known.plus(begin, self.given.of("q_0 q_a q_b q_d"))
            front = self.evaluate("pull_back", given).of("p_0 p_a p_b p_d")
            found[name] = known.plus(front)
        return found

    @property
    def worlds(self) -> dict[str, Callable[[arb], Values]]:
        """The values of constants and of what sequences set, as functions of the time.

        There are none on the edges of regimes, where contexts of theta functions do not apply, and
        for the first motion of a kind only.
        """
        if self.motion.number > 1:
            forms = {}
        elif self.motion.circulates:
            forms = {"state": self.constants, **self.theta_forms}
        elif not self.motion.moves and self.motion.kind != "rest":
            names = {f"p{k}": x for k, x in enumerate(self.motion.attitude0)}
            names |= {f"c{k + 1}": x for k, x in enumerate(self.motion.inertia)}
            names |= {f"Omega{k + 1}": x for k, x in enumerate(self.motion.omega0)}
            forms = {"steady": Values(names, {})}
        else:
            forms = {}
        moving = {"u", *(x for x, _ in self.sequences.published("state").formulas)}
        return {name: self._world(name, known.without(moving)) for name, known in forms.items()}

    def _world(self, sequence: str, fixed: Values) -> Callable[[arb], Values]:
        return lambda t: self.evaluate(sequence, fixed, t=t)

    def sine(self, i: int) -> Values:
        """Return the constants of the sine of the rate about an axis other than a."""
        a, c, w = self.motion.axes[0], self.motion.inertia, self.motion.omega0
        half = -1 if (c[i - 2] - c[i - 1]) * w[i - 2] * w[i - 1] < 0 else 1
        names: dict[str, Any] = {"half": half}
        for x, k in zip("ijk", (i, a, 3 - i - a), strict=True):
            names |= {f"c_{x}": c[k], f"Omega_{x}": w[k]}
        return self.evaluate("sine", Values(names, {}))

    def theorem1(self, t: Any, rates: Sequence[Any]) -> Values:
        """Return the attitude by Theorem 1, where axis 1 is not a."""
        begin = {f"c{k + 1}": x for k, x in enumerate(self.motion.inertia)}
        begin |= {f"Omega{k + 1}": x for k, x in enumerate(self.motion.omega0)}
        sine = self.sine(0)
        known = Values(begin, {}).plus(sine.of("zeta xi mu C_i"))
        known["C_1"], known.origins["C_1"] = known["C_i"], known.origins["C_i"]
        now = {f"Omega{k + 1}": x for k, x in enumerate(rates)}
        side = -1 if self.motion.omega0[2] < 0 else 1
        return self.evaluate(
            "theorem1_state", self.evaluate("theorem1", known), now, t=t, side=side
        )

    def _shortest(self, course: Course) -> list[arb]:
        """Return the shortest turn that takes the momentum to sigma e_a."""
        momentum = [c * w for c, w in zip(self.flow.c, course.omega, strict=True)]
        size = sum((x * x for x in momentum), arb(0)).sqrt()
        sigma, a = self.motion.signs["sigma"], self.motion.axes[0]
        goal = [sigma * size if k == a else arb(0) for k in range(3)]
        turn = [size * size + sigma * size * momentum[a], *cross(momentum, goal)]
        norm = sum((x * x for x in turn), arb(0)).sqrt()
        return [x / norm for x in turn]


def _radius(x: arb | acb) -> arb:
    return x.rad() if isinstance(x, arb) else x.real.rad().max(x.imag.rad())


def regular(case: Case) -> None:
    """Compare constants, states, rates and what is put together of them."""
    constants = case.constants
    energy = sum((c * w * w for c, w in zip(case.flow.c, case.flow.omega0, strict=True)), arb(0))
    case.same(constants, "H", energy / 2)
    for time, course in case.times:
        known = case.evaluate("state", constants, t=time)
        case.state(known, course, "q Omega M")
        turn = case.half_psi(course)
        case.same(known, "cos_half_psi", turn.real)
        case.same(known, "sin_half_psi", turn.imag)
        case.state(case.evaluate("turned", known), course, "q")
        later = constants["u"] + constants["lambda_"] * ball(time)
        rates = case.evaluate("rates", constants.plus(u=later))
        case.state(rates, course, "Omega")
        for name in ("sn", "cn", "dn"):
            case.same(rates, name, known[name])
            function = case.sequences.functions[f"jacobi_{name}"]
            case.same(known, name[0], function(number(known["u_1"]), number(known["m_c"])))


def by_thetas(case: Case) -> None:
    """Compare the three theta forms, where the modulus is neither 0 nor 1."""
    functions, forms = case.sequences.functions, case.theta_forms
    shift, modulus = forms["circular_state"], number(forms["theta_state"]["k_1"])
    for name, kind in {"s_beta": "sn", "c_beta": "cn", "d_beta": "dn"}.items():
        case.same(shift, name, functions[f"jacobi_{kind}"](shift["beta"], modulus**2))
    for name, known in forms.items():
        for time, course in case.times:
            found = case.evaluate(name, known, t=time)
            case.state(found, course, "q")
            if name != "theta_state":
                found = case.evaluate("momentum", found)
            case.state(found, course, "Omega M")


def integrals(case: Case) -> None:
    """Compare psi by integrals of the third kind, by periods and by Fourier series."""
    constants, theta = case.constants, case.theta_forms["theta_state"]
    known = case.evaluate("shift", theta.without(SHIFTED))
    periods = case.evaluate("periods", constants)
    mean = periods["J_c"] / periods["K_1"]
    _periods(case, periods)
    start = case.evaluate("state", constants, t=0)
    given = found = known.plus(periods.of("K_1"), j=mean)
    tables = case.sequences.functions
    for time, course in case.times:
        turn, state = case.half_psi(course), case.evaluate("state", constants, t=time)
        found = case.evaluate("pi_circular", given.plus(state.of("J u_1")))
        angle = found["Lambda"] * ball(time) + found["rest"] - found["rest_0"]
        _turned(case, found, "Lambda rest rest_0", angle, turn)
        # Near the saddle: X turns by psi/2 but for the arctangent.
        zero = {"X_re": 1, "X_im": 0}
        first = case.evaluate("pi_hyperbolic", given.plus(start.of("s c d"), zero))
        third = [
            tables["elliptic_j"](u, first["n_2"], number(known["m_c"]))
            for u in (state["u_1"], start["u_1"])
        ]
        rho, phase = case.motion.signs["rho"], first["Lambda"] * ball(time)
        moved = number(known["mu"]) * ball(time)
        phase -= rho * (first["g_1"] * moved + first["g_2"] * (third[0] - third[1]))
        found = case.evaluate(
            "pi_hyperbolic", given.plus(state.of("s c d"), X_re=phase.cos(), X_im=phase.sin())
        )
        begin = acb(first["cos_half_psi"], -first["sin_half_psi"])
        value = acb(found["cos_half_psi"], found["sin_half_psi"]) * begin
        case.same(found, "cos_half_psi sin_half_psi Lambda g_1 g_2 n_2", turn, value)
        # Far from it, by the same integral at K_1 - u_1.
        past = [
            tables["elliptic_j"](periods["K_1"] - u, first["n_2"], number(known["m_c"]))
            for u in (state["u_1"], start["u_1"])
        ]
        angle = first["Lambda"] * ball(time) - rho * (
            first["g_1"] * moved - first["h_2"] * (past[0] - past[1])
        )
        _turned(case, found, "h_2 g_1", angle, turn)
    rate = (
        found["Lambda"] - case.motion.signs["rho"] * found["alpha"] * known["mu"] / periods["K_1"]
    )
    case.same(found, "alpha", periods["psi_mean"] / 2, rate)
    _series(case, known, start)


def _turned(case: Case, values: Values, name: str, angle: arb, turn: acb) -> None:
    """Compare an angle with the turn of psi/2."""
    case.same(values, name, turn, acb(angle.cos(), angle.sin()))


def _periods(case: Case, periods: Values) -> None:
    """Compare periods with the motion half a period later, where two rates are reversed."""
    half = periods["period"] / 2
    path = case.flow.path(half)
    course, (a, b, d) = path[-1], case.motion.axes
    for k in range(3):
        case.same(periods, "period", case.flow.omega0[k], course.omega[k] * (1 if k == a else -1))
    # The rates about b and d have gone through half a turn, and not through more.
    angle = arb(0)
    for before, after in pairwise(path):
        x, y = (acb(e.omega[b], e.omega[d]) for e in (before, after))
        angle += abs((y / x).arg())
    case.same(periods, "period", arb.pi(), angle)
    angle = periods["psi_mean"] * half / 2
    _turned(case, periods, "psi_mean", angle, case.half_psi(course))
    case.same(periods, "Omega_mean", course.sums[a], periods["Omega_mean"] * half)


def _series(case: Case, known: Values, start: Values) -> None:
    """Compare Fourier series of Jacobi's functions (DLMF 22.11.1 to 22.11.3) and of psi/2."""
    functions, rho = case.sequences.functions, case.motion.signs["rho"]
    scale, nome, mc = known["g"], known["nome_1"], number(known["m_c"])
    first, moved = number(start["u_1"]), number(known["mu"]) * ball(case.time)
    v, modulus = scale * (first + moved), (1 - mc).sqrt()
    for kind, e in (("sn", 1), ("cn", -1), ("dn", -1)):
        wave, odd = arb.sin if kind == "sn" else arb.cos, kind != "dn"
        total, n = arb(0) if odd else arb(1) / 4, 1
        while True:
            x = nome ** (n - arb(odd) / 2)
            found = case.evaluate("fourier", Values({"x": x, "e": e}, {}))
            total += found["a"] * wave((2 * n - odd) * v)
            n += 1
            if found["a"] < LEFT:
                break
        value = 4 * scale / (modulus if odd else 1) * (total + arb(0, (2 * found["a"]).upper()))
        case.same(found, "a", functions[f"jacobi_{kind}"](first + moved, mc), value)
    angle, n = known["Lambda"] * ball(case.time), 1
    while True:
        given = Values({"x": nome**n, "k": n, "rho": rho}, {})
        found = case.evaluate("fourier_rest", given, sinh_b=(2 * n * scale * known["beta"]).sinh())
        angle += found["rest_k"] * ((2 * n * v).sin() - (2 * n * scale * first).sin())
        n += 1
        if abs(found["rest_k"]) < LEFT:
            break
    # Terms decrease at least as fast as the nome times exp(2 b), which is below 1.
    ratio = nome * (2 * scale * known["beta"]).exp()
    angle += arb(0, (2 * abs(found["rest_k"]) * ratio / (1 - ratio)).upper())
    _turned(case, found, "rest_k", angle, case.half_psi(case.near))


def sines(case: Case) -> None:
    """Compare rates by Lemma 1, and the attitude by Theorem 1 and the rate about axis 1."""
    for i in {0, 1, 2} - {case.motion.axes[0]}:
        sine = case.sine(i)
        for time, course in case.times:
            case.same(case.evaluate("sine_state", sine, t=time), "Omega_i", course.omega[i])
    if case.motion.axes[0] == 0:
        return
    front = Values({}, {})
    # The rates do not change their signs so soon.
    for time, course in case.times[:2]:
        found = case.theorem1(time, course.omega)
        for k, x in enumerate(QUATERNION):
            name = f"qbar_{k}"
            found[f"qbar_{x}"], found.origins[f"qbar_{x}"] = found[name], found.origins[name]
        if not front:
            case.same(found, "phi1", 0)
            start = {f"q_{x}": y for x, y in zip(QUATERNION, case.flow.q0, strict=True)}
            front = case.evaluate("pull_back", found, start, epsilon=1).of("p_0 p_a p_b p_d")
        turned = case.evaluate("turned", found, front, epsilon=1)
        for x, y in zip(QUATERNION, course.q, strict=True):
            case.same(turned, f"q_{x}", y)


def steady(case: Case) -> None:
    """Compare motions with constant rates."""
    names = {f"p{k}": x for k, x in enumerate(case.motion.attitude0)}
    names |= {f"Omega{k + 1}": x for k, x in enumerate(case.motion.omega0)}
    for time, course in case.times:
        found = case.evaluate("steady", Values(names, {}), t=time)
        for k, x in enumerate(course.q):
            case.same(found, f"q{k}", x)


def steps(case: Case) -> None:
    """Compare a step from any state, its doubling and its parts with the flow."""
    given = {n: x for n, x in case.given.items() if not n.startswith("Omega")}
    given |= {f"Omega_{x}0": case.given[f"Omega_{x}"] for x in AXES}
    known = case.evaluate("step", Values(given, {}))
    time, courses = ball(case.time), {1: case.near, 2: case.flow.after(2 * case.time)}
    models = {1: _elapsed(known, [arb(0), arb(1)], time)}
    models[2] = _elapsed(known, [x.end() for x in models[1]], time)
    xy = {n: [x.end() for x in model] for n, model in models.items()}
    doubled = case.evaluate("doubling", known, X=xy[1][0], Y=xy[1][1])
    for name, value in zip(("X_next", "Y_next"), xy[2], strict=True):
        case.same(doubled, name, value)
    for n, course in courses.items():
        at = known.plus(doubled.of("X_next Y_next") if n == 2 else {}, X=xy[n][0], Y=xy[n][1])
        rates = case.evaluate("step_rates", at)
        case.state(rates, course, "Omega")
        found = case.evaluate("projection", at)
        a, b, d = case.motion.axes
        momentum = [c * w for c, w in zip(case.flow.c, course.omega, strict=True)]
        sigma, epsilon = case.motion.signs["sigma"], case.motion.signs["epsilon"]
        below = known["K"] + sigma * momentum[a]
        case.same(found, "w_re", momentum[d] / below)
        case.same(found, "w_im", sigma * epsilon * momentum[b] / below)
    found = case.evaluate("projection", known, X=xy[1][0], Y=xy[1][1])
    half = known["psi_0"] * time / 2
    angle = _third_kind(found, models[1][0])
    parts = {"T_re": half.cos(), "T_im": half.sin(), "E_re": angle.cos(), "E_im": angle.sin()}
    found = found.without({"square"})
    thirds = case.evaluate("thirds", found, parts)
    turn = case.half_psi(case.near)
    case.same(thirds, "cos_half_psi psi_0 rate_re rate_im", turn.real)
    case.same(thirds, "sin_half_psi", turn.imag)
    case.same(thirds, "square", thirds["R"] ** 2)
    start = Course(arb(0), case.flow.omega0, case.flow.q0)
    before = case.half_psi(start, case.back)
    second = case.evaluate("second_half", found, W_re=before.real, W_im=before.imag)
    for name, value in {"V_re": turn.real, "V_im": turn.imag, "square": second["R"] ** 2}.items():
        case.same(second, name, value)


def _elapsed(known: Values, start: list[arb], time: arb) -> list[Model]:
    """Return X and Y for a time, with X' = Y and Y' = -e_1 X + 2 e_2 X^3."""
    e_1, e_2 = number(known["e_1"]), number(known["e_2"])

    def right(v: Sequence[Any], _: Sequence[Any]) -> list[Any]:
        x, y = v
        return [y, x * (x * x * (2 * e_2) - e_1)]

    return solve(right, start, time)


def _third_kind(found: Values, x: Model) -> arb:
    """Return the integral of J_rate over the time of X, by the constants of the projection."""
    square = x * x
    names = ("nu_re", "nu_im", "rate_re", "rate_im")
    nu_re, nu_im, rate_re, rate_im = (number(found[name]) for name in names)
    g_re, g_im = 1 - square * nu_re, -(square * nu_im)
    rate = square * (g_re * rate_im - g_im * rate_re) / (g_re * g_re + g_im * g_im)
    return rate.integral().end()


def kicks(case: Case) -> None:
    """Compare a kick's torque with the derivative of its potential by turns of the body."""
    names = ("u1", "u2", "u3", "b1", "b2", "b3", "k", "m1", "m2", "m3")
    names += ("Q11", "Q22", "Q33", "Q23", "Q13", "Q12")
    given = dict(zip(names, case.motion.spare, strict=False))
    q = [ball(x) for x in case.motion.attitude0]
    found = case.evaluate("kick", Values({**given, **{f"q{k}": x for k, x in enumerate(q)}}, {}))
    u, b, m = ([ball(given[f"{x}{k}"]) for k in (1, 2, 3)] for x in "ubm")
    v = rotated(conjugate(q), u)
    matrix = [[ball(given[f"Q{min(i, j)}{max(i, j)}"]) for j in (1, 2, 3)] for i in (1, 2, 3)]
    for i in range(3):
        # The body turns about its axis i: q' = q (0, e_i)/2, and v = q* u q.
        rate = kinematics(q, [HALF * int(i == j) for j in range(3)])
        spaces = product(product(conjugate(rate), [arb(0), *u]), q)
        others = product(product(conjugate(q), [arb(0), *u]), rate)
        dv = [x + y for x, y in zip(spaces[1:], others[1:], strict=True)]
        pulled = [sum((x * y for x, y in zip(row, v, strict=True)), arb(0)) for row in matrix]
        slope = sum((d * (x - y) for d, x, y in zip(dv, pulled, m, strict=True)), arb(0))
        case.same(found, f"T{i + 1}", b[i] + ball(given["k"]) * v[i] - slope)


def sensitivities(case: Case) -> None:
    """Compare derivatives of the rates by all inputs, and the integrals that they are made from."""
    given = {n: x for n, x in case.given.items() if not n.startswith("Omega")}
    given |= {f"Omega_{x}0": case.given[f"Omega_{x}"] for x in AXES}
    moments = case.evaluate("moments", Values(given, {}))
    columns = case.evaluate("columns", moments)
    p, r, time = number(columns["p"]), number(columns["r"]), ball(case.time)
    triple = _Triple(p, r, time)
    known = moments.plus(columns, triple.values, t=case.time)
    found = case.evaluate("sensitivity", known)
    course, axes = case.near, dict(zip(AXES, case.motion.axes, strict=True))
    case.state(found, course, "Omega")
    for x, i in axes.items():
        for y, k in axes.items():
            case.same(found, f"Omega_{x}_by_Omega_{y}", course.by_input[f"Omega{k + 1}"][i])
            case.same(found, f"Omega_{x}_by_c_{y}", course.by_input[f"c{k + 1}"][i])
    excess = {x: course.squares[k] - case.flow.omega0[k] ** 2 * time for x, k in axes.items()}
    case.same(found, "excess_b", excess["b"])
    slopes = case.evaluate("elapsed_slopes", known.plus(triple.fourth))
    for name, value in triple.slopes.items():
        case.same(slopes, name, value)
    if not case.motion.moves:
        return
    found = known.plus(found)
    for x in "ad":
        case.same(case.evaluate("excesses", found), f"excess_{x}", excess[x])
    spun = case.evaluate("spun", found)
    case.same(spun, "excess_spun", excess["b"])
    case.same(spun, "swung", case.near.omega[axes["b"]] - case.flow.omega0[axes["b"]])
    case.same(case.evaluate("elapsed_E", known), "E_t", triple.values["E_t"])
    if not case.motion.circulates:
        return
    case.same(case.evaluate("elapsed_F", known), "F_t", triple.values["F_t"])
    fourth = case.evaluate("fourth_powers", known)
    for name, value in triple.fourth.items():
        case.same(fourth, name, value)
    middle = case.evaluate("middle", found)
    for x in "ad":
        case.same(middle, f"middle_by_Omega_{x}", course.by_input[f"Omega{axes[x] + 1}"][axes["b"]])
    passing = case.evaluate("passing", found)
    for x in AXES:
        case.same(passing, f"Omega_{x}_p", found[f"Omega_{x}_k"] - found[f"Omega_{x}_r"])


class _Triple:
    """S, C and D with S' = C D, C' = -p S D, D' = -r S C, and integrals and changes of them."""

    def __init__(self, p: arb, r: arb, time: arb) -> None:
        def right(v: Sequence[Any], _: Sequence[Any]) -> list[Any]:
            s, c, d = v
            return [c * d, s * d * -p, s * c * -r]

        s, c, d = models = solve(right, [arb(0), arb(1), arb(1)], time)
        square, below = s * s, (d * d).inverse()
        quotient = square * below
        self.values = {"S_t": s.end(), "C_t": c.end(), "D_t": d.end()}
        self.values |= {"E_t": square.integral().end(), "F_t": quotient.integral().end()}
        powers = {"U_t": square * square, "V_t": square * quotient, "W_t": quotient * quotient}
        self.fourth = {name: x.integral().end() for name, x in powers.items()}
        self.slopes = {}
        for name, by_p in (("k", 1), ("r", 0)):

            def varied(v: Sequence[Any], given: Sequence[Any], by_p: int = by_p) -> list[Any]:
                (x, y, z), (s, c, d) = v, given
                return [
                    y * d + c * z,
                    (x * d + s * z) * -p - s * d * by_p,
                    (x * c + s * y) * -r - s * c,
                ]

            x, y, z = solve(varied, [arb(0)] * 3, time, models)
            changes = {"S": x, "C": y, "D": z, "E": (s * x * 2).integral()}
            changes["F"] = ((s * x - quotient * d * z) * below * 2).integral()
            self.slopes |= {f"{key}_{name}": model.end() for key, model in changes.items()}


def turns(case: Case) -> None:
    """Compare the small turns of the body by each input, by time, and by a change of all inputs."""
    course, c, w0 = case.near, case.flow.c, case.flow.omega0
    begin = {f"c{k + 1}": x for k, x in enumerate(case.motion.inertia)}
    names = {f"p{k}": x for k, x in enumerate(case.motion.attitude0)}
    names |= {f"Omega{k + 1}_0": x for k, x in enumerate(case.motion.omega0)}
    known = case.evaluate("turn_constants", Values({**begin, **names}, {}))
    now = {f"q{k}": x for k, x in enumerate(course.q)}
    now |= {f"Omega{k + 1}": x for k, x in enumerate(course.omega)}
    time = ball(case.time)
    more = {f"excess{k + 1}": course.squares[k] - w0[k] ** 2 * time for k in range(3)}
    more |= {f"Omega{i + 1}_by_{x}": course.by_input[x][i] for x in INPUTS for i in range(3)}
    found = case.evaluate("turn", known.plus(now, more), t=case.time)
    rates = case.flow.slopes(course.omega)
    for i, turning in enumerate(rotated(course.q, course.omega)):
        case.same(found, f"eta{i + 1}_by_t", turning)
        case.same(found, f"Omega{i + 1}_by_t", rates[i])
        for x in INPUTS:
            case.same(found, f"eta{i + 1}_by_{x}", course.turned[x][i])
    # A change of all inputs at once.
    changes = dict(zip(INPUTS, map(ball, case.motion.spare), strict=False))

    def changed(columns: dict[str, list[arb]]) -> list[arb]:
        return [sum((h * columns[x][i] for x, h in changes.items()), arb(0)) for i in range(3)]

    dc, dw0, dw = (
        [changes[f"c{k}"] for k in (1, 2, 3)],
        [changes[f"Omega{k}"] for k in (1, 2, 3)],
        changed(course.by_input),
    )
    gained = [dc[k] * w0[k] + c[k] * dw0[k] for k in range(3)]
    kept = rotated(conjugate(course.q), rotated(case.flow.q0, gained))
    energy = sum((dc[k] * w0[k] ** 2 / 2 + c[k] * w0[k] * dw0[k] for k in range(3)), arb(0))
    # s is the small turn along the momentum, times its length, xi.M.
    turned = rotated(conjugate(course.q), changed(course.turned))
    momentum = [x * y for x, y in zip(c, course.omega, strict=True)]
    size = sum((x * x for x in momentum), arb(0)).sqrt()
    given = {
        **begin,
        **now,
        "K": size,
        "s": energy * time - sum((dc[k] * course.squares[k] / 2 for k in range(3)), arb(0)),
    }
    given |= {
        f"{x}{k + 1}": y
        for x, values in {"dc": dc, "dOmega": dw, "l": kept}.items()
        for k, y in enumerate(values)
    }
    found = case.evaluate("turned_body", Values(given, {}))
    for k, x in enumerate(kinematics(course.q, [x * HALF for x in turned])):
        case.same(found, f"dq{k}", x)


def descents(case: Case) -> None:
    """Compare Landen's steps down and up, and the scaled shift, with Jacobi's functions."""
    k, kc, shift, u, scale = _modulus(case.motion.spare)
    functions = case.sequences.functions

    def jacobi(u: arb, mc: arb) -> list[arb]:
        return [functions[f"jacobi_{x}n"](u, mc) for x in "scd"]

    def at(k: arb, kc: arb, u: arb, beta: arb) -> dict[str, arb]:
        s, c, d = jacobi(u, kc * kc)
        x, y, _ = jacobi(beta, k * k)
        return {
            "s": s,
            "c": c,
            "d": d,
            "k": k,
            "kc": kc,
            "K": functions["elliptic_k"](kc * kc),
            "x": x / y,
        }

    # DLMF 22.7(i), 22.7(ii); 19.8(ii)
    k_next = (1 - kc) / (1 + kc)
    kc_next = (1 - k_next * k_next).sqrt()
    first = at(k, kc, u, shift)
    then = at(k_next, kc_next, u / (1 + k_next), shift / (1 + k_next))
    given = {x: first[x] for x in ("s", "c", "d", "k", "kc")} | {"K_next": then["K"]}
    given |= {"r": k / scale**2, "Y": scale * first["x"]}
    found = case.evaluate("landen", Values(given, {}))
    for x in ("s", "c", "d", "k", "kc"):
        case.same(found, f"{x}_next", then[x])
    case.same(found, "K", first["K"])
    case.same(found, "r_next", k_next / scale**2)
    case.same(found, "Y_next", scale * then["x"])
    later = {f"{x}_next": then[x] for x in ("s", "c", "d", "k", "x")}
    found = case.evaluate("ascent", Values(later, {}))
    for x in ("s", "c", "d", "x"):
        case.same(found, x, first[x])
    # k_1 = r Q and x = Y/sqrt(Q), with Q = h_plus h_minus and Y_b half of the difference.
    amplitudes = {"B_a": 3 * scale, "B_d": 4 * scale, "K": 5 * scale}
    given = {**amplitudes, "r": u * u, "k_1": k, "Y_b": kc}
    found = case.evaluate("scaling", Values(given, {}))
    case.same(found, "h_plus", k, found["h_plus"] * found["h_minus"] * u * u)
    case.same(found, "h_minus", kc, (found["h_plus"] - found["h_minus"]) / 2)
    case.same(found, "Y", 1 / k.sqrt() / 2, found["Y"] / found["Q"].sqrt())
    for x in ("root_r", "Q", "h_plus", "h_minus"):
        case.same(found, x, abs(found[x]))


def _modulus(spare: Sequence[Fraction]) -> tuple[arb, ...]:
    """Return a modulus, its complement, a shift, an argument and a scale."""
    k = ball(abs(spare[0]) / (1 + abs(spare[0])))
    return (k, (1 - k * k).sqrt(), *(ball(abs(x) / 2 + THIRD) for x in spare[1:4]))


# Claims, each with the motions that it holds for.
CLAIMS: list[tuple[Callable[[Case], None], Callable[[Motion], bool]]] = [
    (steady, lambda motion: not motion.moves and motion.kind != "rest"),
    (regular, lambda motion: motion.moves),
    (by_thetas, lambda motion: motion.circulates),
    (sines, lambda motion: motion.circulates),
    (integrals, lambda motion: motion.circulates),
    (steps, lambda motion: motion.kind != "rest"),
    (sensitivities, lambda motion: True),
    (turns, lambda motion: motion.kind != "rest"),
    (kicks, lambda motion: True),
    (descents, lambda motion: True),
]
