"""The sealed ledger: derived byte for byte, replayed, and with a mutant of each kind refused."""

import ast
import re
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest
from ledgers import FACTS, LEDGER, TEXT, prove

import derivations
import rigidsym
from derivations import CHAPTERS, FORWARD
from rigidsym.proof.algebra import LedgerBuilder, Part, join
from rigidsym.proof.algebra._mutants import PRINTED, known_fates, mutants, tally
from rigidsym.proof.kernel import Fact, KernelError, Ledger
from rigidsym.proof.paper import verdicts

CHAPTER_FILES = sorted(Path(derivations.__file__).parent.glob("*.py"))
# What a derivation starts from, and the parts of `lemma1` for wheels and for equal moments.
NO_CHAPTERS = {"__init__", "setting", "gyrostat", "symmetric", "theta_laws"}


@pytest.fixture(scope="module")
def decide(sealed_ledger):
    """Return a function that tries `lhs = rhs` in a context and leaves the ledger as it is."""

    def attempt(context: str, equation: str) -> Fact:
        lhs, rhs = equation.split(" = ")
        scratch = Ledger(None, sealed_ledger.contexts, {}, sealed_ledger.rings)
        return prove(scratch, Fact("attempt", context, "equal", (lhs,), (rhs,), "identity"))

    return attempt


def test_every_chapter_file_is_a_chapter_and_those_that_compute_are_in_their_order():
    assert {path.stem for path in CHAPTER_FILES} - NO_CHAPTERS == {*CHAPTERS}
    assert [name for name in CHAPTERS if name in FORWARD] == list(FORWARD)


def test_the_chapters_write_the_sealed_ledger_byte_for_byte(reproduced):
    assert (reproduced / "files" / "ledger.json").read_text("utf-8") == TEXT


def test_the_sealed_ledger_replays_to_itself(sealed_ledger):
    assert sealed_ledger.to_text() == TEXT


def test_one_assumption_with_a_reference_and_five_points_is_all_that_is_not_proved(sealed_ledger):
    facts = sealed_ledger.facts.values()
    weaker = {fact.id: fact.grade for fact in facts if fact.grade != "PROVED"}
    assert weaker == {"period_functions.complete": "ENCLOSED"}
    (assumed,) = (fact for fact in facts if fact.rule == "assumption")
    assert assumed.source == (assumed.certificate["reference"],)
    assert len(assumed.certificate["points"]) >= 5


DEFINED = sorted(
    {
        (entry["context"], entry["definition"])
        for entries in LEDGER["published"]["sequences"].values()
        for entry in entries
        if "definition" in entry
    }
)
# What these are short for is no matter of their own context: the facts that say why it is right.
ELSEWHERE = {
    ("landen", "K"): "landen.quarter",
    ("scaling", "Y"): "unscaled.top",
    ("pi_near", "cos_half_psi"): "pi_near.models_descended",
    ("pi_near", "sin_half_psi"): "pi_near.models_descended",
    # The momentum over its square is constant: at t = 0 it is what it is later.
    ("turned_columns_start", "K_squared"): "turned_columns.momentum",
}


def admit(ledger, context, facts):
    ledger.open(context)
    for fact in facts:
        ledger.add(fact)


@pytest.mark.parametrize(("context", "name"), DEFINED)
def test_a_published_definition_made_wrong_breaks_what_is_proved_of_it(
    sealed_ledger, context, name
):
    """Double a definition: its context is refused, or a fact or a model breaks."""
    if (context, name) in ELSEWHERE:
        assert ELSEWHERE[context, name] in sealed_ledger.facts
        return
    there = sealed_ledger.contexts[context]
    doubled = {**there.definitions, name: f"2*({there.definitions[name]})"}
    others = {k: value for k, value in sealed_ledger.contexts.items() if k != context}
    scratch = Ledger(None, others, {}, dict(sealed_ledger.rings))
    facts = [f for f in sealed_ledger.facts.values() if f.context == context and not f.premises]
    with pytest.raises(KernelError):
        admit(scratch, replace(there, definitions=doubled), facts)


