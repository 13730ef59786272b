"""The files of the Coq export: prelude, contexts, theorems and Makefile."""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import resources

from rigidsym.proof._coq.chapter import Chapter
from rigidsym.proof._coq.facts import Printer
from rigidsym.proof._coq.theory import NotExportedError
from rigidsym.proof.kernel import Ledger

# Hand-written files.  One that requires contexts which the ledger lacks is left out.
_FIXED = (
    "prelude.v",
    "theorems/motion.v",
    "theorems/steady.v",
    "theorems/pull_back.v",
    "theorems/symmetric.v",
    "theorems/asymmetric.v",
    "theorems/separatrix.v",
    "theorems/kick.v",
    "theorems/step.v",
    "theorems/variation.v",
    "theorems/published.v",
    "theorems/instances.v",
    "assumptions/plain.v",
    "assumptions/computed.v",
    "assumptions/published.v",
)
_REQUIRE = r"^From Rigidsym(?:\.(\w+))? Require (?:Import )?(.*)\.$"
_MAKEFILE = """\
# make -j2: Coq decides every theorem.  It needs Coq 8.16 or later with Coquelicot 3.2 or later
# (Debian: apt-get install coq libcoq-coquelicot).
all: CoqMakefile
\t$(MAKE) -f CoqMakefile

# Theorems on motions, on steps and kicks, and on published forms, with the contexts that they use.
plain computed published: CoqMakefile
\t$(MAKE) -f CoqMakefile assumptions/$@.vo

CoqMakefile: _CoqProject
\tcoq_makefile -f _CoqProject -o CoqMakefile

.PHONY: all plain computed published
.NOTPARALLEL:
"""


@dataclass(frozen=True, slots=True)
class Export:
    """Exported Coq files, with counts of exported facts and reasons for omitted ones.

    Files are listed by name, counts by inference rule, and reasons by id of the fact.
    """

    files: Mapping[str, str]
    exported: Mapping[str, int]
    left_out: Mapping[str, str]


def export(ledger: Ledger) -> Export:
    """Export an admitted ledger as Coq files."""
    chapters = {name: Chapter(context) for name, context in ledger.contexts.items()}
    printer = Printer(chapters, ledger.facts)
    exported: Counter[str] = Counter()
    left_out: dict[str, str] = {}
    for fact in ledger.facts.values():
        try:
            printer.export(fact)
            exported[fact.rule] += 1
        except NotExportedError as error:
            left_out[fact.id] = str(error)
    files = {f"contexts/{name}.v": chapter.text() for name, chapter in chapters.items()}
    files |= _fixed(files)
    project = "\n".join(["-Q . Rigidsym", "-arg -w -arg none", *files]) + "\n"
    return Export(files | {"_CoqProject": project, "Makefile": _MAKEFILE}, exported, left_out)


def _fixed(files: Mapping[str, str]) -> dict[str, str]:
    """Return the hand-written Coq files whose imports are all available."""
    found: dict[str, str] = {}
    for name in _FIXED:
        text = resources.files("rigidsym.proof._coq").joinpath(name).read_text("utf-8")
        required = re.findall(_REQUIRE, text, re.MULTILINE)
        needed = (f"{folder}/{x}.v".lstrip("/") for folder, xs in required for x in xs.split())
        if all(file in files or file in found for file in needed):
            found[name] = text
    return found
