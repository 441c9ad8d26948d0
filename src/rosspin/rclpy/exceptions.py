"""rclpy's exceptions (source: rclpy/exceptions.py, rclpy/executors.py, and what its C++ part raises)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .parameter import Parameter

__all__ = [
    *("InvalidHandle", "InvalidNamespaceException", "InvalidNodeNameException"),
    *("InvalidParameterException", "InvalidParameterTypeException", "InvalidParameterValueException"),
    *("InvalidServiceNameException", "InvalidTopicNameException", "NameValidationException"),
    *("NoTypeSupportImportedException", "NotInitializedException", "ParameterAlreadyDeclaredException"),
    *("ParameterException", "ParameterImmutableException", "ParameterNotDeclaredException"),
    *("ParameterUninitializedException", "ROSInterruptException"),
]


class RCLError(RuntimeError):
    """Raised where the C part of rclpy refuses a call. On a real ROS the text also names the line of the C source."""


class RMWError(RuntimeError):
    """Raised where the middleware refuses a call."""


class InvalidHandle(RuntimeError):
    """A timer, publisher or subscription was destroyed."""

    def __init__(self, text: str = "cannot use Destroyable because destruction was requested") -> None:
        super().__init__(text)


class RCLInvalidROSArgsError(RCLError):
    """What follows ``--ros-args`` in a node's own arguments cannot be read."""


class UnknownROSArgsError(RuntimeError):
    """Raised for words after ``--ros-args`` that ROS does not know."""


def invalid_context(failed: str) -> RCLError:
    """Make the error for what fails before ``init`` or after ``shutdown``, in the words of the C part."""
    reason = "either rcl_init() was not called or rcl_shutdown() was called."
    return RCLError(f"failed to {failed}: the given context is not valid, {reason}")


def not_accepted(signature: str, *args: object, function: str = "") -> TypeError:
    """Make the error for arguments of the wrong type, in the words of the C part.

    In ``args``, an object of the C part is given by the name of its class. Without a ``function``, the error is about a
    constructor.
    """
    words = ", ".join(
        f"<rclpy._rclpy_pybind11.{arg} object at {id(arg):#x}>" if arg in _OBJECTS else repr(arg) for arg in args
    )
    return TypeError(
        f"{function or '__init__'}(): incompatible {'function' if function else 'constructor'} arguments. "
        "The following argument types are supported:\n"
        f"    1. {'' if function else 'rclpy._rclpy_pybind11.'}{signature}\n\nInvoked with: {words}"
    )


_OBJECTS = ("Client", "Clock", "Context", "Node", "Service", "rmw_qos_profile_t")


def no_type_support(given: object) -> AttributeError:
    """Make the error for what is no message, service or action of ROS 2."""
    return AttributeError(
        f"type object '{type(given).__name__}' has no attribute '_TYPE_SUPPORT' "
        "This might be a ROS 1 message type but it should be a ROS 2 message type. "
        "Make sure to source your ROS 2 workspace after your ROS 1 workspace."
    )


class NotInitializedException(Exception):
    """Something needs ``rclpy.init()`` first."""

    def __init__(self, message: str | None = None) -> None:
        super().__init__("rclpy.init() has not been called." + (f" msg:{message}" if message else ""))


class NoTypeSupportImportedException(Exception):
    """Raised by a real ROS where the C part of a message is missing."""


class NameValidationException(Exception):
    """A name is not valid, at ``invalid_index``."""

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int) -> None:
        self.error_msg = error_msg
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  '{name}'\n   {' ' * invalid_index}^")


class InvalidNamespaceException(NameValidationException):
    """A namespace is not valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("namespace", name, error_msg, invalid_index)


class InvalidNodeNameException(NameValidationException):
    """A node's name is not valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("node name", name, error_msg, invalid_index)


class InvalidTopicNameException(NameValidationException):
    """A topic's name is not valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("topic name", name, error_msg, invalid_index)


class InvalidServiceNameException(NameValidationException):
    """A service's name is not valid."""

    def __init__(self, name: str, error_msg: str, invalid_index: int) -> None:
        super().__init__("service name", name, error_msg, invalid_index)


class ParameterException(Exception):
    """Base class of errors about parameters."""

    def __init__(self, error_msg: str, parameters: str | list[str]) -> None:
        super().__init__(f"{error_msg}: {parameters}")


class ParameterNotDeclaredException(ParameterException):
    """A parameter was not declared."""

    def __init__(self, parameters: str | list[str]) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters)


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter was declared before."""

    def __init__(self, parameters: str | list[str]) -> None:
        super().__init__("Parameter(s) already declared", parameters)


class InvalidParameterException(ParameterException):
    """A parameter's name is not valid."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__("Invalid parameter name", parameter_name)


class InvalidParameterTypeException(ParameterException):
    """A parameter was given a value of another type than it was declared with."""

    def __init__(self, desired_parameter: Parameter, expected_type: str) -> None:
        name, value, kind = desired_parameter.name, desired_parameter.value, desired_parameter.type_.name
        text = f"Trying to set parameter '{name}' to '{value}' of type '{kind}', expecting type '{expected_type}'"
        super().__init__(text, name)


class InvalidParameterValueException(ParameterException):
    """A parameter's value is out of range, or refused by a callback of the node."""

    def __init__(self, parameter: str, value: Any, reason: str) -> None:
        super().__init__(f"Invalid parameter value ({value}) for parameter. Reason: {reason}", parameter)


class ParameterImmutableException(ParameterException):
    """A parameter is read-only."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__("Attempted to modify read-only parameter", parameter_name)


class ParameterUninitializedException(ParameterException):
    """A parameter was declared with a type and never given a value."""

    def __init__(self, parameter_name: str) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name)


class ROSInterruptException(Exception):
    """A sleeping Rate was woken by ``rclpy.shutdown()``."""

    def __init__(self) -> None:
        super().__init__("rclpy.shutdown() has been called")


class ExternalShutdownException(Exception):
    """The context was shut down while an executor waited, as by a signal."""


class TimeoutException(Exception):
    """An executor's timeout is over."""


class ShutdownException(Exception):
    """The executor was shut down."""


class ConditionReachedException(Exception):
    """The future that an executor waited for is done."""


# Tracebacks show the names of a real ROS.
_ELSEWHERE = {
    **dict.fromkeys(
        ("InvalidHandle", "RCLError", "RCLInvalidROSArgsError", "RMWError", "UnknownROSArgsError"),
        "rclpy._rclpy_pybind11",
    ),
    **dict.fromkeys(
        ("ConditionReachedException", "ExternalShutdownException", "ShutdownException", "TimeoutException"),
        "rclpy.executors",
    ),
}
for _name in {*__all__, *_ELSEWHERE}:
    globals()[_name].__module__ = _ELSEWHERE.get(_name, "rclpy.exceptions")
