"""How many lines of a module follow facts, how many classical formulas; how many are by hand."""

import re
from collections import Counter
from collections.abc import Iterable, Mapping
from importlib import resources

from rigidsym.codegen.ir import KINDS

# Written by hand, and run with what is generated: files of `rigidsym.codegen`, by target.
RUNTIMES = {
    "numpy": tuple(f"targets/numpy/{x}.py" for x in ("runtime", "sensitivity", "double_double")),
    "c": tuple(
        f"targets/c/{x}.c"
        for x in ("runtime", "sensitivity", "exact", "arithmetic", "double_double")
    ),
}
_COMMENT = {"numpy": r"#[^\n]*", "c": r"/\*.*?\*/"}
MEANINGS = {
    "fact": "follow facts of the ledger, each named on its line",
    "classical": "follow classical formulas, each with its reference",
    "arithmetic": "are arithmetic: sums, products, quotients, roots, reductions",
    "runtime": "are the runtime, written by hand",
}


def shares(kinds: Iterable[str], target: str) -> dict[str, int]:
    """How many lines there are of each kind, from the kinds of derived ones; by hand last."""
    counts = Counter(kinds)
    return {kind: counts[kind] for kind in KINDS} | {"runtime": handwritten(target)}


def text(counts: Mapping[str, int]) -> str:
    """A line for each kind."""
    whole = sum(counts.values())
    rows = (
        f"  {count:5} {round(100 * count / whole):3} %  {MEANINGS[kind]}"
        for kind, count in counts.items()
    )
    return "\n".join(["Lines of code:", *rows])


def handwritten(target: str) -> int:
    """Lines that are neither blank nor comments of what a target has beside generated code."""
    return sum(_lines(name, _COMMENT[target]) for name in RUNTIMES.get(target, ()))


def _lines(name: str, comment: str) -> int:
    whole = resources.files("rigidsym.codegen").joinpath(name).read_text("utf-8")
    code = re.sub(comment, "", whole, flags=re.DOTALL)
    return sum(bool(line.strip()) for line in code.splitlines())
