"""Contexts whose hypotheses are consistent and preserved in time."""

from flint import fmpq

from rigidsym.proof.checker._language import Form, Forms, is_name
from rigidsym.proof.checker._records import Hypotheses, Refused
from rigidsym.proof.checker._ring import Ring
from rigidsym.proof.checker._theta import Functions


class Theory:
    """A checked context, with its ring, signs and theta functions.

    Its hypotheses hold at some point and, if it moves, at all later times.
    """

    def __init__(self, given: Hypotheses) -> None:
        _check_names(given)
        self.given, self.ring = given, (ring := Ring(given.generators, given.definitions))
        for unit in given.units:
            ring.units.append(ring.read(unit).above)
        ring.relations = [ring.read(relation).above for relation in given.relations]
        if given.rates is not None:
            rates = given.rates.items()
            ring.rates = {name: None if rate == "?" else ring.read(rate) for name, rate in rates}
        for name in given.definitions:  # now, lest one that nothing uses go unread
            ring.name(name)
        self.signs = [*map(ring.read, given.nonnegative)]
        self._nonnegative = {Forms().read(text) for text in given.nonnegative}
        self.start = [ring.read(text).above for text in given.start]
        self.thetas = Functions(ring, given.thetas)
        self.thetas.check(given.generators, given.rates)
        self._check_closed()
        at = self.point(given.witness)
        if self.start and (given.rates is None or any(zero(*at) for zero in self.start)):
            raise Refused("it does not start at its witness, or has no time to start at")

    def point(self, values: dict[str, str]) -> list[fmpq]:
        """Check that a rational point satisfies every hypothesis, and return it.

        Raises Refused if it does not.
        """
        if values.keys() != {*self.given.generators}:
            raise Refused("a point gives other names than the generators")
        at = [rational(values[name]) for name in self.ring.polynomials.names()]
        if not all(unit(*at) for unit in self.ring.units):
            raise Refused("a unit is zero at the point")
        if any(relation(*at) for relation in self.ring.relations):
            raise Refused("a relation does not hold at the point")
        if any(sign.above(*at) / sign.below(*at) < 0 for sign in self.signs):
            raise Refused("a sign is wrong at the point")
        zeros = [sign for sign in self.signs if not sign.above(*at)]
        rates = map(self.ring.rate, zeros if self.ring.rates is not None else ())
        if any(self.ring.remainder(rate.above) for rate in rates):
            raise Refused("a sign is about to be wrong: 0 at the point, and it moves")
        return at

    def shows_sign(self, text: str) -> bool:
        """Return whether an expression is visibly nonnegative.

        Such are the declared nonnegative quantities, their sums, products and quotients, and all
        even powers, since names are real.
        """
        return self._shows(Forms().read(text))

    def _shows(self, form: Form) -> bool:
        if form in self._nonnegative:
            return True
        match form:
            case int():
                shown = True
            case str(name):
                shown = name in self.given.definitions and self.shows_sign(
                    self.given.definitions[name]
                )
            case ("**", base, int(exponent)):
                shown = exponent % 2 == 0 or self._shows(base)
            case ("+" | "*" | "/", left, right):
                shown = self._shows(left) and self._shows(right)
            case _:
                shown = False
        if shown:  # once is enough, however often it occurs
            self._nonnegative.add(form)
        return shown

    def states(self, lhs: str, rhs: str) -> bool:
        """Return True if an equation is an identity, a definition or a known derivative."""
        left, right = map(Forms().read, (lhs, rhs))
        return left == right or self._has_for(left) == right or self._has_for(right) == left

    def _has_for(self, form: Form) -> Form | None:
        text, rates = "?", self.given.rates
        match form:
            case str(name):
                text = self.given.definitions.get(name, "?")
            case ("call", "D", str(name)) if rates is not None and name in self.given.generators:
                text = rates.get(name, "0")
        return None if text == "?" else Forms().read(text)

    def _check_closed(self) -> None:
        """Raise Refused if a relation has a time derivative that does not vanish.

        It could hold at one instant only.
        """
        ring = self.ring
        for relation in ring.relations if ring.rates is not None else ():
            if ring.remainder(ring.rate(ring.over_one(relation)).above):
                raise Refused(f"{relation} = 0 is not closed under d/dt")


def _check_names(given: Hypotheses) -> None:
    """Raise Refused for names that are invalid or ambiguous.

    Rates of names that are no generators are refused, too.
    """
    names = [*given.generators, *given.definitions]
    if len({*names}) < len(names) or not all(map(is_name, [given.name, *names])) or "D" in names:
        raise Refused("a name is no name, or means two things")
    if not (given.rates or {}).keys() <= {*given.generators}:
        raise Refused("a rate is given to what is not a generator")


def rational(text: str) -> fmpq:
    """Evaluate an expression without names as a rational number."""
    return Ring([], {}).read(text).above.leading_coefficient()
