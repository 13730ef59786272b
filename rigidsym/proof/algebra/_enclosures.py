"""Numerical checks of cited identities at many points, by ball arithmetic.

The value of a name is the number that a point gives it, or that of its definition or its reading.
Such a reading is an expression with the functions of `FUNCTIONS`.  Jacobi's functions are computed
by inverting Legendre's F, never from theta functions, because the facts to be checked are
identities between the two.  Balls agree with a fact at a point if the ball of lhs - rhs contains
zero and is small there.

The points are those of the fact's author, and `COUNT` drawn ones.  A hash of the fact draws their
numbers from (0, 1), from near its ends, from (-10, 10), or from the integers if the certificate
says so.  If a relation connects names, it determines the last of them.  Draws that are no points
of the context, or at which a function has no value, are skipped.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from hashlib import sha256
from operator import add, mul, sub, truediv

from flint import acb, arb, ctx, fmpq

from rigidsym.proof.kernel import Context, Fact, KernelError, Ring
from rigidsym.proof.kernel._language import Tree, is_name, parse

BITS = 192
_ARITHMETIC: Mapping[Tree, Callable[[acb, acb], acb]]
_ARITHMETIC = {"+": add, "-": sub, "*": mul, "/": truediv}
STEPS = 32


def agrees(at: "Evaluation", fact: Fact) -> bool:
    """Return whether ball arithmetic confirms a fact at one point.

    The balls of lhs - rhs have to contain zero and to be small.
    Raises KernelError if a side has no value there.
    """
    gaps, small = [], _tiny(64)
    for lhs, rhs in zip(fact.lhs, fact.rhs, strict=True):
        left = at.value(lhs)
        gaps.append((left - at.value(rhs), small * (1 + left.abs_upper())))
    at.check()
    return all(gap.contains(0) and gap.abs_upper() < small for gap, small in gaps)


def rational(context: Context, point: Mapping[str, str]) -> dict[str, acb]:
    """Convert the rational coordinates of a point to balls.

    Raises KernelError for names that are not free.
    """
    known = {}
    for name, number in point.items():
        if name not in context.generators or _is_formula(context.reading.get(name, "?")):
            raise KernelError(f"a point gives {name!a}, which is not free")
        value = Ring((), {}).read(number).numerator.coeff(1)
        known[name] = acb(fmpq(int(value.numerator), int(value.denominator)))
    return known


class Evaluation:
    """Evaluation of a context's expressions at one point by ball arithmetic."""

    def __init__(self, context: Context, point: Mapping[str, acb]) -> None:
        self.context = context
        self.texts = {**context.reading, **context.definitions}
        self.known: dict[str, acb] = {"pi": acb.pi(), "I": acb(0, 1), **point}

    def check(self) -> None:
        """Raise KernelError if the point violates a hypothesis of the context.

        Only hypotheses whose names have all been evaluated are checked.
        """
        for holds, texts in (
            (lambda value: value.contains(0), self.context.relations),
            (lambda value: not value.contains(0), self.context.units),
            (lambda value: not value.real < 0, self.context.nonnegative),
        ):
            for text in texts:
                if {*names(parse(text))} <= self.known.keys() and not holds(self.value(text)):
                    raise KernelError(f"the point is not one of the context: {text}")

    def value(self, text: str) -> acb:
        """Return the value of an expression as a ball.

        Raises KernelError if the expression is invalid or circular.
        """
        try:
            return self._of(parse(text))
        except (RecursionError, TypeError, ValueError) as error:
            raise KernelError(f"{text!r} has no value: {error}") from None

    def _of(self, tree: Tree) -> acb:
        match tree:
            case int():
                return acb(tree)
            case str():
                return self._named(tree)
            case ("-", operand):
                return -self._of(operand)
            case (base, "**", int(exponent)):
                return self._of(base) ** exponent
            case (str(name), "(", *arguments):
                if name not in FUNCTIONS:
                    raise KernelError(f"{name} is no function")
                return FUNCTIONS[name](*map(self._of, arguments))
        total = self._of(tree[0])
        for operator, operand in zip(tree[1::2], tree[2::2], strict=True):
            total = _ARITHMETIC[operator](total, self._of(operand))
        return total

    def _named(self, name: str) -> acb:
        if name not in self.known:
            if name not in self.texts:
                raise KernelError(f"{name!r} has no value")
            value = self.value(self.texts[name])
            if name in self.context.generators and not value.imag.contains(0):
                raise KernelError(f"{name} is not real")  # signs and even powers rest on that
            self.known[name] = value
        return self.known[name]


