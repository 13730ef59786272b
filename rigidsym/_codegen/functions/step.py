"""Generated functions of the step form: one torque-free step, and the torque of a kick.

Start at a short time, where few terms of series suffice, then double it.  Numbers that angles and
rates grow from are extended.  Corrections of them are doubles, except in the last doublings: for
thin bodies the share taken from psi there is ten times as wrong as the numbers it is made from.
The shortest rotations are extended until they are complete.
"""

from collections.abc import Iterable

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.functions.common import phase
from rigidsym._codegen.ir import Function, Let, let
from rigidsym._codegen.names import ATTITUDE, DIFFERENCES, INERTIA, RATES
from rigidsym._codegen.passes import renamed, select, specialise
from rigidsym._codegen.special_functions import short_time
from rigidsym.solution import Solution

_ALPHAS = ("alpha_a", "alpha_b", "alpha_d")
_SQUARES = ("l_a", "l_b", "l_d")
_STARTS = ("Omega_a0", "Omega_b0", "Omega_d0")
# A torque is found from the attitude, a vector in space, and coefficients.
_KICK = (
    *(f"q{k}" for k in range(4)),
    *(f"{x}{k}" for x in "ub" for k in range(1, 4)),
    *("k", "m1", "m2", "m3", "Q11", "Q22", "Q33", "Q23", "Q13", "Q12"),
)
_FRONT = ("p_0", "p_a", "p_b", "p_d")
_PROJECTED = ("z_re", "z_im", "zr_re", "zr_im")
_BEGUN = ("h", "e_1", "e_2", "K", "Lambda_rate", "X", "Y", *_PROJECTED)
_ELAPSED = ("h", *_PROJECTED, "X", "Y")
_SHORTEST = ("s_0", "s_b", "s_d")
_W, _W_NEXT = ("W_re", "W_im"), ("W_next_re", "W_next_im")
_SIGNS = ("epsilon", "sigma")
# The projection in the last doublings, which is extended.
_LAST = {"w_re": "v_re", "w_im": "v_im"}
_HALF = {"cos_half_psi": "turn_re", "sin_half_psi": "turn_im"}


