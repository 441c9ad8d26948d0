"""Run a node in a web page: in simulated time that keeps pace with real time, in the page's own Python (Pyodide).

``web/src/worker.js`` calls :func:`run`, :func:`trace`, :func:`judge`, :func:`look` and :func:`pin`, and on the page for
teachers :func:`read`, :func:`answer` and :func:`report`. Nothing here is needed, or can run, outside of a browser.
"""

from __future__ import annotations

import errno
import gc
import io
import logging
import os
import random
import re
import shlex
import signal
import sys
import threading
import time
import zipimport
from collections import defaultdict, deque
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, chdir, contextmanager, redirect_stderr, redirect_stdout, suppress
from functools import cache, partial, wraps
from itertools import islice
from json import dumps, loads
from pathlib import Path
from traceback import walk_tb
from typing import TYPE_CHECKING, Any

from js import performance
from pyodide.ffi import JsException, can_run_sync, run_sync

from . import exercises
from .clocks.clock import NS
from .clocks.frames import trail
from .clocks.patches import patched
from .clocks.simulation import PacedSimulation, Simulation
from .clocks.stacks import whose
from .exercises.advice import advice, lacking
from .measures import by_source, describe_timeline, lost_by_source, quantile
from .results.pinned import as_test
from .results.ticks import Tick
from .run.alone import ON_A_COMPUTER, refuse_processes
from .run.beside import run_beside
from .run.explain import TimeStandsStill, say_error, say_uncalled
from .run.host import Result
from .run.kinds import ROS, Ros, language_of
from .run.kinds.cpp import Cpp
from .run.noted_steps import NotedSteps
from .run.roslaunch.launch import Launch
from .run.roslaunch.launch import Node as LaunchNode
from .run.simulate import run_node, run_nodes, several
from .run.source import Code, code_of_program, load_source, split_words
from .vehicle import VEHICLES
from .vehicle.drawn import drawn
from .vehicle.drives import NODE, Drive
from .world.graph import TickLog, unpacked
from .world.world import NotSimulated, World

if TYPE_CHECKING:
    from .hand_ins.on_page import Table
    from .look import Look
    from .programs import Batch, Program

__all__ = ["answer", "judge", "look", "pin", "read", "report", "run", "trace", "wake"]

# The page interrupts code that does not give way, so that a run's watchdog can look at it. Outside of runs, ignore it.
signal.signal(signal.SIGINT, signal.SIG_IGN)

# An automatic collection walks the frames of suspended stacks. In a page their memory is reused, so it breaks Python
# (Pyodide's issue 6464). A full collection does not: it comes after each run, and leaves out what exists by now.
gc.disable()
gc.freeze()

# An argument that sets something in a node: an option of ROS 2, or a parameter or name as ROS 1 has them.
_FOR_ROS = re.compile(r"-p$|--param$|-r$|--remap$|_\w+:=")

# How many ticks, the last ones, a plot shows at most.
_MOST_TICKS = 2000

# What a page takes: see web/src/protocol.js. So long (characters) are names, sentences and larger texts, and the scenes
# of a run, with so many of anything; times (s) go as far as 64 bits count nanoseconds.
_NAME, _SENTENCE, _TEXT, _SCENES = 200, 500, 1_000_000, 250_000
_MOST = 100
_MOST_RINGS = 20
_FAR = 2**63 / NS

# How those lines of both ROSes begin that a reader may want to trace.
_SERIOUS = ("[WARN]", "[ERROR]", "[FATAL]")

# How many chunks of what a tick prints are remembered, and how many of the last in all; the page's console holds no
# more lines.
_MOST_CHUNKS = 1000
_LAST_CHUNKS = 10_000

# Of a log the page shows so many series, and draws so many entries, and as many times at which one is missing.
_MOST_SERIES = 50
_MOST_ENTRIES = 60_000


# How the sources of the ticks begin of which a page shows nothing.
_OF_VEHICLE = f"{NODE} "

# A page has no processes.
refuse_processes()


def wake(supply: Callable[[str], Any]) -> None:
    """Wake Python after its start, maybe from a memory snapshot: its random numbers differ again from other starts'.

    ``supply(path)`` is called before Python imports from the file at ``path``. It returns a promise that is kept when
    the file is there, or None if the file is there already or is none of the page's.
    """
    zipimport._io = _Supplied(supply)  # type: ignore[attr-defined]  # all that it needs of io is open_code
    random.seed()
    logging._startTime = time.time_ns()  # type: ignore[attr-defined]


