"""A node's code: what can be run, how it is loaded, and what can be seen of it before it runs."""

from __future__ import annotations

import ast
import inspect
import io
import linecache
import os
import re
import sys
import tokenize
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from errno import ENOENT
from functools import partial
from importlib import import_module
from importlib.abc import Loader
from importlib.machinery import BuiltinImporter, FrozenImporter, PathFinder
from importlib.util import find_spec
from operator import attrgetter
from pathlib import Path
from types import CodeType, ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

from ..clocks.installed import is_installed_file
from .kinds import ROS, language_of, ros_of, written_in
from .saved_state import working_folder

if TYPE_CHECKING:
    from .kinds.language import Program

__all__ = [
    *("Code", "NodeLike", "around_package", "code_of_program", "folder_of", "load", "load_cell"),
    *("load_entry_point", "load_source"),
    *("compiled", "is_launch_of_ros2", "is_own", "names_a_ros", "own_folders", "read", "refuse_null_bytes"),
    *("refuse_other_ros", "refuse_text", "program", "split_words", "warn_of_files", "words_of"),
]


class Code(NamedTuple):
    """What can be run: the node's own code, the first word of its command line, the file that the code is in."""

    main: Callable[[], Any]
    argv0: str
    filename: str
    folder: str | None  # of the node file: its neighbours can be imported
    source: str | None = None  # the text that it was made from, if any
    hint: int = 0  # the number of the ROS that its code seems to name, or 0; what it imports decides
    loader: Callable[[str, str], Loader] | None = None  # of a module next to it, by name and path, if not Python's own
    is_entry_point: bool = False  # whether the file is imported as a module, whose function is then called

    @property
    def name(self) -> str:
        """Its name where it has no other: its file's, without the suffix, or its function's."""
        return os.path.basename(self.argv0).removesuffix(".py")


NodeLike = str | os.PathLike[str] | Callable[[], Any]


def load(node: NodeLike, waiting: Callable[[], object] = lambda: None) -> Code:
    """Make a node of a file, a function, or the name of a function, as in ``package.module:main``.

    ``waiting()`` is called again and again while a node is compiled. What the compiler warns of is said on
    ``sys.stderr``.

    Raises OSError if it cannot be read, SyntaxError if it is not Python, ValueError for several nodes or a launch file,
    TypeError for anything else.
    """
    if callable(node):
        function = inspect.unwrap(node)
        while isinstance(function, partial):
            function = inspect.unwrap(function.func)
        name = getattr(function, "__name__", type(function).__name__)
        code = getattr(function, "__code__", None) or getattr(type(function).__call__, "__code__", None)
        main = partial(_call, node, sys.modules.get("__main__"))
        return Code(main, name, code.co_filename if code else "", None, hint=_hint([code] if code else [], None))
    path = os.fspath(node) if isinstance(node, (str, os.PathLike)) else ""
    if isinstance(node, (list, tuple)) or path.endswith(".launch") or is_launch_of_ros2(path):
        raise ValueError("several nodes and launch files run in simulated time (rosspin.simulate) or on a real ROS")
    if not isinstance(node, (str, os.PathLike)):
        raise TypeError(f"a node is the path of a file, or a function, not {node!r}")
    if language := language_of(path):
        return _warned(language.program(path, waiting))
    if not os.path.exists(path) and _ENTRY.fullmatch(entry := path if ":" in path else _console_script(path)):
        return load_entry_point(entry)
    return load_source(read(path), path)


def load_cell(text: str, name: str) -> Code:
    """Load a node from the text of a cell. Raises SyntaxError, or for another language than Python ValueError.

    In C++, it may include headers and messages as a file in the working directory could.
    """
    if language := written_in(text):
        return _warned(language.program(name, lambda: None, text))
    return load_source(text, name)


def _warned(program: Program) -> Code:
    if program.warnings:
        sys.stderr.write(f"{program.warnings}\n")
    return code_of_program(program)


def code_of_program(program: Program) -> Code:
    """Return the code of a compiled node."""
    return Code(program, os.path.splitext(program.path)[0], program.path, None, hint=program.ros)


# How a function of a module is written (source: the specification of entry points, packaging.python.org).
_ENTRY = re.compile(r"\w+(\.\w+)*:\w+(\.\w+)*")


def _console_script(name: str) -> str:
    """Return the function that an installed package has given the name of a command; "" if there is none."""
    from importlib.metadata import entry_points  # takes a while, and most nodes are files

    return next((found.value for found in entry_points(group="console_scripts", name=name)), "")


