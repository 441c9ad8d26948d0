"""Sphinx extension: the directives and roles by which pages show runs."""

from __future__ import annotations

import math
import os
import re
import shlex
import subprocess
import sys
import textwrap
from collections.abc import Iterable, Iterator
from contextlib import chdir
from dataclasses import replace
from pathlib import Path
from typing import Any, ClassVar, cast

from docutils import nodes
from docutils.parsers.rst import directives
from pygments.lexer import inherit
from pygments.lexers.c_cpp import CppLexer
from pygments.lexers.python import PythonLexer
from pygments.token import Keyword
from sphinx.application import Sphinx
from sphinx.directives.code import LiteralInclude
from sphinx.environment import BuildEnvironment
from sphinx.util.docutils import SphinxDirective, SphinxRole
from sphinx.util.typing import ExtensionMetadata

from .. import plots, rclpy, rospy
from ..clocks.clock import NS
from ..clocks.explored import Order
from ..clocks.simulation import Simulation
from ..faults import read
from ..look import look
from ..measures import by_source, topic_ticks
from ..orders.exploring import compare_orders
from ..plots import both_orders, overview, picture, with_handle
from ..plots.pictures import figure_of, new_axes, page
from ..results import machine
from ..results.ticks import Run, Tick
from ..run.host import kept, replaced
from ..run.kinds import written_in
from ..run.simulate import run_captured
from ..run.source import load, load_source
from . import scenes
from .claims import Facts, one_line
from .notes import note
from .outputs import differences
from .vehicle import NODES, figure

__all__ = ["setup"]

_CAPTION = "simulated"
_HEIGHT = 200  # px of a plot of a log


