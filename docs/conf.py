"""The site of these pages: `make docs` builds it without the network and without a warning.

Pages with code cells are notebooks: they are executed when the site is built, and their answers are kept in
_build until a cell changes. Formulas become MathML here, which browsers show without a script from elsewhere.
"""

from __future__ import annotations

from typing import Any

from docutils.nodes import SkipNode
from latex2mathml.converter import convert

from haptonic import __version__

project = "haptonic"
version = release = __version__
extensions = ["myst_nb"]
root_doc = "index"
exclude_patterns = ["_build", "templates"]
html_theme = "pydata_sphinx_theme"
html_title = f"haptonic {__version__}"
html_theme_options = {
    "navigation_with_keys": True,
    "navbar_center": [],  # the sidebar lists all pages
    "navbar_persistent": ["search-button"],  # its field has a name for screen readers
    "secondary_sidebar_items": ["page-toc"],
    "pygments_light_style": "a11y-high-contrast-light",
    "pygments_dark_style": "a11y-high-contrast-dark",
}
templates_path = ["templates"]
html_sidebars = {"**": ["pages.html"]}
html_static_path = ["static"]
html_css_files = ["haptonic.css"]
html_copy_source = html_show_sourcelink = False
html_math_renderer = "mathml"
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "cache"
nb_execution_raise_on_error = True
nb_execution_in_temp = True
nb_execution_timeout = 1800  # s on the clock; on a busy machine a cell of 30 s has taken 300
nb_merge_streams = True


def formula(writer: Any, node: Any) -> None:
    """Write a formula, in a line or by itself."""
    block = node.tagname == "math_block"
    mathml = convert(node.astext(), display="block" if block else "inline")
    writer.body.append(f'<div class="math">{mathml}</div>' if block else mathml)
    raise SkipNode


def setup(app: Any) -> None:
    """Called by Sphinx."""
    app.add_html_math_renderer("mathml", (formula, None), (formula, None))
