"""How many lines of a module follow facts, how many classical formulas; how many are by hand."""

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from importlib import resources

from rigidsym.codegen.forms import STEP, THETA, split
from rigidsym.codegen.ir import KINDS


def _of_c(names: str) -> tuple[str, ...]:
    return tuple(f"targets/c/{name}.c" for name in names.split())


# Written by hand, and run with what is generated: files of `rigidsym.codegen`, by target.
RUNTIMES = {
    "numpy": ("targets/numpy/runtime.py", "targets/numpy/double_double.py"),
    "numpy-step": ("targets/numpy/step.py", "targets/numpy/double_double.py"),
    "c": _of_c("runtime bodies exact arithmetic rounding quotients double_double"),
    "c-step": _of_c("step kick bodies step_arithmetic rounding quotients double_double"),
}
# And what the theta form has beside them.
SENSITIVITIES = {"numpy": "targets/numpy/sensitivity.py", "c": "targets/c/sensitivity.c"}
_COMMENT = {"numpy": r"#[^\n]*", "c": r"/\*.*?\*/"}
MEANINGS = {
    "fact": "follow facts of the ledger, each named on its line",
    "classical": "follow classical formulas, each with its reference",
    "arithmetic": "are arithmetic: sums, products, quotients, roots, reductions",
    "runtime": "are the runtime, written by hand",
}


def shares(kinds: Iterable[str], module: str) -> dict[str, int]:
    """How many lines of a module, by its key, there are of each kind; by hand last."""
    counts = Counter(kinds)
    return {kind: counts[kind] for kind in KINDS} | {"runtime": handwritten(module)}


def text(counts: Mapping[str, int]) -> str:
    """A line for each kind."""
    whole = sum(counts.values())
    rows = (
        f"  {count:5} {round(100 * count / whole):3} %  {MEANINGS[kind]}"
        for kind, count in counts.items()
    )
    return "\n".join(["Lines of code:", *rows])


def handwritten(module: str) -> int:
    """Lines that are neither blank nor comments of what a module has beside generated code."""
    target, form = split(module)
    names = RUNTIMES.get(module if form == STEP else target, ())
    if form == THETA and target in SENSITIVITIES:
        names = (*names, SENSITIVITIES[target])
    return sum(_lines(name, _COMMENT[target]) for name in names)


def _lines(name: str, comment: str) -> int:
    whole = resources.files("rigidsym.codegen").joinpath(name).read_text("utf-8")
    code = re.sub(comment, "", whole, flags=re.DOTALL)
    # Other files, where this one names them, are counted by themselves.
    code = re.sub(r"@\w+\.c@", "", code)
    return sum(bool(line.strip()) for line in code.splitlines())
