"""The derived solution as data: the sequences of formulas that the ledger publishes.

The number wing starts here.  It reads ledger.json and nothing else of the proof wing.  A formula is
a proved fact, or what a context says of a name, by definition or as a reading; others, and those
that use a name before it is known, are refused.
"""

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any, TypedDict

from rigidsym.errors import LedgerError
from rigidsym.io.ledger import ledger_data, sealed_text, specification_text
from rigidsym.language import specification
from rigidsym.language.expression import (
    Call,
    Expression,
    children,
    complement,
    names,
    parse,
    rebuild,
    to_text,
)
from rigidsym.language.sequence import FormulaSequence
from rigidsym.language.specification import Unproved, read, require
from rigidsym.solution import signs
from rigidsym.solution.decisions import decisions
from rigidsym.solution.formula import Formula
from rigidsym.solution.partition import Partition, partition_of

AXES = ("a", "b", "d")
_BY_FUNCTIONS = (
    *("epsilon", "sigma", "rho", "chi", "mu", "phase", "beta", "Lambda"),
    *("p_0", "p_a", "p_b", "p_d", "t"),
)
_ALPHA = (
    *("alpha_a", "alpha_b", "alpha_d", "tilt"),
    *(f"tilt_by_c_{x}" for x in AXES),
    *(f"alpha_{x}_by_c_{y}" for x in AXES for y in AXES),
)
# What each sequence is given; everything else it computes.
INPUTS = {
    "constants": (
        *(f"c_{x}" for x in AXES),
        *(f"Omega_{x}" for x in AXES),
        *("epsilon", "sigma", "rho", "chi"),
        *(f"q_{x}" for x in ("0", *AXES)),
        *("t", "cos_half_psi", "sin_half_psi"),
    ),
    "state": (
        *(f"c_{x}" for x in AXES),
        *("A_a", "A_b", "A_d", "K", "epsilon", "sigma", "tau", "chi", "k_1", "k_c", "m_c", "mu"),
        *("phase", "n", "psi_0", "kappa", "J_0", "p_0", "p_a", "p_b", "p_d", "t"),
    ),
    "theta": (
        *(f"c_{x}" for x in AXES),
        *("A_a", "A_b", "A_d", "K", "rho", "k_1", "m_c", "mu", "psi_0"),
    ),
    "pull_back": ("epsilon", *(f"{q}_{x}" for q in ("q", "qbar") for x in ("0", *AXES))),
    "theta_state": (
        *(f"c_{x}" for x in AXES),
        *("K", "epsilon", "sigma", "rho", "chi", "k_1", "m_c", "mu", "phase", "n"),
        *("root_k", "x", "y", "z", "beta", "g", "nome_1", "Lambda"),
        *("p_0", "p_a", "p_b", "p_d", "t"),
    ),
    "shift": ("k_1", "K", "B_a", "B_d"),
    "scaling": ("B_d", "K", "B_a", "k_1", "r", "Y_b"),
    "landen": ("k", "kc", "s", "c", "d", "r", "Y", "K_next"),
    "rates": ("sigma", "chi", "tau", "A_a", "A_b", "A_d", "u", "m_1"),
    "circular": ("m_c", "beta", "rho", "mu", "psi_0"),
    "circular_state": (*_BY_FUNCTIONS, "g", "nome_1", "nome_m"),
    "hyperbolic": ("k_1", "beta", "rho", "mu", "psi_0"),
    "hyperbolic_state": (*_BY_FUNCTIONS, "gc", "nome_c"),
    "ascent": ("k_next", "s_next", "c_next", "d_next", "x_next"),
    "pi_circular": ("psi_0", "kappa", "mu", "j", "J", "u_1", "J_0", "phase"),
    "pi_hyperbolic": (
        *("H", "K", "rho", "k_1", "m_c", "n", "x", "y", "z", "K_1", "j"),
        *("s", "c", "d", "X_re", "X_im"),
    ),
    "step": (*(f"c_{x}" for x in AXES), *(f"Omega_{x}0" for x in AXES), "epsilon", "sigma"),
    "doubling": ("X", "Y", "e_1", "e_2"),
    "projection": ("h", "z_re", "z_im", "zr_re", "zr_im", "X", "Y"),
    "thirds": ("G_re", "G_im", "T_re", "T_im", "E_re", "E_im"),
    "second_half": ("G_re", "G_im", "W_re", "W_im"),
    "step_rates": (
        *("X", "Y", "h", *(f"alpha_{x}" for x in AXES), "l_d", *(f"Omega_{x}0" for x in AXES)),
    ),
    "kick": (
        *(f"q{k}" for k in range(4)),
        *(f"{x}{k}" for x in "ubm" for k in range(1, 4)),
        *("k", "Q11", "Q22", "Q33", "Q23", "Q13", "Q12"),
    ),
    "steady": ("Omega1", "Omega2", "Omega3", "p0", "p1", "p2", "p3", "t"),
    "moments": ("epsilon", *(f"c_{x}" for x in AXES), *(f"Omega_{x}0" for x in AXES)),
    "columns": (*_ALPHA, *(f"Omega_{x}0" for x in AXES)),
    "sensitivity": (
        *_ALPHA,
        *(f"Omega_{x}0" for x in AXES),
        *("g_a", "g_d", "k", "kappa_a", "kappa_d", "p", "r"),
        *("p_by_Omega_a", "p_by_Omega_b", "r_by_Omega_d"),
        *(f"{x}_by_c_{y}" for x in ("kappa", "p", "apart", "leant", *AXES) for y in AXES),
        *("S_t", "C_t", "D_t", "E_t", "F_t", "t"),
    ),
    "middle": (
        *("alpha_a", "alpha_b", "alpha_d", "Omega_a", "Omega_b", "Omega_d"),
        *("Omega_d_by_Omega_a", "Omega_a_by_Omega_d"),
    ),
    "passing": (
        *(*_ALPHA[:3], "k", "p", "r", "over", "S_t", "D_t", "F_t", "t"),
        *(f"Omega_{x}{start}" for x in AXES for start in ("", "0")),
    ),
    "excesses": ("alpha_a", "alpha_b", "alpha_d", "excess_b"),
    "spun": (
        *("alpha_b", "kappa_a", "kappa_d", "k", "p", "apart", "over", "S_t", "C_t", "D_t"),
        *("E_t", "f", "t", *(f"Omega_{x}0" for x in AXES)),
    ),
    "elapsed_F": ("p", "r", "S_t", "C_t", "D_t", "E_t", "t"),
    "elapsed_E": ("p", "r", "S_t", "C_t", "D_t", "F_t", "t"),
    "turn_constants": (
        *(f"c{k}" for k in range(1, 4)),
        *(f"Omega{k}_0" for k in range(1, 4)),
        *("p0", "p1", "p2", "p3"),
    ),
    "turn": (
        *(f"{x}{k}" for x in ("c", "Omega", "l", "excess") for k in range(1, 4)),
        *(f"Omega{k}_0" for k in range(1, 4)),
        *("per_K2", "q0", "q1", "q2", "q3", "t"),
        *(f"B{i}{k}" for i in range(1, 4) for k in range(1, 4)),
        *(f"Omega{k}_by_{x}{j}" for x in ("Omega", "c") for j in range(1, 4) for k in range(1, 4)),
    ),
    "momentum": (
        *(f"c_{x}" for x in AXES),
        *("epsilon", "sigma", "K", *(f"qbar_{x}" for x in ("0", *AXES))),
    ),
    "fourier": ("e", "x"),
    "fourier_rest": ("x", "rho", "sinh_b", "k"),
    "periods": ("n", "m_c", "mu", "psi_0", "kappa", "sigma", "A_a", "lambda_"),
    "turned_body": (
        *(f"{x}{k}" for x in ("c", "dc", "Omega", "dOmega", "l") for k in range(1, 4)),
        *("K", "s", "q0", "q1", "q2", "q3"),
    ),
    "fourth_powers": ("p", "r", "S_t", "C_t", "D_t", "E_t", "F_t", "t"),
    "elapsed_slopes": ("p", "r", *(f"{x}_t" for x in "SCDEFUVW")),
    "sine": (*(f"c_{i}" for i in "ijk"), *(f"Omega_{i}" for i in "ijk"), "half"),
    "sine_state": ("zeta", "xi", "C_i", "mu", "t"),
    "theorem1": ("c1", "c2", "c3", "Omega1", "Omega2", "Omega3", "zeta", "xi", "C_1", "mu"),
    "theorem1_state": (
        *("c1", "c2", "c3", "Omega1", "Omega2", "Omega3", "side", "K", "xi", "C_1", "mu", "n"),
        *("kappa", "Pi_0", "t"),
    ),
    "turned": ("epsilon", *(f"{q}_{x}" for q in ("p", "qbar") for x in ("0", *AXES))),
}
CONSTANTS = ("pi", "I")
# The standard functions that numbers may use, and the quantities they stand for; where a name is
# read in two ways, the context of the second is before it.
READINGS = {
    "s": "jacobi_sn(u_1, 1 - m_c)",
    "c": "jacobi_cn(u_1, 1 - m_c)",
    "d": "jacobi_dn(u_1, 1 - m_c)",
    "u": "jacobi_argument(sn, cn, dn)",
    **{f"{x}n": f"jacobi_{x}n(u, 1 - m_1)" for x in "scd"},
    "J": "elliptic_j(u_1, n, 1 - m_c)",
    "J_0": "elliptic_j(phase, n, 1 - m_c)",
    "beta": "arcsc(x, 1 - k_1**2)",
    "g": "pi/(2*elliptic_k(1 - m_c))",
    "nome_1": "nome(1 - m_c)",
    "nome_m": "sqrt(nome(1 - m_c))",
    "zeta": "g*im(dtheta4(g*I*beta, nome_1)/theta4(g*I*beta, nome_1))",
    "T4_re": "re(theta4(g*(u_1 - rho*I*beta), nome_1))",
    "T4_im": "im(theta4(g*(u_1 - rho*I*beta), nome_1))",
    "T1_re": "re(theta1(g*(u_1 - rho*I*beta), nome_1))",
    "T1_im": "im(theta1(g*(u_1 - rho*I*beta), nome_1))",
    "W": "theta4(g*u_1, nome_m)*re(theta3(g*I*beta, nome_m))",
    "gc": "pi/(2*elliptic_k(1 - k_1**2))",
    "nome_c": "nome(1 - k_1**2)",
    "hyperbolic_form:zeta": "-gc*dtheta2(gc*beta, nome_c)/theta2(gc*beta, nome_c)",
    "hyperbolic_form:T4_re": "re(theta2(gc*(rho*beta + I*u_1), nome_c))",
    "hyperbolic_form:T4_im": "im(theta2(gc*(rho*beta + I*u_1), nome_c))",
    "hyperbolic_form:T1_re": "im(theta1(gc*(rho*beta + I*u_1), nome_c))",
    "hyperbolic_form:T1_im": "-re(theta1(gc*(rho*beta + I*u_1), nome_c))",
    "hyperbolic_form:W": "2*re(theta2(2*gc*I*u_1, nome_c**2))*theta3(2*gc*beta, nome_c**2)",
    "X_re": "cos(Lambda*t)",
    "X_im": "sin(Lambda*t)",
    "cos_half_psi": "cos(psi/2)",
    "sin_half_psi": "sin(psi/2)",
    "cos_half_theta": "cos(theta/2)",
    "sin_half_theta": "sin(theta/2)",
    "K_1": "elliptic_k(1 - m_c)",
    "turn": "2*pi",
    "J_c": "(elliptic_pi(n, 1 - m_c) - K_1)/n",
    "one_rate:zeta": "sqrt(root_j)",
    "one_rate:xi": "half*sqrt(alpha*root_k)",
    "one_rate:C_i": "arcsn(Omega_i/zeta, mu)",
    "one_rate:sn": "jacobi_sn(xi*t + C_i, mu)",
    "Pi": "elliptic_pi(n, jacobi_am(xi*t + C_1, mu), mu) - Pi_0",
    "Pi_0": "elliptic_pi(n, jacobi_am(C_1, mu), mu)",
    "cos_half_phi1": "cos(phi1/2)",
    "sin_half_phi1": "sin(phi1/2)",
}
_OF_PARAMETER = {
    *("jacobi_sn", "jacobi_cn", "jacobi_dn", "jacobi_am", "elliptic_j", "elliptic_k"),
    *("elliptic_pi", "nome", "arcsc", "arcsn"),
}


