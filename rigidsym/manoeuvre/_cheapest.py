"""Search for the cheapest motions within limits and for the shortest possible duration.

Costs and limits are in the units of the dimensionless problem: momenta in the largest moment of
inertia over the duration, rates in 1 over the duration.  Where the turn is a symmetry of the body,
motions come in one-parameter families: each motion that arrives has others beside it, with the same
momentum and energy, all round its polhode (facts ring.kinematics, ring.momentum, ring.euler).  They
differ in their bursts where there are spins, and in their largest rates.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from decimal import ROUND_UP, Context, Decimal
from fractions import Fraction
from functools import cached_property
from itertools import product
from typing import NoReturn

import numpy as np

from rigidsym.errors import InputError
from rigidsym.manoeuvre._directions import is_symmetry
from rigidsym.manoeuvre._families import families, least
from rigidsym.manoeuvre._manoeuvre import Manoeuvre
from rigidsym.manoeuvre._problem import IDENTITY, Problem
from rigidsym.manoeuvre._transit import peaks, phases

# Relative room for rounding, at limits as well.
_ROUNDING = 1e-12
# From rates (N, 3) to a value (N,) of each motion.
Values = Callable[[np.ndarray], np.ndarray]

_NEVER = "found no natural motion that keeps to it, at any duration, up to some twenty turns"
# Durations are longer by this part than the shortest, so that rounding does not break limits.
_ROOM = 1e-12
_GROWTH = 1.5
# Where spins need more than a burst may give, there may be no motion within the limits.  The search
# ends here, at momenta of some twenty turns.
_LARGEST = 30.0
_SHOWN = Context(prec=6, rounding=ROUND_UP)
# Samples of a one-parameter family; the rounds that follow reach a part of 3e-14 of it.
_PHASES = 64
_FINER, _ROUNDS = 8, 13
_ARRIVED = 1e-9
# Half turns about the principal axes take polhodes to polhodes.
_IMAGES = np.array([signs for signs in product((1, -1), repeat=3) if np.prod(signs) == 1])


@dataclass(frozen=True)
class Bursts:
    """Sizes and limits of bursts, the impulses that start and stop a motion.

    Numbers are for motions that take 1 s.

    before, after (3,): momenta outside of the motion, over the largest moment.  max_rate,
    max_burst: limits of rates and of either burst, inf where there is none.
    """

    problem: Problem
    before: np.ndarray
    after: np.ndarray
    max_rate: float
    max_burst: float

    @classmethod
    def of(cls, problem: Problem, manoeuvre: Manoeuvre) -> "Bursts":
        """Create an instance from a manoeuvre's initial spin, final spin and limits."""
        largest = max(manoeuvre.inertia)

        def momentum(spin: tuple[Fraction, ...]) -> np.ndarray:
            return np.array(
                [float(c * w / largest) for c, w in zip(manoeuvre.inertia, spin, strict=True)]
            )

        rate, burst = manoeuvre.limits.max_rate, manoeuvre.limits.max_burst
        return cls(
            problem,
            momentum(manoeuvre.start_spin),
            momentum(manoeuvre.target_spin),
            np.inf if rate is None else float(rate),
            np.inf if burst is None else float(burst / largest),
        )

    @cached_property
    def spin(self) -> float:
        """Sum of the magnitudes of the momenta before and after the manoeuvre.

        The cost of a motion of momentum K differs from 2 K by at most this sum.
        """
        return float(np.linalg.norm(self.before) + np.linalg.norm(self.after))

    def sizes(self, rates: np.ndarray, duration: float) -> np.ndarray:
        """Return the sizes (N, 2) of both bursts of motions with given initial rates (N, 3)."""
        begin = self.problem.inertia * rates
        end = begin @ self.problem.rotation
        bursts = [begin - duration * self.before, duration * self.after - end]
        return np.stack([np.linalg.norm(burst, axis=1) for burst in bursts], axis=1)

    def allowed(self, rates: np.ndarray, duration: float) -> np.ndarray:
        """Return for each motion whether it keeps to the limits.

        The result has the shape (N,), for rates (N, 3).
        """
        return self.excess(rates, duration) <= 1 + _ROUNDING

    def excess(self, rates: np.ndarray, duration: float) -> np.ndarray:
        """Return for each motion the larger of two ratios: peak rate to limit, burst to limit.

        The result has the shape (N,), for rates (N, 3).
        """
        needed = self.sizes(rates, duration).max(axis=1) / (self.max_burst * duration)
        if np.isfinite(self.max_rate):
            needed = np.maximum(needed, peaks(self.problem, rates) / (self.max_rate * duration))
        return needed

    def most(self, duration: float) -> float:
        """Return a momentum above which every motion exceeds the limits."""
        ends = [np.linalg.norm(end) for end in (self.before, self.after)]
        return duration * float(min([self.max_rate, *(self.max_burst + end for end in ends)]))

    @np.errstate(divide="ignore")
    def shortest(self, rates: np.ndarray) -> np.ndarray:
        """Return for each motion the shortest duration in which it keeps to the limits.

        The result has the shape (N,), for rates (N, 3).

        It is inf where there is none.
        """
        fastest = np.full(len(rates), np.inf)
        slowest = np.zeros(len(rates))
        if np.isfinite(self.max_rate):
            fastest = self.max_rate / peaks(self.problem, rates)
        begin = self.problem.inertia * rates
        for end, outside in ((begin, self.before), (begin @ self.problem.rotation, self.after)):
            low, high = _within(end, outside, self.max_burst)
            slowest, fastest = np.maximum(slowest, low), np.minimum(fastest, high)
        return np.where(slowest <= fastest * (1 + _ROUNDING), 1 / fastest, np.inf)


