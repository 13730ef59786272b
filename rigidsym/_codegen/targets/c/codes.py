"""Status codes of the generated C functions, with their messages."""

import ast
from typing import NamedTuple

from rigidsym._codegen.formats import BINARY64, Format
from rigidsym._codegen.forms import STEP, limits
from rigidsym._codegen.routines import INT, Enumeration, Number, Type


class Code(NamedTuple):
    """Meaning of a status code: field, broken rule, and remark for the C header."""

    field: str
    rule: str
    remark: str = ""


# Words are those of `rigidsym._inputs` and of the NumPy module, where these refuse the same.
_CODES = {
    "OK": Code("", "success"),
    "NOT_FINITE": Code("", "every number must be finite", "times, too"),
    "INERTIA": Code("inertia", "principal moments must be positive"),
    "THIN": Code(
        "inertia",
        "principal moments differ by more than binary64 can follow",
        "one is below 2^@min_moment_ratio@ of another",
    ),
    "ATTITUDE": Code("attitude0", "a zero quaternion is no attitude"),
    "SEPARATRIX": Code(
        "t",
        "nearer to the separatrix than binary64 can follow so long",
        "or to spin about the middle axis",
    ),
    "TIME": Code("t", "beyond |omega| t = 2^@max_angle@ rad the angle is lost in binary64"),
    "RATES": Code("omega0", "rates beyond what binary64 can hold", "2^@max_rate@ rad/s"),
    "ARITHMETIC": Code(
        "arithmetic",
        "sums are reordered or not rounded to nearest",
        "by this build's options, or by the processor",
    ),
    "GROWTH": Code(
        "t",
        "on the way to spin about the middle axis squares of changes leave binary64",
    ),
    "NONPHYSICAL": Code(
        "inertia",
        "no body has a principal moment larger than the sum of the other two"
        " (-DALLOW_NONPHYSICAL lets it pass)",
    ),
    "UNPREPARED": Code("motion", "torque_free_motion_init has not made it"),
    "ANGLE": Code(
        "dt", "|omega dt| must be at most 8 rad", "or a body that cannot exist turns faster still"
    ),
}
_OF_STEPS = {
    "ATTITUDE": _CODES["ATTITUDE"]._replace(field="q"),
    "UNPREPARED": Code("body", "torque_free_body_init has not made it"),
}
# What functions say of any other number.
UNKNOWN = "no such code"
# In the order of their numbers, from 0 on.
_MOTIONS = (
    *("OK", "NOT_FINITE", "INERTIA", "THIN", "ATTITUDE", "SEPARATRIX", "TIME", "RATES"),
    *("ARITHMETIC", "GROWTH", "NONPHYSICAL", "UNPREPARED"),
)
_STEPS = (
    *("OK", "NOT_FINITE", "INERTIA", "THIN", "ATTITUDE", "ANGLE", "ARITHMETIC"),
    *("NONPHYSICAL", "UNPREPARED"),
)


def _own(form: str, binary: Format = BINARY64) -> dict[str, Code]:
    """Return the codes of a form by their names, in the order of their numbers."""
    known = _CODES | (_OF_STEPS if form == STEP else {})
    return {
        name: Code(*(_with_limits(text, form, binary) for text in known[name]))
        for name in (_STEPS if form == STEP else _MOTIONS)
    }


def _with_limits(text: str, form: str, binary: Format) -> str:
    """Replace the names of limits in a text by their exponents."""
    for limit in limits(form, binary):
        text = text.replace(f"@{limit.name}@", str(limit.exponent))
    return text


def names(form: str) -> dict[str, str]:
    """Map the name of each code in the runtime to its name in C."""
    prefix = "TORQUE_FREE_STEP" if form == STEP else "TORQUE_FREE"
    return {name: f"{prefix}_{name}" for name in _own(form)}


def enumeration(form: str, binary: Format = BINARY64) -> Enumeration:
    """Return the codes of a form, with what each says."""
    summary = "Return codes; 0 is success."
    if form != STEP:
        summary += "  A call for one body that fails writes nothing."
    numbers = (
        Number(name, INT, ast.Constant(number), f"{x.rule}; {x.remark}" if x.remark else x.rule)
        for number, (name, x) in enumerate(_own(form, binary).items())
    )
    return Enumeration(summary, tuple(numbers))


def texts(form: str) -> list[Number]:
    """Return the arrays of messages, fields and rules, by code, and the text for no code."""
    own = _own(form).values()
    found = {
        "MESSAGES": [f"{x.field}: {x.rule}" if x.field else x.rule for x in own],
        "FIELDS": [x.field for x in own],
        "RULES": [x.rule for x in own],
    }
    return [
        Number("CODES", Type("int"), ast.Constant(len(own))),
        Number("UNKNOWN", Type("text"), ast.Constant(UNKNOWN)),
        *(
            Number(name, Type("text", ("CODES",)), ast.List([ast.Constant(x) for x in said]))
            for name, said in found.items()
        ),
    ]
