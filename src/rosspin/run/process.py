"""A node's code, and the process as the node sees it: command line, modules, streams, folder, end of its threads."""

from __future__ import annotations

import atexit
import codecs
import io
import linecache
import os
import re
import sys
import threading
import tokenize
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from importlib.machinery import BuiltinImporter, FrozenImporter
from pathlib import Path
from types import CodeType, FrameType, ModuleType
from typing import Any, NamedTuple, TextIO

try:
    import _posixsubprocess
except ImportError:  # a web page has no processes
    _posixsubprocess = None  # type: ignore[assignment]

from ..clocks.ending import Ended
from ..clocks.frames import format_error, is_installed
from ..clocks.patches import Patch, patched
from ..clocks.programs import end_program, end_run
from ..clocks.simulation import Simulation
from ..clocks.stacks import StackExit, whose
from ..messages import MessageFinder
from ..world.world import NotSimulated, World, not_simulated
from .kept import state_of_node, state_of_process, working_folder

__all__ = [
    *(
        "in_the_way",
        "Capture",
        "Node",
        "NodeLike",
        "Process",
        "around_package",
        "byte_stream",
        "capture",
        "execute",
        "folder_of",
    ),
    *(
        "kept_in_order",
        "leave",
        "load",
        "load_source",
        "print_error",
        "refuse_a_run_within_a_run",
        "refuse_launch_of_ros2",
    ),
    *("refuse_other_ros", "refuse_text", "run_at_exit", "starter"),
]


# --- a node's code ----------------------------------------------------------------------------------------------------


class Node(NamedTuple):
    """What can be run: the node's own code, the first word of its command line, the file that the code is in."""

    main: Callable[[], Any]
    argv0: str
    filename: str
    folder: str | None  # of the node file: its neighbours can be imported
    source: str | None = None  # the text that it was made of, if it was
    ros: int = 1  # or 2: for which it was written


NodeLike = str | os.PathLike[str] | Callable[[], Any]


def load(node: NodeLike) -> Node:
    """Make a node of a file or a function.

    Raises OSError if it cannot be read, SyntaxError if it is not Python, ValueError for several nodes, for a launch
    file, or if it is for both ROSes, TypeError for what is neither.
    """
    if callable(node):
        code = getattr(node, "__code__", None)
        filename = code.co_filename if code else ""
        ros = _ros([code] if code else [], filename, None)
        return Node(node, getattr(node, "__name__", "node"), filename, None, ros=ros)
    if isinstance(node, (list, tuple)) or (isinstance(node, (str, os.PathLike)) and str(node).endswith(".launch")):
        raise ValueError("several nodes and launch files run in simulated time (rosspin.simulate) or on a real ROS")
    if not isinstance(node, (str, os.PathLike)):
        raise TypeError(f"a node is the path of a file, or a function, not {node!r}")
    path = os.fspath(node)
    refuse_launch_of_ros2(path)
    return load_source(_read(path), path)


def _read(path: str) -> str:
    """The text of a Python file. SyntaxError for bytes that are none."""
    try:
        with tokenize.open(path) as file:
            return file.read()
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        text = f"the byte 0x{error.object[error.start]:02x} is not {error.encoding}"
        raise SyntaxError(text, (path, line, None, None)) from None


def refuse_launch_of_ros2(path: str) -> None:
    """ValueError for a launch file of ROS 2, by its name."""
    if re.search(r"[._]launch\.(xml|ya?ml)$|\.launch\.py$", path):
        raise ValueError(
            f"{path}: rosspin runs launch files of ROS 1 (.launch) only; run the nodes of this one one by one"
        )


# What the real ROS 1 or 2 needs to run a node, beside Python's own modules.
_NEEDED = {
    1: {"genpy", "rosgraph", "rosgraph_msgs", "roslib", "rospkg", "rospy", "std_msgs", "yaml"},
    2: {"builtin_interfaces", "rcl_interfaces", "rclpy", "rosgraph_msgs", "rosidl_runtime_py", "rpyutils", "yaml"},
}


def in_the_way(node: Node) -> list[str]:
    """What is to be said of files beside a node, or its own, that hide modules from a real ROS, a line for each."""
    if node.folder is None:
        return []
    lines = []
    for entry in sorted(os.listdir(node.folder)):
        name = entry.removesuffix(".py")
        if name in _NEEDED[node.ros] or (name.endswith("_msgs") and name in _imports(node)):
            whose = f"ROS {node.ros}'s"
        elif name in sys.stdlib_module_names and not any(map(_finds(name), (BuiltinImporter, FrozenImporter))):
            whose = "Python's"
        else:
            continue
        file = _neighbour(node.folder, name)  # looked for last: a folder may hold hundreds
        if not file:
            continue
        shown = os.path.relpath(file) if working_folder() else file
        lines.append(
            f"{shown} is in the way of {whose} module {name}: on a real ROS whatever imports {name} is given this file"
        )
    return lines


