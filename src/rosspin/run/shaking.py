"""Let the threads of a node change where real ones could.

Simulated threads give way to each other only where they wait, so a node can lack a lock and never show it. A shaken
node can also give way where Python can take its turn from a thread: in ROS 1, whose Python is 3.8, between any two
instructions, so here between statements and after each value that was looked up or calculated. From CPython 3.10 on,
as in ROS 2, that is where a function of the node begins, where a call has returned, and where a loop goes round:
``self.count += 1`` is not taken apart there, ``self.count += self.read()`` is. (Measured with CPython 3.8 to 3.13, with
a switch interval of a microsecond.)
"""

from __future__ import annotations

import ast
import sys
from functools import lru_cache, partial
from importlib.machinery import SourceFileLoader
from types import CodeType, ModuleType
from typing import Any

from ..clocks.explored import ExploredSimulation, Turn, name_of
from ..clocks.stacks import Stack, current
from .kinds import ROS
from .source import Code, program

__all__ = ["shaken"]

# The functions by which a shaken node gives way, and tells the line that it runs. No node has these names.
_GIVE_WAY = "__give_way__"
_TELL = "__tell__"

# Left as they are: annotations, which other code reads; patterns, which are no expressions; and the types after
# ``except``, which are evaluated even while a run is being ended.
_LEFT = ("annotation", "returns", "pattern", "type", "type_params")


def shaken(node: Code) -> Code:
    """Make a node give way where its run's order says so, and note the lines that it runs if they are wanted.

    So do the modules of its own that it imports: what lies next to it, or in its package. Raises ValueError for a node
    that is a function: only a file can be read.
    """
    if node.source is None:
        raise ValueError(f"{node.name}: deep is for node files; a function cannot be shaken")
    everywhere = bool(node.hint) and ROS[node.hint].timers_are_threads
    loader = partial(_Loader, everywhere)
    if node.is_entry_point:
        return node._replace(loader=loader)
    main = program(_shaken(node.source, node.filename, everywhere), node.filename, _NAMES)
    return node._replace(main=main, loader=loader)


@lru_cache(256)  # of the modules that each of a thousand runs imports again
def _shaken(source: str | bytes, filename: str, everywhere: bool) -> CodeType:
    tree = ast.fix_missing_locations(_Shaker(everywhere).visit(ast.parse(source, filename)))
    return compile(tree, filename, "exec", dont_inherit=True)


class _Loader(SourceFileLoader):
    """Loads a module of a shaken node from its source: what Python has kept of it compiled is not shaken."""

    def __init__(self, everywhere: bool, name: str, path: str) -> None:
        super().__init__(name, path)
        self._everywhere = everywhere

    def get_code(self, fullname: str) -> CodeType:
        return _shaken(self.get_data(self.path), self.path, self._everywhere)

    def exec_module(self, module: ModuleType) -> None:
        module.__dict__.update(_NAMES)
        super().exec_module(module)


def _give_way(value: Any = None) -> Any:
    stack = current()
    if isinstance(stack, Stack) and isinstance(clock := stack.clock, ExploredSimulation):
        if clock.order.deep:
            clock.give_way()
        _note(stack, clock)
    return value


def _tell() -> None:
    stack = current()
    if isinstance(stack, Stack) and isinstance(clock := stack.clock, ExploredSimulation):
        _note(stack, clock)


def _note(stack: Stack, clock: ExploredSimulation) -> None:
    if clock.order.turns is not None:
        frame = sys._getframe(2)
        clock.order.turns.append(Turn(clock.now(), name_of(stack), frame.f_code.co_filename, frame.f_lineno))


_NAMES = {_GIVE_WAY: _give_way, _TELL: _tell}


class _Shaker(ast.NodeTransformer):
    """Makes code give way: ``everywhere``, or only where CPython 3.10 and newer can."""

    def __init__(self, everywhere: bool) -> None:
        self._everywhere = everywhere

    def generic_visit(self, node: ast.AST) -> ast.AST:
        left = {name: getattr(node, name) for name in _LEFT if hasattr(node, name)}
        for name in left:
            setattr(node, name, None)
        super().generic_visit(node)
        for name, value in left.items():
            setattr(node, name, value)
        if self._everywhere and isinstance(node, (ast.Assign, ast.AugAssign, ast.AnnAssign, ast.NamedExpr)):
            node.value = node.value and _after(node.value)
        for name in ("body", "orelse", "finalbody"):
            statements = getattr(node, name, None)
            # A module's __future__ imports have to stay first, and so do docstrings.
            if isinstance(statements, list) and not isinstance(node, ast.Module):
                shaken = [each for statement in statements for each in (self._between(node, statement), statement)]
                if isinstance(node, (ast.For, ast.AsyncFor, ast.While)) and name == "body":
                    shaken.append(_call_at(_GIVE_WAY, statements[-1]))
                setattr(node, name, shaken[_is_docstring(statements) :])
        return node

    def _between(self, node: ast.AST, statement: ast.stmt) -> ast.stmt:
        begins = isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and statement is node.body[0]
        goes_round = isinstance(statement, ast.Continue)
        return _call_at(_GIVE_WAY if self._everywhere or begins or goes_round else _TELL, statement)

    def visit_Call(self, node: ast.Call) -> ast.AST:
        self.generic_visit(node)
        return _after(node)

    def _value(self, node: ast.expr) -> ast.AST:
        self.generic_visit(node)
        is_looked_up = isinstance(getattr(node, "ctx", ast.Load()), ast.Load)
        return _after(node) if self._everywhere and is_looked_up else node

    visit_Attribute = visit_Subscript = visit_BinOp = _value


def _is_docstring(statements: list[ast.stmt]) -> bool:
    first = statements[0] if statements else None
    return isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)


def _call_at(name: str, statement: ast.stmt) -> ast.stmt:
    return ast.copy_location(ast.Expr(ast.copy_location(_call(name), statement)), statement)


def _after(value: ast.expr) -> ast.expr:
    return ast.copy_location(_call(_GIVE_WAY, value), value)


def _call(name: str, *value: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(value), [])
