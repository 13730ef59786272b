"""The second checker accepts the sealed ledger and shares no code with the kernel."""

import ast
import json
import re
import subprocess
import sys
from graphlib import TopologicalSorter
from pathlib import Path

import pytest
from ledgers import GONE, both_refuse, tampered, written

import rigidsym.proof.checker
from rigidsym.proof.checker import check
from rigidsym.proof.kernel import replay

HOME = Path(rigidsym.proof.checker.__file__).parent
SEALED = (HOME.parents[2] / "derivations" / "ledger.json").read_text(encoding="utf-8")


def test_accepts_the_sealed_ledger():
    assert check(SEALED) == len(json.loads(SEALED)["facts"]) > 100


@pytest.fixture(scope="module")
def excerpt() -> str:
    """Return three contexts of the sealed ledger with their facts."""
    data, names = json.loads(SEALED), ("body", "attitude", "regular")
    data["contexts"] = [context for context in data["contexts"] if context["name"] in names]
    facts = [fact for fact in data["facts"] if fact["context"] in names]
    data["facts"] = [fact for fact in facts if fact["kind"] != "model" and not fact["premises"]]
    return written(data)


def test_both_checkers_accept_the_excerpt(excerpt):
    assert check(excerpt) == len(replay(excerpt).facts) > 30


@pytest.mark.parametrize("k", range(1, 31, 3))
def test_both_checkers_refuse_a_changed_statement(excerpt, k):
    """No fact of the excerpt has premises, so that each may stand alone."""
    data = json.loads(excerpt)
    fact = data["facts"][k]
    fact["rhs"][0] += " + 1"
    assert both_refuse(written(data | {"facts": [fact]})).startswith(f"fact {fact['id']}: ")


@pytest.mark.parametrize(
    "path",
    [f"contexts/{k}/{part}/0" for k in (1, 2) for part in ("generators", "units", "relations")]
    + ["contexts/0/units/2", "contexts/1/nonnegative/0", "contexts/2/nonnegative/1"],
)
def test_both_checkers_refuse_a_dropped_hypothesis(excerpt, path):
    both_refuse(tampered(excerpt, path, GONE))


def test_its_modules_import_each_other_without_circles():
    """Imports for type checkers count as well."""
    rests_on = {
        path.stem: {
            *re.findall(r"from rigidsym\.proof\.checker\.(\w+) import", path.read_text("utf-8"))
        }
        for path in HOME.glob("*.py")
    }
    assert [*TopologicalSorter(rests_on).static_order()][-1] == "__init__"


def test_imports_neither_sympy_nor_the_rest_of_rigidsym():
    """Its modules import neither directly nor indirectly."""
    allowed = sys.stdlib_module_names | {"flint", "rigidsym.proof.checker"}
    for file in HOME.glob("*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import | ast.ImportFrom):
                names = [alias.name for alias in node.names]
                for name in names if isinstance(node, ast.Import) else [str(node.module)]:
                    depth = 3 if name.startswith("rigidsym") else 1
                    assert ".".join(name.split(".")[:depth]) in allowed
    program = "import sys, rigidsym.proof.checker; print(*sys.modules)"
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    ours = {name for name in run.stdout.split() if name.split(".")[0] == "rigidsym"}
    around = ([], ["_lazy"], ["_version"], ["proof"], ["proof", "checker"])
    assert all(name.split(".")[1:3] in around for name in ours)
    assert not {"sympy", "mpmath", "numpy"} & {*run.stdout.split()}
