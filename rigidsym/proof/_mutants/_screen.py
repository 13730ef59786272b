"""Mutants of the definitions in a specification, and their refutation at points modulo a prime."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain, combinations
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from rigidsym.language._specification import Proved, Theorem, theorems
from rigidsym.proof._mutants._edits import Edit, alone, edits, reach
from rigidsym.proof._mutants._field import PRIME, Array, Points, Values
from rigidsym.proof.kernel import Context, KernelError
from rigidsym.proof.kernel._language import parse
from rigidsym.proof.kernel._rules import _frozen

MOST, BLOCK = 3, 8192
Mutant: TypeAlias = tuple[Edit, ...]


class Mutants(NamedTuple):
    """Many mutants: edits, and a row for each mutant with the places of its edits, or -1."""

    edits: Sequence[Edit]
    rows: Array

    def each(self, chosen: Iterable[int]) -> Iterator[Mutant]:
        """Yield the mutants in the chosen rows."""
        for row in self.rows[chosen].tolist():
            yield tuple(self.edits[place] for place in row if place >= 0)


def listed(mutants: Sequence[Mutant]) -> Mutants:
    """Return mutants with their edits listed once."""
    places = {edit: place for place, edit in enumerate(dict.fromkeys(chain(*mutants)))}
    rows = np.full((len(mutants), MOST), -1)
    for row, mutant in zip(rows, mutants, strict=True):
        row[: len(mutant)] = [places[edit] for edit in mutant]
    return Mutants([*places], rows)


class Screen:
    """The theorems of a specification, with points of their contexts.

    A theorem refutes a mutant if one of its definitions or equations is false at a point of the
    changed context.
    """

    def __init__(self, specification: str, ledger: Mapping[str, Any]) -> None:
        self.theorems, proved = theorems(specification), Proved(ledger)
        contexts = {x["name"]: Context(**_frozen(x)) for x in ledger["contexts"]}
        published = [proved.formula(entry) for x in proved.sequences.values() for entry in x]
        said = {(formula.name, formula.text) for formula in published}
        facts = {formula.name for formula in published if formula.how in ("fact", "root")}
        self.contexts: dict[str, Context] = {}
        self.definitions: dict[str, dict[str, str]] = {}
        for name, theorem in self.theorems.items():
            # It may use names that only it defines, or a context that its context models.
            definitions = {**theorem.let}
            for place in reversed(proved.modelled(name)):
                definitions |= contexts[place].definitions
            self.contexts[name] = replace(contexts[name], definitions=definitions)
            # Names that nothing uses may mean anything.
            used = facts | _used(theorem, definitions)
            here = contexts[name].definitions.items()
            self.definitions[name] = {x: t for x, t in here if x in used or (x, t) in said}
        self._points: dict[str, Points] = {}

    def mutants(self) -> Iterator[tuple[str, Mutants]]:
        """Yield the mutants of each theorem's context.

        They are all sets of up to three edits, except the sets that an earlier theorem has.  Other
        factors and lost terms are one edit each.
        """
        done: list[set[Edit]] = []
        for name in self.theorems:
            found, single = edits(self.definitions[name]), alone(self.definitions[name])
            places = np.arange(len(found), len(found) + len(single))
            padding = ((0, 0), (0, MOST - 1))
            rows = np.concatenate(
                [_sets(found), np.pad(places[:, None], padding, constant_values=-1)]
            )
            found += single
            for earlier in done:
                known = np.array([*(edit in earlier for edit in found), True])
                rows = rows[~known[rows].all(axis=1)]
            done.append({*found})
            yield name, Mutants(found, rows)

    def survivors(self, found: dict[Mutant, str]) -> dict[Mutant, str]:
        """Return those of some mutants that no theorem refutes."""
        left = dict(found)
        for name in self.theorems:
            here = {*self.contexts[name].definitions.items()}
            mutants = listed([m for m in left if any(x in here for e in m for x in e.texts)])
            for mutant in mutants.each(self.refuted(name, mutants)):
                del left[mutant]
        return left

    def refuted(self, name: str, mutants: Mutants) -> Array:
        """Return which mutants a theorem refutes."""
        blocks = range(0, len(mutants.rows), BLOCK)
        parts = [self._block(name, mutants.edits, mutants.rows[k : k + BLOCK]) for k in blocks]
        return np.concatenate([np.zeros(0, bool), *parts])

    def _block(self, name: str, edits: Sequence[Edit], rows: Array) -> Array:
        theorem, context, size = self.theorems[name], self.contexts[name], len(rows)
        refuted = np.zeros(size, bool)
        changes: dict[str, dict[str, Array]] = {}
        for place, edit in enumerate(edits):
            chosen = (rows == place).any(axis=1)
            for (x, text), terms in edit.terms:
                if context.definitions.get(x) != text or not chosen.any():
                    continue
                factors = changes.setdefault(x, {text: np.ones(size, np.int64)})
                factors[text][chosen] = 0
                for new, factor in terms:
                    part = factors.setdefault(new, np.zeros(size, np.int64))
                    part[chosen] += factor % PRIME
        summed = {x: [*factors.items()] for x, factors in changes.items()}
        if name not in self._points:
            self._points[name] = Points(context, seed=1)
        point, found = self._points[name].of(summed, size)
        values = Values(context, summed, point)
        definitions = [("=", name, text) for name, text in theorem.let.items()]
        left = np.arange(size)
        for relation, lhs, rhs in (*definitions, *theorem.then):
            if relation == ">=" or not len(left):
                continue
            try:
                one, other = values.value(parse(lhs)), values.value(parse(rhs))
            except (KernelError, RecursionError):  # for example a second derivative
                continue
            one = one * one % PRIME if relation == "sqrt" else one
            wrong = (one != other) & found[left] & values.defined
            refuted[left[wrong]] = True
            if wrong.mean() > 0.5:
                values.keep(~wrong)
                left = left[~wrong]
        return refuted


def _used(theorem: Theorem, definitions: Mapping[str, str]) -> set[str]:
    """Return the names that the hypotheses, definitions and equations of a theorem rest on."""
    texts = [*theorem.let, *theorem.zero, *theorem.nonzero, *theorem.nonnegative]
    texts += [text for text in (theorem.moving or {}).values() if text != "?"]
    texts += [side for _, *sides in theorem.then for side in sides]
    return set().union(*(reach(text, definitions) for text in texts))


def _sets(found: Sequence[Edit]) -> Array:
    """Return all sets of up to three edits of different definitions, as rows of their places."""
    names = [{name for name, _ in edit.texts} for edit in found]
    apart = np.array([not one & other for one in names for other in names], bool)
    apart = apart.reshape(len(found), len(found))
    rows = []
    for size in range(1, MOST + 1):
        sets = np.array([*combinations(range(len(found)), size)], int).reshape(-1, size)
        for i, j in combinations(range(size), 2):
            sets = sets[apart[sets[:, i], sets[:, j]]]
        rows.append(np.pad(sets, ((0, 0), (0, MOST - size)), constant_values=-1))
    return np.concatenate(rows)
