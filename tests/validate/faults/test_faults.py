"""Faults: each applies to one place, each is detected, and sound modules are not."""

import json
import pickle
import re
from collections import Counter
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from rigidsym import InputError, generate
from rigidsym._codegen.ir import Constant
from rigidsym._engines import STEPPERS
from rigidsym.language._expression import parse, to_text
from rigidsym.validate._bounds import bounds_of
from rigidsym.validate._implementations import missing
from rigidsym.validate._measure import measure
from rigidsym.validate._oracle import Reference
from rigidsym.validate._sensitivities import share
from rigidsym.validate.faults import KINDS, Fault, StaleFaultError, all_faults, by_hand, inject
from rigidsym.validate.faults._detection import (
    CRASHED,
    RAISED,
    Detection,
    broken,
    first,
    mutated_engine,
    on_files,
    references,
)
from rigidsym.validate.faults._drawn import EACH, HARMLESS, changes, drawn, every, is_lost
from rigidsym.validate.faults._fault import TARGETS
from rigidsym.validate.faults._printed import check, faulty, installed, sound
from rigidsym.validate.strata import STRATA

FAULTS = all_faults()
DIGITS, SEED = 30, 1
# Enough of the strata to notice every fault; a report takes them all.
STRATA_CHOSEN = {
    "branch switch": 15,
    "extreme scales": 9,
    "separatrix": 9,
    "near spin, middle": 9,
    "near spin, largest": 6,
    "needle": 9,
    "special attitudes": 9,
    "near separatrix, long": 9,
    "published": 12,
    "rest": 1,
    "sphere": 3,
    "near sphere": 8,
    "quarter periods": 6,
}


# And of faults in sensitivities, and in steps.
COLUMNS_CHOSEN = "published", "axis orders and signs", "uniform", "beside separatrix"
STEPS_CHOSEN = {
    "uniform": 2,
    "rod": 9,
    "scales": 9,
    "rest": 1,
    "special values": 4,
    "spin": 3,
    "needle": 3,
}
CHOSEN = {
    "states": STRATA_CHOSEN,
    "sensitivities": dict.fromkeys(COLUMNS_CHOSEN, 3),
    "steps": STEPS_CHOSEN,
    "torques": {"uniform": 1},
    "states in singles": STRATA_CHOSEN,
    "steps in singles": STEPS_CHOSEN,
}


@pytest.fixture(scope="module")
def chosen():
    """Return a function that encloses the numbers that show a kind of faults, once."""

    @cache
    def enclosed(shown_in):
        strata = CHOSEN[shown_in].items()
        return [references(name, cases, DIGITS, SEED, shown_in) for name, cases in strata]

    return enclosed


# The first fault of every kind for each target, of those by hand and of those that are drawn, but
# few of targets that share most; of those in sensitivities NumPy's, which are not compiled.
SHOWN = {
    ("numpy", "sensitivities"),
    *((target, "states") for target in ("numpy", "c", "numpy-pi")),
}
BY_HAND_SHOWN = {
    ("javascript", "states"),
    ("c-step", "torques"),
    ("c_single", "states in singles"),
    ("c_single-step", "steps in singles"),
}
QUICK = [
    f
    for f in FAULTS
    if (f.target, f.shown_in) in SHOWN or ((f.target, f.shown_in) in BY_HAND_SHOWN and not f.change)
]
SAMPLE = [
    *{(bool(f.change), f.target, f.kind, f.shown_in): f for f in reversed(QUICK)}.values(),
    *(f for f in by_hand() if (f.target, f.kind) == ("c-step", "scale")),
]


@pytest.fixture(autouse=True)
def can_run(request):
    """Skip a test of a target that this machine cannot run."""
    given = getattr(request.node, "callspec", None)
    target = given and (
        given.params.get("target") or getattr(given.params.get("fault"), "target", 0)
    )
    if target and (reason := missing([target])[target]):
        pytest.skip(reason)


