"""The forms of the solution that modules are generated in."""

from rigidsym.errors import InputError

THETA, PI, STEP = "theta", "pi", "step"
# What a module flies by; the first is the default.
FORMS = {
    THETA: "two theta functions of a shifted time",
    PI: "one integral of the third kind, and no theta function",
    STEP: "one step from any state, by its elapsed time alone",
}


def checked(form: str) -> str:
    """The form; raises InputError for one that there is not."""
    if form not in FORMS:
        raise InputError("form", form, f"must be one of: {', '.join(FORMS)}")
    return form


def split(key: str) -> tuple[str, str]:
    """Target and form of a module's key.

    >>> split("c"), split("numpy-pi")
    (('c', 'theta'), ('numpy', 'pi'))
    """
    target, _, form = key.partition("-")
    return target, form or THETA


def option(form: str) -> str:
    """What a command says for a form: nothing for the default."""
    return "" if form == THETA else f" --form {form}"


def key(target: str, form: str) -> str:
    """What names a module among all: its target, and its form where that is not the default."""
    return target if form == THETA else f"{target}-{form}"
