"""Claims that each generated formula equals the fact of the ledger that it cites.

The claims check the renaming in `rigidsym._codegen`, so these tables are written independently of
it.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from rigidsym._codegen.forms import PI, STEP, THETA
from rigidsym._codegen.ir import Function, Let
from rigidsym._codegen.names import GAINS, ROWS, STATE
from rigidsym._codegen.seal.equality import DIFFERS, Claim
from rigidsym.errors import InputError
from rigidsym.language._expression import Expression, Name, children, parse, put, rebuild
from rigidsym.solution import Formula, Solution

Names = Mapping[str, str]
_FIRST = {
    # Of moments only whether they are zero counts.
    ("_circulation", "sorted_body"): {"c_3": "1"},
    # Signs are those of doubles.
    ("_initial_state", "start_signs"): {
        name: f"rounded({name})" for name in ("c_ad", "Omega_a", "Omega_d")
    },
    # The first step down: from k_c and the functions at t = 0.
    ("_initial_state", "landen"): {
        **{"k_next": "k_1", "kc": "k_c", "kc_next": "kc_1"},
        **{"s": "sn", "c": "cn", "d": "dn"},
        **{"s_next": "s", "c_next": "c", "d_next": "d"},
    },
}
_COMMON = {
    "_discriminant": ("constants",),
    "_circulation": ("decisions",),
    "_initial_state": ("signs", "constants", "theta", "landen"),
    "_landen": ("landen",),
    "_steady_constants": ("steady",),
    "_steady_state": ("steady",),
}
_STEADY = {"_steady_state": ("cos_half_theta", "sin_half_theta")}
_INNER = {f"Omega_{x}": f"inner_{x}" for x in "abd"}
_HALF = {"cos_half_psi": "X_re", "sin_half_psi": "X_im"}
_NEARER = {"s": "near_s", "c": "near_c", "d": "near_d", "n": "characteristic"}
_SUM = {
    **{"T_re": "W_re", "T_im": "W_im", "E_re": "V_re", "E_im": "V_im"},
    **{"P_re": "W_next_re", "P_im": "W_next_im"},
}
# The level on which dn is 1.
_LAST = 5


@dataclass(frozen=True, slots=True)
class Meanings:
    """Tables that translate names in the ledger into names in generated functions.

    by_context: by function and context, the meanings of the context's names there.  parts: by
    function, formulas that are a part of their fact; `states` puts the parts together and decides
    the whole.  made_from: by function, the formula sequences that it is made from; formulas that
    these prove are named with their facts there.  letters: by function and context, modulus and
    complement where Landen's steps are written out.  values: by function and context, the values of
    standard functions that facts call; their proved bounds say that they are these.
    """

    by_context: Mapping[tuple[str, str], Names]
    parts: Mapping[str, tuple[str, ...]]
    made_from: Mapping[str, tuple[str, ...]]
    letters: Mapping[tuple[str, str], tuple[str, str]] = field(default_factory=dict)
    values: Mapping[tuple[str, str], Names] = field(default_factory=dict)


_THETA = Meanings(
    by_context={
        **_FIRST,
        # At t = 0 the phase has not turned.
        ("_circular_constants", "theta_form"): {"X_re": "1", "X_im": "0"},
        ("_hyperbolic_constants", "theta_form"): {"X_re": "1", "X_im": "0"},
        # It is alpha_b where that is not zero; where it is, all coefficients are.
        ("_columns_state", "excesses"): {"alpha_b": "alpha_divisor"},
        # The general form, which is one of two; and what products divide by where they are taken.
        ("_columns_state", "varied_rates"): {
            name: f"any_{name}" for name in (*(f"Omega_b_by_Omega_{x}" for x in "ad"), "excess_b")
        },
        ("_along_state", "varied_rates"): {f"Omega_{x}_r": f"any_Omega_{x}_r" for x in "abd"},
        ("_along_state", "passing"): {"Omega_a": "Omega_a_there"},
        ("_along_constants", "passing"): {
            name: f"{name}_there" for name in ("alpha_b", "alpha_d", "Omega_a0", "p")
        },
        ("_columns_state", "middle_columns"): {
            **{f"alpha_{x}": f"{x}_divisor" for x in "ad"},
            "Omega_b": "b_divisor",
        },
        ("_columns_state", "spun"): {"p": "p_divisor", "C_t": "C_ahead"},
        ("_real_state", "elapsed_F"): {"F_t": "F_far"},
        ("_imaginary_state", "elapsed_E"): {"E_t": "E_far", "F_t": "f/D_t"},
    },
    parts={
        **{f"_{branch}_constants": (*ROWS, *GAINS) for branch in ("circular", "hyperbolic")},
        **{f"_{branch}_state": STATE for branch in ("circular", "hyperbolic")},
        **_STEADY,
    },
    made_from={
        **_COMMON,
        "_circular_constants": ("constants", "scaling", "pull_back", "circular", "circular_state"),
        "_circular_state": ("circular_state", "rates"),
        "_hyperbolic_constants": (
            *("constants", "shift", "pull_back", "hyperbolic", "hyperbolic_state"),
        ),
        "_hyperbolic_state": ("hyperbolic_state", "rates"),
        "_moduli": ("moments", "columns"),
        "_columns_constants": ("moments", "columns"),
        "_along_constants": ("moments", "columns", "passing"),
        "_along_state": ("sensitivity", "passing"),
        "_columns_state": ("sensitivity", "middle", "excesses", "spun"),
        "_real_state": ("elapsed_F",),
        "_imaginary_state": ("elapsed_E",),
        "_turn_constants": ("turn_constants",),
        "_turn_state": ("turn",),
    },
    values={
        # A difference taken before rounding: the fact varied_rates.below.
        ("_real_state", "elapsed_F"): {"p - r": "apart"},
        ("_imaginary_state", "elapsed_E"): {"p - r": "apart"},
        ("_circular_constants", "theta_form"): {
            "elliptic_k(m_c)": "K_1",
            "theta4(g*u_1, nome_m)": "theta4_v",
            "re(theta3(g*I*beta, nome_m))": "watson",
        },
        ("_hyperbolic_constants", "hyperbolic_form"): {
            "elliptic_k(k_1**2)": "K_c",
            "re(theta2(2*gc*I*u_1, nome_c**2))": "theta2_y",
            "theta3(2*gc*beta, nome_c**2)": "watson",
        },
    },
)
_PI = Meanings(
    by_context={
        **_FIRST,
        # At t = 0 psi is zero, or what the arctangent says.
        ("_circular_constants", "attitude"): {"cos_half_psi": "1", "sin_half_psi": "0"},
        ("_circular_constants", "pi_form"): {"phase": "u_start"},
        ("_hyperbolic_constants", "attitude"): {
            **{"cos_half_psi": "start_re", "sin_half_psi": "start_im"},
        },
        ("_hyperbolic_angles", "arctangent"): _NEARER,
        ("_hyperbolic_angles", "pi_near"): {
            **_NEARER,
            **{"X_re": "turn_re", "X_im": "turn_im", "T_re": "arc_re", "T_im": "arc_im"},
            **_HALF,
        },
        **{
            (f"_{branch}_state", context): {**_INNER, **_HALF}
            for branch in ("circular", "hyperbolic")
            for context in ("regular", "attitude")
        },
    },
    parts=_STEADY,
    made_from={
        **_COMMON,
        "_circular_constants": ("constants", "pi_circular"),
        "_circular_angles": ("pi_circular",),
        "_circular_state": ("state",),
        "_hyperbolic_constants": ("constants", "shift", "pi_hyperbolic"),
        "_hyperbolic_angles": ("pi_hyperbolic",),
        "_hyperbolic_state": ("state",),
    },
    letters={
        ("_circular_constants", "landen"): ("k", "kc"),
        ("_circular_angles", "landen"): ("k", "kc"),
        ("_hyperbolic_constants", "landen"): ("l", "lc"),
        ("_hyperbolic_angles", "landen"): ("l", "lc"),
    },
)
_STEP = Meanings(
    by_context={
        # At the shortest time, without what grows with it.
        ("_step_first", "thirds"): {
            **{"T_re": "1", "T_im": "0"},
            **{"cos_half_psi": "W_re", "sin_half_psi": "W_im"},
        },
        ("_step_second_half", "turn"): {"z_re": "w_re", "z_im": "w_im"},
        ("_step_second_half", "thirds"): _SUM,
        ("_step_last_projected", "turn"): {"w_re": "v_re", "w_im": "v_im"},
        ("_step_last_second_half", "turn"): {"z_re": "v_re", "z_im": "v_im"},
        ("_step_last_second_half", "thirds"): _SUM,
        ("_step_shortest_before", "attitude"): {f"Omega_{x}": f"Omega_{x}0" for x in "abd"},
        ("_step_front", "attitude"): {"cos_half_psi": "1", "sin_half_psi": "0"},
        ("_step_attitude", "thirds"): {
            **{"T_re": "X_re", "T_im": "X_im", "E_re": "W_re", "E_im": "W_im"},
            **{"P_re": "turn_re", "P_im": "turn_im"},
        },
        ("_step_attitude", "attitude"): {"cos_half_psi": "turn_re", "sin_half_psi": "turn_im"},
    },
    parts={},
    made_from={
        "_step_body": ("step",),
        "_step_start": ("step",),
        "_step_first": ("projection", "thirds"),
        "_step_doubled": ("doubling",),
        "_step_projected": ("projection",),
        "_step_second_half": ("projection", "second_half", "thirds"),
        "_step_last_projected": ("projection",),
        "_step_last_second_half": ("projection", "second_half", "thirds"),
        "_step_rates": ("step_rates",),
        "_step_shortest_before": ("state",),
        "_step_front": ("constants",),
        "_step_shortest": ("state",),
        "_step_attitude": ("thirds", "state"),
        "_step_kick": ("kick",),
    },
)
OF = {THETA: _THETA, PI: _PI, STEP: _STEP}


def level(target: str, name: str, letters: tuple[str, str]) -> Names:
    """Map the ledger's names in a Landen step to generated names at a numbered level.

    The level is that of the step that computes `target`; levels are numbered from 1.

    >>> level("k_3", "k_next", ("k", "kc"))["kc"], level("s", "s", ("k", "kc"))["s_next"]
    ('kc_2', 's_2')
    """
    number = target.rpartition("_")[2]
    here = int(number) if number.isdecimal() else 1
    if name.endswith("_next"):
        here -= 1
    modulus, complement = letters
    said = {"k": f"{modulus}_{here}", "kc": f"{complement}_{here}", "root_kc": f"root_{here}"}
    said |= {"k_next": f"{modulus}_{here + 1}", "kc_next": f"{complement}_{here + 1}"}
    for function in ("s", "c", "d", "x", "inside"):
        said[function] = function if here == 1 else f"{function}_{here}"
        said[f"{function}_next"] = f"{function}_{here + 1}"
    return said | ({"d_next": "1"} if here + 1 == _LAST else {})


def claims(solution: Solution, functions: Iterable[Function], form: str = THETA) -> Iterator[Claim]:
    """Yield a claim for each generated formula that cites a fact of the ledger."""
    ledger, names = by_fact(solution), OF[form]
    for function in functions:
        parts = names.parts.get(function.name, ())
        proved = _proved(solution, function, names) | {*parts}
        for let in function.formulas:
            _check_equations(function.name, let, ledger)
            if not let.facts and let.targets[0] in proved:
                raise InputError(function.name, let, "does not say what it comes from")
            for fact in let.facts:
                if let.targets[0] not in parts:
                    yield _claim(function.name, let, ledger[fact], names)


def by_fact(solution: Solution) -> dict[str, Formula]:
    """Map each fact of the ledger to its formula."""
    return {formula.fact: formula for every in solution.sequences.values() for formula in every}


def _proved(solution: Solution, function: Function, names: Meanings) -> set[str]:
    """Return the quantities of a function for which the ledger has proved formulas."""
    place = function.name
    if place == "_ladder":
        # All quarter periods but the first, which is pi/2.
        return {x.targets[0] for x in function.formulas if re.fullmatch(r"K\d+", x.targets[0])} - {
            f"K{sum(len(x.targets) > 1 for x in function.formulas)}"
        }
    found = set()
    for sequence in names.made_from.get(place, ()):
        for formula in solution.sequences[sequence]:
            if not formula.is_reading:
                meaning = names.by_context.get((place, formula.context), {})
                found.add(meaning.get(formula.name, formula.name))
    return found


def _check_equations(place: str, let: Let, ledger: Mapping[str, Formula]) -> None:
    """Check that each paper equation cited by an assignment belongs to one of its facts."""
    for fact in let.facts:
        if fact not in ledger:
            raise InputError(place, let, f"{fact}: the ledger has no such formula")
    carried = {equation for fact in let.facts for equation in ledger[fact].source}
    for source in let.source:
        if source[0].isdigit() and source not in carried:
            raise InputError(place, let, f"({source}): no fact of this line carries it")


def _claim(place: str, let: Let, formula: Formula, names: Meanings) -> Claim:
    meaning = _meaning(place, let, formula, names)
    said = names.values.get((place, formula.context), {})
    values = {parse(call): parse(value) for call, value in said.items()}
    if (put(Name(formula.name), meaning),) != tuple(map(Name, let.targets)):
        raise InputError(place, let, f"{formula.fact}: {DIFFERS}")
    derived = _valued(put(formula.expression, meaning), values)
    return Claim(place, f"{formula.fact}: {let}", derived, let.expression)


def _valued(expression: Expression, values: Mapping[Expression, Expression]) -> Expression:
    """Replace calls of standard functions by the quantities that hold their values."""
    if expression in values:
        return values[expression]
    return rebuild(expression, tuple(_valued(part, values) for part in children(expression)))


def _meaning(place: str, let: Let, formula: Formula, names: Meanings) -> Mapping[str, Expression]:
    if place == "_ladder":
        # K on a step of the ladder, by that on the step below.
        if not re.fullmatch(r"K\d+", ", ".join(let.targets)):
            raise InputError(place, let, "is no quarter period of the ladder")
        n = int(let.targets[0][1:])
        said = {"K": f"K{n}", "K_next": f"K{n + 1}", "k_next": f"k{n + 1}"}
        return {name: Name(text) for name, text in said.items()}
    said = names.by_context.get((place, formula.context), {})
    if (place, formula.context) in names.letters:
        said = level(let.targets[0], formula.name, names.letters[place, formula.context])
    return {name: parse(text) for name, text in said.items()}
