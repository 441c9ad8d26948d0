"""Parameters, and what a node does with them (sources: rclpy/parameter.py, rclpy/node.py)."""

from __future__ import annotations

import inspect
import math
from array import array
from collections.abc import Callable, Iterable, Iterator
from enum import Enum
from importlib import import_module
from typing import Any

from ..clocks.frames import warn
from ..world import yaml_texts
from .exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from .names import validate_parameter_name

__all__ = [
    *("PARAMETER_SEPARATOR_STRING", "Parameter", "get_parameter_value", "parameter_dict_from_yaml_file"),
    "parameter_value_to_python",
]

PARAMETER_SEPARATOR_STRING = "."


class _Type(Enum):
    """The types of values, numbered as in rcl_interfaces/ParameterType."""

    NOT_SET = 0
    BOOL = 1
    INTEGER = 2
    DOUBLE = 3
    STRING = 4
    BYTE_ARRAY = 5
    BOOL_ARRAY = 6
    INTEGER_ARRAY = 7
    DOUBLE_ARRAY = 8
    STRING_ARRAY = 9

    @classmethod
    def from_parameter_value(cls, parameter_value: Any) -> _Type:
        """Return the type of a value. Raises TypeError if no parameter can have it."""
        if parameter_value is None:
            return cls.NOT_SET
        for kind, name in _NAMES:
            if isinstance(parameter_value, kind):
                return cls[name]
        if isinstance(parameter_value, (list, tuple, array)):
            for kind, name in [(bytes, "BYTE"), *_NAMES]:
                if all(isinstance(value, kind) for value in parameter_value):
                    return cls[f"{name}_ARRAY"]
            raise TypeError(f"The given value is not a list of one of the allowed types '{parameter_value}'.")
        raise TypeError(f"The given value is not one of the allowed types '{parameter_value}'.")

    def check(self, parameter_value: Any) -> bool:
        """Whether a value is of this type."""
        if self is _Type.NOT_SET:
            return parameter_value is None
        kind = _KINDS[self.name.removesuffix("_ARRAY")]
        if not self.name.endswith("_ARRAY"):
            return isinstance(parameter_value, kind)
        sequences = (list, tuple, array) if kind in (int, float) else (list, tuple)
        return isinstance(parameter_value, sequences) and all(isinstance(value, kind) for value in parameter_value)


_Type.__name__, _Type.__qualname__ = "Type", "Parameter.Type"  # which errors show

# In this order: a bool is an int, too.
_NAMES: list[tuple[type, str]] = [(bool, "BOOL"), (int, "INTEGER"), (float, "DOUBLE"), (str, "STRING")]
_KINDS = {"BYTE": bytes, **{name: kind for kind, name in _NAMES}}


class Parameter:
    """A parameter: name, type and value. Raises TypeError and ValueError if type and value do not agree."""

    Type = _Type

    def __init__(self, name: str, type_: _Type | None = None, value: Any = None) -> None:
        if type_ is None:
            type_ = _Type.from_parameter_value(value)
        if not isinstance(type_, _Type):
            raise TypeError(f"type must be an instance of '{_Type!r}'")
        if not type_.check(value):
            raise ValueError(f"Type '{type_}' and value '{value}' do not agree")
        self._name, self._type_, self._value = name, type_, value

    @property
    def name(self) -> str:
        """Its name."""
        return self._name

    @property
    def type_(self) -> _Type:
        """The type of its value."""
        return self._type_

    @property
    def value(self) -> Any:
        """Its value."""
        return self._value

    @property
    def _rosspin_field(self) -> str:
        return f"{self._type_.name.lower()}_value"

    def get_parameter_value(self) -> Any:
        """The value as a message, rcl_interfaces/ParameterValue."""
        message = import_module("rcl_interfaces.msg").ParameterValue(type=self._type_.value)
        if self._type_ is not _Type.NOT_SET:
            setattr(message, self._rosspin_field, self._value)
        return message

    def to_parameter_msg(self) -> Any:
        """Return the parameter as a message, rcl_interfaces/Parameter."""
        return import_module("rcl_interfaces.msg").Parameter(name=self._name, value=self.get_parameter_value())

    @classmethod
    def from_parameter_msg(cls, param_msg: Any) -> Parameter:
        """Make a Parameter from a message."""
        kind = _Type(param_msg.value.type)
        value = None if kind is _Type.NOT_SET else getattr(param_msg.value, f"{kind.name.lower()}_value")
        return cls(param_msg.name, kind, value)