class TicksDirective(SphinxDirective):
    """``.. ticks:: FILE ARGS`` with ``:seconds: S``: runs a node file in simulated time and draws its timeline.

    FILE is relative to the page. Several files, each on a line of the content as ``NAME: FILE ARGS``, share one plot.
    With ``:period: S`` the plot shows the whole grid of that period, and crosses for lost ticks. With ``:topic: /NAME``
    it shows the messages that the node published on a topic, in place of its ticks. One file has a row for each of its
    callbacks that ticked; ``:callbacks: NAMES`` gives these one, in this order, also one that is never called.

    ``:faults:`` are what should go wrong with the one FILE, each on a line, as in ``Crash("/node", at=2.0)``.

    ``:handle: LABEL, FROM to TO by STEP UNIT`` lets the reader move a number; a run is made now for each value. The
    number replaces ``{}`` in ARGS, or what the file assigns to the variable named by ``:sets:``. It begins with
    ``:at:``, or as the file has it. ``:lines: FROM-TO`` shows these lines of the file next to the plot, where the
    number follows the handle.
    """

    has_content = True
    optional_arguments = 1
    final_argument_whitespace = True
    option_spec: ClassVar = {
        **dict.fromkeys(("seconds", "period", "at"), lambda text: float(directives.unchanged_required(text))),
        **dict.fromkeys(("handle", "sets", "lines", "topic", "callbacks", "faults"), directives.unchanged_required),
    }

    def run(self) -> list[nodes.Node]:
        """Return the plot, as inline SVG."""
        try:
            return list(self._shown(self._plot()))
        except Exception as error:
            command = self.arguments[0] if self.arguments else "; ".join(self.content) or "nothing"
            # A fault of the directive is a sentence; other errors need their names.
            said = str(error) if type(error) is ValueError else one_line(error)
            note(self.env, self.lineno, f"a plot of {command}", said)
            return []

    def _commands(self) -> dict[str, list[str]]:
        commands = {}
        for row in self.content or [f": {argument}" for argument in self.arguments]:
            name, colon, command = row.partition(": ")
            if not (colon and command.strip()):
                raise ValueError(f"a row is NAME: FILE ARGS, not {row!r}")
            if name in commands:
                raise ValueError(f"two rows have the name {name}")
            commands[name] = shlex.split(command)
        if not commands:
            raise ValueError("no node is named: give a FILE, or rows of the form NAME: FILE ARGS")
        return commands

    def _file(self, name: str) -> str:
        relative, path = self.env.relfn2path(name)
        self.env.note_dependency(relative)
        if not os.path.isfile(path):
            raise ValueError(f"there is no {name}: a path begins where the page is")
        return os.fspath(path)

    def _plot(self) -> str:
        period = self.options.get("period")
        if "faults" in self.options:
            return page(picture(self._broken(), period, caption=_CAPTION))
        if "handle" not in self.options:
            return page(picture(self._ticks(None), period, caption=_CAPTION))
        found = re.fullmatch(r"(.+), (\S+) to (\S+) by (\S+) (.+)", self.options["handle"])
        if found is None:
            raise ValueError("a handle is LABEL, FROM to TO by STEP UNIT")
        first, last, step = map(float, found.group(2, 3, 4))
        if first >= last or step <= 0:
            raise ValueError("a handle goes from a number to a greater one, by a step above 0")
        sets = self.options.get("sets", "")
        if not sets and not any("{}" in word for _, *args in self._commands().values() for word in args):
            raise ValueError("the handle moves nothing: name a variable with :sets:, or write {} among the arguments")
        if not sets and "at" not in self.options:
            raise ValueError("the handle's first position is missing: give :at:, or a variable with :sets:")
        at = self.options["at"] if "at" in self.options else float(self._assignment(sets)[2])
        values = {at, *(round(first + number * step, 9) for number in range(round((last - first) / step) + 1))}
        runs = {value: self._ticks(value, f" at {value:g} {found[5]}") for value in sorted(values)}
        rows = {row: replace(run, ticks=[], coming=()) for rows in runs.values() for row, run in rows.items()}
        runs = {value: rows | ticks for value, ticks in runs.items()}
        return with_handle(found[1], found[5], runs, at, period, sets, caption=_CAPTION).html

    def _broken(self) -> Run:
        if len(self._commands()) > 1 or "handle" in self.options or "topic" in self.options:
            raise ValueError(":faults: is for the ticks of one FILE, without a handle")
        ((file, *args),) = self._commands().values()
        faults = [read(line) for line in self.options["faults"].splitlines()]
        return run_captured(Simulation(), load(self._file(file)), self._seconds(), args, faults=faults)

    def _ticks(self, value: float | None, where: str = "") -> dict[str, Run]:
        runs: dict[str, Run] = {}
        seconds = self._seconds()
        for name, (file, *args) in self._commands().items():
            given = [word.replace("{}", str(value)) for word in args]
            found = self._run(self._file(file), given, value)
            if "callbacks" in self.options:
                runs |= {own: _only(own, found) for own in self._callbacks(file)}
            elif name:
                runs[name] = found
            else:
                runs |= {source: _only(source, found) for source in by_source(found.ticks)}
        if not any(run.ticks for run in runs.values()):
            raise ValueError(f"there is no tick in {seconds:g} s{where}")
        return runs

    def _callbacks(self, file: str) -> list[str]:
        text, names = Path(self._file(file)).read_text(encoding="utf-8"), str(self.options["callbacks"]).split()
        if lacking := [name for name in names if f"def {name}(" not in text]:
            raise ValueError(f"{file} defines no {lacking[0]}")
        return names

    def _seconds(self) -> float:
        if "seconds" not in self.options:
            raise ValueError(":seconds: is missing: how long the node runs")
        return float(self.options["seconds"])

    def _run(self, path: str, args: list[str], value: float | None) -> Run:
        node = load(path)
        if value is not None and "sets" in self.options:
            at = self._assignment(self.options["sets"])
            node = load_source(f"{at.string[: at.start(2)]}{value}{at.string[at.end(2) :]}", path)
        run = run_captured(Simulation(), node, self.options["seconds"], args)
        topic = self.options.get("topic")
        return replace(run, ticks=topic_ticks(run.messages, topic), coming=()) if topic else run

    def _assignment(self, variable: str) -> re.Match[str]:
        """Find the line of the first file that assigns a number to a variable."""
        file = next(iter(self._commands().values()))[0]
        text = Path(self._file(file)).read_text(encoding="utf-8")
        found = re.search(rf"^( *{re.escape(variable)} = )([\d.]+)$", text, re.MULTILINE)
        if found is None:
            raise ValueError(f"{file} assigns no number to {variable}")
        return found

    def _shown(self, plot: str) -> Iterator[nodes.Node]:
        drawn = nodes.raw("", plot, format="html")
        if "lines" not in self.options:
            yield drawn
            return
        first, last = map(int, self.options["lines"].split("-"))
        file = Path(self._file(next(iter(self._commands().values()))[0]))
        text = textwrap.dedent("\n".join(file.read_text(encoding="utf-8").splitlines()[first - 1 : last]))
        yield nodes.raw("", '<div class="rosspin-beside">', format="html")
        language = written_in(text)
        yield nodes.literal_block(text, text, language=language.name if language else "python")
        yield drawn
        yield nodes.raw("", "</div>", format="html")


