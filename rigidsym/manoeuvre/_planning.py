"""Planning of torque-free motions from one attitude to another, ranked by their cost."""

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from rigidsym import _engines as engines
from rigidsym import _inputs as inputs
from rigidsym._inputs import ExactNumber, Quaternion, Vector3
from rigidsym.errors import InputError, PrecisionError
from rigidsym.io._files import remove, write_all
from rigidsym.manoeuvre._cheapest import Bursts, cheapest, refuse, shortest
from rigidsym.manoeuvre._directions import arcs, is_symmetry
from rigidsym.manoeuvre._families import verified
from rigidsym.manoeuvre._manoeuvre import REST, Manoeuvre, above_zero, manoeuvre
from rigidsym.manoeuvre._problem import problem
from rigidsym.manoeuvre._search import TooManyError
from rigidsym.manoeuvre._transfer import Transfer
from rigidsym.manoeuvre._transit import peaks

if TYPE_CHECKING:
    from rigidsym.view.scenes._scene import Figure

SCHEMA = "rigidsym.plan/1"
MOST_FAMILIES = 1000
AN_ARC = 49
"Points of the curve that draws an arc."
ARRIVED = 1e-12
"The largest angle by which a transfer may miss, rad."

COLUMNS = (
    "",
    "omega0 (rad/s)",
    "cost (N m s)",
    "energy (J)",
    "peak (rad/s)",
    "miss (rad)",
    "burst 1 %, 1° (deg)",
)


@dataclass(frozen=True, slots=True)
class Plan:
    """The planned transfers of one manoeuvre, the cheapest first.

    families: the number asked for; limits may leave fewer.
    """

    manoeuvre: Manoeuvre
    transfers: tuple[Transfer, ...]
    families: int

    @property
    def best(self) -> Transfer:
        """The cheapest transfer within the limits."""
        return self.transfers[0]

    def at(self, duration: ExactNumber) -> "Plan":
        """Return the plan of the same manoeuvre with another duration.

        Without limits and spins it only scales: rates go with 1 / duration, misses stay the same
        (facts faster.kinematics, faster.euler).  Else it is planned anew.

        Parameters
        ----------
        duration : number
            Time from the first burst to the last, s, taken exactly.

        Raises
        ------
        InputError
            As `plan` does.
        """
        old, engine = self.manoeuvre, self.best.engine
        wanted = above_zero("duration", duration)
        asked = replace(old, duration=wanted)
        if asked != Manoeuvre(old.inertia, old.start, old.target, wanted):
            return solve(asked, self.families, engine)
        ratio = (old.duration or wanted) / wanted
        faster = tuple(one.faster(asked, ratio) for one in self.transfers)
        return Plan(asked, faster, self.families)

    @property
    def title(self) -> str:
        """Title of the table of transfers, with the duration and notes on the plan.

        There are notes on zero cost, growing errors and missing families.
        """
        said = [f"rigidsym plan: {self.best.duration:.12g} s"]
        if self.manoeuvre.trivial:
            said.append("start equals target, nothing to do")
        elif self.best.cost == 0:
            said.append("the body arrives by itself")
        grown = max(one.growth_exponent for one in self.transfers)
        if grown:
            said.append(f"errors grow by up to e^{grown:.1f}, about the middle axis")
        if len(self.transfers) < self.families:
            said.append(f"{len(self.transfers)} of {self.families}, no others are within reach")
        return "; ".join(said)

    def table(self) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
        """Return the columns and rows of the table of transfers.

        The last column has the effects of errors.
        """
        rows = []
        for k, one in enumerate(self.transfers, 1):
            rates = ", ".join(f"{x:.9g}" for x in one.omega0)
            figures = (f"{x:.6g}" for x in (one.cost, one.energy, one.peak_rate))
            rows.append((str(k), rates, *figures, one.miss, one.missed))
        return COLUMNS, rows

    def write(self, directory: Path) -> list[Path]:
        """Write plan.json, a case file for each transfer, and a picture to a directory.

        The case files are for `rigidsym propagate`.

        Case files of an earlier plan are removed.

        Parameters
        ----------
        directory : Path
            Folder of the files; it is made where it is missing.

        Returns
        -------
        list of Path
            The files written.
        """
        from rigidsym.view._plots.figure import files
        from rigidsym.view._plots.motions import transfers

        cases = {f"transfer-{k}.toml": one.to_case() for k, one in enumerate(self.transfers, 1)}
        pictures = files({"transfers": transfers(self.transfers)})
        for path in directory.glob("transfer-*.toml"):
            if path.name not in cases:
                remove(path)
        return write_all(directory, {"plan.json": self.to_json(), **cases, **pictures})

    def to_json(self) -> str:
        """Return the plan as JSON in the schema rigidsym.plan/1."""
        data = {
            "schema": SCHEMA,
            "manoeuvre": self.manoeuvre.to_data(),
            "families": self.families,
            "transfers": [transfer.to_data() for transfer in self.transfers],
        }
        return json.dumps(data, indent=1) + "\n"

    def __repr__(self) -> str:
        from rigidsym.view._motions import plan_text

        return plan_text(self)

    def _repr_html_(self) -> str:
        from rigidsym.view._motions import plan_html

        return plan_html(self)