def test_there_are_many_faults_of_every_kind():
    assert len({fault.line for fault in FAULTS}) == len(FAULTS) >= 50
    assert {fault.kind for fault in FAULTS} == set(KINDS)
    # Of others than the default, of what theirs alone is.
    least = {target: 6 if "-" in target else 50 for target in TARGETS}
    counts = Counter(fault.target for fault in FAULTS)
    assert all(counts[target] >= least[target] for target in TARGETS)
    changes = {(f.target, f.place, f.old, f.new, f.options) for f in FAULTS}
    assert len(changes) == len(FAULTS)


@pytest.mark.parametrize(
    "target",
    [pytest.param(t, marks=[pytest.mark.slow] * (t == "numpy-step")) for t in TARGETS],
)
def test_a_module_without_a_fault_is_noticed_by_no_stratum(target, chosen):
    engine, bounds = on_files(target, installed(target)), bounds_of(target)
    shown_in = sorted({fault.shown_in for fault in FAULTS if fault.target == target})
    strata = [stratum for kind in shown_in for stratum in chosen(kind)]
    assert [first(engine, stratum, bounds) for stratum in strata] == [None] * len(strata)


@pytest.mark.parametrize(
    "fault",
    [
        pytest.param(fault, marks=() if fault in SAMPLE else pytest.mark.slow, id=fault.line)
        for fault in FAULTS
    ],
)
def test_a_fault_is_noticed(fault, chosen):
    engine, bounds = mutated_engine(fault), bounds_of(fault.target)
    assert any(first(engine, stratum, bounds) for stratum in chosen(fault.shown_in))


