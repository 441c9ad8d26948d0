"""Put back what a run changes in its process: :data:`SAVED` lists what is saved.

Nothing is made again for a run: its beginning notes what is there, and its end puts back what differs. To see whether
anything differs takes one look at each name, by identity; only what was changed is touched.
"""

from __future__ import annotations

import _locale
import gc
import logging
import os
import random
import sys
import threading
import time
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import contextmanager, suppress
from itertools import chain
from operator import is_
from types import ModuleType
from typing import Any, NamedTuple

from ..clocks.stacks import whose

__all__ = [
    "SAVED",
    "Saved",
    "collect_rarely",
    "one_at_a_time",
    "refuse_a_run_within_a_run",
    "state_of_names",
    "state_of_node",
    "state_of_process",
    "working_folder",
]

Put = Callable[[], None]

# Puts something back as it was noted, and returns what redoes the changes.
Undo = Callable[[], Put]

# The modules that nodes are given, under other names, and what their message classes are made of.
_STAND_INS = (
    *("rosspin.rospy", "rosspin.rclpy", "rosspin.tf2", "rosspin.filters"),
    *("rosspin.messages.genpy", "rosspin.messages.ros"),
)

# Modules of the standard library that nodes may patch and the stand-ins are built on; of some, also the classes.
_LIBRARY = ("atexit", "copy", "functools", "json", "math", "os", "signal", "subprocess", "time", "warnings")
_LIBRARY_WITH_CLASSES = ("concurrent.futures.thread", "logging", "queue", "random", "threading")

# How many objects more than at the last look bring the garbage collector: about 11 times Python's 700.
_OBJECTS = 8_000

_MISSING: Any = object()
_END = [_MISSING]  # what comes after all values


_lock = threading.RLock()


@contextmanager
def one_at_a_time() -> Iterator[None]:
    """Within this context a run may change what the whole process shares. Raises RuntimeError if a node asks."""
    refuse_a_run_within_a_run()
    with _lock:
        yield


def refuse_a_run_within_a_run() -> None:
    """Raise RuntimeError if it is a node that calls this."""
    if whose() is not None:
        raise RuntimeError("a node cannot start a run of its own")


class Saved(NamedTuple):
    """Something that is saved: ``what`` names it, and ``state()`` notes it and returns a function that puts it back.

    If it is ``found_again``, each step of a node finds it as the last one left it.
    """

    what: str
    state: Callable[[], Callable[[], object]]
    found_again: bool = True


# --- names ------------------------------------------------------------------------------------------------------------


class _Names:
    """The attributes of a module, a class or an object with a ``__dict__``. ``values`` is a live view of them."""

    def __init__(self, holder: Any) -> None:
        self._holder = holder
        self.values: Collection[Any] = vars(holder).values()

    def copy(self) -> dict[str, Any]:
        return dict(vars(self._holder))

    def put(self, noted: dict[str, Any]) -> Put:
        """Put back what was noted. Returns what redoes the changes."""
        here = self.copy()
        names = [
            name for name in here.keys() | noted.keys() if here.get(name, _MISSING) is not noted.get(name, _MISSING)
        ]
        # A module that was imported meanwhile stays where the import system has put it.
        changed = [name for name in names if name in noted or not self._is_submodule(name, here[name])]

        def put(values: dict[str, Any]) -> None:
            for name in changed:
                _set(self._holder, name, values.get(name, _MISSING))

        put(noted)
        return lambda: put(here)

    def _is_submodule(self, name: str, value: Any) -> bool:
        return isinstance(self._holder, ModuleType) and sys.modules.get(f"{self._holder.__name__}.{name}") is value


def _set(holder: Any, name: str, value: Any) -> None:
    if isinstance(holder, type):
        if value is not _MISSING:
            type.__setattr__(holder, name, value)
        elif name in vars(holder):
            type.__delattr__(holder, name)
    elif value is not _MISSING:
        vars(holder)[name] = value
    else:
        vars(holder).pop(name, None)


