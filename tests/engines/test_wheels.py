"""Wheels bring the engine, compiled for their platform, with the same bytes each time."""

import os
import re
import shutil
import struct
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from engine_stub import stub

import rigidsym.generated
from rigidsym._engines import build, shipped, wheels
from rigidsym._engines.c_engine import CEngine
from rigidsym._engines.library import load
from rigidsym.validate import _same_bits

GENERATED = Path(rigidsym.generated.__file__).parent
BITS = wheels.ROOT / "tests" / "codegen" / "c" / "bits.c"
MOTIONS = (Path(_same_bits.__file__).parent / "same_bits" / "motions.txt").read_bytes()
EXPECTED = list(_same_bits.expected().values())
HERE = "manylinux-x86-64"
# What the headers of libraries begin with.
MAGIC = {".so": b"\x7fELF", ".dylib": struct.pack("<I", 0xFEEDFACF), ".dll": b"MZ"}
RUN = """
import warnings
warnings.simplefilter("error")
import rigidsym
from rigidsym._cli.doctor import examined
from rigidsym.validate import _same_bits
motion = rigidsym.TorqueFreeMotion((1, 2, 2.5), (0.3, 0.5, -0.7), engine="c")
print(motion(1.0)[0].shape, rigidsym.__file__)
print(examined()["engine"]["why"])
print(_same_bits.differences(("rest", "uniform")))
"""


def zig(*arguments):
    line = [sys.executable, "-m", wheels.COMPILER, "cc", *map(str, arguments)]
    subprocess.run(line, check=True, capture_output=True)


def test_zig_compiles_what_is_shipped(monkeypatch, tmp_path):
    pytest.importorskip(wheels.COMPILER)
    monkeypatch.setattr(build, "package_sources", lambda _: stub("a"))
    platform = wheels.PLATFORMS[HERE]
    few = replace(platform, paths={"x86-64-v3": platform.paths["x86-64-v3"]})
    found = wheels.compiled(few, tmp_path)
    assert [path.name for path in found] == ["x86-64-v3.so", "portable.so"]
    assert all(path.read_bytes().startswith(MAGIC[".so"]) for path in found)
    if wheels.sys.platform == "linux" and os.uname().machine == "x86_64":
        assert isinstance(CEngine(load(found[0], stub("a"))), CEngine)


def test_each_platform_has_the_code_paths_of_its_processors():
    x86, arm = {"x86-64", "x86-64-v3", "x86-64-v4"}, {"arm64"}
    for name, platform in wheels.PLATFORMS.items():
        assert {*platform.paths} == (arm if "arm" in name else x86)
    assert {*shipped.PATHS.values()} == x86 | arm


