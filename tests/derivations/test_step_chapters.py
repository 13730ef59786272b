"""The chapters of Landen's step, the addition form, the step and kicks find what they publish."""

from itertools import chain

import pytest

from derivations import addition_form, attitude, kicks, landen_step, publish, step_form
from derivations.setting import Setting
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.algebra._computation import Computed, Standing, standing

CONTEXTS = ("landen", "scaling", "doubling", "turn", "thirds", "second_half", "step", "kick")
# Landen's sn begins his step; the others are names of differences.
CHOSEN = {"landen.s", "step.c_ab", "step.c_ad", "step.c_bd"}
# A root repeats the relation of its context.
CHOSEN |= {"second_half.R", "step.K", "thirds.R"}


@pytest.fixture(scope="module")
def ledger():
    builder = LedgerBuilder()
    builder.keep(Setting())
    for chapter in (attitude, landen_step, addition_form, step_form, kicks):
        chapter.derive(builder)
    return builder.ledger


def test_published_formulas_are_computed(ledger):
    entries = [*chain(*publish.SEQUENCES.values())]
    facts = {str(entry["fact"]) for entry in entries if "fact" in entry}
    facts = {name for name in facts if name.split(".")[0] in CONTEXTS}
    typed = {name for name in facts if standing(ledger.facts[name]) != Standing.COMPUTED}
    defined = {
        (str(entry["context"]), str(entry["definition"]))
        for entry in entries
        if "definition" in entry and entry["context"] in CONTEXTS
    }
    for context, name in defined:
        if not isinstance(ledger.contexts[context].definitions[name], Computed):
            typed.add(f"{context}.{name}")
    assert typed == CHOSEN
    assert len(facts) + len(defined) > 80