def _only(source: str, run: Run) -> Run:
    ticks, coming = (by_source(found).get(source, []) for found in (run.ticks, run.coming))
    return replace(run, ticks=ticks, coming=coming)


class ScenesDirective(TicksDirective):
    """``.. scenes:: FILE ARGS`` with ``:seconds: S``: runs a node of ROS 2 in simulated time, to be gone through.

    The file is next to what its executor does, step by step. Where no script runs, the steps are a list. With
    ``:rings:`` only the picture of what waits for what is shown.
    """

    has_content = False
    required_arguments, optional_arguments = 1, 0
    option_spec: ClassVar = {"seconds": TicksDirective.option_spec["seconds"], "rings": directives.flag}

    def _plot(self) -> str:
        ((file, *args),) = self._commands().values()
        return scenes.figure(self._file(file), self._seconds(), args, "rings" in self.options)

    def _shown(self, plot: str) -> Iterator[nodes.Node]:
        if "rings" in self.options:
            yield nodes.raw("", plot, format="html")
            return
        ((file, *_),) = self._commands().values()
        text = Path(self._file(file)).read_text(encoding="utf-8")
        yield nodes.raw("", '<div class="rosspin-beside">', format="html")
        yield nodes.literal_block(text, text, language="python")
        yield nodes.raw("", f"{plot}</div>", format="html")


class OrdersDirective(TicksDirective):
    """``.. orders:: FILE ARGS`` with ``:seconds: S`` and ``:schedule: TOKEN``: this order next to the usual one."""

    has_content = False
    required_arguments, optional_arguments = 1, 0
    option_spec: ClassVar = {
        "seconds": TicksDirective.option_spec["seconds"],
        "schedule": directives.unchanged_required,
    }

    def _plot(self) -> str:
        ((file, *args),) = self._commands().values()
        found = compare_orders(self._file(file), self._seconds(), Order.of(self.options["schedule"]), args)
        if not found.instants:
            raise ValueError("the schedule is none of this node: explore again")
        return page(both_orders(found))


class FactsDirective(SphinxDirective):
    """``.. facts::``: Python above the sentence that it is about, run in the source folder and not shown.

    A statement that fails is listed at the end of the build, which then fails. Later facts on the page and the role
    ``fact`` can use its names.
    """

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Run the facts, and show nothing."""
        file, line = self.get_source_info()
        code = "\n" * self.content_offset + "\n".join(self.content)
        block = line, self.content_offset + len(self.content)
        with chdir(self.env.srcdir):
            for failed, stands, now in _facts(self.env).run(code, file):
                note(self.env, failed, stands, now, block)
        return []


class FactRole(SphinxRole):
    """``fact``: a value from the page's facts, given as an expression and a format as in an f-string."""

    def run(self) -> tuple[list[nodes.Node], list[nodes.system_message]]:
        """Return the value as text."""
        text, error = _facts(self.env).value(self.text)
        if error:
            note(self.env, self.get_source_info()[1], self.rawtext, error)
        return [nodes.Text(text)], []