def load_entry_point(entry: str, folder: str = "") -> Code:
    """Load a function that is written as ``package.module:function``. Its module is imported as itself, in the run.

    It is looked for in ``folder``, or where Python would look for it, the working directory first. Raises
    FileNotFoundError if it is not there, and what :func:`load` raises for its file.
    """
    module, _, function = entry.partition(":")
    first, *rest = module.split(".")
    spec = PathFinder.find_spec(first, [folder or working_folder() or ""]) or (None if folder else find_spec(first))
    for part in rest:
        spec = spec and PathFinder.find_spec(part, spec.submodule_search_locations or [])
    if not spec or not (spec.origin or "").endswith(".py"):
        raise FileNotFoundError(ENOENT, f"there is no module {module}, neither in this folder nor installed", entry)
    path = str(spec.origin)
    root = Path(path).parents[module.count(".") + (os.path.basename(path) == "__init__.py")]
    main = partial(_call_entry_point, module, function, path)
    return load_source(read(path), path)._replace(main=main, folder=str(root), is_entry_point=True)


def _call_entry_point(module: str, function: str, path: str) -> None:
    """Do what the script does that an installer makes of an entry point."""
    main = sys.modules["__main__"] = ModuleType("__main__")
    main.__file__ = path
    sys.exit(attrgetter(function)(import_module(module))())


def load_source(source: str, filename: str) -> Code:
    """Load a node from its source text. Raises SyntaxError if it is not Python."""
    code = compiled(source, filename)
    folder = str(Path(filename).resolve().parent) if os.path.exists(filename) else None
    return Code(program(code, filename), filename, filename, folder, source, _hint([code], folder))


def compiled(source: str, filename: str) -> CodeType:
    """Compile a source text so that its lines can be shown. Raises SyntaxError if it is not Python."""
    lines = io.StringIO(source, newline=None).readlines()  # as Python counts lines; it may show one while it compiles
    linecache.cache[filename] = (len(source), None, lines, filename)
    return _compile(source, filename)


def program(code: CodeType, filename: str, more: Mapping[str, Any] | None = None) -> Callable[[], None]:
    """Return what runs code as the module ``__main__``, which has these names besides its own.

    A file of a package can import from the package by relative names, as with ``python -m package.module``.
    """
    file = os.path.abspath(filename) if os.path.exists(filename) else filename
    package = package_of(filename)

    def execute() -> None:
        module = ModuleType("__main__")
        module.__file__ = file
        module.__package__ = package
        module.__dict__.update(more or {})
        sys.modules["__main__"] = module
        exec(code, module.__dict__)

    return execute


def _call(function: Callable[[], Any], main: ModuleType | None) -> None:
    """Call a function of a program whose module ``__main__`` it should find, if that could be seen."""
    if main:
        sys.modules["__main__"] = main
    function()


def read(path: str) -> str:
    """Read the text of a Python file. Raises SyntaxError for bytes that are not in its encoding."""
    try:
        try:
            with tokenize.open(path) as file:
                return file.read()
        except SyntaxError:
            with open(path, "rb") as file_of_bytes:
                content = file_of_bytes.read()
            if b"\0" in content:  # which Python 3.14 refuses here; whoever compiles the text says where it is
                return content.decode()
            raise
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        text = f"the byte 0x{error.object[error.start]:02x} is not {error.encoding}"
        raise SyntaxError(text, (path, line, None, None)) from None


def _compile(source: str, filename: str) -> CodeType:
    refuse_null_bytes(source, filename)
    return compile(source, filename, "exec", dont_inherit=True)


# --- what is refused before it runs -----------------------------------------------------------------------------------


def is_launch_of_ros2(path: str) -> bool:
    """Whether a file is a launch file of ROS 2, by its name."""
    return bool(re.search(r"(^|[._/\\])launch\.(py|xml|ya?ml)$", path))


def refuse_other_ros(path: str, ros: int) -> None:
    """Raise ValueError if a node file is for another ROS. The run will show anything else that is wrong with it."""
    with suppress(SyntaxError):
        if (its := load_source(read(path), path).hint) not in (0, ros):
            raise ValueError(f"{path}: this is a node of ROS {its}: --ros{its}")


def refuse_null_bytes(source: str, filename: str) -> None:
    """Raise SyntaxError for a null byte. Python does not say where it is, and older versions raise ValueError."""
    if "\0" in source:
        line = source.partition("\0")[0].count("\n") + 1
        raise SyntaxError("source code cannot contain null bytes", (filename, line, None, None))


def refuse_text(args: Sequence[str]) -> None:
    """Raise TypeError for a command line that is a text, not a list of words."""
    if isinstance(args, str):
        raise TypeError(f"args is a list of words, not a text: {args.split()!r}, not {args!r}")


def split_words(words: Sequence[str]) -> tuple[Sequence[str], Sequence[str]]:
    """Split a command line in two: rosspin's own words and, after ``--``, the node's."""
    at = words.index("--") if "--" in words else len(words)
    return words[:at], words[at + 1 :]