def _finds(name: str) -> Callable[[Any], bool]:
    return lambda importer: importer.find_spec(name) is not None


def _imports(node: Node) -> set[str]:
    with suppress(SyntaxError):
        return {name.partition(".")[0] for name in _names(_compile(node.source or "", node.filename))}
    return set()


def refuse_other_ros(path: str, ros: int) -> None:
    """ValueError if a node file is for the other ROS. What is wrong with it otherwise, its run will show."""
    with suppress(SyntaxError):
        code = compile(_read(path), path, "exec", dont_inherit=True)
        if _roses([code], str(Path(path).resolve().parent)) == {3 - ros}:
            raise ValueError(f"{path}: this is a node of ROS {3 - ros}: --ros{3 - ros}")


def refuse_text(args: Sequence[str]) -> None:
    """TypeError for a command line that is not in words."""
    if isinstance(args, str):
        raise TypeError(f"args is a list of words, not a text: {args.split()!r}, not {args!r}")


def load_source(source: str, filename: str) -> Node:
    """Load a node from its source text. Raises SyntaxError if it is not Python, ValueError if it is for both ROSes."""
    lines = io.StringIO(source, newline=None).readlines()  # as Python counts them; it may show one when it compiles
    linecache.cache[filename] = (len(source), None, lines, filename)
    code = _compile(source, filename)
    folder = str(Path(filename).resolve().parent) if os.path.exists(filename) else None
    return Node(lambda: execute(code, filename), filename, filename, folder, source, _ros([code], filename, folder))


def _compile(source: str, filename: str) -> CodeType:
    try:
        return compile(source, filename, "exec", dont_inherit=True)
    except SyntaxError as error:  # of null bytes Python does not say where
        line = source.partition("\0")[0].count("\n") + 1
        raise error if error.filename else SyntaxError(error.msg, (filename, line, None, None)) from None


_ROSES = {"rospy": 1, "rclpy": 2}


def _ros(codes: list[CodeType], filename: str, folder: str | None) -> int:
    """The ROS that code is for: 2 if it, or else a neighbour that it imports, imports ``rclpy``. Both: ValueError."""
    found = _roses(codes, folder)
    if len(found) == 2:
        raise ValueError(f"{filename}: a node imports rospy (ROS 1) or rclpy (ROS 2), but not both")
    return 2 if 2 in found else 1


def _roses(codes: list[CodeType], folder: str | None) -> set[int]:
    """The ROSes whose Python code imports, or else a neighbour that it imports."""
    seen: set[str] = set()
    while codes:
        names = {name for code in codes for name in _names(code)}
        roots = {name.partition(".")[0] for name in names}
        if roots & _ROSES.keys() or folder is None:
            return {_ROSES[root] for root in roots & _ROSES.keys()}
        paths = {path for name in names - seen if (path := _neighbour(folder, name))}
        seen |= names
        codes = [_compile(_read(path), path) for path in sorted(paths)]
    return set()


