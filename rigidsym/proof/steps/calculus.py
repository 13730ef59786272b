"""Steps on one expression: rates, partial fractions, integrals by a table, elimination, roots."""

from collections.abc import Mapping, Sequence
from typing import Any

import sympy
from sympy import Eq, Expr, Symbol
from sympy.solvers.solveset import NonlinearError

from rigidsym.proof.kernel import KernelError
from rigidsym.proof.steps.desk import Desk
from rigidsym.proof.steps.names import collected, symbol
from rigidsym.proof.steps.record import Step, StepError


def differentiate(
    desk: Desk, fact_id: str, expression: Expr, why: str, source: Sequence[str] = ()
) -> Step:
    """The time derivative of an expression, by the rates of the context."""
    value = min(map(desk.reduced, desk.rates(expression)), key=sympy.count_ops)
    fact = desk.decide(fact_id, [(f"D({desk.text(expression)})", value)], source)
    shown = Eq(rate_of(expression), value, evaluate=False)
    return desk.note(Step("differentiate", why, value, (shown,), fact, source=tuple(source)))


def rate_of(expression: Expr) -> Expr:
    """The derivative of an expression, not yet formed."""
    D: Any = sympy.Function("D")
    return D(expression)


def rewrite(
    desk: Desk,
    fact_id: str,
    expression: Expr,
    value: Expr,
    why: str,
    source: Sequence[str] = (),
    verb: str = "rewrite",
) -> Step:
    """expression = value, which an earlier step or SymPy found: the kernel decides."""
    conditions = desk.divisors(expression, value)
    there = desk.at(fact_id, *conditions)
    fact = there.decide(fact_id, [(expression, value)], source)
    shown = Eq(expression, value, evaluate=False)
    return there.note(Step(verb, why, value, (shown,), fact, conditions, source=tuple(source)))


def eliminate(
    desk: Desk,
    fact_id: str,
    expression: Expr,
    equations: Sequence[Expr],
    unknowns: Sequence[Expr],
    why: str,
    source: Sequence[str] = (),
    name: Expr | None = None,
) -> Step:
    """Put the solution of equations = 0, linear in the unknowns, in the place of the unknowns.

    Unknowns are symbols or powers of symbols, such as Omega2**2.  `name` is what the expression
    is the value of, if the result is to be stated of that.  Raises StepError where the equations
    do not determine the unknowns or some of them are left.
    """
    stand_ins = {x: sympy.Dummy() for x in unknowns}
    hidden = [sympy.expand(equation).subs(stand_ins) for equation in equations]
    try:
        (solution,) = sympy.linsolve(hidden, *stand_ins.values())
    except (ValueError, NonlinearError):
        raise StepError(f"eliminate: {fact_id}: no one solution of these equations") from None
    found = dict(zip(stand_ins.values(), solution, strict=True))
    above, below = sympy.fraction(sympy.together(expression))
    parts = [sympy.expand(x).subs(stand_ins).subs(found) for x in (above, below)]
    value = desk.reduced(parts[0] / parts[1])
    if value.has(*unknowns):  # the relations of the context may bring them back
        value = collected(parts[0] / parts[1])
    if value.free_symbols & {*stand_ins.values()}:
        raise StepError(f"eliminate: {fact_id}: the equations leave an unknown free")
    left = expression if name is None else name
    return rewrite(desk, fact_id, left, value, why, source, "eliminate")


def apart(expression: Expr, variable: Expr) -> Expr:
    """Partial fractions in a variable, which may be a power, each as c/(1 - n x)."""
    stand_in = sympy.Dummy()
    parts = [
        sympy.expand(x).subs(variable, stand_in) for x in sympy.fraction(sympy.together(expression))
    ]
    terms = sympy.Add.make_args(sympy.apart(parts[0] / parts[1], stand_in))
    return sympy.Add(*(_normalised(term, stand_in).subs(stand_in, variable) for term in terms))


def _normalised(term: Expr, variable: Symbol) -> Expr:
    """c/(a + b x) as (c/a)/(1 - (-b/a) x), the form that tables of integrals have."""
    above, below = sympy.fraction(sympy.together(term))
    if not below.has(variable):
        return collected(term)
    constant = sympy.expand(below).subs(variable, 0)
    rest = sympy.factor((constant - sympy.expand(below)) / constant / variable)
    return collected(above / constant) / (1 - rest * variable)


