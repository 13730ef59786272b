"""Formula sequences of the closed-form solution, as the ledger publishes them.

The number half starts here.  It reads ledger.json and nothing else of the proof half.  A formula is
a proved fact, or a name's definition or reading in a context.  All other formulas are refused, and
so are those that use a name before it is known.  A sequence's inputs are the names that it uses and
does not set; another ledger's sequence may use no others than that of the installed ledger.
"""

import hashlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from rigidsym.errors import LedgerError
from rigidsym.io.ledger import ledger_data, ledger_text, sealed_text, specification_text
from rigidsym.language._expression import (
    Call,
    Expression,
    children,
    complement,
    parse,
    rebuild,
    to_text,
)
from rigidsym.language._sequence import CONSTANTS, Formula, FormulaSequence
from rigidsym.language._specification import Proved, Theorem, Unproved, read, require
from rigidsym.solution._partition import (
    SIGNS_OF,
    Partition,
    check_order,
    decisions,
    partition_of,
    sign_rules,
)

AXES = ("a", "b", "d")
# The sequences that numbers need, in the order in which the digest has them.
SEQUENCES = (
    *("constants", "state", "theta", "pull_back", "theta_state", "shift", "scaling", "landen"),
    *("rates", "circular", "circular_state", "hyperbolic", "hyperbolic_state", "ascent"),
    *("pi_circular", "pi_hyperbolic", "step", "doubling", "projection", "thirds", "second_half"),
    *("step_rates", "kick", "steady", "moments", "columns", "sensitivity", "middle", "passing"),
    *("excesses", "spun", "elapsed_F", "elapsed_E", "turn_constants", "turn", "momentum"),
    *("fourier", "fourier_rest", "periods", "turned_body", "fourth_powers", "elapsed_slopes"),
    *("sine", "sine_state", "theorem1", "theorem1_state", "turned"),
)
# The quantities that are standard functions.  Where contexts read a name in two ways, the second
# entry has its context in front.
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
# Functions whose last argument is the parameter m.
OF_PARAMETER = {
    *("jacobi_sn", "jacobi_cn", "jacobi_dn", "jacobi_am", "elliptic_j", "elliptic_k"),
    *("elliptic_pi", "nome", "arcsc", "arcsn"),
}


@dataclass(frozen=True, slots=True)
class Solution:
    """The formula sequences of the solution by name, with a digest of all formulas.

    partition: the signs that decide the kind of a motion.  The ledger does not publish
    two of the sequences: `decisions` is the partition as formulas, and `signs` has the signs that
    make the hypotheses of the theorem `start_signs` hold.
    """

    sequences: Mapping[str, tuple[Formula, ...]] = field(hash=False)
    digest: str
    evaluated: Mapping[str, FormulaSequence] = field(repr=False, compare=False)
    partition: Partition = field(repr=False, compare=False)

    def __repr__(self) -> str:
        count = sum(map(len, self.sequences.values()))
        sequences = f"{count} formulas in {len(self.sequences)} sequences"
        return f"<Solution: {sequences}, digest {self.digest[:12]}>"


@cache
def sealed() -> Solution:
    """Return the formula sequences of the installed ledger, after a check of its seal."""
    return load(sealed_text())


def sequence(name: str) -> FormulaSequence:
    """Return one formula sequence of the installed ledger, ready to be evaluated."""
    return sealed().evaluated[name]


