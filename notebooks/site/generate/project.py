"""Pages about the project itself, from the files at the top of the repository."""

from pathlib import Path

from generate.text import fenced


def pages(root: Path) -> dict[str, str]:
    """Changes, licence and citation, by their names."""
    changes, licence, citation = (
        (root / name).read_text("utf-8") for name in ("CHANGELOG.md", "LICENSE", "CITATION.cff")
    )
    return {
        "changes.md": changes,
        "licence.md": f"# Licence\n\n{fenced('text', licence)}",
        "citation.md": "# How to cite\n\n`CITATION.cff`, which reference managers and code hosts "
        f"read:\n\n{fenced('yaml', citation)}",
    }
