"""Import graph of the project: packages, layers, dependencies between packages, and cycles.

    python tests/house.py

prints them.  A package is a folder of `rigidsym`, or a module at its top; its layer is above all
that it imports.  Imports inside functions count, and so do those for type checkers alone, except in
`rigidsym.view`: its functions name the classes that they show, which import them, and such an
import never runs.
"""

import ast
import re
from collections import Counter
from collections.abc import Mapping
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).parents[1]
# What codegen wrote, and what is only printed into it.
APART = {
    *("rigidsym.generated.torque_free", "rigidsym.generated.torque_free_pi"),
    "rigidsym.generated.torque_free_step",
    *(
        f"rigidsym.codegen.targets.numpy.{name}"
        for name in ("runtime", "sensitivity", "shared", "step")
    ),
}
Graph = Mapping[str, set[str]]


def plain(name: str) -> str:
    """Return a dotted module name without the leading underscores of private parts."""
    return re.sub(r"\._(?!_)", ".", name)


def modules() -> dict[str, Path]:
    """Return the path of every module of package and derivation, by its dotted name."""
    found = {}
    for top in ("rigidsym", "derivations"):
        for path in sorted((ROOT / top).rglob("*.py")):
            name = ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
            if plain(name) not in APART:
                found[plain(name)] = path
    return found


@cache
def imported(path: Path, types: bool = True) -> tuple[str, ...]:
    """Return the dotted names that a module imports, for example `package.module.name`.

    Without `types`, those under `if TYPE_CHECKING` are left out.
    """
    every = list(ast.walk(ast.parse(path.read_text("utf-8"))))
    guards = (x for x in every if isinstance(x, ast.If) and ast.unparse(x.test) == "TYPE_CHECKING")
    apart = set() if types else {id(child) for node in guards for child in node.body}
    found: list[str] = []
    for node in every:
        if isinstance(node, ast.ImportFrom) and node.module and id(node) not in apart:
            found += (f"{node.module}.{alias.name}" for alias in node.names)
        elif isinstance(node, ast.Import) and id(node) not in apart:
            found += (alias.name for alias in node.names)
    return tuple(map(plain, found))


def imports() -> Graph:
    """Return the modules of the project that each module imports.

    For views, these are the imports that run.
    """
    every = modules()

    def home(name: str) -> str:
        while name and name not in every:
            name = name.rpartition(".")[0]
        return name

    graph = {}
    for name, path in every.items():
        in_view = name.startswith("rigidsym.view.")
        taken = imported(path, types=False) if in_view else imported(path)
        graph[name] = {home(other) for other in taken} - {name, ""}
    return graph


def package(module: str) -> str:
    """Return the name of the package that a module belongs to.

    It is the module's folder, and within proof, view and codegen the folder inside that.
    """
    top, *rest = module.split(".")
    if top != "rigidsym" or not rest:
        return top
    deep = len(rest) > 2 and rest[0] in ("proof", "view", "codegen")
    return ".".join(rest[:2] if deep else rest[:1])


def circle(graph: Graph) -> list[str]:
    """Return modules that import each other in a cycle; none if there is no cycle."""
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return error.args[1]
    return []


def dependencies(graph: Graph) -> Counter[tuple[str, str]]:
    """Count the imports from each package to each other one."""
    pairs = ((package(name), package(other)) for name, others in graph.items() for other in others)
    return Counter(pair for pair in pairs if pair[0] != pair[1])


def layers(graph: Graph) -> dict[str, int]:
    """Return the layer of each package in the import graph.

    It is that of the package's highest module, and a module is above all that it imports.
    """
    height: dict[str, int] = {}
    found: dict[str, int] = {}
    for name in TopologicalSorter(graph).static_order():
        height[name] = 1 + max((height[other] for other in graph[name]), default=0)
        found[package(name)] = max(height[name], found.get(package(name), 0))
    return found


def main() -> None:
    """Print the packages by layer with their imports, or the first import cycle."""
    graph = imports()
    if found := circle(graph):
        print("circle:", " -> ".join(found))
        return
    sizes, between, layer = Counter(map(package, graph)), dependencies(graph), layers(graph)
    print(f"{len(graph)} modules, {len(sizes)} packages, {len(between)} dependencies, no circle")
    for name in sorted(sizes, key=lambda name: (-layer[name], name)):
        goes = [
            f"{end} {count}" for (begin, end), count in sorted(between.items()) if begin == name
        ]
        print(f"{layer[name]:3}  {name} ({sizes[name]}) -> {', '.join(goes or ['nothing'])}")


if __name__ == "__main__":
    main()
