"""`motion.plot` draws the right data with units, without pyplot."""

import re
import subprocess
import sys

import numpy as np
import pytest
from picture_motions import MOTIONS, MOVING, picture

from rigidsym import InputError, Regime, TorqueFreeMotion
from rigidsym.view._plots.figure import svg

PNG = b"\x89PNG\r\n\x1a\n"
plot = TorqueFreeMotion.plot


@pytest.mark.parametrize("name", MOTIONS)
def test_every_regime_is_drawn(name):
    motion = MOTIONS[name]
    figure = picture(plot, name)
    rates, attitude, sphere = figure.axes
    assert rates.get_ylabel() == "body rates Ω (rad/s)"
    assert attitude.get_ylabel() == "attitude q, body to inertial"
    assert attitude.get_xlabel() == "t (s)"
    assert "kg m²/s" in sphere.get_title()
    assert figure.get_suptitle() == str(motion.regime)
    # A body at rest has no polhode.
    assert (sphere.get_legend() is None) == (name == "rest")
    t = rates.lines[0].get_xdata()
    q, omega = motion(t)
    assert [line.get_label() for line in rates.lines] == ["Ω₁", "Ω₂", "Ω₃"]
    assert [line.get_label() for line in attitude.lines] == ["q₀", "q₁", "q₂", "q₃"]
    assert np.array_equal(np.stack([line.get_ydata() for line in rates.lines], 1), omega)
    assert np.array_equal(np.stack([line.get_ydata() for line in attitude.lines], 1), q)


@pytest.mark.parametrize("name", MOVING)
def test_polhode_and_separatrix_lie_on_the_sphere(name):
    motion = MOTIONS[name]
    *_, sphere = picture(plot, name).axes
    start = np.multiply(*(np.array([*map(float, motion.exact[x])]) for x in ("inertia", "omega0")))
    lines = {line.get_label(): np.stack(line.get_data_3d(), 1) for line in sphere.lines}
    assert np.allclose(np.linalg.norm(lines["polhode"], axis=1), np.linalg.norm(start), rtol=1e-9)
    assert np.allclose(lines["first time"], start, rtol=1e-12)
    assert ("separatrix" in lines) == (motion.regime != Regime.SPHERICAL)


def test_times_of_a_plot_are_those_of_a_call():
    figure = MOTIONS["paper"].plot(["0.5", 2, 10.0])
    assert [*figure.axes[0].lines[0].get_xdata()] == [0.5, 2.0, 10.0]
    assert figure._repr_png_().startswith(PNG)
    for times, message in (([1.0], "two or more"), ([1.0, None], "must be a number")):
        with pytest.raises(InputError, match=message):
            MOTIONS["paper"].plot(times)


@pytest.mark.parametrize("module", ["matplotlib", "matplotlib.figure"])
def test_one_line_where_matplotlib_is_missing(monkeypatch, module):
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match=r"^plot needs matplotlib \(extra lab\): pip install"):
        MOTIONS["paper"].plot()


def test_neither_pyplot_nor_sympy_is_loaded():
    code = (
        "import sys, rigidsym; m = rigidsym.TorqueFreeMotion((1, 2, 2.5), (1, 2, 3));"
        "m._repr_html_(); m._repr_latex_(); assert 'matplotlib' not in sys.modules; m.plot();"
        "print(*{'matplotlib.pyplot', 'sympy', 'plotly'} & {*sys.modules})"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == ""


def test_an_svg_has_no_digits_that_a_processor_decides():
    text = svg(MOTIONS["paper"].plot())
    drawn = " ".join(re.findall(r' d="([^"]*)"', text))
    assert max(len(x) for x in re.findall(r"\.(\d+)", drawn)) <= 2
    assert not re.search(r'id="[a-zA-Z][0-9a-f]{10}"', text)
    assert "date" not in text
    assert text == svg(MOTIONS["paper"].plot())
    assert "scale(0.015625)" in text, "letters have the size of their spacing"
