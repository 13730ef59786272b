"""The theta form as it is printed, by mpmath's theta functions; what its series leave out."""

import json
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
from mpmath import mp, workdps
from textbook import FAMILIES, OCTANTS, Motion, conjugate, distance, draw, multiply
from values import value_of

import derivations
from rigidsym.language._expression import parse
from rigidsym.precise import PreciseMotion
from rigidsym.precise._taylor import integrate

LEDGER = json.loads(Path(derivations.__file__).with_name("ledger.json").read_text("utf-8"))
(TAIL,) = (c["reading"] for c in LEDGER["contexts"] if c["name"] == "theta_tail")
(BOUND,) = (f["lhs"][0] for f in LEDGER["facts"] if f["id"] == "theta_tail.bound")
TURNS = (Fraction(37, 100), Fraction(-13, 5), Fraction(51, 10))


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
        norm = mp.sqrt(sum(mp.mpf(x.numerator) ** 2 for x in attitude))
        self.pull_back = multiply([x.numerator / norm for x in attitude], conjugate(self.qbar(0)))

    def qbar(self, t):
        m, turned = self.motion, mp.expj(self.Lambda * t)
        z = self.scale * (m.mu * t + m.phase - mp.mpc(0, m.rho * self.beta))
        first = turned * mp.jtheta(4, z, self.nome)
        second = mp.mpc(0, -m.chi) * turned * mp.jtheta(1, z, self.nome)
        a, b, d = m.axes
        q = [mp.re(first), 0, 0, 0]
        q[1 + a] = m.sigma * mp.im(first)
        q[1 + b], q[1 + d] = mp.re(second), m.epsilon * m.sigma * mp.im(second)
        norm = mp.sqrt(abs(first) ** 2 + abs(second) ** 2)
        return [x / norm for x in q]

    def state(self, t):
        qbar, m = self.qbar(t), self.motion
        axis = [0, 0, 0, 0]
        axis[1 + m.axes[0]] = m.sigma * m.K
        momentum = multiply(multiply(conjugate(qbar), axis), qbar)[1:]
        q = multiply(self.pull_back, qbar)
        return q, [
            x * c.denominator / c.numerator for x, c in zip(momentum, m.inertia, strict=True)
        ]


@pytest.mark.parametrize(("order", "about"), FAMILIES)
def test_the_printed_form_is_the_motion(order, about):
    with workdps(45):
        for signs in OCTANTS:
            inertia, omega, attitude = draw(order, about, signs)
            form = ThetaForm(Motion(inertia, omega), attitude)
            times = [Fraction(int(form.motion.period * 100)) / 100 * turn for turn in TURNS]
            given = PreciseMotion(inertia, omega, attitude).states(times, 32)
            for time, expected in zip(times, given, strict=True):
                for found, right in zip(form.state(mp.mpf(1) * time), expected, strict=True):
                    assert distance(found, right) < 1e-30


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


def tail(kind, q, z, n):
    """theta_kind(z | q^2) less its terms before the one with q**(2*n**2), n whole or half odd."""
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
    assert abs(value_of(step.right, here, {}) - after) < 1e-14
    assert value_of(step.left.right, here, {}) == 2 * here["t"]