def _facts(env: BuildEnvironment) -> Facts:
    return cast(Facts, env.temp_data.setdefault("facts", Facts()))


class ListingDirective(LiteralInclude):
    """``literalinclude`` with ``:changed-from: FILE``, the file of which the listing is a changed copy.

    The lines that FILE lacks, or has in another form, are marked. The list at the end of the build has what cannot be
    shown, and captions that name a file which is not in ``examples/``.
    """

    option_spec: ClassVar = {**LiteralInclude.option_spec, "changed-from": directives.unchanged_required}

    def run(self) -> list[nodes.Node]:
        """Return the listing."""
        if "changed-from" in self.options:
            old, new = (self._lines(name) for name in (self.options["changed-from"], self.arguments[0]))
            changed = [str(n + 1) for _, _, _, start, end in differences(old, new) for n in range(start, end)]
            self.options["emphasize-lines"] = ",".join(changed)
        shown = super().run()
        if isinstance(shown[0], nodes.system_message):
            note(self.env, self.lineno, self.block_text, shown[0].children[0].astext())
        caption = self.options.get("caption")
        if caption and not any(Path(self.env.srcdir, "examples").rglob(Path(caption).name)):
            note(self.env, self.lineno, f":caption: {caption}", f"the file is {self.arguments[0]}")
        return shown

    def _lines(self, name: str) -> list[str]:
        relative, path = self.env.relfn2path(name)
        self.env.note_dependency(relative)
        return Path(path).read_text(encoding="utf-8").splitlines()


class LookDirective(SphinxDirective):
    """``.. look:: FILE``: what ``rosspin look`` prints of a log, as of a file ``console.txt``.

    ``:plot: overview`` gives the plot of it in place of that.

    ``:shows: NAME`` is for the section on a verdict, which has to be the first that this log gets: then there is only
    the ``:plot:`` of that name in :mod:`rosspin.plots`, of the part ``:seconds: FROM-TO``. Lines that match
    ``:without:`` are left out before.
    """

    required_arguments = 1
    option_spec: ClassVar = dict.fromkeys(("plot", "seconds", "shows", "without"), directives.unchanged_required)

    def run(self) -> list[nodes.Node]:
        """Return the console, and the plot as inline SVG."""
        relative, path = self.env.relfn2path(self.arguments[0])
        self.env.note_dependency(relative)
        try:
            return list(self._shown(Path(path).read_bytes()))
        except Exception as error:
            note(self.env, self.lineno, self.block_text, one_line(error))
            return []

    def _shown(self, data: bytes) -> Iterator[nodes.Node]:
        caption = "recorded on a real ROS"
        if without := self.options.get("without"):
            data = b"\n".join(line for line in data.splitlines() if not re.search(without.encode(), line))
            caption += ", some lines taken out"
        found = look(data, "console.txt")
        if "shows" not in self.options:
            if "plot" in self.options:
                yield nodes.raw("", page(overview(found.ticks(), caption=caption)), format="html")
            else:
                text = "\n".join(["$ rosspin look console.txt --plot look.svg", *found.report()])
                yield nodes.literal_block(text, text, language="text")
            return
        if found.verdicts[0].name != self.options["shows"]:
            raise ValueError(f"this log is told to be {found.verdicts[0].name}")
        times = [
            Tick(each.name, n, (time - found.start) / NS, (time - found.start) / NS, math.nan)
            for each in found.series
            for n, time in enumerate(each.times, 1)
        ]
        ticks, plot = found.ticks() or times, self.options["plot"]
        if plot == "timeline":
            drawn = picture(ticks, caption=caption)
        else:
            drawn = figure_of(getattr(plots, plot)(ticks, caption=caption, ax=new_axes(_HEIGHT)))
        if "seconds" in self.options:
            drawn.axes[0].set_xlim(*map(float, self.options["seconds"].split("-")))
        yield nodes.raw("", page(drawn), format="html")


