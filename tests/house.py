"""The house as its imports say it: rooms, the floors they stand on, arrows, and circles.

    python tests/house.py

prints them.  A room is a folder of `rigidsym`, or a module at its top.  Imports inside functions
count, and so do those for type checkers alone, except in `rigidsym.view`: its functions name the
classes that they show, which import them, and such an import never runs.
"""

import ast
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[1]
# What codegen wrote, and what only stands inside of what it writes.
APART = {
    "rigidsym.generated.torque_free",
    "rigidsym.generated.torque_free_pi",
    "rigidsym.generated.torque_free_step",
    "rigidsym.codegen.targets.numpy.runtime",
    "rigidsym.codegen.targets.numpy.sensitivity",
    "rigidsym.codegen.targets.numpy.step",
}


def plain(name: str) -> str:
    """Return a dotted name without the underscores that mark private modules and folders."""
    return re.sub(r"\._(?!_)", ".", name)


Graph = Mapping[str, set[str]]


def modules() -> dict[str, Path]:
    """Every module of the package and of the derivation, by its dotted name."""
    found = {}
    for top in ("rigidsym", "derivations"):
        for path in sorted((ROOT / top).rglob("*.py")):
            name = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
            if plain(name) not in APART:
                found[plain(name)] = path
    return found


@cache
def imported(path: Path, types: bool = True) -> tuple[str, ...]:
    """Dotted names that a module imports, what it takes from a module behind that module's name.

    Without `types`, those under `if TYPE_CHECKING` are left out.
    """
    return tuple(plain(name) for name in _imported(path, types))


def _imported(path: Path, types: bool) -> Iterator[str]:
    every = list(ast.walk(ast.parse(path.read_text("utf-8"))))
    guarded = (node for node in every if isinstance(node, ast.If) and _is_for_types(node))
    apart = {id(child) for node in guarded for child in node.body}
    for node in every:
        if id(node) in apart and not types:
            continue
        if isinstance(node, ast.ImportFrom) and node.module:
            yield from (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)


def _is_for_types(node: ast.If) -> bool:
    return ast.unparse(node.test) == "TYPE_CHECKING"


def imports() -> Graph:
    """For each module the modules of the house that it imports; of views, when they run."""
    every = modules()

    def home(name: str) -> str:
        while name and name not in every:
            name = name.rpartition(".")[0]
        return name

    return {
        name: {home(other) for other in imported(path, not name.startswith("rigidsym.view."))}
        - {name, ""}
        for name, path in every.items()
    }


def room(module: str) -> str:
    """The folder of a module, as deep as two wings and the kinds of views ask for."""
    top, *rest = module.split(".")
    if top != "rigidsym" or not rest:
        return top
    deep = len(rest) > 2 and rest[0] in ("proof", "view", "codegen")
    return ".".join(rest[:2] if deep else rest[:1])


def circle(graph: Graph) -> list[str]:
    """Modules that import each other in a circle; none where there is none."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return error.args[1]
    return []


def arrows(graph: Graph) -> Counter[tuple[str, str]]:
    """How many imports go from room to room."""
    return Counter(
        (room(name), room(other))
        for name, others in graph.items()
        for other in others
        if room(name) != room(other)
    )


def floors(graph: Graph) -> dict[str, int]:
    """How high each module stands: above all that it imports."""
    found: dict[str, int] = {}
    for name in TopologicalSorter(graph).static_order():
        found[name] = 1 + max((found[other] for other in graph[name]), default=0)
    return found


def main() -> None:
    """Print rooms by floor, arrows, and the first circle."""
    graph = imports()
    found = circle(graph)
    if found:
        print("circle:", " -> ".join(found))
        return
    height: dict[str, int] = {}
    for name, floor in floors(graph).items():
        height[room(name)] = max(height.get(room(name), 0), floor)
    sizes = Counter(map(room, graph))
    leaving: dict[str, list[str]] = {}
    for (begin, end), count in sorted(arrows(graph).items()):
        leaving.setdefault(begin, []).append(f"{end} {count}")
    print(f"{len(graph)} modules, {len(sizes)} rooms, {len(arrows(graph))} arrows, no circle")
    for name in sorted(sizes, key=lambda name: (-height[name], name)):
        goes = ", ".join(leaving.get(name, ["nothing"]))
        print(f"{height[name]:3}  {name} ({sizes[name]}) -> {goes}")


if __name__ == "__main__":
    main()