def names(tree: Tree) -> Iterator[str]:
    """Yield the names of quantities in an expression tree, without function names."""
    match tree:
        case str() if is_name(tree):
            yield tree
        case (_, "(", *arguments):
            yield from names(tuple(arguments))
        case tuple():
            for part in tree:
                yield from names(part)


def _is_formula(reading: str) -> bool:
    """Return whether the meaning of a name is given as a formula rather than in words."""
    try:
        parse(reading)
    except KernelError:
        return False
    return True


def _theta(kind: int, derivative: int = 0) -> Callable[[acb, acb], acb]:
    """Return a Jacobi theta function or its z-derivative as a Python function.

    It is theta_kind(z, q) (DLMF 20.2(i)).
    Arb takes z/pi.
    """

    def evaluate(z: acb, q: acb) -> acb:
        tau = q.log() / acb(0, 1) / acb.pi()
        values = (z / acb.pi()).modular_theta(tau, derivative)
        return values[kind - 1] / acb.pi() ** derivative

    return evaluate


def _tiny(lost: int) -> arb:
    """Return a tolerance that allows for a loss of `lost` bits of the working precision."""
    return arb(2) ** (lost - ctx.prec)


def _parameter(m: acb) -> acb:
    if m.imag != 0 or not 0 < m.real < 1:
        raise KernelError(f"the parameter {m} is not between 0 and 1")
    return m


def _nome(m: acb) -> acb:
    m = _parameter(m)
    return (-acb.pi() * (1 - m).elliptic_k() / m.elliptic_k()).exp()


def _slope(phi: acb, m: acb) -> acb:
    """Return the derivative of Legendre's integral F(phi | m) with respect to phi."""
    return 1 / (1 - m * phi.sin() ** 2).sqrt()


def _amplitude(u: acb, m: acb) -> acb:
    """Enclose the Jacobi amplitude of u by an interval Newton step.

    The amplitude is the phi with F(phi | m) = u (DLMF 22.16.10), continued analytically.
    """
    phi = _near(u, _parameter(m))
    radius = arb(0, _tiny(32))
    box = acb(phi.real + radius, phi.imag + radius)
    found = phi - (acb.elliptic_f(phi, m) - u) / _slope(box, m)
    if not box.contains_interior(found):
        raise KernelError(f"the amplitude of {u} is not enclosed")
    return found


def _near(u: acb, m: acb) -> acb:
    """Approximate the Jacobi amplitude of u numerically.

    The midpoint rule integrates along 0..u, and Newton's method improves the result.
    """
    phi, step = acb(0), u / STEPS
    for _ in range(STEPS):
        half = (phi + step / (2 * _slope(phi, m))).mid()
        phi = (phi + step / _slope(half, m)).mid()
    for _ in range(7):
        phi = (phi - (acb.elliptic_f(phi, m) - u) / _slope(phi, m)).mid()
    return phi


def _incomplete_pi(n: acb, phi: acb, m: acb) -> acb:
    """Compute Legendre's incomplete integral Pi(n; phi | m) by numerical integration.

    The path is the straight line from 0 to phi (DLMF 19.2.7).
    The path has no poles for n < 1.
    """

    def integrand(angle: acb, analytic: bool) -> acb:
        square = angle.sin() ** 2
        root = (1 - m * square).sqrt(analytic=analytic)
        return 1 / ((1 - n * square) * root)

    return acb.integral(integrand, 0, phi)


