"""Texts of a launch file that are known only when it runs (sources: launch/substitutions, launch/utilities)."""

from __future__ import annotations

import importlib
import math
import os
import re
from collections.abc import Callable, Iterable
from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING, Any, get_args

if TYPE_CHECKING:
    from .context import LaunchContext

from ...world import yaml_texts

__all__ = [
    *("AndSubstitution", "EnvironmentVariable", "EqualsSubstitution", "ExecutableInPackage", "FindPackageShare"),
    *("IfElseSubstitution", "LaunchConfiguration", "NotEqualsSubstitution", "NotSubstitution", "OrSubstitution"),
    *("PathJoinSubstitution", "PythonExpression", "Substitution", "SubstitutionFailure", "TextSubstitution"),
    *("ThisLaunchFile", "ThisLaunchFileDir", "coerce", "is_of", "is_substitution", "listed", "parse_substitution"),
    *("perform", "perform_typed"),
]


class SubstitutionFailure(RuntimeError):
    """A substitution cannot be made."""


class Substitution:
    """Stands for a text: :meth:`perform` gives it."""

    def perform(self, context: LaunchContext) -> str:
        raise NotImplementedError


def listed(some: Any) -> list[Substitution]:
    """Make a list of substitutions of a text, a substitution or several. Raises TypeError for anything else."""
    some = [some] if isinstance(some, (str, Substitution)) else list(some)
    for each in some:
        if not isinstance(each, (str, Substitution)):
            expected = "when only 'str' or 'launch.Substitution' were expected."
            raise TypeError(f"Failed to normalize given item of type '{type(each)}', {expected}")
    return [TextSubstitution(text=each) if isinstance(each, str) else each for each in some]


def perform(context: LaunchContext, some: Any) -> str:
    """Return the text of what :func:`listed` takes."""
    return "".join(each.perform(context) for each in listed(some))


def is_substitution(value: Any) -> bool:
    """Whether a value stands for one text that is not known yet."""
    if isinstance(value, (list, tuple)):
        known = [isinstance(each, str) for each in value]
        return not all(known) and all(isinstance(each, (str, Substitution)) for each in value)
    return isinstance(value, Substitution)


# --- values with a type -----------------------------------------------------------------------------------------------


def coerce(text: str, kind: Any) -> Any:
    """Read a text as a value of the type ``kind``: bool, int, float, str, a list of these, or what YAML makes of it.

    Raises ValueError.
    """
    if kind is str or (kind is None and not text):
        return text
    if kind in (int, float):
        return kind(text)
    import yaml  # only needed where there are such values

    try:
        value = yaml_texts.load({"1": "true", "0": "false"}.get(text, text) if kind is bool else text)
    except yaml.YAMLError as error:
        raise ValueError(f"Failed to convert '{text}' using yaml rules: yaml.safe_load() failed\n{error}") from None
    if not is_of(value, kind):
        raise ValueError(f"Cannot convert value '{text}' to '{kind or 'a value of a parameter'}'")
    return value


def is_of(value: Any, kind: Any) -> bool:
    """Whether a value is of a type; if that is None, of any that a parameter can have."""
    if kind is not None and isinstance(value, list) != bool(get_args(kind)):
        return False
    items = value if isinstance(value, list) else [value]
    of = get_args(kind) or kind or (bool, int, float, str)
    return len({type(each) for each in items}) < 2 and all(isinstance(each, of) for each in items)


def perform_typed(context: LaunchContext, value: Any, kind: Any) -> Any:
    """Make the substitutions in a value that is of a type, or that stands for one. Raises TypeError and ValueError."""
    if is_substitution(value):
        return coerce(perform(context, value), kind)
    if isinstance(value, (list, tuple)):
        of = get_args(kind)[0] if get_args(kind) else None
        value = [coerce(perform(context, each), of) if is_substitution(each) else each for each in value]
        if {type(each) for each in value} == {int, float}:
            value = [float(each) for each in value]
    if not is_of(value, kind):
        raise TypeError(f"value='{value}' is not an instance of {kind}")
    return value


# --- substitutions ----------------------------------------------------------------------------------------------------


@dataclass(eq=False)
class TextSubstitution(Substitution):
    _: KW_ONLY
    text: str

    def perform(self, context: LaunchContext) -> str:
        return self.text


@dataclass(eq=False)
class LaunchConfiguration(Substitution):
    variable_name: Any
    _: KW_ONLY
    default: Any = None

    def perform(self, context: LaunchContext) -> str:
        name = perform(context, self.variable_name)
        if name in context.launch_configurations:
            return str(context.launch_configurations[name])
        if self.default is None:
            raise SubstitutionFailure(f"launch configuration '{name}' does not exist")
        items = self.default if isinstance(self.default, Iterable) else [self.default]
        return perform(context, [each if isinstance(each, Substitution) else str(each) for each in items])


@dataclass(eq=False)
class EnvironmentVariable(Substitution):
    name: Any
    _: KW_ONLY
    default_value: Any = None

    def perform(self, context: LaunchContext) -> str:
        name = perform(context, self.name)
        if name in context.environment:
            return context.environment[name]
        if self.default_value is None:
            raise SubstitutionFailure(f"environment variable '{name}' does not exist")
        return perform(context, self.default_value)


@dataclass(eq=False)
class PathJoinSubstitution(Substitution):
    substitutions: Any

    def perform(self, context: LaunchContext) -> str:
        return os.path.join(*(each.perform(context) for each in listed(self.substitutions)))


@dataclass(eq=False)
class PythonExpression(Substitution):
    expression: Any
    python_modules: Any = ("math",)

    def perform(self, context: LaunchContext) -> str:
        names = [each.perform(context) for each in listed(self.python_modules)]
        known = {name: importlib.import_module(name) for name in names}
        return str(eval(perform(context, self.expression), {}, {**(vars(math) if "math" in known else {}), **known}))


