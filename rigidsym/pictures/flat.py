"""Figures of matplotlib, apart from pyplot and its state, that show themselves in notebooks."""

import io
from typing import TYPE_CHECKING

from rigidsym.pictures.packages import package

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def blank(user: str, width: float, height: float) -> "Figure":
    """An empty figure, inches; raises ImportError in the name of `user` without matplotlib."""
    base = package("matplotlib.figure", user).Figure

    class Picture(base):
        """A figure that shows itself as PNG."""

        def _repr_png_(self) -> bytes:
            buffer = io.BytesIO()
            self.savefig(buffer, format="png", dpi=130)
            return buffer.getvalue()

    return Picture(figsize=(width, height), layout="constrained")
