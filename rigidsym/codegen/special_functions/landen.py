"""Landen's descending transformation, a fixed number of times, for moduli with k^2 <= 1/2."""

from fractions import Fraction

from rigidsym.codegen.ir import Function, let
from rigidsym.codegen.passes import select
from rigidsym.solution import Solution

# In the plan, and in a state of the Pi form.
STEPS, STATE_STEPS = 5, 4
_GIVEN = ("k", "kc", "s", "c", "d", "r", "Y")
_AFTER = tuple(f"{name}_next" for name in _GIVEN)


def modulus_left(steps: int = STEPS) -> Fraction:
    """A bound for the square of the modulus after the last step: k_next <= (k/(1 + kc))^2."""
    # k_next <= k^2/4/(1 - k^2/4)^2 follows from kc >= 1 - k^2, in rational numbers.
    k = Fraction(70711, 100000)
    for _ in range(steps):
        k = k * k / (2 - k * k) ** 2
    return k * k


def step(solution: Solution) -> Function:
    """One step, by the formulas of the ledger."""
    lets = select(solution.sequences["landen"], _AFTER, ())
    summary = "One step of Landen's descending transformation."
    return Function("_landen", summary, _GIVEN, lets, _AFTER, frozenset(_GIVEN))


def ladder() -> Function:
    """All steps, and the quarter period from the bottom, where it is pi/2, upwards."""
    lets, names = [], dict(zip(_GIVEN, _GIVEN, strict=True))
    for number in range(1, STEPS + 1):
        after = {name: f"{name}{number}" for name in _GIVEN}
        targets, given = ", ".join(after.values()), ", ".join(names.values())
        lets.append(let(f"{targets} = _landen({given})", "DLMF 22.7.2"))
        names = after
    lets.append(let(f"K{STEPS} = pi/2", "DLMF 19.6.1"))
    for number in range(STEPS - 1, -1, -1):
        lets.append(
            let(
                f"K{number} = (1 + k{number + 1})*K{number + 1}",
                "DLMF 19.8.12",
                facts=("definition landen.K",),
            )
        )
    results = ("K0", f"s{STEPS}", f"c{STEPS}", f"Y{STEPS}")
    summary = f"K(k^2), and the descended s, c and Y; {STEPS} steps leave k^2 < 2^-106 of (0, 1/2]."
    return Function("_ladder", summary, _GIVEN, tuple(lets), results, frozenset(_GIVEN))
