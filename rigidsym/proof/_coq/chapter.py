"""The Coq file of one context: its names, hypotheses and facts."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from rigidsym.proof._coq.text import identifiers, names_in, real
from rigidsym.proof._coq.theory import NotExportedError, Theory
from rigidsym.proof.kernel import Context
from rigidsym.proof.kernel._language import Tree, parse

Line: TypeAlias = str | Callable[[], str]


@dataclass(slots=True)
class Model:
    """Data of an exported proof that one context satisfies another's hypotheses.

    `of` is the other context, `theory` proves its hypotheses here, `aliases` are its names here,
    and `hypotheses` are the assumptions of the proof.
    """

    of: "Chapter"
    theory: Theory
    aliases: dict[str, str]
    hypotheses: tuple[str, ...]


@dataclass(slots=True)
class Chapter:
    """One context of the ledger while its Coq file is written.

    `blocks` are the parts of the file that follow its names and hypotheses.
    """

    context: Context
    theory: Theory = field(init=False)
    words: dict[str, str] = field(init=False)
    moving: set[str] = field(init=False)
    models: dict[str, Model] = field(default_factory=dict)
    uses: set[str] = field(default_factory=set)
    blocks: list[tuple[Line, ...]] = field(default_factory=list)
    cases: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        context = self.context
        self.theory = Theory(context)
        self.words = identifiers(self.theory.names)
        self.moving = {name for name, rate in (context.rates or {}).items() if rate != "0"}
        for name in self.theory.names:
            if name in self.theory.texts and self.moving & {*names_in(self.theory.texts[name])}:
                self.moving.add(name)
        self._suppose()

    def _suppose(self) -> None:
        """Add all hypotheses of the context to its theory.

        They are added in the kernel's order.
        """
        context, theory = self.context, self.theory
        for k, text in enumerate(context.units):
            theory.unit(text, self._hypothesis("unit", k, text))
        for k, text in enumerate(context.relations):
            theory.relation(text, self._hypothesis("relation", k, text))
        if context.rates is not None:
            rates = {**dict.fromkeys(context.generators, "0"), **context.rates}
            known = {name: text for name, text in rates.items() if text != "?"}
            for name, text in known.items():
                moving, still = f"rate_{self.words[name]} X H", f"({self.words[name]} X) t"
                proof = moving if name in self.moving else f"fun t => is_derive_const {still}"
                theory.rate(name, text, proof)
            read = {name: theory.ring.read(text) for name, text in known.items()}
            theory.ring.rates = {**dict.fromkeys(context.generators), **read}
        theory.define(*context.definitions)
        for k, text in enumerate(context.nonnegative):
            theory.sign(text, self._hypothesis("sign", k, text))

    def _hypothesis(self, kind: str, k: int, text: str) -> str:
        return f"fun t => {kind}_{k} X H{' t' if self.moves(text) else ''}"

    @property
    def name(self) -> str:
        """The name of the context and of its file."""
        return self.context.name

    @property
    def dynamic(self) -> bool:
        """True if quantities of the context may change in time."""
        return self.context.rates is not None

    @property
    def t(self) -> str:
        """The Coq argument " t" for the time, or "" if the context has no time."""
        return " t" if self.dynamic else ""

    def moves(self, text: str) -> bool:
        """Return whether an expression depends on time."""
        return bool(self.moving & {*names_in(parse(text))})

    def say(self, name: str, names: str = "X", module: str = "") -> str:
        """Return the Coq term of a quantity.

        `names` is the Coq record that contains the quantity.
        `module` is the prefix by which another file refers to this one.
        """
        return f"{module}{self.words[name]} {names}{' t' if name in self.moving else ''}"

    def real(self, tree: Tree) -> str:
        """Return an expression as a Coq term of type R."""
        return real(tree, self.say)

    def write(self, *lines: Line) -> None:
        """Append a block of lines to the file.

        A function among the lines is called when the file is written.
        """
        self.blocks.append(lines)

    def model(self, name: str) -> Model:
        """Return the exported proof that this context satisfies another's hypotheses.

        Raises NotExportedError if there is none.
        """
        if name not in self.models:
            raise NotExportedError(f"that this is a model of {name} is not exported")
        return self.models[name]

    # --- the text of the file

    def text(self) -> str:
        """Return the whole Coq file."""
        imports = [f"From Rigidsym.contexts Require {name}." for name in sorted(self.uses)]
        head = ["From Rigidsym Require Import prelude.", *imports]
        blocks = [
            "\n".join(x if isinstance(x, str) else x() for x in lines) for lines in self.blocks
        ]
        return "\n\n".join(["\n".join(head), *self._head(), *blocks]) + "\n"

    def _head(self) -> Iterable[str]:
        fields = []
        for name in self.context.generators:
            kind = "R -> R" if name in self.moving else "R"
            fields.append(f"  {self.words[name]} : {kind}{comment(self.context.reading.get(name))}")
        yield "(* The quantities. *)\nRecord names := name {\n" + ";\n".join(fields) + "\n}."
        definitions = [name for name in self.theory.names if name in self.theory.texts]
        if definitions:
            yield "(* Abbreviations. *)\n" + "\n".join(map(self._definition, definitions))
        fields = [
            f"  {key} : {'forall t : R, ' if moves else ''}{claim}"
            for key, moves, claim in self.hypotheses()
        ]
        body = ";\n".join(fields) or "  nothing_supposed : True"
        record = f"Record holds (X : names) : Prop := suppose {{\n{body}\n}}."
        yield f"(* What is supposed of them. *)\n{record}"
        atoms = "; ".join(map(self.say, self.theory.names))
        atoms = f"Definition atoms (X : names) (t : R) : list R := [{atoms}]."
        yield f"(* All names, for the prelude. *)\n{atoms}"
        claim = "forall (X : names) (H : holds X) (more : R -> list R),\n  " + sound("more t")
        yield known("", self.theory, "nothing", claim, "nothing_sound _")

    def _definition(self, name: str) -> str:
        time = " (t : R)" if name in self.moving else ""
        body = self.real(self.theory.texts[name])
        note = comment(self.context.reading.get(name))
        return f"Definition {self.words[name]} (X : names){time} : R := {body}.{note}"

    def hypotheses(self, names: str = "X", module: str = "") -> Iterable[tuple[str, bool, str]]:
        """Yield each hypothesis of the context as a field of the Coq record `holds`.

        A field has a name, whether it holds at every time t, and a claim.
        """
        kinds = (
            ("unit", "units", "{} <> 0"),
            ("relation", "relations", "{} = 0"),
            ("sign", "nonnegative", "0 <= {}"),
        )

        def say(name: str) -> str:
            return self.say(name, names, module)

        for kind, part, form in kinds:
            for k, text in enumerate(getattr(self.context, part)):
                yield f"{kind}_{k}", self.moves(text), form.format(real(parse(text), say))
        for name in self.rated():
            rate = real(parse((self.context.rates or {})[name]), say)
            word = self.words[name]
            yield f"rate_{word}", True, f"is_derive ({module}{word} {names}) t ({rate})"

    def rated(self) -> list[str]:
        """Return the names of quantities whose time derivative is known and not zero."""
        return [name for name, text in (self.context.rates or {}).items() if text not in ("0", "?")]

    # --- other contexts

    def qualified(self, other: "Chapter", word: str) -> str:
        """Return a Coq name from another context's file with its module prefix."""
        self.uses.add(other.name)
        return f"{other.name}.{word}"

    def record(self, other: "Chapter", values: dict[str, str]) -> str:
        """Return a Coq record that gives values to another context's quantities."""
        rows = [
            f"{self.qualified(other, other.words[name])} := {value}"
            for name, value in values.items()
        ]
        return "{| " + "; ".join(rows) + " |}"