def warn_of_files(nodes: Sequence[Code]) -> None:
    """Say on ``sys.stderr`` which files next to nodes hide modules of Python or of a real ROS."""
    for line in dict.fromkeys(line for node in nodes for line in _in_the_way(node)):
        sys.stderr.write(f"rosspin: {line}\n")


def _in_the_way(node: Code) -> Iterator[str]:
    if node.folder is None:
        return
    for entry in sorted(os.listdir(node.folder)):
        name = entry.removesuffix(".py")
        if node.hint and (name in ROS[node.hint].needed or (name.endswith("_msgs") and name in _imports(node))):
            whose = f"ROS {node.hint}'s"
        elif name in sys.stdlib_module_names and not any(map(_finds(name), (BuiltinImporter, FrozenImporter))):
            whose = "Python's"
        else:
            continue
        file = neighbour(node.folder, name)  # looked for last: a folder may hold hundreds
        if not file or is_installed_file(file):
            continue
        shown = os.path.relpath(file) if working_folder() else file
        hidden = f"{shown} is in the way of {whose} module {name}"
        yield f"{hidden}: on a real ROS whatever imports {name} is given this file"


def _finds(name: str) -> Callable[[Any], bool]:
    return lambda importer: importer.find_spec(name) is not None


def _imports(node: Code) -> set[str]:
    return {name.partition(".")[0] for name in _names(_compile(node.source or "", node.filename))}


# --- what is seen of it -----------------------------------------------------------------------------------------------


def _hint(codes: Sequence[CodeType], folder: str | None) -> int:
    """Return the ROS that code names, else the one that the neighbours it imports name; 0 if it is none, or several."""
    seen: set[str] = set()
    while codes:
        names = {name for code in codes for name in _names(code)}
        named = {ros.number for name in names if (ros := ros_of(name))}
        if named or folder is None:
            return named.pop() if len(named) == 1 else 0
        paths = {path for name in names - seen if (path := neighbour(folder, name))}
        seen |= names
        codes = list(_compiled(sorted(paths)))
    return 0


def _compiled(paths: Sequence[str]) -> Iterator[CodeType]:
    for path in paths:
        with suppress(SyntaxError):  # it may be for another Python, and never be imported
            yield _compile(read(path), path)


def names_a_ros(code: CodeType) -> int:
    """Return the ROS that code names by itself, whatever it imports; 0 if it names none, or several."""
    return _hint([code], None)


def _names(code: CodeType) -> Iterator[str]:
    """Yield the names in code and in its functions; the modules that it imports are among them."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


def neighbour(folder: str, name: str) -> str | None:
    path = os.path.join(folder, *name.split("."))
    return next((file for file in (f"{path}.py", os.path.join(path, "__init__.py")) if os.path.isfile(file)), None)


def own_folders(node: Code) -> list[str]:
    """Return the folder of a node's file, and the one from which its package can be imported, if it is in one."""
    folders = [] if node.folder is None else [node.folder, around_package(node.folder)]
    return [os.path.join(folder, "") for folder in filter(None, folders)]


def is_own(name: str, file: str, folders: Sequence[str]) -> bool:
    """Whether a module, or its package, lies in such a folder, and is not installed there."""
    root, path = name.partition(".")[0], os.path.abspath(file)
    ways = tuple(f"{folder}{root}{end}" for folder in folders for end in (".", os.sep))
    return path.startswith(ways) and not is_installed_file(path)


def around_package(folder: str) -> str:
    """Find the folder from which a package is imported, as after ``colcon build``; "" if ``folder`` is no package."""
    around = folder
    while os.path.isfile(os.path.join(around, "__init__.py")):
        around = os.path.dirname(around)
    return around if around != folder else ""


def package_of(filename: str) -> str | None:
    """Return the name of the package that a file is in, as in ``package.part``; None if it is in none."""
    folder = os.path.dirname(os.path.realpath(filename)) if os.path.exists(filename) else ""
    around = around_package(folder) if folder else ""
    return os.path.relpath(folder, around).replace(os.sep, ".") if around else None


def words_of(path: str) -> list[str]:
    """Return what a Python is given to run a node file: its path, or the module that it is, if it needs its package."""
    package = package_of(path)
    with suppress(SyntaxError, ValueError):  # the run will show it
        if package and any(isinstance(each, ast.ImportFrom) and each.level for each in ast.walk(ast.parse(read(path)))):
            return ["-m", f"{package}.{Path(path).stem}"]
    return [path]


def folder_of(node: Code) -> Path | None:
    """Return the folder of a node's code, even a function's: the search for its package begins there."""
    return Path(node.filename).parent if os.path.exists(node.filename) else None