class Fact(TypedDict):
    """What is read of a fact of the ledger: sides are lists of texts."""

    id: str
    context: str
    kind: str
    grade: str
    lhs: list[str]
    rhs: list[str]
    source: list[str]


class Context(TypedDict):
    """What is read of a context: what its names abbreviate, and standard functions they are."""

    name: str
    definitions: dict[str, str]
    reading: dict[str, str]


class Entry(TypedDict, total=False):
    """A formula that is published: by its fact, or by a context's definition or reading."""

    fact: str
    context: str
    definition: str
    reading: str
    source: list[str]


@dataclass(frozen=True, slots=True)
class Solution:
    """The sequences by name, a digest of all their statements, and what evaluates them.

    partition: by which signs the kinds of motions are told apart.  Two sequences are not published:
    `decisions` is the partition as formulas, and `signs` what the theorem about them says of each.
    """

    sequences: Mapping[str, tuple[Formula, ...]]
    digest: str
    evaluated: Mapping[str, FormulaSequence] = field(repr=False, compare=False)
    partition: Partition = field(repr=False, compare=False)

    def __repr__(self) -> str:
        count = sum(map(len, self.sequences.values()))
        sequences = f"{count} formulas in {len(self.sequences)} sequences"
        return f"<Solution: {sequences}, digest {self.digest[:12]}>"


