"""Which quantities show by their form that they are not negative, all names being real."""

from rigidsym.proof.checker.language import Form, Forms
from rigidsym.proof.checker.records import Hypotheses


class Signs:
    """What a context lets see: sums, products, quotients of what is seen, and even powers."""

    def __init__(self, given: Hypotheses) -> None:
        self._read = Forms().read
        self._definitions = given.definitions
        self._seen = {self._read(text) for text in given.nonnegative}

    def show(self, text: str) -> bool:
        """Whether the quantity is seen to be nonnegative, wherever it is defined."""
        return self._shown(self._read(text))

    def _shown(self, form: Form) -> bool:
        if form in self._seen:
            return True
        match form:
            case int():
                shown = True
            case str(name):
                shown = name in self._definitions and self.show(self._definitions[name])
            case ("**", base, int(exponent)):
                shown = exponent % 2 == 0 or self._shown(base)
            case ("+" | "*" | "/", left, right):
                shown = self._shown(left) and self._shown(right)
            case _:
                shown = False
        if shown:  # once is enough, however often it occurs
            self._seen.add(form)
        return shown
