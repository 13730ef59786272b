"""Periods and phases of exact motions, and Montgomery's solid angle by quadrature over azimuth."""

import pytest
from mpmath import mp, workdps
from textbook import (
    FAMILIES,
    OCTANTS,
    Motion,
    conjugate,
    distance,
    draw,
    exactly,
    multiply,
    number,
)

from rigidsym.precise import PreciseMotion

CASES = [(*family, OCTANTS[k % 8]) for k, family in enumerate(FAMILIES)]
NODES = 400
every = pytest.mark.parametrize(("order", "about", "signs"), CASES)


def over_a_cycle(function, length):
    """Return the integral of a smooth periodic function by the trapezoidal rule."""
    return length * mp.fsum(function(length * k / NODES) for k in range(NODES)) / NODES


def mean_rate(m):
    """Return psi_mean with the complete integral of the third kind."""
    n = -m.k_1 * (m.K - m.B_a) / (m.K + m.B_a)
    e_a = m.c_d * (m.c_a - m.c_d) * (m.B_d / m.c_d) ** 2
    kappa = 2 * e_a * m.B_a / m.c_a * m.k_1 / ((m.K + m.B_a) ** 2 * m.mu)
    K_1 = mp.ellipk(m.k_1**2)
    return m.psi_0 + kappa * m.mu * (mp.ellippi(n, m.k_1**2) - K_1) / n / K_1


def twice_lambda(m):
    """Return psi_0 + 2 rho mu Z(i beta)/i; Z is the logarithmic derivative of theta_4."""
    parameter = m.k_1**2
    K_1, K_c = mp.ellipk(parameter), mp.ellipk(1 - parameter)
    g, nome = mp.pi / (2 * K_1), mp.exp(-mp.pi * K_c / K_1)
    z = mp.mpc(0, g * mp.ellipf(mp.atan(m.x), 1 - parameter))
    slope = g * mp.jtheta(4, z, nome, 1) / mp.jtheta(4, z, nome)
    return m.psi_0 + 2 * m.rho * m.mu * mp.im(slope)


def solid_angle(m):
    """Return the solid angle of the polhode about sigma e_a, on momentum sphere and ellipsoid."""
    excess = 2 * m.H / m.K**2 - 1 / m.c_a

    def cap(phi):
        across = mp.cos(phi) ** 2 / m.c_b + mp.sin(phi) ** 2 / m.c_d
        return 1 - mp.sqrt(1 - excess / (across - 1 / m.c_a))

    return 2 * over_a_cycle(cap, mp.pi)


def sense(m):
    """Return 1 where the momentum goes round sigma e_a right-handedly in the body, else -1."""
    M = [c * w for c, w in zip(m.inertia, m.omega, strict=True)]
    rate = [M[k - 2] * m.omega[k - 1] - M[k - 1] * m.omega[k - 2] for k in range(3)]
    a = m.axes[0]
    return 1 if m.sigma * (M[a - 2] * rate[a - 1] - M[a - 1] * rate[a - 2]) > 0 else -1


def in_space(q, inertia, rates):
    """Return the momentum seen in space."""
    momentum = [0, *(number(c) * w for c, w in zip(inertia, rates, strict=True))]
    return multiply(multiply(q, momentum), conjugate(q))[1:]


@every
def test_the_rates_come_back_and_the_attitude_has_turned_about_the_momentum(order, about, signs):
    with workdps(45):
        inertia, omega, attitude = draw(order, about, signs)
        m = Motion(inertia, omega)
        start = exactly(m.period * mp.mpf("0.3"))
        times = [start, start + exactly(m.period / 2), start + exactly(m.period)]
        precise = PreciseMotion(inertia, omega, attitude).states(times, 32)
        (q, now), (_, half), (q_later, later) = precise
        a, b, d = m.axes
        assert distance(later, now) < 1e-30
        assert distance([half[a], -half[b], -half[d]], [now[a], now[b], now[d]]) < 1e-30
        direction = [x / m.K for x in in_space(q, inertia, now)]
        half_turn = mean_rate(m) * m.period / 2
        turn = [mp.cos(half_turn), *(mp.sin(half_turn) * x for x in direction)]
        assert distance(multiply(turn, q), q_later) < 1e-29


@every
def test_the_mean_rate_is_that_of_psi_and_of_the_theta_form(order, about, signs):
    with workdps(45):
        m = Motion(*draw(order, about, signs)[:2])

        def psi_rate(t):
            fast = m.B_a / m.c_a * mp.ellipfun("dn", m.lambda_ * t, m=m.m)
            return (2 * m.H + m.K * fast) / (m.K + m.c_a * fast)

        mean, half = mean_rate(m), m.period / 2
        assert abs(mean - over_a_cycle(psi_rate, half) / half) < 1e-25
        assert abs(mean - twice_lambda(m)) < 1e-35


@every
def test_the_turn_is_that_of_the_energy_less_a_solid_angle(order, about, signs):
    with workdps(45):
        inertia, omega, attitude = draw(order, about, signs)
        m = Motion(inertia, omega)
        phase = 2 * m.H * m.period / m.K - sense(m) * solid_angle(m)
        assert abs(mean_rate(m) * m.period - phase) < 1e-25
        motion = PreciseMotion(inertia, omega, attitude)
        (q_0, _), (q, w) = motion.states([0, exactly(m.period)], 32)
        turn = multiply(q, conjugate(q_0))
        pairs = zip(turn[1:], in_space(q, inertia, w), strict=True)
        measured = 2 * mp.atan2(sum(x * y for x, y in pairs), turn[0] * m.K)
        gap = (measured - phase) / (2 * mp.pi)
        assert abs(gap - mp.nint(gap)) < 1e-25


@pytest.mark.parametrize(("about", "expected"), [("largest", 1), ("smallest", -1)])
def test_the_momentum_circulates_one_way_about_the_largest_and_the_other_about_the_smallest(
    about, expected
):
    drawn = (draw(order, kind, signs)[:2] for order, kind, signs in CASES if kind == about)
    assert {sense(Motion(*motion)) for motion in drawn} == {expected}
