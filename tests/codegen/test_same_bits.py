"""-DTORQUE_FREE_FMA=0 gives the same bits with every compiler, option and processor, or refuses."""

import subprocess
from functools import cache
from pathlib import Path

import pytest
from compilers import SOURCES, X86, installed

import rigidsym.generated
from rigidsym.validate import _same_bits, validate

GENERATED = Path(rigidsym.generated.__file__).parent
PROGRAM = (SOURCES / "bits.c", GENERATED / "torque_free.c", GENERATED / "torque_free_step.c")
MOTIONS = (Path(_same_bits.__file__).parent / "same_bits" / "motions.txt").read_text("utf-8")
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


def run(directory, build, before=()):
    """Build the program, run it on the motions, and return its exit status and what it prints."""
    program = directory / "bits"
    line = [*build, "-I", GENERATED, *PROGRAM, "-o", program, "-lm"]
    subprocess.run(line, check=True, capture_output=True)
    done = subprocess.run(
        [*before, program], input=MOTIONS, capture_output=True, text=True, check=False
    )
    lines = done.stdout.splitlines()
    if WITH in build:
        # GCC's fused instructions give zeros of sensitivities another sign than its calls of fma.
        lines = [" ".join(line.split()[:2]) for line in lines]
    return done.returncode, lines


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    """Return the expected hashes; with fused multiply-add those of gcc without optimisation."""
    directory = tmp_path_factory.mktemp("reference")

    @cache
    def bits(option):
        if option == WITHOUT:
            return [*_same_bits.expected().values()]
        status, printed = run(directory, [installed("gcc"), "-std=c99", option])
        assert status == 0
        return printed

    return bits


def test_the_motions_are_the_first_of_all_strata():
    assert _same_bits.drawn_motions() == MOTIONS
    for stratum, motions in _same_bits.motions().items():
        latest = [max(abs(motion[11:])) for motion in motions]
        assert all(t <= 1e9 for t in latest)
        assert 1e9 in latest or "longest" in stratum or "scales" in stratum


def test_both_arithmetics_have_the_bits_of_the_engines(reference):
    assert [*_same_bits.hashes().values()] == reference(WITHOUT)
    both = zip(reference(WITHOUT), reference(WITH), strict=True)
    assert sum(one.startswith(other) for one, other in both) <= 1  # bodies at rest


def test_other_bits_are_a_failure_that_names_stratum_and_hash(monkeypatch):
    changed = {name: x.replace(x[17:33], "0" * 16) for name, x in _same_bits.expected().items()}
    monkeypatch.setattr(_same_bits, "expected", lambda: changed)
    due, other = changed["rest"][17:33], _same_bits.hashes(["rest"])["rest"][17:33]
    line = f"same bits: rest: the hash of steps is {other}, expected {due}"
    assert _same_bits.differences(["rest"]) == (line,)
    report = validate(["c"], cases=1, strata=["rest"])
    assert report.complaints == (line,)
    assert not report.passed


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
    assert run(tmp_path, [installed(build[0]), *build[1:], option]) == (0, reference(option))


@pytest.mark.slow
@pytest.mark.skipif(not X86, reason="only there does GCC fuse so")
def test_bits_do_not_depend_on_vectors_of_straight_lines(reference, tmp_path):
    """GCC 12 makes vfmaddsub of products and sums, whatever -ffp-contract says."""
    fast = ("-std=c99", "-O3", "-march=native", "-fno-math-errno", "-fno-trapping-math")
    found = run(tmp_path, [installed("gcc"), *fast, WITHOUT])
    assert found == (0, reference(WITHOUT))


@pytest.mark.slow
@pytest.mark.parametrize("target", FOREIGN)
def test_bits_do_not_depend_on_the_processor(reference, target, tmp_path):
    build = [installed(f"{target}-gcc"), "-std=c99", "-O2", "-static", WITHOUT]
    before = [installed(f"qemu-{FOREIGN[target]}")]
    assert run(tmp_path, build, before) == (0, reference(WITHOUT))


@pytest.mark.slow
def test_webassembly_has_the_same_bits(reference, tmp_path):
    script = tmp_path / "run.mjs"
    script.write_text(NODE)
    build = [installed("clang"), "--target=wasm32-wasi", "-O2", WITHOUT]
    before = [installed("node"), "--no-warnings", script]
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
    status, printed = run(tmp_path, [installed(build[0]), *build[1:], option])
    assert status != 0
    assert not printed