def parameter_value_to_python(parameter_value: Any) -> Any:
    """Return the value in an rcl_interfaces/ParameterValue, None if not set. Raises RuntimeError for another type."""
    try:
        kind = _Type(parameter_value.type)
    except ValueError:
        raise RuntimeError(f"unexpected parameter type {parameter_value.type}") from None
    if kind is _Type.NOT_SET:
        return None
    value = getattr(parameter_value, f"{kind.name.lower()}_value")
    return list(value) if kind.name.endswith("_ARRAY") else value


def get_parameter_value(string_value: str) -> Any:
    """Return what a text says in YAML as a message, rcl_interfaces/ParameterValue. What is no value is a text."""
    import yaml  # only needed here and on command lines, and many nodes do without

    try:
        value = yaml_texts.load(string_value)
        return Parameter("", value=string_value if value is None else value).get_parameter_value()
    except (yaml.parser.ParserError, TypeError):
        return Parameter("", value=string_value).get_parameter_value()


def parameter_dict_from_yaml_file(
    parameter_file: str, use_wildcard: bool = False, target_nodes: list[str] | None = None, namespace: str = ""
) -> dict[str, Any]:
    """Read the parameters in a file, as messages by name, with ``namespace`` in front of each name.

    They are for the ``target_nodes`` (none: for all nodes in the file), with ``use_wildcard`` also for
    ``/**``. Raises RuntimeError if a node is not in the file, or has no ``ros__parameters``.
    """
    with open(parameter_file, encoding="utf-8") as file:
        tree = yaml_texts.load(file)
    nodes = ["/**"] if use_wildcard and "/**" in tree else []
    for node in target_nodes or ():
        if node not in tree:
            raise RuntimeError(f"Param file does not contain parameters for {node},only for nodes: {list(tree)} ")
    nodes += target_nodes or [node for node in tree if node != "/**"]
    if not nodes:
        raise RuntimeError("Param file does not contain selected parameters")
    found: dict[str, Any] = {}
    for node in nodes:
        if not isinstance(tree[node], dict) or "ros__parameters" not in tree[node]:
            raise RuntimeError(f"YAML file is not a valid ROS parameter file for node {node}")
        found |= tree[node]["ros__parameters"]
    kind = import_module("rcl_interfaces.msg").Parameter
    return {name: kind(name=name, value=get_parameter_value(str(value))) for name, value in _flat(namespace, found)}


