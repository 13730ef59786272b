"""Derivation steps on scalar expressions: derivatives, integrals, elimination, roots."""

from collections.abc import Mapping, Sequence
from typing import Any

import sympy
from sympy import Expr, Symbol
from sympy.solvers.solveset import NonlinearError

from rigidsym.proof.algebra._builder import Source
from rigidsym.proof.algebra._computation import Computation, compute, plain
from rigidsym.proof.kernel import KernelError
from rigidsym.proof.steps._names import collected, symbol
from rigidsym.proof.steps._record import Step, StepError
from rigidsym.proof.steps._scope import Scope
from rigidsym.view._statements import derived_by


def differentiate(
    scope: Scope, fact_id: str, expression: Expr, why: str, source: Source = ()
) -> Step:
    """Differentiate an expression with respect to time, or to the one name that moves at rate 1.

    The context gives the derivatives of its names.
    """
    value = min(map(scope.reduced, scope.rates(expression)), key=sympy.count_ops)
    origin = Computation(value, ("differentiate",))
    fact = scope.decide(fact_id, [(f"D({scope.text(expression)})", value)], source, origin)
    along = derived_by(scope.context)
    slope = rate_of(expression) if along is None else sympy.Derivative(expression, symbol(along))
    return scope.note("differentiate", why, value, [(slope, value)], fact)


def rate_of(expression: Expr) -> Expr:
    """Return the unevaluated time derivative of an expression."""
    D: Any = sympy.Function("D")
    return D(expression)


def rewrite(
    scope: Scope,
    fact_id: str,
    expression: Expr,
    value: Expr | Computation,
    why: str,
    source: Source = (),
    verb: str = "rewrite",
    law: str = "",
) -> Step:
    """Prove that an expression equals another form of it.

    The other form, `value`, was typed unless it is a computation; then the line is a `law`, or was
    guessed.
    """
    form = plain(value)
    conditions = scope.divisors(expression, form)
    there = scope.at(fact_id, *conditions)
    fact = there.decide(fact_id, [(expression, value)], source, law=law)
    return there.note(verb, why, form, [(expression, form)], fact, conditions)


def eliminate(
    scope: Scope,
    fact_id: str,
    expression: Expr,
    equations: Sequence[Expr],
    unknowns: Sequence[Expr],
    why: str,
    source: Source = (),
    name: Expr | None = None,
) -> Step:
    """Eliminate unknowns from an expression by equations that are linear in them.

    The equations are expressions that vanish.
    Unknowns are symbols or powers of symbols, such as Omega2**2.  The result is stated as the value
    of `name` if that is given, else of the expression.  Raises StepError if the equations do not
    determine the unknowns.
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
    value = scope.reduced(parts[0] / parts[1])
    if value.has(*unknowns):  # the relations of the context may bring them back
        value = collected(parts[0] / parts[1])
    if value.free_symbols & {*stand_ins.values()}:
        raise StepError(f"eliminate: {fact_id}: the equations leave an unknown free")
    left = expression if name is None else name
    found = Computation(value, ("eliminate",))
    return rewrite(scope, fact_id, left, found, why, source, "eliminate")


def apart(expression: Expr | Computation, variable: Expr) -> Computation:
    """Expand an expression in partial fractions of the form c/(1 - n x).

    The variable may be a power.
    """
    return compute(expression).apply(_apart, variable)


def _apart(expression: Expr, variable: Expr) -> Expr:
    stand_in = sympy.Dummy()
    parts = [
        sympy.expand(x).subs(variable, stand_in) for x in sympy.fraction(sympy.together(expression))
    ]
    terms = sympy.Add.make_args(sympy.apart(parts[0] / parts[1], stand_in))
    return sympy.Add(*(_normalised(term, stand_in).subs(stand_in, variable) for term in terms))


def _normalised(term: Expr, variable: Symbol) -> Expr:
    """Rewrite c/(a + b x) as (c/a)/(1 - (-b/a) x).

    Tables of integrals use this form.
    """
    above, below = sympy.fraction(sympy.together(term))
    if not below.has(variable):
        return collected(term)
    constant = sympy.expand(below).subs(variable, 0)
    rest = sympy.factor((constant - sympy.expand(below)) / constant / variable)
    return collected(above / constant) / (1 - rest * variable)


def integrate(
    scope: Scope,
    fact_id: str,
    rate: Expr | Computation,
    table: Mapping[Symbol, Expr],
    why: str,
    source: Source = (),
) -> Step:
    """Integrate an expression with respect to time by a table of derivatives.

    The expression is a sum of constants times entries of the table.
    Raises StepError for a term that is not in the table.
    """
    rate, total = plain(rate), sympy.S.Zero
    moving = {symbol(name) for name in scope.context.rates or {}}
    for term in sympy.Add.make_args(rate):
        factors = {f: collected(sympy.cancel(term / slope)) for f, slope in table.items()}
        constant = {
            f: x for f, x in factors.items() if not scope.dictionary.named(x).free_symbols & moving
        }
        if not constant:
            raise StepError(f"integrate: {fact_id}: {term} is not in the table")
        function, factor = next(iter(constant.items()))
        total += factor * function
    origin = Computation(total, ("integrate",))
    fact = scope.decide(fact_id, [(f"D({scope.text(total)})", rate)], source, origin)
    conditions = scope.divisors(total)
    return scope.note(
        "integrate", why, total, [(sympy.Integral(rate, symbol("t")), total)], fact, conditions
    )


def nonnegative(
    scope: Scope,
    fact_id: str,
    expression: Expr,
    form: Expr | Computation,
    why: str,
    source: Source = (),
) -> Step:
    """Prove that an expression is nonnegative by rewriting it in a visibly nonnegative form.

    Such a form is a sum or product of nonnegative parts and even powers.
    """
    try:
        forms = {scope.text(expression): scope.text(form)}
        fact = scope.builder.sign(scope.fact(fact_id), forms, source)
    except KernelError as error:
        raise StepError(str(error)) from None
    return scope.note("nonnegative", why, plain(form), [(expression, plain(form))], fact)


def roots(
    scope: Scope,
    fact_id: str,
    polynomial: Expr,
    variable: Expr,
    why: str,
    source: Source = (),
) -> Step:
    """Find all roots of a polynomial by factoring it into linear factors.

    Raises StepError if a factor is not linear.
    """
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
    conditions = scope.divisors(*values)
    there = scope.at(fact_id, *conditions)
    origin = Computation(values, ("roots",))
    fact = there.decide(fact_id, [(polynomial, product)], source, origin)
    return there.note("roots", why, values, [(polynomial, product)], fact, conditions)


def coefficients(expression: Expr, variable: Expr) -> tuple[Expr, ...]:
    """Return the coefficients of a polynomial, highest power first.

    Each coefficient is one fraction of collected factors.
    """
    stand_in = sympy.Dummy()
    plain = sympy.expand(expression).subs(variable, stand_in)
    return tuple(map(collected, sympy.Poly(plain, stand_in).all_coeffs()))


def match(
    scope: Scope,
    fact_id: str,
    ansatz: Expr,
    wanted: Expr,
    variable: Expr,
    unknowns: Sequence[Symbol],
    why: str,
    source: Source = (),
) -> Step:
    """Solve for unknowns so that two polynomials have equal coefficients.

    The polynomials are in `variable`.
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
    fact = scope.decide(fact_id, pairs, source, Computation(found, ("match",)))
    names = sympy.Tuple(*unknowns)
    choices = [(names, names.subs(solution)) for solution in found]
    conditions = scope.divisors(*(value for solution in found for value in solution.values()))
    return scope.note("match", why, found, choices, fact, conditions)
