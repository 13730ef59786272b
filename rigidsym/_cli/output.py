"""Functions that print tables to stdout, and messages and progress bars to stderr."""

import io
import os
import sys
from argparse import Namespace
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidsym.view._progress import bar

if TYPE_CHECKING:
    from rich.table import Table

# Progress bars that are shown; leaving takes them from the terminal.
BARS = ExitStack()


def prepare_output() -> None:
    """Prepare stdout and stderr so that printing never raises an exception.

    A closed stream is replaced by a buffer, and characters that cannot be encoded by question
    marks.
    """
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, io.StringIO())
        elif isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def discard_output() -> None:
    """Redirect stdout to the null device, so that flushing it at exit does not fail."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


@contextmanager
def reader_may_leave() -> Generator[None]:
    """Ignore the error that occurs when a reader such as `head` closes the pipe early."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:
        discard_output()


def progress(label: str) -> Callable[[int, int], None]:
    """Start a progress bar, and return the function that updates it.

    The function takes the number of steps done and their total.  The bar is removed when all are
    done, or when the command ends.
    """
    return BARS.enter_context(bar(label))


def table(title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> None:
    """Print a table that is as wide as the terminal.

    It is 120 characters wide where stdout is not a terminal.
    """
    sys.stdout.write(table_text(title, columns, rows))


def table_text(title: str, columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Format a table as text."""
    from rich.table import Table
    from rich.text import Text

    table = Table(title=title, title_justify="left")
    for column in columns:
        table.add_column(column, overflow="fold")
    for row in rows:
        table.add_row(*map(Text, row))
    return _rendered(table)


def entries_text(title: str, rows: Iterable[tuple[str, str]]) -> str:
    """Format a titled list of names and their descriptions as text.

    A name is shown once for all consecutive entries.
    """
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
    """Print long text, using the user's pager on a terminal.

    The pager exits by itself where all fits on one screen.
    """
    if not sys.stdout.isatty():
        sys.stdout.write(text)
        return
    import pydoc

    os.environ.setdefault("LESS", "-RFX")
    pydoc.pager(text)


def deliver(options: Namespace, result: Any, show: Callable[[], None]) -> None:
    """Write or print the result of a command as its options ask.

    With -o DIR the result is written there.  It is printed as JSON or by `show`.  The paths of
    written files are printed to stderr.
    """
    written = list(result.write(options.output)) if options.output else []
    if options.json:
        print(result.to_json(), end="")
    else:
        show()
    say_written(written)


def say(message: str) -> None:
    """Print a message to stderr."""
    print(message, file=sys.stderr)


def say_written(paths: Iterable[Path]) -> None:
    """Print the paths of written files to stderr."""
    for path in paths:
        say(f"wrote {path}")
