"""Run a launch file of ROS 2, as ``ros2 launch`` does (source: launch/launch_service.py)."""

from __future__ import annotations

import os
import re
import signal
import sys
import threading
from bisect import insort
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from ...clocks.clock import NS, nanoseconds
from ...clocks.frames import is_installed, node_frames
from ...clocks.installed import note_own
from ...clocks.simulation import Simulation
from ...messages.library import Library
from ...results.folders import TemporaryFolder
from ..executables import find_cpp, find_node, is_cpp
from ..host import Host
from ..source import Code, compiled, load, read, warn_of_files
from ..tags import Fault
from . import events
from .actions import ExecuteProcess, IncludeLaunchDescription, LaunchDescription
from .context import LaunchContext
from .frontend import read_xml, read_yaml
from .launch_file import LaunchFile
from .modules import PackageNotFoundError, modules, within
from .process import ExecuteLocal

__all__ = ["LaunchService", "Timer"]


@dataclass(eq=False)
class Timer:
    """A function, and the time (ns) at which it should be called, unless :meth:`cancel` is called before."""

    when: int
    function: Callable[[], None]
    all: list[Timer]

    def cancel(self) -> None:
        """Forget it."""
        if self in self.all:
            self.all.remove(self)


class LaunchService:
    """Runs a launch file in a host, and does what its actions ask for.

    Raises ValueError, with file and line, for anything that is faulty or not simulated.
    """

    status = 0  # whatever becomes of the nodes

    def __init__(self, host: Host, file: LaunchFile) -> None:
        assert isinstance(host.clock, Simulation)
        self.context = LaunchContext(self, file.args)
        self.folder = ""  # for what is written
        self._host, self._clock, self._file = host, host.clock, file
        self._stdout, self._stderr = sys.stdout, sys.stderr
        self._library = Library(2, Path(file.path).absolute().parent)
        self._modules = modules(self)
        self._processes: list[ExecuteLocal] = []
        self._node_names: list[str] = []
        self._timers: list[Timer] = []
        self._soon: deque[Callable[[], None]] = deque()

    # --- the loop ---

    def run(self) -> None:
        """Do what the file says, until nothing is left to do, or Ctrl-C comes."""
        self._wake = threading.Event()
        signal.signal(signal.SIGINT, lambda number, frame: self._interrupt())
        self.context.register_event_handler(events.OnShutdown(on_shutdown=lambda event, context: self._note_end()))
        self.context.register_event_handler(events.OnTimer())
        with TemporaryFolder() as temporary:
            self.folder = str(temporary.path)
            self.soon(self._begin)
            while True:
                while self._step():
                    pass
                if self._timers or not all(process.is_over for process in self._processes):
                    self._wait()
                elif self.context.is_shutdown:
                    break
                else:
                    self._shut_down("idle")

    def _begin(self) -> None:
        arguments = [_argument(each) for each in self._file.args]
        include = IncludeLaunchDescription(self._file.path, launch_arguments=arguments)
        include.place = ""
        self._visit(include)

    def _step(self) -> bool:
        """Do what is first of all that should be done now; False if nothing is."""
        with self._host.outside(), within(self._modules), _told_with(f"{self._file.path}:1"):
            if self._soon:
                self._soon.popleft()()
            elif self.context.events:
                self._handle(self.context.events.popleft())
            elif self._timers and self._timers[0].when <= self._clock.now():
                self._timers.pop(0).function()
            else:
                return False
        return True

    def _wait(self) -> None:
        self._wake.wait((self._timers[0].when - self._clock.now()) / NS if self._timers else None)
        self._wake.clear()

    def _interrupt(self) -> None:
        self.log("WARNING", "launch", "user interrupted with ctrl-c (SIGINT)")
        for process in self._processes:  # they are on the same terminal
            process.press_ctrl_c()
        self._shut_down("ctrl-c (SIGINT)", due_to_sigint=True)
        self._wake.set()

    def _shut_down(self, reason: str, due_to_sigint: bool = False) -> None:
        if not self.context.is_shutdown:
            self.context.emit_event_sync(events.Shutdown(reason=reason, due_to_sigint=due_to_sigint))
        self._note_end()

    def _note_end(self) -> None:
        self.context.is_shutdown = True

    def _handle(self, event: Any) -> None:
        for handler in list(self.context.event_handlers):
            if handler.matches(event):
                self.context.known = {}
                self._visit_all(handler.handle(event, self.context))
        self.context.known = {}

    def _visit_all(self, entities: Any) -> None:
        for each in entities or ():
            if not hasattr(each, "visit"):
                raise RuntimeError(f"expected a LaunchDescriptionEntity from event_handler, got '{each}'")
            self._visit(each)

    def _visit(self, entity: Any) -> None:
        with _told_with(getattr(entity, "place", "") or f"{self._file.path}:1"):
            then = entity.visit(self.context)
        self._visit_all(then)

    # --- what actions ask for ---

    def soon(self, function: Callable[[], None]) -> None:
        """Call a function as soon as what is being done now is done."""
        self._soon.append(function)
        self._wake.set()

    def after(self, seconds: float, function: Callable[[], None]) -> Timer:
        """Call a function later."""
        timer = Timer(self._clock.now() + nanoseconds(seconds), function, self._timers)
        insort(self._timers, timer, key=lambda each: each.when)
        return timer

    def write(self, text: str) -> None:
        """Print on the console."""
        self._stdout.write(text)

    def log(self, level: str, name: str, text: str) -> None:
        """Print a line of the launch itself."""
        self.write(f"[{level}] [{name}]: {text}\n")

    def load(self, path: str) -> LaunchDescription:
        """Read a launch file. Raises OSError, SyntaxError and ValueError."""
        if path.endswith(".xml"):
            return read_xml(path)
        if path.endswith((".yaml", ".yml")):
            return read_yaml(path)
        module = ModuleType("python_launch_file")
        module.__file__ = path
        note_own(path, [])
        exec(compiled(read(path), path), module.__dict__)
        if not hasattr(module, "generate_launch_description"):
            text = f"launch file at '{path}' does not contain the required function 'generate_launch_description()'"
            raise Fault(f"{path}:1: {text}")
        description: LaunchDescription = module.generate_launch_description()
        return description

    def package(self, name: str) -> Path:
        """Return the folder of a package, which is its share folder, too. Raises PackageNotFoundError."""
        folder = self._library.package(name)
        if folder is None:
            raise PackageNotFoundError(f"package '{name}' not found around the launch file")
        return folder

    def write_file(self, text: str) -> str:
        """Write a file of parameters, and return its path."""
        number = len([*Path(self.folder).glob("launch_params_*")]) + 1
        path = os.path.join(self.folder, f"launch_params_{number}")
        Path(path).write_text(text, encoding="utf-8")
        return path

    def leaves_out(self, place: str, what: str) -> bool:
        """Whether nodes in C++ are left out; if so, say that this one is."""
        if self._file.skip_cpp:
            self._stderr.write(f"rosspin: {place}: {what} is left out\n")
        return self._file.skip_cpp

    def node(self, place: str, package: str, name: str) -> Code | None:
        """Return the code of a package's node; None if it is left out. Raises ValueError if there is none."""
        folder = self._library.package(package)
        code = find_node(folder, name) if folder else None
        if code or self.leaves_out(place, f"{package}/{name}"):
            return code
        if source := find_cpp(self.package(package), name):
            return load(source, self._let_work)
        if is_cpp(self.package(package), name):
            raise ValueError(f"{package}/{name} is a C++ node whose source is not there; --skip-cpp leaves it out")
        raise ValueError(f"executable '{name}' not found in package '{package}'")

    def _let_work(self) -> None:
        """Let the compiler work for longer than a simulation may stand still."""
        self._clock.beside += 1

    def command(self, place: str, words: Sequence[str]) -> tuple[Code | None, Sequence[str]]:
        """Return the code of a program, and the rest of its command line. Raises ValueError if it is not in Python."""
        match words:
            case ["ros2", "run", package, name, *rest]:
                return self.node(place, package, name), rest
            case [python, file, *rest] if re.fullmatch(r"python[\d.]*", os.path.basename(python)) and file[0] != "-":
                return load(file), rest
            case [file, *rest] if file.endswith(".py"):
                return load(file), rest
            case [file, *rest] if Path(file).parts[-3:-2] == ("lib",):  # as ExecutableInPackage says it
                return self.node(place, *Path(file).parts[-2:]), rest
        raise ValueError(f"{words[0]!r} is not simulated: only Python nodes are")

    def start(self, action: ExecuteProcess, name: str, code: Code, args: Sequence[str]) -> None:
        """Start the process of an action soon."""
        name = f"{name}-{len(self._processes) + 1}"
        if any(process.action is action for process in self._processes):
            raise RuntimeError(f"ExecuteLocal action '{name}': executed more than once")
        if not self.context.is_shutdown:
            warn_of_files([code])
            self._processes.append(ExecuteLocal(self, self._host, action, name, code, args))
            self.soon(self._processes[-1].begin)

    def note_node(self, name: str) -> None:
        """Warn if there are several nodes of a name."""
        self._node_names.append(name)
        count = self._node_names.count(name)
        if count > 1:
            text = f"there are now at least {count} nodes with the name {name} created within this launch context"
            self.log("WARNING", self._processes[-1].name, text)


def _argument(text: str) -> tuple[str, str]:
    name, assigned, value = text.partition(":=")
    if not (name and assigned):
        raise Fault(f"malformed launch argument '{text}', expected format '<name>:=<value>'")
    return name, value


@contextmanager
def _told_with(place: str) -> Iterator[None]:
    """Within this context an error becomes a Fault, at this place if it is not in the launch file's own code."""
    try:
        yield
    except Fault:
        raise
    except Exception as error:
        if isinstance(error, SyntaxError) and error.filename != "<string>":  # not in an expression
            raise
        raise Fault(_say(error, place)) from error


def _say(error: Exception, place: str) -> str:
    trace, said = node_frames(error.__traceback__), str(error)
    if type(error) is KeyError:
        said = f"KeyError: {said}"
    while trace:
        if not (is_installed(trace.tb_frame) or trace.tb_frame.f_code.co_filename.startswith("<")):
            place = f"{trace.tb_frame.f_code.co_filename}:{trace.tb_lineno}"
        trace = trace.tb_next
    if isinstance(error, OSError) and error.filename:
        said = f"{error.filename}: {error.strerror}"
    return f"{place}: {said}"