@cache
def sealed() -> Solution:
    """The solution of the sealed ledger."""
    return load(sealed_text())


def sequence(name: str) -> FormulaSequence:
    """A formula sequence of the sealed ledger, ready to be evaluated."""
    return sealed().evaluated[name]


def load(text: str) -> Solution:
    """The solution that a ledger publishes; raises LedgerError where it proves less."""
    data = ledger_data(text)
    try:
        facts = {fact["id"]: fact for fact in data["facts"]}
        contexts = {context["name"]: context for context in data["contexts"]}
        published = specification.sequences(data)
        sequences = {
            name: tuple(_formula(entry, facts, contexts) for entry in published[name])
            for name in INPUTS
            if name in published
        }
    except (KeyError, TypeError, AttributeError) as error:
        raise LedgerError(f"ledger: not readable as rigidsym.ledger/4: {error!r}") from None
    for name in INPUTS:
        if name not in sequences:
            raise LedgerError(f"ledger: it does not publish the formula sequence {name}")
        _check_order(name, sequences[name])
        _check_together(name, sequences[name], facts)
    _check_specified(data)
    specified = read(specification_text())
    partition = partition_of(facts.values(), contexts, specified)
    sequences["decisions"] = decisions(partition)
    sequences["signs"] = _signs(specified[signs.THEOREM].nonnegative, sequences["constants"], facts)
    evaluated = {
        name: FormulaSequence((f.name, f.expression) for f in formulas)
        for name, formulas in sequences.items()
    }
    return Solution(sequences, _digest(sequences), evaluated, partition)


