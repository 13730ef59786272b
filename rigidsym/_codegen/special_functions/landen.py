"""Landen's transformation and complete elliptic integrals, by fixed numbers of steps.

Landen's transformation descends from moduli with k^2 <= 1/2.  Complete integrals are computed by
the arithmetic-geometric mean, for every modulus that is not 1: K = pi/(2 M(1, k')), and the mean
slope of J, J_c/K = (Pi(n)/K - 1)/n, is a sum of Q_0 = 1, Q_1, ... over 2 (1 - n) (DLMF 19.8.6).
For k' near 1 a few steps would do; for small k' each step halves the logarithm before the means
agree.
"""

from fractions import Fraction

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.passes import select
from rigidsym.solution import Solution

# In a state of the Pi form.
STATE_STEPS = 4
_GIVEN = ("k", "kc", "s", "c", "d", "r", "Y")
_AFTER = tuple(f"{name}_next" for name in _GIVEN)
MEANS = 16
# Relative error of both, from k' = 2^-230 up, times K: measured, not proved.
MEANS_MEASURED = 1e-29
_MEANS_SOURCE = "DLMF 19.8.6"


def modulus_left(steps: int = BINARY64.landen) -> Fraction:
    """Bound the square of the modulus after the last Landen step."""
    # k_next <= k^2/4/(1 - k^2/4)^2 follows from kc >= 1 - k^2, in rational numbers.
    k = Fraction(70711, 100000)
    for _ in range(steps):
        k = k * k / (2 - k * k) ** 2
    return k * k


def step(solution: Solution) -> Function:
    """Build the function that takes one step of Landen's descending transformation.

    Its formulas are those of the ledger.
    """
    lets = select(solution.sequences["landen"], _AFTER, ())
    summary = "One step of Landen's descending transformation."
    return Function("_landen", summary, _GIVEN, lets, _AFTER, frozenset(_GIVEN))


def ladder(binary: Format = BINARY64) -> Function:
    """Build the function that takes all Landen steps and computes the quarter period.

    After the last step the quarter period is pi/2.
    """
    steps, lets, names = binary.landen, [], dict(zip(_GIVEN, _GIVEN, strict=True))
    for number in range(1, steps + 1):
        after = {name: f"{name}{number}" for name in _GIVEN}
        targets, given = ", ".join(after.values()), ", ".join(names.values())
        lets.append(let(f"{targets} = _landen({given})", "DLMF 22.7.2"))
        names = after
    lets.append(let(f"K{steps} = pi/2", "DLMF 19.6.1"))
    for number in range(steps - 1, -1, -1):
        lets.append(
            let(
                f"K{number} = (1 + k{number + 1})*K{number + 1}",
                "DLMF 19.8.12",
                facts=("definition landen.K",),
            )
        )
    results = ("K0", f"s{steps}", f"c{steps}", f"Y{steps}")
    summary = (
        f"K(k^2), and the descended s, c and Y; {steps} steps leave k^2 < 2^-{2 * binary.digits}"
        " of (0, 1/2]."
    )
    return Function("_ladder", summary, _GIVEN, tuple(lets), results, frozenset(_GIVEN))


def complete() -> Function:
    """Build the function that computes complete elliptic integrals of the first and third kind.

    From k' and 1 - n it computes K(k^2) and the sum of Q, which gives Pi(n).
    """
    lets: list[Let] = []
    for n in range(MEANS):
        lets += _mean_step(n)
    total = " + ".join(["1", *(f"Q_{n}" for n in range(1, MEANS + 1))])
    lets.append(let(f"K = pi/(2*a_{MEANS})", "DLMF 19.8.5"))
    lets.append(let(f"total = {total}", _MEANS_SOURCE))
    summary = "K(k^2), and the sum of Q for 1 - n = path; kc^2 = 1 - k^2."
    given = ("kc", "path")
    return Function("_complete", summary, given, tuple(lets), ("K", "total"), frozenset(given))


def _mean_step(n: int) -> list[Let]:
    """Return assignments for one step of the arithmetic-geometric mean.

    They compute the means of a and g, and the next p and Q.
    """
    a, g, p, last = (f"{name}_{n}" for name in ("a", "g", "p", "Q"))
    if n == 0:
        a, g, p, last = "1", "kc", "sqrt(path)", "1"
    lets = [
        let(f"product_{n} = {a}*{g}" if n else "product_0 = kc", _MEANS_SOURCE),
        let(f"square_{n} = {p}*{p}" if n else "square_0 = path", _MEANS_SOURCE),
        let(f"sum_{n} = square_{n} + product_{n}", _MEANS_SOURCE),
        let(f"Q_{n + 1} = {last}*((square_{n} - product_{n})/sum_{n})/2", _MEANS_SOURCE),
        let(f"a_{n + 1} = ({a} + {g})/2", _MEANS_SOURCE),
    ]
    if n < MEANS - 1:
        lets.append(let(f"p_{n + 1} = sum_{n}/(2*{p})", _MEANS_SOURCE))
        lets.append(let(f"g_{n + 1} = sqrt(product_{n})", _MEANS_SOURCE))
    return lets
