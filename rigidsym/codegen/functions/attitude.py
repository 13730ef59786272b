"""Attitude and rates from theta functions: what both branches have in common.

What does not change with time is multiplied out beforehand: every component of the attitude is
linear in the parts P4 and P1 over N, and every rate is a constant times a quotient of thetas.
"""

from collections.abc import Iterable

from rigidsym.codegen.ir import Function, Let, let
from rigidsym.codegen.names import AMPLITUDES, ATTITUDE, INITIAL, PARTS, RATES, SIGNS, STATE
from rigidsym.codegen.passes import coefficient, inlined, live, select, specialise
from rigidsym.codegen.special_functions import reduction
from rigidsym.language.expression import Name, Operation, names, parse
from rigidsym.solution import Solution
from rigidsym.solution.formulas import AXES

_FRONT = ("p_0", "p_a", "p_b", "p_d")


def secular(solution: Solution) -> list[Let]:
    """The rate of the phase in half turns."""
    given = ("psi_0", "rho", "mu", "zeta")
    return [
        *select(solution.sequences["theta"], ("Lambda",), given),
        let("Lambda_rate = Lambda/pi"),
    ]


def phase() -> list[Let]:
    """Cosine and sine of Lambda t."""
    return [
        *reduction.product("L", "Lambda_rate"),
        *reduction.whole("L", "L"),
        let("L_turns = L_rest + L_error", reduction.TURNS),
        *reduction.sine_and_cosine("L", "L_turns", "L_whole", "X_im", "X_re"),
    ]


def parts(solution: Solution) -> tuple[Let, ...]:
    """e^(i Lambda t) times theta_4 and theta_1."""
    given = ("X_re", "X_im", "T4_re", "T4_im", "T1_re", "T1_im")
    return select(solution.sequences["circular_state"], PARTS, given)


def front(solution: Solution, form: str, norm: str, share_of_rows: str) -> list[Let]:
    """The unit quaternion in front, and the rows of q_x = (sum of row times part) * scale."""
    sequence = solution.sequences["circular_state"]
    pull_back = solution.sequences["pull_back"]
    bars = tuple(name.replace("q_", "qbar_") for name in ATTITUDE)
    return [
        *specialise(parts(solution), {"X_re": 1, "X_im": 0}),
        let(f"W = {norm}", facts=(f"reading {form}.W",)),
        *select(sequence, ("N",), ("W",)),
        *select(sequence, bars, (*PARTS, "N", *SIGNS)),
        *select(pull_back, _FRONT, (*bars, *ATTITUDE, *SIGNS)),
        let(f"over_N = {share_of_rows}", "DLMF 20.7.14"),
        *_rows(_linear(solution)),
    ]


def _linear(solution: Solution) -> tuple[Let, ...]:
    """The attitude, linear in the parts over N."""
    given = (*_FRONT, *PARTS, "N", *SIGNS)
    return inlined(select(solution.sequences["circular_state"], ATTITUDE, given), ATTITUDE)


def _rows(attitude: Iterable[Let]) -> list[Let]:
    """What multiplies each part in each component, with the constant share of 1/N."""
    rows = []
    for formula in attitude:
        for part in PARTS:
            factor = coefficient(formula.expression, part, PARTS, "N")
            name = f"row_{formula.targets[0][2:]}_{part}"
            expression = Operation("*", Name("over_N"), factor)
            rows.append(Let((name,), expression, formula.source, formula.facts))
    return rows


def _rates(solution: Solution) -> dict[str, Let]:
    """The rates by the Jacobi function each is a multiple of."""
    given = ("sn", "cn", "dn", "sigma", "chi", "tau", *AMPLITUDES)
    rates = select(solution.sequences["rates"], RATES, given)
    return dict(zip(("dn", "sn", "cn"), rates, strict=True))


def gains(solution: Solution, scale: dict[str, str]) -> list[Let]:
    """What multiplies the quotient of thetas in each rate (DLMF 22.2.4 to 22.2.6).

    `unit` is the power of two, in 1/s, that inner rates are times.
    """
    lets = list(select(solution.sequences["constants"], ("tau",), SIGNS))
    for name, rate in _rates(solution).items():
        (gain,) = specialise([rate], {name: 1})
        quotient = Operation("*", gain.expression, parse(scale[name]))
        product = Operation("*", quotient, Name("unit"))
        target = f"gain_{rate.targets[0][-1]}"
        lets.append(Let((target,), product, (*rate.source, "DLMF 22.2.4"), rate.facts))
    return lets


def state_lets(thetas: tuple[str, str, str], flip: str = "") -> list[Let]:
    """The attitude and the rates from parts, rows, gains and thetas."""
    lets = []
    for x in ("0", *AXES):
        first, second, third, fourth = (f"row_{x}_{part}*{part}" for part in PARTS)
        turned = f"{flip}*({third} + {fourth})" if flip else f"({third} + {fourth})"
        lets.append(
            let(
                f"q_{x} = scale*({first} + ({second} + {turned}))",
                facts=(f"definition attitude.q_{x}",),
            )
        )
    for x, theta in zip(AXES, thetas, strict=True):
        lets.append(
            let(
                f"Omega_{x} = gain_{x}*(({theta})*over)",
                facts=(f"definition regular.Omega_{x}",),
            )
        )
    return lets


def flat(split: Iterable[str]) -> tuple[str, ...]:
    """The names of the doubles that carry extended numbers."""
    return tuple(f"{name}_{part}" for name in split for part in ("hi", "lo"))


def constants_function(
    name: str,
    lets: list[Let],
    results: tuple[str, ...],
    split: tuple[str, ...],
    given: tuple[str, ...] = (*INITIAL, *ATTITUDE),
) -> Function:
    """The constants of a branch, from what the start hands over."""
    used = {name for formula in live(lets, results) for name in names(formula.expression)}
    used |= {*results}
    extended = [name for name in given if name in used]
    return Function(
        f"_{name}_constants",
        f"The constants of a motion on the {name} branch, from `_initial_state`.",
        (*extended, *(sign for sign in SIGNS if sign in used), "unit"),
        tuple(lets),
        results,
        frozenset(extended),
        frozenset(split),
        rounds=True,
    )


def at_time(
    name: str, lets: list[Let], constants: tuple[str, ...], results: tuple[str, ...]
) -> Function:
    """What changes with time."""
    summary = f"What changes with time on the {name} branch, at t + t_lo."
    parameters = ("t", "t_lo", *constants)
    return Function(f"_{name}_angles", summary, parameters, tuple(lets), results)


def from_angles(
    name: str, lets: list[Let], given: tuple[str, ...], constants: tuple[str, ...]
) -> Function:
    """The state from what changes with time."""
    summary = f"The state on the {name} branch, from `_{name}_angles`."
    parameters = (*given, *constants)
    return Function(f"_{name}_state", summary, parameters, tuple(lets), STATE)
