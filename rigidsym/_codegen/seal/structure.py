"""Checks of generated functions: order of definitions, interfaces, shared subexpressions."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace

from rigidsym._codegen.forms import PI, STEP, THETA
from rigidsym._codegen.ir import CALLS, Function, Let
from rigidsym._codegen.lines import comment, flat_results
from rigidsym._codegen.passes import expand
from rigidsym._codegen.seal.equality import DIFFERS, Claim
from rigidsym.errors import InputError
from rigidsym.language._expression import (
    Call,
    Expression,
    Operation,
    children,
    names,
    put,
    rebuild,
)

_MOTION = (
    *("c_a", "c_b", "c_d", "c_ab", "c_ad", "c_bd", "Omega_a", "Omega_b", "Omega_d", "E_b"),
    *("axis_a", "axis_b", "axis_d", "q_0", "q_a", "q_b", "q_d", "unit"),
)
_PARAMETERS = {
    "_discriminant": ("c_a", "c_d", "c_ab", "c_bd", "Omega_a", "Omega_d"),
    "_circulation": ("c_12", "c_13", "c_23", "Omega_1", "Omega_2", "Omega_3", "E_2"),
    "_steady_constants": ("Omega1", "Omega2", "Omega3", "p0", "p1", "p2", "p3"),
}
_STATE = ("q_0", "q_a", "q_b", "q_d", "Omega_a", "Omega_b", "Omega_d")
_RESULTS = {
    "_discriminant": ("E_b",),
    "_circulation": ("sorted_body",),
    "_steady_angles": ("X_im", "X_re"),
    "_circular_state": _STATE,
    "_hyperbolic_state": _STATE,
    "_steady_state": ("q0", "q1", "q2", "q3"),
}
# The first four are sines and cosines.
_ANGLES = {
    THETA: {
        "_circular_angles": ("sin_v", "cos_v", "X_im", "X_re"),
        "_hyperbolic_angles": ("w", "p", "side", "flip", "X_im", "X_re"),
    },
    PI: {
        "_circular_angles": ("s", "c", "X_im", "X_re", "d"),
        "_hyperbolic_angles": ("s", "c", "X_im", "X_re", "d"),
    },
}
# What the runtimes read of constants, by these names.
_READ = {
    "_initial_state": ("A_a", "A_b", "A_d", "k_1"),
    "_circular_constants": ("v_rate_hi", "Lambda_rate_hi", "v_hi", "v_lo"),
    "_hyperbolic_constants": ("y_rate_hi", "Lambda_rate_hi"),
    "_steady_constants": ("Lambda_rate_hi", "Lambda_rate_lo"),
}
# What functions of a step take and return.
_MOMENTS, _APART, _BEGUN = "c_a c_b c_d", "c_ab c_ad c_bd", "Omega_a0 Omega_b0 Omega_d0"
_PROJECTED = "z_re z_im zr_re zr_im"
_STEPS = {
    "_step_body": (f"{_MOMENTS} {_APART} epsilon", "alpha_a alpha_b alpha_d l_a l_b l_d"),
    "_step_start": (
        f"{_MOMENTS} l_a l_b l_d {_BEGUN} t epsilon sigma",
        f"h e_1 e_2 K Lambda_rate X Y {_PROJECTED}",
    ),
    "_step_first": (f"h e_1 e_2 X {_PROJECTED}", "W_re W_im"),
    "_step_doubled": ("X Y e_1 e_2", "X_next Y_next"),
    "_step_projected": (f"h {_PROJECTED} X Y", "w_re w_im"),
    "_step_second_half": ("h X w_re w_im W_re W_im", "W_next_re W_next_im"),
    "_step_last_projected": (f"h {_PROJECTED} X Y", "v_re v_im"),
    "_step_last_second_half": ("h X v_re v_im W_re W_im", "W_next_re W_next_im"),
    "_step_rates": (
        f"X Y h alpha_a alpha_b alpha_d l_d {_BEGUN}",
        "Omega_a Omega_b Omega_d",
    ),
    "_step_shortest_before": (f"K {_BEGUN} {_MOMENTS} epsilon sigma", "s_0 s_b s_d"),
    "_step_front": ("s_0 s_b s_d q_0 q_a q_b q_d epsilon", "p_0 p_a p_b p_d"),
    "_step_shortest": (f"K Omega_a Omega_b Omega_d {_MOMENTS} epsilon sigma", "s_0 s_b s_d"),
    "_step_attitude": (
        "t Lambda_rate_hi Lambda_rate_lo W_re W_im s_0 s_b s_d p_0 p_a p_b p_d epsilon sigma",
        "q_0 q_a q_b q_d",
    ),
    "_step_kick": (
        "q0 q1 q2 q3 u1 u2 u3 b1 b2 b3 k m1 m2 m3 Q11 Q22 Q33 Q23 Q13 Q12",
        "T1 T2 T3",
    ),
}


def check_order(functions: Iterable[Function], numbers: set[str]) -> None:
    """Raise InputError for the first line that uses a name or function before its definition."""
    called: dict[str, Function] = {}
    for function in functions:
        for lets in (function.formulas, function.lets):
            _check_names(function, lets, numbers)
            for let in lets:
                _check_calls(function.name, let, called)
        called[function.name] = function


def _check_names(function: Function, lets: tuple[Let, ...], numbers: set[str]) -> None:
    """Check that every name is set once, before its use, and is used or returned."""
    known = {*function.parameters, *numbers}
    if len(set(function.parameters)) != len(function.parameters):
        raise InputError(function.name, ", ".join(function.parameters), "a name is given twice")
    for let in lets:
        missing = sorted(set(names(let.expression)) - known)
        if missing:
            raise InputError(function.name, let, f"{', '.join(missing)}: used before it is known")
        again = sorted(known.intersection(let.targets))
        if again or len(set(let.targets)) != len(let.targets):
            raise InputError(function.name, let, f"{', '.join(again)}: known already, set again")
        known.update(let.targets)
    left = sorted(set(function.results) - known)
    if left:
        raise InputError(function.name, ", ".join(left), "is returned and never set")
    wanted = set(function.results)
    for let in reversed(lets):
        if not wanted.intersection(let.targets):
            raise InputError(function.name, let, "nothing needs this line")
        wanted.update(names(let.expression))


def check_rounding(plain: Iterable[Function], printed: Iterable[Function]) -> None:
    """Raise InputError for the first line that differs in more than where numbers are rounded."""
    for function, other in zip(plain, printed, strict=True):
        known = {target for let in function.lets for target in let.targets}
        rounded = {x.targets[0]: x.expression for x in other.lets if not known & {*x.targets}}
        lets = [let for let in other.lets if let.targets[0] not in rounded]
        for let, changed in zip(function.lets, lets, strict=True):
            same = replace(changed, expression=_bare(put(changed.expression, rounded)))
            if same != replace(let, expression=_bare(let.expression)):
                raise InputError(function.name, changed, f"{let}: {DIFFERS}")


def _bare(expression: Expression) -> Expression:
    """Drop all rounding from an expression."""
    match rebuild(expression, tuple(map(_bare, children(expression)))):
        case Call("rounded", (inner,)):
            return inner
        case other:
            return other


def _check_calls(place: str, let: Let, known: dict[str, Function]) -> None:
    """Check that each call has the number of arguments and results of the function called."""
    whole = let.expression
    if len(let.targets) > 1 and not (isinstance(whole, Call) and whole.function in known):
        raise InputError(place, let, "several names are set by no function that returns several")
    for call in _calls(whole):
        if call.function in CALLS:
            continue
        if call.function not in known:
            raise InputError(place, let, f"{call.function}: called and not known")
        function = known[call.function]
        expected = len(let.targets) if call is whole else 1
        if len(call.arguments) != len(function.parameters) or len(function.results) != expected:
            raise InputError(place, let, f"{call.function}: takes or returns another number")


def _calls(expression: Expression) -> Iterator[Call]:
    if isinstance(expression, Call):
        yield expression
    for part in children(expression):
        yield from _calls(part)


def check_interfaces(functions: Iterable[Function], form: str = THETA) -> None:
    """Raise InputError for a function whose interface differs from what the runtimes expect."""
    by_name = {function.name: function for function in functions}
    if form == STEP:
        for name, (parameters, results) in _STEPS.items():
            _same(name, "takes", by_name[name].parameters, tuple(parameters.split()))
            _same(name, "returns", by_name[name].results, tuple(results.split()))
        return
    for name, parameters in _PARAMETERS.items():
        _same(name, "takes", by_name[name].parameters, parameters)
    for name, results in (_RESULTS | _ANGLES[form]).items():
        _same(name, "returns", by_name[name].results, results)
    for name, read in _READ.items():
        _among(name, "returns", read, flat_results(by_name[name]))
    start = by_name["_initial_state"]
    _among(start.name, "is given", start.parameters, _MOTION)
    for branch in ("circular", "hyperbolic"):
        constants = by_name[f"_{branch}_constants"]
        _among(constants.name, "is given", constants.parameters, (*_MOTION, *start.results))
    for branch in ("circular", "hyperbolic", "steady"):
        _check_branch(branch, by_name)


def _check_branch(branch: str, functions: Mapping[str, Function]) -> None:
    """Check the parameters of a branch's functions.

    Angles take times, states take angles, and both take constants.
    """
    constants, angles, state = (
        functions[f"_{branch}_{part}"] for part in ("constants", "angles", "state")
    )
    kept = flat_results(constants)
    for function, first in ((angles, ("t", "t_lo")), (state, angles.results)):
        _same(function.name, "takes first", function.parameters[: len(first)], first)
        _among(function.name, "is given", function.parameters[len(first) :], kept)


def _same(name: str, what: str, found: tuple[str, ...], counted: tuple[str, ...]) -> None:
    if found != counted:
        raise InputError(name, ", ".join(found), f"is not what it {what}: {', '.join(counted)}")


def _among(name: str, what: str, found: Iterable[str], known: Iterable[str]) -> None:
    unknown = [x for x in found if x not in set(known)]
    if unknown:
        raise InputError(name, ", ".join(unknown), f"is nothing that it {what}")


def sharing_claims(stated: Iterable[Function], functions: Iterable[Function]) -> Iterator[Claim]:
    """Yield claims that lines with shared subexpressions still compute the original formulas."""
    for origin, function in zip(stated, functions, strict=True):
        _check_stated(origin, function)
        _check_shared(function)
        printed = expand(function.lets)
        targets = [let.targets for let in printed]
        if targets != [formula.targets for formula in function.formulas]:
            raise InputError(function.name, "its lines", "do not set what the formulas set")
        for formula, let in zip(function.formulas, printed, strict=True):
            # Rounding errors are found by sums that would vanish in a ring: no other order will do.
            if let.expression != formula.expression and not _has_power(formula.expression):
                raise InputError(function.name, formula, DIFFERS)
            if (let.facts, let.source) != (formula.facts, formula.source):
                raise InputError(function.name, let, f"is by {comment(formula)}")
            yield Claim(function.name, str(formula), formula.expression, let.expression)


def _check_stated(origin: Function, function: Function) -> None:
    """Check that a function's formulas are among the original ones, and in their order.

    Some of these may be left out.
    """
    later = iter(origin.lets)
    for formula in function.formulas:
        if formula not in later:
            raise InputError(function.name, formula, DIFFERS)
    if function.results != origin.results or function.parameters != origin.parameters:
        raise InputError(function.name, "its parameters and results", "are not those stated")


def _check_shared(function: Function) -> None:
    """Check that each shared subexpression cites exactly the facts of the lines that use it."""
    formulas = {formula.targets[0] for formula in function.formulas}
    users: dict[str, set[str]] = {}
    for let in reversed(function.lets):
        own = {*let.facts} if let.targets[0] in formulas else users.get(let.targets[0], set())
        if own != {*let.facts}:
            raise InputError(function.name, let, f"is by {', '.join(sorted(own)) or 'no fact'}")
        for name in names(let.expression):
            users.setdefault(name, set()).update(own)


def _has_power(expression: Expression) -> bool:
    if isinstance(expression, Operation) and expression.operator == "**":
        return True
    return any(map(_has_power, children(expression)))
