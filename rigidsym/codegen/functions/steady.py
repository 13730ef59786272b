"""The branch with constant rates: spin, spherical bodies, rest."""

from rigidsym.codegen.functions.attitude import at_time, flat, phase
from rigidsym.codegen.ir import Function, let
from rigidsym.codegen.passes import select
from rigidsym.solution import Solution

_QUATERNION = ("q0", "q1", "q2", "q3")


def steady(solution: Solution) -> tuple[Function, ...]:
    """Plan, angle and state; the half angle is the phase of the other branches."""
    sequence = solution.sequences["steady"]
    given = ("Omega1", "Omega2", "Omega3")
    axis, start = ("axis1", "axis2", "axis3"), ("p0", "p1", "p2", "p3")
    first = [*select(sequence, ("omega", *axis), given), let("Lambda_rate = omega/(2*pi)")]
    turned = ("X_im", "X_re")
    # The half angle is omega t/2: its cosine and sine are those of the phase.
    state = [
        let("cos_half_theta = X_re", facts=("reading steady.cos_half_theta",)),
        let("sin_half_theta = X_im", facts=("reading steady.sin_half_theta",)),
        *select(sequence, _QUATERNION, ("sin_half_theta", "cos_half_theta", *axis, *start)),
    ]
    results = ("Lambda_rate", *axis, *start)
    return (
        Function(
            "_steady_constants",
            "The axis and the rate of a motion with constant rates.",
            (*given, *start),
            tuple(first),
            results,
            frozenset((*given, *start)),
            frozenset(("Lambda_rate",)),
            rounds=True,
        ),
        at_time("steady", phase(), flat(("Lambda_rate",)), turned),
        Function(
            "_steady_state",
            "The attitude from `_steady_angles`.",
            (*turned, *axis, *start),
            tuple(state),
            _QUATERNION,
        ),
    )
