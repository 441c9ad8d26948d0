"""Frames and tracebacks as the author of a node wants to see them: without the frames of this package."""

from __future__ import annotations

import dis
import linecache
import os
import re
import sys
import traceback
import warnings
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from types import CodeType, FrameType, TracebackType
from typing import NamedTuple

from .installed import is_installed_file

__all__ = [
    *("Place", "Whereabouts", "as_printed", "asleep_in_loop", "called_from", "format_error", "is_installed"),
    *("is_statement", "node_frame", "node_frames"),
    *("node_place", "outer_place", "outwards", "places", "show_in", "trail", "trail_of", "warn"),
]

# This package, whose frames are not the node's.
_PACKAGE = __name__.partition(".")[0]
_HERE = os.path.dirname(__file__) + os.sep
_FOLDER = os.path.dirname(os.path.dirname(__file__)) + os.sep

# The function with which a stack begins in a web page (clocks/jspi.py).
_BASE = "_run_stack"

# The modules that start threads. In a thread's traceback their frames are above the node's.
_STARTERS = {"threading", "concurrent.futures.thread"}


def _is_ours(frame: FrameType) -> bool:
    module = frame.f_globals.get("__name__", "")
    return bool(module == _PACKAGE or module.startswith(_PACKAGE + "."))


def _starts_threads(frame: FrameType) -> bool:
    return frame.f_globals.get("__name__") in _STARTERS


def node_frame(frame: FrameType) -> FrameType:
    """The innermost frame that is the node's, from ``frame`` outwards: the line of the node that is being run."""
    return _outwards(frame, _is_ours)


def called_from(frame: FrameType) -> FrameType:
    """Like ``node_frame``, but it also skips the frames of what is installed."""
    return _outwards(frame, lambda each: _is_ours(each) or is_installed(each))


def _outwards(frame: FrameType, skipped: Callable[[FrameType], bool]) -> FrameType:
    while skipped(frame) and frame.f_back:
        frame = frame.f_back
    return frame


def is_installed(frame: FrameType) -> bool:
    """Whether a frame belongs to the standard library or to an installed package."""
    return is_installed_file(frame.f_code.co_filename)


def warn(text: str, category: type[Warning] = UserWarning) -> None:
    """Issue a warning that names the line of the node that is being run, however deep in this package it arises.

    A text comes once for each line of this package, as it does where a library issues it.
    """
    caller, frame = sys._getframe(1), node_frame(sys._getframe())
    registry = frame.f_globals.setdefault("__warningregistry__", {})
    places = registry.get("rosspin", {})
    place = frame.f_code.co_filename, frame.f_lineno
    filename, line = places.setdefault((text, category, caller.f_code, caller.f_lineno), place)
    warnings.warn_explicit(text, category, filename, line, registry=registry)
    registry["rosspin"] = places  # Python empties a registry that is new, or whose filters have changed


def show_in(kind: type, module: str) -> None:
    """Let tracebacks and texts show a class in another module. Its line stays known, which Python 3.13 then forgets."""
    line = vars(kind).get("__firstlineno__")
    kind.__module__ = module
    if line is not None:
        kind.__firstlineno__ = line  # type: ignore[attr-defined]


def node_frames(trace: TracebackType | None) -> TracebackType | None:
    """Drop from a traceback the frames of this package, and those above the node's that started its thread."""
    while trace and (_is_ours(trace.tb_frame) or _starts_threads(trace.tb_frame)):
        trace = trace.tb_next
    frames = []
    while trace:
        if not _is_ours(trace.tb_frame):
            frames.append(trace)
        trace = trace.tb_next
    kept = None
    for each in reversed(frames):
        kept = TracebackType(kept, each.tb_frame, each.tb_lasti, each.tb_lineno)
    return kept


def as_printed(error: BaseException, trace: TracebackType | None = None) -> traceback.TracebackException:
    """Describe an exception as Python prints it, with the frames of ``trace``.

    From Python 3.12 on, traceback fails where Python itself does not: at a NameError whose name is no text.
    """
    chain: dict[int, BaseException] = {}
    left: list[BaseException | None] = [error]
    while left:
        each = left.pop()
        if each is not None and id(each) not in chain:
            chain[id(each)] = each
            left += [each.__cause__, each.__context__]
    odd = [each for each in chain.values() if isinstance(each, NameError)]
    names = [(each, each.name) for each in odd if not isinstance(each.name, str | None)]
    for each, _ in names:
        each.name = None
    try:
        return traceback.TracebackException(type(error), error, trace)
    finally:
        for each, name in names:
            each.name = name


def format_error(error: BaseException, made: traceback.FrameSummary | None = None) -> str:
    """Format an exception as Python prints it, but with the node's frames only.

    If there are none, as when a callback cannot be called, show ``made``: the frame that started the thread.
    """
    printed = as_printed(error, node_frames(error.__traceback__))
    # The heading is printed even above no frames.
    printed.stack = printed.stack or traceback.StackSummary.from_list([made] if made else [])
    return "".join(printed.format())


