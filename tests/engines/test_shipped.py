"""Libraries that come with the package are used first, and need no compiler."""

import shutil
import sys

import pytest
from engine_stub import stub

from rigidsym._engines import DEFAULT, build, engine, forget, shipped, stepper
from rigidsym._engines.c_engine import CEngine
from rigidsym._engines.library import LibraryError
from rigidsym._engines.numpy_engine import NumpyEngine

PROCESSOR = (build.Path(shipped.__file__).parent / "processor.c").read_text("utf-8")
pytestmark = pytest.mark.skipif(
    sys.platform != "linux" or not any(map(shutil.which, build.NAMES)),
    reason="needs Linux and a C compiler: cc, gcc or clang",
)


@pytest.fixture
def folder(monkeypatch, tmp_path):
    """Ship stubs for every code path; then there is no compiler."""
    monkeypatch.setenv("RIGIDSYM_CACHE", str(tmp_path / "cache"))
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(build, "package_sources", lambda _: stub("a"))
    monkeypatch.setattr(shipped, "FOLDER", tmp_path / "shipped")
    shipped.FOLDER.mkdir()
    ship("a", *shipped.PATHS.values(), shipped.PORTABLE)
    monkeypatch.setenv("PATH", "")
    shipped.code_path.cache_clear()
    forget()
    yield shipped.FOLDER
    shipped.code_path.cache_clear()
    forget()


def ship(digit, *names):
    work = shipped.FOLDER.parent / f"work-{digit}"
    work.mkdir()
    flags = ("-O0", "-fPIC", "-shared", "-std=gnu99")
    sources = stub(digit) | {"processor.c": PROCESSOR}
    made = build.compile_library(build.find(), sources, work, flags)
    for name in names:
        shutil.copy(made, shipped.FOLDER / f"{name}.so")


def features():
    """Return the flags of this processor, as Linux names them."""
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        lines = (line.partition(":") for line in file)
        return next((set(x.split()) for name, _, x in lines if name.strip() == "flags"), set())


def test_the_code_path_is_the_best_that_the_processor_has(folder):
    found, has = shipped.code_path(), features()
    if "sse2" not in has:
        assert found == "arm64"
        return
    v3 = has >= {"avx2", "bmi1", "bmi2", "f16c", "fma", "abm", "movbe", "xsave"}
    v4 = v3 and has >= {"avx512f", "avx512bw", "avx512cd", "avx512dq", "avx512vl"}
    assert found == ("x86-64-v4" if v4 else "x86-64-v3" if v3 else "x86-64")


@pytest.mark.parametrize(("name", "file"), [("c", ""), ("c-portable", "portable")])
@pytest.mark.filterwarnings("error")
def test_no_compiler_is_needed_and_nothing_is_built(folder, name, file):
    assert isinstance(engine(name), CEngine)
    assert isinstance(engine(DEFAULT), CEngine)
    found = build.library([], name)
    assert found.path == folder / f"{file or shipped.code_path()}.so"
    assert not build.cache_directory().exists()


@pytest.mark.parametrize("fault", ["other sources", "no library", "missing", "no processor"])
def test_a_library_that_is_not_right_is_told_and_a_compiler_sought(folder, fault, monkeypatch):
    # Not loaded before: a process keeps what it has loaded by a name.
    path = folder / ("portable.so" if fault == "no processor" else f"{shipped.code_path()}.so")
    said = "cannot be loaded"
    if fault == "other sources":
        monkeypatch.setattr(build, "package_sources", lambda _: stub("b"))
        said = "was built from other sources"
    else:
        path.unlink()
        if fault != "missing":
            path.write_text("no library")
    remarks = []
    with pytest.raises(LibraryError, match=said):
        build.library(remarks)
    assert remarks == []
    with pytest.warns(RuntimeWarning, match=f"{said}.*: states are computed by NumPy"):
        assert isinstance(engine(DEFAULT), NumpyEngine)
    # With a compiler, the library is built instead.
    monkeypatch.setattr(build, "find", lambda: build.Compiler(("cc",), ""))
    monkeypatch.setattr(build, "_cached", lambda *_: "built")
    monkeypatch.setattr(build, "check_arithmetic", lambda _: None)
    assert build.library(remarks) == "built"
    (remark,) = remarks
    assert remark.startswith(f"engine: {path} {said}")
    assert remark.endswith(": it is compiled")


def test_modules_that_are_not_shipped_are_compiled(folder):
    assert shipped.library("c_single", stub("a")) is None
    (folder / "portable.so").unlink()
    shipped.code_path.cache_clear()
    assert shipped.library("c", stub("a")) is None


def test_a_library_without_steps_is_refused(folder):
    header = {"torque_free_step.h": "int torque_free_step(int x);\n"}
    with pytest.raises(LibraryError, match="cannot be loaded"):
        shipped.library("c-step", header)
    assert stepper("numpy")