class ThisLaunchFile(Substitution):
    _local = "current_launch_file_path"

    def perform(self, context: LaunchContext) -> str:
        if self._local not in context.known:
            raise SubstitutionFailure(f"{type(self).__name__} used outside of a launch file (in a script)")
        return str(context.known[self._local])


class ThisLaunchFileDir(ThisLaunchFile):
    _local = "current_launch_file_directory"


@dataclass(eq=False)
class FindPackageShare(Substitution):
    package: Any

    def perform(self, context: LaunchContext) -> str:
        return str(context.service.package(perform(context, self.package)))


@dataclass(eq=False)
class ExecutableInPackage(Substitution):
    executable: Any
    package: Any

    def perform(self, context: LaunchContext) -> str:
        package = perform(context, self.package)
        return os.path.join(context.service.package(package), "lib", package, perform(context, self.executable))


@dataclass(eq=False)
class IfElseSubstitution(Substitution):
    condition: Any
    if_value: Any = ""
    else_value: Any = ""

    def perform(self, context: LaunchContext) -> str:
        return perform(context, self.if_value if _truth(context, self.condition) else self.else_value)


@dataclass(eq=False)
class NotSubstitution(Substitution):
    value: Any

    def perform(self, context: LaunchContext) -> str:
        return _word(not _truth(context, self.value))


@dataclass(eq=False)
class AndSubstitution(Substitution):
    left: Any
    right: Any
    _join = all

    def perform(self, context: LaunchContext) -> str:
        return _word(type(self)._join([_truth(context, each) for each in (self.left, self.right)]))


class OrSubstitution(AndSubstitution):
    _join = any


@dataclass(eq=False)
class EqualsSubstitution(Substitution):
    left: Any
    right: Any
    _wanted = True

    def perform(self, context: LaunchContext) -> str:
        return _word(self._are_equal(context) == self._wanted)

    def _are_equal(self, context: LaunchContext) -> bool:
        left, right = (_text(context, each) for each in (self.left, self.right))
        truths = {"true": True, "1": True, "false": False, "0": False}
        if left.lower() in truths and right.lower() in truths:
            return truths[left.lower()] == truths[right.lower()]
        try:
            return math.isclose(float(left), float(right))
        except ValueError:
            return left == right


class NotEqualsSubstitution(EqualsSubstitution):
    _wanted = False


def _text(context: LaunchContext, value: Any) -> str:
    if is_substitution(value):
        return perform(context, value)
    return "" if value is None else _word(value) if isinstance(value, bool) else str(value)


def _truth(context: LaunchContext, some: Any) -> bool:
    try:
        return bool(perform_typed(context, listed(some), bool))
    except ValueError as error:
        raise SubstitutionFailure(error) from None


def _word(truth: bool) -> str:
    return str(truth).lower()


# --- in a text --------------------------------------------------------------------------------------------------------


def parse_substitution(text: str) -> list[Any]:
    """Find each ``$(name arguments)`` in a text (source: launch/frontend/grammar.lark). Raises RuntimeError."""
    return _parse(text, 0, "")[0] or [TextSubstitution(text="")]


def _parse(text: str, at: int, end: str) -> tuple[list[Any], int]:
    """Read from ``at`` on, up to one of the characters in ``end``."""
    parts: list[Any] = []
    while at < len(text) and text[at] not in end:
        if text.startswith("$(", at):
            part, at = _parse_one(text, at)
            parts.append(part)
        else:
            stop = f"|[{end}]" if end else ""
            piece = re.compile(rf"(\\.|(?!\$\({stop})[\s\S])+").match(text, at)
            assert piece
            parts.append(TextSubstitution(text=re.sub(r"\\(.)", r"\1", piece[0])))
            at = piece.end()
    return parts, at


def _parse_one(text: str, start: int) -> tuple[Any, int]:
    name = re.compile(r"\$\(([a-zA-Z][\w-]*)").match(text, start)
    if not name:
        raise RuntimeError(f"there is no name after $( in {text!r}")
    arguments, at = [], name.end()
    while text[at : at + 1] == " ":
        quote = text[at + 1 : at + 2]
        is_quoted = quote in ("'", '"')
        argument, at = _parse(text, at + 1 + is_quoted, quote if is_quoted else " )")
        arguments.append(argument)
        at += is_quoted
    if text[at : at + 1] != ")":
        raise RuntimeError(f"{text[start:]!r} is not closed")
    if name[1] not in _BY_NAME:
        raise RuntimeError(f"Unknown substitution: {name[1]}")
    counts, make = _BY_NAME[name[1]]
    if len(arguments) not in counts:
        numbers = " or ".join(map(str, counts))
        raise RuntimeError(f"{name[1]} substitution expects {numbers} argument{'' if counts[-1] == 1 else 's'}")
    return make(*arguments), at + 1


# How many arguments each may have.
_BY_NAME: dict[str, tuple[tuple[int, ...], Callable[..., Substitution]]] = {
    "var": ((1, 2), lambda name, default=None: LaunchConfiguration(name, default=default)),
    "env": ((1, 2), lambda name, default=None: EnvironmentVariable(name, default_value=default)),
    "dirname": ((0,), ThisLaunchFileDir),
    "filename": ((0,), ThisLaunchFile),
    "find-pkg-share": ((1,), FindPackageShare),
    "eval": ((1,), PythonExpression),
    "not": ((1,), NotSubstitution),
    "and": ((2,), AndSubstitution),
    "or": ((2,), OrSubstitution),
    "equals": ((2,), EqualsSubstitution),
    "not-equals": ((2,), NotEqualsSubstitution),
    "if": ((1, 2, 3), IfElseSubstitution),
}
