"""Published sequences of any ledger over balls, with functions taken from their meaning."""

from collections.abc import Mapping
from typing import Any

from flint import acb, arb

from rigidsym.errors import LedgerError
from rigidsym.language._expression import (
    Call,
    Expression,
    children,
    complement,
    names,
    parse,
    rebuild,
)
from rigidsym.language._sequence import CONSTANTS, FormulaSequence
from rigidsym.language._specification import Proved, Unproved
from rigidsym.precise._balls import ball
from rigidsym.precise._evaluation import exactly
from rigidsym.precise._functions import Theta, carlson_f, quarter_period
from rigidsym.solution._formulas import OF_PARAMETER

Origin = tuple[str, str]


class Values(dict[str, Any]):
    """Values by name, with the sequence and the output that each one comes from."""

    def __init__(self, values: Mapping[str, Any], origins: Mapping[str, Origin]) -> None:
        super().__init__(values)
        self.origins = dict(origins)

    def __missing__(self, name: str) -> Any:
        """Refuse a ledger that does not set a name."""
        raise LedgerError(f"ledger: no published sequence sets {name}")

    def plus(self, *others: Mapping[str, Any], **more: Any) -> "Values":
        """Return these values with others in their place where names agree."""
        found = Values(self, self.origins)
        for other in (*others, more):
            for name, value in other.items():
                found[name] = value
                found.origins.pop(name, None)
                if isinstance(other, Values) and name in other.origins:
                    found.origins[name] = other.origins[name]
        return found

    def of(self, names: str) -> "Values":
        """Return some of the values."""
        chosen = names.split()
        origins = {name: self.origins[name] for name in chosen if name in self.origins}
        return Values({name: self[name] for name in chosen}, origins)

    def without(self, names: set[str]) -> "Values":
        """Return all values but some."""
        kept = [name for name in self if name not in names]
        return self.of(" ".join(kept))


class Sequences:
    """The formula sequences that a ledger publishes, and which of their outputs are compared."""

    def __init__(self, ledger: Proved) -> None:
        self.sequences: dict[str, FormulaSequence] = {}
        for name, entries in ledger.sequences.items():
            try:
                formulas = [ledger.formula(entry) for entry in entries]
                self.sequences[name] = FormulaSequence(
                    (
                        f.name,
                        by_complement(parse(f"sqrt({f.text})" if f.how == "root" else f.text)),
                    )
                    for f in formulas
                )
            except (Unproved, LookupError, TypeError, ValueError, SyntaxError) as error:
                raise LedgerError(f"ledger: sequence {name}: {error}") from None
        self.names = {
            name: [(output, frozenset(names(x))) for output, x in sequence.formulas]
            for name, sequence in self.sequences.items()
        }
        self.functions = functions()
        self.constants = {x: self.functions[x] for x in CONSTANTS}
        self.uses: dict[Origin, set[Origin]] = {}
        self.compared: set[Origin] = set()
        self.last = ""

    def published(self, name: str) -> FormulaSequence:
        """Return a published sequence."""
        if name not in self.sequences:
            raise LedgerError(f"ledger: the sequence {name} is not published")
        return self.sequences[name]

    def evaluate(self, name: str, given: Values, *others: Mapping[str, Any], **more: Any) -> Values:
        """Evaluate a published sequence; return its outputs beside all that is given."""
        self.last = name
        sequence, known = self.published(name), given.plus(*others, more)
        if missing := sorted(sequence.inputs - {*known}):
            raise LedgerError(f"ledger: sequence {name}: it needs {', '.join(missing)}")
        values = {x: known[x] for x in sequence.inputs} | self.constants
        try:
            found = exactly(sequence, values, self.functions, number)
        except (KeyError, NameError) as error:
            raise LedgerError(
                f"ledger: sequence {name}: it uses {error} before it is set"
            ) from None
        except ZeroDivisionError:
            raise LedgerError(f"ledger: sequence {name}: it divides by zero") from None
        except (TypeError, ValueError, AttributeError) as error:
            raise LedgerError(f"ledger: sequence {name}: {error}") from None
        result = Values(known, known.origins)
        for output, used in self.names[name]:
            here = {result.origins[x] for x in used if x in result.origins}
            self.uses.setdefault((name, output), set()).update(here)
            result[output], result.origins[output] = found[output], (name, output)
        return result

    def left(self) -> list[Origin]:
        """Return the outputs that no comparison depends on."""
        reached, waiting = set(self.compared), [*self.compared]
        while waiting:
            for other in self.uses.get(waiting.pop(), ()):
                if other not in reached:
                    reached.add(other)
                    waiting.append(other)
        every = [(s, x) for s, formulas in self.sequences.items() for x, _ in formulas.formulas]
        return [origin for origin in every if origin not in reached]


