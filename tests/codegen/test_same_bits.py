"""-DTORQUE_FREE_FMA=0 gives the same bits with every compiler, option and processor, or refuses."""

import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest
from compilers import SOURCES, X86

import rigidsym.generated

GENERATED = Path(rigidsym.generated.__file__).parent
PROGRAM = (SOURCES / "bits.c", GENERATED / "torque_free.c", GENERATED / "torque_free_step.c")
WITHOUT, WITH = "-DTORQUE_FREE_FMA=0", "-DTORQUE_FREE_FMA=1"
# Debian's cross-compilers, and the processors that qemu emulates for them: of 32 and 64 bits,
# of either byte order, with fused multiply-add and without.
FOREIGN = {
    "aarch64-linux-gnu": "aarch64",
    "arm-linux-gnueabihf": "arm",
    "mips64el-linux-gnuabi64": "mips64el",
    "powerpc64-linux-gnu": "ppc64",
    "riscv64-linux-gnu": "riscv64",
    "s390x-linux-gnu": "s390x",
    "sparc64-linux-gnu": "sparc64",
}
NODE = """\
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";
const wasi = new WASI({ version: "preview1" });
const code = await readFile(process.argv[2]);
const { instance } = await WebAssembly.instantiate(code, wasi.getImportObject());
process.exit(wasi.start(instance));
"""


def needed(tool):
    """Return the tool's name; skip the test where it is not installed."""
    return tool if shutil.which(tool) else pytest.skip(f"{tool} is not installed")


def run(directory, build, before=()):
    """Build the program and run it; return its exit status and what it prints."""
    program = directory / "bits"
    line = [*build, "-I", GENERATED, *PROGRAM, "-o", program, "-lm"]
    subprocess.run(line, check=True, capture_output=True)
    done = subprocess.run([*before, program], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout.strip()


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """Return the bits of gcc without optimisation, by the option that chooses them."""
    needed("gcc")
    directory = tmp_path_factory.mktemp("reference")

    @cache
    def bits(option):
        status, printed = run(directory, ["gcc", "-std=c99", option])
        assert status == 0
        return printed

    return bits


def test_the_two_arithmetics_differ(reference):
    assert reference(WITHOUT) != reference(WITH)


@pytest.mark.parametrize("option", [WITHOUT, pytest.param(WITH, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    "build",
    [
        ("gcc", "-std=c99", "-O2", "-march=native"),
        pytest.param(("gcc", "-std=c99", "-O3", "-fno-math-errno"), marks=pytest.mark.slow),
        pytest.param(("clang", "-O2", "-march=native"), marks=pytest.mark.slow),
        pytest.param(("clang", "-O3", "-fno-math-errno"), marks=pytest.mark.slow),
        pytest.param(("musl-gcc", "-std=c99", "-O2", "-static"), marks=pytest.mark.slow),
    ],
    ids=" ".join,
)
def test_bits_do_not_depend_on_the_compiler(reference, build, option, tmp_path):
    assert run(tmp_path, [needed(build[0]), *build[1:], option]) == (0, reference(option))


@pytest.mark.slow
@pytest.mark.parametrize("target", FOREIGN)
def test_bits_do_not_depend_on_the_processor(reference, target, tmp_path):
    build = [needed(f"{target}-gcc"), "-std=c99", "-O2", "-static", WITHOUT]
    before = [needed(f"qemu-{FOREIGN[target]}")]
    assert run(tmp_path, build, before) == (0, reference(WITHOUT))


@pytest.mark.slow
def test_webassembly_has_the_same_bits(reference, tmp_path):
    script = tmp_path / "run.mjs"
    script.write_text(NODE)
    build = [needed("clang"), "--target=wasm32-wasi", "-O2", WITHOUT]
    before = [needed("node"), "--no-warnings", script]
    assert run(tmp_path, build, before) == (0, reference(WITHOUT))


@pytest.mark.parametrize("option", [WITHOUT, pytest.param(WITH, marks=pytest.mark.slow)])
@pytest.mark.parametrize(
    "build",
    [
        pytest.param(("gcc", "-O2", "-mfma"), marks=pytest.mark.slow),
        ("clang", "-O1", "-mfma", "-ffp-contract=fast"),
    ],
    ids=" ".join,
)
@pytest.mark.skipif(not X86, reason="-mfma is an option for x86")
def test_compilers_that_fuse_products_themselves_are_refused(build, option, tmp_path):
    status, printed = run(tmp_path, [needed(build[0]), *build[1:], option])
    assert status != 0
    assert not printed
