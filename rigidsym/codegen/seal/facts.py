"""A formula that names what the ledger has it from is that, under the names of `meanings`."""

from collections.abc import Iterable, Iterator, Mapping

from rigidsym.codegen.forms import THETA
from rigidsym.codegen.ir import Function, Let
from rigidsym.codegen.seal import meanings
from rigidsym.codegen.seal.claims import DIFFERS, Claim
from rigidsym.codegen.seal.meanings import Meanings
from rigidsym.codegen.special_functions import landen
from rigidsym.errors import InputError
from rigidsym.language.expression import Expression, Name, children, parse, put, rebuild
from rigidsym.solution import Formula, Solution


def claims(solution: Solution, functions: Iterable[Function], form: str = THETA) -> Iterator[Claim]:
    """Each formula that names a fact, and the fact."""
    ledger, names = by_fact(solution), meanings.OF[form]
    for function in functions:
        parts = names.parts.get(function.name, ())
        proved = _proved(solution, function.name, names) | {*parts}
        for let in function.formulas:
            _check_equations(function.name, let, ledger)
            if not let.facts and let.targets[0] in proved:
                raise InputError(function.name, let, "does not say what it comes from")
            for fact in let.facts:
                if let.targets[0] not in parts:
                    yield _claim(function.name, let, ledger[fact], names)


def by_fact(solution: Solution) -> dict[str, Formula]:
    """The formulas of all sequences by what the ledger has them from."""
    return {formula.fact: formula for every in solution.sequences.values() for formula in every}


def _proved(solution: Solution, place: str, names: Meanings) -> set[str]:
    """What the names of the ledger that a function may set are called there."""
    if place == "_ladder":
        return {f"K{n}" for n in range(landen.STEPS)}
    found = set()
    for sequence in names.made_from.get(place, ()):
        for formula in solution.sequences[sequence]:
            if not formula.is_reading:
                meaning = names.by_context.get((place, formula.context), {})
                found.add(meaning.get(formula.name, formula.name))
    return found


def _check_equations(place: str, let: Let, ledger: Mapping[str, Formula]) -> None:
    """A line names equations of the paper by facts alone that carry them."""
    for fact in let.facts:
        if fact not in ledger:
            raise InputError(place, let, f"{fact}: the ledger has no such formula")
    carried = {equation for fact in let.facts for equation in ledger[fact].source}
    for source in let.source:
        if source[0].isdigit() and source not in carried:
            raise InputError(place, let, f"({source}): no fact of this line carries it")


def _claim(place: str, let: Let, formula: Formula, names: Meanings) -> Claim:
    meaning = _meaning(place, let, formula, names)
    said = names.values.get((place, formula.context), {})
    values = {parse(call): parse(value) for call, value in said.items()}
    if (put(Name(formula.name), meaning),) != tuple(map(Name, let.targets)):
        raise InputError(place, let, f"{formula.fact}: {DIFFERS}")
    derived = _valued(put(formula.expression, meaning), values)
    return Claim(place, f"{formula.fact}: {let}", derived, let.expression)


def _valued(expression: Expression, values: Mapping[Expression, Expression]) -> Expression:
    """The expression with what calls of standard functions are in place of them."""
    if expression in values:
        return values[expression]
    return rebuild(expression, tuple(_valued(part, values) for part in children(expression)))


def _meaning(place: str, let: Let, formula: Formula, names: Meanings) -> Mapping[str, Expression]:
    if place == "_ladder":
        return _rung(place, let)
    said = names.by_context.get((place, formula.context), {})
    if (place, formula.context) in names.letters:
        said = meanings.level(let.targets[0], formula.name, names.letters[place, formula.context])
    return {name: parse(text) for name, text in said.items()}


def _rung(place: str, let: Let) -> Mapping[str, Expression]:
    """K on a step of the ladder, from the step below."""
    for n in range(landen.STEPS):
        if let.targets == (f"K{n}",):
            means = {"K": f"K{n}", "K_next": f"K{n + 1}", "k_next": f"k{n + 1}"}
            return {name: Name(text) for name, text in means.items()}
    raise InputError(place, let, "is no quarter period of the ladder")
