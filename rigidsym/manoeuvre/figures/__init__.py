"""The paper's Figures 1 to 3, drawn anew from the library."""

from rigidsym.manoeuvre.figures.figures import Figures, figures

__all__ = ["Figures", "figures"]
