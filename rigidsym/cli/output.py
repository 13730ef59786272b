"""What commands print: tables to stdout, messages and progress to stderr."""

import io
import os
import sys
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from rigidsym.errors import InputError

if TYPE_CHECKING:
    from rich.table import Table

# Progress bars that are shown; leaving takes them from the terminal.
BARS = ExitStack()


def prepare_output() -> None:
    """Closed streams and encodings without our letters are no reason to fail."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, io.StringIO())
        elif isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def discard_output() -> None:
    """What is still buffered goes nowhere, so that leaving does not fail again."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextmanager
def reader_may_leave() -> Generator[None]:
    """Printing to a reader that goes away, as `head` does, changes no exit status."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        discard_output()


@contextmanager
def packages() -> Generator[None]:
    """A package that is not installed becomes one line."""
    try:
        yield
    except ImportError as error:
        raise InputError("packages", error.name or "missing", str(error)) from None


def progress(label: str) -> Callable[[int, int], None]:
    """A progress bar with the time left on a terminal, silence elsewhere; called with what is done
    and the total."""
    if not sys.stderr.isatty():
        return lambda done, total: None
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    columns = (*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn())
    bar = Progress(*columns, console=Console(stderr=True), transient=True)
    task = bar.add_task(label)
    bar.start()
    BARS.callback(bar.stop)

    def show(done: int, total: int) -> None:
        bar.update(task, completed=done, total=total)
        if done == total:
            bar.stop()

    return show


def table(title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Print a table, as wide as the terminal, or 120 characters."""
    sys.stdout.write(table_text(title, columns, rows))


def table_text(title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """The table that `table` prints."""
    from rich.table import Table
    from rich.text import Text

    table = Table(title=title, title_justify="left")
    for column in columns:
        table.add_column(column, overflow="fold")
    for row in rows:
        table.add_row(*map(Text, row))
    return _rendered(table)


def entries_text(title: str, rows: Iterable[tuple[str, str]]) -> str:
    """Names and what they are, below a title; a name is said once for all that follow it."""
    from rich.table import Table
    from rich.text import Text

    grid = Table(title=title, title_justify="left", box=None, show_header=False, padding=(0, 2))
    grid.add_column(no_wrap=True)
    grid.add_column(overflow="fold")
    before = ""
    for name, text in rows:
        grid.add_row("" if name == before else name, Text(text))
        before = name
    return _rendered(grid)


def _rendered(table: "Table") -> str:
    from rich.console import Console

    console = Console(width=None if sys.stdout.isatty() else 120)
    with console.capture() as text:
        console.print(table)
    return text.get()


def page(text: str) -> None:
    """Print what may be long: through the user's pager on a terminal, which ends by itself where
    all is on one screen."""
    if not sys.stdout.isatty():
        sys.stdout.write(text)
        return
    import pydoc

    os.environ.setdefault("LESS", "-RFX")
    pydoc.pager(text)


def say(message: str) -> None:
    """Print to stderr."""
    print(message, file=sys.stderr)


def say_written(paths: Iterable[Path]) -> None:
    """Tell which files there are now."""
    for path in paths:
        say(f"wrote {path}")