class _Supplied:
    def __init__(self, supply: Callable[[str], Any]) -> None:
        self._supply = supply

    def open_code(self, path: str) -> Any:
        if can_run_sync() and (coming := self._supply(path)):
            run_sync(coming)
        return io.open_code(path)


def run(source: str, filename: str, seconds: float, args: str, speed: float, beside: str, files: str, page: Any) -> str:
    """Run the node in the text ``source`` for ``seconds``, ``speed`` times as fast as real time (0: without waiting).

    ``args`` are its command line, split into words as a shell does. A text that begins with ``%%simulate SECONDS --
    ARGS`` brings its own. ``beside`` lists, as JSON, the texts, file names and arguments of other nodes that run
    together with it. A node whose file is one in C++ has been compiled: ``page.program(name)`` returns its program, as
    ``cpp/js/beside.mjs`` makes it. If there are ``files``, texts by their paths, as JSON, the text is a launch file's
    among them.

    ``page`` is a JavaScript object. Its ``print(text, isError, line)`` is called with what the node prints, and with
    the line that logged it if that is a warning or worse, else 0; its ``tick(source, number, expected, real)`` is
    called with each tick that begins (s). ``wait(ms)`` returns a promise that is kept after that time. The result, as
    JSON: the exit ``status``, the number of ``errors`` in its threads, the last ``ticks`` with their durations, their
    ``count``, the ``lost`` ones, each with its source and when it was due (s), the ``chunks`` that each tick printed (a
    call of ``print`` is one, counted from 0; the last ones only), the ``end`` of the run (s) and a text ``alternative``
    to their plot; the ``scenes`` of the nodes, or after ``%%drive SECONDS -- ARGS`` the ``drive`` of the vehicle that
    ran together with the node, as :func:`rosspin.vehicle.drawn.drawn` has it. Errors are printed and give status 1.
    """
    printed = _Printed()
    streams = [_Stream(page, is_error, printed, filename) for is_error in (False, True)]
    with _left_as_found(), redirect_stdout(streams[0]), redirect_stderr(streams[1]):
        try:
            if launched := loads(files):
                pacer = _Pacer(page, speed, printed, "", ROS[1], several=True)
                words = _split(args, "arguments")
                return dumps(_launch(source, filename, seconds, words, launched, page, pacer, printed))
            if source.startswith("%%"):
                seconds, node_args = _magic(source)
            else:
                node_args = _split(args, "arguments")
            others = [(_load(text, name, page), _split(words, "arguments")) for text, name, words in loads(beside)]
            node = _load(exercises.code(source), filename, page)
            drives = source.startswith("%%drive ")
            seen = "" if drives or node.source is None else filename
            pacer = _Pacer(page, speed, printed, seen, ROS[node.hint or 1], len(others) > 0)
            if drives:
                return dumps(_drive(node, seconds, node_args, pacer, printed))
            return dumps(_run(node, seconds, node_args, others, pacer, printed))
        except (ValueError, SyntaxError, NotSimulated, TimeStandsStill) as error:
            print(say_error(error), file=sys.stderr)
            if isinstance(error, SyntaxError):
                print("Python could not read this line, so nothing ran.", file=sys.stderr)
            if isinstance(error, NotSimulated) and not language_of(filename):
                ros = load_source(exercises.code(source), filename).hint or 1
                with_ros, option = ("", "") if error.where == ON_A_COMPUTER else (f" with ROS {ros}", f" --ros{ros}")
                print(f"On a computer{with_ros}, run: python -m rosspin run{option} FILE", file=sys.stderr)
            return dumps({"status": 1})


def _load(source: str, filename: str, page: Any) -> Code:
    return code_of_program(_program(source, filename, page)) if language_of(filename) else load_source(source, filename)


def _program(source: str, filename: str, page: Any) -> Program:
    from .programs import Program  # most runs go without

    begin = partial(_Child, page, os.path.basename(filename))
    return Program(2 if "rclcpp/" in source else 1, filename, begin)


def _compiled_by(page: Any) -> AbstractContextManager[None]:
    """Within this context, what is a node in C++ has been compiled by a page."""

    def program(cpp: Cpp, path: str, waiting: object, text: str = "", closed: bool = False) -> Program:
        return _program(text or Path(path).read_text(encoding="utf-8"), path, page)

    return patched([(Cpp, "program", lambda real: program)])