class _Content:
    """The content of a list, a dictionary or a set of a stand-in, with the methods of :class:`_Names`."""

    def __init__(self, holder: Any) -> None:
        self._holder = holder
        self.values: Collection[Any] = holder.values() if isinstance(holder, dict) else holder

    def copy(self) -> Any:
        return self._holder.copy()

    def put(self, noted: Any) -> Put:
        here = self.copy()

        def put(values: Any) -> None:
            self._holder.clear()
            (self._holder.extend if isinstance(self._holder, list) else self._holder.update)(values)

        put(noted)
        return lambda: put(here)


class _AllNames:
    """All that is saved of the stand-ins and the standard library, as far as their modules have been imported."""

    def __init__(self) -> None:
        self._loaded = 0  # how many modules there were when the holders were last looked for
        self._holders: dict[int, _Names | _Content] = {}  # by the identity of the object they describe
        self._views: list[Iterable[Any]] = []
        self._values: list[Any] = []  # of all holders, as last noted
        self._noted: list[Any] = []

    def state(self) -> Undo:
        """Note what there is, at little cost if nothing has changed since the last time."""
        if self._loaded != len(sys.modules):
            self._find_holders()
        if not _are_same(self._views, self._values):
            self._values = list(chain.from_iterable(self._views))
            self._noted = [holder.copy() for holder in self._holders.values()]
        views, values, noted = self._views, self._values, self._noted

        def put() -> Put:
            if _are_same(views, values):
                return _nothing
            redo = []
            for holder, each in zip(self._holders.values(), noted, strict=False):  # new holders come last
                now, then = holder.values, each.values() if isinstance(each, dict) else each
                if len(now) != len(then) or not all(map(is_, now, then)):
                    redo.append(holder.put(each))
            return lambda: _call(redo)

        return put

    def _find_holders(self) -> None:
        self._loaded = len(sys.modules)
        before = len(self._holders)
        stand_ins = [name for name in sys.modules if name.startswith(_STAND_INS)]
        for name in (*stand_ins, *_LIBRARY, *_LIBRARY_WITH_CLASSES):
            module = sys.modules.get(name)
            if isinstance(module, ModuleType) and id(module) not in self._holders:
                self._holders |= {id(holder): kept for holder, kept in _holders_in(name, module)}
        if len(self._holders) != before:
            self._views = [*(holder.values for holder in self._holders.values()), _END]


def _are_same(views: list[Iterable[Any]], values: list[Any]) -> bool:
    """Whether the views, the last of which is ``_END``, hold exactly these values."""
    return bool(values) and all(map(is_, chain.from_iterable(views), values))


def _holders_in(name: str, module: ModuleType) -> Iterator[tuple[Any, _Names | _Content]]:
    """Yield a module, the classes that it defines and, of a stand-in, also its objects and containers."""
    yield module, _Names(module)
    if name in _LIBRARY:
        return
    classes = [each for each in vars(module).values() if isinstance(each, type) and _can_change(each)]
    if name in _LIBRARY_WITH_CLASSES:
        yield from ((each, _Names(each)) for each in classes if each.__module__ == name)
        return
    homes = ("rosspin.", "rospy", "rclpy", "genpy")
    own = [each for each in classes if each.__module__.startswith(homes)]
    yield from ((each, _Names(each)) for each in own)
    holders: list[Any] = [module, *own]
    for holder in holders:
        for key, value in dict(vars(holder)).items():
            if type(value) in (list, dict, set) and key not in _OF_PYTHON:
                yield value, _Content(value)
            elif type(value).__module__.startswith(homes) and hasattr(value, "__dict__"):
                yield value, _Names(value)


# Containers that Python itself fills, in a module or an enumeration.
_OF_PYTHON = {"__builtins__", "__warningregistry__", "_member_map_", "_value2member_map_", "_member_names_"}


def _can_change(kind: type) -> bool:
    return bool(kind.__flags__ & 1 << 9)  # Py_TPFLAGS_HEAPTYPE


_names = _AllNames()


def _call(functions: Iterable[Callable[[], object]]) -> None:
    for function in functions:
        function()


def _nothing() -> None:
    pass


