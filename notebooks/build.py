"""Executes the notebooks and writes them, or checks that they are what execution gives.

    python notebooks/build.py [NAME…]            execute, write the .ipynb of each text
    python notebooks/build.py --check [NAME…]    1 where text, .ipynb and a fresh execution differ

A notebook is a py:percent text of the folder `text`, paired by jupytext with the .ipynb of its
stem in this one.  The text is the source; what is written depends on it and on the code alone: no
times, versions, random ids, addresses or paths.  Pictures are not compared, only that they are
there.  `support/executed.json` has a digest of all that each notebook was written from: tests
execute those again for which it is another by now, and all of them with `-m slow`.

A new notebook: write cells, "# %%" and "# %% [markdown]", in text/NN_name.py or text/howto_name.py
and run the command, which adds the head.  It takes less than a minute and writes nothing to stderr;
it prints numbers rounded to what is certain on every processor, rounding errors as bounds ("below
1e-15"), draws with matplotlib or plotly, and its last cell, folded by the tag "hide-cell", asserts
what it says.  `rigidsym.view._cards` shows facts and verdicts, `rigidsym.view.scenes` motions, each
with a still for readers without scripts; `support` has what notebooks alone need.
"""

import argparse
import difflib
import os
import re
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from functools import partial
from hashlib import sha256
from pathlib import Path
from time import monotonic
from typing import Any

import jupytext
import nbformat
from jupyter_client.kernelspec import KernelSpecManager
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError, CellTimeoutError

from rigidsym.io._files import write_text
from support import executed

FOLDER = Path(__file__).resolve().parent
TEXTS = FOLDER / "text"
# Limits that end what hangs, however busy the machine is: of a whole notebook, and of its kernel.
SECONDS = KERNEL_SECONDS = 600
BYTES = 4_000_000
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}
LANGUAGE = {"file_extension": ".py", "mimetype": "text/x-python", "name": "python"}
PAIRED = {
    "cell_metadata_filter": "tags,-all",
    "formats": "ipynb,text//py:percent",
    "notebook_metadata_filter": "kernelspec,jupytext,"
    "-jupytext.text_representation.jupytext_version",
}
# What only a running kernel can show, under an id that is another one each time.
LIVE = "application/vnd.jupyter.widget-view+json"
# Tags of cells whose code is folded; the site's `myst_nb` knows them.
FOLDED = {"hide-cell", "hide-input"}
# What no committed output may hold: addresses in memory, and folders of one machine.
FOLDERS = {str(FOLDER.parent), str(Path.home()), sys.prefix, tempfile.gettempdir()} - {"/"}
PRIVATE = re.compile(
    "|".join(
        (
            r"\b0x[0-9a-f]{6,}\b",
            "site-packages",
            r"(?<![\w.:/\\{}])/(?:home|root|tmp|usr|opt|var|Users)/\w",
            *map(re.escape, sorted(FOLDERS)),
        )
    )
)


class NotebookError(Exception):
    """A notebook cannot be executed or may not be committed; says which, where and why."""


def names() -> list[str]:
    """The stems of the notebooks."""
    return sorted(path.stem for path in TEXTS.glob("*.py"))


def source(name: str) -> Any:
    """A notebook as its text says it, with its metadata and ids in one form, not executed."""
    notebook = jupytext.read(TEXTS / f"{name}.py", fmt="py:percent")
    shape = {"extension": ".py", "format_name": "percent", "format_version": "1.3"}
    notebook.metadata = nbformat.from_dict(
        {
            "jupytext": {**PAIRED, "text_representation": shape},
            "kernelspec": KERNEL,
            "language_info": LANGUAGE,
        }
    )
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    for cell, identity in zip(notebook.cells, _ids(notebook.cells), strict=True):
        cell.metadata = nbformat.from_dict(_metadata(cell.metadata.get("tags")))
        cell.id = identity
    return notebook


def _metadata(tags: Sequence[str] | None) -> dict[str, Any]:
    """The tags of a cell; what the site folds by its tag is folded in JupyterLab, too."""
    if not tags:
        return {}
    folded = {"jupyter": {"source_hidden": True}} if {*tags} & FOLDED else {}
    return {**folded, "tags": list(tags)}


def _ids(cells: Sequence[Any]) -> Iterator[str]:
    """Ids by what is in a cell, so that a change moves no other id; repeated cells are counted."""
    seen: dict[str, int] = {}
    for cell in cells:
        digest = sha256(f"{cell.cell_type}\n{cell.source}".encode()).hexdigest()[:12]
        seen[digest] = seen.get(digest, 0) + 1
        yield digest if seen[digest] == 1 else f"{digest}-{seen[digest]}"


def text(notebook: Any) -> str:
    """The py:percent text of a notebook."""
    return jupytext.writes(notebook, fmt="py:percent")


class _OwnKernel(AsyncKernelManager):
    """The kernel of this Python, whatever kernelspecs a user has installed."""

    def __init__(self, **options: Any) -> None:
        super().__init__(kernel_spec_manager=KernelSpecManager(kernel_dirs=[]), **options)


