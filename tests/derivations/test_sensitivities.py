"""The changes of rates and attitude, by numbers: against differences of states of many digits."""

import json
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest
from mpmath import mp, mpf, workdps
from values import value_of

import derivations
from rigidsym import TorqueFreeMotion
from rigidsym.language._expression import parse

LEDGER = json.loads(Path(derivations.__file__).with_name("ledger.json").read_text("utf-8"))
SAID = {context["name"]: context["definitions"] for context in LEDGER["contexts"]}
STEP = Fraction(1, 10**20)
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
TIME = Fraction(27, 10)


def read(numbers):
    return [Fraction(x) for x in numbers]


def defined(values, *contexts):
    """Values of all that contexts define, after what is given."""
    for context in contexts:
        for name, text in SAID[context].items():
            if name not in values:
                values[name] = value_of(parse(text), values)
    return values


@cache
def functions(p, r, t):
    """S_t, C_t, D_t by mpmath's functions, and the integrals of S_t^2 and S_t^2/D_t^2."""
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
    """The small turn and the change of the rates, by the ledger's formulas, for one input."""
    c, w, t = [mpf(x.numerator) / x.denominator for x in inertia], [], mpf(27) / 10
    w = [mpf(x.numerator) / x.denominator for x in rates]
    change = {f"d{name}": mpf(name == changed) for name in NAMES}
    values = {"epsilon": mpf(1), **{f"c_{x}": y for x, y in zip("abd", c, strict=True)}}
    # Axes (a, b, d) = (1, 2, 3).
    for x, k in zip("abd", "123", strict=True):
        values[f"Omega_{x}0"] = w[int(k) - 1]
        values[f"dOmega_{x}0"], values[f"dc_{x}"] = change[f"dOmega{k}"], change[f"dc{k}"]
    defined(values, "perturbed_moments")
    for name in ("g_a", "g_d", "p", "r"):
        values[name] = value_of(parse(SAID["varied"][name]), values)
    for name in ("dg_a", "dg_d", "dp", "dr"):
        values[name] = value_of(parse(SAID["varied"][name]), values)
    values["t"] = t
    names = ("S_t", "C_t", "D_t", "E_t", "F_t")
    values |= dict(zip(names, functions(values["p"], values["r"], t), strict=True))
    defined(values, "varied_regular", "varied")
    if values["alpha_b"]:
        defined(values, "addition_integrals")
    else:
        values |= {f"I_{x}": values[f"Omega_{x}0"] ** 2 * t for x in "abd"}
    turned = {"t": t, "K": mp.sqrt(sum((x * y) ** 2 for x, y in zip(c, w, strict=True))), **change}
    for x, k in zip("abd", "123", strict=True):
        turned |= {f"c{k}": values[f"c_{x}"], f"Omega{k}": values[f"Omega_{x}"]}
        turned |= {f"dOmega{k}": values[f"dOmega_{x}"], f"I{k}": values[f"I_{x}"]}
    return turned


def momentum_there(turned, q, inertia, rates, changed):
    """l: the change of R M at t = 0, where the attitude is given, seen in the body at t."""
    k = int(changed[-1]) - 1
    other = rates if changed.startswith("c") else inertia
    start = [mpf(0)] * 3
    start[k] = mpf(other[k].numerator) / other[k].denominator
    first = normed(ATTITUDE)
    return rotate(conjugate(q), rotate(first, start))


def normed(q):
    length = mp.sqrt(sum(mpf(x) ** 2 for x in q))
    return [x / length for x in q]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def product(p, q):
    vector = [p[0] * q[k] + q[0] * p[k] + p[1 + k % 3] * q[1 + (k + 1) % 3]
              - p[1 + (k + 1) % 3] * q[1 + k % 3] for k in (1, 2, 3)]  # fmt: skip
    return [p[0] * q[0] - sum(p[k] * q[k] for k in (1, 2, 3)), *vector]


def rotate(q, v):
    return product(product(q, [mpf(0), *v]), conjugate(q))[1:]


@pytest.mark.parametrize("kind", MOTIONS)
@pytest.mark.parametrize("changed", NAMES)
def test_changes_are_those_of_differences(kind, changed):
    inertia, rates = map(read, MOTIONS[kind])
    k = NAMES.index(changed)
    ends = []
    for step in (STEP, -STEP):
        inputs = [*inertia, *rates]
        inputs[k] += step
        motion = TorqueFreeMotion(inputs[:3], inputs[3:], ATTITUDE)
        ends.append([*map(list, motion.precise(TIME, 70))])
    with workdps(60):
        wide = 2 * mpf(STEP.numerator) / STEP.denominator
        dq, dw = (
            [(x - y) / wide for x, y in zip(*pair, strict=True)] for pair in zip(*ends, strict=True)
        )
        q = normed([(x + y) / 2 for x, y in zip(ends[0][0], ends[1][0], strict=True)])
        found = columns(inertia, rates, changed)
        there = momentum_there(found, q, inertia, rates, changed)
        found |= {f"l{k}": x for k, x in enumerate(there, 1)} | {"s_0": mpf(0)}
        found |= {f"q{k}": x for k, x in enumerate(q)}
        defined(found, "turned_attitude")
        gaps = [found[f"dOmega{k}"] - dw[k - 1] for k in (1, 2, 3)]
        gaps += [found[f"dq{k}"] - dq[k] for k in range(4)]
        size = 1 + max(map(abs, (*dq, *dw)))
        assert max(map(abs, gaps)) < mpf(10) ** -30 * size