def _names(code: CodeType) -> Iterator[str]:
    """The names in code and in the functions in it, among which are those of the modules that it imports."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def _neighbour(folder: str, name: str) -> str | None:
    path = os.path.join(folder, *name.split("."))
    return next((file for file in (f"{path}.py", os.path.join(path, "__init__.py")) if os.path.isfile(file)), None)


def around_package(folder: str) -> str:
    """The folder from which the package in a folder can be imported, as after ``colcon build``; "" if it is none."""
    around = folder
    while os.path.isfile(os.path.join(around, "__init__.py")):
        around = os.path.dirname(around)
    return around if around != folder else ""


def execute(code: CodeType, filename: str) -> None:
    """Run code as the module ``__main__``."""
    module = ModuleType("__main__")
    module.__file__ = filename
    sys.modules["__main__"] = module
    exec(code, module.__dict__)


# --- the process around it --------------------------------------------------------------------------------------------

# A run changes what the whole process shares, so there is one at a time.
_one_at_a_time = threading.RLock()


def refuse_a_run_within_a_run() -> None:
    """RuntimeError if a node asks."""
    if whose() is not None:
        raise RuntimeError("a node cannot start a run of its own")


class Process:
    """The process as a node sees it: its command line, its path, and ``modules`` by their names.

    It can import the messages of ROS 1 or 2, and those of its own package and the packages beside it; ``messages``
    makes their classes.
    """

    def __init__(self, node: Node, args: Sequence[str], modules: Mapping[str, ModuleType], ros: int) -> None:
        self._node = node
        self._args = args
        self._finder = MessageFinder(ros, folder_of(node))
        self.messages = self._finder.messages
        self._modules = dict(modules)  # those that only the node has
        self._put_inside = self._begin
        self._put_names: Callable[[], None] = lambda: None  # those that the node has changed

    def _begin(self) -> None:
        sys.argv = [self._node.argv0, *self._args]
        sys.excepthook, sys.unraisablehook = sys.__excepthook__, sys.__unraisablehook__
        if self._node.folder is not None:
            sys.path.insert(0, self._node.folder)
            if around := around_package(self._node.folder):
                sys.path.append(around)

    @contextmanager
    def inside(self) -> Iterator[None]:
        """Within this context the process is the node's, as it was left the last time.

        Afterwards, whatever the node has changed is as before: environment, working directory, loggers, modules.
        """
        with kept_in_order(self._note_names):
            self._put_inside()
            self._put_names()
            try:
                with self._finder, self._own_modules():
                    yield
            finally:
                self._put_inside = state_of_node()

    def _note_names(self, put: Callable[[], None]) -> None:
        self._put_names = put

    @contextmanager
    def _own_modules(self) -> Iterator[None]:
        """Within this context the node's modules are there, and not those of the same names that were there."""
        before = dict(sys.modules)
        sys.modules.update(self._modules)
        try:
            yield
        finally:
            found = {name for name in sys.modules if name not in before and _lies_in(self._node.folder, name)}
            own = {name for name in ("__main__", *self._modules, *found) if name in sys.modules}
            self._modules = {name: sys.modules.pop(name) for name in own}
            sys.modules.update({name: before[name] for name in own if name in before})


@contextmanager
def kept_in_order(left: Callable[[Callable[[], None]], None] | None = None) -> Iterator[None]:
    """What any run needs of the process: there is one at a time, and what it changes is undone at its end.

    ``left`` is told how to have the names again that were changed.
    """
    refuse_a_run_within_a_run()
    with _one_at_a_time:
        put_back = state_of_process()
        try:
            with patched(_PATCHES):
                yield
        finally:
            put_names = put_back()
            if left:
                left(put_names)


def folder_of(node: Node) -> Path | None:
    """The folder of a node's code, from which its package is looked for: a function's, too."""
    return Path(node.filename).parent if os.path.exists(node.filename) else None


def _lies_in(folder: str | None, name: str) -> bool:
    """Whether a module is, or belongs to, a neighbour of the node or its package; a virtual environment is none."""
    file: str | None = getattr(sys.modules[name], "__file__", None)
    if folder is None or file is None:
        return False
    root = name.partition(".")[0]
    neighbours = [os.path.join(each, root) for each in (folder, around_package(folder)) if each]
    return os.path.abspath(file).startswith(tuple(each + end for each in neighbours for end in (".", os.sep)))


def print_error(world: World, error: BaseException, made: traceback.FrameSummary | None = None) -> None:
    """Print an exception that was not caught on stderr, with the node's frames, and keep it."""
    if sys.stderr is None:
        world.stderr.write("rosspin: sys.stderr is None, and Python would show nothing of this:\n")
    (sys.stderr or world.stderr).write(format_error(error, made))
    world.note_error(error)


def _excepthook(real: Callable[[Any], None]) -> Callable[[Any], None]:
    """``threading.excepthook`` for the threads of nodes: what ends a run goes on, the rest is printed."""

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
            print_error(world, error, getattr(args.thread, "made", None))

    return excepthook


def _register(real: Callable[..., Any]) -> Callable[..., Any]:
    """``atexit.register``: what a node registers is called at the end of its run; a library lives longer than that."""

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
    """``os._exit``: of a node, not of the process that runs it."""

    def exit_at_once(status: int) -> None:
        world = whose()
        if not isinstance(world, World) or os.getpid() != world.pid:  # outside of all nodes, or in a child of one
            real(status)
        else:
            world.exit_status = status
            end_program()

    return exit_at_once


