"""Conversion of the ledger's facts to Coq theorems, with one method per inference rule."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from rigidsym.proof._coq.chapter import (
    Chapter,
    Model,
    claims_list,
    known,
    path,
    sound,
)
from rigidsym.proof._coq.text import data, derivatives, listed, real, renamed
from rigidsym.proof._coq.theory import NotExportedError, Theory
from rigidsym.proof.kernel import Context, Fact
from rigidsym.proof.kernel._language import Tree, parse


@dataclass(frozen=True, slots=True)
class Claim:
    """A claim in the language of the Coq prelude: a constructor and its operands."""

    form: str
    sides: tuple[Tree, ...]

    def data(self, theory: Theory) -> str:
        """Return the claim as input to the checker in the Coq prelude."""
        return f"{self.form} {' '.join(data(tree, theory.index) for tree in self.sides)}"

    def real(self, chapter: Chapter) -> str:
        """Return the claim as a Coq proposition on real numbers."""
        left, *right = map(chapter.real, self.sides)
        function = f"(fun t : R => {left}) t"
        match self.form:
            case "Equal":
                return f"{left} = {right[0]}"
            case "Derives":
                return f"is_derive {function} ({right[0]})"
            case "Smooth":
                return f"ex_derive {function}"
            case "Root":
                return f"{left} = sqrt ({right[0]})"
        return f"0 <= {left}"


def claims_of(fact: Fact) -> list[list[Claim]]:
    """Convert each component of a fact to a list of claims."""
    return [_component(fact.kind, *sides) for sides in _sides(fact)]


def _sides(fact: Fact) -> list[tuple[Tree, Tree]]:
    return list(zip(map(parse, fact.lhs), map(parse, fact.rhs), strict=True))


def _component(kind: str, left: Tree, right: Tree) -> list[Claim]:
    if kind == "equal" and isinstance(left, tuple) and left[0] == "D":
        plain = not any(derivatives(right)) and not any(derivatives(left[2]))
        if plain:
            return [Claim("Derives", (left[2], right))]
    inner = dict.fromkeys([*derivatives(left), *derivatives(right)])
    smooth = [Claim("Smooth", (tree,)) for tree in inner]
    if kind == "root":
        return [*smooth, Claim("Root", (left, right))]
    signed = [Claim("Nonnegative", (right,))] if kind == "nonnegative" else []
    return [*smooth, Claim("Equal", (left, right)), *signed]


# Rules whose facts Coq takes as hypotheses: cited results, and functions that it lacks.
SUPPOSED = ("assumption", "theta", "start")


def computed(term: str) -> str:
    """Return a Coq proof that applies a term and ends with a computation."""
    return f"Proof. refine ({term}); vm_cast_no_check (eq_refl true). Qed."


class Printer:
    """Writer of the ledger's facts into the Coq files of their contexts.

    Facts are written in the order of the ledger.
    """

    def __init__(self, chapters: dict[str, Chapter], facts: dict[str, Fact]) -> None:
        self.chapters, self.facts = chapters, facts
        # For each exported fact, the assumptions that it rests on, as propositions about X.
        self.hypotheses: dict[str, tuple[str, ...]] = {}
        self.components: dict[str, list[tuple[Tree, ...]]] = {}

    def export(self, fact: Fact) -> None:
        """Write one fact as a Coq theorem or assumption.

        Raises NotExportedError if that is impossible.
        """
        rules: dict[str, Callable[[Chapter, Fact], tuple[str, ...]]] = {
            "identity": self._identity,
            "counterexample": self._counterexample,
            "model": self._model,
            "transfer": self._transfer,
            "partition": self._partition,
            "assumption": self._assumption,
            "theta": self._assumption,
            "start": self._assumption,
        }
        self.hypotheses[fact.id] = rules[fact.rule](self.chapters[fact.context], fact)

    # --- identities

    def _identity(self, chapter: Chapter, fact: Fact) -> tuple[str, ...]:
        theory, rows, said = chapter.theory, [], []
        for claims, cofactors in zip(claims_of(fact), fact.certificate["cofactors"], strict=True):
            for claim in claims:
                for tree in claim.sides:
                    theory.ready(tree)
                if claim.form in ("Derives", "Smooth"):
                    theory.differentiate(claim.sides[0])
                given = [theory.ring.read(text).numerator for text in cofactors]
                certified = claim.form not in ("Smooth", "Nonnegative")
                row = theory.rows(given if certified else ())
                rows.append(f"({claim.data(theory)}, {row})")
                said.append(claim.real(chapter))
        name = word(fact)
        chapter.write(
            claims_list(f"claims_{name}", rows),
            f"Theorem fact_{name} (X : names) (H : holds X){_time(chapter)} :",
            f"  {_all(said)}.",
            computed(f"decided _ theory (known X H (fun _ => [])) claims_{name} {_now(chapter)} _"),
        )
        return ()

    # --- assumptions

    def _assumption(self, chapter: Chapter, fact: Fact) -> tuple[str, ...]:
        said = [claim.real(chapter) for claims in claims_of(fact) for claim in claims]
        every = "forall t : R,\n  " if chapter.dynamic else ""
        reference = fact.certificate.get("reference", f"the kernel's rule {fact.rule} has it")
        chapter.write(
            f"(* Supposed, not proved: {str(reference).replace('*)', '* )')} *)",
            f"Definition fact_{word(fact)} (X : names) : Prop :=\n  {every}{_all(said)}.",
        )
        return (f"{chapter.name}.fact_{word(fact)} X",)

    # --- models and what they carry

    def _model(self, chapter: Chapter, fact: Fact) -> tuple[str, ...]:
        other = self.chapters[fact.rhs[0]]
        hypotheses = self._supports(fact)
        theory = chapter.theory.extended()
        chapter.uses.add(other.name)
        self._premises(chapter, theory, fact, hypotheses)
        held = chapter.dynamic and not other.dynamic
        at, time = (" t", " (t : R)") if held else ("", "")
        aliases = {
            name: f"{other.name} {name}"
            for name in other.theory.names
            if name in other.theory.texts
        }
        for name, alias in aliases.items():
            tree = renamed(other.theory.texts[name], aliases)
            theory.alias(alias, name, tree, "fun t => eq_refl")
        name = other.name
        here = f"as_{name} X{at}"
        rows, proofs = self._fields(chapter, other, theory, aliases)
        said = [claim for _, _, claim in other.hypotheses(f"({here})", f"{name}.")] or ["True"]
        values = {g: self._value(chapter, other, g, held) for g in other.context.generators}
        more = [other.say(x, f"({here})", f"{name}.") for x in aliases]
        binder, passed = _binder(hypotheses)
        who = f"(X : names) (H : holds X){binder}"
        claim = f"forall {who},\n  {sound(f'more_{name} X t')}"
        suppose = f"{name}.suppose ({here}){''.join(proofs)}"
        chapter.write(
            f"(* This is a model of {name}. *)",
            f"Definition as_{name} (X : names){time} : {name}.names :=",
            f"  {chapter.record(other, values)}.",
            f"Definition more_{name} (X : names) (t : R) : list R := {listed(more)}.",
            lambda: known(f"_{name}", theory, "theory", claim, f"known X H (more_{name} X)"),
            claims_list(f"fields_{name}", rows),
            f"Lemma all_{name} {who} (t : R) :",
            f"  {_all(said)}.",
            computed(f"decided _ theory_{name} (known_{name} X H{passed}) fields_{name} t _"),
            f"Theorem models_{name} {who}{time} : {name}.holds ({here}).",
            f"Proof. exact ({suppose.replace('ALL', f'all_{name} X H{passed}')}). Qed.",
        )
        chapter.models[name] = Model(other, theory, aliases, hypotheses)
        return hypotheses

    def _premises(
        self, chapter: Chapter, theory: Theory, fact: Fact, hypotheses: tuple[str, ...]
    ) -> None:
        """Add the equations of a fact's premises to a theory."""
        for premise in (self.facts[name] for name in fact.premises):
            claims = [claim for component in claims_of(premise) for claim in component]
            proof = self._theorem(chapter, premise, hypotheses)
            for k, claim in enumerate(claims):
                part = path(f"({proof})", k, len(claims))
                match claim.form:
                    case "Smooth":
                        continue
                    case "Equal":
                        left, right = claim.sides
                    case "Derives":
                        left, right = ("D", "(", claim.sides[0]), claim.sides[1]
                        part = f"(is_derive_unique _ _ _ {part})"
                    case _:
                        raise NotExportedError(f"premise {premise.id} is not a plain equation")
                if theory.read((left, "-", right)).numerator:
                    theory.premise((left, "-", right), f"fun t => Rminus_diag_eq _ _ {part}")

    def _theorem(self, chapter: Chapter, premise: Fact, hypotheses: tuple[str, ...]) -> str:
        """Return the Coq term that proves a premise of a fact at time t.

        The term refers to the names X, their hypotheses H, and the assumptions A0, A1, ...
        """
        rest = self.hypotheses[premise.id]
        numbers = [hypotheses.index(text) for text in rest]
        if premise.rule in SUPPOSED:
            return f"A{numbers[0]}{chapter.t}"
        return f"fact_{word(premise)} X H{''.join(f' A{k}' for k in numbers)}{chapter.t}"

    def _supports(self, fact: Fact) -> tuple[str, ...]:
        found: dict[str, None] = {}
        for name in fact.premises:
            if name not in self.hypotheses:
                raise NotExportedError(f"its premise {name} is not exported")
            found.update(dict.fromkeys(self.hypotheses[name]))
        return tuple(found)

    def _value(self, chapter: Chapter, other: Chapter, name: str, held: bool) -> str:
        """Express a quantity of another context in the names of this context."""
        value = f"{chapter.words[name]} X"
        if name in other.moving:
            return value if name in chapter.moving else f"fun _ => {value}"
        if name in chapter.moving and not held:
            raise NotExportedError(f"{name} moves here, and is constant there")
        return f"{value} t" if name in chapter.moving else value

    def _fields(
        self, chapter: Chapter, other: Chapter, theory: Theory, aliases: dict[str, str]
    ) -> tuple[list[str], list[str]]:
        """Return another context's hypotheses as claims in this context, with their proofs."""
        rows, moving = [], []

        def there(text: str) -> Tree:
            return renamed(parse(text), aliases)

        def add(claim: Claim, cofactors: str, moves: bool) -> None:
            rows.append(f"({claim.data(theory)}, {cofactors})")
            moving.append(moves)

        for text in other.context.units:
            theory.ready(there(text))
            theory.invert(there(text))
            add(Claim("Nonzero", (there(text),)), "[]", other.moves(text))
        for text in other.context.relations:
            add(Claim("Equal", (there(text), 0)), theory.gap(there(text), 0), other.moves(text))
        for text in other.context.nonnegative:
            claim = Claim("AtLeast", (there(text), parse(text)))
            add(claim, theory.gap(*claim.sides), other.moves(text))
        for name in other.rated():
            rate = there((other.context.rates or {})[name])
            theory.differentiate(name)
            add(Claim("Derives", (name, rate)), theory.gap(("D", "(", name), rate), True)
        if not chapter.dynamic and other.dynamic:
            raise NotExportedError("this context is an instant, the other is not")
        proofs = []
        for k, moves in enumerate(moving):
            at = "t" if chapter.dynamic and (moves or not other.dynamic) else "0"
            proof = path(f"(ALL {at})", k, len(rows))
            proofs.append(f" (fun t => {proof})" if moves else f" {proof}")
        return rows, proofs or [" I"]

    def _transfer(self, chapter: Chapter, fact: Fact) -> tuple[str, ...]:
        there = self.facts[fact.premises[0]]
        model = chapter.model(there.context)
        other, theory, rows, said = model.of, model.theory, [], []
        for component in claims_of(fact):
            for claim in component:
                sides = tuple(renamed(tree, model.aliases) for tree in claim.sides)
                theory_gap = [theory.gap(x, y) for x, y in zip(sides, claim.sides, strict=True)]
                witness = f"({theory_gap[0]}, {theory_gap[-1]})"
                rows.append(
                    f"({Claim(claim.form, sides).data(theory)}, {claim.data(theory)}, {witness})"
                )
                said.append(claim.real(chapter))
        held = " t" if chapter.dynamic and not other.dynamic else ""
        inner = self.hypotheses.get(there.id)
        if inner is None:
            raise NotExportedError(f"its premise {there.id} is not exported")
        here = f"(as_{other.name} X{held})"
        carried = []
        for proposition in inner:  # about X, to be stated of the other context's names
            head, _, names = proposition.partition(" ")
            carried.append(f"{head} {names.replace('X', here)}")
        hypotheses = tuple(dict.fromkeys([*model.hypotheses, *carried]))
        binder, _ = _binder(hypotheses)
        mine = "".join(f" A{hypotheses.index(text)}" for text in model.hypotheses)
        theirs = "".join(f" A{hypotheses.index(text)}" for text in carried)
        if there.rule in SUPPOSED:
            proof = f"{theirs.strip()}{other.t}"
        else:
            models = f"(models_{other.name} X H{mine}{held})"
            proof = f"{other.name}.fact_{word(there)} {here} {models}{theirs}{other.t}"
        name = word(fact)
        time = _time(chapter)
        chapter.uses.add(other.name)
        # The bound variable of a static context is any instant.
        chapter.write(
            f"(* As in {other.name}. *)",
            claims_list(f"claims_{name}", rows, "carriage"),
            f"Theorem fact_{name} (X : names) (H : holds X){binder}{time} :",
            f"  {_all(said)}.",
            computed(
                f"carried _ theory_{other.name} claims_{name} {_now(chapter)}"
                f" (known_{other.name} X H{mine}) _ ({proof})"
            ),
        )
        return hypotheses

    # --- counterexamples

    def _counterexample(self, chapter: Chapter, fact: Fact) -> tuple[str, ...]:
        if chapter.dynamic:
            raise NotExportedError("a point of a context that moves is no motion")
        context, values = chapter.context, fact.certificate["point"]
        point = {name: values[name] for name in context.generators}
        there = Context(context.name, (), {}, definitions={**point, **context.definitions})
        theory = Theory(there)
        theory.define(*there.definitions)
        rows = []
        for text in context.units:
            theory.invert(parse(text))
            rows.append(f"({Claim('Nonzero', (parse(text),)).data(theory)}, [])")
        for text in context.relations:
            gap = theory.gap(parse(text), 0)
            rows.append(f"({Claim('Equal', (parse(text), 0)).data(theory)}, {gap})")
        for text in context.nonnegative:
            number = theory.read(parse(text)).numerator.coeff(1)
            tree = (int(number.numerator), "/", int(number.denominator))
            gap = theory.gap(parse(text), tree)
            rows.append(f"({Claim('AtLeast', (parse(text), tree)).data(theory)}, {gap})")
        sides = _sides(fact)
        gaps: list[Tree] = [(left, "-", right) for left, right in sides]
        apart = next(k for k, gap in enumerate(gaps) if theory.read(gap).numerator)
        gap = gaps[apart]
        theory.invert(gap)
        rows.append(f"({Claim('Nonzero', (gap,)).data(theory)}, [])")
        name = word(fact)
        record = "; ".join(
            f"{chapter.words[g]} := {real(parse(text), str)}" for g, text in point.items()
        )
        said = " \\/\n    ".join(" <> ".join(map(chapter.real, pair)) for pair in sides)
        proofs = [path(f"all_{name}", k, len(rows)) for k in range(len(rows))]
        differ = f"(Rminus_not_eq _ _ {proofs[-1]})"
        branch = differ if apart == len(sides) - 1 else f"(or_introl {differ})"
        for _ in range(apart):
            branch = f"(or_intror {branch})"
        order = "; ".join(chapter.say(x).replace(" X", f" point_{name}") for x in theory.names)
        suppositions = " ".join(proofs[:-1]) or "I"
        chapter.write(
            f"Definition point_{name} : names := {{| {record} |}}.",
            f"Definition atoms_{name} (t : R) : list R := [{order}].",
            known(f"_{name}", theory, "nothing", f"sound atoms_{name}", "nothing_sound _"),
            claims_list(f"claims_{name}", rows),
            f"Lemma all_{name} : all_state atoms_{name} 0 claims_{name}.",
            computed(f"decided _ theory_{name} known_{name} claims_{name} 0 _"),
            f"Theorem fact_{name} : exists X : names, holds X /\\\n   ({said}).",
            f"Proof. exact (ex_intro _ point_{name}",
            f"  (conj (suppose point_{name} {suppositions}) {branch})). Qed.",
        )
        return ()

    # --- partitions

    def _partition(self, chapter: Chapter, fact: Fact) -> tuple[str, ...]:
        if chapter.dynamic:
            raise NotExportedError("a quantity that moves has no one sign")
        cases = [self.chapters[name] for name in fact.certificate["cases"]]
        for other in [*cases, *(self.chapters[name] for name in fact.rhs)]:
            self._case(chapter, other)
        x = fact.lhs[0]
        proof = self._by_sign(chapter, fact, cases, x)
        finer = {self.facts[p].context: self.facts[p] for p in fact.premises}
        whole = [self._holds(case) for case in cases]
        leaves = [self._holds(self.chapters[leaf]) for leaf in fact.rhs]
        before, standing = f"cases_{word(fact)} X", list(whole)
        for case in cases:
            split = finer.get(case.name)
            count = len(split.rhs) if split else 1
            inner, leaves = leaves[:count], leaves[count:] + leaves[:count]
            found = (
                f"{case.name}.fact_{word(split)} (as_{case.name} X)" if split else "splits_itself _"
            )
            rest = standing[1:]
            first = (
                f"splits_first _ {standing[0]} {listed(inner)} {listed(rest)} ({found}) ({before})"
            )
            before = f"splits_rotate _ {listed(inner)} {listed(rest)} ({first})"
            standing = [*rest, *inner]
        chapter.write(
            f"(* The cases of {x}. *)",
            f"Lemma cases_{word(fact)} (X : names) : splits (holds X) {listed(whole)}.",
            proof,
            f"Theorem fact_{word(fact)} (X : names) : splits (holds X)\n  {listed(leaves)}.",
            f"Proof. exact ({before}). Qed.",
        )
        return ()

    def _holds(self, other: Chapter) -> str:
        return f"({other.name}.holds (as_{other.name} X))"

    def _case(self, chapter: Chapter, other: Chapter) -> None:
        """Write the Coq definition of a case's quantities as those of the split context."""
        text = f"Definition as_{other.name} (X : names) : {other.name}.names :="
        if other.name not in chapter.cases:
            chapter.cases.add(other.name)
            values = {name: f"{chapter.words[name]} X" for name in other.context.generators}
            chapter.write(f"{text}\n  {chapter.record(other, values)}.")

    def _by_sign(self, chapter: Chapter, fact: Fact, cases: Sequence[Chapter], x: str) -> str:
        """Return the Coq proof that a context splits into cases by the sign of x."""
        context = chapter.context
        given = {
            "unit": len(context.units),
            "relation": len(context.relations),
            "sign": len(context.nonnegative),
        }
        iffs = []
        for k, case in enumerate(cases):
            at = f"(as_{case.name} X)"
            # The hypothesis that the case adds, or both, as parts of G for the whole context.
            added = {"unit": "(proj1 (proj2 G))", "sign": "(proj2 (proj2 G))"}
            added = {"relation": "(proj2 G)"} if k == 0 else added
            back, forth = "", []
            for kind, count in given.items():
                back += "".join(f" ({case.name}.{kind}_{j} {at} G)" for j in range(count))
                forth += [f"({kind}_{j} X (proj1 G))" for j in range(count)]
                forth += [added[kind]] if kind in added else []
            here = [f"({case.name}.{kind}_{given[kind]} {at} G)" for kind in added]
            news = here[0] if k == 0 else f"(conj {' '.join(here)})"
            iffs.append(
                f"(conj (fun G => conj (suppose X{back or ' I'}) {news})\n"
                f"    (fun G => {case.name}.suppose {at} {' '.join(forth)}))"
            )
        joined = "\n  ".join(iffs)
        if len(cases) == 3:
            return f"Proof. exact (splits_by_sign _ _ _ _ ({chapter.say(x)})\n  {joined}). Qed."
        visible = f"claims_{word(fact)}"
        chapter.write(
            claims_list(visible, [f"(Nonnegative {data(x, chapter.theory.index)}, [])"]),
            f"Lemma visible_{word(fact)} (X : names) (H : holds X) : 0 <= {chapter.say(x)}.",
            computed(f"decided _ theory (known X H (fun _ => [])) {visible} 0 _"),
        )
        start = f"splits_by_size _ _ _ ({chapter.say(x)}) (visible_{word(fact)} X)"
        return f"Proof. exact ({start}\n  {joined}). Qed."


def word(fact: Fact) -> str:
    """Return the Coq name of a fact within its context."""
    return "_".join(fact.id.split(".")[1:])


def _time(chapter: Chapter) -> str:
    return " (t : R)" if chapter.dynamic else ""


def _now(chapter: Chapter) -> str:
    return "t" if chapter.dynamic else "0"


def _all(said: Sequence[str]) -> str:
    return " /\\\n  ".join(said)


def _binder(hypotheses: Sequence[str]) -> tuple[str, str]:
    """Return Coq text that declares hypotheses, and Coq text that passes them as arguments."""
    binder = "".join(f" (A{k} : {text})" for k, text in enumerate(hypotheses))
    return binder, "".join(f" A{k}" for k in range(len(hypotheses)))
