import ast
import json
from dataclasses import replace
from pathlib import Path

import pytest
from ledgers import prove

import derivations
import rigidsym
from derivations import CHAPTERS, FORWARD
from rigidsym.proof.algebra._enclosures import encloses
from rigidsym.proof.kernel import Fact, KernelError, Ledger, replay

SEALED = Path(derivations.__file__).with_name("ledger.json").read_text("utf-8")
PACKAGE = Path(rigidsym.__file__).parent
# What a derivation starts from, and the part of `lemma1` for a body with wheels.
NO_CHAPTERS = {"setting", "gyrostat", "theta_laws"}


@pytest.fixture(scope="module")
def ledger() -> Ledger:
    return replay(SEALED, encloses)


@pytest.fixture(scope="module")
def decide(ledger):
    """Tries equations ``lhs = rhs`` in a context of the ledger, leaving that as it is."""

    def attempt(context: str, equation: str) -> Fact:
        lhs, rhs = equation.split(" = ")
        scratch = Ledger(None, ledger.contexts, {}, ledger.rings)
        return prove(scratch, Fact("attempt", context, "equal", (lhs,), (rhs,), "identity"))

    return attempt


def test_every_chapter_file_is_a_chapter():
    files = {path.stem for path in Path(derivations.__file__).parent.glob("*.py")}
    assert files - {"__init__", *NO_CHAPTERS} == set(CHAPTERS)


def test_the_chapters_that_compute_are_in_their_order_among_all():
    assert [name for name in CHAPTERS if name in FORWARD] == list(FORWARD)


def test_the_chapters_write_the_sealed_ledger_byte_for_byte(reproduced):
    assert (reproduced / "files" / "ledger.json").read_text("utf-8") == SEALED


def test_the_sealed_ledger_replays_to_itself(ledger):
    assert ledger.to_text() == SEALED


def test_only_the_interchange_of_argument_and_parameter_is_weaker_than_proved(ledger):
    weaker = {fact.id: fact.grade for fact in ledger.facts.values() if fact.grade != "PROVED"}
    assert weaker == {"period_functions.complete": "ENCLOSED"}


def test_every_assumption_has_a_reference_and_at_least_five_points(ledger):
    assumed = [fact for fact in ledger.facts.values() if fact.rule == "assumption"]
    assert len(assumed) == 1
    for fact in assumed:
        assert fact.source == (fact.certificate["reference"],)
        assert len(fact.certificate["points"]) >= 5