class VehicleDirective(SphinxDirective):
    """``.. vehicle::``: the figure of the first page, a vehicle that nodes steer in simulated time."""

    def run(self) -> list[nodes.Node]:
        """Return the figure, as inline SVG with all its positions."""
        for file, _ in NODES.values():
            self.env.note_dependency(file)
        try:
            return [nodes.raw("", figure(Path(self.env.srcdir)), format="html")]
        except Exception as error:  # of a node that the author has changed
            note(self.env, self.lineno, self.block_text, one_line(error))
            return []


class UsageDirective(SphinxDirective):
    """``.. usage:: run``: what ``rosspin run --help`` prints, in 72 columns."""

    optional_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the text, as it is."""
        command = [sys.executable, "-m", "rosspin", *self.arguments, "--help"]
        environment = {**os.environ, "COLUMNS": "72", "NO_COLOR": "1"}
        text = subprocess.run(command, env=environment, check=True, capture_output=True, text=True).stdout
        return [nodes.literal_block(text, text, language="text")]


class NamesDirective(SphinxDirective):
    """``.. names:: rospy full``: the names that a stand-in has; ``part``: has in part; ``none``: does not have."""

    required_arguments = 2

    def run(self) -> list[nodes.Node]:
        """Return a table of the names that there are, or of what some of them lack; for ``none`` a row of names."""
        module, which = self.arguments
        stand_in = {"rospy": rospy, "rclpy": rclpy}[module]
        match which:
            case "full" if module == "rospy":
                names = sorted(set(rospy.__all__) - rospy.IN_PART.keys(), key=str.lower)
                text = _table("Name", "What it does", rows=[(_code(name), _rospy_does(name)) for name in names])
            case "full":
                rows = [(_code(name), _code(*sorted(names, key=str.lower))) for name, names in _rclpy_names().items()]
                text = _table("Module", "Names", rows=rows)
            case "part":
                lacking: dict[str, list[str]] = {}
                for name, what in sorted(stand_in.IN_PART.items()):
                    lacking.setdefault(what, []).append(name)
                rows = [(_code(*lacking[what]), what) for what in lacking]
                text = _table("Names", "What is different", rows=rows, widths="50 50")
            case _:
                missing = rospy.NOT_SIMULATED if module == "rospy" else _rclpy_lacks()
                text = _code(*sorted(missing, key=str.lower))
        return self.parse_text_to_nodes(text)


def _code(*names: str) -> str:
    return ", ".join(f"``{name}``" for name in names)


def _rospy_does(name: str) -> str:
    """Return the first paragraph of a name's docstring."""
    value = getattr(rospy, name)
    if isinstance(value, int):
        return f"A severity, {value}, for the ``log_level`` of ``init_node``."
    return " ".join((value.__doc__ or "").partition("\n\n")[0].split())


def _rclpy_lacks() -> set[str]:
    """Return the names that the modules of the stand-in for rclpy lack."""
    return {f"{where}.{name}" for where, names in rclpy.LACKING.items() for name in names}


def _rclpy_names() -> dict[str, list[str]]:
    """Return the names of each module of rclpy. Where a file stands for several, each name is listed in its own."""
    return {
        module: [
            name
            for name in file.__all__
            if getattr(file.__spec__, "name", "").endswith(module)  # runs call it otherwise
            or module.endswith(f".{name}")
            or getattr(getattr(file, name), "__module__", "") == module
        ]
        for module, file in sorted(rclpy.MODULES.items())
        if file.__all__
    }


