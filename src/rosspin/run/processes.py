"""The processes of several nodes inside of this one: whoever has its turn finds what is its own."""

from __future__ import annotations

import io
import logging
import os
import sys
import warnings
from collections.abc import Callable, Iterable, Mapping
from contextlib import ExitStack
from operator import attrgetter
from types import ModuleType
from typing import Any

from ..clocks.patches import Patch, patched
from ..clocks.stacks import Program, telling_turns
from ..messages import MessageFinder
from .process import Node, folder_of, kept_in_order

__all__ = ["Processes"]

# What the module sys keeps once for a process, and each node has for itself.
_of_sys = attrgetter("argv", "path", "meta_path", "excepthook", "unraisablehook", "stdin", "stdout", "stderr")

# Modules that each node has for itself, whoever has imported them before it; random, because a node may seed it.
_OWN_MODULES = ("__main__", "random")

_chdir = os.chdir


class _Process:
    """What one process has for itself, to be put in place when it has its turn."""

    def __init__(self) -> None:
        """As this process is now."""
        self.finder: MessageFinder | None = None
        self.folder = os.getcwd()
        self.modules = {name: sys.modules[name] for name in _OWN_MODULES if name in sys.modules}
        self.keep()

    def keep(self) -> None:
        """Keep what is in place now; this and the next are done at each turn, and have to be quick."""
        self.of_sys = _of_sys(sys)
        self.environment: dict[bytes, bytes] = os.environ._data  # type: ignore[attr-defined]
        self.filters = warnings.filters
        self.root_logger = logging.root.__dict__
        self.loggers = logging.root.manager.loggerDict

    def put_in_place(self) -> None:
        """Put in place what was kept."""
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
        os.environ._data = self.environment  # type: ignore[attr-defined]
        warnings.filters = self.filters
        logging.root.__dict__ = self.root_logger
        logging.root.manager.loggerDict = self.loggers


class Processes:
    """The processes of the nodes of one run, as a context.

    A node has for itself what it imports from its own folder, and messages. All other modules are shared by all:
    ``stand_ins``, which they find by these names, the standard library, and what is installed.
    """

    def __init__(self, nodes: Iterable[Node], stand_ins: Mapping[str, ModuleType]) -> None:
        self._stand_ins = stand_ins
        self._neighbours = {name for node in nodes for name in _neighbours(node.folder)}
        self._of: dict[Program, _Process] = {}
        self._differ = False  # whether their environments may

    def __enter__(self) -> Processes:
        with ExitStack() as stack:
            stack.enter_context(kept_in_order())
            self._outside = self._current = _Process()
            self._replaced = {name: sys.modules[name] for name in self._stand_ins if name in sys.modules}
            sys.modules.update(self._stand_ins)
            self._shared = {*sys.modules, *_OWN_MODULES}
            self._neighbours -= {name.partition(".")[0] for name in self._shared}
            self._count = len(sys.modules)
            stack.callback(self._put_back)
            stack.enter_context(patched(self._patches()))
            stack.enter_context(telling_turns(self.turn))
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *error: Any) -> None:
        self._stack.__exit__(*error)

    def _put_back(self) -> None:
        self._go_on(self._outside)
        for name in self._stand_ins:
            del sys.modules[name]
        sys.modules.update(self._replaced)

    def add(
        self,
        program: Program,
        node: Node,
        argv: list[str],
        ros: int,
        environment: Mapping[str, str],
        folder: str = "",
        quiet: bool = False,
    ) -> None:
        """Make the process in which ``program`` is to run a node.

        ``environment`` is added to that of this process, and ``folder`` is where it begins, if not where this process
        is. With ``quiet`` its stdout is for nobody.
        """
        self._go_on(self._outside)
        process = self._of[program] = _Process()
        process.finder = MessageFinder(ros, folder_of(node))
        process.folder = os.path.abspath(folder)
        process.modules.pop("random", None)
        added = {os.fsencode(name): os.fsencode(value) for name, value in environment.items()}
        root = vars(logging.root)
        process.of_sys = (
            argv,
            [*([] if node.folder is None else [node.folder]), *sys.path],
            [process.finder, *sys.meta_path],
            sys.__excepthook__,
            sys.__unraisablehook__,
            sys.stdin,
            _nowhere() if quiet else sys.stdout,
            sys.stderr,
        )
        process.environment = {**process.environment, **added}
        self._differ = self._differ or bool(added)
        process.filters = list(warnings.filters)
        process.root_logger = {**root, "handlers": root["handlers"][:], "filters": root["filters"][:], "_cache": {}}
        process.loggers = dict(process.loggers)
        hidden = process.finder.hide()
        self._replaced.update(hidden)
        self._shared.difference_update(hidden)
        self._count = len(sys.modules)

    def remove(self, program: Program) -> None:
        """Nothing more runs for ``program``."""
        del self._of[program]

    def turn(self, program: Program) -> None:
        """It is the program's turn. One that is no node finds what is there."""
        process = self._of.get(program)
        if process is not None and process is not self._current:
            self._go_on(process)

    def _go_on(self, process: _Process) -> None:
        before, self._current = self._current, process
        before.keep()
        modules = sys.modules
        own = before.modules
        if len(modules) != self._count:
            own = before.modules = {name: modules[name] for name in modules if self._is_own(name, before)}
        for name in own:
            own[name] = modules.pop(name, own[name])
        modules.update(process.modules)
        self._count = len(modules)
        process.put_in_place()
        if process.folder != before.folder:
            _chdir(process.folder)
        if self._differ and process.environment != before.environment:
            _export(before.environment, process.environment)

    def _is_own(self, module: str, process: _Process) -> bool:
        if module in self._shared:
            return module in _OWN_MODULES
        package = module.partition(".")[0]
        return package in self._neighbours or (process.finder is not None and package in process.finder.found)

    def _patches(self) -> list[Patch]:
        def noted(real: Callable[[Any], None]) -> Callable[[Any], None]:
            def chdir(path: Any) -> None:
                real(path)
                self._current.folder = os.getcwd()

            return chdir

        def changing(real: Callable[..., None]) -> Callable[..., None]:
            def change(*words: Any) -> None:
                self._differ = True
                real(*words)

            return change

        return [
            *((os, name, noted) for name in ("chdir", "fchdir")),
            *((os, name, changing) for name in ("putenv", "unsetenv")),
        ]


def _neighbours(folder: str | None) -> list[str]:
    """The names under which a node can import what lies beside it."""
    return [] if folder is None else [name.partition(".")[0] for name in os.listdir(folder)]


def _export(before: Mapping[bytes, bytes], after: Mapping[bytes, bytes]) -> None:
    """Give the environment to the programs that are started from here, which take it from the system."""
    for name in before.keys() - after.keys():
        os.unsetenv(name)
    for name, value in after.items():
        if before.get(name) != value:
            os.putenv(name, value)


class _Null(io.BufferedIOBase):
    def writable(self) -> bool:
        return True

    def write(self, data: Any) -> int:
        return len(data)


def _nowhere() -> io.TextIOWrapper:
    null: Any = _Null()
    return io.TextIOWrapper(null, encoding="utf-8", errors="backslashreplace")