def comment(text: str | None) -> str:
    """Return a text as a Coq comment, or an empty string if there is no text."""
    return f" (* {text.replace('(*', '( *').replace('*)', '* )')} *)" if text else ""


def sound(more: str) -> str:
    """Return the start of the Coq proposition that a theory is sound.

    The theory's name has to be appended.  The theory is about all names of the context and about
    the values `more`.
    """
    return f"sound (fun t => atoms X t ++ {more})"


def known(suffix: str, theory: Theory, start: str, claim: str, before: str) -> str:
    """Return Coq commands that build a theory from its steps and prove it sound.

    `claim` is the proposition without the theory, `before` proves it for the theory `start`.
    """
    steps, result = f"steps{suffix}", f"theory{suffix}"
    rows = ";\n  ".join(theory.steps)
    intros = "intros; " if claim.startswith("forall") else ""
    given = (
        "".join(f"(conj ({proof})\n    " for proof in theory.given) + "I" + ")" * len(theory.given)
    )
    return "\n".join(
        (
            f"Definition {steps} : list step := [\n  {rows}\n].",
            f"Definition {result} := Eval vm_compute in",
            f"  match run {start} {steps} with Some found => found | None => nothing end.",
            f"Lemma runs{suffix} : run {start} {steps} = Some {result}.",
            f"Proof. vm_cast_no_check (eq_refl (Some {result})). Qed.",
            f"Lemma known{suffix} : {claim} {result}.",
            "Proof.",
            f"  {intros}apply (run_sound _ {steps} {start} {result} ({before}) runs{suffix}).",
            f"  cbv [all_given given {steps}]; exact {given}.",
            "Qed.",
        )
    )


def claims_list(name: str, rows: Sequence[str], kind: str = "certified") -> str:
    """Return the Coq definition of a list of claims with their cofactors."""
    return f"Definition {name} : list {kind} := [\n  " + ";\n  ".join(rows) + "\n]."


def path(proof: str, k: int, count: int) -> str:
    """Return the Coq term that projects a proof of a conjunction to its k-th conjunct.

    `proof` proves all `count` conjuncts, and `k` begins at 0.
    """
    for _ in range(k):
        proof = f"(proj2 {proof})"
    return f"(proj1 {proof})" if k < count - 1 else proof
