"""Texts of a launch file that are known only when it runs (source: launch/substitutions, launch/utilities)."""

from __future__ import annotations

import importlib
import math
import os
import re
from collections.abc import Iterable, Sequence
from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING, Any, get_args

if TYPE_CHECKING:
    from .context import LaunchContext

__all__ = [
    *("AllSubstitution", "AndSubstitution", "AnonName", "AnySubstitution", "EnvironmentVariable", "EqualsSubstitution"),
    *("FindPackageShare", "IfElseSubstitution", "LaunchConfiguration", "NotEqualsSubstitution", "NotSubstitution"),
    *("OrSubstitution", "PathJoinSubstitution", "PythonExpression", "Substitution", "SubstitutionFailure"),
    *("TextSubstitution", "ThisLaunchFile", "ThisLaunchFileDir", "coerce", "is_substitution", "listed"),
    *("parse_substitution", "perform", "perform_typed"),
]


class SubstitutionFailure(RuntimeError):
    """A substitution cannot be made."""


class Substitution:
    """Stands for a text: :meth:`perform` gives it."""

    def perform(self, context: LaunchContext) -> str:
        raise NotImplementedError


def listed(some: Any) -> list[Substitution]:
    """Make a list of substitutions of a text, a substitution or several. Raises TypeError for anything else."""
    if isinstance(some, (str, Substitution)):
        some = [some]
    for each in some:
        if not isinstance(each, (str, Substitution)):
            raise TypeError(
                f"Failed to normalize given item of type '{type(each)}', when only 'str' or 'launch.Substitution' "
                "were expected."
            )
    return [TextSubstitution(text=each) if isinstance(each, str) else each for each in some]


def perform(context: LaunchContext, some: Any) -> str:
    """The text of what :func:`listed` takes."""
    return "".join(each.perform(context) for each in listed(some))


def is_substitution(value: Any) -> bool:
    """Whether a value stands for one text that is not known yet."""
    if isinstance(value, (list, tuple)):
        return all(isinstance(each, (str, Substitution)) for each in value) and not all(
            isinstance(each, str) for each in value
        )
    return isinstance(value, Substitution)


# --- values with a type -----------------------------------------------------------------------------------------------

_SCALARS = (int, float, bool, str)


def _is_uniform(value: Any) -> bool:
    return isinstance(value, _SCALARS) or (
        isinstance(value, list) and all(type(each) is type(value[0]) and isinstance(each, _SCALARS) for each in value)
    )


def as_yaml(text: str, failed: str) -> Any:
    """Read a text as YAML. Raises ValueError, which begins with ``failed``."""
    import yaml  # only needed where there are such values

    if not text:
        return text
    try:
        value = yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise ValueError(f"{failed}: yaml.safe_load() failed\n{error}") from None
    if not _is_uniform(value):
        raise ValueError(f"{failed}: output type is not allowed, got {type(value)}")
    return value


def coerce(text: str, kind: Any) -> Any:
    """Read a text as an int, a float, a bool, a str, or a list of these; as YAML, if ``kind`` is None."""
    if kind is None:
        return as_yaml(text, f"Failed to convert '{text}' using yaml rules")
    if kind is str:
        return text
    if kind in (int, float):
        return kind(text)
    if kind is bool:
        value = as_yaml({"1": "true", "0": "false"}.get(text, text), f"Failed to convert '{text}' to '{kind}'")
        if not isinstance(value, bool):
            raise ValueError(f"Cannot convert value '{text}' to '{kind}'")
        return value
    (of,) = get_args(kind)
    failed = f"Cannot convert value '{text}' to a list of '{of}'"
    value = as_yaml(text, failed)
    if not isinstance(value, list):
        raise ValueError(failed)
    if not all(isinstance(each, of) for each in value):
        raise ValueError(f"{failed}, got {value}")
    return value


def perform_typed(context: LaunchContext, value: Any, kind: Any) -> Any:
    """Make the substitutions in a value that is of a type, or stands for one. Raises TypeError and ValueError."""
    if is_substitution(value):
        return coerce(perform(context, value), kind)
    of = get_args(kind)[0] if get_args(kind) else None
    if isinstance(value, Sequence) and not isinstance(value, str):
        if kind is not None and of is None:
            raise TypeError(
                "The provided value resolves to a list, though the required type is a scalar. "
                f"Got value='{value}', data_type='{kind}'."
            )
        items = [coerce(perform(context, each), of) if is_substitution(each) else each for each in value]
        if {type(each) for each in items} == {int, float}:
            items = [float(each) for each in items]
        if not _is_uniform(items) or (of and not all(isinstance(each, of) for each in items)):
            raise TypeError(f"Got a list of '{type(items[0])}', expected a list of '{of}'. value='{value}'")
        return items
    if kind is not None and (of is not None or not isinstance(value, kind)):
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
        if self._local not in context.get_locals_as_dict():
            raise SubstitutionFailure(f"{type(self).__name__} used outside of a launch file (in a script)")
        return str(context.get_locals_as_dict()[self._local])


class ThisLaunchFileDir(ThisLaunchFile):
    _local = "current_launch_file_directory"


@dataclass(eq=False)
class FindPackageShare(Substitution):
    package: Any

    def perform(self, context: LaunchContext) -> str:
        return str(context.service.package(perform(context, self.package)))


@dataclass(eq=False)
class AnonName(Substitution):
    name: Any

    def perform(self, context: LaunchContext) -> str:
        # On a real ROS it differs each time; here runs are the same each time.
        return f"{perform(context, self.name)}_anonymous"