# --- the process ------------------------------------------------------------------------------------------------------


def _command_line() -> Put:
    argv = sys.argv
    hooks = sys.excepthook, sys.unraisablehook, threading.excepthook

    def put() -> None:
        sys.argv = argv
        sys.excepthook, sys.unraisablehook, threading.excepthook = hooks

    return put


def _modules() -> Put:
    """Leave new modules for the next run, which finds them quickly, but remove those that were put there by hand."""
    before = dict(sys.modules)
    modules = sys.modules

    def put() -> None:
        sys.modules = modules
        if modules != before:
            roots = {name.partition(".")[0] for name in before}
            for name in modules.keys() - before.keys():
                if name.partition(".")[0] not in roots and getattr(modules[name], "__spec__", None) is None:
                    del modules[name]
            modules.update(before)

    return put


def _names_in_sys() -> Undo:
    """Saved apart from all other names, because the streams differ from run to run."""
    names = _Names(sys)
    before = names.copy()
    return lambda: names.put(before)


def _lists_of_sys() -> Put:
    lists: list[list[Any]] = [sys.path, sys.meta_path, sys.path_hooks]
    kept = [(each, each[:]) for each in lists]

    def put() -> None:
        for each, before in kept:
            each[:] = before

    return put


def _hooks() -> Put:
    trace, profile = sys.gettrace(), sys.getprofile()

    def put() -> None:
        if sys.gettrace() is not trace:
            sys.settrace(trace)
        if sys.getprofile() is not profile:
            if profile is None or callable(profile):
                sys.setprofile(profile)
            else:  # cProfile's, written in C
                profile.enable()

    return put


def _limits() -> Put:
    interval, depth = sys.getswitchinterval(), sys.getrecursionlimit()
    digits = sys.get_int_max_str_digits()

    def put() -> None:
        if sys.getswitchinterval() != interval:
            sys.setswitchinterval(interval)
        if sys.getrecursionlimit() != depth:
            sys.setrecursionlimit(depth)
        if sys.get_int_max_str_digits() != digits:
            sys.set_int_max_str_digits(digits)

    return put


def _collector() -> Put:
    enabled, threshold, debug, callbacks = gc.isenabled(), gc.get_threshold(), gc.get_debug(), gc.callbacks[:]

    def put() -> None:
        (gc.enable if enabled else gc.disable)()
        if gc.get_threshold() != threshold:
            gc.set_threshold(*threshold)
        gc.set_debug(debug)
        gc.callbacks[:] = callbacks

    return put


def collect_rarely() -> None:
    """Let Python collect garbage less often, and at the same moments of a run whatever was there before it.

    A node that refers to itself is gone when that is collected. To make one, rclpy makes so many objects that the node
    is past the first collection, and the next one of objects as old comes after 11 times as many. Here, making it takes
    fewer objects, and what comes later takes more.
    """
    if gc.isenabled():
        gc.collect(0)
        gc.set_threshold(_OBJECTS, *gc.get_threshold()[1:])


def _environment() -> Put:
    environ: Any = os.environ
    data = environ._data  # decoding all of it would take time
    before = data.copy()

    def put() -> None:
        os.environ, environ._data = environ, data
        if data != before:
            zone = environ.get("TZ")
            for name in data.keys() - before.keys():
                del environ[environ.decodekey(name)]
            for name, value in before.items():
                if data.get(name) != value:
                    environ[environ.decodekey(name)] = environ.decodevalue(value)
            if environ.get("TZ") != zone and hasattr(time, "tzset"):
                time.tzset()

    return put


def _folder() -> Put:
    folder = working_folder()

    def put() -> None:
        if folder and folder != working_folder():
            with suppress(OSError):  # it is gone
                os.chdir(folder)

    return put


def working_folder() -> str | None:
    """Return the working directory; None if it was removed."""
    try:
        return os.getcwd()
    except FileNotFoundError:
        return None


def _mask() -> Put:
    mask = os.umask(0o022)
    os.umask(mask)

    def put() -> None:
        os.umask(mask)

    return put


