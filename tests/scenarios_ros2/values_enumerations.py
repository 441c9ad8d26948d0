"""The enumerations of rclpy's C++ part: each value is true, can be an int and is printed by its name."""

import pickle

import rclpy._rclpy_pybind11 as cpp
from rclpy.lifecycle import TransitionCallbackReturn
from rclpy.qos import QoSCompatibility
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.signals import SignalHandlerOptions
from scenario import attempt


def refuses(function):
    """Whether this raises TypeError; how its text names the types is not of interest."""
    try:
        function()
    except TypeError:
        return True
    return False


for first, second in (
    (QoSCompatibility.OK, QoSCompatibility.ERROR),
    (ServiceIntrospectionState.OFF, ServiceIntrospectionState.METADATA),
    (SignalHandlerOptions.NO, SignalHandlerOptions.ALL),
    (TransitionCallbackReturn.SUCCESS, TransitionCallbackReturn.FAILURE),
):
    names = {"Kind": type(first), "first": first, "second": second, "refuses": refuses}
    for text in (
        "Kind.__name__, Kind.__module__",
        "first, second",
        "str(first), f'{second}', '%s' % second",
        "first.name, first.value",
        "bool(first), bool(second)",
        "int(first), float(second), '%d' % second, hex(second), [*range(100)][second]",
        "isinstance(first, int)",
        "hash(first), hash(second)",
        "Kind(second.value), Kind(second.value) == second",
        "first == second, first != second, first == first",
        "second == second.value, second.value == second, second != second.value, second == float(second)",
        "second == None, second == second.name, second in (None, second.name)",
        "second.value in {second: 1}, second in {second.value: 1}",
        "list(Kind.__members__)",
    ):
        attempt(text, names)
    for text in ("first < second", "first <= 3", "second + 1", "first | second", "-second"):
        attempt(f"refuses(lambda: {text})", names)
for value in (QoSCompatibility.ERROR, SignalHandlerOptions.ALL, TransitionCallbackReturn.ERROR):
    names = {"value": value, "cpp": cpp, "pickle": pickle}
    attempt("getattr(cpp, type(value).__name__) is type(value), pickle.loads(pickle.dumps(value)) == value", names)
