"""The derivation in notebooks: chapters run in a builder, their lines, and SymPy within them."""

from collections.abc import Callable
from importlib import import_module
from inspect import getsource
from typing import Any

from IPython.display import HTML, Markdown, display
from sympy import ImmutableMatrix

from derivations import FORWARD
from derivations.setting import KINETIC, Setting
from rigidsym.proof.algebra import LedgerBuilder
from rigidsym.proof.steps import Rate, Scope, Step, StepError, rewrite
from rigidsym.view._article import line_html

__all__ = [
    "KINETIC",
    "Rate",
    "Setting",
    "StepError",
    "begun",
    "display",
    "lines",
    "rewrite",
    "source",
    "step",
    "within",
]


def begun(setting: Setting, *chapters: str) -> LedgerBuilder:
    """A builder with this setting, and in it forward chapters up to the last of these."""
    builder = LedgerBuilder()
    builder.keep(setting)
    for name in FORWARD[: max(map(FORWARD.index, chapters), default=-1) + 1]:
        import_module(f"derivations.{name}").derive(builder)
    return builder


def step(builder: LedgerBuilder, fact: str) -> Step:
    """The step of a builder that found a fact; KeyError where none did."""
    return {step.fact.id: step for step in builder.steps}[fact]


def lines(builder: LedgerBuilder, *facts: str) -> HTML:
    """The steps of a builder that found these facts, under each other."""
    return HTML("\n".join(line_html(step(builder, fact)) for fact in facts))


def within(builder: LedgerBuilder, context: str) -> Scope:
    """A context that a chapter has opened, to calculate with its names and matrices in SymPy."""
    scope = Scope(builder, builder.ledger.contexts[context], {})
    for name, value in builder.matrices.get(context, {}).items():
        known = isinstance(value, ImmutableMatrix)
        scope.matrices[name] = value if known else scope.explicit(value)
    return scope


def source(function: Callable[..., Any]) -> Markdown:
    """The lines of a function of a chapter, as the chapter has them."""
    return Markdown(f"```python\n{getsource(function)}```")