def _flat(prefix: str, tree: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    for name, value in tree.items():
        if isinstance(value, dict):
            yield from _flat(f"{prefix}{name}{PARAMETER_SEPARATOR_STRING}", value)
        else:
            yield prefix + name, value


class Parameters:
    """Declares, reads and sets the parameters of a node; the base of Node.

    A parameter keeps the type with which it is declared and refuses values of other types, even an int for a float. A
    value on the command line takes precedence over the one in the code.
    """

    PARAM_REL_TOL = 1e-6

    def __init__(self, overrides: dict[str, Parameter], allow_undeclared: bool) -> None:
        self._parameters: dict[str, Parameter] = {}
        self._descriptors: dict[str, Any] = {}
        self._parameter_overrides = overrides
        self._allow_undeclared_parameters = allow_undeclared
        self._pre_set_parameters_callbacks: list[Callable[[list[Parameter]], list[Parameter]]] = []
        self._on_set_parameters_callbacks: list[Callable[[list[Parameter]], Any]] = []
        self._post_set_parameters_callbacks: list[Callable[[list[Parameter]], Any]] = []

    # --- declaring ----------------------------------------------------------------------------------------------------

    def declare_parameter(
        self, name: str, value: Any = None, descriptor: Any = None, ignore_override: bool = False
    ) -> Parameter:
        """Declare a parameter with a value, or a type. Return the parameter with the value that it has now.

        ``descriptor`` is a ParameterDescriptor. Raises ParameterAlreadyDeclaredException, InvalidParameterException for
        an empty name, InvalidParameterTypeException if the command line gives a value of another type,
        InvalidParameterValueException if the value is out of range or refused by a callback, TypeError and ValueError.
        """
        entry: tuple[Any, ...] = (name,) if value is None and descriptor is None else (name, value, descriptor)
        return self.declare_parameters("", [entry], ignore_override)[0]

    def declare_parameters(
        self, namespace: str, parameters: Iterable[tuple[Any, ...]], ignore_override: bool = False
    ) -> list[Parameter]:
        """Declare parameters given by name, or name and value, or these and a descriptor, as ``namespace.name``."""
        declared: list[tuple[Parameter, Any]] = []
        for index, entry in enumerate(parameters):
            if not 1 <= len(entry) <= 3:
                raise TypeError(
                    f"Invalid parameter tuple length at index {index} in parameters list: "
                    f"{entry}; expecting length between 1 and 3"
                )
            name, value, descriptor = (*entry, None, None)[:3]
            if not isinstance(name, str):
                raise TypeError(f"First element {name} at index {index} in parameters list is not a str.")
            name = f"{namespace}.{name}" if namespace else name
            validate_parameter_name(name)
            descriptor = _descriptor(descriptor, index)
            if len(entry) == 1:
                warn(
                    f"when declaring parameter named '{name}', declaring a parameter only providing its name is "
                    'deprecated. You have to either:\n\t- Pass a name and a default value different to "PARAMETER NOT '
                    'SET" (and optionally a descriptor).\n\t- Pass a name and a parameter type.\n\t- Pass a name and a '
                    "descriptor with `dynamic_typing=True",
                )
                descriptor.dynamic_typing = True
            if isinstance(value, _Type):
                _check_static(name, value, descriptor)
                descriptor.type, value = value.value, None
            elif not descriptor.dynamic_typing:
                is_message = isinstance(value, import_module("rcl_interfaces.msg").ParameterValue)
                descriptor.type = value.type if is_message else _Type.from_parameter_value(value).value
                if descriptor.type == 0:
                    raise ValueError(
                        "Cannot declare a statically typed parameter with default value of type PARAMETER_NOT_SET"
                    )
            if not ignore_override and name in self._parameter_overrides:
                value = self._parameter_overrides[name].value
            declared.append((Parameter(name, value=value), descriptor))
        if again := [parameter.name for parameter, _ in declared if parameter.name in self._parameters]:
            raise ParameterAlreadyDeclaredException(again)
        for parameter, descriptor in declared:
            reason = self._rosspin_set_parameters([parameter], {parameter.name: descriptor})
            if reason is not None:
                if reason.startswith("Wrong parameter type"):
                    raise InvalidParameterTypeException(parameter, _Type(descriptor.type).name)
                raise InvalidParameterValueException(parameter.name, parameter.value, reason)
        return [self._parameters[parameter.name] for parameter, _ in declared]

    def undeclare_parameter(self, name: str) -> None:
        """Forget a parameter. Raises ParameterNotDeclaredException, or ParameterImmutableException if read-only."""
        if not self.has_parameter(name):
            raise ParameterNotDeclaredException(name)
        if self._descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del self._parameters[name], self._descriptors[name]

    def has_parameter(self, name: str) -> bool:
        """Whether a parameter is declared."""
        return name in self._parameters

    # --- reading ------------------------------------------------------------------------------------------------------

    def get_parameter(self, name: str) -> Parameter:
        """Return a parameter. Raises ParameterNotDeclaredException, or ParameterUninitializedException if not set."""
        if self.has_parameter(name):
            parameter = self._parameters[name]
            if parameter.type_ is _Type.NOT_SET and not self._descriptors[name].dynamic_typing:
                raise ParameterUninitializedException(name)
            return parameter
        if self._allow_undeclared_parameters:
            return Parameter(name, _Type.NOT_SET)
        raise ParameterNotDeclaredException(name)

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """Return several parameters, as ``get_parameter`` does."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter(name) for name in names]

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """Return a parameter, or the alternative (default: one not set) if it is not declared or has no value."""
        if self.has_parameter(name) and self._parameters[name].type_ is not _Type.NOT_SET:
            return self._parameters[name]
        return Parameter(name, _Type.NOT_SET) if alternative_value is None else alternative_value

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """Return the parameters below a prefix, keyed by the rest of their names."""
        prefix = prefix + PARAMETER_SEPARATOR_STRING if prefix else ""
        return {name[len(prefix) :]: value for name, value in self._parameters.items() if name.startswith(prefix)}

    def get_parameter_type(self, name: str) -> Any:
        """The number of a parameter's type."""
        if self.has_parameter(name):
            return self._parameters[name].type_.value
        if self._allow_undeclared_parameters:
            return _Type.NOT_SET
        raise ParameterNotDeclaredException(name)

    def get_parameter_types(self, names: list[str]) -> list[Any]:
        """The numbers of several parameters' types."""
        return [self.get_parameter_type(name) for name in names]

    def describe_parameter(self, name: str) -> Any:
        """Return a parameter's descriptor, a message. Raises ParameterNotDeclaredException."""
        if name in self._descriptors:
            found = self._descriptors[name]
            return found.message() if isinstance(found, _Descriptor) else found
        if self._allow_undeclared_parameters:
            return import_module("rcl_interfaces.msg").ParameterDescriptor()
        raise ParameterNotDeclaredException(name)

    def set_descriptor(self, name: str, descriptor: Any, alternative_value: Any = None) -> Any:
        """Replace a parameter's descriptor. Return the parameter's value, a message.

        If the value does not agree with it, ``alternative_value`` (a message) replaces the value. Raises
        ParameterNotDeclaredException, ParameterImmutableException, and InvalidParameterValueException if neither does.
        """
        if not self.has_parameter(name):
            return self.get_parameter(name).get_parameter_value()
        if self.describe_parameter(name).read_only:
            raise ParameterImmutableException(name)
        value = self.get_parameter(name)
        if (reason := self._rosspin_refused(value, descriptor, False)) is not None and alternative_value is not None:
            kind = import_module("rcl_interfaces.msg").Parameter
            value = Parameter.from_parameter_msg(kind(name=name, value=alternative_value))
            reason = self._rosspin_refused(value, descriptor, False)
        if reason is not None:
            raise InvalidParameterValueException(name, value.value, reason)
        self._parameters[name], self._descriptors[name] = value, descriptor
        return self.get_parameter(name).get_parameter_value()

    def describe_parameters(self, names: list[str]) -> list[Any]:
        """Several parameters' descriptors."""
        return [self.describe_parameter(name) for name in names]

    def list_parameters(self, prefixes: list[str], depth: int) -> Any:
        """List the names of the parameters below any of the prefixes (none: all), and their own prefixes, in a message.

        A name has fewer than ``depth`` separators below the prefix; 0: any number. Raises TypeError and ValueError.
        """
        if not isinstance(prefixes, list):
            raise TypeError("The prefixes argument must be a list")
        if not all(isinstance(prefix, str) for prefix in prefixes):
            raise TypeError("All prefixes must be instances of type str")
        if not isinstance(depth, int):
            raise TypeError("The depth must be instance of type int")
        if depth < 0:
            raise ValueError("The depth must be greater than or equal to zero")

        def is_listed(name: str) -> bool:
            below = [name[len(start) :] for start in starts if name.startswith(start)]
            return name in prefixes or any(depth == 0 or rest.count(".") < depth for rest in below)

        starts = [prefix + PARAMETER_SEPARATOR_STRING for prefix in prefixes] or [""]
        names = [name for name in self._parameters if is_listed(name)]
        above = [name.rpartition(PARAMETER_SEPARATOR_STRING)[0] for name in names]
        result = import_module("rcl_interfaces.msg").ListParametersResult
        return result(names=names, prefixes=list(dict.fromkeys(filter(None, above))))

    # --- setting ------------------------------------------------------------------------------------------------------

    def set_parameters(self, parameter_list: list[Parameter]) -> list[Any]:
        """Set parameters one by one. Return a SetParametersResult for each. Raises ParameterNotDeclaredException."""
        return [self._set_parameters_atomically([parameter]) for parameter in parameter_list]

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> Any:
        """Set all or none. Return one SetParametersResult. Raises ParameterNotDeclaredException."""
        return self._set_parameters_atomically(parameter_list)

    def _set_parameters_atomically(self, parameter_list: list[Parameter]) -> Any:
        if self._pre_set_parameters_callbacks:
            parameter_list = [
                each for callback in self._pre_set_parameters_callbacks for each in callback(parameter_list)
            ]
            if not parameter_list:
                return _result(
                    "parameter list cannot be empty, this might be due to pre_set_parameters_callback modifying the "
                    "original parameters list."
                )
        if not all(isinstance(parameter, Parameter) for parameter in parameter_list):
            raise TypeError(f"parameter must be instance of type '{Parameter!r}'")
        undeclared = [parameter.name for parameter in parameter_list if parameter.name not in self._parameters]
        if undeclared and not self._allow_undeclared_parameters:
            raise ParameterNotDeclaredException(undeclared[1:])  # rclpy's error, too, leaves out the first one
        return _result(self._rosspin_set_parameters(parameter_list, None))

    def _rosspin_set_parameters(self, parameters: list[Parameter], descriptors: dict[str, Any] | None) -> str | None:
        """Set parameters, declaring them if descriptors are given. Return why that failed, or None."""
        known = self._descriptors if descriptors is None else descriptors
        for parameter in parameters:
            if parameter.name in known:
                reason = self._rosspin_refused(parameter, known[parameter.name], check_read_only=descriptors is None)
                if reason is not None:
                    return reason
        for callback in self._on_set_parameters_callbacks:
            result = callback(parameters)
            if not isinstance(result, import_module("rcl_interfaces.msg").SetParametersResult):
                warn("Callback returned an invalid type, it should return SetParameterResult.")
                return "Callback returned an invalid type"
            if not result.successful:
                return str(result.reason)
        namespace = self.get_namespace()
        path = namespace + self.get_name() if namespace == "/" else namespace + "/" + self.get_name()
        new: list[Parameter] = []
        changed: list[Parameter] = []
        deleted: list[Parameter] = []
        for parameter in parameters:
            name = parameter.name
            if descriptors is None and parameter.type_ is _Type.NOT_SET:
                deleted.append(parameter)
                self._parameters.pop(name, None)
                self._descriptors.pop(name, None)
                continue
            if descriptors is not None:
                self._descriptors[name] = descriptors[name]
            elif name not in self._descriptors:
                self._descriptors[name] = _Descriptor(name, dynamic_typing=True)
            if parameter.type_ is _Type.INTEGER_ARRAY and not all(-(2**63) <= each < 2**63 for each in parameter.value):
                raise OverflowError("int too big to convert")
            (new if self.get_parameter_or(name).type_ is _Type.NOT_SET else changed).append(parameter)
            self._parameters[name] = parameter
        self._rosspin_tell_parameters(path, new, changed, deleted)
        for callback in self._post_set_parameters_callbacks:
            callback(parameters)
        return None

    def get_name(self) -> str:
        """The node's name."""
        raise NotImplementedError

    def get_namespace(self) -> str:
        """The node's namespace."""
        raise NotImplementedError

    def _rosspin_tell_parameters(
        self, node: str, new: list[Parameter], changed: list[Parameter], deleted: list[Parameter]
    ) -> None:
        """Tell what has been set in a node. Raises RCLError."""
        raise NotImplementedError

    def _rosspin_refused(self, parameter: Parameter, descriptor: Any, check_read_only: bool) -> str | None:
        """Return why a parameter may not have this value, or None."""
        descriptor.name = parameter.name
        if check_read_only and descriptor.read_only:
            return f"Trying to set a read-only parameter: {parameter.name}."
        if descriptor.dynamic_typing:
            descriptor.type = parameter.type_.value
        elif self.has_parameter(parameter.name) and parameter.type_ is _Type.NOT_SET:
            return "Static parameter cannot be undeclared"
        elif parameter.type_ is not _Type.NOT_SET and parameter.type_.value != descriptor.type:
            return f"Wrong parameter type, expected '{_Type(descriptor.type)}' got '{parameter.type_}'"
        if parameter.type_ is _Type.INTEGER and descriptor.integer_range:
            return _out_of_integers(parameter, descriptor.integer_range[0])
        if parameter.type_ is _Type.DOUBLE and descriptor.floating_point_range:
            return _out_of_floats(parameter, descriptor.floating_point_range[0], self.PARAM_REL_TOL)
        return None

    def add_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Let a function replace the parameters that are about to be set; the newest function goes first."""
        self._pre_set_parameters_callbacks.insert(0, callback)

    def add_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        """Let a function refuse parameters by the SetParametersResult that it returns; the newest goes first.

        Raises TypeError if it cannot be called, as ``add_post_set_parameters_callback`` does.
        """
        _check_callable(callback)
        self._on_set_parameters_callbacks.insert(0, callback)

    def add_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        """Call a function with the parameters that were set; the newest goes first."""
        _check_callable(callback)
        self._post_set_parameters_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Do not call it any more; ValueError if it is not there."""
        self._pre_set_parameters_callbacks.remove(callback)

    def remove_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        """Do not call it any more; ValueError if it is not there."""
        self._on_set_parameters_callbacks.remove(callback)

    def remove_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], Any]) -> None:
        """Do not call it any more; ValueError if it is not there."""
        self._post_set_parameters_callbacks.remove(callback)


