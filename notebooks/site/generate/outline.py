"""The outline of JSON data: every path in it with its type, and a sample short enough to print."""

import json
from collections.abc import Iterator, Mapping
from typing import Any

_TYPES = {bool: "true or false", int: "whole number", float: "number", str: "text"}
_LONGEST, _MOST = 72, 2
MORE = "// and so on"


def paths(data: Any, named: frozenset[str], path: str = "") -> Iterator[tuple[str, str]]:
    """Pairs of path and type; `[]` stands for each entry of a list, `NAME` for any key.

    `named` are the paths of objects whose keys are data themselves.
    """
    if path:
        yield path, kind(data)
    if isinstance(data, Mapping):
        for key, value in data.items():
            name = "NAME" if path in named else key
            yield from paths(value, named, f"{path}.{name}" if path else name)
    elif isinstance(data, list):
        for value in data:
            yield from paths(value, named, f"{path}[]")


def kind(value: Any) -> str:
    """What a value of JSON is called."""
    if isinstance(value, Mapping):
        return "object"
    if isinstance(value, list):
        return "list"
    return "null" if value is None else _TYPES[type(value)]


def sample(data: Any, named: frozenset[str]) -> str:
    """JSON with comments where something was left out."""
    return "\n".join(_lines(data, named, ""))


def _lines(data: Any, named: frozenset[str], path: str) -> list[str]:
    if isinstance(data, Mapping):
        keys, inner = list(data), path in named
        kept = keys[:_MOST] if inner else keys
        parts = [
            (
                f"{json.dumps(key, ensure_ascii=False)}: ",
                data[key],
                f"{path}.{'NAME' if inner else key}".lstrip("."),
            )
            for key in kept
        ]
        return _block("{}", parts, len(keys) > len(kept), named)
    if isinstance(data, list):
        plain = not any(isinstance(x, (Mapping, list)) for x in data)
        whole = json.dumps(data, ensure_ascii=False)
        if plain and len(whole) <= _LONGEST:
            return [whole]
        kept = data[: _MOST if plain else 1]
        return _block("[]", [("", x, f"{path}[]") for x in kept], len(data) > len(kept), named)
    return [_short(data)]


def _block(
    brackets: str, parts: list[tuple[str, Any, str]], more: bool, named: frozenset[str]
) -> list[str]:
    if not parts:
        return [brackets]
    lines = [brackets[0]]
    for k, (label, value, path) in enumerate(parts):
        inner = _lines(value, named, path)
        inner[0] = label + inner[0]
        if k < len(parts) - 1 or more:
            inner[-1] += ","
        lines += [f"  {line}" for line in inner]
    return [*lines, *([f"  {MORE}"] if more else []), brackets[1]]


def _short(value: Any) -> str:
    if isinstance(value, str) and len(value) > _LONGEST:
        value = f"{value[:_LONGEST]}…"
    return json.dumps(value, ensure_ascii=False)
