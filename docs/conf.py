"""How Sphinx makes the manual; `nox -s docs` runs it. Nothing is asked from the network."""

project = "repro"
author = "The repro founders"
project_copyright = author
html_title = "repro"

extensions = ["myst_parser", "sphinx.ext.autodoc"]
exclude_patterns = ["examples", "_build", "pyodide/node_modules"]
default_role = "code"
myst_heading_anchors = 3

autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
python_use_unqualified_type_names = True

html_theme = "furo"
html_static_path = ["_static"]
html_copy_source = False
html_show_sourcelink = False
