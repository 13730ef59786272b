"""Progress bars on terminals."""

import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager


@contextmanager
def bar(label: str) -> Generator[Callable[[int, int], None]]:
    """Show a progress bar during a `with` block, and yield the function that updates it.

    The function takes the number of steps done and their total.  The bar is shown on stderr if that
    is a terminal, with the time left, and removed at the end.
    """
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.console import Console
    from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

    columns = (*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as shown:
        task = shown.add_task(label, total=None)

        def show(done: int, total: int) -> None:
            shown.update(task, completed=done, total=total)
            if done == total:
                shown.stop()

        yield show