def plan(
    inertia: Vector3,
    start: Quaternion,
    target: Quaternion,
    duration: ExactNumber | None = None,
    *,
    start_spin: Vector3 = REST,
    target_spin: Vector3 = REST,
    max_rate: ExactNumber | None = None,
    max_burst: ExactNumber | None = None,
    degrees: bool = False,
    families: int = 1,
    engine: str = engines.DEFAULT,
) -> Plan:
    """Plan torque-free motions that take a body from one attitude to another in a given time.

    Every transfer misses the target by at most 1e-12 rad, by the derived solution at thirty
    digits.  Source: section V of the paper.

    Parameters
    ----------
    inertia : array (3,)
        Principal moments, kg m^2.
    start, target : array (4,)
        Quaternions, scalar first, body to inertial; either sign of the target is reached.
    duration : number, optional
        Time from the first burst to the last, s; None for the shortest that the limits allow.
    start_spin, target_spin : array (3,)
        Body rates before and after, rad/s.
    max_rate : number, optional
        Limit of |omega| on the way, rad/s.
    max_burst : number, optional
        Limit of either burst, N m s.
    degrees : bool
        Whether spins and `max_rate` are in deg/s.
    families : int
        Number of transfers, the cheapest first; there are infinitely many.
    engine : str
        Engine of the states, as for `TorqueFreeMotion`.

    Returns
    -------
    Plan
        The transfers, the cheapest first.

    Raises
    ------
    InputError
        For bad input; for limits that cannot be kept, with the limit that binds and a duration
        that would do; and where spins turn the body so often in the duration, some fifty times,
        that there are too many motions to search.

    Examples
    --------
    >>> found = plan((0.0109, 0.04, 0.0506), (1, 0, 0, 0), (0.5, 0.5, 0.5, 0.5), 180)
    >>> found.best.omega0.round(6), round(found.best.cost, 6)
    (array([0.010731, 0.00148 , 0.007482]), 0.000801)
    """
    asked = manoeuvre(
        inertia,
        start,
        target,
        duration,
        start_spin=start_spin,
        target_spin=target_spin,
        max_rate=max_rate,
        max_burst=max_burst,
        degrees=degrees,
    )
    return solve(asked, families, engine)


def solve(asked: Manoeuvre, families: int = 1, engine: str = engines.DEFAULT) -> Plan:
    """Plan the transfers of a `Manoeuvre`.

    Arguments and errors are those of `plan`.
    """
    count = inputs.whole("families", families, MOST_FAMILIES)
    try:
        return _solve(asked, count, engine)
    except TooManyError:
        raise _too_many(asked, count) from None


def _solve(asked: Manoeuvre, count: int, engine: str) -> Plan:
    posed = problem(asked.inertia, asked.start, asked.target, engines.engine(engine))
    bursts = Bursts.of(posed, asked)
    duration = shortest(bursts, asked) if asked.duration is None else asked.duration
    asked = replace(asked, duration=duration)
    chosen = cheapest(bursts, float(duration), count)
    if not len(chosen):
        refuse(bursts, asked)
    found = [verified(posed, asked, rates) for rates in chosen]
    # Motions that miss by more at thirty digits are beside a double zero, and do not arrive.
    found = [(rates, residual) for rates, residual in found if residual <= ARRIVED]
    if not found:
        raise PrecisionError(f"target: no motion was brought to within {ARRIVED} rad of it")
    turned = np.array([[float(x * duration) for x in rates] for rates, _ in found])
    highest = (peaks(posed, turned) / float(duration)).tolist()
    ways = zip(found, highest, strict=True)
    return Plan(asked, tuple(Transfer(asked, *one, peak, engine) for one, peak in ways), count)


def _too_many(asked: Manoeuvre, count: int) -> InputError:
    """Return the error for an input that leads to too many motions to search.

    It names the spin, the number of families or the body.
    """
    spins = {"spin.start": asked.start_spin, "spin.target": asked.target_spin}
    fastest = max(spins, key=lambda name: max(map(abs, spins[name])))
    if any(spins[fastest]):
        rule = "turns the body so often that there are too many motions: take a shorter duration"
        return InputError(fastest, inputs.shown(spins[fastest]), rule)
    if count > 1:
        return InputError("families", count, "there are too many motions to search: take fewer")
    rule = "a needle turns so often that there are too many motions to search"
    return InputError("inertia", inputs.shown(asked.inertia), rule)


def directions_of(plan: Plan) -> "Figure":
    """Draw the paths of a plan's momentum directions on a sphere, relative to body axes.

    It has the cone of all directions in which a natural motion can arrive; and of each transfer the
    polhode, thin, and the path of the momentum on it, thick, from a dot on the cone on.  A turn
    that is a symmetry of the body allows every direction: one of each polhode is drawn.

    Parameters
    ----------
    plan : Plan
        The transfers to draw.

    Returns
    -------
    plotly.graph_objects.Figure
        A figure that can be turned.

    Raises
    ------
    ImportError
        Without plotly.
    """
    from rigidsym.view.scenes._pictures import directions

    asked = plan.manoeuvre
    posed = problem(asked.inertia, asked.start, asked.target, engines.engine("numpy"))
    curves = arcs(posed)
    cone = [
        curves.direction(np.linspace(begin, end, AN_ARC), np.full(AN_ARC, k))
        for k, (begin, end) in enumerate(curves.ends)
    ]
    # A sphere has no cone: its momentum has the direction of its rates.
    name = "one of each polhode" if is_symmetry(posed) else "cone of directions"
    moving = {f"transfer {k}": x for k, x in enumerate(plan.transfers, 1) if x.momentum}
    title = f"Momenta that arrive in {plan.best.duration:g} s"
    return directions(asked.inertia, (name, cone), moving, title)
