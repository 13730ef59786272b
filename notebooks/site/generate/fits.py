"""The format of fits."""

import json
from typing import Any

import rigidsym
from generate.form import Format
from rigidsym.fitting import _fit as report
from rigidsym.fitting._published import toutatis


def _fit() -> Any:
    """Of a few looks, from a start."""
    looks = toutatis()
    guess = rigidsym.TorqueFreeMotion(
        (0.92, 1.0, 0.31), (-4.3e-6, 5.8e-6, -2.01e-5), (0.821, -0.497, 0.177, -0.219)
    )
    found = rigidsym.fit(
        looks.times, attitudes=looks.q, sigma=looks.sigma, guess=guess, engine="numpy"
    )
    return json.loads(found.to_json())


FORMATS = (
    Format(
        report.SCHEMA,
        "`rigidsym fit --json`, and as `fit.json` with `-o DIR`; what is infinite is `null`",
        _fit,
        {
            "converged": "whether this is a minimum",
            "reason": "why, or why not",
            "chi2": "of the best motion",
            "degrees_of_freedom": "numbers observed less the parameters they tell",
            "probability": "that errors alone make chi2 as large",
            "agreement": "whether residuals are errors",
            "agreement.verdict": "`agree`, `outliers`, or a sentence",
            "agreement.scale": "the root of chi2 over its degrees of freedom",
            "agreement.message": "what to do where they are not, else empty",
            "agreement.readings": "conventions by which the data fit instead: `name` and `chi2`",
            "nonlinearity": "how far the covariance can be trusted",
            "nonlinearity.flagged": "whether it must not be taken for the errors",
            "nonlinearity.message": "where it is wrong, else empty",
            "nonlinearity.beyond": "share of directions in which it excludes what is allowed",
            "nonlinearity.off": "share of directions in which chi2 is not as linear errors say",
            "nonlinearity.single": "names of quantities whose standard deviation misleads",
            "nonlinearity.joint": "names of the combination that it is most overconfident of",
            "intervals": "of 95 %, by profile likelihood, in the order of `names`; turns are from "
            "the estimate",
            "spin": "whether no more than a spin about an axis of the body is seen",
            "scale_known": "whether the moments are in kg m²; else the largest is 1",
            "names": "of the rows of `covariance`",
            "covariance": "of a turn at t = 0 along inertial axes, rad, `omega0`, rad/s, moments, "
            "and axes where they are estimated, rad",
            "unobservable": "names of what the observations do not tell",
            "parameters": "of the columns of `null_directions`",
            "null_directions": "unit directions that change nothing observed, in units of 1 rad "
            "and of the sizes of rates and moments",
            "best": "the motion along its principal axes",
            "best.inertia": "kg m², or with the largest as unit",
            "best.omega0": "rad/s at t = 0",
            "best.attitude0": "of the principal axes, scalar first, body to inertial",
            "best.mount": "the rotation from the principal axes to those observed",
            "best.chi2": "the sum of squares, in units of the errors",
            "best.mode": "long-axis or short-axis mode, or `null`",
            "best.rotation_period": "of the rates, s",
            "best.precession_period": "of the circulation axis about the momentum, s",
            "delta_chi2": "up to how much above the best alternatives are listed",
            "alternatives": "other minima, as `best` is",
            "observations": "by set, in the order of kinds",
            "observations[].kind": "`attitudes`, `rates`, `vectors` or `models`",
            "observations[].times": "s",
            "observations[].residuals": "computed less seen, in units of the errors",
            "observations[].against_others": "chi2 by which each misses what the others predict",
            "observations[].outliers": "indices of those that the others do not allow",
        },
    ),
)
