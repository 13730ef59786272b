"""Definitions under the specification, and forged versions of each."""

from typing import Any

from rigidsym.language._expression import Call, Number, Operation, parse, to_text
from rigidsym.language._specification import theorems


def changes(text: str) -> dict[str, str]:
    """Return forged versions of a definition, by the kind of change.

    A version has a flipped sign, a dropped term or factor, or a factor 2.
    """
    tree = parse(text)
    found = {"flipped": _flipped(tree), "doubled": Operation("*", Number(2), tree)}
    if isinstance(tree, Operation) and tree.operator != "**":
        found["dropped"] = tree.left
    return {kind: to_text(changed) for kind, changed in found.items()}


def _flipped(tree):
    match tree:
        case Operation("+" | "-" as sign, left, right):
            return Operation("-" if sign == "+" else "+", left, right)
        case Call("neg", (operand,)):
            return operand
    return Call("neg", (tree,))


def definitions(specification: str, data: Any) -> list[tuple[str, str]]:
    """Return the name and text of each definition in the contexts of a specification."""
    named = theorems(specification)
    contexts = [context for context in data["contexts"] if context["name"] in named]
    return [*dict.fromkeys(pair for c in contexts for pair in c["definitions"].items())]
