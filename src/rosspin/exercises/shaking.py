"""Give the threads of a node their turns where a lock is missing.

Simulated threads give way to each other only where they wait, so a node can lack a lock and never show it. A shaken
node also gives way between any two of its statements, and within them: after each value that it has looked up or
calculated, which is where a real thread may lose its turn before it uses the value.
"""

from __future__ import annotations

import ast
import builtins
import random
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from ..world.world import current_world

__all__ = ["shake", "turns"]

# The function by which a shaken node gives way. No answer has this name.
_GIVE_WAY = "__give_way__"

# Left as they are: annotations, which other code reads; patterns, which are no expressions; and the types after
# ``except``, which are evaluated even while a run is being ended.
_LEFT = ("annotation", "returns", "pattern", "type", "type_params")


def shake(source: str) -> ast.Module:
    """Make the code of a node give way. Run it within :func:`turns`."""
    tree = ast.parse(source)
    _Shaker().visit(tree)
    return ast.fix_missing_locations(tree)


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
            node.value = _give_way(node.value)
        for name in ("body", "orelse", "finalbody"):
            statements = getattr(node, name, None)
            # A module's docstring and its __future__ imports have to stay first.
            if isinstance(statements, list) and not isinstance(node, ast.Module):
                shaken = [each for statement in statements for each in (ast.Expr(_give_way()), statement)]
                setattr(node, name, shaken)
        return node

    def _value(self, node: ast.expr) -> ast.expr:
        self.generic_visit(node)
        return _give_way(node) if isinstance(getattr(node, "ctx", ast.Load()), ast.Load) else node

    visit_Attribute = visit_Subscript = visit_Call = visit_BinOp = _value


def _give_way(*value: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(_GIVE_WAY, ast.Load()), list(value), [])


@contextmanager
def turns(seed: int | None) -> Iterator[None]:
    """Let a shaken node give way within this context; ``seed`` decides how often at each place.

    Without a seed nothing is shaken.
    """
    if seed is None:
        yield
        return
    draw = random.Random(seed)

    def give_way(value: Any = None) -> Any:
        for _ in range(draw.choice((0, 0, 1, 2))):
            current_world().clock.sleep(0)
        return value

    setattr(builtins, _GIVE_WAY, give_way)
    try:
        yield
    finally:
        delattr(builtins, _GIVE_WAY)
