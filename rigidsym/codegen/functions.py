"""From the solution to the functions a target prints, by the passes in their order."""

from rigidsym.codegen.ir import Function
from rigidsym.codegen.passes import lower, select, share, specialise, without
from rigidsym.solution import Solution
from rigidsym.solution.formulas import AXES, INPUTS

_START = {"t": 0, "cos_half_psi": 1, "sin_half_psi": 0}
_RATES = tuple(f"Omega_{x}" for x in AXES)
_INERTIA = tuple(f"c_{x}" for x in AXES)
_ATTITUDE = ("q_0", "q_a", "q_b", "q_d")


def functions(solution: Solution) -> tuple[Function, ...]:
    """Input: the solution.  Output: E_b alone, the constants, a state, and the steady state."""
    state = _state(solution)
    return (_excess(solution), _plan(solution, state.parameters[1:]), state, _steady(solution))


def _excess(solution: Solution) -> Function:
    parameters = (*_INERTIA, "Omega_a", "Omega_d")
    lets = share(select(solution.programmes["plan"], ("E_b",), parameters))
    summary = "K^2 - 2 H c_b over any numbers, integers among them."
    return Function("_excess", summary, parameters, lets, ("E_b",))


def _plan(solution: Solution, results: tuple[str, ...]) -> Function:
    signs = ("epsilon", "sigma", "rho", "chi")
    parameters = (*_INERTIA, *_RATES, *signs, *_ATTITUDE, "E_b")
    given = (*parameters, *_START)
    wanted = [name for name in results if name not in given]
    wanted += ["J_0"]  # brings the quarter period and the complete integral with it
    lets = select(solution.programmes["plan"], wanted, given)
    lets = share(lower(specialise(lets, _START)))
    summary = "The constants of a motion from its state at t = 0; E_b comes from `_excess`."
    return Function("_plan", summary, parameters, lets, results)


def _state(solution: Solution) -> Function:
    results = (*_ATTITUDE, *_RATES)
    lets = lower(select(solution.programmes["state"], results, INPUTS["state"]))
    kept = tuple(
        target
        for let in lets
        for target in let.targets
        if target.startswith(("quarter_", "complete_"))
    )
    lets = share(without(lets, kept))
    constants = [name for name in INPUTS["state"] if name != "t"]
    summary = "The state at time t."
    return Function("_state", summary, ("t", *constants, *kept), lets, results)


def _steady(solution: Solution) -> Function:
    results = ("q0", "q1", "q2", "q3")
    lets = share(select(solution.programmes["steady"], results, INPUTS["steady"]))
    summary = "The attitude at time t where the rates are constant."
    return Function("_steady", summary, INPUTS["steady"], lets, results)
