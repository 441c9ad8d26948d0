"""Sphinx extension: each exercise of the site has a page of its own; the page that has them all becomes a list of them.

The search, the links of other pages and the times know them on the list; ``web/`` leads on from its anchors.
A teacher's exercise stays on its page.
"""

from __future__ import annotations

import difflib
import html
import posixpath
import re
from collections.abc import Iterator
from itertools import groupby
from typing import Any, NamedTuple, cast
from urllib.parse import urljoin

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.builders.html import StandaloneHTMLBuilder
from sphinx.util.typing import ExtensionMetadata
from sphinx_design.tabs import sd_tab_input

from ..exercises.own import FOLDER, LESSONS
from .times import rounded, seconds

__all__ = ["difference", "setup"]

_ANSWER = re.compile(r"%%answer (\S+)\n")
# An answer of fewer lines stays in view while one reads the node that it is about, unless that can be run.
_FEW_LINES = 8
_LINK = re.compile(r'(?<= )(href|src|data-previous)="(?!\w+:)([^"]*)"')
_TEACHERS = {lesson.exercise.name for lesson in LESSONS if lesson.file.parent == FOLDER}


class _Exercise(NamedTuple):
    name: str
    title: str
    minutes: int
    section: nodes.Element

    def link(self, text: str, more: str = "") -> str:
        """Return a link from a page of the site's second level."""
        return f'<a href="../exercises/{self.name}.html" data-exercise="{self.name}"{more}>{html.escape(text)}</a>'


def difference(start: str, solution: str) -> nodes.literal_block:
    """Show a solution as a difference to what was given; where little of that is left, as it is."""
    old, new, language = start.splitlines(), solution.splitlines(), "ipython3"
    if difflib.SequenceMatcher(None, old, new, autojunk=False).ratio() > 0.4:
        found = [*difflib.unified_diff(old, new, lineterm="", n=2)][3:]
        new, language = ["..." if line.startswith("@@") else line for line in found], "diff"
    text = "\n".join(new)
    return nodes.literal_block(text, text, language=language)


def _exercises(page: nodes.document) -> Iterator[_Exercise]:
    known = set(_TEACHERS)
    for listing in page.findall(nodes.literal_block):
        found = _ANSWER.match(listing.astext())
        if found and "live" in listing["classes"] and found[1] not in known:
            known.add(found[1])  # in another language it is the same one
            section: Any = listing.parent
            while not isinstance(section, nodes.section) and "exercise" not in section["classes"]:
                section = section.parent
            title = section[0].astext().replace("Exercise ", "").replace(": ", ". ", 1)
            yield _Exercise(found[1], title, rounded([seconds(section)]), section)


def _raw(text: str) -> nodes.raw:
    return nodes.raw("", text, format="html")


def _alone(exercise: _Exercise, following: str) -> nodes.section:
    """Turn a section into a page, which leads on below the answer."""
    section = nodes.section("", nodes.title("", exercise.title), ids=exercise.section["ids"])
    alone = sum("live" in listing["classes"] for listing in exercise.section.findall(nodes.literal_block)) == 1
    for part in exercise.section.children[1:]:
        section += part
        answers = [text for listing in part.findall(nodes.literal_block) if _ANSWER.match(text := listing.astext())]
        if answers:
            section += _raw(following)
        if alone and any(text.count("\n") < _FEW_LINES for text in answers):
            cast(nodes.Element, part)["classes"].append("exercise-few-lines")
    return section


def _render(app: Sphinx, doctree: nodes.document) -> str:
    for node in doctree.findall(sd_tab_input):
        node["ids"] = []  # docutils adds the one that it is given, each time that it writes the node
    visitor: Any = app.builder.create_translator(doctree, app.builder)
    doctree.walkabout(visitor)
    return "".join(visitor.fragment)


def _list(exercises: list[_Exercise]) -> nodes.raw:
    items = []
    for each in exercises:
        anchors = "".join(f'<span id="{name}"></span>' for name in each.section["ids"])
        items.append(f"<li>{anchors}{each.link(each.title)} <small>{each.minutes} minutes</small></li>")
    return _raw(f'<ul class="exercise-list">{"".join(items)}</ul>')


