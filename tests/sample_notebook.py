"""Small notebook with text, mathematics and a 3-D picture."""

CELLS = (
    "import numpy as np\n\nimport rigidsym\n\n"
    "motion = rigidsym.TorqueFreeMotion((0.0109, 0.04, 0.0506), (0.05, 0.03, -0.02))\n"
    "q, omega = motion(np.linspace(0, 180, 91))\nmotion.regime",
    "from IPython.display import Math\n\n"
    "Math(r'\\dot q=\\tfrac12\\,q\\otimes(0,\\boldsymbol\\omega)')",
    "import plotly.graph_objects as go\n\n"
    "line = go.Scatter3d(x=omega[:, 0], y=omega[:, 1], z=omega[:, 2], mode='lines')\n"
    "figure = go.Figure(line)\nfigure.update_layout(width=600, height=400)\nfigure",
    "assert abs(np.linalg.norm(q, axis=1) - 1).max() < 1e-15",
)
TEXT = """# A sample

The rates of a free body, for which

$$c_1\\dot\\Omega_1=(c_2-c_3)\\,\\Omega_2\\Omega_3$$

and $|q|=1$. More is in [the README](../README.md), and in [nothing](../nowhere.py)."""
KERNEL = {"display_name": "Python 3", "language": "python", "name": "python3"}


def notebook():
    """Return the notebook, not executed."""
    import nbformat

    cells = [nbformat.v4.new_markdown_cell(TEXT), *map(nbformat.v4.new_code_cell, CELLS)]
    for number, cell in enumerate(cells):
        cell["id"] = f"cell-{number}"
    return nbformat.v4.new_notebook(cells=cells, metadata={"kernelspec": KERNEL})
