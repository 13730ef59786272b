"""Names of the derivation in LaTeX: phi1 is \\phi_{1}, c_a_squared is c_{a}^{2}.

A name is read from its parts; what these do not tell is in the tables.
"""

import re
from dataclasses import dataclass

GREEK = frozenset(
    ("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu")
    + ("nu", "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega")
    + ("Gamma", "Delta", "Theta", "Lambda", "Xi", "Pi", "Sigma", "Phi", "Psi", "Omega")
)
VARIANTS = {"epsilon": r"\varepsilon"}
MARKS = {"plus": "+", "minus": "-", "star": r"\star", "squared": "2"}
FUNCTIONS = {"cos": r"\cos", "sin": r"\sin"}
PARTS = {"re": r"\operatorname{Re}", "im": r"\operatorname{Im}"}


@dataclass(frozen=True, slots=True)
class Symbol:
    """A name as LaTeX: the head, which takes an exponent, and the argument that follows it."""

    head: str
    argument: str = ""
    raised: bool = False

    @property
    def latex(self) -> str:
        """The name by itself."""
        return f"{self.head} {self.argument}" if self.argument else self.head

    def power(self, exponent: str) -> str:
        """The name to a power."""
        head = rf"\left({self.head}\right)" if self.raised else self.head
        return f"{head}^{{{exponent}}} {self.argument}".rstrip()


def symbol(name: str) -> Symbol:
    """The LaTeX of a name.

    >>> symbol("Omega1").latex, symbol("sin_half_phi2").power("2")
    ('\\\\Omega_{1}', '\\\\sin^{2} \\\\frac{\\\\phi_{2}}{2}')
    """
    base, _, last = name.rpartition("_")
    first, _, rest = name.partition("_")
    if first in FUNCTIONS and rest:
        return _function(FUNCTIONS[first], rest)
    if first == "sqrt" and rest:
        return Symbol(rf"\sqrt{{{symbol(rest).latex}}}", raised=True)
    if base and last in PARTS:
        return Symbol(PARTS[last], symbol(base).latex)
    if base and last == "squared":
        return Symbol(f"{symbol(base.rstrip('_')).latex}^{{2}}", raised=True)
    if base and last == "rate" and (letter := _letter(base.rstrip("0123456789"))):
        return Symbol(rf"\dot{{{letter}}}" + _below(re.findall(r"\d+", base)))
    if first == "minus" and rest:
        return Symbol(rf"\left(-{symbol(rest).latex}\right)")
    return Symbol(_indexed(name), raised=last == "star")


def _function(head: str, argument: str) -> Symbol:
    half, _, angle = argument.partition("_")
    if half != "half":
        return Symbol(head, symbol(argument).latex)
    return (
        Symbol(head, rf"\frac{{{symbol(angle).latex}}}{{2}}")
        if angle
        else Symbol(rf"{head}_{{1/2}}")
    )


def _indexed(name: str) -> str:
    """A base and what stands below it."""
    base, *below = [part for part in name.split("_") if part]
    letters = base.rstrip("0123456789")
    below = [part for part in (base[len(letters) :], *below) if part]
    bar = letters.endswith("bar") and _letter(letters.removesuffix("bar"))
    head = rf"\bar{{{bar}}}" if bar else _letter(letters) or rf"\mathrm{{{letters}}}"
    if below[-1:] == ["star"]:
        return rf"{head}^{{\star}}" + _below(below[:-1])
    return head + _below(below)


def _below(parts: list[str]) -> str:
    return f"_{{{','.join(map(_index, parts))}}}" if parts else ""


def _index(part: str) -> str:
    return MARKS.get(part) or _letter(part) or (part if part.isdigit() else rf"\mathrm{{{part}}}")


def _letter(text: str) -> str:
    """A letter, Latin or Greek; empty for anything else."""
    if text in GREEK:
        return VARIANTS.get(text, f"\\{text}")
    return text if len(text) == 1 and text.isalpha() else ""