@dataclass(eq=False)
class IfElseSubstitution(Substitution):
    condition: Any
    if_value: Any = ""
    else_value: Any = ""

    def perform(self, context: LaunchContext) -> str:
        return perform(context, self.if_value if _truth(context, self.condition) else self.else_value)


class AnySubstitution(Substitution):
    def __init__(self, *args: Any) -> None:
        self.args = args

    def perform(self, context: LaunchContext) -> str:
        return _word(any([_truth(context, each) for each in self.args]))


class AllSubstitution(AnySubstitution):
    def perform(self, context: LaunchContext) -> str:
        return _word(all([_truth(context, each) for each in self.args]))


class OrSubstitution(AnySubstitution):
    def __init__(self, left: Any, right: Any) -> None:
        super().__init__(left, right)


class AndSubstitution(AllSubstitution):
    def __init__(self, left: Any, right: Any) -> None:
        super().__init__(left, right)


@dataclass(eq=False)
class NotSubstitution(Substitution):
    value: Any

    def perform(self, context: LaunchContext) -> str:
        return _word(not _truth(context, self.value))


@dataclass(eq=False)
class EqualsSubstitution(Substitution):
    left: Any
    right: Any

    def are_equal(self, context: LaunchContext) -> bool:
        left, right = (self._text(context, each) for each in (self.left, self.right))
        truths = {"true": True, "1": True, "false": False, "0": False}
        if left.lower() in truths and right.lower() in truths:
            return truths[left.lower()] == truths[right.lower()]
        try:
            return math.isclose(float(left), float(right))
        except ValueError:
            return left == right

    def _text(self, context: LaunchContext, value: Any) -> str:
        if is_substitution(value):
            return perform(context, value)
        return "" if value is None else _word(value) if isinstance(value, bool) else str(value)

    def perform(self, context: LaunchContext) -> str:
        return _word(self.are_equal(context))


class NotEqualsSubstitution(EqualsSubstitution):
    def perform(self, context: LaunchContext) -> str:
        return _word(not self.are_equal(context))


def _truth(context: LaunchContext, some: Any) -> bool:
    try:
        return bool(perform_typed(context, listed(some), bool))
    except (TypeError, ValueError) as error:
        raise SubstitutionFailure(error) from None


def _word(truth: bool) -> str:
    return str(truth).lower()


# --- in a text --------------------------------------------------------------------------------------------------------


def parse_substitution(text: str) -> list[Any]:
    """Find the ``$(name arguments)`` in a text. Raises RuntimeError for faulty ones."""
    parts, at = _parse(text, 0, "")
    assert at == len(text)
    return parts or [TextSubstitution(text="")]


# A piece of text, by what it ends at: nothing, a quotation mark, or what separates arguments. A backslash hides that.
_PIECES = {
    "": re.compile(r"(?:\\.|(?!\$\()[\s\S])+"),
    "'": re.compile(r"(?:\\.|(?!\$\()[^'])+"),
    '"': re.compile(r'(?:\\.|(?!\$\()[^"])+'),
    " )": re.compile(r"(?:\\.|(?!\$\()[^ ()'\"])+"),
}


def _parse(text: str, at: int, end: str) -> tuple[list[Any], int]:
    """Read from ``at`` on, up to one of the characters in ``end``."""
    parts: list[Any] = []
    while at < len(text) and text[at] not in end:
        if text.startswith("$(", at):
            part, at = _parse_one(text, at)
            parts.append(part)
        elif piece := _PIECES[end].match(text, at):
            parts.append(TextSubstitution(text=re.sub(r"\\(.)", r"\1", piece[0])))
            at = piece.end()
        else:
            raise RuntimeError(f"No terminal matches '{text[at]}' in {text!r}")
    return parts, at


def _parse_one(text: str, start: int) -> tuple[Any, int]:
    name = re.compile(r"\$\(([a-zA-Z][\w-]*)").match(text, start)
    if not name:
        raise RuntimeError(f"there is no name after $( in {text!r}")
    arguments, at = [], name.end()
    while text[at : at + 1] == " ":
        quote = text[at + 1 : at + 2]
        if quote in ("'", '"'):
            argument, at = _parse(text, at + 2, quote)
            at += 1
        else:
            argument, at = _parse(text, at + 1, " )")
        arguments.append(argument)
    if text[at : at + 1] != ")":
        raise RuntimeError(f"{text[start:]!r} is not closed")
    if name[1] not in _BY_NAME:
        raise RuntimeError(f"Unknown substitution: {name[1]}")
    least, most, make = _BY_NAME[name[1]]
    if not least <= len(arguments) <= most:
        numbers = f"{least} or {most}" if most > least else f"{most}"
        raise RuntimeError(f"{name[1]} substitution expects {numbers} argument{'s'[: most > 1]}")
    return make(*arguments), at + 1


# How many arguments each may have.
_BY_NAME: dict[str, tuple[int, int, Any]] = {
    "var": (1, 2, lambda name, default=None: LaunchConfiguration(name, default=default)),
    "env": (1, 2, lambda name, default=None: EnvironmentVariable(name, default_value=default)),
    "dirname": (0, 0, ThisLaunchFileDir),
    "filename": (0, 0, ThisLaunchFile),
    "find-pkg-share": (1, 1, FindPackageShare),
    "eval": (1, 1, PythonExpression),
    "anon": (1, 1, AnonName),
    "not": (1, 1, NotSubstitution),
    "and": (2, 2, AndSubstitution),
    "or": (2, 2, OrSubstitution),
    "any": (1, 99, AnySubstitution),
    "all": (1, 99, AllSubstitution),
    "equals": (2, 2, EqualsSubstitution),
    "not-equals": (2, 2, NotEqualsSubstitution),
    "if": (1, 3, IfElseSubstitution),
}
