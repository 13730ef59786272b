"""The rule for Pi beyond half a turn, against quadrature of its integrand."""

import json
from pathlib import Path

import pytest
from mpmath import mp, workdps
from values import value_of

import derivations
from rigidsym.language._expression import parse

LEDGER = json.loads(Path(derivations.__file__).with_name("ledger.json").read_text("utf-8"))
# One half turn more, and that k of them and one are k + 1.
((ONCE, ONE_MORE),) = {
    tuple(fact["rhs"])
    for fact in LEDGER["facts"]
    if fact["lhs"] == ["Pi_later", "2*k*Pi_c + Pi_later"]
}
PARAMETERS = [
    ("0.5", "0.5", "0.7"),
    ("-3", "0.9", "-1.2"),
    ("0.8", "-2", "1.5"),
    ("-40", "0.3", "0"),
]


def by_quadrature(n, theta, m):
    def integrand(angle):
        square = mp.sin(angle) ** 2
        return 1 / ((1 - n * square) * mp.sqrt(1 - m * square))

    pieces = int(abs(theta) / mp.pi * 4) + 1
    return mp.quad(integrand, mp.linspace(0, theta, pieces + 1))


@pytest.mark.parametrize("k", range(-5, 6))
@pytest.mark.parametrize(("n", "m", "theta"), PARAMETERS)
def test_pi_winds_as_stated(n, m, theta, k):
    with workdps(22):
        n, m, theta = map(mp.mpf, (n, m, theta))
        values = {"k": k - 1, "Pi_c": mp.ellippi(n, m), "Pi": mp.ellippi(n, theta, m)}
        wound = value_of(parse(ONE_MORE), values, {})
        assert k != 1 or wound == value_of(parse(ONCE), values, {})
        assert abs(wound - by_quadrature(n, theta + k * mp.pi, m)) < 1e-18 * (1 + abs(wound))