def load(text: str) -> Solution:
    """Load the formula sequences from the text of a ledger.

    Raises LedgerError if the ledger does not prove the whole specification.
    """
    ledger, sequences = _published(text)
    evaluated = {name: _evaluated(formulas) for name, formulas in sequences.items()}
    for name in SEQUENCES:
        if name not in sequences:
            raise LedgerError(f"ledger: it does not publish the formula sequence {name}")
        check_order(name, evaluated[name].formulas, {*CONSTANTS, *_inputs()[name]})
        # All formulas hold at once: one context is a model of all others.
        contexts = {formula.context for formula in sequences[name]}
        if not any(contexts <= {*ledger.modelled(context)} for context in contexts):
            rule = f"no context is a model of all: {sorted(contexts)}"
            raise LedgerError(f"ledger: {name}: {rule}")
    try:  # That the proofs hold is for the checkers to decide.
        require(specification_text(), ledger)
    except Unproved as error:
        raise LedgerError(f"ledger: {error}") from None
    specified = read(specification_text())
    partition = partition_of(ledger, specified)
    sequences["decisions"] = decisions(partition)
    sequences["signs"] = _signs(specified[SIGNS_OF], sequences["constants"], ledger)
    evaluated |= {name: _evaluated(sequences[name]) for name in ("decisions", "signs")}
    lines = (
        f"{name}: {formula.fact}: {formula.name} = {to_text(formula.expression)}"
        for name, formulas in sequences.items()
        for formula in formulas
    )
    digest = hashlib.sha256("\n".join(lines).encode()).hexdigest()
    return Solution(sequences, digest, evaluated, partition)


def _published(text: str) -> tuple[Proved, dict[str, tuple[Formula, ...]]]:
    """Return the proved statements and the published formula sequences of a ledger."""
    try:
        ledger = Proved(ledger_data(text))
        return ledger, {
            name: tuple(_formula(entry, ledger) for entry in ledger.sequences[name])
            for name in SEQUENCES
            if name in ledger.sequences
        }
    except Unproved as error:
        raise LedgerError(f"ledger: {error}") from None
    except (KeyError, TypeError, AttributeError) as error:
        raise LedgerError(f"ledger: not readable as rigidsym.ledger/4: {error!r}") from None


@cache
def _inputs() -> dict[str, frozenset[str]]:
    """Return the inputs of each formula sequence in the installed ledger."""
    _, sequences = _published(ledger_text())
    return {name: _evaluated(formulas).inputs for name, formulas in sequences.items()}


def _evaluated(formulas: Iterable[Formula]) -> FormulaSequence:
    return FormulaSequence((formula.name, formula.expression) for formula in formulas)


def _signs(theorem: Theorem, constants: Iterable[Formula], ledger: Proved) -> tuple[Formula, ...]:
    """Return the formulas of the signs sigma, rho and chi.

    The formula of tau is among them, because chi depends on it.
    """
    (source,) = (tuple(x["source"]) for x in ledger.facts.values() if x["context"] == SIGNS_OF)
    *first, last = (
        Formula(name, expression, f"choice {SIGNS_OF}.{name}", SIGNS_OF, source)
        for name, expression in sign_rules(theorem.nonnegative).items()
    )
    (tau,) = (formula for formula in constants if formula.name == "tau")
    return (*first, tau, last)


def _formula(entry: Mapping[str, Any], ledger: Proved) -> Formula:
    """Return a published formula with its origin in the ledger.

    Raises LedgerError for a standard function that `READINGS` does not have.
    """
    stated = ledger.facts[entry["fact"]] if "fact" in entry else entry
    how, context, name, text = ledger.formula(entry)
    expression = parse(f"sqrt({text})" if how == "root" else text)
    if how == "reading":
        expression = _by_complement(expression)
        if READINGS.get(f"{context}:{name}", READINGS.get(name)) != text:
            rule = "its reading is not the one that numbers know"
            raise LedgerError(f"ledger: {context}:{name}: {rule}")
    origin = f"{how} {context}.{name}" if stated is entry else stated["id"]
    return Formula(name, expression, origin, context, tuple(stated["source"]))


def _by_complement(expression: Expression) -> Expression:
    match expression:
        case Call(function, (*arguments, parameter)) if function in OF_PARAMETER:
            return Call(function, (*arguments, complement(parameter)))
    return rebuild(expression, tuple(map(_by_complement, children(expression))))