def by_complement(expression: Expression) -> Expression:
    """Replace the parameter m of functions by 1 - m."""
    parts = tuple(map(by_complement, children(expression)))
    if isinstance(expression, Call) and expression.function in OF_PARAMETER:
        parts = (*parts[:-1], complement(parts[-1]))
    return rebuild(expression, parts)


def number(value: Any) -> Any:
    """Convert an exact number to a ball."""
    return value if isinstance(value, arb | acb) else ball(value)


class _Functions(Theta):
    """All functions that meanings use; the last argument is 1 - m, or the nome."""

    def table(self) -> dict[str, Any]:
        """Return the functions by name."""
        table = {
            **super().table(),
            "jacobi_sn": lambda u, mc: self.three(u, mc)[0],
            "jacobi_cn": lambda u, mc: self.three(u, mc)[1],
            "jacobi_dn": lambda u, mc: self.three(u, mc)[2],
            "jacobi_am": self.amplitude,
            "arcsn": lambda s, mc: s * carlson_f(1 - s * s, 1 - (1 - mc) * s * s, arb(1)),
            "elliptic_pi": self.third_kind,
        }
        for k in range(1, 5):
            table[f"theta{k}"] = lambda z, q, k=k: self.theta(k, 0, z, q)
            table[f"dtheta{k}"] = lambda z, q, k=k: self.theta(k, 1, z, q)
        return table

    def theta(self, k: int, order: int, z: Any, q: arb) -> Any:
        """Return a theta function or its derivative, which is real at real arguments."""
        tau = acb(0, -q.log() / arb.pi())
        value = (acb(z) / arb.pi()).modular_theta(tau, order)[k - 1] / arb.pi() ** order
        return value.real if isinstance(z, arb) else value

    def three(self, u: arb, mc: arb) -> tuple[arb, arb, arb]:
        """Return sn, cn and dn, for negative parameters too (DLMF 22.17(i))."""
        if not mc > 1:
            return self.jacobi(u, mc)
        root = mc.sqrt()
        s, c, d = self.jacobi(u * root, 1 / mc)
        return s / (root * d), c / d, 1 / d

    def turns(self, u: arb, mc: arb) -> int:
        """Return the number of half turns of am(u) that is nearest to it."""
        return int((u / (2 * quarter_period(mc)) + arb(1) / 2).mid().floor().unique_fmpz() or 0)

    def amplitude(self, u: arb, mc: arb) -> arb:
        """Return Jacobi's amplitude am(u)."""
        s, c, _ = self.three(u, mc)
        turns = self.turns(u, mc)
        sign = -1 if turns % 2 else 1
        return arb.atan2(sign * s, sign * c) + turns * arb.pi()

    def third_kind(self, n: arb, phi: arb, mc: arb | None = None) -> arb:
        """Return Legendre's integral Pi(n; phi | m), or the complete one Pi(n | m)."""
        if mc is None:
            return quarter_period(phi) + n * self.complete_j(n, phi)
        turns = int((phi / arb.pi() + arb(1) / 2).mid().floor().unique_fmpz() or 0)
        rest = phi - turns * arb.pi()
        s, c = rest.sin_cos()
        square = 1 - (1 - mc) * s * s
        part = s * carlson_f(c * c, square, arb(1))
        part += n * s**3 * acb.elliptic_rj(c * c, square, arb(1), 1 - n * s * s).real / 3
        return part + (2 * turns * self.third_kind(n, mc) if turns else 0)


def functions() -> dict[str, Any]:
    """Return functions over balls by the names that meanings call."""
    return _Functions().table()
