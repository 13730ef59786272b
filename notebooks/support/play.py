"""Sliders for a body and its motion while a kernel runs; a picture for all other readers."""

from base64 import b64encode
from collections.abc import Sequence
from typing import Any

import ipywidgets
from IPython.display import clear_output, display

from rigidsym import InputError, TorqueFreeMotion
from rigidsym.view.scenes import sphere_and_body
from rigidsym.view.scenes._still import still

_NAMES = ("c₁", "c₂", "c₃"), ("Ω₁", "Ω₂", "Ω₃")
_MOMENTS = {"min": 0.005, "max": 0.1, "step": 0.0005, "readout_format": ".4f"}
_RATES = {"min": -0.1, "max": 0.1, "step": 0.001, "readout_format": ".3f"}


class Play:
    """Six sliders, inertia (kg m^2) and body rates (rad/s), and what they make, drawn anew as each
    is let go: the regime's name, the momentum on its sphere, the body that turns.

    Files and pages, which have no kernel, show the motion that it began with.
    """

    def __init__(self, inertia: Sequence[float], omega0: Sequence[float]) -> None:
        self.sliders = [
            ipywidgets.FloatSlider(value, description=name, continuous_update=False, **span)
            for values, names, span in zip(
                (inertia, omega0), _NAMES, (_MOMENTS, _RATES), strict=True
            )
            for value, name in zip(values, names, strict=True)
        ]
        self.said, self.shown = ipywidgets.HTML(), ipywidgets.Output()
        columns = [ipywidgets.VBox(part) for part in (self.sliders[:3], self.sliders[3:])]
        self.whole = ipywidgets.VBox([ipywidgets.HBox(columns), self.said, self.shown])
        for slider in self.sliders:
            slider.observe(self.draw, "value")

    def motion(self) -> TorqueFreeMotion:
        """What the sliders say; raises InputError where no body has such moments."""
        values = [round(slider.value, 6) for slider in self.sliders]
        return TorqueFreeMotion(values[:3], values[3:])

    def draw(self, change: object = None) -> None:
        """Say and show the motion of the sliders, or why there is none."""
        try:
            motion = self.motion()
            picture = sphere_and_body(motion)
        except InputError as error:
            self.said.value = f"<b>{error}</b>"
            return
        self.said.value = f"<b>{motion.regime}</b>"
        with self.shown:
            clear_output(wait=True)
            display(picture._repr_mimebundle_(), raw=True)

    def _ipython_display_(self) -> None:
        """The sliders, and beside them in the same output the picture for readers without them."""
        self.draw()
        picture = sphere_and_body(self.motion())
        bundle: dict[str, Any] = dict(picture._repr_mimebundle_())
        bundle["image/jpeg"] = b64encode(still(picture)).decode()
        live = self.whole._repr_mimebundle_() or {}
        display(bundle | live | {"text/plain": str(self.motion().regime)}, raw=True)
