"""Read a launch file as the nodes of one run (source: roslaunch's xmlloader.py, loader.py and substitution_args.py)."""

from __future__ import annotations

import os
import re
import shlex
from collections import Counter
from collections.abc import Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from ...messages.library import Library
from ...rospy.rosgraph import PRIV_NAME, canonicalize_name, load_mappings, make_global_ns, ns_join
from ...world import yaml_texts
from ..executables import find_cpp, find_python, is_cpp
from ..source import NodeLike
from ..tags import Tag, parse

__all__ = ["Launch", "Node", "read_launch"]

# How deep files may include one another. No one means more.
_DEEPEST = 100


@dataclass(frozen=True)
class Node:
    """One of the nodes of a run: what a launch file says in ``<node>``.

    ``node`` is the path of a node file, or a function; ``args`` are its command line, where remappings and private
    parameters are written as for ``rosrun``: ``"chatter:=talk"``, ``"_rate:=10"``. ``name`` replaces the name that the
    node gives itself, and ``namespace`` is the one that it starts in. If a ``required`` node ends, all nodes end; a
    node with ``respawn`` is started again ``respawn_delay`` seconds after its end. ``output`` is "screen", or "log" to
    keep what the node prints on stdout off the console. ``cwd`` is the folder that it starts in (default: this
    process's), and ``env`` is added to its environment. ``parameters`` are set before it runs: in ROS 1 private ones by
    names such as ``"~rate"``, in ROS 2 those that it declares.
    """

    node: NodeLike
    args: Sequence[str] = ()
    name: str = ""
    namespace: str = "/"
    required: bool = False
    respawn: bool = False
    respawn_delay: float = 0.0
    output: str = "screen"
    cwd: str = ""
    env: Mapping[str, str] = field(default_factory=dict)
    parameters: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Launch:
    """The nodes of a run in the order of their start, the parameters that are set first, and what is left out."""

    nodes: Sequence[Node]
    parameters: Sequence[tuple[str, Any]] = ()
    left_out: Sequence[str] = ()


def read_launch(
    path: str | os.PathLike[str], args: Sequence[str] = (), skip_cpp: bool = False, commands: bool = True
) -> Launch:
    """Read a launch file; ``args`` are its own, as in ``"rate:=10"``.

    The packages that it names are looked for around the file. With ``skip_cpp`` nodes that are not in Python are left
    out. What ``<param command>`` names is run when all of the file has been found right, and with ``commands`` only:
    else such parameters are left out. Raises OSError if a file cannot be read, and ValueError, with file and line, for
    anything that is faulty or not simulated.
    """
    launch = _read_launch(path, args, skip_cpp, commands=False)
    return _read_launch(path, args, skip_cpp, commands=True) if commands else launch


def _read_launch(path: str | os.PathLike[str], args: Sequence[str], skip_cpp: bool, commands: bool) -> Launch:
    reader = _Reader(Path(path), skip_cpp, commands)
    reader.read(os.fspath(path), _Scope(os.fspath(path), args=load_mappings([*args])))
    for name, count in Counter(ns_join(node.namespace, node.name) for node in reader.nodes).items():
        if count > 1:
            raise ValueError(f"{os.fspath(path)}: there are several nodes named {name}")
    return Launch(reader.nodes, list(reader.parameters.items()), reader.left_out)


# --- what tags mean ---------------------------------------------------------------------------------------------------


@dataclass
class _Scope:
    """What applies to a tag because of its place in the files."""

    file: str
    namespace: str = "/"
    args: dict[str, str] = field(default_factory=dict)
    declared: set[str] = field(default_factory=set)  # names of args that have a tag in this file
    takes_all: bool = False  # whether the file is given all args of the one that includes it
    remaps: dict[str, str] = field(default_factory=dict)
    env: dict[str, str] = field(default_factory=dict)
    private: dict[str, Any] = field(default_factory=dict)  # parameters of the nodes to come

    def inner(self, namespace: str | None) -> _Scope:
        """Make a scope inside of this one: what is changed there does not apply here."""
        inner = deepcopy(self)
        if namespace:
            inner.namespace = make_global_ns(ns_join(self.namespace, namespace))
        return inner


# For each tag, how many attributes it must have, and the names of all, those first. Any tag may have "if" and "unless".
_ATTRIBUTES = {
    "arg": (1, "name value default doc"),
    "env": (2, "name value"),
    "group": (0, "ns clear_params"),
    "include": (1, "file ns clear_params pass_all_args"),
    "node": (3, "pkg type name args output respawn respawn_delay cwd ns clear_params required"),
    "param": (1, "name value type textfile command"),
    "remap": (2, "from to"),
    "rosparam": (0, "command file ns param"),
}