PUBLISHED = json.loads(SEALED)["published"]["sequences"]
DEFINED = sorted(
    {
        (entry["context"], entry["definition"])
        for entries in PUBLISHED.values()
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
def test_a_published_definition_made_wrong_breaks_what_is_proved_of_it(ledger, context, name):
    """Doubled, a definition is refused with its context, or breaks a fact or a model."""
    if (context, name) in ELSEWHERE:
        assert ELSEWHERE[context, name] in ledger.facts
        return
    there = ledger.contexts[context]
    doubled = {**there.definitions, name: f"2*({there.definitions[name]})"}
    others = {other: value for other, value in ledger.contexts.items() if other != context}
    scratch = Ledger(None, others, {}, dict(ledger.rings))
    facts = [f for f in ledger.facts.values() if f.context == context and not f.premises]
    with pytest.raises(KernelError):
        admit(scratch, replace(there, definitions=doubled), facts)


MUTANTS = [
    # Euler's equations and the invariants
    ("body", "D(Omega1) = (c2 - c3)/c1*Omega2*Omega3", "D(Omega1) = (c3 - c2)/c1*Omega2*Omega3"),
    ("body", "D(Omega2) = (c3 - c1)/c2*Omega1*Omega3", "D(Omega2) = (c3 - c1)/c1*Omega1*Omega3"),
    ("body", "D(M3) = (c1 - c2)*Omega1*Omega2", "D(M3) = (c1 - c2)*Omega1*Omega3"),
    ("body", "H = (M1*Omega1 + M2*Omega2 + M3*Omega3)/2", "H = M1*Omega1 + M2*Omega2 + M3*Omega3"),
    ("body", "D(M1**2 + M2**2 + M3**2) = 0", "D(M1**2 + M2**2 - M3**2) = 0"),
    ("body", "D(c1*Omega1**2 + c2*Omega2**2 + c3*Omega3**2) = 0", "D(c1*Omega1 + c2*Omega2) = 0"),
    # the attitude, on axes of either handedness
    (
        "attitude",
        "D(q_0) = (-q_a*Omega_a - q_b*Omega_b - q_d*Omega_d)/2",
        "D(q_0) = -q_a*Omega_a - q_b*Omega_b - q_d*Omega_d",
    ),
    (
        "attitude",
        "D(q_a) = (q_0*Omega_a + epsilon*(q_b*Omega_d - q_d*Omega_b))/2",
        "D(q_a) = (q_0*Omega_a - epsilon*(q_b*Omega_d - q_d*Omega_b))/2",
    ),
    (
        "attitude",
        "D(qbar_b) = (qbar_0*Omega_b + epsilon*(qbar_d*Omega_a - qbar_a*Omega_d))/2",
        "D(qbar_b) = (qbar_0*Omega_b + qbar_d*Omega_a - qbar_a*Omega_d)/2",
    ),
    ("attitude", "s_0**2 + s_b**2 + s_d**2 = 1", "s_0**2 + s_b**2 - s_d**2 = 1"),
    ("attitude", "nu**2 = 2*K*(K + sigma*M_a)", "nu**2 = 2*K*(K - sigma*M_a)"),
    ("attitude", "M_d = 2*sigma*epsilon*K*s_0*s_b", "M_b = 2*sigma*epsilon*K*s_0*s_b"),
    (
        "attitude",
        "D(sin_psi) = psi_rate*cos_psi",
        "D(sin_psi) = psi_rate*sin_psi",
    ),
    # the rates in Jacobi's functions
    (
        "regular",
        "D(Omega_d) = epsilon*(c_a - c_b)/c_d*Omega_a*Omega_b",
        "D(Omega_d) = epsilon*(c_b - c_a)/c_d*Omega_a*Omega_b",
    ),
    (
        "regular",
        "m = E_a*c_bd/(E_d*c_ab)",
        "m**2 = E_a*c_bd/(E_d*c_ab)",
    ),
    (
        "regular",
        "m_1 = (c_a - c_d)*E_b/((c_a - c_b)*E_d)",
        "m_1 = (c_a - c_b)*E_b/((c_a - c_d)*E_d)",
    ),
    (
        "regular",
        "lambda_**2 = (c_a - c_b)*E_d/(c_a*c_b*c_d)",
        "lambda_**2 = 2*(c_a - c_b)*E_d/(c_a*c_b*c_d)",
    ),
    ("regular", "chi*Omega_b = A_b*sn", "chi*Omega_b = A_b*cn"),
    ("regular", "Omega_d = -chi*rho*epsilon*sigma*A_d*cn", "Omega_d = -chi*rho*sigma*A_d*cn"),
    ("regular", "D(dn) = -m*lambda_*sn*cn", "D(dn) = -m**2*lambda_*sn*cn"),
    ("regular", "A_a**2 = E_d/(c_a*(c_a - c_d))", "A_a**2 = E_d/(c_a*(c_a - c_b))"),
    # Landen's descent and the secular angle
    ("descended", "k_1 = m/(1 + k_c)**2", "k_1 = m**2/(1 + k_c)**2"),
    ("descended", "k_c**2 = 1 - m", "k_c**2 = 1 - m**2"),
    ("descended", "m_c = 4*k_c/(1 + k_c)**2", "m_c = 2*k_c/(1 + k_c)**2"),
    ("descended", "cn = d*c/(1 + k_1*s**2)", "dn = d*c/(1 + k_1*s**2)"),
    ("descended", "D(sn) = lambda_*cn*dn", "D(sn) = mu*cn*dn"),
    (
        "descended",
        "n = -k_1*(c_d*A_d)**2/(K + c_a*A_a)**2",
        "n = k_1*(c_d*A_d)**2/(K + c_a*A_a)**2",
    ),
    ("descended", "D(psi) = psi_rate", "D(psi) = -psi_rate"),
    ("descended", "D(u) = lambda_", "D(u_1) = lambda_"),
    (
        "descended",
        "kappa = 2*E_a*A_a*k_1/((K + c_a*A_a)**2*mu)",
        "kappa = E_a*A_a*k_1/((K + c_a*A_a)**2*mu)",
    ),
    # phi1 as an integral of the third kind
    (
        "third_kind",
        "D(phi1) = K*(2*H - c1*Omega1**2)/(K**2 - (c1*Omega1)**2)",
        "D(phi1) = K*(2*H + c1*Omega1**2)/(K**2 - (c1*Omega1)**2)",
    ),
    ("third_kind", "D(Pi)*(1 - n*sn**2) = xi", "D(Pi)*(1 - n*sn) = xi"),
    ("third_kind", "D(phi1) = K/c1 + kappa*D(Pi)", "D(phi1) = K/c1 - kappa*D(Pi)"),
    ("third_kind", "D(Omega1)**2 = (zeta*xi*cn*dn)**2", "D(Omega1)**2 = (zeta*xi*sn*dn)**2"),
    # the three angles
    (
        "three_angle_motion",
        "c1*D(Omega1) = (c2 - c3)*Omega2*Omega3",
        "c1*D(Omega1) = (c3 - c2)*Omega2*Omega3",
    ),
    (
        "three_angle_motion",
        "K**2 - (c1*Omega1)**2 = K**2*sin_phi2**2",
        "K**2 - (c1*Omega1)**2 = K**2*cos_phi2**2",
    ),
    (
        "three_angle_motion",
        "phi1_rate*K*sin_phi2**2 = c2*Omega2**2 + c3*Omega3**2",
        "phi1_rate*K*sin_phi2**2 = c3*Omega2**2 + c2*Omega3**2",
    ),
    (
        "three_angle_motion",
        "phi1_rate*sin_phi2 = Omega2*sin_phi3 + Omega3*cos_phi3",
        "phi1_rate*sin_phi2 = Omega2*cos_phi3 + Omega3*sin_phi3",
    ),
    # natural motions between two attitudes
    (
        "faster",
        "D(q1) = (q0*W1 + q2*W3 - q3*W2)/2",
        "D(q1) = (q0*Omega1 + q2*Omega3 - q3*Omega2)/2",
    ),
    ("faster", "c1*D(W1) = (c2 - c3)*W2*W3", "c1*D(W1) = s*(c2 - c3)*W2*W3"),
    ("faster", "W1*M1 + W2*M2 + W3*M3 = 2*s*H", "W1*M1 + W2*M2 + W3*M3 = 2*s**2*H"),
    ("manoeuvre", "A11 + A22 + A33 = 0", "A11 + A22 = 0"),
    ("manoeuvre", "N1**2 + N2**2 + N3**2 = K**2", "N1**2 + N2**2 - N3**2 = K**2"),
    ("manoeuvre", "R11*p1 + R12*p2 + R13*p3 = p1", "R11*p1 + R12*p2 + R13*p3 = p2"),
    ("arrival", "q1 = z0*p1 + z1*p0 + z2*p3 - z3*p2", "q1 = z0*p1 + z1*p0 - z2*p3 + z3*p2"),
    (
        "separatrix_planes",
        "E_b = c_b*(across*M_a - along*M_d)*(across*M_a + along*M_d)",
        "E_b = c_b*(along*M_a - across*M_d)*(along*M_a + across*M_d)",
    ),
    ("ring", "c1*W1 = R11*M1 + R21*M2 + R31*M3", "c1*W1 = R11*M1 + R21*M2 - R31*M3"),
]


@pytest.mark.parametrize(("context", "equation", "mutant"), MUTANTS, ids=[m[2] for m in MUTANTS])
def test_an_equation_is_proved_and_its_mutant_is_not(decide, context, equation, mutant):
    assert decide(context, equation).grade == "PROVED"
    with pytest.raises(KernelError, match="undecided"):
        decide(context, mutant)


def test_trying_equations_left_the_ledger_alone(ledger, decide):
    decide("body", "2*H = H + H")
    assert "attempt" not in ledger.facts


BANNED = {"simplify", "nsimplify", "trigsimp", "equals"}
# A step may put a value in a symbol's place before the kernel sees it; what decides may not.
DECIDING = {"kernel", "algebra"}
TRUSTED = [
    path
    for folder in (
        Path(derivations.__file__).parent,
        PACKAGE / "proof" / "kernel",
        PACKAGE / "proof" / "algebra",
        PACKAGE / "proof" / "steps",
    )
    for path in sorted(folder.glob("*.py"))
]


def test_all_that_proves_is_looked_at():
    assert {path.parent.name for path in TRUSTED} == {"derivations", "steps", *DECIDING}


@pytest.mark.parametrize("path", TRUSTED, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_no_heuristic_simplifier_is_named(path):
    nodes = list(ast.walk(ast.parse(path.read_text("utf-8"))))
    named = {node.attr for node in nodes if isinstance(node, ast.Attribute)}
    named |= {node.id for node in nodes if isinstance(node, ast.Name)}
    named |= {
        alias.name
        for node in nodes
        if isinstance(node, ast.ImportFrom | ast.Import)
        for alias in node.names
    }
    assert not named & (BANNED | ({"subs"} if path.parent.name in DECIDING else set()))
