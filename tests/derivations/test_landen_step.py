"""Landen's step by its published sequence, over mpmath numbers and from step to step."""

from random import Random

import pytest
from mpmath import mp, workdps

from rigidsym.solution._formulas import sequence

STEPS = 8
NUMBERS = {"sqrt": mp.sqrt, "power": lambda x, n: x**n}
MODULI = ["1e-9", "0.2", "0.7", "0.95", "0.999999"]


def descend(k, u, beta, w):
    """What each of eight steps finds, from Jacobi's functions of u and i*beta."""
    here = {f"{x}": mp.ellipfun(f"{x}n", u, m=k**2) for x in "scd"}
    here |= {"k": k, "kc": mp.sqrt(1 - k**2), "r": k / w**2, "K_next": mp.mpf(1)}
    here["Y"] = w * mp.ellipfun("sc", beta, m=1 - k**2)
    found = []
    for _ in range(STEPS):
        found.append(sequence("landen").evaluate(here, NUMBERS))
        here |= {x: found[-1][f"{x}_next"] for x in ("k", "kc", "s", "c", "d", "r", "Y")}
    return found


def draw(modulus, seed):
    """A modulus, an argument below K, a shift below K'/2, and the scale, which is root_Q."""
    random, k = Random(f"{modulus}/{seed}"), mp.mpf(modulus)
    u = mp.ellipk(k**2) * random.uniform(-0.99, 0.99)
    beta = mp.ellipk(1 - k**2) / 2 * random.uniform(0, 0.99)
    return k, u, beta, mp.qfrom(k=k) ** 0.25


@pytest.mark.parametrize("modulus", MODULI)
@pytest.mark.parametrize("seed", range(3))
def test_one_step_is_that_of_jacobi_functions(modulus, seed):
    with workdps(50):
        k, u, beta, w = draw(modulus, seed)
        first = descend(k, u, beta, w)[0]
        k_next = first["k_next"]
        scale, m = 1 + k_next, k_next**2
        for x in "scd":
            right = mp.ellipfun(f"{x}n", u / scale, m=m)
            assert abs(first[f"{x}_next"] - right) < 1e-40
        assert abs(first["Y_next"] / w - mp.ellipfun("sc", beta / scale, m=1 - m)) < 1e-38
        assert abs(first["r_next"] * w**2 - k_next) < 1e-40
        assert abs(first["kc_next"] - mp.sqrt(1 - m)) < 1e-40


@pytest.mark.parametrize("modulus", MODULI)
@pytest.mark.parametrize("seed", range(3))
def test_eight_steps_invert_jacobi_functions(modulus, seed):
    with workdps(50):
        k, u, beta, w = draw(modulus, seed)
        found = descend(k, u, beta, w)
        last, quarter = found[-1], mp.pi / 2 * mp.fprod(step["K"] for step in found)
        assert last["k_next"] < 1e-30
        assert abs(quarter / mp.ellipk(k**2) - 1) < 1e-30
        scale = mp.pi / (2 * quarter)
        angle = mp.atan2(last["s_next"], last["c_next"])
        assert abs(angle - scale * u) < 1e-30
        assert abs(mp.asinh(last["Y_next"] / w) - scale * beta) < 1e-30


@pytest.mark.parametrize("modulus", MODULI)
@pytest.mark.parametrize("seed", range(3))
def test_the_scale_gives_the_exponentials_at_the_bottom(modulus, seed):
    with workdps(50):
        k, u, beta, w = draw(modulus, seed)
        last = descend(k, u, beta, w)[-1]
        x = mp.ellipfun("sc", beta, m=1 - k**2)
        part = k * x * x  # (K - B_a)/(K + B_a)
        momentum = {"K": 1 + part, "B_a": 1 - part, "B_d": 2 * mp.sqrt(part)}
        given = {**momentum, "k_1": k, "r": k / w**2, "Y_b": last["Y_next"]}
        scaled = sequence("scaling").evaluate(given, NUMBERS)
        b = mp.pi * beta / (2 * mp.ellipk(k**2))
        assert abs(scaled["Y"] - w * x) < 1e-38
        assert abs(scaled["Q"] - w**2) < 1e-38
        assert abs(scaled["h_plus"] - w * mp.exp(b)) < 1e-30
        assert abs(scaled["h_minus"] - w * mp.exp(-b)) < 1e-30
        shift = sequence("shift").evaluate({**momentum, "k_1": k}, NUMBERS)
        for name in "scd":
            right = mp.ellipfun(f"{name}n", beta, m=1 - k**2)
            assert abs(shift[f"{name}_beta"] - right) < 1e-38


def test_the_ends_of_the_modulus_are_no_exceptions():
    half = {"r": 4, "Y": mp.mpf(1) / 3, "K_next": mp.mpf(1)}
    begin = {**half, "s": 0.6, "c": 0.8}
    circular = sequence("landen").evaluate({**begin, "k": 0, "kc": 1, "d": 1}, NUMBERS)
    assert (circular["k_next"], circular["r_next"], circular["kc_next"]) == (0, 0, 1)
    assert [circular[f"{x}_next"] for x in "scd"] == pytest.approx([0.6, 0.8, 1])
    assert circular["Y_next"] == pytest.approx(1 / 3)
    hyperbolic = sequence("landen").evaluate({**begin, "k": 1, "kc": 0, "d": 0.8}, NUMBERS)
    assert (hyperbolic["k_next"], hyperbolic["kc_next"], hyperbolic["r_next"]) == (1, 0, 4)
    assert hyperbolic["s_next"] == pytest.approx(mp.tanh(mp.atanh(0.6) / 2))
