"""Python expressions that others have written, evaluated within bounds: of steps, and of the size of what they make."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from types import GeneratorType
from typing import Any

__all__ = ["Unbounded", "evaluate"]

# So many steps, items, characters and bytes an expression may take in all.
_BUDGET = 1_000_000

# An expression is no longer than this, in characters: what it has in it is gone through without being counted.
_LONGEST = 10_000

# What makes of a text, or a number, something as long as one likes; and what repeats in it what it is given.
_WIDENS = {"center", "expandtabs", "ljust", "rjust", "to_bytes", "zfill"}
_REPEATS = {"format", "format_map", "join", "replace", "translate"}


class Unbounded(ValueError):
    """An expression takes too many steps, or makes something too large."""

    def __init__(self) -> None:
        super().__init__(f"takes more than {_BUDGET:,} steps or characters")


def evaluate(expression: str, names: Mapping[str, Any]) -> Any:
    """The value of an expression in which only these names are known.

    Raises :class:`Unbounded`, and whatever the expression raises; SyntaxError if it is none.
    """
    if len(expression) > _LONGEST:
        raise Unbounded
    tree = ast.fix_missing_locations(_Counting().visit(ast.parse(expression.strip(), mode="eval")))
    tally = _Tally()
    own = {"_count__": tally.count, "_each__": tally.each, "_call__": tally.call, "_work__": tally.work}
    return tally.count(eval(compile(tree, "<expression>", "eval"), {"__builtins__": {}, **own}, names))


class _Counting(ast.NodeTransformer):
    """Has an expression ask the tally before each thing that could be large, or be done often."""

    def visit_Name(self, node: ast.Name) -> ast.expr:
        return _ask("_count__", node) if isinstance(node.ctx, ast.Load) else node

    def visit_Call(self, node: ast.Call) -> ast.expr:
        self.generic_visit(node)
        return ast.Call(ast.Name("_call__", ast.Load()), [node.func, *node.args], node.keywords)

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        sides = ast.Tuple([node.left, node.right], ast.Load())
        parameters = ast.arguments([], [ast.arg("left"), ast.arg("right")], None, [], [], None, [])
        left, right = ast.Name("left", ast.Load()), ast.Name("right", ast.Load())
        does = ast.Lambda(parameters, ast.BinOp(left, node.op, right))
        return _ask("_work__", ast.Constant(type(node.op).__name__), sides, does)

    def visit_comprehension(self, node: ast.comprehension) -> ast.comprehension:
        self.generic_visit(node)
        node.iter = _ask("_each__", node.iter)
        return node

    def visit_Starred(self, node: ast.Starred) -> ast.Starred:
        self.generic_visit(node)
        node.value = _ask("_each__", node.value)
        return node

    def visit_FormattedValue(self, node: ast.FormattedValue) -> ast.FormattedValue:
        """The width in a format may be anything: it is left to str.format, which is counted."""
        self.generic_visit(node)
        if node.format_spec is None:
            return node
        convert = "" if node.conversion < 0 else f"!{chr(node.conversion)}"
        form = ast.Attribute(ast.Constant(f"{{0{convert}:{{1}}}}"), "format", ast.Load())
        return ast.FormattedValue(_ask("_call__", form, node.value, node.format_spec), -1, None)


def _ask(name: str, *values: ast.expr) -> ast.Call:
    return ast.Call(ast.Name(name, ast.Load()), list(values), [])


class _Tally:
    """Counts what an expression takes. Each method raises Unbounded as soon as that is too much."""

    def __init__(self) -> None:
        self._left = _BUDGET

    def _spend(self, amount: int) -> None:
        self._left -= amount
        if self._left < 0:
            raise Unbounded

    def count(self, value: Any) -> Any:
        """The value, whose size is counted."""
        self._size(value)
        return value

    def _size(self, value: Any) -> int:
        """How large a value is, with all that is in it; spent on the way, so that no walk is endless."""
        before, waiting = self._left, [value]
        while waiting:
            each = waiting.pop()
            self._spend(1)
            if isinstance(each, (str, bytes, bytearray)):
                self._spend(len(each))
            elif isinstance(each, int):
                self._spend(each.bit_length() // 8)
            elif isinstance(each, Mapping):
                self._spend(len(each))
                waiting += [*each.keys(), *each.values()]
            elif isinstance(each, (list, tuple, set, frozenset)):
                self._spend(len(each))
                waiting += each
        return before - self._left

    def each(self, values: Iterable[Any]) -> Iterator[Any]:
        """The values, each of which is a step."""
        for value in values:
            self._spend(1)
            yield value

    def work(self, operation: str, sides: tuple[Any, Any], does: Callable[[Any, Any], Any]) -> Any:
        """What an operator makes of two values."""
        left, right = sides
        sizes = [self._size(side) for side in sides]
        numbers = [_bounded(side) for side in sides if isinstance(side, int)]
        if operation == "Pow" and len(numbers) == 2:
            self._spend(left.bit_length() * numbers[1])
        elif operation == "LShift" and len(numbers) == 2:
            self._spend(numbers[1])
        elif operation == "Mult" and len(numbers) == 1:
            self._spend(numbers[0] * max(sizes))
        elif operation == "Mod" and isinstance(left, (str, bytes)):
            self._spend(sizes[0] * sizes[1] if isinstance(right, Mapping) else 0)
            forms = re.findall(r"%(?:\([^)]*\))?[-+ #0-9.*]*", str(left))
            self._widen(forms, right if any("*" in form for form in forms) else ())
        return does(left, right)

    def call(self, function: Callable[..., Any], *args: Any, **more: Any) -> Any:
        """What a function gives."""
        # What a generator gives can be counted only when it is there, and a function only when it is called.
        args = tuple(map(self._counted, args))
        more = {name: self._counted(value) for name, value in more.items()}
        sizes = sum(map(self._size, (*args, *more.values())), 1)
        name, owner, given = getattr(function, "__name__", ""), getattr(function, "__self__", None), args
        if args and hasattr(function, "__objclass__"):  # a method, called as one of its class
            owner, given = args[0], args[1:]
        if isinstance(owner, (str, bytes, int)):
            size = self._size(owner)
            if name in _REPEATS:
                self._spend(size * sizes)
            if name in _WIDENS:
                self._widen((), [number * size for number in _numbers([*given, *more.values()])])
            elif name in ("format", "format_map"):
                forms = re.findall(r"\{[^{}]*", str(owner))
                self._widen(forms, (given, more) if re.search(r"\{[^{}]*\{", str(owner)) else ())
        elif name in ("factorial", "comb", "perm"):
            numbers = list(_numbers(args))
            self._spend(min(numbers, default=0) * max(numbers, default=0).bit_length())
        return self.count(function(*args, **more))

    def _counted(self, value: Any) -> Any:
        if isinstance(value, (GeneratorType, map)):
            return list(self.each(value))
        if callable(value) and not isinstance(value, (type, partial)):
            return partial(self.call, value)
        return value

    def _widen(self, forms: Iterable[str], values: Any) -> None:
        """Count the widths that stand in forms, and those that are among values."""
        self._spend(sum(int(width[:9]) for form in forms for width in re.findall(r"\d+", form)))
        self._spend(sum(_numbers(values)))


def _bounded(number: int) -> int:
    return min(abs(number), _BUDGET + 1)


def _numbers(value: Any) -> Iterator[int]:
    """The numbers in a value, wherever they are in it, also those that are written in a text."""
    if isinstance(value, int):
        yield _bounded(value)
    elif isinstance(value, str):
        yield from (int(number[:9]) for number in re.findall(r"\d+", value))
    elif isinstance(value, Mapping):
        yield from _numbers(list(value.values()))
    elif isinstance(value, (list, tuple)):
        for each in value:
            yield from _numbers(each)
