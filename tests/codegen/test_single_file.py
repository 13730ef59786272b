"""C modules in one header and one source, to copy into another program."""

import subprocess
from pathlib import Path

import pytest
from compilers import STRICT, either, needed

from rigidsym import generate
from rigidsym._codegen.forms import FORMS
from rigidsym._codegen.targets.c.module import ARITHMETIC, HEADERS, SOURCES


@pytest.fixture(scope="module", params=FORMS)
def both(request):
    """Return the module of a form, in the files of the package and in a single source."""
    generated = generate("c", form=request.param)
    return request.param, generated, generated.single_file()


def assembly(directory, files, source):
    """Return the assembly of a source, without its name and the compiler's."""
    directory.mkdir()
    for name, text in files.items():
        (directory / name).write_text(text, "utf-8")
    compiler = either()
    made = directory / "made.s"
    done = compiler.run(*STRICT, "-O0", "-S", directory / source, "-o", made)
    assert done.returncode == 0, done.stderr[-2000:]
    lines = made.read_text("utf-8").splitlines()
    return [line for line in lines if not line.startswith(("\t.file", "\t.ident"))]


def test_a_single_file_has_all_and_the_same_machine_code(both, tmp_path):
    form, generated, single = both
    assert set(generated.files) == {HEADERS[form], SOURCES[form], ARITHMETIC}
    assert set(single.files) == {HEADERS[form], SOURCES[form]}
    assert single.files[HEADERS[form]] == generated.files[HEADERS[form]]
    first = assembly(tmp_path / "several", generated.files, SOURCES[form])
    assert assembly(tmp_path / "single", single.files, SOURCES[form]) == first


def test_the_map_of_a_single_file_names_its_own_lines(both):
    form, generated, single = both
    source = SOURCES[form]
    before, after = (x.files[source].split("\n") for x in (generated, single))
    assert len(single.map[source]) == len(generated.map[source])
    for one, other in zip(generated.map[source], single.map[source], strict=True):
        assert {**one, "line": 0} == {**other, "line": 0}
        assert before[one["line"] - 1] == after[other["line"] - 1]
    assert len(after) > len(before)


def test_the_manifest_of_a_single_file_has_the_digests_of_its_files(both):
    _, generated, single = both
    assert single.manifest["digest"] == generated.manifest["digest"]
    assert set(single.manifest["sha256"]) == set(single.files)
    assert single.manifest["sha256"] != generated.manifest["sha256"]


def test_single_files_of_all_forms_go_into_one_program(tmp_path):
    sources = Path(__file__).parent / "c"
    for form in FORMS:
        generate("c", form=form).single_file().write(tmp_path)
    assert not (tmp_path / ARITHMETIC).exists()
    (tmp_path / "both.c").write_text((sources / "both.c").read_text("utf-8"), "utf-8")
    program = needed("gcc").linked(
        tmp_path, "-std=c99", "-O0", sources=("both.c", *SOURCES.values())
    )
    printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    one, other = ([float(x) for x in line.split()] for line in printed.splitlines())
    assert one == pytest.approx(other, abs=1e-13)


def test_numpy_modules_are_single_files_already():
    generated = generate("numpy", form="step")
    assert generated.single_file() == generated