class PatchedDirective(SphinxDirective):
    """``.. patched::``: what a run replaces in modules, and what it puts back at its end."""

    def run(self) -> list[nodes.Node]:
        """Two lists, made from the data by which a run patches and puts back."""
        names: dict[str, list[str]] = {}
        for place, name, _ in replaced():
            names.setdefault(getattr(place, "__qualname__", place.__name__), []).append(name)
        lines = [f"{place}: {', '.join(sorted(set(found)))}" for place, found in sorted(names.items())]
        return [
            _bullets(lines),
            nodes.paragraph(text="What is as before when a run is over:"),
            _bullets(map(str, kept())),
        ]


def _bullets(lines: Iterable[str]) -> nodes.bullet_list:
    items = [nodes.list_item("", nodes.paragraph(text=line)) for line in lines]
    return nodes.bullet_list("", *items)


class MachineDirective(SphinxDirective):
    """``.. machine:: myst-nb Sphinx``: the machine that builds this page, and the versions of these packages."""

    has_content = False
    optional_arguments = 1
    final_argument_whitespace = True

    def run(self) -> list[nodes.Node]:
        """Return a table."""
        packages = "".join(self.arguments).split()
        described = machine.describe(packages)
        self.env.metadata[self.env.docname]["machine"] = packages, described
        return self.parse_text_to_nodes(_table("What", "Value", rows=described.items()))


def moved(app: Sphinx, env: BuildEnvironment, added: set[str], changed: set[str], removed: set[str]) -> list[str]:
    """Return the pages that describe another machine or Python than this one: they are read again."""
    shown = ((page, data["machine"]) for page, data in env.metadata.items() if "machine" in data)
    return [page for page, (packages, described) in shown if machine.describe(packages) != described]


def _table(*headings: str, rows: Iterable[Iterable[str]], widths: str = "auto") -> str:
    def lines() -> Iterator[str]:
        yield from (".. list-table::", "   :header-rows: 1", f"   :widths: {widths}", "")
        for row in (headings, *rows):
            for column, cell in enumerate(row):
                yield f"   {' ' if column else '*'} - {cell}"

    return "\n".join(lines())


class CellLexer(PythonLexer):
    """Python as in the cells of a notebook, where a line may begin with a magic. The rest of a cell may be C++."""

    name = "IPython cell"
    aliases: ClassVar = ["ipython3"]
    tokens: ClassVar = {"root": [(r"^%%?\w+", Keyword.Namespace), inherit]}

    def get_tokens_unprocessed(self, text: str, stack: Iterable[str] = ("root",)) -> Iterator[tuple[int, Any, str]]:
        """Yield where each token is, its kind and its text."""
        first, newline, rest = text.partition("\n")
        is_other = first.startswith("%%") and written_in(rest)
        yield from super().get_tokens_unprocessed(first + newline if is_other else text, stack)
        if is_other:
            for at, kind, token in CppLexer().get_tokens_unprocessed(rest):  # type: ignore[no-untyped-call]
                yield len(first + newline) + at, kind, token


def offer_download(app: Sphinx, page: str, source: list[str]) -> None:
    """End the introduction of a notebook with a link to the notebook that was run.

    The link is made here because JupyterLab would show the role as it is. No line is added: line numbers stay true,
    and what ends there, such as a directive, keeps its last line.
    """
    if page.startswith("notebooks/"):
        link = f"{{nb-download}}`Download this notebook, with its outputs <{page.rpartition('/')[2]}.ipynb>`."
        source[0] = source[0].replace("\n\n## ", f"\n{link}\n## ", 1)


def name_terms(app: Sphinx, page: nodes.document) -> None:
    """Let a link in Markdown lead to a term of the glossary: ``[jitter](../docs/glossary.rst#term-jitter)``."""
    labels = app.env.domains.standard_domain
    for term in page.findall(nodes.term):
        for name in term["ids"]:
            labels.note_hyperlink_target(name, app.env.docname, name)


def link_by_label(app: Sphinx, page: nodes.document) -> None:
    """Let the link of a heading be its label, if it has one: it stays when the words of the heading change."""
    labels = {page.nameids[name] for name, is_explicit in page.nametypes.items() if is_explicit}
    for section in page.findall(nodes.section):
        if labels & {*section["ids"]}:
            section["ids"].sort(key=lambda name: name not in labels)
            section["classes"].append("labelled")


