"""Theta forms against precise motions: as printed, by the published sequences, and their tails."""

from fractions import Fraction
from random import Random

import pytest
from ledgers import CONTEXTS, FACTS
from mpmath import mp, workdps
from textbook import FAMILIES, OCTANTS, ORDERS, Motion, conjugate, distance, draw, multiply, number
from values import value_of

from rigidsym.language._expression import parse
from rigidsym.precise import PreciseMotion
from rigidsym.precise._taylor import integrate
from rigidsym.solution._formulas import sequence

FORMS = ["circular", "hyperbolic"]
ABOUT = pytest.mark.parametrize("about", ["largest", "smallest"])


def is_the_motion(form, inertia, omega, attitude, turns):
    """Compare states at some multiples of the period with those of the balls."""
    times = [Fraction(int(form.motion.period * 100)) / 100 * turn for turn in turns]
    given = PreciseMotion(inertia, omega, attitude).states(times, 32)
    for time, expected in zip(times, given, strict=True):
        for found, right in zip(form.state(mp.mpf(1) * time), expected, strict=True):
            assert distance(found, right) < 1e-30


def normed(attitude):
    norm = mp.sqrt(sum(number(x) ** 2 for x in attitude))
    return [number(x) / norm for x in attitude]


# As it is printed, by mpmath's theta functions.


class ThetaForm:
    """q and omega at any time, from the formulas at the head of the chapter."""

    def __init__(self, motion, attitude):
        m = self.motion = motion
        K_1, m_1 = mp.ellipk(m.k_1**2), m.k_1**2
        self.scale = mp.pi / (2 * K_1)
        self.nome = mp.exp(-mp.pi * mp.ellipk(1 - m_1) / K_1)
        self.beta = mp.ellipf(mp.atan(m.x), 1 - m_1)
        epsilon = mp.ellipe(mp.asin(mp.mpc(0, m.x)), m_1)
        self.zeta = mp.im(epsilon) - mp.ellipe(m_1) / K_1 * self.beta
        self.Lambda = m.psi_0 / 2 + m.rho * m.mu * self.zeta
        self.pull_back = multiply(normed(attitude), conjugate(self.qbar(0)))

    def qbar(self, t):
        m, turned = self.motion, mp.expj(self.Lambda * t)
        z = self.scale * (m.mu * t + m.phase - mp.mpc(0, m.rho * self.beta))
        first = turned * mp.jtheta(4, z, self.nome)
        second = mp.mpc(0, -m.chi) * turned * mp.jtheta(1, z, self.nome)
        return by_axes(m, first, mp.re(second), m.epsilon * m.sigma * mp.im(second))

    def state(self, t):
        qbar, m = self.qbar(t), self.motion
        axis = [0, 0, 0, 0]
        axis[1 + m.axes[0]] = m.sigma * m.K
        momentum = multiply(multiply(conjugate(qbar), axis), qbar)[1:]
        rates = [x / number(c) for x, c in zip(momentum, m.inertia, strict=True)]
        return multiply(self.pull_back, qbar), rates


def by_axes(m, first, about_b, about_d):
    """Return the unit quaternion along (first, about_b, about_d) on the axes of a motion."""
    a, b, d = m.axes
    q = [mp.re(first), 0, 0, 0]
    q[1 + a], q[1 + b], q[1 + d] = m.sigma * mp.im(first), about_b, about_d
    norm = mp.sqrt(sum(x**2 for x in q))
    return [x / norm for x in q]


@pytest.mark.parametrize(("order", "about"), FAMILIES)
def test_the_printed_form_is_the_motion(order, about):
    turns = (Fraction(37, 100), Fraction(-13, 5), Fraction(51, 10))
    with workdps(45):
        for signs in OCTANTS:
            inertia, omega, attitude = draw(order, about, signs)
            form = ThetaForm(Motion(inertia, omega), attitude)
            is_the_motion(form, inertia, omega, attitude, turns)


@pytest.mark.parametrize(("order", "about"), [FAMILIES[0], FAMILIES[3]])
def test_the_printed_form_is_the_motion_that_series_integrate(order, about):
    with workdps(45):
        inertia, omega, attitude = draw(order, about, (1, -1, -1))
        form = ThetaForm(Motion(inertia, omega), attitude)
        expected = integrate(inertia, omega, attitude, Fraction(-7, 4))
        for found, right in zip(form.state(mp.mpf(-7) / 4), expected, strict=True):
            assert distance(found, right) < 1e-35


@pytest.mark.parametrize("signs", [(1, 1, 1), (-1, 1, -1)])
def test_a_wrong_circulation_or_handedness_is_seen(signs):
    with workdps(40):
        inertia, omega, attitude = draw((0, 1, 2), "largest", signs)
        right = ThetaForm(Motion(inertia, omega), attitude).state(mp.mpf(3))
        for name in ("rho", "epsilon", "chi"):
            motion = Motion(inertia, omega)
            setattr(motion, name, -getattr(motion, name))
            assert distance(ThetaForm(motion, attitude).state(mp.mpf(3))[0], right[0]) > 1e-3


