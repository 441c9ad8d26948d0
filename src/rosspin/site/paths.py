"""Sphinx extension: paths through the site, and on each page of one where on it that is, and what comes next.

A table of the class ``path`` is one: its name is the path's, its caption the title, and each row a step: the page
that it links to with ``:doc:``, and sections of one, linked to with ``:ref:``. A link with ``?path=NAME``, as in
the table, chooses a path, which ``edition.js`` remembers. Before one is chosen, a page is on the first of its
paths, of the class ``course`` before others; along that, the links to the next and the previous page lead, which
``edition.js`` changes for a path that was chosen.
"""

from __future__ import annotations

import html
from collections.abc import Sequence
from typing import Any, NamedTuple, cast

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.typing import ExtensionMetadata

__all__ = ["setup"]


class _Row(NamedTuple):
    text: str
    links: tuple[tuple[str, str], ...]  # the page of each, or "" and the label of a section


class _Step(NamedTuple):
    page: str
    sections: tuple[str, ...]  # empty for the whole page, which comes before sections of it
    title: str


class _Path(NamedTuple):
    page: str  # that has the table
    title: str
    course: bool
    rows: tuple[_Row, ...]


def _all(env: BuildEnvironment) -> dict[str, _Path]:
    return cast("dict[str, _Path]", env.__dict__.setdefault("rosspin_paths", {}))


def _collect(app: Sphinx, page: nodes.document) -> None:
    """Keep the paths of a page."""
    env = app.env
    for table in page.findall(nodes.table):
        if "path" not in table["classes"]:
            continue
        rows = []
        for row in next(table.findall(nodes.tbody)).children:
            found = cast("nodes.Element", row).findall(addnodes.pending_xref)
            links = [each for each in found if each["reftype"] in ("doc", "ref")]
            if links:
                docs = (each["reftarget"] if each["reftype"] == "doc" else "" for each in links)
                pages = (doc and env.relfn2path(f"{doc}.rst")[0][:-4] for doc in docs)
                targets = tuple(zip(pages, (each["reftarget"] for each in links)))
                rows.append(_Row(links[0].parent.astext(), targets))
        title = next(table.findall(nodes.title)).astext()
        _all(env)[table["names"][0]] = _Path(env.docname, title, "course" in table["classes"], tuple(rows))


def _purge(app: Sphinx, env: BuildEnvironment, page: str) -> None:
    for name in [name for name, path in _all(env).items() if path.page == page]:
        del _all(env)[name]


def _merge(app: Sphinx, env: BuildEnvironment, pages: Sequence[str], other: BuildEnvironment) -> None:
    _all(env).update({name: path for name, path in _all(other).items() if path.page in pages})


def _steps(env: BuildEnvironment) -> dict[str, list[_Step]]:
    """Return the steps of each path. A link that leads nowhere is none; Sphinx warns of it."""
    labels = env.domains.standard_domain.anonlabels
    found: dict[str, list[_Step]] = {}
    for name, path in _all(env).items():
        found[name] = []
        for text, links in path.rows:
            places = [(page, "") if page else labels.get(target, ("", "")) for page, target in links]
            page, first = places[0]
            if page in env.titles:
                sections = tuple(section for other, section in places if other == page)
                title = text if first else env.titles[page].astext()
                found[name].append(_Step(page, sections, title))
    return found


def _write_again(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Write all pages of paths again when these have changed."""
    now = {name: (_all(env)[name].title, steps) for name, steps in _steps(env).items()}
    before = env.__dict__.get("rosspin_steps", {})
    if now == before:
        return []
    env.__dict__["rosspin_steps"] = now
    changed = [*before.values(), *now.values()]
    return sorted({step.page for _, steps in changed for step in steps} & env.found_docs)


def _address(app: Sphinx, page: str, step: _Step, name: str = "") -> str:
    query, section = f"?path={name}" if name else "", f"#{step.sections[0]}" if step.sections[0] else ""
    return app.builder.get_relative_uri(page, step.page) + query + section


def _own(env: BuildEnvironment, page: str) -> dict[str, list[_Step]]:
    """Return the steps of the paths on which a page is, courses first."""
    found = {name: steps for name, steps in _steps(env).items() if any(step.page == page for step in steps)}
    return dict(sorted(found.items(), key=lambda item: not _all(env)[item[0]].course))


def _is_place(node: nodes.Node) -> bool:
    """Whether it can be a step: a section, or an exercise, which need not be one."""
    return isinstance(node, nodes.section) or (isinstance(node, nodes.container) and "exercise" in node["classes"])


def _add_lines(app: Sphinx, doctree: nodes.document, page: str) -> None:
    """Say where on its paths a page is, and let the links of a path choose it."""
    for table in doctree.findall(nodes.table):
        if "path" in table["classes"]:
            for link in table.findall(nodes.reference):
                address, mark, section = link.get("refuri", "").partition("#")
                link["refuri"] = f"{address}?path={table['names'][0]}{mark}{section}"
    found = cast("list[nodes.Element]", [*doctree.findall(_is_place)])
    sections = {name: each for each in found for name in each["ids"]}
    sections[""] = whole = found[0] if found else doctree
    for is_other, (name, steps) in enumerate(_own(app.env, page).items()):
        path = _all(app.env)[name]
        home = f"{app.builder.get_relative_uri(page, path.page)}#{name}"
        for number, step in enumerate(steps, 1):
            if step.page != page:
                continue
            line = f'<a href="{home}">{html.escape(path.title)}</a>, {number} of {len(steps)}'
            hidden = " hidden" if is_other else ""
            own = [sections[each] for each in step.sections if each in sections]
            after = [step._replace(sections=(each["ids"][0],), title=each[0].astext()) for each in own[1:]]
            before = steps[number - 2] if number > 1 else None
            leads = [*after, *steps[number : number + 1], None]
            for part, (place, following) in enumerate(zip(own, leads), 1):
                onward = " You have reached its end."
                if following:
                    to = _address(app, page, following, name)
                    onward = f' Next: <a href="{to}">{html.escape(following.title)}</a>'
                data = {"path": name}
                if before:
                    last = before._replace(sections=before.sections[-1:])
                    data |= {"previous": _address(app, page, last, name), "title": before.title}
                known = "".join(f' data-{key}="{html.escape(value)}"' for key, value in data.items())
                where = f"{line}, part {part} of {len(own)}." if len(own) > 1 else f"{line}."
                said = f'<p class="rosspin-path"{known}{hidden}>{where}{onward}</p>'
                before = _Step(page, ("" if place is whole else place["ids"][0],), place[0].astext())
                place.insert(1 if place is whole else len(place), nodes.raw("", said, format="html"))


def _lead_on(app: Sphinx, page: str, template: str, context: dict[str, Any], doctree: nodes.document | None) -> None:
    """Let the links below a page lead along its first path."""
    for steps in list(_own(app.env, page).values())[:1]:
        places = [place for place, step in enumerate(steps) if step.page == page]
        for name, place in ("prev", places[0] - 1), ("next", places[-1] + 1):
            if 0 <= place < len(steps):
                step = steps[place]
                context[name] = {"link": _address(app, page, step), "title": html.escape(step.title)}


def setup(app: Sphinx) -> ExtensionMetadata:
    """Connect the functions above."""
    app.connect("env-purge-doc", _purge)
    app.connect("env-merge-info", _merge)
    app.connect("doctree-read", _collect)
    app.connect("env-updated", _write_again)
    app.connect("doctree-resolved", _add_lines)
    app.connect("html-page-context", _lead_on)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
