"""A formula that names what the ledger has it from is that, under names declared here.

The renaming in `rigidsym.codegen` is what is decided: this table is written down apart from it.
"""

from collections.abc import Iterable, Iterator, Mapping

from rigidsym.codegen.ir import Function, Let
from rigidsym.codegen.names import GAINS, ROWS, STATE
from rigidsym.codegen.seal.claims import DIFFERS, Claim
from rigidsym.codegen.special_functions import landen
from rigidsym.errors import InputError
from rigidsym.language.expression import Expression, Name, children, parse, put, rebuild
from rigidsym.solution import Formula, Solution

# By function and the context of the fact: what the fact's names are there.
_MEANINGS = {
    # The first step down: from k_c and the functions at t = 0.
    ("_initial_state", "landen"): {
        **{"k_next": "k_1", "kc": "k_c", "kc_next": "kc_1"},
        **{"s": "sn", "c": "cn", "d": "dn"},
        **{"s_next": "s", "c_next": "c", "d_next": "d"},
    },
    # Of moments only whether they are zero counts.
    ("_circulation", "sorted_body"): {"c_3": "1"},
    # Signs are those of doubles.
    ("_initial_state", "start_signs"): {
        name: f"rounded({name})" for name in ("c_ad", "Omega_a", "Omega_d")
    },
    # At t = 0 the phase has not turned.
    ("_circular_constants", "theta_form"): {"X_re": "1", "X_im": "0"},
    ("_hyperbolic_constants", "theta_form"): {"X_re": "1", "X_im": "0"},
}
# By function and context: what standard functions, called in a fact, are there.  That they are, the
# bounds of the special functions say.
_VALUES = {
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
}
# Formulas that are a part of their fact; `states` puts the parts together and decides the whole.
_PARTS_OF_FACTS = {
    **{f"_{branch}_constants": (*ROWS, *GAINS) for branch in ("circular", "hyperbolic")},
    **{f"_{branch}_state": STATE for branch in ("circular", "hyperbolic")},
    "_steady_state": ("cos_half_theta", "sin_half_theta"),
}
# The formula sequences that a function is made from: what they prove is named with its fact there.
_MADE_FROM = {
    "_discriminant": ("constants",),
    "_circulation": ("decisions",),
    "_initial_state": ("signs", "constants", "theta", "landen"),
    "_landen": ("landen",),
    "_circular_constants": ("constants", "scaling", "pull_back", "circular", "circular_state"),
    "_circular_state": ("circular_state", "rates"),
    "_hyperbolic_constants": ("constants", "shift", "pull_back", "hyperbolic", "hyperbolic_state"),
    "_hyperbolic_state": ("hyperbolic_state", "rates"),
    "_steady_constants": ("steady",),
    "_steady_state": ("steady",),
}


def claims(solution: Solution, functions: Iterable[Function]) -> Iterator[Claim]:
    """Each formula that names a fact, and the fact."""
    ledger = by_fact(solution)
    for function in functions:
        parts = _PARTS_OF_FACTS.get(function.name, ())
        proved = _proved(solution, function.name) | {*parts}
        for let in function.formulas:
            _check_equations(function.name, let, ledger)
            if not let.facts and let.targets[0] in proved:
                raise InputError(function.name, let, "does not say what it comes from")
            for fact in let.facts:
                if let.targets[0] not in parts:
                    yield _claim(function.name, let, ledger[fact])


def by_fact(solution: Solution) -> dict[str, Formula]:
    """The formulas of all sequences by what the ledger has them from."""
    return {formula.fact: formula for every in solution.sequences.values() for formula in every}


def _proved(solution: Solution, place: str) -> set[str]:
    """What the names of the ledger that a function may set are called there."""
    if place == "_ladder":
        return {f"K{n}" for n in range(landen.STEPS)}
    found = set()
    for sequence in _MADE_FROM.get(place, ()):
        for formula in solution.sequences[sequence]:
            if not formula.is_reading:
                meaning = _MEANINGS.get((place, formula.context), {})
                found.add(meaning.get(formula.name, formula.name))
    return found


def _check_equations(place: str, let: Let, ledger: Mapping[str, Formula]) -> None:
    """A line names equations of the paper by facts alone that carry them."""
    for fact in let.facts:
        if fact not in ledger:
            raise InputError(place, let, f"{fact}: the ledger has no such formula")
    carried = {equation for fact in let.facts for equation in ledger[fact].source}
    for source in let.source:
        if source[0].isdigit() and source not in carried:
            raise InputError(place, let, f"({source}): no fact of this line carries it")


def _claim(place: str, let: Let, formula: Formula) -> Claim:
    meaning = _meaning(place, let, formula.context)
    values = {parse(k): parse(v) for k, v in _VALUES.get((place, formula.context), {}).items()}
    if (put(Name(formula.name), meaning),) != tuple(map(Name, let.targets)):
        raise InputError(place, let, f"{formula.fact}: {DIFFERS}")
    derived = _valued(put(formula.expression, meaning), values)
    return Claim(place, f"{formula.fact}: {let}", derived, let.expression)


def _valued(expression: Expression, values: Mapping[Expression, Expression]) -> Expression:
    """The expression with what calls of standard functions are in place of them."""
    if expression in values:
        return values[expression]
    return rebuild(expression, tuple(_valued(part, values) for part in children(expression)))


def _meaning(place: str, let: Let, context: str) -> Mapping[str, Expression]:
    if place == "_ladder":
        return _rung(place, let)
    return {name: parse(text) for name, text in _MEANINGS.get((place, context), {}).items()}


def _rung(place: str, let: Let) -> Mapping[str, Expression]:
    """K on a step of the ladder, from the step below."""
    for n in range(landen.STEPS):
        if let.targets == (f"K{n}",):
            means = {"K": f"K{n}", "K_next": f"K{n + 1}", "k_next": f"k{n + 1}"}
            return {name: Name(text) for name, text in means.items()}
    raise InputError(place, let, "is no quarter period of the ladder")
