"""The formats of manoeuvres: the files that ask for them, plans and flights."""

import json
from dataclasses import replace
from fractions import Fraction
from importlib import resources
from typing import Any

from generate.form import Format
from generate.text import code, fenced, prose, table
from rigidsym.manoeuvre import _planning as planning
from rigidsym.manoeuvre import solve
from rigidsym.manoeuvre._manoeuvre import FLIGHT, OWN, PAPER, Limits, open_manoeuvre
from rigidsym.manoeuvre.flight import _results as results
from rigidsym.manoeuvre.flight import fly, read

_KEYS = {
    "inertia": "three principal moments, kg m²",
    "start": "quaternion, scalar first, body to inertial, normalised",
    "target": "the same; either sign of it is reached",
    "duration": "of the natural motion, s; without it the shortest that the limits allow",
    "spin": "optional: body rates before (`start`) and after (`target`), rad/s",
    "limits": "optional: `max_rate` of |omega| on the way, rad/s, and `max_burst` of either "
    "burst, N m s",
    "degrees": "optional: true where spins and `max_rate` are in deg/s",
    "orbit": "circular: altitude, angles, and the instant of t = 0",
    "wheels": "three, along the principal axes: what each can do, and what it stores at t = 0",
    "thrusters": "optional: pairs along the principal axes that burn the bursts; without "
    "`controller` nothing else steers",
    "controller": "gains, whether to cancel the wheels' gyroscopic torque, and whether to exert "
    "the torque of the track, bursts included, ahead of errors",
    "spacecraft": "what the environment acts upon",
    "disturbances": "which of them act",
    "run": "how long, how often, how exactly; what counts as settled",
    "message": "optional, of the attitude ephemeris message: `object_name`, `object_id`, "
    "`originator`, `creation_date`, `ref_frame_b`",
}


def files() -> str:
    """The section about manoeuvre files, with the paper's as the sample."""
    if _KEYS.keys() != OWN | FLIGHT:
        raise ValueError(f"manoeuvre files: {sorted(_KEYS.keys() ^ (OWN | FLIGHT))}")
    rows = [(code(key), prose(words)) for key, words in _KEYS.items()]
    text = resources.files("rigidsym.manoeuvre").joinpath(PAPER).read_text("utf-8")
    return "\n".join(
        [
            "## Manoeuvre files: TOML\n",
            "Read by `rigidsym plan`, which needs `inertia`, `start` and `target`, and by "
            "`rigidsym track`, for which the tables from `orbit` on are; what they leave out is as "
            "below. Numbers are those of case files, uncertain ones apart. This is `paper`:\n",
            table(("key", ""), rows),
            fenced("toml", text),
        ]
    )


def _plan() -> Any:
    """One that has limits."""
    asked, _ = open_manoeuvre("paper")
    limited = replace(asked, limits=Limits(Fraction("0.05"), Fraction("0.002")))
    return json.loads(solve(limited, engine="numpy").to_json())


def _track() -> Any:
    """A coarse one, which takes no time."""
    asked, tables = open_manoeuvre("paper")
    flight = read(tables)
    coarse = replace(flight, run=replace(flight.run, period=Fraction(1)))
    best = solve(asked, engine="numpy").best
    run = fly(best.manoeuvre, coarse, best)
    return json.loads(results.Tracked(best.manoeuvre, coarse, best, run).to_json())


_ASKED = "what was asked for, as in the file, numbers exact"
_LIMITS = "`max_rate`, rad/s, and `max_burst`, N m s, where they are given"
FORMATS = (
    Format(
        planning.SCHEMA,
        "`rigidsym plan --json`, and as `plan.json` with `-o DIR`, beside a case file for each "
        "transfer",
        _plan,
        {
            "manoeuvre": _ASKED,
            "manoeuvre.duration": "s, the one that was found where none was given",
            "manoeuvre.limits": _LIMITS,
            "families": "how many transfers were wanted; limits may leave fewer",
            "transfers": "the cheapest first",
            "transfers[].omega0": "body rates after the first burst, rad/s, as doubles",
            "transfers[].rates": "the same exactly",
            "transfers[].omega1": "body rates before the last burst, rad/s",
            "transfers[].bursts": "changes of momentum that start and end the motion, in body "
            "axes, N m s",
            "transfers[].cost": "of both bursts, |first| + |last|, N m s",
            "transfers[].momentum": "K, N m s",
            "transfers[].energy": "H, J",
            "transfers[].peak_rate": "the largest |omega| on the way, rad/s",
            "transfers[].miss_burst_size": "first order: by 1 % of the first burst, rad",
            "transfers[].miss_burst_direction": "by 1 rad of its direction, the worst way, rad",
            "transfers[].growth_exponent": "the power of e by which errors grow, or 0",
            "transfers[].residual": "the angle by which `rates` miss the target, at thirty "
            "digits, rad",
        },
    ),
    Format(
        results.SCHEMA,
        "`rigidsym track --json`, and as `summary.json` with `-o DIR`, beside the states "
        "(`run.npz`) and pictures",
        _track,
        {
            "transfer.duration": "of the natural motion, s",
            "transfer.omega0": "its body rates at the start, rad/s",
            "transfer.omega1": "and at the target, rad/s",
            "transfer.regime": "the kind of motion",
            "transfer.miss_burst_size": "first order: by 1 % of the first burst, rad",
            "transfer.miss_burst_direction": "by 1 rad of its direction, the worst way, rad",
            "tracking_error": "angle between what is flown and what is followed until the target: "
            "greatest, root mean square, last; rad",
            "target": "after it is reached; `null` where nothing is flown by then",
            "target.final_error": "angle from the target at the end, rad",
            "target.greatest_error": "the largest since it was reached, rad",
            "target.settled_at": "since when it stays within `flight.run.settled`, s; or `null`",
            "thrusters": "`null` without them; else when each axis burns for each burst "
            "(`spans`, s), its `impulses` (N m s), and the `error` (rad) and `rate` (rad/s) of "
            "the `last` sample, when all burns are over",
            "saturation.torque": "how long each wheel is at its limit of torque, s",
            "saturation.momentum": "and of momentum, s",
            "saturation.momentum_needed": "what each wheel would store at most if what is wanted "
            "were flown exactly, N m s",
            "torque_peak": "of each wheel, N m",
            "torque_integral": "of its size over time, N m s",
            "wheel_momentum_peak": "stored at most by each wheel, N m s",
            "disturbance_peak": "the greatest size of each disturbing torque, N m",
            "checks.momentum_defect": "change of momentum that nothing outside explains, N m s",
            "checks.energy_defect": "change of energy that is no torque's work, J",
            "manoeuvre": _ASKED,
            "flight": "all settings, as in the file, in its units",
        },
        frozenset({"disturbance_peak"}),
    ),
)
