"""`import rigidsym` alone makes every public name and module reachable."""

import re
import subprocess
import sys

import pytest
from document_texts import ROOT, documents

import rigidsym

# The pages, and notebooks with their code; the changelog also names what is gone.
TEXTS = [text for path, text in documents().items() if path != "CHANGELOG.md"] + [
    path.read_text("utf-8") for path in sorted((ROOT / "notebooks" / "text").glob("*.py"))
]
# Not names of schemas, such as rigidsym.states/1, of files, or of what is private.
DOTTED = re.compile(r"(?<![\w./\-])rigidsym((?:\.[A-Za-z]\w*)+)\b(?![/.]\w)")
NAMES = sorted({name for text in TEXTS for name in DOTTED.findall(text)})
CODE = """
import sys, rigidsym
for name in sys.argv[1:]:
    found = rigidsym
    try:
        for part in name.split(".")[1:]:
            found = getattr(found, part)
    except AttributeError as error:
        print(name, error)
    except ImportError as error:
        # Of an extra that is not installed.
        if "pip install 'rigidsym[" not in str(error):
            raise
"""


def test_names_of_documents_are_reachable_from_the_package():
    assert {".io.sampled", ".validate.examine", ".view.scenes", ".manoeuvre.flight"} <= {*NAMES}
    done = subprocess.run([sys.executable, "-c", CODE, *NAMES], capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("", "")


@pytest.mark.parametrize(
    ("package", "names"),
    [
        (rigidsym, {"io", "validate", "view", "step", "steps"}),
        (rigidsym.io, {"cases", "ledger", "sampled"}),
        (rigidsym.validate, {"examine", "faults", "strata"}),
        (rigidsym.view, {"scenes"}),
    ],
)
def test_a_package_lists_its_names_and_modules(package, names):
    assert names <= {*dir(package)}
    assert not [name for name in dir(package) if re.match("_[^_]", name)]
    assert "lazily" not in dir(package)


@pytest.mark.parametrize("name", ["nothing", "_nothing", "a.b", "__nothing__"])
def test_other_names_are_errors_of_attributes(name):
    with pytest.raises(AttributeError, match=f"^module 'rigidsym' has no attribute '{name}'$"):
        getattr(rigidsym, name)


def test_a_module_that_fails_to_import_is_not_an_unknown_name(monkeypatch):
    """The error of the import is shown, and not that there is no such name."""
    vars(rigidsym.view).pop("scenes", None)
    monkeypatch.setitem(sys.modules, "rigidsym.view.scenes", None)
    with pytest.raises(ImportError):
        _ = rigidsym.view.scenes