@pytest.mark.parametrize("target", TARGETS)
def test_a_fault_drawn_changes_few_lines(target):
    text = without_digest(sound(target).files)
    for fault in (*drawn(target)[::12], *every(target)[:: len(every(target)) // 4]):
        changed = without_digest(faulty(fault))
        # Beside the line of the let: where a number was handed on that is not used any more.
        assert len({*text} ^ {*changed}) <= 10


def without_digest(files):
    """Return lines without the digest and the errors that were measured for it."""
    text = "\n".join(files.values())
    text = re.sub(
        r"Worst errors measured by.*?\n\n|Errors: not measured.*?\n\n", "", text, flags=re.DOTALL
    )
    return re.sub("[0-9a-f]{64}", "", text).splitlines()


def test_no_fault_is_stale():
    for fault in FAULTS:
        check(fault)


@pytest.mark.slow
def test_every_fault_by_hand_changes_something():
    for fault in by_hand():
        assert faulty(fault) != sound(fault.target).files


def test_what_is_drawn_is_of_every_kind_and_not_known_to_be_harmless():
    for target in TARGETS:
        of = [f for f in every(target) if f.change not in HARMLESS]
        kinds = {(fault.kind, fault.in_sensitivities) for fault in of}
        assert {(fault.kind, fault.in_sensitivities) for fault in drawn(target)} == kinds
        has_columns = target in ("numpy", "c")
        least = 12 if target in STEPPERS else 60 if has_columns else 30
        assert len(drawn(target)) >= (least if target.partition("-")[0] in EACH else 5)
        found = sum(fault.in_sensitivities for fault in drawn(target))
        assert (found >= 25) == has_columns
    known = {fault.change for target in TARGETS for fault in every(target)}
    assert HARMLESS.keys() <= known
    assert not {fault.change for fault in FAULTS} & HARMLESS.keys()


@pytest.fixture(scope="module")
def figures(chosen):
    """Return a function that measures a target without faults, once."""

    @cache
    def found(target, kind):
        return worst(on_files(target, installed(target)), chosen(kind))

    return found


def worst(engine, strata):
    """Return the largest error over its bound, by measure."""
    shares = [shares_of(reference, engine) for stratum in strata for reference in stratum]
    names = {name for found in shares for name in found}
    return {n: max(found[n] for found in shares if n in found) for n in names}


def shares_of(reference, engine):
    if isinstance(reference, Reference):
        return {n: np.max(found.share) for n, found in measure(reference, engine).items()}
    return {"columns": share(engine, reference)}


@pytest.mark.slow
@pytest.mark.parametrize(
    "fault",
    [
        pytest.param(fault, id=fault.line)
        for target in TARGETS
        for fault in every(target)
        if fault.change in HARMLESS
    ],
)
def test_what_is_called_harmless_takes_no_more_of_any_bound(fault, chosen, figures):
    found = worst(mutated_engine(fault), chosen(fault.shown_in))
    assert found == pytest.approx(figures(fault.target, fault.shown_in), abs=0.1)


def test_coefficients_are_as_good_as_others_far_below_rounding():
    sine, over = Constant("sine_3", 0.08, None, ""), Constant("over_17", 0.06, 0.0, "")
    assert is_lost(sine, replace(sine, hi=0.08 * (1 + 1e-12)))
    assert not is_lost(sine, replace(sine, hi=0.08 * (1 + 1e-10)))
    assert is_lost(over, replace(over, lo=1e-18))
    assert not is_lost(over, replace(over, lo=1e-12))
    # What is no coefficient may not be changed at all.
    other = Constant("log_2_short", 0.69, None, "")
    assert not is_lost(other, replace(other, hi=0.69 * (1 + 1e-15)))


def test_a_place_of_an_expression_is_changed_in_every_way():
    found = {
        to_text(change.expression): change.kind
        for change in changes(parse("choose(a, b, c/d, alternating(x) - 2*y)"))
    }
    assert found == {
        "choose(a, b, alternating(x) - 2 * y, c / d)": "branch",
        "choose(a, b, d / c, alternating(x) - 2 * y)": "scale",
        "choose(a, b, c / d, alternating(x) + 2 * y)": "sign",
        "choose(a, b, c / d, alternating(x))": "series",
        "choose(a, b, c / d, 1 - 2 * y)": "winding",
        "choose(a, b, c / d, alternating(x) - 2 * (2 * y))": "scale",
    }


FAULT = Fault("numpy", "constant", "a third is a half", "over_3", "0.3333333333333333", "0.5")


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"place": "over_2"}, "over_2 is no named number"),
        ({"old": "0.25"}, "'0.25' is 0 times in over_3, not once"),
        ({"old": "3333"}, "'3333' is 4 times in over_3, not once"),
        ({"place": "ladder.K9"}, "ladder.K9 is not assigned"),
        ({"place": "rungs.K0"}, "rungs.K0 is not assigned"),
        ({"place": "ladder.K0"}, "'0.3333333333333333' is 0 times in ladder.K0, not once"),
        ({"place": "motion.start"}, "motion.start is no routine"),
        ({"place": "def nothing("}, "'def nothing(' is 0 times in the module, not once"),
        (
            {"place": "def _fill("},
            "'0.3333333333333333' is 0 times in the paragraph of 'def _fill(', not once",
        ),
    ],
)
def test_a_stale_fault_says_so(changes, told):
    with pytest.raises(StaleFaultError) as caught:
        faulty(replace(FAULT, **changes))
    assert str(caught.value) == f"numpy: a third is a half: {told}"


def test_a_fault_that_no_line_shows_is_refused():
    # The runtime of NumPy has no grids.
    fault = replace(FAULT, place="motion.grid_angles", old=" + start", new="")
    with pytest.raises(ValueError, match="a third is a half: changes nothing in the module"):
        faulty(fault)


def test_a_fault_leaves_the_next_module_as_it_was():
    fault = next(f for f in by_hand() if f.place == "decisions.ordered" and f.target == "c")
    faulty(fault)
    assert generate("c").files == sound("c").files


def test_stale_faults_are_told_before_anything_is_measured():
    told = []
    stale = replace(FAULT, old="0.25")
    with pytest.raises(StaleFaultError):
        inject(["numpy"], 1, DIGITS, SEED, lambda *done: told.append(done), [stale])
    assert not told


@pytest.mark.parametrize(
    "changes",
    [
        {"target": "fortran"},
        {"kind": "no kind"},
        {"new": FAULT.old},
        {"place": "def _fill(", "new": "while True: pass"},
        {"place": "def _fill(", "old": "for k in range(3)"},
    ],
)
def test_faults_that_are_none_or_might_not_end_are_refused(changes):
    with pytest.raises(ValueError, match=r"^(numpy|fortran): a third is a half: must|no such"):
        replace(FAULT, **changes)


