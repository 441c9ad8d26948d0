"""Parameters in a launch file, and how a node is given them (sources: launch_ros/utilities, parameter_descriptions)."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass
from typing import TYPE_CHECKING, Any

from ...world import yaml_texts
from .substitutions import is_substitution, parse_substitution, perform, perform_typed

if TYPE_CHECKING:
    from .context import LaunchContext

__all__ = ["Parameter", "ParameterFile", "ParameterValue", "evaluate", "words_for"]


@dataclass(eq=False)
class ParameterValue:
    """A value of the type ``value_type``; of the one that it has as YAML, if that is None."""

    value: Any
    _: KW_ONLY
    value_type: Any = None


@dataclass(eq=False)
class Parameter(ParameterValue):
    """A parameter with its value."""

    def __init__(self, name: Any, value: Any, *, value_type: Any = None) -> None:
        super().__init__(value, value_type=value_type)
        self.name = name


@dataclass(eq=False)
class ParameterFile:
    """A file with parameters, in which substitutions may be made."""

    param_file: Any
    _: KW_ONLY
    allow_substs: Any = False


def evaluate(context: LaunchContext, parameters: Mapping[Any, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the names and values that a dictionary gives. Raises TypeError and ValueError."""
    for key, value in parameters.items():
        name = prefix + perform(context, key)
        if isinstance(value, Mapping):
            yield from evaluate(context, value, f"{name}.")
        else:
            found = _value(context, name, value)
            yield name, tuple(found) if isinstance(found, list) else found


def _value(context: LaunchContext, name: str, value: Any) -> Any:
    if isinstance(value, ParameterValue):
        return perform_typed(context, value.value, value.value_type)
    if is_substitution(value):
        text = perform(context, value)
        value = yaml_texts.load(text) if text else text
        if not isinstance(value, (bool, int, float, str, list)):
            raise TypeError(
                "Allowed value types are bytes, bool, int, float, str, Sequence[bool], Sequence[int], Sequence[float], "
                f'Sequence[str]. Got {type(value)} for "{name}". If the parameter is meant to be a string, try '
                "wrapping it in launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)"
            )
    if isinstance(value, (bool, int, float, str)):
        return value
    if not isinstance(value, Sequence):
        raise TypeError(f"Unexpected type for parameter value {value!r}")
    items = [yaml_texts.load(perform(context, item)) if is_substitution(item) else item for item in value]
    if {type(item) for item in items} == {int, float}:
        return [float(item) for item in items]
    if len({type(item) for item in items}) != 1 or not isinstance(items[0], (bool, int, float, str)):
        raise TypeError(
            "Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are bool, int, "
            f'float, str. Got inconsistent input for "{name}"'
        )
    return items


def words_for(context: LaunchContext, parameters: Sequence[Any], node: str) -> Iterator[str]:
    """Yield the words of a command line that give parameters to a node, by its full name or "/**"."""
    import yaml

    for each in parameters:
        if isinstance(each, Parameter):
            value = yaml.dump(perform_typed(context, each.value, each.value_type))
            yield from ("-p", f"{perform(context, each.name)}:={value}")
            continue
        if isinstance(each, Mapping):
            found = {
                name: list(value) if isinstance(value, tuple) else value for name, value in evaluate(context, each)
            }
            path = context.service.write_file(yaml.dump({node: {"ros__parameters": found}}))
        else:
            path = _path(context, each if isinstance(each, ParameterFile) else ParameterFile(each))
        if os.path.isfile(path):
            yield from ("--params-file", path)
        else:
            context.service.log("WARNING", "launch_ros.actions.node", f"Parameter file path is not a file: {path}")


def _path(context: LaunchContext, file: ParameterFile) -> str:
    """Return the path of a file; if substitutions are made in it, the path of a copy."""
    path = os.fspath(file.param_file) if isinstance(file.param_file, os.PathLike) else perform(context, file.param_file)
    if perform_typed(context, file.allow_substs, bool):
        with open(path, encoding="utf-8") as opened:
            return context.service.write_file(perform(context, parse_substitution(opened.read())))
    return path