def _check_specified(data: Mapping[str, Any]) -> None:
    """The ledger states every theorem of the specification; that proofs hold, checkers decide."""
    try:
        require(specification_text(), data)
    except Unproved as error:
        raise LedgerError(f"ledger: {error}") from None


def _signs(
    nonnegative: Iterable[str], constants: Iterable[Formula], facts: Mapping[str, Fact]
) -> tuple[Formula, ...]:
    """The signs in their order; tau, which chi is by, is the published one."""
    place = signs.THEOREM
    (source,) = (x["source"] for x in facts.values() if x["context"] == place)
    *first, last = (
        Formula(name, expression, f"choice {place}.{name}", place, tuple(source))
        for name, expression in signs.rules(nonnegative).items()
    )
    (tau,) = (formula for formula in constants if formula.name == "tau")
    return (*first, tau, last)


def _formula(entry: Entry, facts: Mapping[str, Fact], contexts: Mapping[str, Context]) -> Formula:
    if "definition" in entry:
        return _by_definition(entry["definition"], contexts[entry["context"]], entry["source"])
    if "reading" in entry:
        return _by_reading(entry["reading"], contexts[entry["context"]], entry["source"])
    fact = facts[entry["fact"]]
    proved = fact["grade"] == "PROVED" and fact["kind"] in ("equal", "root")
    if not proved or len(fact["lhs"]) != 1:
        raise LedgerError(f"ledger: {fact['id']} is published but is not one proved formula")
    (name,), (text,) = fact["lhs"], fact["rhs"]
    expression = parse(text)
    if fact["kind"] == "root":
        expression = Call("sqrt", (expression,))
    return Formula(name, expression, fact["id"], fact["context"], tuple(fact["source"]))


