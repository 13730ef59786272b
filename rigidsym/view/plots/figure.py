"""Figures of matplotlib, apart from pyplot and its state, that show themselves in notebooks."""

import io
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING

from rigidsym.errors import package

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Figure
    from matplotlib.typing import RcKeyType


@contextmanager
def defaults(settings: Mapping["RcKeyType", object] | None = None) -> Generator[None]:
    """Draw with matplotlib's own settings and these, whatever the user's matplotlibrc says.

    Artists take some of them when they are made and others when they are drawn: figures are made
    and saved in here.
    """
    import matplotlib

    # The backend has no part in what is drawn here, and once set it stays.
    own = {key: x for key, x in matplotlib.rcParamsDefault.items() if key != "backend"}
    with matplotlib.rc_context({**own, **(settings or {})}):
        yield


def blank(user: str, width: float, height: float) -> "Figure":
    """An empty figure, inches; raises ImportError in the name of `user` without matplotlib."""
    base = package("matplotlib.figure", user).Figure

    class Picture(base):
        """A figure that shows itself as PNG."""

        def _repr_png_(self) -> bytes:
            buffer = io.BytesIO()
            with defaults():
                self.savefig(buffer, format="png", dpi=130)
            return buffer.getvalue()

    with defaults():
        return Picture(figsize=(width, height), layout="constrained")
