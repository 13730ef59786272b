"""Imports run downwards only and without circles; only the seal imports the kernel."""

import pytest
from house import circle, imported, imports, modules, package

GRAPH = imports()
# What each package may import, itself, `_version` and `_lazy` aside; the longest name that
# fits a module counts.  Names are of folders, with all that is in them, and of modules.
FOUNDATION = "errors language quaternions"
NUMBERS = f"{FOUNDATION} inputs solution precise"
ALLOWED = {
    "rigidsym": "codegen errors fitting manoeuvre motion principal solution.polhode "
    "solution.symbolic splitting steps",
    "rigidsym.__main__": "cli",
    "rigidsym.version": "",
    "rigidsym.lazy": "",
    "rigidsym.errors": "",
    "rigidsym.quaternions": "",
    "rigidsym.sensitivity": "errors",
    "rigidsym.language": "",
    "rigidsym.generated": "",
    "rigidsym.containers": "errors",
    "rigidsym.inputs": "containers errors",
    "rigidsym.layers": "containers errors sensitivity",
    "rigidsym.frames": "containers errors inputs layers",
    "rigidsym.principal": "containers errors frames inputs layers quaternions sensitivity",
    "rigidsym.motion": f"{NUMBERS} engines frames layers principal sensitivity view",
    "rigidsym.steps": "engines errors layers",
    "rigidsym.tangents": "",
    "rigidsym.jax": "engines errors motion steps tangents",
    "rigidsym.torch": "engines errors motion sensitivity steps tangents",
    # What is true.
    "rigidsym.proof.kernel": "",
    "rigidsym.proof.checker": "",
    "rigidsym.proof.algebra": "proof.kernel",
    "rigidsym.proof.steps": "language proof.algebra proof.kernel view.article view.statements",
    "rigidsym.proof.coq": "proof.algebra proof.kernel",
    "rigidsym.proof.mutants": "language proof.algebra proof.kernel",
    "rigidsym.proof.paper": "language view.proofs",
    "rigidsym.proof.audit": "language",
    "rigidsym.proof.claims": "io.ledger language view.cards",
    "rigidsym.proof.derivation": "derivations errors io.ledger language proof view.proofs",
    "rigidsym.proof": "",
    "derivations": "errors language proof.algebra proof.kernel proof.paper proof.steps",
    # What is computed from it.
    "rigidsym.solution": "errors inputs io.ledger language",
    "rigidsym.precise": f"{FOUNDATION} inputs solution",
    "rigidsym.precise.comparison": f"{NUMBERS} io.cases view.plots.charts",
    "rigidsym.codegen": f"{FOUNDATION} codegen io.files solution",
    "rigidsym.codegen.functions": f"{FOUNDATION} codegen solution",
    "rigidsym.codegen.special_functions": f"{FOUNDATION} codegen solution",
    "rigidsym.codegen.targets": f"{FOUNDATION} codegen",
    # The one exception: the kernel decides that what is printed is what was derived.
    "rigidsym.codegen.seal": f"{FOUNDATION} codegen solution proof.kernel",
    # Reference vectors of the flight profile are precise states in the strata of validation.
    "rigidsym.codegen.flight": f"{NUMBERS} codegen io.files io.ledger validate.strata",
    "rigidsym.engines": f"{FOUNDATION} codegen.forms codegen.targets containers generated inputs "
    "io.files solution",
    "rigidsym.validate": f"{NUMBERS} codegen engines generated io motion view",
    "rigidsym.validate.fits": f"{FOUNDATION} fitting motion validate",
    "rigidsym.validate.torques": "errors quaternions splitting validate",
    "rigidsym.validate.faults": f"{NUMBERS} codegen engines generated io splitting validate view",
    "rigidsym.splitting": "containers engines errors frames generated inputs motion quaternions",
    "rigidsym.manoeuvre": f"{NUMBERS} engines io motion splitting validate.executors view",
    "rigidsym.fitting": f"{NUMBERS} containers engines frames io motion view",
    # Both halves meet: what a ledger publishes is compared with the equations of motion.
    "rigidsym.numbers": f"{FOUNDATION} inputs solution precise",
    # What shows it, and what reads and writes files.
    "rigidsym.view": NUMBERS,
    "rigidsym.view.article": "language view.cards view.pages view.prose view.statements",
    "rigidsym.view.prose": "language view.statements",
    "rigidsym.view.statements": "language",
    "rigidsym.view.pages": "view.cards view.style view.tables",
    "rigidsym.view.plots": f"{NUMBERS} view",
    "rigidsym.view.scenes": f"{NUMBERS} view",
    "rigidsym.view.validation": "validate.bounds view",
    "rigidsym.io": "errors io",
    "rigidsym.io.attitude_ephemeris": "errors io motion",
    "rigidsym.io.cases": "errors inputs io motion view",
    "rigidsym.io.tables": "inputs io precise",
    "rigidsym.io.tracks": "engines errors io motion",
    # What a user calls for all of it.
    "rigidsym.reproduce": "codegen errors inputs io proof solution validate view",
    "rigidsym.cli": f"{NUMBERS} codegen derivations engines fitting generated io manoeuvre motion "
    "numbers proof reproduce validate view",
}
# Third-party packages, each with the only packages that import it.
OTHERS = {
    "matplotlib": ("rigidsym.view",),
    "plotly": ("rigidsym.view",),
    "sympy": (
        *("rigidsym.proof", "rigidsym.view.article", "derivations"),
        *("rigidsym.language.functions", "rigidsym.solution.symbolic"),
    ),
    "casadi": ("rigidsym.manoeuvre.comparison",),
    "jax": ("rigidsym.engines.xla",),
}


