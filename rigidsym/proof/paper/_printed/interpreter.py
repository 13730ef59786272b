"""Translation of printed formulas into definitions and equations of a context.

A vocabulary maps printed words to names of the context, also roots and functions of the time.  The
properties that such a name must have become additional equations: the square of a root is its
radicand, and sn, cn, dn, am and Pi have the time derivatives that the printed argument and
parameter imply.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from functools import lru_cache

from rigidsym.language._expression import Call, Expression, Name, Number, Operation, parse, to_text
from rigidsym.proof.paper._printed.parser import Display, PrintError, Statement
from rigidsym.proof.paper._printed.values import (
    IDENTITY,
    ONE,
    ZERO,
    Complex,
    Matrix,
    Value,
    add,
    alike,
    divide,
    multiply,
    negative,
    over,
    power,
    subtract,
)


class Second(StrEnum):
    """Meaning of the second argument of an elliptic function."""

    PARAMETER = "parameter"
    MODULUS = "modulus"


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """Translation table from printed symbols to the names of a context.

    `words` maps printed names or expressions to texts; `roots` names the printed square roots in
    order, `jacobi` the sn, cn and dn of the printed elliptic functions in order, and `arguments`
    their arguments, where the context has them; `pm` is the sign for a printed +-, `when` a
    quantity that a printed condition says is not negative.  `second` says whether the second
    argument of sn is the parameter, `moves` whether the first grows with time.
    """

    words: Mapping[str, str] = field(default_factory=dict)
    roots: Sequence[str] = ()
    jacobi: Sequence[tuple[str, str, str]] = ()
    pm: str = "1"
    arguments: Sequence[str] = ()
    when: str = ""
    second: Second = Second.PARAMETER
    moves: bool = True


Triple = tuple[Complex, Complex, Complex]
PLAIN = Vocabulary()
_BINARY: dict[str, Callable[[Value, Value], Value]] = {
    "+": add,
    "-": subtract,
    "*": multiply,
    "/": divide,
}


class Interpreter:
    """Evaluator of printed formulas for a given translation table.

    `asked` collects the equations that the results rely on.
    """

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.vocabulary = vocabulary
        self.asked: list[tuple[Expression, Expression]] = []
        self.meant = {word: in_names(text) for word, text in vocabulary.words.items()}
        self._roots: dict[str, Complex] = {}
        self._triples: dict[str, Triple] = {}

    def value(self, tree: Expression) -> Value:
        """Return the value of a formula.

        Raises PrintError if the vocabulary lacks a word for it.
        """
        known = self.meant.get(to_text(tree))
        if known is not None:
            return known
        match tree:
            case Number():
                return Complex(tree)
            case Name("imaginary"):
                return Complex(ZERO, ONE)
            case Operation("**", Call("abs", (inner,)), Number(2)):
                return Complex(self.number(inner).square())
            case Operation("**", base, exponent):
                return self.power(self.value(base), exponent)
            case Operation(operator, left, right):
                return _BINARY[operator](self.value(left), self.value(right))
            case Call(function, arguments):
                return self.call(function, arguments)
        raise PrintError(f"{to_text(tree)}: the vocabulary has no word for it")

    def number(self, tree: Expression) -> Complex:
        """Return the value of a formula as a complex number.

        Raises PrintError if it is a matrix.
        """
        found = self.value(tree)
        if isinstance(found, Matrix):
            raise PrintError(f"{to_text(tree)}: a matrix, where a number is due")
        return found

    def power(self, base: Value, exponent: Expression) -> Value:
        """Return an integer power of a number or matrix.

        A negative power of a matrix requires determinant one.
        """
        match exponent:
            case Name("dagger") if isinstance(base, Matrix):
                return base.dagger()
            case Number(whole):
                return power(base, whole)
            case Call("neg", (Number(whole),)):
                if isinstance(base, Matrix):
                    self.ask(base.determinant(), Complex(ONE))
                return power(base, -whole)
        raise PrintError(f"{to_text(exponent)}: no whole exponent")

    def call(self, function: str, arguments: tuple[Expression, ...]) -> Value:
        """Return the value of a printed function call."""
        match function, arguments:
            case "neg", (inner,):
                return self.value(inner).each(negative)
            case "pm", (inner,):
                return multiply(Complex(parse(self.vocabulary.pm)), self.value(inner))
            case "at", (inner, Name("t")):
                return self.value(inner)
            case "d", (Name("t"),):
                return Complex(ONE)
            case (("D" | "d"), (inner,)):
                return self.value(inner).each(rate)
            case "matrix", entries:
                a, b, c, d = map(self.number, entries)
                return Matrix((a, b, c, d))
            case "bracket", (left, right):
                x, y = self.value(left), self.value(right)
                return subtract(multiply(x, y), multiply(y, x))
            case "det", (inner,):
                found = self.value(inner)
                return found.determinant() if isinstance(found, Matrix) else found
            case "exp", (Operation("*", angle, generator),):
                return self.exponential(angle, generator)
            case "sqrt", (radicand,):
                return self.root(radicand)
            case (("sn" | "cn" | "dn"), (argument, parameter)):
                return self.triple(argument, parameter)[("sn", "cn", "dn").index(function)]
            case "Pi", (characteristic, angle, parameter):
                return self.third_kind(characteristic, angle, parameter)
            case "am", (argument, parameter):
                return self.amplitude(argument, parameter)
            case "arcsn", (value, parameter):
                return self.inverse(value, parameter)
        raise PrintError(f"{to_text(Call(function, arguments))}: the vocabulary has no word for it")

    def exponential(self, angle: Expression, generator: Expression) -> Value:
        """Return the matrix exponential exp(phi A).

        It is cos(phi/2) + 2 sin(phi/2) A.  This requires that A^2 = -1/4.
        """
        half = Operation("/", angle, Number(2))
        cosine, sine = (self.number(Call(name, (half,))) for name in ("cos", "sin"))
        matrix = self.value(generator)
        quarter = Complex(over(negative(ONE), Number(4)))
        self.ask(multiply(matrix, matrix), IDENTITY.scaled(quarter))
        return add(cosine, multiply(multiply(Complex(Number(2)), sine), matrix))

    def root(self, radicand: Expression) -> Complex:
        """Return the context's name for a printed square root.

        This requires that its square is the radicand.
        """
        text = to_text(radicand)
        if text not in self._roots:
            if len(self._roots) == len(self.vocabulary.roots):
                raise PrintError(f"sqrt({text}): the vocabulary has no word for it")
            root = self._roots[text] = _number(self.vocabulary.roots[len(self._roots)])
            self.ask(squared(root), self.number(radicand))
        return self._roots[text]

    def triple(self, argument: Expression, parameter: Expression) -> Triple:
        """Return the context's names for sn, cn and dn of a printed argument.

        This requires their algebraic relations and time derivatives.
        """
        text = f"{to_text(argument)} | {to_text(parameter)}"
        if text not in self._triples:
            if len(self._triples) == len(self.vocabulary.jacobi):
                raise PrintError(f"sn({text}): the vocabulary has no word for it")
            place = len(self._triples)
            s, c, d = map(_number, self.vocabulary.jacobi[place])
            if self.vocabulary.arguments:
                self.ask(self.number(argument), _number(self.vocabulary.arguments[place]))
            self._triples[text] = (s, c, d)
            self.ask(squared(c) + squared(s), Complex(ONE))
            self.complement(s, d, parameter)
            speed = self.number(argument).each(rate)
            if self.vocabulary.moves:
                self.ask(s.each(rate), speed * (c * d))
        return self._triples[text]

    def complement(self, s: Complex, d: Complex, second: Expression) -> None:
        """Add the requirement dn^2 = 1 - m sn^2 for the printed parameter m."""
        m = self.number(second)
        if self.vocabulary.second == Second.MODULUS:
            m = squared(m)
        self.ask(squared(d) + m * squared(s), Complex(ONE))

    def amplitude(self, argument: Expression, parameter: Expression) -> Complex:
        """Return the context's name for the Jacobi amplitude, theta.

        This requires that its time derivative is dn times that of the argument.
        """
        _, _, d = self.triple(argument, parameter)
        angle = Complex(Name("theta"))
        self.ask(angle.each(rate), self.number(argument).each(rate) * d)
        return angle

    def third_kind(self, n: Expression, angle: Expression, parameter: Expression) -> Complex:
        """Return the context's name for the elliptic integral of the third kind, Pi.

        This requires the time derivative of the integral of 1/((1 - n sn^2) dn).
        """
        s, _, d = map(_number, self.vocabulary.jacobi[0])
        self.complement(s, d, parameter)
        integral = Complex(Name("Pi"))
        below = (Complex(ONE) - self.number(n) * squared(s)) * d
        self.ask(integral.each(rate) * below, self.number(angle).each(rate))
        return integral

    def inverse(self, value: Expression, parameter: Expression) -> Value:
        """Return the context's name for the inverse of sn.

        This requires that sn has the printed value and parameter.
        """
        s, _, d = map(_number, self.vocabulary.jacobi[0])
        self.ask(s, self.number(value))
        self.complement(s, d, parameter)
        return self.meant["C_i"]

    def condition(self, left: Expression, relation: str, right: Expression) -> None:
        """Require that a printed inequality states `when` >= 0, the condition in the vocabulary.

        The quantity `when` is then the larger side minus the smaller one.
        """
        if self.vocabulary.when:
            x, y = map(self._size, (left, right))
            over = x - y if relation in (">", ">=") else y - x
            self.ask(over, _number(self.vocabulary.when))

    def _size(self, tree: Expression) -> Complex:
        """Return one side of an inequality, squared if it is an absolute value or a number."""
        match tree:
            case Call("abs", (inner,)):
                return Complex(self.number(inner).square())
            case Number():
                return squared(Complex(tree))
        return self.number(tree)

    def ask(self, left: Value, right: Value) -> None:
        """Require that two values are equal, component by component."""
        self.asked += [(x, y) for x, y in zip(left, right, strict=True) if x != y]


def rate(expression: Expression) -> Expression:
    """Return the unevaluated time derivative D(...) of an expression.

    That of a number is 0.
    """
    return ZERO if isinstance(expression, Number) else Call("D", (expression,))


def squared(number: Complex) -> Complex:
    """Return the square of a complex number."""
    if number.imag == ZERO:
        return Complex(Operation("**", number.real, Number(2)))
    return number * number


class _Plain(Interpreter):
    """Interpreter of formulas that already use a context's own names."""

    def value(self, tree: Expression) -> Value:
        if isinstance(tree, Name) and tree.name != "imaginary":
            return Complex(tree)
        return super().value(tree)


