"""Both theta forms are the motion, by their published sequences over mpmath numbers."""

from fractions import Fraction

import pytest
from mpmath import mp, workdps
from textbook import FAMILIES, OCTANTS, ORDERS, Motion, conjugate, distance, draw, multiply

from rigidsym.precise import PreciseMotion
from rigidsym.solution._formulas import sequence

TURNS = (Fraction(37, 100), Fraction(-9, 10), Fraction(17, 10))
FORMS = ["circular", "hyperbolic"]


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
        begin = self.at(mp.mpf(0))
        norm = mp.sqrt(sum(mp.mpf(x.numerator) ** 2 for x in attitude))
        front = {f"qbar_{x}": begin[f"qbar_{x}"] for x in "0abd"}
        front |= {name: attitude[k].numerator / norm for name, k in self.places("q")}
        m |= sequence("pull_back").evaluate({**m, **front}, FUNCTIONS)

    def places(self, q):
        a, b, d = self.motion.axes
        return ((f"{q}_0", 0), (f"{q}_a", 1 + a), (f"{q}_b", 1 + b), (f"{q}_d", 1 + d))

    def at(self, t):
        known = sequence(f"{self.form}_state").evaluate({**self.known, "t": t}, FUNCTIONS)
        known["u"] = (1 + self.motion.k_1) * known["u_1"]
        return known | sequence("rates").evaluate(known, FUNCTIONS)

    def state(self, t):
        known, q, omega = self.at(t), [0] * 4, [0] * 3
        for name, place in self.places("q"):
            q[place] = known[name]
        for name, place in self.places("Omega")[1:]:
            omega[place - 1] = known[name]
        return q, omega


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("order", "about"), FAMILIES)
def test_the_programmes_give_the_motion(form, order, about):
    with workdps(42):
        for signs in OCTANTS[::3]:
            inertia, omega, attitude = draw(order, about, signs)
            found = Sequences(form, Motion(inertia, omega), attitude)
            times = [Fraction(int(found.motion.period * 100)) / 100 * turn for turn in TURNS]
            given = PreciseMotion(inertia, omega, attitude).states(times, 32)
            for time, expected in zip(times, given, strict=True):
                for part, right in zip(found.state(mp.mpf(1) * time), expected, strict=True):
                    assert distance(part, right) < 1e-30


@pytest.mark.parametrize("about", ["largest", "smallest"])
def test_the_forms_turn_at_rates_that_differ_by_the_gaussian_factor(about):
    with workdps(40):
        motion = Motion(*draw((0, 1, 2), about, (1, 1, 1))[:2])
        circular, hyperbolic = (Sequences(form, motion, (1, 0, 0, 0)) for form in FORMS)
        m = motion.k_1**2
        gap = mp.pi / (2 * mp.ellipk(m) * mp.ellipk(1 - m)) * circular.known["beta"]
        assert abs(hyperbolic.known["zeta"] - circular.known["zeta"] - gap) < 1e-36
        faster = hyperbolic.known["Lambda"] - circular.known["Lambda"]
        assert abs(faster - motion.rho * motion.mu * gap) < 1e-36


def on_the_separatrix(m, t):
    """qbar there: T4 = cos(z) and T1 = -i sin(z) of z = rho beta + i u_1, where x = tan(beta)."""
    z = mp.mpc(m.rho * mp.atan(m.x), m.mu * t + m.phase)
    turned = mp.expj((m.psi_0 / 2 + m.rho * m.mu * m.x) * t)
    four, one = turned * mp.cos(z), turned * mp.mpc(0, -1) * mp.sin(z)
    a, b, d = m.axes
    q = [mp.re(four), 0, 0, 0]
    q[1 + a], q[1 + b] = m.sigma * mp.im(four), m.chi * mp.im(one)
    q[1 + d] = -m.epsilon * m.sigma * m.chi * mp.re(one)
    norm = mp.sqrt(abs(four) ** 2 + abs(one) ** 2)
    return [x / norm for x in q]


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


@pytest.mark.parametrize("about", ["largest", "smallest"])
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