class _Child:
    """A node in C++ that runs in this page."""

    def __init__(self, page: Any, name: str, world: World, clock: Simulation) -> None:
        self._program = page.program(name)
        self._clock = clock

    def go_on(self, message: Mapping[str, Any]) -> Iterator[Batch]:
        # It never runs on its own: what it does is shown when it does it.
        request = {**message, "horizon": message.get("now")}
        for batch in run_sync(self._program.goOn(dumps(request))):
            self._clock.beside += 1
            ticks = batch.ticks
            yield loads(batch.text) | ({"ticks": ticks.to_bytes()} if ticks else {})

    def end(self, by_itself: bool) -> None:
        pass  # it ends with the page's Python


def trace(exercise: str, text: str, page: Any) -> str:
    """Run the answer ``text`` to an ``exercise``, given by its name, and write down what it did.

    ``page.program(name)`` returns the program of one in C++, as in :func:`run`.

    Returns the trace for :func:`judge` in another Python: JSON of little more than 2 MB at most, empty if there is no
    such exercise.
    """
    with _left_as_found(), _compiled_by(page):
        try:
            return exercises.trace(exercise, exercises.code(text))
        except ValueError:
            return ""


def judge(exercise: str, text: str, trace: str) -> str:
    """Judge an answer by its trace, in a Python that has run no one's code; nothing of the answer is run here.

    The result is a :class:`rosspin.exercises.Verdict` as JSON, with the ``drive`` of its first run.
    """
    with _left_as_found():
        verdict = exercises.verdict(exercise, exercises.code(text), trace)
        return dumps(verdict._asdict() | {"drive": exercises.drawing(exercise, trace)})


def pin(source: str, filename: str, seconds: float, args: str, console: str, ticks: str) -> str:
    """Write a test that pins what a run showed: its ``console``, and its ``ticks`` as JSON, as :func:`run` has them.

    The rest are the arguments of that run. Nothing of it is run here.
    """
    words: Sequence[str] = ()
    if source.startswith("%%"):
        seconds, words = _magic(source)
    else:
        words = _split(args, "arguments")
    shown = [Tick(name, number, *map(float, times)) for name, number, *times in loads(ticks)]
    return as_test(exercises.code(source), filename, seconds, words, console, shown)


@cache
def _table() -> Table:
    from .hand_ins.on_page import Table  # which only one page needs

    return Table()


def read(paths: str, files: Any) -> str:
    """Read what students handed in: ``paths`` as JSON, and of each a file, as worker.js has it. None of it is run.

    The result, as JSON, is what :meth:`rosspin.hand_ins.on_page.Table.read` returns, of these and all earlier files.
    """
    return dumps(_table().read((path, io.BufferedReader(_Blob(file))) for path, file in zip(loads(paths), files)))


def answer(number: int, exercise: str) -> str:
    """Return, as JSON, an answer that was read: see :meth:`rosspin.hand_ins.on_page.Table.answer`."""
    return dumps(_table().answer(number, exercise))


def report(verdicts: str) -> str:
    """Tell, as JSON, what came of all that was read: see :meth:`rosspin.hand_ins.on_page.Table.report`."""
    return dumps(_table().report(loads(verdicts)))


class _Blob(io.RawIOBase):
    """A file that the browser has, of which only what is read comes into memory."""

    def __init__(self, file: Any) -> None:
        self._file = file
        self._at = 0

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def tell(self) -> int:
        return self._at

    def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
        start = {os.SEEK_SET: 0, os.SEEK_CUR: self._at, os.SEEK_END: self._file.size}[whence]
        if start + offset < 0:
            raise OSError(errno.EINVAL, "before its start")
        self._at = start + offset
        return self._at

    def readinto(self, buffer: Any) -> int:
        try:
            data = self._file.read(self._at, self._at + len(buffer)).to_bytes()
        except JsException:
            raise OSError(errno.EIO, "the browser does not give it") from None
        buffer[: len(data)] = data
        self._at += len(data)
        return len(data)