# Tags that are skipped, as by roslaunch, and attributes that do not affect a run.
_IGNORED = {"test", "master"}
_IDLE = {"doc", "clear_params"}

_TRUTHS = {"true": True, "1": True, "false": False, "0": False}


class _Reader:
    """Reads a launch file and those that it includes."""

    def __init__(self, path: Path, skip_cpp: bool, commands: bool) -> None:
        self.nodes: list[Node] = []
        self.parameters: dict[str, Any] = {}
        self.left_out: list[str] = []
        self._library = Library(1, path.absolute().parent)
        self._skip_cpp = skip_cpp
        self._commands = commands
        self._includes: list[str] = []  # the <include> tags that lead to the file that is being read

    def read(self, path: str, scope: _Scope) -> None:
        """Read a file in a scope."""
        self._read_all(parse(path).children, scope)

    def _read_all(self, tags: Sequence[Tag], scope: _Scope, known: Sequence[str] = (*_ATTRIBUTES, *_IGNORED)) -> None:
        for tag in tags:
            if tag.name not in known:
                raise tag.fault(f"<{tag.name}> is not simulated")
            if tag.name not in _IGNORED:
                try:
                    values = self._attributes(tag, scope)
                    if values is not None:
                        getattr(self, f"_read_{tag.name}")(tag, scope, **values)
                except _Fault as error:
                    raise tag.fault(str(error)) from None
                except OSError as error:
                    if error.filename2 is None:  # else a tag of an included file has said where
                        place = f"{error.strerror} ({tag.file}:{tag.line})"
                        raise type(error)(error.errno, place, error.filename, None, tag.file) from None
                    raise

    def _attributes(self, tag: Tag, scope: _Scope) -> dict[str, str] | None:
        """Return a tag's attributes, with substitutions made; None if its "if" or "unless" leaves the tag out."""
        needed, names = _ATTRIBUTES[tag.name][0], _ATTRIBUTES[tag.name][1].split()
        found = {
            name: self._resolve(value, scope) for name, value in tag.attributes.items() if name in ("if", "unless")
        }
        if len(found) == 2:
            raise _Fault(f"<{tag.name}> has both if and unless")
        for name, value in found.items():
            if _truth(value, name) != (name == "if"):
                return None
        for name in tag.attributes:
            if name not in (*names, "if", "unless"):
                raise _Fault(f'<{tag.name} {name}="..."> is not simulated')
        for name in names[:needed]:
            if name not in tag.attributes:
                raise _Fault(f"<{tag.name}> lacks {name}")
        passed_over = _IDLE | found.keys()
        return {name: self._resolve(text, scope) for name, text in tag.attributes.items() if name not in passed_over}

    def _read_group(self, tag: Tag, scope: _Scope, ns: str | None = None) -> None:
        self._read_all(tag.children, scope.inner(ns))

    def _read_arg(
        self, tag: Tag, scope: _Scope, name: str, value: str | None = None, default: str | None = None
    ) -> None:
        if value is not None and default is not None:
            raise _Fault(f"arg {name} has both value and default")
        if name in scope.declared and not scope.takes_all:
            raise _Fault(f"arg {name} is declared a second time")
        if value is not None and name in scope.args and not scope.takes_all:
            raise _Fault(f"arg {name} has a fixed value, and cannot be set")
        scope.declared.add(name)
        if value is not None:
            scope.args[name] = value
        elif default is not None:
            scope.args.setdefault(name, default)

    def _read_include(
        self, tag: Tag, scope: _Scope, file: str, ns: str | None = None, pass_all_args: str = "false"
    ) -> None:
        inner = scope.inner(ns)
        takes_all = _truth(pass_all_args, "pass_all_args")
        passed = replace(
            inner,
            args=dict(scope.args) if takes_all else {},
            declared=set(),
            takes_all=takes_all,
            private=scope.private,  # what the file adds also applies after it
        )
        for child in tag.children:
            values = self._attributes(child, scope) if child.name in ("arg", "env") else None
            if child.name == "arg" and values:
                self._read_arg(child, passed, **values)
            elif child.name == "env" and values:
                self._read_env(child, passed, **values)
            elif child.name not in ("arg", "env"):
                raise child.fault(f"<{child.name}> has no place in <include>")
        if lacking := passed.declared - passed.args.keys():
            raise _Fault(f"arg {lacking.pop()} is given no value")
        given = passed.declared
        passed = replace(passed, file=file, declared=set())
        self._includes.append(f"{tag.file}:{tag.line}")
        if len(self._includes) > _DEEPEST:
            chain = " -> ".join(self._includes[-3:])
            raise _Fault(f"files include one another without end: {chain} -> ...")
        self.read(file, passed)
        self._includes.pop()
        if not takes_all and (unused := given - passed.declared):
            raise _Fault(f"{file} has no arg {', '.join(sorted(unused))}")

    def _read_remap(self, tag: Tag, scope: _Scope, **names: str) -> None:
        scope.remaps.pop(names["from"], None)
        scope.remaps[names["from"]] = names["to"]

    def _read_env(self, tag: Tag, scope: _Scope, name: str, value: str) -> None:
        scope.env[name] = value

    def _read_param(
        self,
        tag: Tag,
        scope: _Scope,
        name: str,
        value: str | None = None,
        type: str = "auto",
        textfile: str | None = None,
        command: str | None = None,
        private: bool = False,
    ) -> None:
        if [value, textfile, command].count(None) != 2:
            raise _Fault(f"param {name} needs one of value, textfile and command")
        if value is not None:
            text = value.strip()
        elif textfile is not None:
            text = _read(textfile)
        else:
            words = _words(command or "", "command")
            if not self._commands:
                return
            text = _output(words, command or "", name)
        found = _convert(text, type.lower().strip(), name)
        _check_values(found, name)
        name = name.strip()
        if private or name.startswith(PRIV_NAME):
            scope.private.pop(name, None)
            scope.private[name] = found
        else:
            self._set(ns_join(scope.namespace, name), found)

    def _set(self, name: str, value: Any) -> None:
        if isinstance(value, dict):
            for key, item in value.items():
                self._set(ns_join(name, key), item)
        else:
            name = canonicalize_name(name)
            self.parameters.pop(name, None)
            self.parameters[name] = value

    def _read_rosparam(
        self, tag: Tag, scope: _Scope, command: str = "load", file: str | None = None, ns: str = "", param: str = ""
    ) -> None:
        if command != "load":
            raise _Fault(f'<rosparam command="{command}"> is not simulated')
        text = tag.text if file is None else _read(file)
        data = _yaml(text, file or "rosparam")
        _check_values(data, file or "rosparam")
        name = ns_join(ns, param)
        if not name and not isinstance(data, dict):
            raise _Fault("rosparam needs a param for a value that is not a dictionary")
        self._set(ns_join(scope.namespace, name) if name else scope.namespace, data)

    def _read_node(
        self,
        tag: Tag,
        scope: _Scope,
        pkg: str,
        type: str,
        name: str,
        args: str = "",
        output: str = "log",
        respawn: str = "false",
        respawn_delay: str = "0",
        cwd: str = "ROS_HOME",
        ns: str | None = None,
        required: str = "false",
    ) -> None:
        if "/" in name:
            raise _Fault(f"the name of a node cannot contain a namespace: {name}")
        if output not in ("screen", "log"):
            raise _Fault(f"output is screen or log, not {output}")
        if cwd not in ("ROS_HOME", "ros_home", "node"):
            raise _Fault(f"cwd is ROS_HOME or node, not {cwd}")
        inner = scope.inner(ns)
        own = replace(inner, namespace=make_global_ns(ns_join(inner.namespace, name)), private={})
        for child in tag.children:
            if child.name == "param":
                values = self._attributes(child, own)
                if values is not None:
                    self._read_param(child, own, private=True, **values)
            else:
                self._read_all([child], own, ("remap", "env", "rosparam"))
        for key, value in (*inner.private.items(), *own.private.items()):
            self._set(own.namespace + key.removeprefix(PRIV_NAME), value)
        file = self._find_node(pkg, type)
        if file is None:
            self.left_out.append(f"{tag.file}:{tag.line}: {pkg}/{type} is left out")
            return
        node = Node(
            str(file),
            [*_words(args, "args"), *(f"{source}:={target}" for source, target in own.remaps.items())],
            name,
            inner.namespace,
            _truth(required, "required"),
            _truth(respawn, "respawn"),
            _number(respawn_delay, "respawn_delay"),
            output,
            str(file.parent) if cwd == "node" else "",
            own.env,
        )
        if node.required and node.respawn:
            raise _Fault("a node cannot be both required and started again")
        self.nodes.append(node)

    # --- packages ---

    def _package(self, name: str) -> Path:
        folder = self._library.package(name)
        if folder is None:
            raise _Fault(f"there is no package {name} around this file")
        return folder

    def _find_node(self, package: str, kind: str) -> Path | None:
        """Return the file of a node; None if it should be left out."""
        folder = self._library.package(package)
        if folder is None:
            if self._skip_cpp:
                return None
            raise _Fault(f"there is no package {package} around this file; --skip-cpp leaves its node {kind} out")
        if file := find_python(folder, kind):
            return file
        source = find_cpp(folder, kind)
        if not (source or is_cpp(folder, kind)):
            raise _Fault(f"there is no node {kind} in package {package}")
        if source or self._skip_cpp:
            return None if self._skip_cpp else source
        raise _Fault(f"{package}/{kind} is a C++ node whose source is not there; --skip-cpp leaves it out")

    # --- substitutions ---

    def _resolve(self, text: str, scope: _Scope) -> str:
        """Replace $(find PKG) and the like. Raises _Fault."""
        if text.startswith("$(eval "):
            raise _Fault("$(eval) is not simulated")
        text = re.sub(r"\$\(([^()$]*)\)", lambda match: self._substitute(match[0], match[1].split(), scope), text)
        if "$(" in text:
            raise _Fault(f"{text}: a substitution in another one, or one that is not closed")
        return text

    def _substitute(self, whole: str, words: list[str], scope: _Scope) -> str:
        match words:
            case ["env", name]:
                if name not in os.environ:
                    raise _Fault(f"the environment variable {name} is not set")
                return os.environ[name]
            case ["optenv", name, *default]:
                return os.environ.get(name, " ".join(default))
            case ["arg", name]:
                if name not in scope.args:
                    raise _Fault(f"arg {name} has no value; give it one: {name}:=...")
                return scope.args[name]
            case ["find", name]:
                return str(self._package(name))
            case ["anon", name]:
                return f"{name}_anonymous"  # roslaunch makes it different each time; here runs are the same each time
            case ["dirname"]:
                return os.path.dirname(os.path.abspath(scope.file))
        raise _Fault(f"{whole} is no substitution")


