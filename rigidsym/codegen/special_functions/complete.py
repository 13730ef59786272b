"""Complete integrals by the arithmetic-geometric mean, for every modulus that is not 1.

K = pi/(2 M(1, k')), and the mean slope of J, J_c/K = (Pi(n)/K - 1)/n, is a sum of Q_0 = 1, Q_1, ...
over 2 (1 - n) (DLMF 19.8.6).  For k' near 1 a few steps would do; small k' takes a step each time
its logarithm falls by half, before means agree.
"""

from rigidsym.codegen.ir import Function, Let, let

STEPS = 16
# Relative error of both, from k' = 2^-230 up, times K: measured, not proved.
MEASURED = 1e-29
_SOURCE = "DLMF 19.8.6"


def complete() -> Function:
    """K(k^2) and the sum of Q, from k' and 1 - n; for k' = 0 numbers that nobody needs."""
    lets: list[Let] = []
    for n in range(STEPS):
        lets += _step(n)
    total = " + ".join(["1", *(f"Q_{n}" for n in range(1, STEPS + 1))])
    lets.append(let(f"K = pi/(2*a_{STEPS})", "DLMF 19.8.5"))
    lets.append(let(f"total = {total}", _SOURCE))
    summary = "K(k^2), and the sum of Q for 1 - n = path; kc^2 = 1 - k^2."
    given = ("kc", "path")
    return Function("_complete", summary, given, tuple(lets), ("K", "total"), frozenset(given))


def _step(n: int) -> list[Let]:
    """Means of a and g, and what p and Q become."""
    a, g, p, last = (f"{name}_{n}" for name in ("a", "g", "p", "Q"))
    if n == 0:
        a, g, p, last = "1", "kc", "sqrt(path)", "1"
    lets = [
        let(f"product_{n} = {a}*{g}", _SOURCE) if n else let(f"product_{n} = kc", _SOURCE),
        let(f"square_{n} = {p}*{p}" if n else "square_0 = path", _SOURCE),
        let(f"sum_{n} = square_{n} + product_{n}", _SOURCE),
        let(f"Q_{n + 1} = {last}*((square_{n} - product_{n})/sum_{n})/2", _SOURCE),
        let(f"a_{n + 1} = ({a} + {g})/2", _SOURCE),
    ]
    if n < STEPS - 1:
        lets.append(let(f"p_{n + 1} = sum_{n}/(2*{p})", _SOURCE))
        lets.append(let(f"g_{n + 1} = sqrt(product_{n})", _SOURCE))
    return lets