def name_pages(app: Sphinx, env: BuildEnvironment) -> list[str]:
    """Write all pages again when one comes, goes or changes its name: each page lists and links them."""
    titles = {page: title.astext() for page, title in env.titles.items()}
    now = titles, env.toctree_includes, env.tocs[app.config.root_doc].pformat()  # with the captions
    if app.builder.format != "html" or env.__dict__.get("rosspin_names") == now:
        return []
    env.__dict__["rosspin_names"] = now
    return sorted(env.found_docs)


def name_exercises(app: Sphinx, page: nodes.document) -> None:
    """Let links lead to each exercise by its name, which stays: ``exercises.html#ten-hertz``, ``:ref:`ten-hertz```."""
    labels = app.env.domains.standard_domain
    for listing in page.findall(nodes.literal_block):
        if match := re.match(r"%%answer (\S+)\n", listing.astext()):
            section: Any = listing.parent
            while not isinstance(section, nodes.section) and "exercise" not in section["classes"]:
                section = section.parent
            above = section.parent
            if "exercise" in section["classes"] and above[0].astext().endswith(section[0].astext().partition(": ")[2]):
                place = above.index(section)  # the heading is on the page, and not the directive's
                above[place : place + 1] = section.children[1:]
                section = above
            labels.note_hyperlink_target(match[1], app.env.docname, match[1])
            if match[1] not in section["ids"]:
                section["ids"].append(match[1])


# The space before a unit. After the value of a fact, the unit is in a text of its own.
_SPACE_BEFORE_UNIT = re.compile(r"(?<=\d)\s(?=(?:s|ms|Hz)\b)")


def keep_units(app: Sphinx, page: nodes.document) -> None:
    """Let no line break between a number and its unit, except in code."""
    for element in page.findall(nodes.TextElement):
        if isinstance(element, nodes.literal | nodes.FixedTextElement):
            continue
        before = ""
        for place, child in enumerate(element.children):
            if isinstance(child, nodes.Text):
                element[place] = nodes.Text(_SPACE_BEFORE_UNIT.sub("\N{NO-BREAK SPACE}", before + child)[len(before) :])
            before = child.astext()[-1:]


def forget(app: Sphinx, env: BuildEnvironment, pages: list[str]) -> None:
    """Forget all pages that are read again before the first one is: a label may have moved from one to another."""
    for name in pages:
        app.emit("env-purge-doc", env, name)
        env.clear_doc(name)


def setup(app: Sphinx) -> ExtensionMetadata:
    """Add the directives and the role above, the checks, and the highlighting of notebook cells."""
    app.add_directive("ticks", TicksDirective)
    app.add_directive("scenes", ScenesDirective)
    app.add_directive("orders", OrdersDirective)
    app.setup_extension("rosspin.site.checks")
    app.setup_extension("rosspin.site.compiling")
    app.setup_extension("rosspin.site.lessons")
    app.add_directive("facts", FactsDirective)
    app.add_directive("literalinclude", ListingDirective, override=True)
    app.add_directive("look", LookDirective)
    app.add_directive("vehicle", VehicleDirective)
    app.add_directive("usage", UsageDirective)
    app.add_directive("names", NamesDirective)
    app.add_directive("machine", MachineDirective)
    app.add_directive("patched", PatchedDirective)
    app.add_role("fact", FactRole())
    app.add_lexer("ipython3", CellLexer)
    app.connect("env-get-outdated", moved)
    app.connect("env-before-read-docs", forget)
    app.connect("source-read", offer_download)
    app.connect("doctree-read", name_terms)
    app.connect("doctree-read", keep_units)
    app.connect("doctree-read", name_exercises)
    app.connect("doctree-read", link_by_label, priority=400)  # before Sphinx collects the headings
    app.connect("env-updated", name_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