def rule(module):
    """Return the entry of ALLOWED that applies to a module, the one with the longest name."""
    while module not in ALLOWED:
        module = module.rpartition(".")[0]
    return module


def lies_in(module, names):
    return any(module == name or module.startswith(f"{name}.") for name in names)


@pytest.mark.parametrize("module", GRAPH)
def test_a_module_imports_what_its_package_may(module):
    own = rule(module)
    named = (name if name == "derivations" else f"rigidsym.{name}" for name in ALLOWED[own].split())
    allowed = [*named, "rigidsym.version", "rigidsym.lazy"]
    assert [x for x in GRAPH[module] if rule(x) != own and not lies_in(x, allowed)] == []


def test_the_seal_alone_imports_the_kernel_into_the_number_half():
    proving = ("rigidsym.proof", "rigidsym.reproduce", "rigidsym.cli", "derivations")
    across = [
        (name, other)
        for name, others in GRAPH.items()
        for other in others
        if not lies_in(name, proving) and lies_in(other, ["rigidsym.proof"])
    ]
    assert across
    assert all(lies_in(name, ["rigidsym.codegen.seal"]) for name, _ in across)
    assert all(lies_in(other, ["rigidsym.proof.kernel"]) for _, other in across)


def test_nothing_is_imported_in_a_circle():
    assert circle(GRAPH) == []


def test_every_rule_is_about_something():
    assert {rule(module) for module in GRAPH} == {*ALLOWED}


@pytest.mark.parametrize("other", OTHERS)
def test_a_package_is_imported_where_it_belongs(other):
    users = {
        name
        for name, path in modules().items()
        if other in {taken.split(".")[0] for taken in imported(path)}
    }
    assert users
    assert [name for name in users if not lies_in(name, OTHERS[other])] == []


def test_the_kernel_imports_the_polynomials_of_sympy_alone():
    kernel = [path for name, path in modules().items() if package(name) == "proof.kernel"]
    taken = [other for path in kernel for other in imported(path) if "sympy" in other]
    assert taken
    assert all(other.startswith("sympy.polys") for other in taken)


def test_imports_for_types_are_left_out_for_views_only(tmp_path):
    path = tmp_path / "one.py"
    path.write_text("import a\nif TYPE_CHECKING:\n    from b import c\n")
    assert imported(path) == ("a", "b.c")
    assert imported(path, types=False) == ("a",)
    motion = "rigidsym.motion"
    assert motion in imported(modules()["rigidsym.view.geometry"])[-1]
    assert motion not in GRAPH["rigidsym.view.geometry"]
