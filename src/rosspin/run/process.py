"""A process as its node sees it: command line, modules, environment, streams, folder; how it begins and how it ends."""

from __future__ import annotations

import atexit
import logging
import os
import signal
import sys
import threading
import traceback
import warnings
from collections.abc import Callable, Mapping, Sequence
from operator import attrgetter
from types import FrameType, FunctionType, ModuleType
from typing import Any, TextIO

try:
    import _posixsubprocess
except ImportError:  # a web page has no processes
    _posixsubprocess = None  # type: ignore[assignment]

from ..clocks.ending import Ended, heed
from ..clocks.frames import format_error, is_installed
from ..clocks.installed import is_installed_file, note_own
from ..clocks.patches import Patch
from ..clocks.programs import end_program, end_run
from ..clocks.signals import Died
from ..clocks.simulation import Simulation
from ..clocks.stacks import StackExit, acting_for, whose
from ..clocks.threads import begin_main, end_main
from ..world.world import NotSimulated, World, not_simulated
from .imports import Imports
from .kinds import ROS
from .saved_state import working_folder
from .source import Code, around_package, is_own, neighbour, own_folders

__all__ = ["PATCHES", "Process", "Slots", "leave", "starter"]

# What the module sys keeps once for a process, and each node has for itself.
_OF_SYS = ("argv", "path", "meta_path", "excepthook", "unraisablehook", "stdin", "stdout", "stderr")
_of_sys = attrgetter(*_OF_SYS)

# Where what the stand-ins define says that it is from.
_STAND_INS = ("rosspin.rospy", "rosspin.rclpy", "rosspin.tf2")

# Taken now, because nodes may put something else in its place.
_environ: Any = os.environ


class Slots:
    """What one of several processes has for itself, to be put in place whenever it continues."""

    def __init__(self) -> None:
        """Begin with what this process has now."""
        self.folder = working_folder()
        self.modules: dict[str, ModuleType] = {}  # those that only it has
        self.keep()

    def keep(self) -> None:
        """Keep what is in place now. This and ``put_in_place`` run at each change of process, and must be quick."""
        self.of_sys = _of_sys(sys)
        self.environment: dict[bytes, bytes] = _environ._data
        self.filters = warnings.filters
        self.root_logger = logging.root.__dict__
        self.loggers = logging.root.manager.loggerDict

    def put_in_place(self) -> None:
        """Put in place what was kept.

        The environment and the root logger keep their identity, which other code refers to, and change their contents
        as a whole. No thread of the run sees that halfway: only one of them continues at a time. One of the caller's
        that logs meanwhile is given what the node has, as with ``sys.stdout``.
        """
        (
            sys.argv,
            sys.path,
            sys.meta_path,
            sys.excepthook,
            sys.unraisablehook,
            sys.stdin,
            sys.stdout,
            sys.stderr,
        ) = self.of_sys
        _environ._data = self.environment
        warnings.filters = self.filters
        logging.root.__dict__ = self.root_logger
        logging.root.manager.loggerDict = self.loggers