def look(log: Any, name: str) -> str:
    """Look at a log, of which ``log`` is a buffer of JavaScript and ``name`` is the file's name; nothing in it is run.

    The result, as JSON: the ``problem``, in words, if nothing can be made of it. Else what :class:`~rosspin.look.Look`
    has, times in seconds from the first entry: ``kind``, ``entries``, ``seconds``, ``notes``, ``verdicts`` and
    ``series``, each with its ``times``, of regular ones how ``late`` they were, and when one is ``missing``; and as
    ``files``, by name and text, a node and a test with the periods found.
    """
    from .look import NoLog  # which only one page needs
    from .look import look as look_at

    try:
        return dumps(_looked(look_at(log.to_bytes(), name)), allow_nan=False)
    except NoLog as error:
        return dumps({"problem": _shortened(str(error))})
    except Exception as error:  # a log may be made of anything
        said = f"rosspin itself failed at this log, which is a fault of rosspin: {type(error).__name__}: {error}"
        return dumps({"problem": _shortened(said)})


def _looked(shown: Look) -> dict[str, Any]:
    from .look.pinning import as_files
    from .look.series import FEWEST

    if shown.seconds > _FAR:
        years = shown.seconds / 31_557_600
        return {"problem": f"its times are {years:.3g} years apart, which no clock of ROS can say"}
    made = shown.as_dict()
    left = lacking = _MOST_ENTRIES
    rows = []
    for series in [series for series in made["series"] if series["count"] >= FEWEST][:_MOST_SERIES]:
        row: dict[str, Any] = {name: series[name] or 0 for name in ("part", "count", "period", "chosen", "drift")}
        row["name"] = _name(series["name"])
        for name, most in (("times", left), ("late", left), ("missing", lacking)):
            row[name] = [round(time, 6) for time in series[name][:most]]
        left, lacking = left - len(row["times"]), lacking - len(row["missing"])
        sizes = [abs(late) for late in series["late"]]
        rows.append(row | {"usual": quantile(sizes, 0.98) if sizes else 0, "lost": len(series["missing"])})
    faults = [
        _shortened({name: verdict[name] for name in ("title", "certain", "page")})
        | {"evidence": _shortened(verdict["evidence"][:_MOST]), "series": [*map(_name, verdict["series"][:_MOST])]}
        for verdict in made["verdicts"][:_MOST]
    ]
    about = {name: made[name] for name in ("kind", "entries", "seconds")} | {"notes": _shortened(made["notes"][:_MOST])}
    files = [[name, text] for name, text in as_files(shown).items() if len(text) <= _TEXT]
    return {"problem": "", **about, "verdicts": faults, "series": rows, "files": files}


@contextmanager
def _left_as_found() -> Iterator[None]:
    """Within this context a run may do as it likes: the next one in this page finds what this one found."""
    environment = dict(os.environ)
    try:
        yield
    finally:
        os.environ.clear()
        os.environ.update(environment)
        gc.collect()


def _magic(source: str) -> tuple[float, Sequence[str]]:
    """The number after the cell magic in the first line, and the words after ``--``."""
    first = source.partition("\n")[0]
    words, args = split_words(_split(first[2:], first))
    with suppress(ValueError):
        magic, seconds, *_ = words
        if magic in ("simulate", "drive"):
            return float(seconds), args
    raise ValueError(f"{first}: the first line can be %%simulate SECONDS here, or %%drive SECONDS")


def _split(text: str, name: str) -> list[str]:
    try:
        return shlex.split(text)
    except ValueError as error:
        raise ValueError(f"{name}: {str(error)[0].lower()}{str(error)[1:]}") from None


def _run(
    node: Code,
    seconds: float,
    args: Sequence[str],
    others: Sequence[tuple[Code, Sequence[str]]],
    pacer: _Pacer,
    printed: _Printed,
) -> dict[str, Any]:
    with patched((ros.rate, "__init__", printed.forget_before) for ros in ROS.values()):
        if others:
            nodes = [(node, args), *others]
            launch = Launch([LaunchNode(each.filename, words) for each, words in nodes])
            result = run_nodes(launch, seconds, pacer.simulation, printed, [each for each, _ in nodes])
        else:
            result = run_node(node, seconds, args, pacer.simulation, printed)
    return _shown(result, seconds, args, pacer, printed)


def _drive(node: Code, seconds: float, args: Sequence[str], pacer: _Pacer, printed: _Printed) -> dict[str, Any]:
    """Run a node together with a vehicle. What is shown is the node's, and the vehicle's drive."""
    result = run_beside(node, args, [VEHICLES[node.hint or 2]], seconds, pacer.simulation, printed)
    own = [place for place, tick in enumerate(result.ticks) if not tick.source.startswith(_OF_VEHICLE)]
    result.ticks = ticks = tuple(result.ticks[place] for place in own)
    printed.chunks = [printed.chunks[place] for place in own]
    end = min(pacer.simulation.seconds(), seconds)
    drive = drawn(Drive.of(result.messages()), [tick.real for tick in ticks], end)
    return _shown(result, seconds, args, pacer, printed) | {"drive": drive}


