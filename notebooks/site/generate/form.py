"""What there is to say about a kind of file."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True, slots=True)
class Format:
    """A kind of file: who writes it, what its fields mean, and how to make a sample.

    `named` are the paths whose keys are data; `masked` are those that differ from run to run.
    """

    title: str
    written: str
    make: Callable[[], Any]
    fields: Mapping[str, str]
    named: frozenset[str] = field(default_factory=frozenset)
    masked: Mapping[str, Any] = field(default_factory=dict)
