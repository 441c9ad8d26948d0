"""Sphinx extension: listings that can be run in the page, and what the pages allow themselves to load.

A listing of the class ``live`` (``:class: live`` on its literalinclude) is run by ``web/``, which finds it in the page.
"""

from __future__ import annotations

import base64
import hashlib
import re
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.typing import ExtensionMetadata

__all__ = ["setup"]

# What `make html` builds from web/, below the html_static_path.
_SCRIPT = "live/live.js"
_STYLE = "live/live.css"

_NO_JAVASCRIPT = (
    '<noscript><p class="live-missing">JavaScript is off, so this listing cannot be run in the page.</p></noscript>'
)

_INLINE_SCRIPT = re.compile(r"<script(?![^>]*\bsrc=)[^>]*>(.*?)</script>", re.DOTALL)
_CHARSET = '<meta charset="utf-8" />'


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect what follows."""
    app.connect("doctree-resolved", _say_without_javascript)
    app.connect("html-page-context", _add_files)
    app.connect("build-finished", _restrict_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _live_listings(doctree: nodes.document) -> list[nodes.literal_block]:
    return [node for node in doctree.findall(nodes.literal_block) if "live" in node["classes"]]


def _say_without_javascript(app: Sphinx, doctree: nodes.document, name: str) -> None:
    for listing in _live_listings(doctree):
        captioned = isinstance(listing.parent, nodes.container)
        place = listing.parent if captioned else listing
        place.parent.insert(place.parent.index(place) + 1, nodes.raw("", _NO_JAVASCRIPT, format="html"))


def _add_files(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None) -> None:
    # Where web/ was not built, as for the doctests, the listings are plain.
    built = any((Path(app.confdir) / folder / _SCRIPT).is_file() for folder in app.config.html_static_path)
    if doctree is not None and built and _live_listings(doctree):
        app.add_js_file(_SCRIPT, loading_method="defer")
        app.add_css_file(_STYLE)


def _restrict_pages(app: Sphinx, error: Exception | None) -> None:
    """Give each page a Content-Security-Policy: nothing from elsewhere, and of inline scripts only its own."""
    if error is not None or app.builder.format != "html":
        return
    for path in Path(app.outdir).rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        if "_static" not in path.parts and "Content-Security-Policy" not in text:
            head = f'{_CHARSET}\n    <meta http-equiv="Content-Security-Policy" content="{policy(text)}" />'
            path.write_text(text.replace(_CHARSET, head, 1), encoding="utf-8")


def policy(page: str) -> str:
    """The Content-Security-Policy of a page, given as HTML. Styles may be inline: plots and the editor have theirs."""
    digests = [hashlib.sha256(script.encode()).digest() for script in _INLINE_SCRIPT.findall(page)]
    hashes = [f"'sha256-{base64.b64encode(digest).decode()}'" for digest in digests]
    return "; ".join(
        [
            "default-src 'self'",
            " ".join(["script-src 'self' 'wasm-unsafe-eval'", *dict.fromkeys(hashes)]),
            "style-src 'self' 'unsafe-inline'",
            "img-src 'self' data:",
            "object-src 'none'",
            "base-uri 'self'",
            "form-action 'self'",
        ]
    )
