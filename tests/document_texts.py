"""The texts that people read first: the README, and the site's pages that are written by hand."""

import re
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
    """The fenced blocks of a language in one text, or in all."""
    chosen = FENCED if name is None else [name]
    return [text for document in chosen for info, text in FENCED[document] if info == language]


def words(name):
    """A text without its line breaks."""
    return " ".join(TEXTS[name].split())


def rows(name):
    """The rows of a text's tables, as cells."""
    lines = (line for line in TEXTS[name].splitlines() if line.startswith("| "))
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in lines]
