"""What a printed tree means in a context, by a vocabulary: real texts that the kernel reads.

Roots and functions of a time have names in the context.  That a name is what the print has there is
asked with the statement: its square is what stands under the root, and sn, cn, dn, am and Pi have
the derivatives that the printed argument and parameter give them.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum

from rigidsym.language.expression import Call, Expression, Name, Number, Operation, parse, to_text
from rigidsym.proof.paper.printed.tree import PrintError
from rigidsym.proof.paper.printed.values import (
    IDENTITY,
    ONE,
    ZERO,
    Complex,
    Matrix,
    Value,
    add,
    divide,
    multiply,
    negative,
    over,
    power,
    subtract,
)


class Second(StrEnum):
    """What the second argument of an elliptic function can be."""

    PARAMETER = "parameter"
    MODULUS = "modulus"


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """What the print's words are called in a context.

    `words` gives texts for what the print writes so (a name, or any expression); `roots` names its
    square roots in order, `jacobi` the sn, cn and dn of its elliptic functions in order, and
    `arguments` those of which they are, where the context says; `pm` is the sign that it leaves
    open, `when` what its condition says is not negative.  `second` says what the second argument
    of sn is, `moves` whether the first grows with time, or is that of an instant.
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
    """Reads trees by one vocabulary; `asked` is what they take for granted, as equations."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.vocabulary = vocabulary
        self.asked: list[tuple[Expression, Expression]] = []
        self.meant = {word: in_names(text) for word, text in vocabulary.words.items()}
        self._roots: dict[str, Complex] = {}
        self._triples: dict[str, Triple] = {}

    def value(self, tree: Expression) -> Value:
        """The meaning of a tree; PrintError where the vocabulary has none."""
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
        """The meaning of what has to be a number."""
        found = self.value(tree)
        if isinstance(found, Matrix):
            raise PrintError(f"{to_text(tree)}: a matrix, where a number is due")
        return found

    def real(self, tree: Expression) -> Expression:
        """The meaning of what has to be real."""
        found = self.number(tree)
        if found.imag != ZERO:
            raise PrintError(f"{to_text(tree)}: complex, where a real number is due")
        return found.real

    def power(self, base: Value, exponent: Expression) -> Value:
        """A whole power; below zero, of a matrix with determinant one."""
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
        """The meaning of a function of trees."""
        match function, arguments:
            case "neg", (inner,):
                return multiply(Complex(negative(ONE)), self.value(inner)).each(_tidy)
            case "pm", (inner,):
                return multiply(Complex(parse(self.vocabulary.pm)), self.value(inner))
            case "at", (inner, Name("t")):
                return self.value(inner)
            case "D", (inner,):
                return self.value(inner).each(rate)
            case "d", (Name("t"),):
                return Complex(ONE)
            case "d", (inner,):
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
        """exp(phi A) = cos(phi/2) + 2 sin(phi/2) A, where the square of A is -1/4."""
        half = Operation("/", angle, Number(2))
        cosine, sine = (self.number(Call(name, (half,))) for name in ("cos", "sin"))
        matrix = self.value(generator)
        quarter = Complex(over(negative(ONE), Number(4)))
        self.ask(multiply(matrix, matrix), IDENTITY.scaled(quarter))
        return add(cosine, multiply(multiply(Complex(Number(2)), sine), matrix))

    def root(self, radicand: Expression) -> Complex:
        """What a square root is called: its square is asked to be what is printed."""
        text = to_text(radicand)
        if text not in self._roots:
            if len(self._roots) == len(self.vocabulary.roots):
                raise PrintError(f"sqrt({text}): the vocabulary has no word for it")
            root = self._roots[text] = _number(self.vocabulary.roots[len(self._roots)])
            self.ask(squared(root), self.number(radicand))
        return self._roots[text]

    def triple(self, argument: Expression, parameter: Expression) -> Triple:
        """What sn, cn and dn are called: asked to move as argument and parameter say."""
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
        """Ask that dn^2 = 1 - m sn^2, with the m that is printed."""
        m = self.number(second)
        if self.vocabulary.second == Second.MODULUS:
            m = squared(m)
        self.ask(squared(d) + m * squared(s), Complex(ONE))

    def amplitude(self, argument: Expression, parameter: Expression) -> Complex:
        """The angle whose sine is sn: asked to grow as dn and the argument say."""
        _, _, d = self.triple(argument, parameter)
        angle = Complex(Name("theta"))
        self.ask(angle.each(rate), self.number(argument).each(rate) * d)
        return angle

    def third_kind(self, n: Expression, angle: Expression, parameter: Expression) -> Complex:
        """The integral of 1/((1 - n sn^2) dn) over the angle: asked to be that."""
        s, _, d = map(_number, self.vocabulary.jacobi[0])
        self.complement(s, d, parameter)
        integral = Complex(Name("Pi"))
        below = (Complex(ONE) - self.number(n) * squared(s)) * d
        self.ask(integral.each(rate) * below, self.number(angle).each(rate))
        return integral

    def inverse(self, value: Expression, parameter: Expression) -> Value:
        """An argument at which sn is what is printed, for the parameter that is printed."""
        s, _, d = map(_number, self.vocabulary.jacobi[0])
        self.ask(s, self.number(value))
        self.complement(s, d, parameter)
        return self.meant["C_i"]

    def condition(self, left: Expression, relation: str, right: Expression) -> None:
        """Ask that an inequality says of a quantity that it is not negative, or positive."""
        if self.vocabulary.when:
            x, y = map(self._size, (left, right))
            over = x - y if relation in (">", ">=") else y - x
            self.ask(over, _number(self.vocabulary.when))

    def _size(self, tree: Expression) -> Complex:
        """A side of an inequality; of absolute values and of numbers beside them, the square."""
        match tree:
            case Call("abs", (inner,)):
                return Complex(self.number(inner).square())
            case Number():
                return squared(Complex(tree))
        return self.number(tree)

    def ask(self, left: Value, right: Value) -> None:
        """Let two values be the same."""
        self.asked += [(x, y) for x, y in zip(left, right, strict=True) if x != y]


def rate(expression: Expression) -> Expression:
    """D of an expression, of a number 0."""
    return ZERO if isinstance(expression, Number) else Call("D", (expression,))


def squared(number: Complex) -> Complex:
    """The square of a number."""
    if number.imag == ZERO:
        return Complex(Operation("**", number.real, Number(2)))
    return number * number


def _tidy(expression: Expression) -> Expression:
    """-1 x as -x."""
    match expression:
        case Operation("*", Call("neg", (Number(1),)), right):
            return negative(right)
        case Call("neg", (Number(1),)):
            return expression
    return expression


class _Plain(Interpreter):
    """The texts of a vocabulary: every name is one of the context's."""

    def value(self, tree: Expression) -> Value:
        if isinstance(tree, Name) and tree.name != "imaginary":
            return Complex(tree)
        return super().value(tree)


def in_names(text: str) -> Value:
    """The meaning of a text in a context's own names."""
    return _Plain(PLAIN).value(parse(text))


def _number(text: str) -> Complex:
    return _Plain(PLAIN).number(parse(text))
