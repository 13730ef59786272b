"""Changes of rates and attitude by the ledger's formulas, against differences of precise states."""

from fractions import Fraction
from functools import cache

import pytest
from ledgers import CONTEXTS
from mpmath import mp, mpf, workdps
from textbook import conjugate, multiply, number
from values import value_of

from rigidsym import TorqueFreeMotion
from rigidsym.language._expression import parse

STEP, TIME = Fraction(1, 10**20), Fraction(27, 10)
ATTITUDE = (2, -1, 3, 1)
NAMES = ("c1", "c2", "c3", "Omega1", "Omega2", "Omega3")
# Moments and rates, b being axis 2.
MOTIONS = {
    "larger axis": (("0.0109", "0.04", "0.0506"), ("0.05", "0.03", "-0.2")),
    "smaller axis": (("3", "2", "1"), ("-0.1", "0.3", "0.9")),
    "symmetric": (("3", "2", "2"), ("0.7", "-0.2", "0.5")),
    "separatrix": (("4", "3", "3/2"), ("3/4", "1/2", "1")),
    "about the middle axis": (("3", "2", "1"), ("0", "0.8", "0")),
    "sphere": (("2", "2", "2"), ("0.3", "0.4", "-0.1")),
}


def defined(values, *contexts, only=None):
    """Add the values of definitions of contexts, all or only some, to given values."""
    for context in contexts:
        definitions = CONTEXTS[context]["definitions"]
        for name in only or definitions:
            if name not in values:
                values[name] = value_of(parse(definitions[name]), values)
    return values


@cache
def functions(p, r, t):
    """Return S_t, C_t, D_t by mpmath's functions, and the integrals of S_t^2 and S_t^2/D_t^2."""
    root = mp.sqrt(p)

    @cache
    def square(x):
        return (mp.ellipfun("sn", root * x, m=r / p) / root if p else x) ** 2

    def integral(function):
        return mp.quad(function, mp.linspace(0, t, 3), method="gauss-legendre")

    squares = integral(square), integral(lambda x: square(x) / (1 - r * square(x)))
    if not p:
        return t, mpf(1), mpf(1), *squares
    sn, cn, dn = (mp.ellipfun(f"{name}n", root * t, m=r / p) for name in "scd")
    return sn / root, cn, dn, *squares


def columns(inertia, rates, changed):
    """Return the small turn and the change of the rates with one input, by the ledger's formulas.

    Axes (a, b, d) are (1, 2, 3).
    """
    c, w, t = [*map(number, inertia)], [*map(number, rates)], number(TIME)
    change = {f"d{name}": mpf(name == changed) for name in NAMES}
    values = {"epsilon": mpf(1), "t": t}
    for k, x in enumerate("abd"):
        values |= {f"c_{x}": c[k], f"Omega_{x}0": w[k]}
        values |= {f"dOmega_{x}0": change[f"dOmega{k + 1}"], f"dc_{x}": change[f"dc{k + 1}"]}
    defined(values, "perturbed_moments")
    defined(values, "varied", only=("g_a", "g_d", "p", "r", "dg_a", "dg_d", "dp", "dr"))
    names = ("S_t", "C_t", "D_t", "E_t", "F_t")
    values |= dict(zip(names, functions(values["p"], values["r"], t), strict=True))
    defined(values, "varied_regular", "varied")
    if values["alpha_b"]:
        defined(values, "addition_integrals")
    else:
        values |= {f"I_{x}": values[f"Omega_{x}0"] ** 2 * t for x in "abd"}
    turned = {"t": t, "K": mp.sqrt(sum((x * y) ** 2 for x, y in zip(c, w, strict=True))), **change}
    for k, x in enumerate("abd", 1):
        names = {f"c{k}": "c_", f"Omega{k}": "Omega_", f"dOmega{k}": "dOmega_", f"I{k}": "I_"}
        turned |= {name: values[f"{other}{x}"] for name, other in names.items()}
    return turned


def momentum_there(q, inertia, rates, changed):
    """Return the change of R M at t = 0, seen in the body at t."""
    k = int(changed[-1]) - 1
    start = [mpf(0)] * 3
    start[k] = number((rates if changed.startswith("c") else inertia)[k])
    return rotate(conjugate(q), rotate(normed(ATTITUDE), start))


def normed(q):
    length = mp.sqrt(sum(mpf(x) ** 2 for x in q))
    return [x / length for x in q]


def rotate(q, v):
    return multiply(multiply(q, [mpf(0), *v]), conjugate(q))[1:]


@pytest.mark.parametrize("kind", MOTIONS)
@pytest.mark.parametrize("changed", NAMES)
def test_changes_are_those_of_differences(kind, changed):
    inertia, rates = ([*map(Fraction, numbers)] for numbers in MOTIONS[kind])
    ends = []
    for step in (STEP, -STEP):
        inputs = [*inertia, *rates]
        inputs[NAMES.index(changed)] += step
        motion = TorqueFreeMotion(inputs[:3], inputs[3:], ATTITUDE)
        ends.append([*map(list, motion.precise(TIME, 70))])
    with workdps(60):
        pairs = [[*zip(*pair, strict=True)] for pair in zip(*ends, strict=True)]
        dq, dw = ([(x - y) / (2 * number(STEP)) for x, y in pair] for pair in pairs)
        q = normed([(x + y) / 2 for x, y in pairs[0]])
        found = columns(inertia, rates, changed)
        there = momentum_there(q, inertia, rates, changed)
        found |= {f"l{k}": x for k, x in enumerate(there, 1)} | {"s_0": mpf(0)}
        found |= {f"q{k}": x for k, x in enumerate(q)}
        defined(found, "turned_attitude")
        gaps = [found[f"dOmega{k}"] - dw[k - 1] for k in (1, 2, 3)]
        gaps += [found[f"dq{k}"] - dq[k] for k in range(4)]
        size = 1 + max(map(abs, (*dq, *dw)))
        assert max(map(abs, gaps)) < mpf(10) ** -30 * size
