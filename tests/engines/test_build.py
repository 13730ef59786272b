"""The C library is built once, cached and checked; failures give one warning."""

import os
import re
import shutil
import stat
import subprocess
import sys
import warnings
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from engine_stub import stub

from rigidsym._engines import DEFAULT, build, engine, forget, resolved
from rigidsym._engines.c_engine import CEngine
from rigidsym._engines.library import LibraryError, load, written_digest
from rigidsym._engines.numpy_engine import NumpyEngine
from rigidsym.errors import InputError

SYSTEM = next(filter(None, map(shutil.which, build.NAMES)), None)
OF_THE_PACKAGE = build.package_sources
needs_compiler = pytest.mark.skipif(SYSTEM is None, reason="needs a C compiler: cc, gcc or clang")


@pytest.fixture(autouse=True)
def fresh(monkeypatch, tmp_path):
    """Start each test with an empty cache, small sources and no engine in C."""
    monkeypatch.setenv("RIGIDSYM_CACHE", str(tmp_path / "cache"))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(build, "package_sources", lambda _: stub("a"))
    forget()
    yield
    forget()


@pytest.fixture
def wrapped(monkeypatch, tmp_path):
    """Return a function that replaces the compiler by a script and returns its log.

    The script compiles without optimising: these tests are about who builds what, and when.
    """

    def wrap(before=""):
        log, script = tmp_path / "calls", tmp_path / "wrapped-cc"
        lines = [
            "#!/bin/sh",
            f'case "$*" in *-shared*) echo "$*" >> "{log}";; *) exec "{SYSTEM}" "$@";; esac',
            before,
            f'exec "{SYSTEM}" "$@" -O0',
        ]
        script.write_text("\n".join(lines) + "\n")
        script.chmod(stat.S_IRWXU)
        log.touch()
        monkeypatch.setenv("CC", str(script))
        return log

    return wrap


def calls(log):
    return log.read_text().splitlines()


def obtained():
    """Load the library as a new process does; return the warnings."""
    remarks = []
    build.library(remarks)
    return remarks


def kept():
    return sorted(build.cache_directory().glob("*.so"))