class Process(Slots):
    """The process of one node: ``world`` is what the stand-ins know of it, ``imports`` is what it can import.

    It begins as a copy of the process that it is made in, with another command line: ``args`` are the words after the
    first. ``environment`` is added to the environment; ``folder``, if given, is the working directory; ``stdout`` and
    ``stderr``, if given, are its streams.
    """

    def __init__(
        self,
        node: Code,
        args: Sequence[str],
        make_world: Callable[[list[str]], World],
        stand_in: Callable[[int, str], Mapping[str, ModuleType]],
        hidden: Callable[[Mapping[str, ModuleType]], None],
        environment: Mapping[str, str] | None = None,
        folder: str = "",
        stdout: TextIO | None = None,
        stderr: TextIO | None = None,
    ) -> None:
        super().__init__()
        self.node = node
        argv = [node.argv0, *args]
        self.world = make_world(argv)
        self.imports = Imports(node, self.world, stand_in, hidden)
        self._own = own_folders(node)
        note_own(node.filename, self._own)
        folders = [] if node.folder is None else [node.folder]
        around = [] if node.folder is None else [around_package(node.folder)]
        if folder:
            self.folder = os.path.abspath(folder)
        added = {os.fsencode(name): os.fsencode(value) for name, value in (environment or {}).items()}
        root = vars(logging.root)
        self.of_sys = (
            argv,
            [*folders, *sys.path, *filter(None, around)],
            [self.imports, *sys.meta_path],
            sys.__excepthook__,
            sys.__unraisablehook__,
            sys.stdin,
            stdout or sys.stdout,
            stderr or sys.stderr,
        )
        self.world.stderr = stderr or sys.stderr
        self.environment = {**self.environment, **added}
        self.filters = list(warnings.filters)
        self.root_logger = {**root, "handlers": root["handlers"][:], "filters": root["filters"][:], "_cache": {}}
        self.loggers = dict(self.loggers)

    def owns(self, module: object) -> bool:
        """Whether a module, or its package, lies next to the node or its package, and is not installed there."""
        if not isinstance(module, ModuleType):  # a node can put anything into sys.modules
            return False
        return is_own(module.__name__, getattr(module, "__file__", None) or "", self._own)

    def with_its_ros(self, names: set[str], own: set[str]) -> set[str]:
        """Return which of the imported modules hold something of its ROS, its messages, or modules of its ``own``.

        They are its own, too: in the next run the same names would mean other objects. So is all of their package.
        """
        roots = {name.partition(".")[0] for name in own} | self.imports.packages | set(ROS[self.world.ros or 1].roots)
        left = {name for name in names if name.partition(".")[0] not in _COMMON}
        count = -1
        while count != len(roots):
            count = len(roots)
            roots |= {name.partition(".")[0] for name in left if _holds(sys.modules[name], roots)}
            left = {name for name in left if name.partition(".")[0] not in roots}
        return {name for name in names if name.partition(".")[0] in roots}

    def give_parameters(self, parameters: Mapping[str, Any]) -> None:
        """Set parameters before the node runs, once it is known of which ROS it is. A wrong value ends the run."""

        def give() -> None:
            try:
                with acting_for(self.world):
                    ROS[self.world.ros].tester.give_parameters(self.world, parameters)
            except Exception as error:
                self.world.failure = error
                end_run()

        if parameters:
            self.world.at_bind.append(give)

    def namesakes(self) -> set[str]:
        """Return the names of imported modules that a file next to the node has, too, and that are not that file."""
        folder = self.node.folder
        names = {entry.partition(".")[0] for entry in os.listdir(folder)} if folder else set()
        loaded = {name: module for name in names - {"__main__", "rosspin"} if (module := sys.modules.get(name))}
        return {
            name
            for name, module in loaded.items()
            if (file := getattr(module, "__file__", None))
            and not (self.owns(module) or is_installed_file(file))
            and neighbour(folder or "", name)
        }

    @property
    def messages(self) -> Any:
        """The classes of its messages by name, as in ``messages["std_msgs/UInt32"]``."""
        return self.imports.messages

    @property
    def raises_at_ctrl_c(self) -> bool:
        """Whether Ctrl-C raises KeyboardInterrupt in its node, as in ROS 2. If that ends it, it has not failed."""
        return bool(self.world.ros) and ROS[self.world.ros].raises

    def fails_with(self, status: int, interrupted: bool) -> bool:
        """Whether an exit status means failure. In ROS 2, most nodes end with 130 when they are ``interrupted``."""
        is_end = interrupted and status == 128 + signal.SIGINT and self.raises_at_ctrl_c
        return status != 0 and not self.world.crashed and not is_end

    def run(self) -> None:
        """Run the node's code as the interpreter runs a program, and keep the exit status."""
        try:
            self._run()
        finally:
            self.end_if_forked()

    def end_if_forked(self) -> None:
        """End this process if it is a child that the node has forked: what comes next is for its parent to do."""
        if os.getpid() != self.world.pid:
            for stream in filter(None, (sys.stdout, sys.stderr)):
                stream.flush()
            os._exit(self.world.exit_status or 0)

    def _run(self) -> None:
        world = self.world
        status = 0
        begin_main(world)
        try:
            self.node.main()
        except SystemExit as error:
            if not isinstance(error.code, int) and error.code is not None:
                sys.stderr.write(f"{error.code}\n")
            status = _status(error)
        except (NotSimulated, Ended, StackExit, Died):
            raise
        except BaseException as error:
            heed()
            if lacking := not_simulated(error):
                raise lacking from error
            status = 128 + signal.SIGINT if type(error) is KeyboardInterrupt else 1
            if sys.excepthook is sys.__excepthook__:
                _print_error(world, error)
            else:
                world.note_error(error)
                try:
                    sys.excepthook(type(error), error, error.__traceback__)
                except SystemExit as end:
                    status = _status(end)
                except Exception as another:
                    sys.stderr.write("Error in sys.excepthook:\n")
                    _print_error(world, another)
        world.note_main_status(status)
        try:
            end_main(world)
        except (NotSimulated, Ended, StackExit, Died):
            raise
        except BaseException as error:
            sys.stderr.write("Exception ignored in: <module 'threading'>\n")
            _print_error(world, error)
        if self.node.source is not None:  # a program, which waits for them (source: _exit_function in multiprocessing)
            world.at_exit[:0] = [(child.join, (), {}) for child in world.forked]
        _run_at_exit(world)
        world.exit_status = status
        world.finished = True


