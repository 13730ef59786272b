"""What both branches of the Pi form have in common: moduli, the state, and what is in front."""

from collections.abc import Iterable

from rigidsym.codegen.functions.attitude import at_time, constants_function, from_angles
from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import AMPLITUDES, ATTITUDE, INERTIA, RATES
from rigidsym.codegen.passes import renamed, select, specialise
from rigidsym.codegen.special_functions import landen
from rigidsym.solution import Solution

# Landen's levels, from a state's down to where functions are elementary.
LEVELS = landen.STATE_STEPS + 1
FRONT = ("p_0", "p_a", "p_b", "p_d")
# As in the theta form, sines and cosines come in rows before the rest.
TIMED = ("s", "c", "X_im", "X_re", "d")
# The names of rates in the unit of time that motions are computed in.
INNER = {rate: f"inner_{rate[-1]}" for rate in RATES}
# Those of the cosine and sine of psi/2.
HALF = {"cos_half_psi": "X_re", "sin_half_psi": "X_im"}
# What a state is made of beside what changes with time.
KEPT = (*INERTIA, *AMPLITUDES, "K", "k_1", "k_c", "epsilon", "sigma", "chi", "tau", *FRONT, "unit")
# What the plans take from `_initial_state`.
GIVEN = ("K", *AMPLITUDES, "B_a", "B_d", "k_c", "k_1", "kc_1", "m_c", "mu", "psi_0")
GIVEN += ("n", "kappa", "H", "s", "c", "d")


def level(name: str, n: int) -> str:
    """What a quantity of Landen's steps is called on a level."""
    return name if n == 1 else f"{name}_{n}"


def moduli(solution: Solution, modulus: str, complement: str) -> tuple[Let, ...]:
    """The moduli of all levels below the first, by the names of that one's."""
    lets: tuple[Let, ...] = ()
    for n in range(1, LEVELS):
        step = select(solution.sequences["landen"], ("k_next", "kc_next"), ("k", "kc"))
        names = {"k": f"{modulus}_{n}", "k_next": f"{modulus}_{n + 1}", "root_kc": f"root_{n}"}
        names |= {"kc": f"{complement}_{n}", "kc_next": f"{complement}_{n + 1}"}
        lets += renamed(step, names)
    return lets


def ascent(solution: Solution, modulus: str, functions: tuple[str, ...]) -> tuple[Let, ...]:
    """Functions of the first level from those of the last, where dn is 1."""
    lets: tuple[Let, ...] = ()
    for n in reversed(range(1, LEVELS)):
        names = {name: level(name, n) for name in (*functions, "inside")}
        names |= {f"{name}_next": level(name, n + 1) for name in functions}
        step = select(solution.sequences["ascent"], functions, ())
        lets += renamed(step, names | {"k_next": f"{modulus}_{n + 1}"})
    return specialise(lets, {level("d", LEVELS): 1})


def state(solution: Solution) -> tuple[Let, ...]:
    """Rates and attitude from s, c, d and the cosine and sine of psi/2."""
    given = ("s", "c", "d", *HALF, *KEPT)
    lets = select(solution.sequences["state"], (*ATTITUDE, *RATES), given)
    units = (let(f"{rate} = unit*{INNER[rate]}") for rate in RATES)
    return (*renamed(lets, INNER | HALF), *units)


def front(solution: Solution) -> tuple[Let, ...]:
    """tau, and p from the attitude at t = 0 and the regular one there."""
    given = ("K", "epsilon", "sigma", "rho", *HALF, *INERTIA, *RATES, *ATTITUDE)
    return select(solution.sequences["constants"], ("tau", *FRONT), given)


def branch(
    name: str,
    solution: Solution,
    constants: Iterable[Let],
    angles: Iterable[Let],
    kept: tuple[str, ...],
    split: tuple[str, ...],
) -> tuple[Function, ...]:
    """Plan, angles and state; angles are given `kept`, and `split` as two doubles each."""
    flat = tuple(f"{x}_{part}" for x in split for part in ("hi", "lo"))
    results = (*split, *kept, *KEPT)
    extended = (*GIVEN, *INERTIA, *RATES, *ATTITUDE)
    return (
        constants_function(name, list(constants), results, split, extended),
        at_time(name, list(angles), (*flat, *kept), TIMED),
        from_angles(name, list(state(solution)), TIMED, KEPT),
    )