def _split(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None) -> None:
    """Put lists in the place of a page's exercises, and keep these, with their pages."""
    exercises = [*_exercises(doctree)] if doctree and page in app.env.found_docs else []
    if not (doctree and exercises):
        return
    for _, group in groupby(exercises, lambda each: id(each.section.parent)):
        first, *others = listed = [*group]
        parent = cast(nodes.Element, first.section.parent)
        parent[parent.index(first.section)] = _list(listed)
        for each in others:
            parent.remove(each.section)
    pages = app.env.__dict__.setdefault("rosspin_exercise_pages", [])
    for number, exercise in enumerate(exercises):
        pages.append(_page(app, page, context, doctree, exercises, number))
    context["body"] = _lead(_render(app, doctree), page, exercises, posixpath.dirname(f"/{page}"))


def _page(
    app: Sphinx, home: str, context: dict[str, Any], doctree: nodes.document, exercises: list[_Exercise], number: int
) -> tuple[str, dict[str, Any], nodes.document]:
    exercise = exercises[number]
    around = {}
    for name, place in ("prev", number - 1), ("next", number + 1):
        if 0 <= place < len(exercises):
            around[name] = {"link": f"../exercises/{exercises[place].name}.html", "title": exercises[place].title}
    around.setdefault("prev", {"link": f"../{home}.html", "title": context["title"]})
    back = f'<a href="../{home}.html">{context["title"]}</a>'
    onward = exercises[number + 1].link(f"Next: {exercises[number + 1].title}") if "next" in around else back
    alone = doctree.copy()
    alone += _alone(exercise, f'<p class="exercise-next" hidden>{onward}</p>')
    links = []
    for each in exercises:
        more = f' title="{html.escape(each.title)}"' + ' aria-current="page"' * (each is exercise)
        links.append(f"<li>{each.link(each.title.partition('.')[0], more)}</li>")
    way = f'<nav class="exercise-way" aria-label="Exercises"><p>{back}, {number + 1} of {len(exercises)}</p>'
    body = _lead(_render(app, alone), home, exercises, "/exercises")
    own: dict[str, Any] = {"title": html.escape(exercise.title), "body": f"{way}<ol>{''.join(links)}</ol></nav>{body}"}
    own |= {"prev": around.get("prev"), "next": around.get("next"), "meta": {"html_theme.sidebar_secondary.remove": ""}}
    return f"exercises/{exercise.name}", {**own, "metatags": "", "toc": "", "display_toc": False, "parents": []}, alone


def _lead(text: str, home: str, exercises: list[_Exercise], folder: str) -> str:
    """Let links of the list, or of what was on it, lead to the pages of exercises, and to all else, from a folder."""
    places = {anchor: f"/exercises/{each.name}.html" for each in exercises for anchor in each.section["ids"]}

    def lead(link: re.Match[str]) -> str:
        page, mark, anchor = urljoin(f"/{home}.html", link[2]).partition("#")
        address, question, query = page.partition("?")
        if address == f"/{home}.html" and anchor in places:
            address, mark, anchor = places[anchor], "", ""
        elif folder == posixpath.dirname(f"/{home}"):
            return link[0]
        return f'{link[1]}="{posixpath.relpath(address, folder)}{question}{query}{mark}{anchor}"'

    return _LINK.sub(lead, text)


def _write(app: Sphinx) -> list[tuple[str, dict[str, Any], str]]:
    """Write the pages of the exercises on the lists that were written."""
    builder = cast(StandaloneHTMLBuilder, app.builder)
    for page, context, doctree in app.env.__dict__.pop("rosspin_exercise_pages", []):
        builder.handle_page(page, context, event_arg=doctree)
    return []


def _write_serially(app: Sphinx) -> None:
    """Let one process write all pages: what is kept while lists are written would be lost with another."""
    type(app.builder).allow_parallel = False


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect the functions above, after all that adds to a page."""
    app.connect("builder-inited", _write_serially)
    app.connect("html-page-context", _split, priority=900)
    app.connect("html-collect-pages", _write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