# What is not made for one run: the standard library, and this package.
_COMMON = sys.stdlib_module_names | {"rosspin"}


def _holds(module: object, roots: set[str]) -> bool:
    """Whether a module has a name for something that comes from one of the packages ``roots``."""
    if not isinstance(module, ModuleType):
        return False
    for value in list(vars(module).values()):
        if isinstance(value, ModuleType):
            home = value.__name__
        else:
            home = (value if isinstance(value, (type, FunctionType)) else type(value)).__module__
        if isinstance(home, str) and (home.startswith(_STAND_INS) or home.partition(".")[0] in roots):
            return True
    return False


def _status(end: SystemExit) -> int:
    return end.code & 0xFF if isinstance(end.code, int) else int(end.code is not None)


def _print_error(world: World, error: BaseException, made: traceback.FrameSummary | None = None) -> None:
    """Print an uncaught exception on stderr, with the node's frames, and keep it."""
    if sys.stderr is None:
        world.stderr.write("rosspin: sys.stderr is None, and Python would show nothing of this:\n")
    (sys.stderr or world.stderr).write(format_error(error, made))
    world.note_error(error)


def _run_at_exit(world: World) -> None:
    """Call what the node registered with ``atexit``, the last first, and print exceptions."""
    while world.at_exit:
        function, args, kwargs = world.at_exit.pop()
        try:
            function(*args, **kwargs)
        except (Ended, StackExit):
            raise
        except SystemExit:
            pass
        except BaseException as error:
            (sys.stderr or world.stderr).write(f"Exception ignored in atexit callback: {function!r}\n")
            _print_error(world, error)


def _excepthook(real: Callable[[Any], None]) -> Callable[[Any], None]:
    """``threading.excepthook`` for the threads of nodes: what ends a run continues, the rest is printed."""

    def excepthook(args: Any) -> None:
        world, error = whose(), args.exc_value
        if isinstance(error, Ended):
            raise error
        lacking = not_simulated(error)
        if not isinstance(world, World):
            real(args)
        elif isinstance(error, NotSimulated) or lacking:
            world.failure = world.failure or lacking or error
            end_run()
        elif not isinstance(error, (StackExit, SystemExit)):
            (sys.stderr or world.stderr).write(f"Exception in thread {args.thread.name}:\n")
            _print_error(world, error, getattr(args.thread, "made", None))

    return excepthook


