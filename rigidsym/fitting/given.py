"""The arguments of a fit, as users give them, as a problem; one line for what is wrong."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidsym import inputs
from rigidsym.engines import batches, checked
from rigidsym.errors import InputError
from rigidsym.fitting.covariances import whitening
from rigidsym.fitting.observations import (
    Attitudes,
    Directions,
    Modelled,
    Observations,
    Rates,
    middle,
)
from rigidsym.fitting.parameters import Parameters
from rigidsym.fitting.problem import Prior, Problem

INERTIA = ("ratios", "known", "tensor")
KINDS: Mapping[str, type[Observations]] = {
    "attitudes": Attitudes,
    "rates": Rates,
    "vectors": Directions,
    "models": Modelled,
}

Sigma = ArrayLike | Mapping[str, ArrayLike] | None
Given = Observations | Sequence[Observations] | ArrayLike | None


def observations(
    times: ArrayLike | None, given: Mapping[str, Given], sigma: Sigma
) -> tuple[Observations, ...]:
    """All sets, in the order of their kinds; arrays are seen at `times` with errors `sigma`."""
    sigmas = _sigmas(sigma, [name for name, value in given.items() if value is not None])
    found = [
        one
        for name, value in given.items()
        if value is not None
        for one in _sets(name, value, times, sigmas.get(name))
    ]
    if not found:
        raise InputError("observations", "none", f"give {', '.join(given)}, or some of them")
    if len(np.unique(np.concatenate([one.t for one in found]))) == 1:
        rule = "all observations are at one time, and show no motion"
        raise InputError("times", found[0].t[0], rule)
    return tuple(found)


def _sigmas(sigma: Sigma, names: Sequence[str]) -> Mapping[str, Any]:
    """By the name of the kind; one for all where there is but one kind."""
    if isinstance(sigma, Mapping):
        for name in sigma:
            if name not in (*KINDS, "moments"):
                rule = f"is not one of: {', '.join((*KINDS, 'moments'))}"
                raise InputError("sigma", name, rule)
        return sigma
    if sigma is not None and len(names) > 1:
        raise InputError("sigma", "one for all", f"give one for each of: {', '.join(names)}")
    return dict.fromkeys(names, sigma)


def _sets(name: str, value: Any, times: ArrayLike | None, sigma: Any) -> Iterable[Observations]:
    if isinstance(value, Observations):
        value = [value]
    if isinstance(value, list | tuple) and value and isinstance(value[0], Observations):
        for one in value:
            if not isinstance(one, KINDS[name]):
                rule = f"must be {KINDS[name].__name__}"
                raise InputError(name, type(one).__name__, rule)
        return value
    if name in ("vectors", "models"):
        rule = f"must be rigidsym.fitting.{KINDS[name].__name__}, or a list of them"
        raise InputError(name, type(value).__name__, rule)
    if times is None:
        raise InputError("times", "missing", f"{name} given as an array need them")
    return [KINDS[name](times, value, sigma)]


def problem(
    sets: tuple[Observations, ...],
    inertia: str,
    moments: ArrayLike | None,
    sigma: Sigma,
    engine: str,
) -> tuple[Problem, np.ndarray | None]:
    """What is to be solved, and the moments (3,) that are known, guessed, or have a prior."""
    if inertia not in INERTIA:
        raise InputError("inertia", repr(inertia), f"must be one of: {', '.join(INERTIA)}")
    known = None if moments is None else _moments(moments)
    if inertia == "known" and known is None:
        raise InputError("moments", "missing", 'inertia="known" needs them')
    prior = _prior(known, sigma, inertia)
    parameters = Parameters(
        shape=inertia != "known", scale=prior is not None, axes=inertia == "tensor"
    )
    found = Problem(sets, parameters, prior, checked(engine), middle(sets))
    if found.count < parameters.count:
        rule = f"are fewer than the {parameters.count} parameters"
        raise InputError("observations", f"{found.count} numbers", rule)
    return found, known


def _moments(values: ArrayLike) -> np.ndarray:
    found = inputs.certain("moments", inputs.inertia(values, way_out=""))
    return np.array(inputs.doubles("moments", found))


def _prior(known: np.ndarray | None, sigma: Sigma, inertia: str) -> Prior | None:
    """What `sigma["moments"]` says of the errors of the moments."""
    if not isinstance(sigma, Mapping) or "moments" not in sigma:
        return None
    if known is None or inertia == "known":
        rule = 'is about moments that are given, and inertia="ratios" or "tensor"'
        raise InputError("sigma.moments", "given", rule)
    errors = batches.array("sigma.moments", sigma["moments"])
    matrix = np.diag(errors**2) if errors.shape == (3,) else errors
    weights = whitening("sigma.moments", matrix, 1, 3)[0]
    return Prior(known, weights * np.eye(3) if weights.shape == (1, 1) else weights)
