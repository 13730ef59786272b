"""Facts: hypotheses |- statement, with a grade, the rule that made it, and its certificate."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any


class Grade(StrEnum):
    """How a statement is known, from worst to best; a conclusion has its weakest premise's."""

    REFUTED = "REFUTED"
    UNDECIDED = "UNDECIDED"
    ASSUMED = "ASSUMED"
    SAMPLED = "SAMPLED"
    ENCLOSED = "ENCLOSED"
    PROVED = "PROVED"


@dataclass(frozen=True, slots=True)
class Fact:
    """context |- statement.  A value like any other: only `Ledger.add` makes it count.

    The statement is, by `kind` and componentwise: "equal", lhs = rhs; "root", lhs = +sqrt(rhs);
    "unequal", lhs and rhs differ at some point of the context; "model", the context is a model of
    the context named in rhs.  `source` lists the equations of the paper (or DLMF) it is about.
    """

    id: str
    context: str
    kind: str
    lhs: tuple[str, ...]
    rhs: tuple[str, ...]
    rule: str
    grade: Grade = Grade.PROVED
    premises: tuple[str, ...] = ()
    source: tuple[str, ...] = ()
    certificate: Mapping[str, Any] = field(default_factory=dict)
