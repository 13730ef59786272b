"""Lines and words of a picture."""

from rigidsym.view.html.markup import Markup, tag


def line(class_: str, x1: float, y1: float, x2: float, y2: float) -> Markup:
    """A line between two points."""
    return tag("line", class_=class_, x1=x1, y1=y1, x2=x2, y2=y2)


def write(
    x: float, y: float, written: str, anchor: str = "middle", class_: str | None = None, **more: str
) -> Markup:
    """Words at a point."""
    return tag("text", written, class_=class_, x=x, y=y, text_anchor=anchor, **more)