def execute(notebook: Any, name: str) -> Any:
    """The notebook with its outputs, from a fresh kernel of this Python; raises NotebookError."""
    done = deepcopy(notebook)
    end = monotonic() + SECONDS
    with tempfile.TemporaryDirectory() as scratch:
        client = NotebookClient(
            done,
            kernel_name="python3",
            kernel_manager_class=_OwnKernel,
            extra_arguments=["--log-level=ERROR"],
            timeout_func=lambda cell: max(1, round(end - monotonic())),
            startup_timeout=KERNEL_SECONDS,
            iopub_timeout=KERNEL_SECONDS,
            record_timing=False,
            coalesce_streams=True,
            shutdown_kernel="immediate",
            resources={"metadata": {"path": str(FOLDER)}},
        )
        try:
            client.execute(env=_environment(scratch))
        except CellTimeoutError:
            raise NotebookError(f"{name}: it runs longer than {SECONDS} s") from None
        except (CellExecutionError, RuntimeError) as error:  # RuntimeError: the kernel is gone
            raise NotebookError(f"{name}: {_plain(str(error))}") from None
    for cell in done.cells:
        cell.metadata.pop("execution", None)
        for output in cell.get("outputs", ()):
            _settle(output, name)
    done.metadata = deepcopy(notebook.metadata)
    nbformat.validate(done)
    return done


def _environment(scratch: str) -> dict[str, str]:
    paths = [str(FOLDER.parent), os.environ.get("PYTHONPATH", "")]
    return {
        **{key: value for key, value in os.environ.items() if key != "MPLBACKEND"},
        "PYTHONPATH": os.pathsep.join(filter(None, paths)),
        "PYTHONHASHSEED": "0",
        "IPYTHONDIR": scratch,
        "PLOTLY_RENDERER": "plotly_mimetype",
        "PYDEVD_DISABLE_FILE_VALIDATION": "1",
        "COLUMNS": "100",
    }


def _plain(message: str) -> str:
    return re.sub(r"\x1b\[[0-9;]*m", "", message)


def _settle(output: Any, name: str) -> None:
    """Refuse what must not be committed, and make the rest the same every time."""
    if output.output_type == "stream" and output.name == "stderr":
        raise NotebookError(f"{name}: a cell writes to stderr: {output.text[:400]}")
    output.get("data", {}).pop(LIVE, None)
    for kind, content in _texts(output):
        if found := PRIVATE.search(content):
            raise NotebookError(f"{name}: {kind} holds {found[0]!r}, an address or a path")


def _texts(output: Any) -> Iterator[tuple[str, str]]:
    """What is text in an output, by kind; pictures are not."""
    if output.output_type == "stream":
        yield output.name, output.text
    for kind, content in sorted(output.get("data", {}).items()):
        if kind.startswith("text/"):
            yield kind, content


def comparable(notebook: Any) -> str:
    """Everything that a fresh execution must give again, as text; of pictures only their kinds."""
    lines = [f"notebook {dict(notebook.metadata)}"]
    for cell in notebook.cells:
        lines += [f"{cell.cell_type} {cell.id} {dict(cell.metadata)}", cell.source]
        for output in cell.get("outputs", ()):
            lines.append(f"{output.output_type} {sorted(output.get('data', {}))}")
            lines += [f"{kind}\n{content}" for kind, content in _texts(output)]
    return "\n".join(lines) + "\n"


def build(name: str) -> None:
    """Execute a notebook; write it, its digest, and its text where jupytext's is another one."""
    notebook = source(name)
    written = nbformat.writes(execute(notebook, name), indent=1) + "\n"
    if len(written.encode()) > BYTES:
        raise NotebookError(f"{name}: {len(written):_} bytes, more than {BYTES:_}")
    if text(notebook) != (TEXTS / f"{name}.py").read_text("utf-8"):
        write_text(TEXTS / f"{name}.py", text(notebook))
    write_text(FOLDER / f"{name}.ipynb", written)
    executed.note(name)


def check(name: str, fresh: Callable[[Any, str], Any] = execute) -> str:
    """What differs between the text, the committed notebook and a fresh execution; "" if nothing.

    Raises NotebookError where it cannot be executed.
    """
    path = FOLDER / f"{name}.ipynb"
    if not path.is_file():
        return f"{path.name} is not there: python notebooks/build.py {name}\n"
    notebook = source(name)
    committed = nbformat.read(path, as_version=4)
    there = (TEXTS / f"{name}.py").read_text("utf-8")
    return (
        _difference(there, text(notebook), f"{name}.py", "by jupytext")
        or _difference(_sources(committed), _sources(notebook), path.name, f"{name}.py")
        or _difference(comparable(committed), comparable(fresh(notebook, name)), path.name, "fresh")
    )


def _sources(notebook: Any) -> str:
    cells = (f"{cell.cell_type} {cell.id}\n{cell.source}\n" for cell in notebook.cells)
    return "".join((f"{dict(notebook.metadata)}\n", *cells))


def _difference(before: str, after: str, *files: str) -> str:
    found = difflib.unified_diff(before.splitlines(True), after.splitlines(True), *files, n=1)
    return "".join(found)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit status."""
    parser = argparse.ArgumentParser(prog="notebooks/build.py", description="Notebooks, executed.")
    parser.add_argument("names", metavar="NAME", nargs="*", help="all, unless some are named")
    parser.add_argument("--check", action="store_true", help="write nothing, compare")
    options = parser.parse_args(arguments)
    chosen = [Path(name).stem for name in options.names] or names()
    if unknown := sorted({*chosen} - {*names()}):
        parser.error(f"{unknown[0]}: must be one of: {', '.join(names())}")
    return max(
        [_report(name, partial(check if options.check else _built, name)) for name in chosen]
    )


def _built(name: str) -> str:
    build(name)
    return ""


def _report(name: str, work: Callable[[], str]) -> int:
    start = monotonic()
    try:
        found = work()
    except NotebookError as error:
        found = f"{error}\n"
    sys.stdout.write(found)
    print(f"{name}: {'FAILED' if found else 'ok'} ({monotonic() - start:.1f} s)", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