# By context: equations that are proved, each with a mutant that is not.
MUTANTS = """
body: Euler's equations and the invariants
    D(Omega1) = (c2 - c3)/c1*Omega2*Omega3 | D(Omega1) = (c3 - c2)/c1*Omega2*Omega3
    D(Omega2) = (c3 - c1)/c2*Omega1*Omega3 | D(Omega2) = (c3 - c1)/c1*Omega1*Omega3
    D(M3) = (c1 - c2)*Omega1*Omega2 | D(M3) = (c1 - c2)*Omega1*Omega3
    H = (M1*Omega1 + M2*Omega2 + M3*Omega3)/2 | H = M1*Omega1 + M2*Omega2 + M3*Omega3
    D(M1**2 + M2**2 + M3**2) = 0 | D(M1**2 + M2**2 - M3**2) = 0
    D(c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2) = 0 | D(c1*Omega1 + c2*Omega2) = 0

attitude: the attitude, on axes of either handedness
    D(q_0) = (-q_a*Omega_a - q_b*Omega_b - q_d*Omega_d)/2 |
        D(q_0) = -q_a*Omega_a - q_b*Omega_b - q_d*Omega_d
    D(q_a) = (q_0*Omega_a + epsilon*(q_b*Omega_d - q_d*Omega_b))/2 |
        D(q_a) = (q_0*Omega_a - epsilon*(q_b*Omega_d - q_d*Omega_b))/2
    D(qbar_b) = (qbar_0*Omega_b + epsilon*(qbar_d*Omega_a - qbar_a*Omega_d))/2 |
        D(qbar_b) = (qbar_0*Omega_b + qbar_d*Omega_a - qbar_a*Omega_d)/2
    s_0**2 + s_b**2 + s_d**2 = 1 | s_0**2 + s_b**2 - s_d**2 = 1
    nu**2 = 2*K*(K + sigma*M_a) | nu**2 = 2*K*(K - sigma*M_a)
    M_d = 2*sigma*epsilon*K*s_0*s_b | M_b = 2*sigma*epsilon*K*s_0*s_b
    D(sin_psi) = psi_rate*cos_psi | D(sin_psi) = psi_rate*sin_psi

regular: the rates in Jacobi's functions
    D(Omega_d) = epsilon*(c_a - c_b)/c_d*Omega_a*Omega_b |
        D(Omega_d) = epsilon*(c_b - c_a)/c_d*Omega_a*Omega_b
    m = E_a*c_bd/(E_d*c_ab) | m**2 = E_a*c_bd/(E_d*c_ab)
    m_1 = (c_a - c_d)*E_b/((c_a - c_b)*E_d) | m_1 = (c_a - c_b)*E_b/((c_a - c_d)*E_d)
    lambda_**2 = (c_a - c_b)*E_d/(c_a*c_b*c_d) | lambda_**2 = 2*(c_a - c_b)*E_d/(c_a*c_b*c_d)
    chi*Omega_b = A_b*sn | chi*Omega_b = A_b*cn
    Omega_d = -chi*rho*epsilon*sigma*A_d*cn | Omega_d = -chi*rho*sigma*A_d*cn
    D(dn) = -m*lambda_*sn*cn | D(dn) = -m**2*lambda_*sn*cn
    A_a**2 = E_d/(c_a*(c_a - c_d)) | A_a**2 = E_d/(c_a*(c_a - c_b))

descended: Landen's descent and the secular angle
    k_1 = m/(1 + k_c)**2 | k_1 = m**2/(1 + k_c)**2
    k_c**2 = 1 - m | k_c**2 = 1 - m**2
    m_c = 4*k_c/(1 + k_c)**2 | m_c = 2*k_c/(1 + k_c)**2
    cn = d*c/(1 + k_1*s**2) | dn = d*c/(1 + k_1*s**2)
    D(sn) = lambda_*cn*dn | D(sn) = mu*cn*dn
    n = -k_1*(c_d*A_d)**2/(K + c_a*A_a)**2 | n = k_1*(c_d*A_d)**2/(K + c_a*A_a)**2
    D(psi) = psi_rate | D(psi) = -psi_rate
    D(u) = lambda_ | D(u_1) = lambda_
    kappa = 2*E_a*A_a*k_1/((K + c_a*A_a)**2*mu) | kappa = E_a*A_a*k_1/((K + c_a*A_a)**2*mu)

third_kind: phi1 as an integral of the third kind
    D(phi1) = K*(2*H - c1*Omega1**2)/(K**2 - (c1*Omega1)**2) |
        D(phi1) = K*(2*H + c1*Omega1**2)/(K**2 - (c1*Omega1)**2)
    D(Pi)*(1 - n*sn**2) = xi | D(Pi)*(1 - n*sn) = xi
    D(phi1) = K/c1 + kappa*D(Pi) | D(phi1) = K/c1 - kappa*D(Pi)
    D(Omega1)**2 = (zeta*xi*cn*dn)**2 | D(Omega1)**2 = (zeta*xi*sn*dn)**2

three_angle_motion: the three angles
    c1*D(Omega1) = (c2 - c3)*Omega2*Omega3 | c1*D(Omega1) = (c3 - c2)*Omega2*Omega3
    K**2 - (c1*Omega1)**2 = K**2*sin_phi2**2 | K**2 - (c1*Omega1)**2 = K**2*cos_phi2**2
    phi1_rate*K*sin_phi2**2 = c2*Omega2**2 + c3*Omega3**2 |
        phi1_rate*K*sin_phi2**2 = c3*Omega2**2 + c2*Omega3**2
    phi1_rate*sin_phi2 = Omega2*sin_phi3 + Omega3*cos_phi3 |
        phi1_rate*sin_phi2 = Omega2*cos_phi3 + Omega3*sin_phi3

faster: natural motions between two attitudes
    D(q1) = (q0*W1 + q2*W3 - q3*W2)/2 | D(q1) = (q0*Omega1 + q2*Omega3 - q3*Omega2)/2
    c1*D(W1) = (c2 - c3)*W2*W3 | c1*D(W1) = s*(c2 - c3)*W2*W3
    W1*M1 + W2*M2 + W3*M3 = 2*s*H | W1*M1 + W2*M2 + W3*M3 = 2*s**2*H

manoeuvre: natural motions between two attitudes
    A11 + A22 + A33 = 0 | A11 + A22 = 0
    N1**2 + N2**2 + N3**2 = K**2 | N1**2 + N2**2 - N3**2 = K**2
    R11*p1 + R12*p2 + R13*p3 = p1 | R11*p1 + R12*p2 + R13*p3 = p2

arrival: natural motions between two attitudes
    q1 = z0*p1 + z1*p0 + z2*p3 - z3*p2 | q1 = z0*p1 + z1*p0 - z2*p3 + z3*p2

separatrix_planes: natural motions between two attitudes
    E_b = c_b*(across*M_a - along*M_d)*(across*M_a + along*M_d) |
        E_b = c_b*(along*M_a - across*M_d)*(along*M_a + across*M_d)

ring: natural motions between two attitudes
    c1*W1 = R11*M1 + R21*M2 + R31*M3 | c1*W1 = R11*M1 + R21*M2 - R31*M3
"""