class _Fault(ValueError):
    """What is wrong with the tag that is being read."""


def _read(path: str) -> str:
    """Read the text of a file. Raises OSError and _Fault."""
    try:
        return Path(path).read_text(encoding="utf-8")
    except UnicodeDecodeError as error:
        raise _Fault(f"{path} is not UTF-8: {error}") from None


def _output(words: Sequence[str], command: str, name: str) -> str:
    """Run the words of a command, and return what it prints on stdout. Raises _Fault."""
    import subprocess

    try:
        process = subprocess.run(words, stdout=subprocess.PIPE, encoding="utf-8")
    except (OSError, IndexError):
        raise _Fault(f"param {name}: there is no command {command!r}") from None
    except UnicodeDecodeError as error:
        raise _Fault(f"param {name}: what {command!r} prints is not UTF-8: {error}") from None
    if process.returncode:
        raise _Fault(f"param {name}: the command {command!r} ended with status {process.returncode}")
    return process.stdout


def _words(text: str, name: str) -> list[str]:
    """Split a command line into words. Raises _Fault."""
    try:
        return shlex.split(text)
    except ValueError as error:
        raise _Fault(f"{name} is no command line: {str(error).lower()} in {text!r}") from None


def _truth(text: str, name: str) -> bool:
    try:
        return _TRUTHS[text.strip().lower()]
    except KeyError:
        raise _Fault(f"{name} is true or false, not {text!r}") from None


