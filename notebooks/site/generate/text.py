"""Words and tables as Markdown."""

from collections.abc import Iterable, Sequence


def code(text: str) -> str:
    """The text as code, whatever marks are in it."""
    fence = "``" if "`" in text else "`"
    return f"{fence} {text} {fence}" if "`" in text else f"`{text}`"


def plain(text: str) -> str:
    """The text with nothing in it that Markdown would take for a mark."""
    return "".join(f"\\{mark}" if mark in "\\`*_{}[]<>#|$" else mark for mark in text)


def prose(text: str) -> str:
    """A docstring's words: what stands between single backticks is code, all else is plain."""
    parts = text.split("`")
    return "".join(code(part) if k % 2 else plain(part) for k, part in enumerate(parts))


def table(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """A Markdown table; bars within cells are escaped where they are not yet."""
    lines = [columns, ["---"] * len(columns), *rows]
    return "\n".join("| " + " | ".join(map(_cell, line)) + " |" for line in lines) + "\n"


def fenced(language: str, text: str) -> str:
    """A block of code."""
    return f"```{language}\n{text.rstrip()}\n```\n"


def _cell(text: str) -> str:
    bare = text.replace("\\|", "|").replace("|", "\\|")
    return bare.replace("\n", " ")