@pytest.mark.parametrize(("order", "about"), FAMILIES)
def test_the_shift_is_below_half_of_the_complementary_quarter_period(order, about):
    with workdps(40):
        for signs in OCTANTS:
            m = Motion(*draw(order, about, signs)[:2])
            beta = mp.ellipf(mp.atan(m.x), 1 - m.k_1**2)
            inside = 1 - m.k_1 * m.x**2
            assert 0 < 2 * beta < mp.ellipk(1 - m.k_1**2)
            assert abs(inside - 2 * m.B_a / (m.K + m.B_a)) < 1e-35
            dn = mp.ellipfun("dn", mp.mpc(0, (1 + m.k_1) * beta), m=m.m)
            assert abs(dn - m.K / m.B_a) < 1e-30


# By the published sequences, in both nomes, and at its edge.


def jacobi(kind):
    return lambda u, mc: mp.re(mp.ellipfun(kind, u, m=1 - mc))


def theta(kind, derivative=0):
    return lambda z, q: mp.jtheta(kind, z, q, derivative)


FUNCTIONS = {
    "pi": mp.pi,
    "I": mp.mpc(0, 1),
    "power": lambda x, n: x**n,
    "elliptic_k": lambda mc: mp.ellipk(1 - mc),
    "nome": lambda mc: mp.exp(-mp.pi * mp.ellipk(mc) / mp.ellipk(1 - mc)),
    **{name: getattr(mp, name) for name in ("re", "im", "cos", "sin", "sqrt")},
    **{f"jacobi_{x}n": jacobi(f"{x}n") for x in "scd"},
    **{f"theta{kind}": theta(kind) for kind in (1, 2, 3, 4)},
    **{f"dtheta{kind}": theta(kind, 1) for kind in (2, 4)},
}


class Sequences:
    """The state at any time by the sequences `form` and `form_state`, and by `rates`."""

    def __init__(self, form, motion, attitude):
        self.form, self.motion = form, motion
        m = self.known = {**vars(motion), "m_c": 1 - motion.k_1**2, "m_1": 1 - motion.m}
        m["tau"] = -motion.rho * motion.epsilon * motion.sigma
        m |= {"A_a": motion.B_a / motion.c_a, "A_d": motion.B_d / motion.c_d}
        m["B_b"] = mp.sqrt(motion.B_d**2 + motion.m * motion.B_a**2)
        m |= {"A_b": m["B_b"] / motion.c_b, "p_0": 1, "p_a": 0, "p_b": 0, "p_d": 0}
        shift = sequence("shift").evaluate(m, FUNCTIONS)
        m["beta"] = mp.ellipf(mp.asin(shift["s_beta"]), m["m_c"])
        m |= sequence(form).evaluate(m, FUNCTIONS)
        begin, unit = self.at(mp.mpf(0)), normed(attitude)
        front = {f"qbar_{x}": begin[f"qbar_{x}"] for x in "0abd"}
        front |= {f"q_{x}": unit[k] for x, k in self.places()}
        m |= sequence("pull_back").evaluate({**m, **front}, FUNCTIONS)

    def places(self):
        return zip("0abd", (0, *(1 + k for k in self.motion.axes)), strict=True)

    def at(self, t):
        known = sequence(f"{self.form}_state").evaluate({**self.known, "t": t}, FUNCTIONS)
        known["u"] = (1 + self.motion.k_1) * known["u_1"]
        return known | sequence("rates").evaluate(known, FUNCTIONS)

    def state(self, t):
        known, (scalar, *places) = self.at(t), sorted(self.places(), key=lambda place: place[1])
        q = [known[f"q_{x}"] for x, _ in (scalar, *places)]
        return q, [known[f"Omega_{x}"] for x, _ in places]


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("order", "about"), FAMILIES)
def test_the_sequences_give_the_motion(form, order, about):
    turns = (Fraction(37, 100), Fraction(-9, 10), Fraction(17, 10))
    with workdps(42):
        for signs in OCTANTS[::3]:
            inertia, omega, attitude = draw(order, about, signs)
            found = Sequences(form, Motion(inertia, omega), attitude)
            is_the_motion(found, inertia, omega, attitude, turns)


@ABOUT
def test_the_forms_turn_at_rates_that_differ_by_the_gaussian_factor(about):
    with workdps(40):
        motion = Motion(*draw((0, 1, 2), about, (1, 1, 1))[:2])
        circular, hyperbolic = (Sequences(form, motion, (1, 0, 0, 0)) for form in FORMS)
        m = motion.k_1**2
        gap = mp.pi / (2 * mp.ellipk(m) * mp.ellipk(1 - m)) * circular.known["beta"]
        assert abs(hyperbolic.known["zeta"] - circular.known["zeta"] - gap) < 1e-36
        faster = hyperbolic.known["Lambda"] - circular.known["Lambda"]
        assert abs(faster - motion.rho * motion.mu * gap) < 1e-36


