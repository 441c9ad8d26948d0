"""Sphinx extension: a page or notebook that says ``slides`` at its top can be shown as slides.

Its beginning is the first slide, each of its sections the next one; ``web/src/slides.js`` shows them. Nothing on the
page is made again for that: its listings run, and its figures have their handles.

In reStructuredText the mark is the field ``:slides:`` above the title, in a notebook ``slides: true`` in its front
matter.
"""

from __future__ import annotations

from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective
from sphinx.util.typing import ExtensionMetadata

__all__ = ["setup"]

_SCRIPT = "slides/slides.js"
_STYLE = "slides/slides.css"


class NotesDirective(SphinxDirective):
    """``.. notes::`` with ``:minutes: N``: what the speaker should know about a slide, and how long it takes.

    The notes are on the page and in the speaker's window, not on the slide.
    """

    has_content = True
    option_spec: ClassVar = {"minutes": directives.positive_int}

    def run(self) -> list[nodes.Node]:
        """Return the notes, under a line that gives the minutes."""
        minutes = self.options.get("minutes", 0)
        title = f"For the speaker, {minutes} min" if minutes else "For the speaker"
        begins = f"<div class='rosspin-notes' role='note' data-minutes='{minutes}'><p><b>{title}</b></p>"
        return [
            nodes.raw("", begins, format="html"),
            *self.parse_content_to_nodes(),
            nodes.raw("", "</div>", format="html"),
        ]


def _add_files(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None) -> None:
    if "slides" in app.env.metadata.get(page, {}):
        app.add_js_file(_SCRIPT, loading_method="defer")
        app.add_css_file(_STYLE)


def setup(app: Sphinx) -> ExtensionMetadata:
    """Add the directive, and the script where it is needed."""
    app.add_directive("notes", NotesDirective)
    app.connect("html-page-context", _add_files)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
