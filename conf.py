"""Sphinx settings: the source folder is the root, and what is made goes into build/."""

import doctest
import hashlib
import os
import sys
from pathlib import Path

from rosspin.site.published import BRANCH, PREVIEW, where

# Where JupyterLab is installed, jsonschema finds this and needs a second for its grammars, which no notebook uses.
sys.modules.setdefault("rfc3987_syntax", None)

root = Path(__file__).parent

project = "rosspin"
html_title = "rosspin"
copyright = "the rosspin contributors. The texts are CC BY 4.0, after a page by Paul N. Beuchat, 2023"

extensions = ["myst_nb", "rosspin.site.pages", "rosspin.site.live", "rosspin.site.slides"]
extensions += ["rosspin.site.times", "rosspin.site.paths", "rosspin.site.exercise_pages", "sphinx.ext.autodoc"]
extensions += ["sphinx_copybutton", "sphinx_design", "notfound.extension", "rosspin.site.published"]
extensions += ["rosspin.site.search"]
include_patterns = ["index.rst", "docs/**.rst", "notebooks/*.md"]
exclude_patterns = [".venv", "build"]  # not walked through in search of pages

nb_execution_mode = "force"  # runs a notebook whenever its page is read
nb_execution_allow_errors = True  # a cell that fails is listed with all else that no longer holds, at the end
nb_execution_timeout = 1200  # only a hang should end here, not a busy machine
nb_render_markdown_format = "gfm"  # CommonMark has no tables
nb_merge_streams = True  # a console mixes stdout and stderr
nb_code_prompt_show, nb_code_prompt_hide = "Show the code", "Hide the code"  # of cells that are folded
nb_ipywidgets_js = {}  # the default loads scripts from another host

# As Sphinx has them, but the message of an error is compared, too.
doctest_default_flags = doctest.ELLIPSIS | doctest.DONT_ACCEPT_TRUE_FOR_1

nitpick_ignore_regex = [("py:.*", r"(?!rosspin\b).*")]  # the names of other projects have their pages elsewhere

# "pip install rosspin" in the how-tos, instead of a clone: to be set with the first release on PyPI.
if released := False:
    tags.add("released")  # noqa: F821 (a name that Sphinx gives)

html_theme = "pydata_sphinx_theme"
html_favicon = "docs/_static/favicon.svg"
html_static_path = ["docs/_static"]
if (root / "build/web").exists():  # what runs in the page, from `make html`; the doctests do without
    html_static_path.append("build/web")
html_css_files = ["site.css"]
html_js_files = ["edition.js"]
html_search_scorer = "docs/_static/scorer.js"
templates_path = ["docs/_templates"]
html_sidebars = {"**": ["pages"]}
html_theme_options = {
    "navbar_center": [],
    "article_header_start": [],
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "back_to_top_button": False,  # it would float above plots and consoles
}
html_context = {"default_mode": "auto"}  # light or dark as the reader's system is
html_show_sourcelink = False

# What follows from the place where the site is published. Where that is not known, there is nothing of it.
published = where(os.environ)
notfound_urls_prefix = published.path
notfound_context = {
    "title": "Page not found",
    "body": f"""<h1>Page not found</h1><p>There is no page at this address. Choose one from the list of pages, search
        for a word, or go to the <a href="{published.path}index.html">start page</a>.</p>""",
}
if published.address:
    extensions.append("sphinxext.opengraph")
    html_baseurl = ogp_site_url = published.address
    ogp_social_cards = {"enable": False}  # one picture for all pages
    ogp_image = PREVIEW
    ogp_image_alt = "A vehicle that follows a winding line, and leaves it where a tick is overdue"
    ogp_custom_meta_tags = ('<meta name="twitter:card" content="summary_large_image" />',)
    ogp_enable_meta_description = True
if published.repository:
    user, _, name = published.repository.partition("/")
    html_context |= {"github_user": user, "github_repo": name, "github_version": BRANCH, "doc_path": ""}
    html_theme_options |= {"use_edit_page_button": True, "secondary_sidebar_items": ["page-toc", "edit-this-page"]}

# Sphinx keeps pages, and with them the outputs of notebooks, until this changes. The cache of myst-nb would not do: it
# sees the cells of a notebook only, and its downloads lack their outputs.
found = [*root.glob("src/**/*"), *root.glob("examples/**/*"), root / "pins/html.txt", root / "web/package-lock.json"]
used = sorted(path for path in found if path.is_file() and path.suffix != ".pyc")
what_pages_run = hashlib.sha256(b"".join(path.read_bytes() for path in used)).hexdigest()
