"""A display in the language of a context: what it defines there, and the equations it states."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from rigidsym.language.expression import Call, Expression, Name, Number, Operation, to_text
from rigidsym.proof.paper.printed.interpreter import Interpreter, Vocabulary, rate
from rigidsym.proof.paper.printed.tree import Display, PrintError, Statement
from rigidsym.proof.paper.printed.values import (
    ZERO,
    Complex,
    Matrix,
    Value,
    add,
    alike,
    multiply,
    subtract,
)

EQUALITIES = ("=", "<->")
ORDERS = ("<", "<=", ">", ">=")


@dataclass(frozen=True, slots=True)
class Translation:
    """Texts of a context's definitions, and the components of equations, left and right."""

    definitions: Mapping[str, str]
    equations: tuple[tuple[str, str], ...]


def translate(
    displays: Iterable[Display],
    vocabulary: Vocabulary,
    defines: Mapping[str, str],
    *,
    differentiated: bool = False,
) -> Translation:
    """The meaning of displays by one vocabulary; raises PrintError where it has no word.

    `defines` names what the displays define, as printed and in the context; a matrix is put in
    where it is used.  All else is stated: `differentiated` states that both sides grow alike.
    """
    displays, interpreter = list(displays), Interpreter(vocabulary)
    lines = [pair for display in displays for pair in _equations(display)]
    for name, meaning in defines.items():
        interpreter.meant[name] = Complex(Name(meaning))
    _check_defined(displays, defines)
    definitions: dict[str, str] = {}
    for left, right in lines:
        if defined(left) in defines:
            found = interpreter.value(right)
            if isinstance(found, Matrix) or found.imag != ZERO:
                interpreter.meant[defined(left)] = found
            else:
                definitions[defines[defined(left)]] = to_text(interpreter.real(right))
    stated: list[tuple[Expression, Expression]] = []
    meaning = growth if differentiated else Interpreter.value
    for left, right in lines:
        if defined(left) not in defines:
            sides = alike(meaning(interpreter, left), meaning(interpreter, right))
            stated += [pair for pair in zip(*sides, strict=True) if pair[0] != pair[1]]
    for mentioned in _mentioned(displays):
        interpreter.value(mentioned)
    for left, relation, right in _inequalities(displays):
        interpreter.condition(left, relation, right)
    texts = [(to_text(x), to_text(y)) for x, y in (*stated, *interpreter.asked)]
    return Translation(definitions, tuple(dict.fromkeys(texts)))


def _equations(display: Display) -> Iterator[tuple[Expression, Expression]]:
    """The two sides of every equation in a display, chains taken apart."""
    for piece in display:
        if isinstance(piece, Statement):
            neighbours = zip(piece.sides, piece.relations, piece.sides[1:], strict=False)
            yield from ((x, y) for x, relation, y in neighbours if relation in EQUALITIES)


def _check_defined(displays: Iterable[Display], defines: Mapping[str, str]) -> None:
    """Refuse displays that leave something undefined, or define it twice."""
    found = [[defined(left) for left, _ in _equations(display)] for display in displays]
    for name in defines:
        times = [names.count(name) for names in found]
        if not any(times) or max(times) > 1:
            raise PrintError(f"{name}: defined {max(times)} times")


def _mentioned(displays: Iterable[Display]) -> Iterator[Expression]:
    """What a text speaks of without saying anything of it."""
    for piece in (piece for display in displays for piece in display):
        if isinstance(piece, Statement) and not piece.relations:
            yield piece.sides[0]


def _inequalities(displays: Iterable[Display]) -> Iterator[tuple[Expression, str, Expression]]:
    """The conditions that displays put as inequalities."""
    for piece in (piece for display in displays for piece in display):
        if isinstance(piece, Statement) and piece.relations[:1] and piece.relations[0] in ORDERS:
            yield piece.sides[0], piece.relations[0], piece.sides[1]


def defined(left: Expression) -> str:
    """What a left side defines: a name, at any time."""
    match left:
        case Call("at", (inner, Name("t"))):
            return to_text(inner)
    return to_text(left)


def growth(interpreter: Interpreter, tree: Expression) -> Value:
    """The time derivative of what is printed, of an integral its integrand.

    What stands before an integral is asked to be constant.
    """
    known = interpreter.meant.get(to_text(Call("D", (tree,))))
    if known is not None:
        return known
    match tree:
        case Call("at", (inner, Name("t"))):
            return growth(interpreter, inner)
        case Call("integral", (integrand,)):
            return interpreter.value(integrand)
        case Operation("+", left, right):
            return add(growth(interpreter, left), growth(interpreter, right))
        case Operation("-", left, right):
            return subtract(growth(interpreter, left), growth(interpreter, right))
        case Operation("*", factor, Call("integral", (integrand,))):
            constant = interpreter.value(factor)
            interpreter.ask(constant.each(rate), constant.each(lambda _: Number(0)))
            return multiply(constant, interpreter.value(integrand))
    return interpreter.value(tree).each(rate)