class Place(NamedTuple):
    """A line of code that is being run. ``call`` is the text of the call in it that has not returned.

    ``function`` is the qualified name of the function around it. What is not known is empty.
    """

    filename: str
    line: int
    call: str = ""
    function: str = ""

    def shown(self) -> str:
        """The place as messages name it: the line, and the call if it is known."""
        return f"{self.filename}:{self.line}" + (f": {self.call}" if self.call else "")


class Whereabouts(NamedTuple):
    """Where a thread is: its name, its places (innermost first), and whether Python will end without waiting for it."""

    thread: str
    places: list[Place]
    daemon: bool = False


# A stack of frames, innermost first: the code of each, and the instruction and the line at which it is.
Trail = list[tuple[CodeType, int, int]]


def trail(frame: FrameType | None) -> Trail:
    """Note where a stack of frames is, in a form that stays true while the stack continues."""
    return [(each.f_code, each.f_lasti, each.f_lineno or 0) for each in outwards(frame)]


def outwards(frame: FrameType | None) -> Iterator[FrameType]:
    """Yield the frames of a stack, innermost first."""
    while frame:
        yield frame
        # In a web page another stack, a suspended one, lies below this frame: its frames cannot be looked at.
        frame = None if frame.f_code.co_name == _BASE else frame.f_back


def asleep_in_loop(trail: Trail, code: CodeType, call: int) -> bool | None:
    """Whether a stack is in the ``call`` (an instruction of ``code``), and not elsewhere in a loop around it.

    None if it has left the loop, so that it may never make the call again. A call outside of any loop counts as left.
    """
    for each, at, _ in trail:
        if each is code and any(loop.start <= min(at, call) <= max(at, call) < loop.stop for loop in _loops(code)):
            return at == call
    return None


def is_statement(frame: FrameType) -> bool:
    """Whether the call that a frame is in is a statement by itself: what it returns is dropped."""
    following = (each for each in dis.get_instructions(frame.f_code) if each.offset > frame.f_lasti)
    return next((each.opname for each in following), "") == "POP_TOP"


def _loops(code: CodeType) -> list[range]:
    """The instructions of each loop: all between a jump back and its target."""
    jumps = [each for each in dis.get_instructions(code) if each.opcode in dis.hasjrel and each.argval < each.offset]
    return [range(jump.argval, jump.offset + 1) for jump in jumps]


def trail_of(trace: TracebackType | None) -> Trail:
    """Note where an exception was raised, in the same form."""
    found: Trail = []
    while trace:
        found.insert(0, (trace.tb_frame.f_code, trace.tb_lasti, trace.tb_lineno))
        trace = trace.tb_next
    return found


def places(trail: Trail) -> list[Place]:
    """Turn a trail into places in source files, innermost first."""
    return [Place(code.co_filename, line, _call(code, at), code.co_qualname) for code, at, line in trail]


def node_place(places: Iterable[Place]) -> Place | None:
    """The first place that is neither in this package nor in what is installed."""
    own = (place for place in places if not place.filename.startswith(_FOLDER))
    return next((place for place in own if not is_installed_file(place.filename)), None)


def outer_place(places: Iterable[Place]) -> Place | None:
    """The first place that is not of the clocks: who lets them wait."""
    return next((place for place in places if not place.filename.startswith(_HERE)), None)


# The instructions with which a with statement enters its context. Python 3.13 and newer give them the place of the
# expression after ``with``, older ones the whole statement's.
_ENTERS = {"BEFORE_WITH", "BEFORE_ASYNC_WITH", "LOAD_SPECIAL"}
_WITH = re.compile(r"\s*((?:async )?with\b.*)")
_OPENS_BLOCK = re.compile(r":\s*(#.*)?$")


def _call(code: CodeType, at: int) -> str:
    """The source text of the instruction ``at``; a text of several lines is cut after the first."""
    where = next(islice(code.co_positions(), at // 2, None), (None,) * 4)
    line, end_line, column, end = where
    if line is None or column is None:
        return ""
    text = linecache.getline(code.co_filename, line).rstrip("\n")
    statement = _WITH.match(text)
    if statement and _has_entered(code, at, where):
        return statement[1] + (" ..." if line != end_line or _OPENS_BLOCK.search(text) else "")
    shown = text.encode()
    return (shown[column:end] if line == end_line else shown[column:] + b" ...").decode(errors="replace")


def _has_entered(code: CodeType, at: int, where: tuple[int | None, ...]) -> bool:
    """Whether an instruction is of a with statement itself, not of the expression at the same place."""
    places = enumerate(islice(code.co_positions(), at // 2 + 1))
    return any(place == where and dis.opname[code.co_code[2 * number]] in _ENTERS for number, place in places)
