"""Let the threads of a node change wherever real ones could: between its statements, and within them.

Simulated threads give way to each other only where they wait, so a node can lack a lock and never show it. A shaken
node can also give way between any two of its statements, and after each value that it has looked up or calculated,
which is where a real thread may lose its turn before it uses the value.
"""

from __future__ import annotations

import ast
import sys
from functools import partial
from typing import Any

from ..clocks.explored import ExploredSimulation, Turn, name_of
from ..clocks.stacks import Stack, current
from .source import Node, execute

__all__ = ["shaken"]

# The function by which a shaken node gives way. No node has this name.
_GIVE_WAY = "__give_way__"

# Left as they are: annotations, which other code reads; patterns, which are no expressions; and the types after
# ``except``, which are evaluated even while a run is being ended.
_LEFT = ("annotation", "returns", "pattern", "type", "type_params")


def shaken(node: Node) -> Node:
    """Make a node give way where its run's order says so, and note the lines that it runs if they are wanted.

    Raises ValueError for a node that is a function: only a file can be read.
    """
    if node.source is None:
        raise ValueError(f"{node.name}: deep is for node files; a function cannot be shaken")
    tree = ast.fix_missing_locations(_Shaker().visit(ast.parse(node.source)))
    code = compile(tree, node.filename, "exec", dont_inherit=True)
    return node._replace(main=partial(execute, code, node.filename, {_GIVE_WAY: _give_way}))


def _give_way(value: Any = None) -> Any:
    stack = current()
    if isinstance(stack, Stack) and isinstance(clock := stack.clock, ExploredSimulation):
        order = clock.order
        if order.deep:
            clock.give_way()
        if order.turns is not None:
            frame = sys._getframe(1)
            order.turns.append(Turn(clock.now(), name_of(stack), frame.f_code.co_filename, frame.f_lineno))
    return value


class _Shaker(ast.NodeTransformer):
    """Makes code give way."""

    def generic_visit(self, node: ast.AST) -> ast.AST:
        left = {name: getattr(node, name) for name in _LEFT if hasattr(node, name)}
        for name in left:
            setattr(node, name, None)
        super().generic_visit(node)
        for name, value in left.items():
            setattr(node, name, value)
        if isinstance(node, (ast.Assign, ast.AugAssign, ast.AnnAssign, ast.NamedExpr)) and node.value:
            node.value = _after(node.value)
        for name in ("body", "orelse", "finalbody"):
            statements = getattr(node, name, None)
            # A module's __future__ imports have to stay first, and so do docstrings.
            if isinstance(statements, list) and not isinstance(node, ast.Module):
                shaken = [each for statement in statements for each in (_between(statement), statement)]
                setattr(node, name, shaken[_is_docstring(statements) :])
        return node

    def _value(self, node: ast.expr) -> ast.expr:
        self.generic_visit(node)
        return _after(node) if isinstance(getattr(node, "ctx", ast.Load()), ast.Load) else node

    visit_Attribute = visit_Subscript = visit_Call = visit_BinOp = _value


def _is_docstring(statements: list[ast.stmt]) -> bool:
    first = statements[0] if statements else None
    return isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)


def _between(statement: ast.stmt) -> ast.stmt:
    return ast.copy_location(ast.Expr(ast.copy_location(_call(), statement)), statement)


def _after(value: ast.expr) -> ast.expr:
    return ast.copy_location(_call(value), value)


def _call(*value: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(_GIVE_WAY, ast.Load()), list(value), [])
