"""Statements and hypotheses in LaTeX: what stands on both sides of the turnstile."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from rigidsym.language.latex import latex

RELATIONS = (" != ", " >= ", " <= ", " = ", " > ", " < ")
SIGNS = {"!=": r"\neq", ">=": r"\geq", "<=": r"\leq"}
_ZEROS = {"0", "D(0)"}
_FORMS: dict[str, Callable[[str, str], str]] = {
    "equal": lambda left, right: f"{left} = {right}",
    "unequal": lambda left, right: rf"{left} \neq {right}",
    "root": lambda left, right: rf"{left} = \sqrt{{{right}}}",
    "nonnegative": lambda left, right: rf"{left} = {right} \geq 0",
}


def word(text: str) -> str:
    """A name that stands for a context, upright."""
    shown = text.replace("_", r"\_")
    return rf"\mathrm{{{shown}}}"


def statements(fact: Mapping[str, Any]) -> list[str]:
    """The components of a statement, each once, without those that are alike on both sides."""
    if fact["kind"] == "model":
        return [word(fact["rhs"][0])]
    if fact["kind"] == "partition":
        return [r" \sqcup ".join(map(word, fact["rhs"]))]
    pairs = dict.fromkeys(zip(fact["lhs"], fact["rhs"], strict=True))
    telling = [pair for pair in pairs if len({*pair} - _ZEROS) > 0 and pair[0] != pair[1]]
    form = _FORMS[fact["kind"]]
    return [form(latex(left), latex(right)) for left, right in telling or pairs]


def turnstile(kind: str) -> str:
    """What stands between hypotheses and statement."""
    return {"model": r"\models", "partition": "="}.get(kind, r"\vdash")


def hypotheses(context: Mapping[str, Any]) -> dict[str, list[str]]:
    """What a context assumes, by kind."""
    rates = context["rates"] or {}
    return {
        "relation": [f"{latex(text)} = 0" for text in context["relations"]],
        "unit": [rf"{latex(text)} \neq 0" for text in context["units"]],
        "sign": [rf"{latex(text)} \geq 0" for text in context["nonnegative"]],
        "rate": [f"{latex(f'D({name})')} = {_rate(rate)}" for name, rate in rates.items()],
        "definition": [f"{latex(k)} := {latex(v)}" for k, v in context["definitions"].items()],
    }


def _rate(text: str) -> str:
    return r"\mathrm{unknown}" if text == "?" else latex(text)


def condition(text: str) -> str | None:
    """A condition such as "c_i != c_j" in LaTeX; None where it is in words."""
    for sign in RELATIONS:
        left, found, right = text.partition(sign)
        if found:
            try:
                return f"{latex(left)} {SIGNS.get(sign.strip(), sign.strip())} {latex(right)}"
            except (ValueError, SyntaxError):
                return None
    return None


def point(values: Mapping[str, str]) -> list[str]:
    """A rational point, a coordinate each."""
    return [f"{latex(name)} = {latex(value)}" for name, value in values.items()]


def listed(parts: Sequence[str]) -> str:
    """Formulas in one line."""
    return r",\quad ".join(parts)
