"""Campaigns: one result however they are shared out, interrupted and resumed."""

import errno
import json
import math
import os
import signal
import tracemalloc
from dataclasses import replace
from fractions import Fraction
from multiprocessing import active_children

import pytest

from rigidsym import InputError
from rigidsym.io import _files as files
from rigidsym.io.cases import load_case
from rigidsym.validate import _executors as executors
from rigidsym.validate import _session as session
from rigidsym.validate import _validation as validation
from rigidsym.validate import validate
from rigidsym.validate._bounds import BOUNDS
from rigidsym.validate._campaign import NAME, Campaign, Progress, complete, tallied
from rigidsym.validate._finding import case_text, measure_case, read_case
from rigidsym.validate._tally import Tally
from rigidsym.validate._validation import run, simplest
from rigidsym.validate.strata import STRATA, count, draw
from rigidsym.validate.strata._sample import MAX_ANGLE

NAMES = ("sphere", "rest")
# Small pieces of work are interrupted as large ones are.
CHUNK = 10
CASES = 3 * CHUNK
CHOSEN = {"targets": ["c"], "cases": CASES, "strata": NAMES}


@pytest.fixture(autouse=True)
def _small_chunks(monkeypatch):
    monkeypatch.setattr("rigidsym.validate._campaign.CHUNK", CHUNK)


def small(directory=None):
    return Progress(Campaign.of(**CHOSEN), directory=directory)


@pytest.fixture(scope="module")
def expected():
    return validate(["c"], CASES, strata=NAMES).to_data()["implementations"]


def stopping_at(cases):
    def show(done, total):
        if done >= cases:
            raise KeyboardInterrupt

    return show


def test_an_interrupted_campaign_goes_on_to_the_same_report(tmp_path, expected):
    progress = small(tmp_path)
    with pytest.raises(KeyboardInterrupt, match=f"interrupted: {2 * CHUNK} of {2 * CASES} cases"):
        run(progress, executors.local(1), stopping_at(2 * CHUNK))
    found = session.begin({}, tmp_path, resume=True)
    assert found.campaign == small().campaign
    assert found == progress
    assert found.cases == 2 * CHUNK
    report = run(found, executors.local(1))
    assert report.to_data()["implementations"] == expected
    assert found.done == {name: [(0, CASES)] for name in NAMES}


@pytest.mark.parametrize("cells", [0, 1, 5])
def test_an_interrupt_while_a_chunk_is_taken_in_leaves_all_of_it_out(cells, monkeypatch):
    progress = small()
    progress.take(*tallied(progress.campaign, ("rest", 0, 2)))
    before = json.dumps([progress.tally.to_data(), progress.done])
    chunk, tally = tallied(progress.campaign, ("rest", 2, 4))
    put, left = Tally.put, iter(range(cells))

    def interrupted(*arguments):
        if next(left, None) is None:
            raise KeyboardInterrupt
        put(*arguments)

    monkeypatch.setattr(Tally, "put", interrupted)
    with pytest.raises(KeyboardInterrupt):
        progress.take(chunk, tally)
    assert json.dumps([progress.tally.to_data(), progress.done]) == before


def test_an_interrupt_while_the_report_is_made_loses_no_case(tmp_path, monkeypatch):
    """Interrupt a campaign while its worst cases are measured again."""

    def interrupted(*arguments):
        raise KeyboardInterrupt

    monkeypatch.setattr(validation, "reported", interrupted)
    progress = small(tmp_path)
    with pytest.raises(KeyboardInterrupt, match=f"{2 * CASES} of {2 * CASES} cases are kept"):
        run(progress, executors.local(1))
    assert Progress.load(tmp_path) == progress


def test_a_case_that_fails_in_both_modules_leaves_a_file_of_each(tmp_path, monkeypatch):
    monkeypatch.setitem(BOUNDS, "angle", 1e-18)
    session.write(validate(cases=1, strata=["uniform"]), tmp_path)
    files_written = sorted(path.parent.name for path in tmp_path.rglob("*.toml"))
    assert files_written == ["c", "numpy"]


def test_a_large_campaign_is_not_laid_out_in_memory():
    progress = Progress(Campaign.of(["c"], 5_000_000, strata=NAMES))
    tracemalloc.start()
    with executors.local(1) as place, pytest.raises(KeyboardInterrupt):
        complete(progress, place, lambda: stopping_at(1)(progress.cases, None))
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert progress.cases == CHUNK
    assert peak < 10**7