# Who wants a process, by the module that asks for it.
_STARTERS = {
    "concurrent.futures.process": "ProcessPoolExecutor",
    "multiprocessing.managers": "multiprocessing.Manager",
    "multiprocessing.pool": "multiprocessing.Pool",
    "multiprocessing.process": "multiprocessing.Process",
}


def starter(frame: FrameType) -> str:
    """Which name of the standard library a node has used that wants a process, or what processes can share."""
    calls = [(each.f_globals.get("__name__"), each.f_code.co_name) for each, _ in traceback.walk_stack(frame)]
    for module, function in reversed(calls):
        if module in _STARTERS:
            return _STARTERS[module]
        if module == "multiprocessing.context" and not function.startswith("_"):
            return f"multiprocessing.{function}"
    return "multiprocessing"


def _fork(real: Callable[..., Any]) -> Callable[..., Any]:
    """What starts a process for ``multiprocessing``, and for others, which may.

    What its processes wait for, they wait for in real time. One that is not forked is a Python without stand-ins.
    """

    def fork(*args: Any) -> Any:
        world = whose()
        if isinstance(world, World) and os.getpid() == world.pid:
            for frame, _ in traceback.walk_stack(sys._getframe(1)):
                if frame.f_globals.get("__name__") == "multiprocessing.process" and frame.f_code.co_name == "start":
                    method = getattr(frame.f_locals["self"], "_start_method", None)
                    method = method or sys.modules["multiprocessing"].get_start_method()
                    if method != "fork":
                        raise NotSimulated(f"{starter(frame)} ({method})")
                    if isinstance(world.clock, Simulation):
                        raise NotSimulated(f"{starter(frame)} ({method})", "the wall clock or on a real ROS")
        return real(*args)

    return fork


_PATCHES: list[Patch] = [
    (os, "_exit", _exit),
    (os, "fork", _fork),
    *((module, "fork_exec", _fork) for module in [_posixsubprocess] if module),
    (threading, "excepthook", _excepthook),
    (atexit, "register", _register),
    (atexit, "unregister", _unregister),
]


def run_at_exit(world: World) -> None:
    """Call what the node registered with ``atexit``, the last first; exceptions are printed."""
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
            print_error(world, error)


def leave(status: int, world: World) -> None:
    """Exit at once, if Python would wait for threads that are left of a node: one that was killed."""
    if any(thread.ident in world.idents and not thread.daemon for thread in threading.enumerate()):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(status)


# --- its streams ------------------------------------------------------------------------------------------------------


class Capture:
    """What is written to two streams, in order. It is also written to ``stdout`` and ``stderr``, if these are given."""

    def __init__(self, stdout: TextIO | None = None, stderr: TextIO | None = None) -> None:
        self._chunks: list[bytes] = []
        self.stdout = byte_stream(self._keep(stdout))
        self.stderr = byte_stream(self._keep(stderr))

    def __len__(self) -> int:
        """How many pieces were written."""
        return len(self._chunks)

    def text(self, since: int = 0) -> str:
        """All of it, from the piece ``since`` on."""
        return b"".join(self._chunks[since:]).decode(errors="replace")

    @contextmanager
    def redirected(self) -> Iterator[None]:
        """Within this context, what is printed goes here."""
        refuse_a_run_within_a_run()
        with _one_at_a_time, redirect_stdout(self.stdout), redirect_stderr(self.stderr):
            yield

    def _keep(self, onward: TextIO | None) -> Callable[[bytes], None]:
        decode = codecs.getincrementaldecoder("utf-8")(errors="replace").decode

        def keep(data: bytes) -> None:
            self._chunks.append(data)
            if onward is not None:
                onward.write(decode(data))

        return keep


class _Sink(io.BufferedIOBase):
    """The bytes of a stream, for nodes that write some: ``sys.stdout.buffer``."""

    def __init__(self, take: Callable[[bytes], None]) -> None:
        self._take = take

    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        self._take(bytes(data))
        return len(data)


def byte_stream(take: Callable[[bytes], None]) -> TextIO:
    """A stream such as ``sys.stdout``: ``take`` is called with all that is written, as UTF-8."""
    sink: Any = _Sink(take)
    return io.TextIOWrapper(sink, encoding="utf-8", errors="backslashreplace", newline="\n", write_through=True)


@contextmanager
def capture(stdout: TextIO | None = None, stderr: TextIO | None = None) -> Iterator[Capture]:
    """Within this context, what is printed goes to a :class:`Capture`, and from there to the streams that are given."""
    captured = Capture(stdout, stderr)
    with captured.redirected():
        yield captured
