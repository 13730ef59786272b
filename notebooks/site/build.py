"""Build of the site, without network: `python notebooks/site/build.py` (extra `docs`).

Its pages are this folder's, the README, the notebooks as they are committed, and what
`generate` makes from the code.  All of it goes to DIR/source and from there, by Sphinx, to
DIR/html; a warning is an error.
"""

import argparse
import shutil
import sys
from collections.abc import Sequence
from importlib import resources
from pathlib import Path

import docstrings  # noqa: F401  (before the package is imported)
from sphinx.cmd.build import main as sphinx

from generate import gallery, links, notebook, project

SITE = Path(__file__).resolve().parent
ROOT = SITE.parents[1]
# Where the site shows what a link into the repository leads to.
SHOWN = {
    "README.md": "index.md",
    "CONTRIBUTING.md": "contributing.md",
    "CHANGELOG.md": "changes.md",
    "LICENSE": "licence.md",
    "CITATION.cff": "citation.md",
    "notebooks": "guide.md",
    "rules.py": "reference/kernel.md",
    "ledger.json": "reference/kernel.md",
}


# What most people come for leads the how-tos.
FIRST = "propagate"


def main(arguments: Sequence[str] | None = None) -> int:
    """Stage the sources and run Sphinx; return its exit status."""
    parser = argparse.ArgumentParser(description="Build the site.")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "build" / "site", metavar="DIR")
    parser.add_argument("-n", "--notebooks", type=Path, default=SITE.parent, metavar="DIR")
    options = parser.parse_args(arguments)
    output = options.output
    for part in ("source", "static", "html", "cache"):
        shutil.rmtree(output / part, ignore_errors=True)
    notebooks = sorted(options.notebooks.glob("*.ipynb"))
    stage(output / "source", notebooks)
    stage_static(output / "static", notebooks)
    status = render(output)
    if status == 0:
        print(f"open {output / 'html' / 'index.html'}")
    return status


def render(output: Path) -> int:
    """Run Sphinx over what is staged; return its exit status."""
    places = ["-c", SITE, "-d", output / "cache", "-D", f"html_static_path={output / 'static'}"]
    quiet = ["-W", "--keep-going", "-q"]
    status = sphinx([*quiet, *map(str, [*places, output / "source", output / "html"])])
    # It records where the site was built.
    (output / "html" / ".buildinfo").unlink(missing_ok=True)
    return status


def stage(source: Path, notebooks: Sequence[Path]) -> None:
    """Write every page of the site as a file under `source`."""
    # They import most of the package, which rendering does not need.
    from generate import api, command, displays, errata, formats, kernel, live

    shutil.copytree(SITE / "pages", source)
    for name, page in project.pages(ROOT).items():
        _write(source / name, page)
    _stage_guide(source, notebooks)
    _write(source / "reference" / "command.md", command.page())
    _write(source / "reference" / "formats.md", formats.page())
    _write(source / "errata.md", errata.page())
    _write(source / "displays.md", displays.page())
    page = source / "live.md"
    _write(page, page.read_text("utf-8").replace(live.PLACE, live.block()))
    page, printed = source / "trust.md", "derivations/specification.txt\n"
    specification = (ROOT / printed.strip()).read_text("utf-8")
    _write(page, page.read_text("utf-8").replace(f"text\n{printed}", f"text\n{specification}"))
    _write(source / "reference" / "kernel.md", kernel.page())
    contents = source / "reference" / "api.md"
    _write(contents, contents.read_text("utf-8").replace("PACKAGES", api.contents()))
    for package, text in api.pages().items():
        _write(source / "reference" / "api" / f"{package}.rst", text)


def stage_static(static: Path, notebooks: Sequence[Path]) -> None:
    """Write files that pages load: style, font of formulas, pictures, and plotly if needed."""
    shutil.copytree(SITE / "static", static)
    for name, data in gallery.pictures(_texts(notebooks)).items():
        (static / name).write_bytes(data)
    _copy("ziamath", "fonts/STIXTwoMath-Regular.ttf", static)
    if any(notebook.has_pictures(path.read_text("utf-8")) for path in notebooks):
        _copy("plotly", "package_data/plotly.min.js", static)


def _texts(notebooks: Sequence[Path]) -> dict[str, str]:
    return {path.stem: path.read_text("utf-8") for path in notebooks}


def _copy(package: str, name: str, folder: Path) -> None:
    """Copy a file of an installed package."""
    file = resources.files(package).joinpath(name)
    (folder / name.rpartition("/")[2]).write_bytes(file.read_bytes())


def _stage_guide(source: Path, notebooks: Sequence[Path]) -> None:
    """Write README, pages and notebooks with links between them, how-tos after chapters."""
    shutil.copyfile(ROOT / "CONTRIBUTING.md", source / "contributing.md")
    pages = [path.name for path in source.glob("*.md") if path.name != "index.md"]
    below = SHOWN | {name: name for name in pages}
    below |= {path.name: f"guide/{path.name}" for path in notebooks}
    above = {name: f"../{page}" for name, page in below.items()}
    for path in notebooks:
        text = path.read_text("utf-8")
        _write(source / "guide" / path.name, notebook.shown(text, path.stem, above))
    for name in pages:
        _write(source / name, links.within((source / name).read_text("utf-8"), below))
    readme = (ROOT / "README.md").read_text("utf-8")
    _stage_pictures(readme, source)
    start = source / "index.md"
    landing = gallery.within(links.within(readme, below), _texts(notebooks))
    _write(start, landing + "\n" + start.read_text("utf-8"))
    howtos = [path.stem for path in notebooks if not path.stem[:1].isdigit()]
    howtos.sort(key=lambda stem: (FIRST not in stem, stem))
    chapters = [path.stem for path in notebooks if path.stem[:1].isdigit()]
    guide = (source / "guide.md").read_text("utf-8")
    for name, stems in (("CHAPTERS", chapters), ("HOWTOS", howtos)):
        guide = guide.replace(name, "\n".join(f"guide/{stem}" for stem in stems))
    _write(source / "guide.md", guide)


def _stage_pictures(readme: str, source: Path) -> None:
    """The pictures that the README shows, under the same names."""
    for name in links.pictures(readme):
        target = source / name
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, target)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")


if __name__ == "__main__":
    sys.exit(main())
