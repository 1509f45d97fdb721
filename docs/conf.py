"""The site of these pages: `make docs` builds it without the network and without a warning."""

from haptonic import __version__

project = "haptonic"
version = release = __version__
extensions = ["myst_nb"]
root_doc = "index"
exclude_patterns = ["_build"]
html_theme = "pydata_sphinx_theme"
html_title = f"haptonic {__version__}"
html_theme_options = {"navigation_with_keys": True, "secondary_sidebar_items": ["page-toc"]}
html_copy_source = html_show_sourcelink = False
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "cache"  # of pages that are notebooks; their answers stay in _build
nb_execution_raise_on_error = True
