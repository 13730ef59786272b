"""A plotly figure that brings a still of itself, which is seen where no scripts run."""

from base64 import b64encode

from plotly.graph_objects import Figure

from rigidsym.view.scenes.still import still


class Picture(Figure):
    """A figure whose output in a notebook is interactive, and has a JPEG for all other readers.

    Not a PNG: of one that comes with a figure JupyterLab's extension shows nothing else.
    """

    def show(self, *args: object, **kwargs: object) -> None:
        """As plotly's, and the still with it where a notebook shows the figure."""
        bundle = {} if args or kwargs else super()._repr_mimebundle_()
        if not bundle:
            super().show(*args, **kwargs)
            return
        from IPython.display import display

        display(bundle | self._still(), raw=True)

    def _ipython_display_(self) -> None:
        self.show()

    def _still(self) -> dict[str, str]:
        """Nothing where matplotlib is not installed, or something was added that `still` cannot
        draw: the interactive picture is shown in any case."""
        try:
            return {"image/jpeg": b64encode(still(self)).decode()}
        except (ImportError, LookupError, TypeError, ValueError):
            return {}
