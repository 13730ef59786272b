"""How Sphinx builds the site; `build.py` runs it on the staged sources."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import rigidsym

project = "rigidsym"
author = "The rigidsym developers"
smartquotes = False
version = release = rigidsym.__version__
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx_copybutton", "docstrings", "mathml", "words"]

# Notebooks are shown as they are committed.
nb_execution_mode = "off"
# Tables that cells give are tables, with formulas in them.
nb_render_markdown_format = "myst"
nb_ipywidgets_js: dict[str, dict[str, str]] = {}
nb_mime_priority_overrides = [("html", "image/svg+xml", 5)]
myst_enable_extensions = ["amsmath", "colon_fence", "dollarmath"]
myst_heading_anchors = 3
myst_update_mathjax = False

autodoc_member_order = "bysource"
autodoc_typehints_format = "short"
add_module_names = False
python_maximum_signature_line_length = 88
python_use_unqualified_type_names = True

html_theme = "furo"
html_math_renderer = "mathml"
html_title = f"rigidsym {release}"
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
# Pages depend on the sources alone.
html_last_updated_fmt = None
html_show_copyright = False
pygments_style = "friendly"
pygments_dark_style = "github-dark"
copybutton_prompt_text = r">>> |\.\.\. |\$ |In \[\d*\]: "
copybutton_prompt_is_regexp = True
