"""Parameters of nodes in a launch file, and how a node is given them (source: launch_ros/utilities, descriptions)."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .substitutions import SubstitutionFailure, is_substitution, parse_substitution, perform, perform_typed

if TYPE_CHECKING:
    from .context import LaunchContext

__all__ = ["Parameter", "ParameterFile", "ParameterValue", "evaluate", "words_for"]


class ParameterValue:
    """A value of the type ``value_type``; of the one that it has as YAML, if that is None."""

    def __init__(self, value: Any, *, value_type: Any = None) -> None:
        self.value, self.value_type = value, value_type

    def evaluate(self, context: LaunchContext) -> Any:
        return perform_typed(context, self.value, self.value_type)


class Parameter:
    def __init__(self, name: Any, value: Any, *, value_type: Any = None) -> None:
        self.name, self.value = name, ParameterValue(value, value_type=value_type)

    def evaluate(self, context: LaunchContext) -> tuple[str, Any]:
        return perform(context, self.name), self.value.evaluate(context)


class ParameterFile:
    def __init__(self, param_file: Any, *, allow_substs: Any = False) -> None:
        self.param_file, self.allow_substs = param_file, allow_substs

    def evaluate(self, context: LaunchContext) -> str:
        """The path of the file; if it has substitutions, of a new one in which they are made."""
        file = self.param_file
        path = os.fspath(file) if isinstance(file, os.PathLike) else perform(context, file)
        if not perform_typed(context, self.allow_substs, bool):
            return path
        with open(path, encoding="utf-8") as opened:
            text = perform(context, parse_substitution(opened.read()))
        import yaml

        try:
            yaml.safe_load(text)
        except yaml.YAMLError:
            raise SubstitutionFailure("The substituted parameter file is not a valid yaml file") from None
        return context.service.write_file(text)


def evaluate(context: LaunchContext, parameters: Mapping[Any, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """The names and values that a dictionary gives."""
    for key, value in parameters.items():
        name = prefix + perform(context, key)
        if isinstance(value, Mapping):
            yield from evaluate(context, value, f"{name}.")
        else:
            yield name, _value(context, name, value)


def _value(context: LaunchContext, name: str, value: Any) -> Any:
    import yaml

    if isinstance(value, ParameterValue):
        found = value.evaluate(context)
        return tuple(found) if isinstance(found, list) else found
    if is_substitution(value):
        text = perform(context, value)
        try:
            value = yaml.safe_load(text) if text else text
        except yaml.YAMLError:
            raise TypeError(
                f"Unable to parse the value of parameter {name} as yaml. If the parameter is meant to be a string, try "
                "wrapping it in launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)"
            ) from None
        if not isinstance(value, (bool, int, float, str, bytes, Sequence)):
            raise TypeError(
                "Allowed value types are bytes, bool, int, float, str, Sequence[bool], Sequence[int], Sequence[float], "
                f'Sequence[str]. Got {type(value)} for "{name}". If the parameter is meant to be a string, try '
                "wrapping it in launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)"
            )
    if isinstance(value, (bool, int, float, str, bytes)):
        return value
    if not isinstance(value, Sequence):
        raise TypeError(f"Unexpected type for parameter value {value!r}")
    items = [yaml.safe_load(perform(context, item)) if is_substitution(item) else item for item in value]
    if {type(item) for item in items} == {int, float}:
        items = [float(item) for item in items]
    if len({type(item) for item in items}) != 1 or not isinstance(items[0], (bool, int, float, str)):
        raise TypeError(
            "Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are bool, int, "
            f'float, str. Got inconsistent input for "{name}"'
        )
    return tuple(items)


def words_for(context: LaunchContext, parameters: Sequence[Any], node: str) -> Iterator[str]:
    """The command line for what a node, by its full name or "/**", is given as ``parameters``."""
    import yaml

    for each in parameters:
        if isinstance(each, Parameter):
            name, value = each.evaluate(context)
            yield from ("-p", f"{name}:={yaml.dump(value)}")
            continue
        if isinstance(each, Mapping):
            values = {name: list(v) if isinstance(v, tuple) else v for name, v in evaluate(context, each)}
            path = context.service.write_file(yaml.dump({node: {"ros__parameters": values}}))
        else:
            path = (each if isinstance(each, ParameterFile) else ParameterFile(each)).evaluate(context)
        if os.path.isfile(path):
            yield from ("--params-file", path)
        else:
            context.service.log("WARNING", "launch_ros.actions.node", f"Parameter file path is not a file: {path}")
