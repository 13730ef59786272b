"""Code generation: solution -> lets -> passes -> one emitter per target."""

from rigidsym.codegen.generate import TARGETS, Generated, generate

__all__ = ["TARGETS", "Generated", "generate"]