def heard(name="c"):
    """Return the engine of a name and the warnings of that call."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = engine(name)
    assert all(issubclass(warning.category, RuntimeWarning) for warning in caught)
    return found, [str(warning.message) for warning in caught]


@needs_compiler
def test_a_library_is_compiled_once(wrapped):
    log = wrapped()
    assert obtained() == obtained() == []
    assert len(calls(log)) == len(kept()) == 1


@needs_compiler
def test_what_determines_a_library_is_in_its_name(wrapped, monkeypatch):
    log = wrapped()
    obtained()
    for name, value in (
        ("package_sources", lambda _: stub("b")),
        ("processor", lambda: ["another"]),
        ("FLAGS", (*build.FLAGS, "-g")),
    ):
        monkeypatch.setattr(build, name, value)
        obtained()
    monkeypatch.setenv("CC", f"{SYSTEM} -g")
    obtained()
    assert len(kept()) == 5
    assert len(calls(log)) == 4


@needs_compiler
@pytest.mark.parametrize(
    "damage",
    [lambda data: data[:-100], lambda data: data[:2048], lambda _: b"no library", lambda _: b""],
    ids=["end lost", "most lost", "overwritten", "emptied"],
)
def test_a_damaged_library_is_built_again(wrapped, damage):
    log = wrapped()
    obtained()
    (path,) = kept()
    data = path.read_bytes()
    # As a new file: this process has the old one in its memory.
    path.unlink()
    path.write_bytes(damage(data))
    assert obtained() == [f"engine: {path} is damaged: it is built again"]
    assert [build.is_whole(path) for path in kept()] == [True]
    assert obtained() == []
    assert len(calls(log)) == 2


@needs_compiler
@pytest.mark.parametrize("mistake", ["sources", "text"])
def test_a_whole_file_that_is_the_wrong_one_is_built_again(tmp_path, mistake):
    obtained()
    (path,) = kept()
    key = path.stem.split("-")[1]
    path.unlink()
    other = tmp_path / "other"
    other.mkdir()
    if mistake == "sources":
        wrong = build.compile_library(build.find(), stub("b"), other)
    else:
        wrong = other / "text.so"
        wrong.write_text("no library")
    wrong = build._keep(key, wrong)
    (remark,) = obtained()
    assert remark.startswith(f"engine: {wrong} ")
    assert remark.endswith(": it is built again")
    assert "\n" not in remark
    assert ("was built from other sources" in remark) == (mistake == "sources")
    assert kept() == [path]


@needs_compiler
def test_a_cache_that_cannot_be_made_is_named(monkeypatch, tmp_path):
    (tmp_path / "file").touch()
    place = tmp_path / "file" / "cache"
    monkeypatch.setenv("RIGIDSYM_CACHE", str(place))
    found, remarks = heard()
    assert isinstance(found, CEngine)
    (remark,) = remarks
    assert remark.startswith(f"engine: cache {place} cannot be written: ")
    assert remark.endswith(": the library serves this process only")
    assert heard() == (found, [])


@needs_compiler
def test_a_cache_that_cannot_be_written_is_named():
    place = build.cache_directory()
    place.mkdir(mode=0o500)
    if os.access(place, os.W_OK):
        pytest.skip("this user may write anywhere")
    (remark,) = obtained()
    assert remark.startswith(f"engine: cache {place} cannot be written: ")


@needs_compiler
def test_a_home_that_does_not_exist_is_told(monkeypatch):
    def homeless():
        raise RuntimeError("no home")

    monkeypatch.delenv("RIGIDSYM_CACHE")
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(build.Path, "home", homeless)
    reason = "there is no home directory for a cache"
    assert obtained() == [f"engine: {reason}: the library serves this process only"]


# What a compiler does, and what a user is told of it; {CC} is the compiler's path.
BROKEN = {
    "errors": (
        'echo "note" >&2; echo "a.c:1: error: boom" >&2; echo "error: more" >&2; exit 1',
        "{CC} failed: a.c:1: error: boom",
    ),
    "no library": (
        'for last; do case "$last" in *.so) echo "no library" > "$last";; esac; done; exit 0',
        ".* cannot be loaded .*",
    ),
    "nothing": ("exit 0", "{CC} wrote no library"),
}


@needs_compiler
@pytest.mark.parametrize(("script", "reason"), BROKEN.values(), ids=BROKEN)
def test_a_compiler_that_fails_is_told_once(wrapped, script, reason):
    log = wrapped(script)
    found, (remark,) = heard()
    assert isinstance(found, NumpyEngine)
    reason = reason.replace("{CC}", re.escape(os.environ["CC"]))
    assert re.fullmatch(f"engine: {reason}: states are computed by NumPy", remark)
    assert heard()[1] == []
    assert len(calls(log)) == (2 if "error" in script else 1)
    assert kept() == []


@pytest.mark.parametrize(
    ("variables", "reason"),
    [
        ({"PATH": ""}, r"no C compiler found \(cc, gcc, clang\)"),
        ({"CC": "no-such-compiler -O1"}, r"no C compiler found \(CC=no-such-compiler\)"),
        ({"CC": "{place}/no-programme"}, "{place}/no-programme cannot be run: .*"),
    ],
)
def test_without_a_compiler_numpy_serves_and_says_so_once(monkeypatch, tmp_path, variables, reason):
    script = tmp_path / "no-programme"
    script.write_text("#!/no/such/interpreter\n")
    script.chmod(stat.S_IRWXU)
    for name, value in variables.items():
        monkeypatch.setenv(name, value.format(place=tmp_path))
    expected = reason.format(place=re.escape(str(tmp_path)))
    found, (remark,) = heard()
    assert isinstance(found, NumpyEngine)
    assert re.fullmatch(f"engine: {expected}: states are computed by NumPy", remark)
    again, remarks = heard()
    assert isinstance(again, NumpyEngine)
    assert remarks == []


def test_by_default_a_missing_compiler_is_no_problem_and_a_failing_one_is(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", "")
    found, remarks = heard(DEFAULT)
    assert isinstance(found, NumpyEngine)
    assert remarks == []
    assert resolved(DEFAULT) == "numpy"
    # Who asks for C is told, and once.
    assert [len(heard("c")[1]) for _ in range(2)] == [1, 0]
    forget()
    script = tmp_path / "failing"
    script.write_text("#!/bin/sh\nexit 1\n")
    script.chmod(stat.S_IRWXU)
    monkeypatch.setenv("CC", str(script))
    assert [len(heard(name)[1]) for name in (DEFAULT, DEFAULT, "c")] == [1, 0, 0]


@needs_compiler
def test_the_default_is_c_where_a_compiler_is(wrapped):
    log = wrapped()
    assert heard(DEFAULT) == heard("c")
    assert isinstance(heard(DEFAULT)[0], CEngine)
    assert len(calls(log)) == 1


@needs_compiler
def test_a_compiler_that_does_not_know_this_machine_is_asked_without(wrapped):
    log = wrapped('case "$*" in *-march=native*) echo "error: unknown" >&2; exit 1;; esac')
    assert obtained() == obtained() == []
    first, second = calls(log)
    assert "-march=native" in first
    assert "-march=native" not in second


def test_the_package_has_the_sources_and_their_digest():
    sources = OF_THE_PACKAGE()
    assert set(sources) == set(build.FILES["c"])
    assert written_digest(sources)


def test_threads_that_ask_at_once_hear_one_warning(monkeypatch):
    said = []
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(warnings, "warn", lambda remark, *_, **__: said.append(remark))
    with ThreadPoolExecutor(8) as pool:
        engines = list(pool.map(engine, ["c"] * 32))
    assert len(said) == 1
    assert {type(found) for found in engines} == {NumpyEngine}


SCRIPT = """
from rigidsym._engines import engine
c = engine("c")
q, omega = c.states(c.prepare((1.0, 2.0, 2.5), (0.3, -0.2, 0.9), (1.0, 0.0, 0.0, 0.0)), 0.5)
print(type(c).__name__, *map(float.hex, map(float, [*q, *omega])))
"""


def started(tmp_path):
    paths = os.pathsep.join(filter(None, [str(Path(build.__file__).parents[2]), *sys.path]))
    variables = {"PYTHONPATH": paths, "TMPDIR": str(tmp_path)}
    return subprocess.Popen(
        [sys.executable, "-W", "error", "-c", SCRIPT],
        env=os.environ | variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@needs_compiler
def test_processes_that_build_at_once_all_succeed(tmp_path, wrapped):
    log = wrapped()
    processes = [started(tmp_path) for _ in range(4)]
    answers = [process.communicate() for process in processes]
    assert [error for _, error in answers] == [""] * 4
    (answer,) = {answer for answer, _ in answers}
    assert answer.startswith("CEngine ")
    assert 1 <= len(calls(log)) <= 4
    assert all(map(build.is_whole, kept()))
    compiled = len(calls(log))
    assert started(tmp_path).communicate() == (answer, "")
    assert len(calls(log)) == compiled


@needs_compiler
def test_an_interrupted_build_leaves_nothing_that_is_taken_for_a_library(tmp_path, wrapped):
    bomb = tmp_path / "bomb"
    log = wrapped(f'if [ -e "{bomb}" ]; then rm "{bomb}"; kill -9 $PPID; fi')
    bomb.touch()
    interrupted = started(tmp_path)
    interrupted.communicate()
    assert interrupted.returncode == -9
    assert kept() == []
    answer, error = started(tmp_path).communicate()
    assert (answer.split()[0], error) == ("CEngine", "")
    assert len(calls(log)) == 2


@needs_compiler
def test_a_library_that_lacks_a_function_is_refused(tmp_path):
    sources = stub("a")
    text = sources["torque_free.c"].replace("torque_free_propagate", "torque_free_other")
    path = build.compile_library(build.find(), sources | {"torque_free.c": text}, tmp_path)
    with pytest.raises(LibraryError, match="torque_free_propagate"):
        load(path, sources)


@needs_compiler
def test_a_build_that_refuses_every_motion_is_not_used(monkeypatch):
    sources = stub("b")
    sources["torque_free.c"] = sources["torque_free.c"].replace("attitude0 ? 2", "attitude0 ? 8")
    monkeypatch.setattr(build, "package_sources", lambda _: sources)
    with pytest.raises(LibraryError, match=r"^the C module refuses: inertia: refused$"):
        build.library([])


@needs_compiler
@pytest.mark.parametrize(
    ("engine", "more", "error", "rule"),
    [
        ("c", "", (LibraryError, build.CompilerError), "reorder"),
        ("c-step", " -U__ASSOCIATIVE_MATH__", LibraryError,
         "^the C module refuses: arithmetic: sums are reordered"),
    ],
)  # fmt: skip
def test_options_that_reorder_sums_are_told(monkeypatch, engine, more, error, rule):
    """The module of steps also detects what no macro reveals."""
    options = f"-fassociative-math -fno-signed-zeros -fno-trapping-math{more}"
    monkeypatch.setenv("CC", f"{SYSTEM} {options}")
    monkeypatch.setattr(build, "package_sources", OF_THE_PACKAGE)
    with pytest.raises(error, match=rule):
        build.library([], engine)


def test_a_digest_need_not_be_written():
    assert written_digest({"torque_free.c": "int x;"}) is None
    assert written_digest(stub("b")) == "b" * 64


@pytest.mark.parametrize(
    ("variables", "place"),
    [
        ({"RIGIDSYM_CACHE": "/own", "XDG_CACHE_HOME": "/xdg"}, "/own"),
        ({"XDG_CACHE_HOME": "/xdg"}, "/xdg/rigidsym"),
        # The specification has relative paths ignored.
        ({"XDG_CACHE_HOME": "xdg", "HOME": "/home/me"}, "/home/me/.cache/rigidsym"),
        ({"RIGIDSYM_CACHE": "", "HOME": "/home/me"}, "/home/me/.cache/rigidsym"),
    ],
)
def test_the_place_of_the_cache(monkeypatch, variables, place):
    monkeypatch.setattr(sys, "platform", "linux")
    for name in ("RIGIDSYM_CACHE", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert build.cache_directory() == Path(place)


def test_an_unknown_engine_is_refused():
    with pytest.raises(
        InputError,
        match=r"^engine = 'fortran': must be one of: auto, numpy, c, numpy-pi, c-pi, javascript, ",
    ):
        engine("fortran")