def _register(real: Callable[..., Any]) -> Callable[..., Any]:
    """``atexit.register``: what a node registers is called at the end of its run; what a library does, as usual."""

    def register(function: Callable[..., Any], *args: Any, **kwargs: Any) -> Callable[..., Any]:
        world = whose()
        if isinstance(world, World) and not is_installed(sys._getframe(1)):
            world.at_exit.append((function, args, kwargs))
        else:
            real(function, *args, **kwargs)
        return function

    return register


def _unregister(real: Callable[..., Any]) -> Callable[..., Any]:
    def unregister(function: Callable[..., Any]) -> None:
        world = whose()
        if isinstance(world, World):
            world.at_exit[:] = [entry for entry in world.at_exit if entry[0] != function]
        else:
            real(function)

    return unregister


def _exit(real: Callable[[int], Any]) -> Callable[[int], Any]:
    """``os._exit``: end the node, not the process that runs it."""

    def exit_at_once(status: int) -> None:
        world = whose()
        if not isinstance(world, World) or os.getpid() != world.pid:  # outside of all nodes, or in a child of one
            real(status)
        else:
            world.exit_status = status
            end_program()

    return exit_at_once


# What a node has used, by the module that then asks for a process.
_STARTERS = {
    "concurrent.futures.process": "ProcessPoolExecutor",
    "multiprocessing.managers": "multiprocessing.Manager",
    "multiprocessing.pool": "multiprocessing.Pool",
    "multiprocessing.process": "multiprocessing.Process",
}


def starter(frame: FrameType) -> str:
    """Name what a node has used of the standard library to ask for a process, or for something that processes share.

    If a process is being started, the name says how: it depends on the platform, and on Python's version.
    """
    process = _being_started(frame)
    return _starter(frame) + (f" ({_method(process)})" if process else "")


def _starter(frame: FrameType) -> str:
    calls = [(each.f_globals.get("__name__"), each.f_code.co_name) for each, _ in traceback.walk_stack(frame)]
    for module, function in reversed(calls):
        if module in _STARTERS:
            return _STARTERS[module]
        if module == "multiprocessing.context" and not function.startswith("_"):
            return f"multiprocessing.{function}"
    return "multiprocessing"


def _being_started(frame: FrameType) -> Any:
    """Return the process of ``multiprocessing`` that is being started, the outermost one; None if there is none."""
    found = None
    for each, _ in traceback.walk_stack(frame):
        if each.f_globals.get("__name__") == "multiprocessing.process" and each.f_code.co_name == "start":
            found = each.f_locals["self"]
    return found


def _method(process: Any) -> str:
    return str(getattr(process, "_start_method", None) or sys.modules["multiprocessing"].get_start_method())


def _fork(real: Callable[..., Any]) -> Callable[..., Any]:
    """Start no process for ``multiprocessing`` in simulated time, and none that is not forked; others may start any.

    Its processes wait for each other in real time. One that is not forked is a Python without stand-ins.
    """

    def fork(*args: Any) -> Any:
        world, process = whose(), None
        if isinstance(world, World) and os.getpid() == world.pid:
            frame = sys._getframe(1)
            if process := _being_started(frame):
                if _method(process) != "fork":
                    raise NotSimulated(starter(frame))
                if isinstance(world.clock, Simulation):
                    raise NotSimulated(starter(frame), "the wall clock or on a real ROS")
        pid = real(*args)
        if isinstance(world, World) and process and pid and not process.daemon:
            world.forked.append(process)
        return pid

    return fork


PATCHES: list[Patch] = [
    (os, "_exit", _exit),
    (os, "fork", _fork),
    *((module, "fork_exec", _fork) for module in [_posixsubprocess] if module),
    (threading, "excepthook", _excepthook),
    (atexit, "register", _register),
    (atexit, "unregister", _unregister),
]


def leave(status: int, world: World) -> None:
    """Exit immediately if a killed node has left threads for which Python would wait."""
    if any(thread.ident in world.idents and not thread.daemon for thread in threading.enumerate()):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)