def test_what_is_missing_is_each_case_once_whatever_was_done():
    progress, tally = small(), Tally()
    for chunk in (("rest", 4, 6), ("rest", 12, 29), ("sphere", 0, 1), ("rest", 6, 7)):
        progress.take(chunk, tally)
    assert progress.done["rest"] == [(4, 7), (12, 29)]
    missing = list(progress.missing())
    listed = [(name, k) for name, start, stop in missing for k in range(start, stop)]
    done = {("rest", k) for k in [*range(4, 7), *range(12, 29)]} | {("sphere", 0)}
    assert sorted([*listed, *done]) == sorted((name, k) for name in NAMES for k in range(CASES))
    assert all(stop - start <= CHUNK for _, start, stop in missing)


def test_tallies_merge_in_any_order_and_come_back_from_json():
    chunks = [("sphere", 0, 7), ("rest", 3, 9), ("sphere", 7, 20)]
    parts = [tallied(small().campaign, chunk)[1] for chunk in chunks]
    there, back = Tally(), Tally()
    for part in parts:
        there.merge(part)
    for part in reversed(parts):
        back.merge(Tally.from_data(json.loads(json.dumps(part.to_data()))))
    assert there == back
    assert there.cases == {"sphere": 20, "rest": 6}


def test_a_tally_does_not_grow_with_its_cases():
    """Count cells: their number depends on strata, regimes and decades, not on cases."""
    few, many = (
        tallied(Campaign.of(**CHOSEN | {"cases": n}), ("sphere", 0, n))[1] for n in (20, 160)
    )
    assert len(many.cells) < 1.5 * len(few.cells)


def test_a_worker_that_dies_is_one_line_and_its_cases_are_not_counted(tmp_path):
    progress = Progress(Campaign.of(["c"], 2000, strata=NAMES), directory=tmp_path)

    def show(done, total):
        for child in active_children():
            os.kill(child.pid, signal.SIGKILL)

    with pytest.raises(InputError, match=r"one process: died.* cases are kept, --resume"):
        run(progress, executors.local(2), show)
    found = Progress.load(tmp_path)
    assert found == progress
    assert 0 < found.cases == sum(found.tally.cases.values()) < found.campaign.size


@pytest.mark.parametrize(
    ("chosen", "message"),
    [
        ({"cases": 7}, f"is another campaign: its cases {CASES}, not 7"),
        ({"seed": 7}, "its seed 1, not 7"),
        ({"targets": ["numpy"]}, "its targets c, not numpy"),
        ({"strata": ["rod"]}, "its strata sphere, rest, not rod"),
        ({"peers": ["dop853"]}, "its peers none, not dop853"),
    ],
)
def test_a_directory_of_another_campaign_is_refused(tmp_path, chosen, message):
    small(tmp_path).save()
    before = (tmp_path / NAME).read_bytes()
    with pytest.raises(InputError, match=message):
        session.begin(chosen, tmp_path, resume=True)
    assert session.begin({"cases": CASES}, tmp_path, resume=True) == small()
    with pytest.raises(InputError, match="holds an unfinished campaign: --resume goes on"):
        session.begin(chosen, tmp_path, resume=False)
    assert (tmp_path / NAME).read_bytes() == before


def test_a_campaign_of_other_modules_is_refused(tmp_path):
    other = replace(small().campaign, digests=("0" * 64,))
    Progress(other, directory=tmp_path).save()
    with pytest.raises(InputError, match="its digests 000000000000, not"):
        session.begin({}, tmp_path, resume=True)
    with pytest.raises(InputError, match=r"digests = .*: a worker has others than"):
        tallied(other, ("rest", 0, 1))


def test_nothing_to_resume(tmp_path):
    with pytest.raises(InputError, match="holds no unfinished campaign"):
        session.begin({}, tmp_path, resume=True)
    with pytest.raises(InputError, match="needs -o DIR"):
        session.begin({}, None, resume=True)


DAMAGED = "", "{", "[]", '{"schema": "rigidsym.campaign/0"}', "null"


@pytest.mark.parametrize(
    "change",
    [
        *(lambda text, other=other: other for other in DAMAGED),
        lambda text: text.replace('"done": {', '"done": {"rod": [[0, 9]], '),
        lambda text: text.replace(f'"cases": {CASES}', f'"cases": {CASES + 1}'),
        lambda text: text[: len(text) // 2],
        lambda text: text.replace("sha256", "sha"),
    ],
)
def test_a_damaged_or_edited_checkpoint_is_refused_in_one_line(tmp_path, change):
    progress = small(tmp_path)
    progress.take(*tallied(progress.campaign, ("rest", 0, 5)))
    progress.save()
    path = tmp_path / NAME
    text = change(path.read_text())
    assert text != path.read_text()
    path.write_text(text)
    with pytest.raises(InputError, match="is not what a campaign of this version left there"):
        session.begin({}, tmp_path, resume=True)


def test_errors_of_workers_arrive_as_they_are():
    other = replace(small().campaign, version="0")
    with pytest.raises(InputError, match=r"version = .*: a worker has others"):
        run(Progress(other), executors.local(2))


def test_interrupts_wait_for_undisturbed_work():
    # Where a shell starts a process in the background, it ignores them.
    known, done = signal.signal(signal.SIGINT, signal.default_int_handler), []
    try:
        with pytest.raises(KeyboardInterrupt), executors.undisturbed():
            done.append(signal.raise_signal(signal.SIGINT))
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, known)
    assert done == [None]