@ABOUT
def test_half_a_period_later_the_hyperbolic_thetas_have_turned_by_the_shift(about):
    with workdps(40):
        motion = Motion(*draw((0, 1, 2), about, (1, 1, 1))[:2])
        form = Sequences("hyperbolic", motion, (1, 0, 0, 0))
        known, (here, there) = form.known, (form.at(t) for t in (mp.mpf(1), 1 + motion.period / 2))
        turn = mp.expj(-2 * motion.rho * known["gc"] * known["beta"])
        growth = mp.exp(2 * known["gc"] * here["u_1"]) / known["nome_c"]
        for name, sign in (("T4", 1), ("T1", -1)):
            before, after = (mp.mpc(at[f"{name}_re"], at[f"{name}_im"]) for at in (here, there))
            assert abs(after / (growth * turn * before) - sign) < 1e-34


def on_the_separatrix(m, t):
    """Return qbar by T4 = cos(z) and T1 = -i sin(z) of z = rho beta + i u_1, x = tan(beta)."""
    z = mp.mpc(m.rho * mp.atan(m.x), m.mu * t + m.phase)
    turned = mp.expj((m.psi_0 / 2 + m.rho * m.mu * m.x) * t)
    four, one = turned * mp.cos(z), turned * mp.mpc(0, -1) * mp.sin(z)
    return by_axes(m, four, m.chi * mp.im(one), -m.epsilon * m.sigma * m.chi * mp.re(one))


@pytest.mark.parametrize("order", ORDERS)
def test_the_elementary_form_is_the_motion_on_the_separatrix(order):
    with workdps(42):
        for signs in OCTANTS[::3]:
            inertia = tuple(Fraction((4, 5, 9)[k]) for k in order)
            omega = tuple(Fraction(s * (3, 1, 1)[k]) for s, k in zip(signs, order, strict=True))
            motion = Motion(inertia, omega)
            assert motion.m == 1
            times = [Fraction(5, 7), Fraction(-2)]
            given = PreciseMotion(inertia, omega, (1, 0, 0, 0)).states(times, 34)
            back = conjugate(on_the_separatrix(motion, 0))
            for t, (right, _) in zip(times, given, strict=True):
                found = multiply(back, on_the_separatrix(motion, mp.mpf(1) * t))
                assert distance(found, right) < 1e-30


# What a series leaves out.

TAIL, BOUND = CONTEXTS["theta_tail"]["reading"], FACTS["theta_tail.bound"]["lhs"][0]


def tail(kind, q, z, n):
    """Return theta_kind(z | q^2) less its terms before q**(2*n**2), n whole or half odd."""
    before = range(1, n) if kind == 4 else [mp.mpf(k) + 0.5 for k in range(int(n))]
    trig = mp.cos if kind == 4 else mp.sin
    terms = [2 * (-1) ** int(k) * q ** (2 * k * k) * trig(2 * k * z) for k in before]
    return mp.jtheta(kind, z, q**2) - mp.fsum(terms) - (kind == 4)


def read(name, q, b, n):
    formula = parse(TAIL[name].split(", ")[-1].replace("|Im z|", "b"))
    return value_of(formula, {"q": q, "b": b, "n": n}, {"exp": mp.exp})


@pytest.mark.parametrize("kind", [4, 1])
def test_what_a_series_leaves_out_is_within_the_bound(kind):
    random, tightest = Random(kind), 0
    rest = parse(BOUND).left.left
    with workdps(60):
        for _ in range(150):
            q, n = mp.mpf(random.uniform(0.001, 0.85)), random.randint(1, 4)
            n = n if kind == 4 else n + mp.mpf(0.5)
            b = -mp.log(q) / 2 * random.random()
            bound = value_of(rest, {name: read(name, q, b, n) for name in "trp"}, {})
            assert read("r", q, b, n) < q ** (4 * n + 1)
            for real in (0, mp.pi / 2, random.uniform(-9, 9)):
                left = abs(tail(kind, q, mp.mpc(real, b * random.choice((1, -1))), n))
                assert left <= bound
                tightest = max(tightest, left / bound)
            assert abs(tail(kind, q, mp.mpc(mp.pi / 2, b), n)) > bound / 4
    assert tightest > 0.9


def test_the_step_of_the_bound_is_from_one_cut_to_the_next():
    step, (q, b, n) = parse(BOUND), (mp.mpf("0.6"), mp.mpf("0.1"), 2)
    here, there = ({name: read(name, q, b, k) for name in "trp"} for k in (n, n + 1))
    assert abs(there["t"] - here["t"] * here["r"]) < 1e-14
    assert abs(there["r"] - here["p"] * here["r"]) < 1e-14
    after = value_of(step.left.left, there, {})
    assert abs(value_of(step.left.right, here, {}) - after) < 1e-14
    assert value_of(step.right, here, {}) == 2 * here["t"]
