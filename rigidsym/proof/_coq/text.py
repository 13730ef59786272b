"""Conversion of ledger expressions to Coq terms.

The terms are real numbers, or data for the checker in the prelude.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping

from sympy.polys.rings import PolyElement

from rigidsym.proof.kernel._language import Tree
from rigidsym.proof.kernel._ring import Number

# Reserved words of Coq and of the exported files.  A quantity with such a name, or with a prefix
# of theorems, gets a "_" behind it.
_WORDS = """
as at by cofix else end exists exists2 fix for forall fun if in let match mod return
then using where with Prop Set SProp Type R X H t names holds atoms steps theory runs
known sqrt is_derive Derive ex_derive Num Var Neg Add Sub Mul Div Pow Rate Generator
Define Rename Unit Relation Sign Moves Invert Differentiate Equal Derives Smooth Root
Nonnegative AtLeast Nonzero mono pw check decided carried carriage certified run nothing
sound conj proj1 proj2 eq_refl I or_introl or_intror exactly_one splits value states
all_state claim expr list nil cons app step bool true false
"""
RESERVED = frozenset(_WORDS.split())
PREFIXES = (
    "fact_",
    "as_",
    "models_",
    "claims_",
    "fields_",
    "steps_",
    "theory_",
    "runs_",
    "more_",
    "known_",
)
_OPERATORS = {"+": ("Add", 1), "-": ("Sub", 1), "*": ("Mul", 2), "/": ("Div", 2)}


def identifiers(names: Iterable[str]) -> dict[str, str]:
    """Return a Coq name for each quantity, different from all reserved words."""
    known = list(names)
    taken = {*known, *RESERVED}
    found = {}
    for name in known:
        word = name
        if name in RESERVED or name.startswith(PREFIXES):
            while word in taken:
                word += "_"
            taken.add(word)
        found[name] = word
    return found


def operands(tree: Tree) -> list[Tree]:
    """Return the direct subtrees of a syntax tree from left to right."""
    match tree:
        case int() | str():
            return []
        case ("-", argument) | ("D", "(", argument) | (argument, "**", int()):
            return [argument]
    return list(tree[::2])


def parts(tree: Tree) -> Iterator[Tree]:
    """Yield all subtrees of a syntax tree in postorder."""
    for operand in operands(tree):
        yield from parts(operand)
    yield tree


def names_in(tree: Tree) -> Iterator[str]:
    """Yield the names in a syntax tree from left to right, with repetitions."""
    return (part for part in parts(tree) if isinstance(part, str))


def divisors(tree: Tree) -> Iterator[Tree]:
    """Yield the divisors in a syntax tree, innermost first.

    Divisors that are numbers are left out.
    """
    for part in parts(tree):
        if is_chain(part) and isinstance(part, tuple):
            pairs = zip(part[1::2], part[2::2], strict=True)
            yield from (y for operator, y in pairs if operator == "/" and not isinstance(y, int))


def derivatives(tree: Tree) -> Iterator[Tree]:
    """Yield the arguments of all time derivatives D(...) in a syntax tree, innermost first."""
    yield from (part[2] for part in parts(tree) if isinstance(part, tuple) and part[0] == "D")


def is_chain(tree: Tree) -> bool:
    """Return whether a syntax tree is a chain of operations such as x + y - z or x * y / z."""
    return isinstance(tree, tuple) and len(tree) > 2 and tree[1] in _OPERATORS


def renamed(tree: Tree, names: Mapping[str, str]) -> Tree:
    """Return a syntax tree with some names replaced."""
    match tree:
        case int():
            return tree
        case str():
            return names.get(tree, tree)
        case ("D", "(", argument):
            return ("D", "(", renamed(argument, names))
        case ("-", argument):
            return ("-", renamed(argument, names))
        case (base, "**", int(exponent)):
            return (renamed(base, names), "**", exponent)
    return tuple(renamed(x, names) if k % 2 == 0 else x for k, x in enumerate(tree))


def real(tree: Tree, say: Callable[[str], str], level: int = 0) -> str:
    """Return a syntax tree as a Coq term of type R.

    `say` returns the term of a name, `level` is how tightly the surrounding operator binds.
    """
    match tree:
        case int():
            return str(tree)
        case str():
            return _in_brackets(say(tree), " " in say(tree) and level > 2)
        case ("-", argument):
            return _in_brackets(f"- {real(argument, say, 3)}", level > 0)
        case ("D", "(", argument):
            return _in_brackets(f"Derive (fun t : R => {real(argument, say)}) t", level > 0)
        case (base, "**", int(exponent)):
            return _in_brackets(f"{real(base, say, 3)} ^ {exponent}", level > 2)
    binds = _OPERATORS[tree[1]][1]
    text = real(tree[0], say, max(binds - 1, 1))
    for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
        text += f" {operator} {real(operand, say, binds)}"
    return _in_brackets(text, level >= binds)


def _in_brackets(text: str, needed: bool) -> str:
    return f"({text})" if needed else text


def data(tree: Tree, index: Mapping[str, int]) -> str:
    """Return a syntax tree as a Coq term of the prelude's type `expr`.

    Names become their indices in the list of atoms.
    """
    match tree:
        case int():
            return f"(Num {tree})"
        case str():
            return f"(Var {index[tree]})"
        case ("-", argument):
            return f"(Neg {data(argument, index)})"
        case ("D", "(", argument):
            return f"(Rate {data(argument, index)})"
        case (base, "**", int(exponent)):
            return f"(Pow {data(base, index)} {exponent})"
    text = data(tree[0], index)
    for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
        text = f"({_OPERATORS[operator][0]} {text} {data(operand, index)})"
    return text


def terms(polynomial: PolyElement, index: Mapping[str, int]) -> str:
    """Return a polynomial as a Coq list of its terms, in the prelude's format."""
    places = [index[str(generator)] for generator in polynomial.ring.gens]
    found = []
    for powers, number in polynomial.terms():
        factors = [f"pw {k} {power}" for k, power in zip(places, powers, strict=True) if power]
        found.append(f"mono {rational(number)} {listed(factors)}")
    return listed(found)


def rational(number: Number) -> str:
    """Return the numerator and denominator of a rational number as Coq arguments."""
    above = number.numerator
    return f"{above if above >= 0 else f'({above})'} {number.denominator}"


def listed(items: Iterable[object]) -> str:
    """Return items as a Coq list."""
    return f"[{'; '.join(map(str, items))}]"