def integrate(
    desk: Desk,
    fact_id: str,
    rate: Expr,
    table: Mapping[Symbol, Expr],
    why: str,
    source: Sequence[str] = (),
) -> Step:
    """An integral of a sum, term by term: each a constant times an entry of a table of rates.

    Raises StepError for a term that the table has not.
    """
    total = sympy.S.Zero
    moving = {symbol(name) for name in desk.context.rates or {}}
    for term in sympy.Add.make_args(rate):
        factors = {f: collected(sympy.cancel(term / slope)) for f, slope in table.items()}
        constant = {
            f: x for f, x in factors.items() if not desk.dictionary.named(x).free_symbols & moving
        }
        if not constant:
            raise StepError(f"integrate: {fact_id}: {term} is not in the table")
        function, factor = next(iter(constant.items()))
        total += factor * function
    fact = desk.decide(fact_id, [(f"D({desk.text(total)})", rate)], source)
    shown = Eq(sympy.Integral(rate, symbol("t")), total, evaluate=False)
    conditions = desk.divisors(total)
    return desk.note(
        Step("integrate", why, total, (shown,), fact, conditions, source=tuple(source))
    )


def nonnegative(
    desk: Desk, fact_id: str, expression: Expr, form: Expr, why: str, source: Sequence[str] = ()
) -> Step:
    """expression = form, a form of sums and products that shows it not to be negative."""
    try:
        fact = desk.book.sign(fact_id, {desk.text(expression): desk.text(form)}, source)
    except KernelError as error:
        raise StepError(str(error)) from None
    shown = Eq(expression, form, evaluate=False)
    return desk.note(Step("nonnegative", why, form, (shown,), fact, source=tuple(source)))


def roots(
    desk: Desk,
    fact_id: str,
    polynomial: Expr,
    variable: Expr,
    why: str,
    source: Sequence[str] = (),
) -> Step:
    """All roots of a polynomial that factors: it is its leading coefficient times their factors."""
    stand_in = sympy.Dummy()
    plain = sympy.expand(polynomial).subs(variable, stand_in)
    leading, factors = sympy.factor_list(sympy.numer(sympy.together(plain)), stand_in)
    linear = [(sympy.Poly(factor, stand_in), power) for factor, power in factors]
    if any(factor.degree() > 1 for factor, _ in linear):
        raise StepError(f"roots: {fact_id}: a factor is not linear")
    values = tuple(
        sympy.factor(-factor.TC() / factor.LC()) for factor, power in linear for _ in range(power)
    )
    leading = sympy.factor(sympy.Poly(plain, stand_in).LC())
    product = sympy.Mul(leading, *(variable - x for x in values), evaluate=False)
    conditions = desk.divisors(*values)
    there = desk.at(fact_id, *conditions)
    fact = there.decide(fact_id, [(polynomial, product)], source)
    shown = Eq(polynomial, product, evaluate=False)
    return there.note(Step("roots", why, values, (shown,), fact, conditions, source=tuple(source)))


def coefficients(expression: Expr, variable: Expr) -> tuple[Expr, ...]:
    """Those of a polynomial, the highest power first, each collected."""
    stand_in = sympy.Dummy()
    plain = sympy.expand(expression).subs(variable, stand_in)
    return tuple(map(collected, sympy.Poly(plain, stand_in).all_coeffs()))


def match(
    desk: Desk,
    fact_id: str,
    ansatz: Expr,
    wanted: Expr,
    variable: Expr,
    unknowns: Sequence[Symbol],
    why: str,
    source: Sequence[str] = (),
) -> Step:
    """The unknowns for which two polynomials in a variable agree: their coefficients compared.

    The kernel decides that each solution makes them agree.  Raises StepError where none does.
    """
    stand_in = sympy.Dummy()
    gap = sympy.expand(sympy.expand(ansatz - wanted).subs(variable, stand_in))
    equations = sympy.Poly(gap, stand_in).all_coeffs()
    solutions = sympy.solve(equations, list(unknowns), dict=True)
    found = [s for s in solutions if all(s.get(x, x) != 0 for x in unknowns)]
    if not found:
        raise StepError(f"match: {fact_id}: no choice of {unknowns} makes them agree")
    found.sort(key=lambda solution: sympy.default_sort_key(solution[unknowns[0]]))
    pairs = [(ansatz.subs(solution), wanted.subs(solution)) for solution in found]
    fact = desk.decide(fact_id, pairs, source)
    shown = tuple(Eq(x, value, evaluate=False) for s in found for x, value in s.items())
    conditions = desk.divisors(*(value for s in found for value in s.values()))
    return desk.note(Step("match", why, found, shown, fact, conditions, source=tuple(source)))