def step(solution: Solution, binary: Format = BINARY64) -> tuple[Function, ...]:
    """Return all functions of the step form, in the order of their use."""

    def lets(sequence: str, results: Iterable[str], *given: str) -> tuple[Let, ...]:
        return select(solution.sequences[sequence], results, given)

    def sum_of_angles(**names: str) -> tuple[Let, ...]:
        """Return assignments for the cosine and sine of the sum of two angles.

        names: the names of the quantities, by those in the formula.
        """
        return renamed(lets("thirds", ("P_re", "P_im"), "T_re", "T_im", "E_re", "E_im"), names)

    def second_half(w_re: str, w_im: str) -> list[Let]:
        """Return assignments that add the change of psi/2 in the second half of a doubled time.

        They use psi/2 and the momentum's projection at the time itself.
        """
        factor = lets("projection", ("G_re", "G_im"), "h", "z_re", "z_im", "X")
        return [
            *renamed(factor, {"z_re": w_re, "z_im": w_im}),
            *lets("second_half", ("R", "V_re", "V_im"), "G_re", "G_im", *_W),
            *sum_of_angles(
                **{"T_re": "W_re", "T_im": "W_im", "E_re": "V_re", "E_im": "V_im"},
                **{"P_re": "W_next_re", "P_im": "W_next_im"},
            ),
        ]

    projected = lets("projection", tuple(_LAST), *_ELAPSED)
    shortest = lets("state", _SHORTEST, "K", *_SIGNS, *INERTIA, *RATES)
    return (
        _function(
            "body",
            "The coefficients of Euler's equations, and their products.",
            lets("step", (*_ALPHAS, *_SQUARES), *INERTIA, *DIFFERENCES, "epsilon"),
            (*_ALPHAS, *_SQUARES),
            extended=(*INERTIA, *DIFFERENCES),
            doubles=("epsilon",),
            split=True,
        ),
        _function(
            "start",
            "Momentum, its projection, frequencies, rate of psi; X and Y at the shortest time.",
            [
                *lets(
                    "step",
                    ("h", "e_1", "e_2", "K", "psi_0", *_PROJECTED),
                    *(*INERTIA, *_SQUARES, *_STARTS, *_SIGNS),
                ),
                let("Lambda_rate = psi_0/(2*pi)"),
                let(f"first_t = t*(1/{2**binary.doublings})"),
                *short_time.elapsed(binary),
            ],
            _BEGUN,
            extended=(*INERTIA, *_SQUARES, *_STARTS),
            doubles=("t", *_SIGNS),
            split=True,
        ),
        _function(
            "first",
            "psi/2 at the shortest time, without its linear part.",
            [
                *lets(
                    "projection",
                    ("nu_re", "nu_im", "rate_re", "rate_im", "G_re", "G_im"),
                    *("h", *_PROJECTED, "X"),
                ),
                *short_time.third_kind(binary),
                *renamed(
                    specialise(
                        lets(
                            "thirds",
                            ("R", "N", *_HALF),
                            *("G_re", "G_im", "T_re", "T_im", "E_re", "E_im"),
                        ),
                        {"T_re": 1, "T_im": 0},
                    ),
                    dict(zip(_HALF, _W, strict=True)),
                ),
            ],
            _W,
            doubles=("h", "e_1", "e_2", "X", *_PROJECTED),
        ),
        _function(
            "doubled",
            "X and Y at twice the time.",
            lets("doubling", ("X_next", "Y_next"), "X", "Y", "e_1", "e_2"),
            ("X_next", "Y_next"),
            extended=("X", "Y", "e_1", "e_2"),
            split=True,
        ),
        _function(
            "projected",
            "The momentum's projection at the time of X and Y.",
            projected,
            tuple(_LAST),
            doubles=_ELAPSED,
        ),
        _function(
            "second_half",
            "psi/2 at twice the time, without its linear part.",
            second_half(*_LAST),
            _W_NEXT,
            doubles=("h", "X", *_LAST, *_W),
        ),
        _function(
            "last_projected",
            "The momentum's projection in extended precision, for the last doublings.",
            renamed(projected, _LAST),
            tuple(_LAST.values()),
            extended=_ELAPSED,
            split=True,
        ),
        _function(
            "last_second_half",
            "psi/2 at twice the time from extended numbers, for the last doublings.",
            second_half(*_LAST.values()),
            _W_NEXT,
            extended=("h", "X", *_LAST.values()),
            doubles=_W,
        ),
        _function(
            "rates",
            "The rates after the step.",
            lets("step_rates", RATES, "X", "Y", "h", *_ALPHAS, "l_d", *_STARTS),
            RATES,
            extended=("X", "Y", "h", *_ALPHAS, "l_d", *_STARTS),
            split=True,
        ),
        _function(
            "shortest_before",
            "The shortest rotation that takes the momentum at the start to its axis.",
            renamed(shortest, dict(zip(RATES, _STARTS, strict=True))),
            _SHORTEST,
            extended=("K", *_STARTS),
            doubles=(*INERTIA, *_SIGNS),
        ),
        _function(
            "front",
            "The constant left factor of the attitude.",
            specialise(
                lets("constants", _FRONT, *_SIGNS, *_HALF, *_SHORTEST, *ATTITUDE),
                dict(zip(_HALF, (1, 0), strict=True)),
            ),
            _FRONT,
            doubles=(*_SHORTEST, *ATTITUDE, "epsilon"),
        ),
        _function(
            "shortest",
            "The shortest rotation that takes the momentum after the step to its axis.",
            shortest,
            _SHORTEST,
            extended=("K", *RATES),
            doubles=(*INERTIA, *_SIGNS),
        ),
        _function(
            "attitude",
            "The attitude after the step.",
            [
                *specialise(phase(binary), {"t_lo": 0}),
                *sum_of_angles(
                    **{"T_re": "X_re", "T_im": "X_im", "E_re": "W_re", "E_im": "W_im"},
                    **{"P_re": "turn_re", "P_im": "turn_im"},
                ),
                *renamed(lets("state", ATTITUDE, *_SIGNS, *_HALF, *_SHORTEST, *_FRONT), _HALF),
            ],
            ATTITUDE,
            doubles=(
                *("t", "Lambda_rate_hi", "Lambda_rate_lo", *_W),
                *(*_SHORTEST, *_FRONT, *_SIGNS),
            ),
        ),
        _function(
            "kick",
            "The torque that a vector in space exerts, and a torque fixed in the body.",
            lets("kick", ("T1", "T2", "T3"), *_KICK),
            ("T1", "T2", "T3"),
            doubles=_KICK,
        ),
    )


def _function(
    name: str,
    summary: str,
    lets: Iterable[Let],
    results: tuple[str, ...],
    *,
    extended: tuple[str, ...] = (),
    doubles: tuple[str, ...] = (),
    split: bool = False,
) -> Function:
    """Build one function of the step form, with doubles and extended numbers as parameters.

    Its results are extended numbers if `split`.
    """
    return Function(
        f"_step_{name}",
        summary,
        (*extended, *doubles),
        tuple(lets),
        results,
        frozenset(extended),
        frozenset(results if split else ()),
        rounds=True,
    )