for _function in [each for each in vars(Parameters).values() if inspect.isfunction(each)]:
    _function.__qualname__ = f"Node.{_function.__name__}"  # where rclpy has them, and what errors say


def check_value(parameter: Parameter) -> None:
    """Raise what the C part raises for a value that no message can hold, when it is published."""
    value, kind = parameter.value, parameter.type_
    if kind is _Type.INTEGER and not -(2**63) <= value < 2**63:
        raise SystemError("<function ParameterValue.double_value> returned a result with an exception set")
    if kind is _Type.STRING:
        value.encode()


def _check_callable(callback: object) -> None:
    if not callable(callback):
        raise TypeError("Callback must be callable, got {}", type(callback))  # two arguments, as rclpy raises it


class _Descriptor:
    """Stands in for a ParameterDescriptor where a node gives none: making a message each time would be slow."""

    def __init__(self, name: str = "", dynamic_typing: bool = False) -> None:
        self.name = name
        self.type = 0
        self.dynamic_typing = dynamic_typing
        self.read_only = False
        self.integer_range: list[Any] = []
        self.floating_point_range: list[Any] = []

    def message(self) -> Any:
        """The message."""
        kind = import_module("rcl_interfaces.msg").ParameterDescriptor
        return kind(**{name: value for name, value in vars(self).items() if not isinstance(value, list)})


