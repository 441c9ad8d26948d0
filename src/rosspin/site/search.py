"""Sphinx extension: the search keeps the index entries of pages that a build does not write, which Sphinx forgets."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from sphinx.application import Sphinx
from sphinx.util.index_entries import split_index_msg
from sphinx.util.typing import ExtensionMetadata

__all__ = ["setup"]


def _keep(app: Sphinx) -> list[Any]:
    builder: Any = app.builder
    for page, entries in app.env.domaindata["index"]["entries"].items():
        found = set()
        for kind, value, target, main, _ in entries:
            with suppress(ValueError):
                found |= {(each, target or "", main) for each in split_index_msg(kind, value)}
        builder.indexer._index_entries[page] = sorted(found)
    return []


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect the function above to what comes before the search index is written."""
    app.connect("html-collect-pages", _keep)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
