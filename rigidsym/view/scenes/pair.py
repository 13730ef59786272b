"""The momentum on its sphere beside the body that turns, by one slider."""

from typing import TYPE_CHECKING

import numpy as np

from rigidsym.inputs import Times
from rigidsym.view.geometry import moments
from rigidsym.view.palette import MARK
from rigidsym.view.protocols import Motion
from rigidsym.view.scenes.body import tumbling_body
from rigidsym.view.scenes.scene import dot, plotly, with_slider
from rigidsym.view.scenes.sphere import momentum_sphere
from rigidsym.view.times import chosen

if TYPE_CHECKING:
    from plotly.graph_objects import Figure

FRAMES, FAMILY = 73, 3
WIDTH, HEIGHT = 980, 640
_LEFT, _RIGHT = [0.0, 0.49], [0.51, 1.0]


def sphere_and_body(motion: Motion, times: Times | None = None) -> "Figure":
    """The momentum sphere in body axes, and the body in inertial space; its title is the regime.

    A slider moves both through `times` (N,), s.  A body at rest has no sphere: InputError.  Raises
    ImportError without plotly.
    """
    go = plotly("sphere_and_body")
    shown = chosen(motion, times, FRAMES)
    whole, body = momentum_sphere(motion, FAMILY), tumbling_body(motion, shown)
    here = moments(motion) * motion(shown)[1]
    dots = [dot(go, point, "momentum now", MARK) for point in here]
    count = len(whole.data)
    whole.add_traces([dots[0], *(trace.update(scene="scene2") for trace in body.data)])
    moving = [count, *(count + 1 + k for k in body.frames[0].traces)]
    frames = [
        [now, *(trace.update(scene="scene2") for trace in frame.data)]
        for now, frame in zip(dots, body.frames, strict=True)
    ]
    whole.update_layout(
        title={"text": str(motion.regime)},
        width=WIDTH,
        height=HEIGHT,
        scene={"domain": {"x": _LEFT, "y": [0.0, 1.0]}},
        scene2=body.layout.scene.to_plotly_json() | {"domain": {"x": _RIGHT, "y": [0.0, 1.0]}},
    )
    return with_slider(go, whole, np.asarray(shown), moving, frames)