def test_an_unknown_target():
    with pytest.raises(InputError, match="target = fortran"):
        inject(["fortran"], 1, DIGITS, SEED)


SOME = [one for one in by_hand() if one.kind == "steady" and one.target in ("numpy", "c")]
# Exact decimals are in no batch with spheres, spins and bodies at rest.
FEW = ("sphere", "spin", "rest", "decimals")


def report(**changes):
    told = []
    options = {"targets": ("numpy", "c"), "faults": SOME, "strata": FEW} | changes
    drawn = {"cases": 2, "digits": DIGITS, "seed": SEED}
    return inject(**drawn, **options, progress=lambda *done: told.append(done)), told


@pytest.fixture(scope="module")
def reported(once):
    """Return a report and its progress, measured once for all processes of a run."""

    def measure(folder):
        (folder / "report").write_bytes(pickle.dumps(report()))

    return pickle.loads((once("fault_report", measure) / "report").read_bytes())


def test_the_report_is_deterministic_and_plain_data(reported):
    found, told = reported
    again, _ = report()
    assert found == again
    assert json.loads(json.dumps(found.to_data())) == again.to_data()
    assert found.to_markdown() == again.to_markdown()
    total = len(FEW) + len(SOME)
    assert told == [(k, total) for k in range(1, total + 1)]


def test_what_the_report_says(reported):
    found, _ = reported
    data = found.to_data()
    assert found.passed
    assert data["schema"] == "rigidsym.faults/2"
    assert list(data["strata"]) == list(FEW)
    assert data["strata"]["decimals"] == {"caught": 0, "alone": 0, "of": len(SOME)}
    assert found.caught("sphere") > 1
    text = found.to_markdown()
    assert f"{len(SOME)} of {len(SOME)} faults were caught." in text
    assert f"| sphere | {found.caught('sphere')} of {len(SOME)} |" in text
    assert all(f"| {fault.line} | steady | " in text for fault in SOME)


def part(found, strata=FEW, targets=TARGETS):
    """Return the part of a report on some strata and on faults of some targets."""
    outcomes = tuple(
        replace(one, detections=tuple(d for d in one.detections if d.stratum in strata))
        for one in found.outcomes
        if one.fault.target in targets
    )
    return replace(found, strata=strata, outcomes=outcomes)


def test_a_fault_that_is_missed_fails_the_report(reported):
    found = part(reported[0], strata=("decimals",))
    assert found.missed == tuple(SOME)
    assert not found.passed
    assert found.to_markdown().count("NOT CAUGHT") == len(SOME)


def test_no_faults_are_no_proof(reported):
    found = part(reported[0], targets=("c",))
    assert found.outcomes
    assert not found.missed
    assert not found.passed


def test_what_raises_is_noticed(chosen):
    class Engine:
        def prepare(self, *given):
            raise NameError

    assert all(
        broken(Engine(), strata[2][0]) == (RAISED,)
        for strata in map(chosen, ("states", "sensitivities"))
    )


def test_a_process_that_is_lost_is_noticed_where_it_was(reported):
    crash = Fault(
        "c",
        "special",
        "a crash at rest",
        "motion.steady_init",
        "motion.unit = 0.0",
        "motion.q0[16777216] = 0.0",
    )
    options = {"targets": ("c",), "strata": ("sphere", "rest")}
    others = [fault for fault in SOME if fault.target == "c"]
    found, told = report(faults=[crash, *others], **options)
    # The batch of the sphere has a body at rest in it, too.
    lost = tuple(Detection(name, 0, (CRASHED,)) for name in options["strata"])
    assert found.outcomes[0].detections == lost
    assert found.outcomes[1:] == part(reported[0], **options).outcomes
    assert told[-1] == (3 + len(others), 3 + len(others))


def test_the_strata_chosen_exist():
    assert {*STRATA_CHOSEN, *COLUMNS_CHOSEN} <= set(STRATA)