def _warnings() -> Put:
    warnings: Any = sys.modules["warnings"]
    filters, before = warnings.filters, warnings.filters[:]

    def put() -> None:
        if warnings.filters is not filters or filters != before:
            warnings.filters = filters
            filters[:] = before
            warnings._filters_mutated()

    return put


def _random() -> Put:
    """Let a run draw the numbers that its caller would draw next, and the caller draw them again."""
    generator = random._inst
    before = generator.getstate()
    return lambda: generator.setstate(before)


def _decimals() -> Put:
    """Keep the calling thread's context of decimal arithmetic; a simulated thread has its own."""
    decimal = sys.modules.get("decimal")
    if decimal is None:
        return _nothing
    context = decimal.getcontext().copy()
    return lambda: decimal.setcontext(context)


def _locales() -> Put:
    before = _locale.setlocale(_locale.LC_ALL, None)

    def put() -> None:
        if _locale.setlocale(_locale.LC_ALL, None) != before:
            _locale.setlocale(_locale.LC_ALL, before)

    return put


def _sockets() -> Put:
    timeout = _socket_timeout()

    def put() -> None:
        if _socket_timeout() != timeout:
            sys.modules["socket"].setdefaulttimeout(timeout)

    return put


def _socket_timeout() -> float | None:
    socket = sys.modules.get("socket")
    timeout: float | None = socket.getdefaulttimeout() if socket else None
    return timeout


def _threads() -> Put:
    size = threading.stack_size()

    def put() -> None:
        if threading.stack_size() != size:
            threading.stack_size(size)

    return put


def _loggers() -> Put:
    loggers = dict(logging.root.manager.loggerDict)
    known = [logging.root, *(logger for logger in loggers.values() if isinstance(logger, logging.Logger))]
    states = [(logger, logger.level, logger.handlers[:], logger.filters[:], logger.propagate) for logger in known]
    off = logging.root.manager.disable

    def put() -> None:
        logging.root.manager.loggerDict.clear()
        logging.root.manager.loggerDict.update(loggers)
        if logging.root.manager.disable != off:
            logging.disable(off)
        for logger, level, handlers, filters, propagate in states:
            if logger.level != level:  # setting it is slow
                logger.setLevel(level)
            logger.handlers[:], logger.filters[:], logger.propagate = handlers, filters, propagate

    return put


# These are put back in this order, and then the names in rospy, rclpy, the message classes and the standard library's
# modules. Others see to the rest: clocks/programs.py to signal handlers and to the names in builtins, process.py to
# what is registered with atexit, which it calls at the end of the run, and messages/finder.py to message classes, which
# each run makes again.
SAVED: tuple[Saved, ...] = (
    Saved("command line, excepthooks", _command_line),
    Saved("sys.modules", _modules, found_again=False),
    Saved("names in sys, such as its streams", _names_in_sys, found_again=False),
    Saved("sys.path, sys.meta_path, sys.path_hooks", _lists_of_sys),
    Saved("trace and profile functions", _hooks),
    Saved("switch interval, recursion limit, digits of an int", _limits),
    Saved("garbage collector", _collector),
    Saved("environment and time zone", _environment),
    Saved("working directory", _folder),
    Saved("file mode mask", _mask),
    Saved("warning filters", _warnings),
    Saved("random numbers", _random),
    Saved("context of decimal arithmetic", _decimals),
    Saved("locale", _locales),
    Saved("default timeout of sockets", _sockets),
    Saved("stack size of threads", _threads),
    Saved("loggers", _loggers),
)


def state_of_process() -> Undo:
    """Note all that is saved. Returns a function that puts it back, and that returns one to restore the run's names."""
    puts, put_names = [each.state() for each in SAVED], _names.state()

    def put() -> Put:
        _call(puts)
        return put_names()

    return put


def state_of_names() -> Undo:
    """Note names alone, for modules that were imported only after the state of the process was noted."""
    return _names.state()


def state_of_node() -> Put:
    """Note what the next step of a node should find again, except for names. Returns what puts it in place."""
    puts = [each.state() for each in SAVED if each.found_again]
    return lambda: _call(puts)