def _descriptor(descriptor: Any, index: int) -> Any:
    if descriptor is None:
        return _Descriptor()
    if not isinstance(descriptor, import_module("rcl_interfaces.msg").ParameterDescriptor):
        raise TypeError(f"Third element {descriptor} at index {index} in parameters list is not a ParameterDescriptor.")
    return descriptor


def _check_static(name: str, kind: _Type, descriptor: Any) -> None:
    if kind is _Type.NOT_SET:
        raise ValueError(f"Cannot declare parameter {{{name}}} as statically typed of type NOT_SET")
    if descriptor.dynamic_typing:
        raise ValueError(
            f"When declaring parameter {{{name}}} passing a descriptor with"
            "`dynamic_typing=True` is not allowed when the parameter type is provided"
        )


def _result(reason: str | None) -> Any:
    kind = import_module("rcl_interfaces.msg").SetParametersResult
    return kind(successful=reason is None, reason=reason or "")


def _out_of_integers(parameter: Parameter, range_: Any) -> str | None:
    low, high = sorted((range_.from_value, range_.to_value))
    name, value, step = parameter.name, parameter.value, range_.step
    if value in (low, high):
        return None
    if not low < value < high:
        return f"Parameter {name} out of range. Min: {low}, Max: {high}, value: {value}"
    if step and (value - low) % step:
        return (
            f"The parameter value for {name} is not a valid step. Min: {low}, max: {high}, value: {value}, step: {step}"
        )
    return None


def _out_of_floats(parameter: Parameter, range_: Any, tolerance: float) -> str | None:
    low, high = sorted((range_.from_value, range_.to_value))
    name, value, step = parameter.name, parameter.value, range_.step
    if math.isclose(value, low, rel_tol=tolerance) or math.isclose(value, high, rel_tol=tolerance):
        return None
    if not low < value < high:
        return f"Parameter {name} out of range Min: {low}, Max: {high}, value: {value}"
    if step and not math.isclose(low + round((value - low) / step) * step, value, rel_tol=tolerance):
        return (
            f"The parameter value for {name} is not close enough to a valid step. "
            f"Min: {low}, max: {high}, value: {value}, step: {step}"
        )
    return None