def _launch(
    source: str,
    filename: str,
    seconds: float,
    args: Sequence[str],
    files: dict[str, str],
    page: Any,
    pacer: _Pacer,
    printed: _Printed,
) -> dict[str, Any]:
    from .results.folders import TemporaryFolder  # likewise

    with TemporaryFolder() as folder, chdir(folder.path), _compiled_by(page):
        for name, text in {**files, filename: source}.items():
            path = Path(name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        launched = several(filename, args)
        assert launched
        return _shown(run_nodes(launched, seconds, pacer.simulation, printed), seconds, args, pacer, printed)


def _shown(result: Result, seconds: float, args: Sequence[str], pacer: _Pacer, printed: _Printed) -> dict[str, Any]:
    errors = [error for process in result.host.processes for error in process.world.errors]
    hints = [_hint(error) for error in errors]
    ended_early = pacer.simulation.now() < seconds * NS
    first = next(iter(result.host.processes), None)  # a launch file may start none
    ros = ROS.get(first.world.ros) if first else None
    hints += say_uncalled(result.host.processes, ended_early)
    if ros and ros.flag and ros.flag not in args and any(_FOR_ROS.match(word) for word in args):
        like = " ".join(ros.settings("-p", ["frequency:=5.0"]))
        hints.append(f"In ROS {ros.number}, what is for ROS follows {ros.flag}, as in: {like}")
    hints = [*dict.fromkeys(filter(None, hints))]
    for hint in hints:
        print(hint, file=sys.stderr)
    groups = by_source(result.ticks)
    recording = result.host.recording
    lost = lost_by_source(result.ticks, recording.periods(), recording.coming())
    shown = result.ticks[-_MOST_TICKS:]
    since = 0.0 if len(shown) == len(result.ticks) else min(tick.expected for tick in shown)
    return {
        "status": result.status,
        "errors": len(errors),
        "count": len(result.ticks),
        "hints": len(hints),
        "ticks": [[_name(tick.source), *tick[1:4], tick.duration if tick.duration >= 0 else 0] for tick in shown],
        "lost": [[_name(source), round(time, 6)] for source, times in lost.items() for time in times if time >= since][
            -_MOST_TICKS:
        ],
        "chunks": [
            [number for number in chunks if number >= printed.count - _LAST_CHUNKS]
            for chunks in printed.chunks[-_MOST_TICKS:]
        ],
        "end": min(pacer.simulation.seconds(), seconds),
        "alternative": " ".join(
            describe_timeline(source, group) + (f" Lost ticks: {len(lost[source])}." if source in lost else "")
            for source, group in islice(groups.items(), _MOST)
        )[:_TEXT],
        "scenes": _drawable(pacer.scenes.data(result.status) if pacer.scenes else None),
        "drive": [],
    }


def _name(text: str) -> str:
    return text if len(text) <= _NAME else f"{text[: _NAME - 1]}…"


def _shortened(value: Any) -> Any:
    """Return something with its texts cut to the length of a sentence."""
    if isinstance(value, str):
        return value if len(value) <= _SENTENCE else f"{value[: _SENTENCE - 1]}…"
    if isinstance(value, dict):
        return {name: _shortened(part) for name, part in value.items()}
    return [_shortened(part) for part in value] if isinstance(value, (list, tuple)) else value


def _drawable(scenes: dict[str, Any] | None) -> dict[str, Any] | None:
    """Return the scenes of a run as a page can show them; None if there is more in them than that."""
    if scenes is None:
        return None
    made = _shortened(scenes | {"rings": scenes["rings"][:_MOST_RINGS]})
    lists = [made["threads"], made["groups"], made["callbacks"], *(ring["links"] for ring in made["rings"])]
    return made if max(map(len, lists)) <= _MOST and len(dumps(made)) <= _SCENES else None


class _Printed(TickLog):
    """The ticks of a run, and what was printed during each: the numbers of its ``chunks``, in all ``count``."""

    def __init__(self) -> None:
        super().__init__()
        self.chunks: list[deque[int]] = []
        self.count = 0
        self._last: dict[int, int] = {}  # of each thread, its last tick
        self._since: defaultdict[int, deque[tuple[int, int]]] = defaultdict(_deque)  # its chunks since, and when (ns)

    def add(self, source: str, number: int, expected: int, real: int, duration: int | None = None) -> int:
        thread = threading.get_ident()
        # The pass of a loop is recorded at its end, the call of a timer when it begins.
        passed = duration is not None
        since = self._since.pop(thread, ())
        self.chunks.append(_deque(number for number, when in since if passed and when >= real))
        self._last[thread] = place = super().add(source, number, expected, real, duration)
        return place

    def extend(self, data: bytes, names: Sequence[str]) -> int:
        place = len(self)
        for tick in zip(*unpacked((data, names)), strict=True):
            self.add(*tick)
        return place

    def forget_before(self, make: Callable[..., None]) -> Callable[..., None]:
        """Wrap ``Rate.__init__`` of either ROS: what its thread has printed before belongs to no pass of its loop."""

        @wraps(make)
        def make_after(*args: Any, **kwargs: Any) -> None:
            self._since.pop(threading.get_ident(), None)
            make(*args, **kwargs)

        return make_after

    def note(self) -> None:
        """Note that a chunk is printed."""
        world, thread = whose(), threading.get_ident()
        last = self._last.get(thread)
        if last is not None and self.is_running(last):
            self.chunks[last].append(self.count)
        elif isinstance(world, World):
            self._since[thread].append((self.count, world.clock.now()))
        self.count += 1


def _deque(items: Iterable[Any] = ()) -> deque[Any]:
    return deque(items, _MOST_CHUNKS)


class _Pacer:
    """Makes a simulation keep pace with the page's clock, and shows the page each tick as it begins.

    Of the node in the file ``filename``, if one is given, it keeps the steps, together with the steps of ``several``.
    """

    def __init__(self, page: Any, speed: float, ticks: TickLog, filename: str, ros: Ros, several: bool) -> None:
        self.scenes: NotedSteps | None = None
        if filename:
            self.scenes = ros.noted_steps(ticks, filename, *([self._wait] if speed else []), several=several)
        paced = self.scenes.clock if self.scenes else PacedSimulation(self._wait) if speed else None
        self.simulation: Simulation = paced or Simulation()
        self._page = page
        self._speed = speed
        self._ticks = ticks
        self._start = performance.now()
        self._shown = 0

    def _wait(self, when: int) -> None:
        self._show_ticks()
        ahead = self._start + when / NS * 1e3 / self._speed - performance.now()
        if ahead > 0:
            run_sync(self._page.wait(ahead))

    def _show_ticks(self) -> None:
        for source, number, expected, real, _ in zip(*self._ticks.columns(self._shown)):
            if not source.startswith(_OF_VEHICLE):
                self._page.tick(_name(source), number, expected / NS, real / NS)
            self._shown += 1


class _Stream(io.TextIOBase):
    encoding = "utf-8"

    def __init__(self, page: Any, is_error: bool, printed: _Printed, filename: str) -> None:
        self._page = page
        self._is_error = is_error
        self._printed = printed
        self._filename = filename

    def write(self, text: str) -> int:
        self._printed.note()
        self._page.print(text, self._is_error, self._line() if text.startswith(_SERIOUS) else 0)
        return len(text)

    def _line(self) -> int:
        """The line of the node that is being run; 0 if there is none."""
        return next((line for code, _, line in trail(sys._getframe(2)) if code.co_filename == self._filename), 0)


def _hint(error: BaseException) -> str:
    if isinstance(error, ModuleNotFoundError):
        return f"{lacking(error)} Run the node on your own computer: python -m rosspin run FILE"
    if isinstance(error, OSError) and error.errno == errno.EIO and str(error.filename).endswith(".zip"):
        return "A part of Python could not be loaded from this site. Is its server still there?"
    if isinstance(error, KeyboardInterrupt) and _is_of_a_rate_that_nobody_wakes(error):
        return (
            "The timer that wakes this Rate was due, but nothing called it: while this thread sleeps, another one has "
            "to spin the node."
        )
    return advice(error)


def _is_of_a_rate_that_nobody_wakes(error: KeyboardInterrupt) -> bool:
    sleep = ROS[2].rate.sleep
    for frame, _ in walk_tb(error.__traceback__):
        if frame.f_code is sleep.__code__:
            timer = frame.f_locals["self"]._timer
            return bool(timer._rosspin_time_left() < -timer.timer_period_ns)
    return False