def _number(text: str, name: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise _Fault(f"{name} is a number, not {text!r}") from None


def _convert(text: str, kind: str, name: str) -> Any:
    """Read a parameter's value as the type ``kind``; "auto" is what it looks like: int, float, bool or str."""
    if kind == "auto":
        if text.lower() in ("true", "false"):
            return text.lower() == "true"
        try:
            return float(text) if "." in text else text if "_" in text else int(text)
        except ValueError:
            return text
    if kind in ("str", "string"):
        return text
    if kind in ("bool", "boolean"):
        return _truth(text, name)
    if kind == "yaml":
        return _yaml(text, name)
    if kind not in ("int", "double"):
        raise _Fault(f"type is auto, str, int, double, bool or yaml, not {kind}")
    try:
        return int(text) if kind == "int" else float(text)
    except ValueError:
        raise _Fault(f"{name} is of type {kind}, and cannot be {text!r}") from None


def _yaml(text: str, name: str) -> Any:
    import yaml  # only needed where there is some

    try:
        data = yaml_texts.load(text)
    except yaml.YAMLError as error:
        raise _Fault(f"{name} is not YAML: {error}") from None
    except ValueError as error:  # a date such as 2024-13-01
        raise _Fault(f"{name} has a value that YAML cannot read: {str(error).partition(';')[0]}") from None
    return {} if data is None else data


def _check_values(data: Any, name: str) -> None:
    """Raise _Fault if ROS's parameter server would not take a value, such as one that contains itself."""
    from xmlrpc.client import dumps  # only needed where there are parameters

    try:
        dumps((data,))
    except (TypeError, OverflowError) as error:
        raise _Fault(f"{name} has a value that ROS's parameter server does not take: {error}") from None