@lru_cache(maxsize=1024)
def in_names(text: str) -> Value:
    """Evaluate a formula that uses a context's own names."""
    return _Plain(PLAIN).value(parse(text))


def _number(text: str) -> Complex:
    return _Plain(PLAIN).number(parse(text))


EQUALITIES = ("=", "<->")
ORDERS = ("<", "<=", ">", ">=")


@dataclass(frozen=True, slots=True)
class Translation:
    """Definitions and equations that result from translating printed formulas.

    The definitions are expressions by name, the equations are pairs of expressions.
    """

    definitions: Mapping[str, str]
    equations: tuple[tuple[str, str], ...]


def translate(
    displays: Iterable[Display],
    vocabulary: Vocabulary,
    defines: Mapping[str, str],
    *,
    differentiated: bool = False,
) -> Translation:
    """Translate printed formulas to definitions and equations of a context.

    `defines` maps printed names that the displays define to the context's names; a matrix is
    substituted where it is used.  All other equations are stated, with `differentiated` for the
    time derivatives.  Raises PrintError if the vocabulary lacks a word.
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
                definitions[defines[defined(left)]] = to_text(found.real)
    stated: list[tuple[Expression, Expression]] = []
    meaning = derivative if differentiated else Interpreter.value
    for left, right in lines:
        if defined(left) not in defines:
            sides = alike(meaning(interpreter, left), meaning(interpreter, right))
            stated += [pair for pair in zip(*sides, strict=True) if pair[0] != pair[1]]
    pieces = [x for display in displays for x in display if isinstance(x, Statement)]
    for piece in pieces:
        if not piece.relations:  # a quantity that the text mentions
            interpreter.value(piece.sides[0])
    for piece in pieces:
        if piece.relations[:1] and piece.relations[0] in ORDERS:
            interpreter.condition(piece.sides[0], piece.relations[0], piece.sides[1])
    texts = [(to_text(x), to_text(y)) for x, y in (*stated, *interpreter.asked)]
    return Translation(definitions, tuple(dict.fromkeys(texts)))


def _equations(display: Display) -> Iterator[tuple[Expression, Expression]]:
    """Yield both sides of every equation in a displayed formula.

    a = b = c is two equations.
    """
    for piece in display:
        if isinstance(piece, Statement):
            neighbours = zip(piece.sides, piece.relations, piece.sides[1:], strict=False)
            yield from ((x, y) for x, relation, y in neighbours if relation in EQUALITIES)


def _check_defined(displays: Iterable[Display], defines: Mapping[str, str]) -> None:
    """Raise PrintError for a name that is undefined or defined twice.

    Twice means twice in one displayed formula.
    """
    found = [[defined(left) for left, _ in _equations(display)] for display in displays]
    for name in defines:
        times = [names.count(name) for names in found]
        if not any(times) or max(times) > 1:
            raise PrintError(f"{name}: defined {max(times)} times")


def defined(left: Expression) -> str:
    """Return the name on the left side of a definition.

    Its argument (t) is left out.
    """
    match left:
        case Call("at", (inner, Name("t"))):
            return to_text(inner)
    return to_text(left)


def derivative(interpreter: Interpreter, tree: Expression) -> Value:
    """Return the time derivative of a formula.

    That of an integral is its integrand.
    A factor before an integral is required to be constant.
    """
    known = interpreter.meant.get(to_text(Call("D", (tree,))))
    if known is not None:
        return known
    match tree:
        case Call("at", (inner, Name("t"))):
            return derivative(interpreter, inner)
        case Call("integral", (integrand,)):
            return interpreter.value(integrand)
        case Operation("+", left, right):
            return add(derivative(interpreter, left), derivative(interpreter, right))
        case Operation("-", left, right):
            return subtract(derivative(interpreter, left), derivative(interpreter, right))
        case Operation("*", factor, Call("integral", (integrand,))):
            constant = interpreter.value(factor)
            interpreter.ask(constant.each(rate), constant.each(lambda _: Number(0)))
            return multiply(constant, interpreter.value(integrand))
    return interpreter.value(tree).each(rate)