def test_a_full_disk_is_one_line_and_leaves_the_last_checkpoint(tmp_path, monkeypatch):
    progress = small(tmp_path)
    progress.save()
    before = (tmp_path / NAME).read_bytes()

    def full(*arguments):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(validation, "INTERVAL", 0.0)
    monkeypatch.setattr(files.os, "replace", full)
    with pytest.raises(InputError, match="cannot be written: No space left on device"):
        run(progress, executors.local(1))
    assert (tmp_path / NAME).read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == [NAME]


def test_the_simplest_case_that_fails():
    sample = draw("uniform", 3, 1)

    def fails(given):
        return given.omega0[1] != 0 and max(map(abs, given.times)) > 3 and given.inertia[0] > 0.3

    found = simplest(sample, fails)
    assert fails(found)
    assert len(found.times) == 1
    assert found.attitude0 == (1, 0, 0, 0)
    assert sum(x != 0 for x in found.omega0) == 1
    assert all(float(f"{x:.1g}") == x for x in (*found.omega0, *found.inertia, *found.times))


def test_a_case_is_not_made_simpler_by_what_modules_may_refuse():
    """Simplify a case whose times are too late for simpler rates: 1e-250 rad/s, 1e251 s."""
    sample = draw("scales", 1, 1)
    found = simplest(sample, lambda given: any(given.omega0) and max(map(abs, given.times)) > 1)
    assert max(map(abs, found.times)) * math.hypot(*found.omega0) <= MAX_ANGLE


def test_a_fraction_next_to_a_simple_number_becomes_that_number():
    plain = draw("uniform", 3, 1)
    near = replace(plain, inertia=(1 + Fraction(1, 10**250), 1.0, 1.0))
    assert simplest(near, lambda given: True).inertia == (1, 1, 1)
    for sample in (near, plain):
        assert simplest(sample, lambda given, sample=sample: given == sample) == sample


def test_a_failure_is_made_simpler_as_a_failure_of_the_same_measure(monkeypatch):
    """A body at rest breaks the bound on the angle here, and never that on rates."""
    monkeypatch.setitem(BOUNDS, "omega", 1e-19)
    monkeypatch.setitem(BOUNDS, "angle", 1e-18)
    report = validate(["numpy"], cases=1, strata=["uniform"])
    (failure,) = report.failures
    assert failure.measure == "omega"
    assert failure.simplest.shares("numpy")["omega"] > 1
    assert any(failure.simplest.sample.omega0)


@pytest.mark.parametrize("strata", [["rest"], ["rest", "sphere"]])
def test_figures_of_some_strata_are_not_recorded(strata):
    with pytest.raises(InputError, match=r"^record = .*: the heads speak of all strata"):
        session.record(validate(["numpy"], cases=1, strata=strata))


@pytest.mark.parametrize("stratum", ["uniform", "decimals", "extreme scales", "published"])
def test_case_files_are_read_back_as_the_same_numbers(tmp_path, stratum):
    sample = draw(stratum, 1, 1)
    path = tmp_path / "case.toml"
    path.write_text(case_text(sample, ["a remark"]))
    motion = load_case(path).motion
    numbers = (sample.inertia, sample.omega0, sample.attitude0)
    assert tuple(map(tuple, motion.exact.values())) == numbers
    found = read_case(str(path))
    assert replace(found, stratum=stratum, index=1) == sample
    assert session.replay(str(path), small().campaign).share("c") < 1


def test_a_case_of_a_campaign_is_found_by_its_name():
    campaign = small().campaign
    finding = session.replay("published:3", campaign)
    assert finding.sample == draw("published", 3, 1)
    assert finding.share("c") == measure_case(finding.sample, 40, ["c"]).share("c")
    for name in ("published", "moon:1", "published:999", "uniform:-1", "uniform:1e3"):
        with pytest.raises(InputError, match=r"^case = "):
            session.replay(name, campaign)
    assert count("published", 999) == STRATA["published"].size
