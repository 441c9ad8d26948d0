"""Sphinx extension: find out from the environment of the build where the site is published, and use that.

GitHub Actions and Read the Docs tell it. Elsewhere the pages name no address and no repository.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import urlsplit
from xml.etree import ElementTree

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.typing import ExtensionMetadata

from .vehicle import save_preview

__all__ = ["PREVIEW", "Published", "setup", "where"]

PREVIEW = "_static/preview.png"  # the picture of links to the site

BRANCH = "main"  # the one that readers are asked to edit


class Published(NamedTuple):
    """The ``address`` of the site, ending in a slash, and the ``repository`` on GitHub, as "owner/name".

    Each is "" if it is not known.
    """

    address: str
    repository: str

    @property
    def path(self) -> str:
        """The path of the address; "/" if it is not known."""
        return urlsplit(self.address).path or "/"


def where(environment: Mapping[str, str]) -> Published:
    """Return what these environment variables tell."""
    if environment.get("READTHEDOCS") == "True":
        cloned = re.search(
            r"github\.com[:/]([^/]+/[^/]+?)(\.git)?/?$", environment.get("READTHEDOCS_GIT_CLONE_URL", "")
        )
        address = environment.get("READTHEDOCS_CANONICAL_URL", "")
        return Published(address and address.rstrip("/") + "/", cloned[1] if cloned else "")
    if environment.get("GITHUB_ACTIONS") == "true":
        repository = environment["GITHUB_REPOSITORY"]
        owner, _, name = repository.partition("/")
        host = f"{owner.lower()}.github.io"
        return Published(f"https://{host}/" + (f"{name}/" if name.lower() != host else ""), repository)
    return Published("", "")


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect the functions below."""
    app.connect("html-page-context", _set_root)
    app.connect("build-finished", _write_sitemap)
    app.connect("build-finished", _draw_preview)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _set_root(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None) -> None:
    # sphinx-notfound-page leaves this path relative, but the theme's scripts find the other pages by it.
    if page == app.config.notfound_pagename:
        context["content_root"] = app.config.notfound_urls_prefix


def _write_sitemap(app: Sphinx, error: Exception | None) -> None:
    # sphinx-sitemap would know only the pages that this build has written.
    address = app.config.html_baseurl
    if error is not None or app.builder.format != "html" or not address:
        return
    urls = ElementTree.Element("urlset", xmlns="http://www.sitemaps.org/schemas/sitemap/0.9")
    for page in sorted(app.env.found_docs):
        ElementTree.SubElement(ElementTree.SubElement(urls, "url"), "loc").text = address + app.builder.get_target_uri(
            page
        )
    ElementTree.indent(urls)
    path = Path(app.outdir, "sitemap.xml")
    ElementTree.ElementTree(urls).write(path, encoding="utf-8", xml_declaration=True)


def _draw_preview(app: Sphinx, error: Exception | None) -> None:
    if error is None and app.builder.format == "html" and app.config.html_baseurl:
        save_preview(Path(app.srcdir), Path(app.outdir, PREVIEW), app.env.titles[app.config.root_doc].astext())
