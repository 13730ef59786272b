"""Texts of the README and the pages, and the commands that documents name."""

import re
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
PAGES = ROOT / "notebooks" / "site" / "pages"
# Lists of other pages, which only the site has.
CONTENTS = ("index.md", "guide.md")
PATHS = (
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    *sorted(path for path in PAGES.glob("*.md") if path.name not in CONTENTS),
)
TEXTS = {path.name: path.read_text("utf-8") for path in PATHS}
README = TEXTS["README.md"]
FENCED = {
    name: re.findall(r"^```(.*?)\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    for name, text in TEXTS.items()
}


def blocks(language, name=None):
    """Return the fenced code blocks of a language in one document, or in all."""
    chosen = FENCED if name is None else [name]
    return [text for document in chosen for info, text in FENCED[document] if info == language]


def words(name):
    """Return the text of a document without its line breaks."""
    return " ".join(TEXTS[name].split())


def rows(name):
    """Return the rows of all tables in a document, each as a list of cells."""
    lines = (line for line in TEXTS[name].splitlines() if line.startswith("| "))
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in lines]


# What a command begins with; in the text it is followed by its arguments.
PROGRAMS = (
    *("rigidsym", "python", "python3", "uv", "pytest", "bash", "sh", "pip", "jupyter"),
    *("pre-commit", "make", "cc", "gcc", "clang", "nice", "time", "apt-get"),
)
COMMAND = re.compile(rf"(?:{'|'.join(PROGRAMS)}) +\S")


def documents() -> dict[str, str]:
    """Return the Markdown text of every document that may name commands, by its path."""
    paths = [ROOT / "CHANGELOG.md", *PATHS[:2], *sorted(PAGES.rglob("*.md"))]
    notebooks = sorted((ROOT / "notebooks" / "text").glob("*.py"))
    texts = {path: path.read_text("utf-8") for path in paths}
    texts |= {path: _markdown(path.read_text("utf-8")) for path in notebooks}
    return {path.relative_to(ROOT).as_posix(): text for path, text in texts.items()}


def _markdown(notebook: str) -> str:
    """Convert a notebook to Markdown: its prose, and shell commands as code blocks."""
    told = []
    for cell in re.split(r"^# %%", notebook, flags=re.MULTILINE)[1:]:
        head, _, body = cell.partition("\n")
        if "[markdown]" in head:
            told.append(re.sub(r"^# ?", "", body, flags=re.MULTILINE))
        else:
            called = re.findall(r"^\s*(?:# )?[!%](.*)$", body, re.MULTILINE)
            told.append("\n".join(("```sh", *called, "```")))
    return "\n".join(told)


def commands() -> dict[str, str]:
    """Return every command that a document names, with the last document that names it.

    Commands stand in blocks of a shell, line by line, and in other text as code that begins with
    the name of a program.
    """
    return {command: name for name, text in documents().items() for command in _named(text)}


def _named(text: str) -> Iterator[str]:
    fenced = re.compile(r"^```(.*?)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
    for info, block in fenced.findall(text):
        for line in block.replace("\\\n", " ").splitlines():
            line = re.sub(r"(^|\s)#.*", "", line.strip().removeprefix("$ "))
            for command in map(str.strip, line.split("&&")):
                if command if info == "sh" else info in ("", "text") and COMMAND.match(command):
                    yield from _alternatives(command)
    for code in re.findall(r"`([^`]+)`", fenced.sub("", text)):
        for command in " ".join(code.split()).split(" && "):
            if COMMAND.match(command):
                yield from _alternatives(command)


def _alternatives(command: str) -> Iterator[str]:
    """Yield the commands `x a` and `x b` for `x a|b`.

    They are the commands as they are run in an environment that is set up, without `uv run`.
    """
    command = re.sub(
        r"^(?:time|nice|uv run(?: --no-dev| --no-sync| --group all)*) (?=\w)", "", command
    )
    if found := re.search(r"(\w+)\|(\w+)", command):
        for one in found.groups():
            yield command.replace(found[0], one)
    else:
        yield command
