"""Stills: small, of what the interactive picture shows, and beside it in a notebook's output."""

import base64
import sys

import numpy as np
import pytest
from picture_motions import MOTIONS

from rigidsym.view.scenes import momentum_sphere, rolling_ellipsoid, tumbling_body
from rigidsym.view.scenes._still import still

pytest.importorskip("IPython", reason="IPython is not installed: extra `lab`")
plotly_io = pytest.importorskip("plotly.io", reason="plotly is not installed: extra `lab`")
image = pytest.importorskip("matplotlib.image", reason="matplotlib is not installed: extra `lab`")

PICTURES = (momentum_sphere, rolling_ellipsoid, tumbling_body)
KIND = "application/vnd.plotly.v1+json"


@pytest.fixture
def shown(monkeypatch):
    """What a notebook gets to show."""
    found = []
    monkeypatch.setattr(plotly_io.renderers, "default", "plotly_mimetype")
    monkeypatch.setattr("IPython.display.display", lambda data, raw: found.append(data))
    return found


@pytest.mark.parametrize("draw", PICTURES)
@pytest.mark.parametrize("name", [name for name in MOTIONS if name != "rest"])
def test_pictures_are_small_and_stills_smaller_with_colours(draw, name, tmp_path):
    picture = draw(MOTIONS[name])
    assert len(picture.to_json()) < 1_200_000
    data = still(picture)
    assert len(data) < 60_000
    (tmp_path / "still.jpeg").write_bytes(data)
    pixels = image.imread(tmp_path / "still.jpeg")
    assert pixels.shape[0] > 300
    assert len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)) > 20


def test_a_still_has_what_was_added_to_the_picture():
    picture = momentum_sphere(MOTIONS["paper"])
    before = still(picture)
    picture.add_scatter3d(x=[0, 1e-3], y=[0, 0], z=[0, 1e-3], line={"color": "#ff0000"})
    assert still(picture) != before


def test_both_are_one_output(shown):
    picture = tumbling_body(MOTIONS["paper"])
    picture.show()
    picture._ipython_display_()
    assert shown[0] == shown[1]
    assert set(shown[0]) == {KIND, "image/jpeg"}
    assert base64.b64decode(shown[0]["image/jpeg"]).startswith(b"\xff\xd8\xff")
    assert len(shown[0][KIND]["data"]) == len(picture.data)


def test_without_matplotlib_the_picture_is_shown_alone(shown, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    momentum_sphere(MOTIONS["paper"]).show()
    assert set(shown[0]) == {KIND}


def test_what_cannot_be_drawn_flat_is_shown_alone(shown):
    picture = momentum_sphere(MOTIONS["paper"])
    picture.add_cone(x=[0], y=[0], z=[0], u=[1], v=[0], w=[0])
    picture.show()
    assert set(shown[0]) == {KIND}


def test_other_renderers_are_plotlys(shown, monkeypatch):
    asked = []
    monkeypatch.setattr(plotly_io, "show", lambda picture, **how: asked.append(how))
    momentum_sphere(MOTIONS["paper"]).show(renderer="browser")
    monkeypatch.setattr(plotly_io.renderers, "default", "browser")
    momentum_sphere(MOTIONS["paper"]).show()
    assert asked == [{"renderer": "browser"}, {}]
    assert shown == []