def test_the_recipe_for_conda_needs_what_the_package_needs():
    text = (wheels.ROOT / ".ci" / "conda" / "recipe.yaml").read_text("utf-8")
    listed = re.findall(r"^    - ([\w-]+) (\S+)$", text.partition("  run:")[2], re.MULTILINE)
    project = tomllib.loads((wheels.ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    needed = {tuple(re.match(r"([\w-]+)(.*)", x).groups()) for x in project["dependencies"]}
    # conda-forge's matplotlib brings Qt, which nothing here uses.
    plain = {(name.removesuffix("-base"), version) for name, version in listed}
    assert plain == needed | {("python", project["requires-python"])}
    tags = [platform.tag for name, platform in wheels.PLATFORMS.items() if "musl" not in name]
    assert all(f"-py3-none-{tag}.whl" in text for tag in tags)


def test_unknown_platforms_are_refused(monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["wheels", "amiga"])
    with pytest.raises(SystemExit) as stopped:
        wheels.main()
    assert stopped.value.code == 2
    assert "PLATFORM = amiga: must be one of: manylinux-x86-64" in capsys.readouterr().err


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """Return a function that builds a wheel, once each, and its contents unpacked."""
    for package in (wheels.COMPILER, "hatchling"):
        pytest.importorskip(package)
    made = {}

    def build_one(name):
        if name not in made:
            folder = tmp_path_factory.mktemp(name)
            made[name] = wheel(name, folder), folder / "unpacked"
            zipfile.ZipFile(made[name][0]).extractall(made[name][1])
        return made[name]

    return build_one


def wheel(name, folder):
    line = [sys.executable, "-m", "rigidsym._engines.wheels", name, "-o", folder]
    subprocess.run(line, check=True, capture_output=True)
    (found,) = folder.glob("*.whl")
    return found


@pytest.mark.slow
@pytest.mark.parametrize("name", wheels.PLATFORMS)
def test_a_wheel_has_its_tag_and_libraries(built, name):
    platform = wheels.PLATFORMS[name]
    path, unpacked = built(name)
    assert path.name.endswith(f"-py3-none-{platform.tag}.whl")
    folder = unpacked / "rigidsym" / "_engines" / "shipped"
    found = {x.stem: x.read_bytes() for x in folder.iterdir()}
    assert {*found} == {*platform.paths, shipped.PORTABLE}
    for data in found.values():
        assert data.startswith(MAGIC[platform.end])
        # The names of all functions of the headers, and no path of this machine.
        for module in shipped.MODULES:
            header = next(x for x in build.FILES[module] if x.endswith(".h"))
            names = re.findall(r"^[a-z_].*?\b(torque_free\w+)\(", (GENERATED / header).read_text())
            assert names or module
            assert all(one.encode() in data for one in names)
        assert b"torque_free_processor_level" in data
        assert str(Path.home()).encode() not in data


@pytest.mark.slow
def test_a_wheel_is_the_same_each_time(built, tmp_path):
    assert built(HERE)[0].read_bytes() == wheel(HERE, tmp_path).read_bytes()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="the wheel is for Linux")
def test_a_wheel_computes_without_a_compiler(built, tmp_path):
    """Its C has the bits that are promised; another package by its name is not imported."""
    unpacked = built(HERE)[1]
    variables = {"PATH": str(tmp_path), "HOME": str(tmp_path), "PYTHONPATH": str(unpacked)}
    line = [sys.executable, "-c", RUN]
    done = subprocess.run(line, cwd=tmp_path, env=variables, capture_output=True, text=True)
    assert done.stderr == ""
    assert done.stdout.splitlines() == [
        f"(4,) {unpacked / 'rigidsym' / '__init__.py'}",
        "the package brings its library; no compiler is needed",
        "()",
    ]
    assert [*tmp_path.iterdir()] == []


@pytest.mark.slow
def test_the_library_for_arm_has_the_same_bits(built, tmp_path):
    """qemu runs it with Debian's C library for that processor (libc6-arm64-cross)."""
    root = Path("/usr/aarch64-linux-gnu")
    if not shutil.which("qemu-aarch64") or not root.is_dir():
        pytest.skip("needs qemu-aarch64 and libc6-arm64-cross")
    name = "manylinux-arm64"
    library = built(name)[1] / "rigidsym" / "_engines" / "shipped" / "portable.so"
    target = wheels.PLATFORMS[name].target
    zig("-target", target, "-I", GENERATED, BITS, library, "-o", tmp_path / "bits")
    line = ["qemu-aarch64", "-L", root, "-E", f"LD_LIBRARY_PATH={library.parent}", "./bits"]
    done = subprocess.run(line, cwd=tmp_path, input=MOTIONS, capture_output=True, check=True)
    assert done.stdout.decode().splitlines() == EXPECTED


@pytest.mark.slow
def test_the_library_for_windows_has_the_same_bits(built, tmp_path):
    """Wine runs it; the program asks for the library by the name that it was linked with."""
    if not shutil.which("wine"):
        pytest.skip("needs wine")
    name = "windows-x86-64"
    folder = built(name)[1] / "rigidsym" / "_engines" / "shipped"
    target = wheels.PLATFORMS[name].target
    program = tmp_path / "bits.exe"
    zig("-target", target, "-O1", "-I", GENERATED, BITS, folder / "portable.dll", "-o", program)
    shutil.copy(folder / "portable.dll", tmp_path / "torque_free.so")
    variables = {**os.environ, "WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all"}
    line = ["wine", program]
    done = subprocess.run(line, input=MOTIONS, capture_output=True, check=True, env=variables)
    assert done.stdout.decode().splitlines() == EXPECTED


@pytest.mark.slow
def test_the_source_distribution_installs_without_zig(tmp_path):
    """It makes a wheel of pure Python, which compiles at its first use."""
    pytest.importorskip("hatchling")
    line = [sys.executable, "-m", "hatchling", "build", "-d", str(tmp_path)]
    subprocess.run([*line, "-t", "sdist"], cwd=wheels.ROOT, check=True, capture_output=True)
    (path,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(path) as file:
        file.extractall(tmp_path, filter="data")
    (source,) = (x for x in tmp_path.iterdir() if x.is_dir())
    variables = {key: x for key, x in os.environ.items() if key != wheels.VARIABLE}
    subprocess.run(
        [*line, "-t", "wheel"], cwd=source, check=True, capture_output=True, env=variables
    )
    (wheel,) = tmp_path.glob("*-py3-none-any.whl")
    names = zipfile.ZipFile(wheel).namelist()
    assert "rigidsym/_engines/processor.c" in names
    assert not [name for name in names if "/shipped/" in name]