def _by_definition(name: str, context: Context, source: Iterable[str]) -> Formula:
    """What a context, and with it each of its models, has a name for."""
    place, expression = context["name"], parse(context["definitions"][name])
    return Formula(name, expression, f"definition {place}.{name}", place, tuple(source))


def _by_reading(name: str, context: Context, source: Iterable[str]) -> Formula:
    """The standard function that a context reads a name as."""
    reading, place = context["reading"][name], context["name"]
    expression = _by_complement(parse(reading))
    if READINGS.get(f"{place}:{name}", READINGS.get(name)) != reading:
        raise LedgerError(f"ledger: {place}:{name}: its reading is not the one that numbers know")
    return Formula(name, expression, f"reading {place}.{name}", place, tuple(source))


def _by_complement(expression: Expression) -> Expression:
    match expression:
        case Call(function, (*arguments, parameter)) if function in _OF_PARAMETER:
            return Call(function, (*arguments, complement(parameter)))
    return rebuild(expression, tuple(map(_by_complement, children(expression))))


def _check_order(sequence: str, formulas: tuple[Formula, ...]) -> None:
    known = {*CONSTANTS, *INPUTS.get(sequence, ())}
    for formula in formulas:
        missing = sorted(set(names(formula.expression)) - known)
        if missing:
            raise LedgerError(f"ledger: {sequence}: {formula.name} needs {', '.join(missing)}")
        known.add(formula.name)


def _check_together(
    sequence: str, formulas: tuple[Formula, ...], facts: Mapping[str, Fact]
) -> None:
    """All formulas hold at once: one context is a model of every other they come from."""
    contexts = {formula.context for formula in formulas}
    if not any(contexts <= _modelled(context, facts) for context in contexts):
        raise LedgerError(f"ledger: {sequence}: no context is a model of all: {sorted(contexts)}")


def _modelled(context: str, facts: Mapping[str, Fact]) -> set[str]:
    """A context, what it is proved to be a model of, what that is a model of, and so on."""
    found = [context]
    for name in found:
        found += [
            fact["rhs"][0]
            for fact in facts.values()
            if (fact["kind"], fact["context"], fact["grade"]) == ("model", name, "PROVED")
        ]
    return set(found)


def _digest(sequences: Mapping[str, tuple[Formula, ...]]) -> str:
    lines = [
        f"{name}: {formula.fact}: {formula.name} = {to_text(formula.expression)}"
        for name, formulas in sequences.items()
        for formula in formulas
    ]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()