def equations():
    """Yield contexts, equations and mutants of the table; rows that end in | go on below."""
    for block in MUTANTS.strip().split("\n\n"):
        head, _, body = block.partition("\n")
        for row in re.sub(r"\|\n +", "| ", body).splitlines():
            equation, mutant = row.strip().split(" | ")
            yield pytest.param(head.partition(":")[0], equation, mutant, id=mutant)


@pytest.mark.parametrize(("context", "equation", "mutant"), [*equations()])
def test_an_equation_is_proved_and_its_mutant_is_not(decide, context, equation, mutant):
    assert decide(context, equation).grade == "PROVED"
    with pytest.raises(KernelError, match="undecided"):
        decide(context, mutant)


def test_trying_equations_left_the_ledger_alone(sealed_ledger, decide):
    decide("body", "2*H = H + H")
    assert "attempt" not in sealed_ledger.facts


# Mutants by the thousand: each is refuted, refused or equivalent, and the ledger has their counts.

FATES = {"refuted", "refused", "equivalent"}
PART = Part(witness={"c1": "1", "x1": "1", "x2": "1"}, units=("c1",))
SQUARE = {"(x1 + x2)**2/c1": "(x1**2 + 2*x1*x2 + x2**2)/c1"}


@pytest.mark.parametrize("verdict", verdicts(LEDGER), ids=lambda v: v.equation.number)
def test_every_equation_has_ten_mutants_and_most_are_refuted(verdict):
    counts = Counter(verdict.mutants)
    assert set(counts) <= FATES
    assert counts.total() >= 10
    assert counts["refuted"] >= 6


def test_every_fact_decided_or_enclosed_is_counted():
    decided = [
        name
        for name, fact in FACTS.items()
        if fact["rule"] in ("identity", "assumption") and PRINTED not in name
    ]
    assert list(LEDGER["published"]["mutants"]) == decided


