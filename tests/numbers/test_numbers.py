"""Published formulas against the equations of motion: what is wrong in numbers is refused."""

import json

import pytest
from ledgers import CONTEXTS, LEDGER, OUTSIDE, TEXT, doubled_meanings, forger, hollow, written

from rigidsym._numbers import check_numbers
from rigidsym._numbers._motions import motions
from rigidsym.errors import LedgerError


def refused(ledger):
    """Return why numbers refuse a ledger that nothing else has checked."""
    with pytest.raises(LedgerError) as refusal:
        check_numbers(ledger if isinstance(ledger, str) else written(ledger))
    return str(refusal.value)


def test_the_sealed_ledger_agrees():
    count, formulas = check_numbers(TEXT)
    published = LEDGER["published"]
    sequences = [*published["sequences"].values(), *published["forms"].values()]
    assert (count, formulas) == (len([*motions(TEXT)]), sum(map(len, sequences)))


def test_motions_are_of_every_kind_and_of_both_handednesses():
    drawn = [*motions(TEXT)]
    for kind in ("rest", "spherical", "separatrix_motion", "largest", "smallest"):
        assert sum(motion.kind == kind for motion in drawn) >= 3
    for sign in ("epsilon", "sigma", "chi"):
        assert {motion.signs[sign] for motion in drawn if motion.moves} == {-1, 1}
    assert {motion.axes[0] for motion in drawn if motion.kind == "largest"} == {0, 1, 2}
    assert [*map(str, motions(TEXT))] == [*map(str, drawn)]
    assert [*map(str, motions(TEXT + " "))] != [*map(str, drawn)]


@pytest.mark.parametrize("name", OUTSIDE)
def test_what_changes_together_is_refused(name):
    """Refuse the ledgers of the outside attack, which kernel and theorems accept."""
    assert refused(forger().forge(OUTSIDE[name])).startswith("ledger: sequence ")


def test_hollow_formulas_are_refused():
    assert refused(hollow()).startswith("ledger: sequence ")


@pytest.mark.parametrize("name", doubled_meanings())
def test_a_doubled_meaning_is_refused(name):
    assert refused(doubled_meanings()[name]).startswith("ledger: ")


@pytest.mark.parametrize(
    ("context", "name", "changed", "sequence"),
    [
        ("descended", "psi", "psi_0*t + kappa*(J - J_0) + 1", "state"),
        ("descended", "u_1", "mu*t + phase + 1", "state"),
        ("theta_form", "Lambda", "psi_0/2 - rho*mu*zeta", "theta_state"),
        ("attitude", "s_b", "-sigma*epsilon*M_d/nu", "state"),
        ("steady", "theta", "omega*t + 1", "steady"),
        ("period", "period", "8*K_1/mu", "periods"),
        ("period", "period", "12*K_1/mu", "periods"),
        ("theorem1_motion", "phi1", "K/c1*t + kappa*Pi + 1", "theorem1_state"),
        ("step", "psi_0", "(2*H_0 - K*sigma*Omega_a0)/(K + sigma*M_a0)", "thirds"),
        ("elapsed_E", "E_t", "(t - S_t*C_t/D_t - (p - r)*F_t)/p + 1", "elapsed_E"),
    ],
)
def test_wrong_starts_and_signs_are_refused(context, name, changed, sequence):
    definitions = {**CONTEXTS[context]["definitions"], name: changed}
    told = refused(with_context(context, definitions=definitions))
    assert told.startswith(f"ledger: sequence {sequence}: ")


@pytest.mark.parametrize("sequence", ["constants", "state", "kick", "turn"])
def test_a_sequence_has_to_be_published(sequence):
    ledger = json.loads(TEXT)
    group = "forms" if sequence in ledger["published"]["forms"] else "sequences"
    del ledger["published"][group][sequence]
    assert sequence in refused(ledger)


@pytest.mark.parametrize("sequence", ["constants", "state", "theta", "step", "kick", "turn"])
def test_an_output_has_to_be_published(sequence):
    for place in (0, -1):
        ledger = json.loads(TEXT)
        del ledger["published"]["sequences"][sequence][place]
        assert refused(ledger).startswith("ledger: ")


def test_an_output_without_a_comparison_is_refused():
    ledger = json.loads(TEXT)
    entry = {"context": "kick", "definition": "w1", "source": ["3"]}
    ledger["published"]["sequences"]["more"] = [entry]
    assert refused(ledger) == "ledger: sequence more: w1 is compared with nothing"


def with_context(name, **fields):
    """Return the sealed ledger with some fields of a context replaced."""
    ledger = {**LEDGER, "contexts": [*LEDGER["contexts"]]}
    ledger["contexts"][ledger["contexts"].index(CONTEXTS[name])] = {**CONTEXTS[name], **fields}
    return ledger


@pytest.mark.parametrize("name", ["theta_functions", "hyperbolic_functions", "theta_form"])
@pytest.mark.parametrize("relation", ["K - 2*B_a", "rho - sigma - 1", "R**2 - 2*T4_re**2"])
def test_contradictory_relations_are_refused(name, relation):
    """Refuse a context that no motion is in, though its witness may be."""
    relations = [*CONTEXTS[name]["relations"], relation]
    told = refused(with_context(name, relations=relations))
    assert told.startswith(f"ledger: context {name}: {relation} = 0 does not hold, for largest 1:")


def test_functions_are_what_they_are_declared_to_be():
    for name in ("v_s", "b_n", "N_re"):
        thetas = CONTEXTS["theta_functions"]["thetas"]
        changed = {**thetas, name: thetas[name].replace("(theta", "(dtheta")}
        assert "does not hold" in refused(with_context("theta_functions", thetas=changed))


@pytest.mark.parametrize(
    ("name", "changed", "told"),
    [
        ("theta_form", {"T4_re": "T4_im"}, "T4_re' = T4_im is not its derivative"),
        ("descended", {"J": "mu*s**2"}, "J' = mu*s**2 is not its derivative"),
        ("hyperbolic_functions", {"v_s": "-mu*g*dv_s"}, "v_s' = -mu*g*dv_s is not its derivative"),
    ],
)
def test_wrong_rates_are_refused(name, changed, told):
    rates = {**CONTEXTS[name]["rates"], **changed}
    assert told in refused(with_context(name, rates=rates))


def test_conditions_hold_somewhere():
    units = [*CONTEXTS["descended"]["units"], "A_a - A_a"]
    assert "A_a - A_a may be zero" in refused(with_context("descended", units=units))
    signs = [*CONTEXTS["theta_form"]["nonnegative"], "-K"]
    assert "-K is negative" in refused(with_context("theta_form", nonnegative=signs))


@pytest.mark.parametrize("text", ["{}", "[]", "x", '{"contexts": [], "facts": 1, "published": {}}'])
def test_what_is_no_ledger_is_refused_in_a_line(text):
    assert refused(text) == "ledger: its contexts and sequences are not readable"