FUNCTIONS: dict[str, Callable[..., acb]] = {
    "re": lambda x: acb(x.real),
    "im": lambda x: acb(x.imag),
    "sqrt": lambda x: x.sqrt(),
    "exp": lambda x: x.exp(),
    "arcsc": lambda x, m: acb.elliptic_f(x.atan(), _parameter(m)),
    "nome": _nome,
    "elliptic_k": lambda m: m.elliptic_k(),
    "elliptic_e": lambda m: m.elliptic_e(),
    "elliptic_pi": lambda n, *x: (_incomplete_pi if x[1:] else acb.elliptic_pi)(n, *x),
    "elliptic_j": lambda u, n, m: (_incomplete_pi(n, _amplitude(u, m), m) - u) / n,
    "jacobi_sn": lambda u, m: _amplitude(u, m).sin(),
    "jacobi_cn": lambda u, m: _amplitude(u, m).cos(),
    "jacobi_dn": lambda u, m: 1 / _slope(_amplitude(u, m), m),
    "jacobi_epsilon": lambda u, m: acb.elliptic_e_inc(_amplitude(u, m), m),
    **{f"theta{kind}": _theta(kind) for kind in (1, 2, 3, 4)},
    **{f"dtheta{kind}": _theta(kind, derivative=1) for kind in (2, 4)},
}


COUNT, ATTEMPTS = 40, 400
FEWER_BITS = 128


def encloses(context: Context, fact: Fact, points: Sequence[Mapping[str, str]]) -> bool:
    """Return whether ball arithmetic confirms a fact at given and at pseudorandom points."""
    with ctx.workprec(BITS):
        given = (Evaluation(context, rational(context, point)) for point in points)
        if not all(agrees(at, fact) for at in given):
            return False
    free = [name for name in context.generators if name in points[0]]
    with ctx.workprec(FEWER_BITS):
        return _at_drawn_points(context, fact, free)


def _at_drawn_points(context: Context, fact: Fact, free: Sequence[str]) -> bool:
    """Return whether ball arithmetic confirms a fact at `COUNT` pseudorandom points.

    Raises KernelError if too few draws are points of the context.
    """
    found = 0
    for attempt in range(ATTEMPTS):
        try:
            agreed = agrees(_drawn(context, fact, free, attempt), fact)
        except (KernelError, ZeroDivisionError):
            continue
        if not agreed:
            return False
        found += 1
        if found == COUNT:
            return True
    raise KernelError(
        f"only {found} of {ATTEMPTS} drawn points are points where both sides have values"
    )


def _drawn(context: Context, fact: Fact, free: Sequence[str], attempt: int) -> Evaluation:
    known = {name: _number(context, fact, name, attempt) for name in free}
    for name, relation in _ties(context, free):
        sign = -1 if known.pop(name).real < 0 else 1
        known[name] = sign * _solution(context, known, name, relation)
    return Evaluation(context, known)


def _number(context: Context, fact: Fact, name: str, attempt: int) -> acb:
    """Return a pseudorandom value for a name.

    A hash of the claim and of the attempt determines it.
    """
    claim = [fact.context, *fact.lhs, "=", *fact.rhs, name, str(attempt)]
    digest = sha256("\n".join(claim).encode()).digest()
    share, kind = fmpq(int.from_bytes(digest[:8]), 2**64), digest[8] % 8
    if name in fact.certificate.get("whole", ()):
        return acb(digest[9] % 7 - 3)
    if kind < 4:
        return acb(share)
    if kind < 6:
        return acb(share / 1000 if kind == 4 else 1 - share / 1000)
    return acb(10 * share if kind == 6 or name in context.nonnegative else -10 * share)


def _ties(context: Context, free: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield pairs of a name and the relation that determines it.

    All names in the relation are free, and this one is the last of them.
    """
    for relation in context.relations:
        if (tied := {*names(parse(relation))}) <= {*free}:
            yield max(tied, key=free.index), relation


def _solution(context: Context, known: Mapping[str, acb], name: str, relation: str) -> acb:
    """Solve a relation that is linear in a name or in its square.

    The relation is a + b x = 0, or a + b x**2 = 0 with x > 0.
    A point with another relation is refused.
    """
    zero, one, less = (
        Evaluation(context, {**known, name: acb(x)}).value(relation) for x in (0, 1, -1)
    )
    value = zero / (zero - one)
    if (one - less).contains(0):
        if not value.real > 0:
            raise KernelError(f"{relation} = 0 has no real {name}")
        value = value.sqrt()
    return value