def test_all_mutants_counted_again_have_the_sealed_fates(sealed_ledger):
    assert tally(sealed_ledger) == LEDGER["published"]["mutants"]


@pytest.fixture
def builder():
    return opened(Part(witness={"c1": "1", "c2": "2", "x1": "1", "x2": "1"}, units=("c1",)))


def opened(part):
    builder = LedgerBuilder()
    builder.open(join("c", part))
    return builder


def test_mutants_change_one_place_and_are_all_different(builder):
    fact = builder.claim("c.square", SQUARE)
    found = list(mutants(fact, builder.ledger.rings["c"]))
    assert len(found) == len(set(found)) > 10
    assert (fact.lhs[0], fact.rhs[0]) not in found
    assert {
        ("(x1 + x2)**2/c1", "(x1 ** 2 - 2 * x1 * x2 + x2 ** 2) / c1"),
        ("(x1 + x2)**2/c1", "(x1 ** 2 + 2 * x1 * x2 + x2 ** 2) / c2"),
        ("(x1 + x2)**2/c1", "x1 ** 2 + 2 * x1 * x2 + x2 ** 2"),
        ("(x1 + x2)**2/c1", "(x1 + 2 * x1 * x2 + x2 ** 2) / c1"),
    } <= {*found}


def test_the_three_fates(builder):
    builder.claim("c.zero", {"(x1 - x1)/c1": "0"})
    assert set(tally(builder.ledger, each=40)["c.zero"]) == FATES


def ledger_of(part=PART, mutants=None):
    """Return a ledger of two facts, with counts of their mutants as if it were sealed."""
    builder = opened(part)
    builder.claim("c.square", SQUARE)
    builder.claim("c.sum", {"x1 + x2": "x2 + x1"})
    builder.ledger.published["mutants"] = mutants or {}
    return builder.ledger


def test_fates_are_known_of_facts_that_are_word_for_word_the_same():
    marked = {"c.square": {"refuted": 1}, "c.sum": {"refuted": 2}}
    text = ledger_of(mutants=marked).to_text()
    assert known_fates(ledger_of(), text) == marked
    more = LedgerBuilder()
    more.ledger = ledger_of()
    more.claim("c.double", {"x1 + x1": "2*x1"})
    assert known_fates(more.ledger, text) == marked
    counts = tally(more.ledger, known_fates(more.ledger, text))
    assert counts["c.square"] == {"refuted": 1}
    assert counts["c.double"] == tally(more.ledger)["c.double"]


@pytest.mark.parametrize(
    "changes",
    [
        {"units": ("c1", "x1")},
        {"definitions": {"y": "x1"}},
        {"witness": {"c1": "2", "x1": "1", "x2": "1"}},
    ],
)
def test_no_fate_is_known_where_the_context_is_another(changes):
    text = ledger_of(mutants={"c.square": {"refuted": 1}}).to_text()
    assert known_fates(ledger_of(replace(PART, **changes)), text) == {}


def test_no_fate_is_known_of_a_changed_fact():
    text = ledger_of(mutants={"c.sum": {"refuted": 1}}).to_text()
    assert known_fates(ledger_of(), text.replace('"x2 + x1"', '"x1 + x2 + 0"')) == {}
    assert known_fates(ledger_of(), LedgerBuilder().ledger.to_text()) == {}


# No chapter, step or part of the kernel decides by a heuristic simplifier.

BANNED = {"simplify", "nsimplify", "trigsimp", "equals"}
# A step may put a value in a symbol's place before the kernel sees it; what decides may not.
DECIDING = ("kernel", "algebra")
PROOF = Path(rigidsym.__file__).parent / "proof"
TRUSTED = [
    *CHAPTER_FILES,
    *(
        path
        for name in ("kernel", "algebra", "steps")
        for path in sorted(PROOF.glob(f"{name}/*.py"))
    ),
]


def test_all_that_proves_is_looked_at():
    assert {path.parent.name for path in TRUSTED} == {"derivations", "steps", *DECIDING}


@pytest.mark.parametrize("path", TRUSTED, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_no_heuristic_simplifier_is_named(path):
    named = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        # Names, attributes and imports.
        named |= {getattr(node, "id", None), getattr(node, "attr", None)}
        named |= {
            alias.name for alias in getattr(node, "names", []) if isinstance(alias, ast.alias)
        }
    assert not named & (BANNED | ({"subs"} if path.parent.name in DECIDING else set()))