@np.errstate(divide="ignore", invalid="ignore")
def _within(end: np.ndarray, outside: np.ndarray, limit: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the interval of factors s for which |s v - w| is within a limit, for vectors v and w.

    The vectors v are the rows (N, 3) of `end`, and w is `outside` (3,).  The interval is a pair of
    arrays (N,); an empty interval is inf and 0.
    """
    if not np.isfinite(limit):
        return np.zeros(len(end)), np.full(len(end), np.inf)
    square, mixed = np.sum(end * end, axis=1), end @ outside
    root = mixed * mixed - square * (outside @ outside - limit * limit)
    found = (mixed + np.sqrt(root) * np.array([[-1.0], [1.0]])) / square
    if outside @ outside <= limit * limit:
        found[:, square == 0] = [[0.0], [np.inf]]
    never = np.isnan(found[0]) | (found[1] <= 0)
    return np.where(never, np.inf, np.maximum(found[0], 0)), np.where(never, 0.0, found[1])


def cheapest(bursts: Bursts, duration: float, count: int) -> np.ndarray:
    """Return the initial rates (N, 3) of the cheapest motions within the limits.

    At most `count` motions are returned.

    From rest to rest a motion costs twice its momentum (facts manoeuvre.first_burst,
    manoeuvre.last_burst).  Spins before and after can save at most their own momenta.  So the
    motions up to a cost are among those up to a momentum, which can all be searched.
    """
    spins = bursts.spin * duration
    most = bursts.most(duration)
    bound = min(least(bursts.problem) + spins, most)
    while True:
        known = _all(bursts, bound, lambda known: _within_limits(bursts, known, duration))
        allowed = known[bursts.allowed(known, duration)]
        costs = bursts.sizes(allowed, duration).sum(axis=1)
        order = np.argsort(costs, kind="stable")[:count]
        found = costs[order]
        needed = (found[-1] + spins) / 2 if len(found) == count else np.inf
        if min(needed, most) <= bound * (1 + _ROUNDING):
            return allowed[order]
        larger = _GROWTH * bound + bursts.problem.inertia.min()
        bound = min(needed, most) if needed < np.inf else min(larger, most)


def shortest(bursts: Bursts, asked: Manoeuvre) -> Fraction:
    """Return the shortest duration, in s, that the limits allow.

    Raises InputError where there is none.
    """
    found = _shortest(bursts)
    if found == 0:
        rule = "start equals target, which takes no time: give one"
        raise InputError("duration", "missing", rule)
    if not np.isfinite(found):
        _refuse(bursts, asked, lambda one: np.isfinite(_shortest(one)), _NEVER)
    return Fraction(found * (1 + _ROOM))


def refuse(bursts: Bursts, asked: Manoeuvre) -> NoReturn:
    """Raise an InputError that names the violated limit and a sufficient duration."""
    duration = float(asked.duration or 0)
    found = _shortest(bursts)
    rule = _NEVER
    if np.isfinite(found):
        enough = _SHOWN.create_decimal(Decimal(found))
        rule = f"no natural motion of {duration:g} s keeps to it; {enough.normalize():f} s would do"
    _refuse(bursts, asked, lambda one: len(cheapest(one, duration, 1)) > 0, rule)


def _refuse(
    bursts: Bursts, asked: Manoeuvre, can_be_kept: Callable[[Bursts], bool], rule: str
) -> NoReturn:
    """Raise an InputError that names the limits that no motion can keep.

    It names each limit that cannot be kept even alone; without such a limit, it names all.
    """
    limits = asked.limits
    alone = {
        "max_rate": (limits.max_rate, replace(bursts, max_burst=np.inf)),
        "max_burst": (limits.max_burst, replace(bursts, max_rate=np.inf)),
    }
    there = {name: (value, one) for name, (value, one) in alone.items() if value is not None}
    binding = [name for name, (_, one) in there.items() if not can_be_kept(one)] or [*there]
    values = ", ".join(f"{float(there[name][0]):g}" for name in binding)
    raise InputError(" and ".join(binding), values, rule)


def _shortest(bursts: Bursts) -> float:
    """Return the shortest duration, in s, that the limits allow, or inf if none was found."""
    bound = least(bursts.problem)
    # Motions of larger momentum than those searched need longer.
    while True:
        known = _all(bursts, bound, lambda known: _least(bursts, known, bursts.shortest))
        found = float(np.min(bursts.shortest(known), initial=np.inf))
        if found <= bound / bursts.most(1.0) * (1 + _ROOM) or bound > _LARGEST:
            return found
        bound = found * bursts.most(1.0) if np.isfinite(found) else _GROWTH * bound + 0.1


def _all(bursts: Bursts, bound: float, best: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
    """Return the initial rates (N, 3) of all motions with a momentum up to `bound`.

    Where motions of a one-parameter family differ in cost or in the limits they need, `best`
    replaces each motion by one of its family.
    """
    known = families(bursts.problem, bound)
    differ = bursts.spin > 0 or np.isfinite(bursts.max_rate)
    return best(known) if differ and is_symmetry(bursts.problem) else known


def _within_limits(bursts: Bursts, rates: np.ndarray, duration: float) -> np.ndarray:
    """Replace each motion by the cheapest allowed motion of its one-parameter family.

    Motions are given by their rates (N, 3).

    Where none is within them, it is the one nearest to the limits.
    """

    def excess(found: np.ndarray) -> np.ndarray:
        return bursts.excess(found, duration)

    def cost(found: np.ndarray) -> np.ndarray:
        return np.where(excess(found) <= 1, bursts.sizes(found, duration).sum(axis=1), np.inf)

    found = _least(bursts, rates, cost)
    beyond = ~bursts.allowed(found, duration)
    found[beyond] = _least(bursts, rates[beyond], excess)
    return found


def _least(bursts: Bursts, rates: np.ndarray, values: Values) -> np.ndarray:
    """Replace each motion by the minimiser of a function over its one-parameter family.

    Motions are given by their rates (N, 3).
    """

    def arrived(found: np.ndarray) -> np.ndarray:
        missed = np.linalg.norm(bursts.problem.misses(found), axis=1)
        return np.where(missed < _ARRIVED, values(found), np.inf)

    chosen = []
    for one in rates:
        shares = np.arange(_PHASES) / _PHASES
        images = _along(bursts, one, shares) * _IMAGES[:, None]
        image, place = divmod(int(np.argmin(arrived(images.reshape(-1, 3)))), _PHASES)
        share, width, found = shares[place], 1 / _PHASES, images[image]
        for _ in range(_ROUNDS):
            near = share + width * np.arange(-_FINER, _FINER + 1) / _FINER
            found = _along(bursts, one, near) * _IMAGES[image]
            place = int(np.argmin(arrived(found)))
            share, width = near[place], width / _FINER
        chosen.append(found[place] if np.isfinite(arrived(found[place : place + 1])[0]) else one)
    return np.array(chosen).reshape(-1, 3)


def _along(bursts: Bursts, rates: np.ndarray, shares: np.ndarray) -> np.ndarray:
    """Return motions of a one-parameter family, at given fractions of one period.

    The family is that of the motion with rates (3,); its members (N, 3) are at the shares (N,).
    """
    problem, size = bursts.problem, bursts.problem.momenta(rates)
    if size == 0:
        return np.zeros((len(shares), 3))
    period = phases(problem, (problem.inertia * rates / size)[None]).period[0] / size
    if np.isfinite(period):
        _, later = problem.engine.propagate(problem.inertia, rates, IDENTITY, shares * period)
        return later
    # Whole turns also arrive about other axes of the same moment; other spins have no family.
    axes = None if problem.angle else _equal_axes(bursts, rates)
    if axes is None:
        return np.tile(rates, (len(shares), 1))
    angles = 2 * np.pi * shares
    return np.linalg.norm(rates) * np.stack([np.cos(angles), np.sin(angles)], axis=-1) @ axes


def _equal_axes(bursts: Bursts, rates: np.ndarray) -> np.ndarray | None:
    """Return two principal axes (2, 3) that have the same moment as the axis of a spin.

    For a sphere, they span the plane of the spins before and after.  None without two such axes.
    """
    c = bursts.problem.inertia
    if c.min() == c.max():
        return np.linalg.svd([bursts.before, bursts.after])[2][:2]
    equal = c == c[np.argmax(np.abs(rates))]
    return np.eye(3)[equal] if equal.sum() == 2 else None
