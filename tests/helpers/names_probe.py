"""A node that draws names and times at random and prints what comes of them: ``names_probe.py SEED COUNT``.

It needs no master. All of it is drawn before it is used, so that one difference causes no others.
"""

from __future__ import annotations

import copy
import operator
import pickle
import random
import sys
from collections.abc import Callable
from typing import Any

import genpy
import genpy.rostime
import rospy
import rospy.core
import rospy.names
from rospy.impl.validators import non_empty

seed, count = int(sys.argv[1]), int(sys.argv[2])
draw = random.Random(seed)
sys.stderr = sys.stdout  # of a bad remapping in its place


def show(what: str, function: Callable[..., Any], *args: Any) -> None:
    """Print what a call gives, or how it fails."""
    try:
        result = describe(function(*args))
    except Exception as error:
        result = type(error).__name__
        if not isinstance(error, (ArithmeticError, AttributeError, TypeError)):  # Python's own texts change
            result += f": {error}"
    print(what, *map(describe, args), "->", result)


def describe(value: Any) -> str:
    """A value in words, with its class and its fields if it is a time."""
    if isinstance(value, genpy.rostime.TVal):
        return f"{value!r} {type(value).__name__} {value.secs!r} {value.nsecs!r}"
    return repr(value)


# --- names ------------------------------------------------------------------------------------------------------------

PARTS = ["a", "b1", "c_d", "__e", "~", "/", "//", ":", ":=", " ", "", "é", "1", "\n"]


def any_name() -> Any:
    return draw.choice([None, 1, ""]) if draw.random() < 0.03 else "".join(draw.choices(PARTS, k=draw.randint(1, 4)))


def any_node() -> str:
    return draw.choice(["", "/"]) + "/".join(draw.choices(["n", "m", "", "o/p"], k=draw.randint(0, 3)))


def truth(function: Callable[..., Any]) -> Callable[..., bool]:
    return lambda *args: bool(function(*args))


def checked(check: Callable[..., Any], *args: Any) -> Callable[..., Any]:
    return lambda value, caller: check("parameter", *args)(value, caller)


UNARY = {
    "canonicalize_name": rospy.names.canonicalize_name,
    "namespace": rospy.names.namespace,
    "make_global_ns": rospy.names.make_global_ns,
    "is_global": truth(rospy.names.is_global),
    "is_private": truth(rospy.names.is_private),
    "isstring": rospy.names.isstring,
    "resolve_name": rospy.names.resolve_name,
    "resolve_name_without_node_name": rospy.names.resolve_name_without_node_name,
    "remap_name": rospy.names.remap_name,
}
BINARY = {
    "resolve_name": rospy.names.resolve_name,
    "remap_name": rospy.names.remap_name,
    "valid_name": checked(rospy.names.valid_name),
    "valid_name unresolved": checked(rospy.names.valid_name, False),
    "global_name": checked(rospy.names.global_name),
    "is_topic": checked(rospy.core.is_topic),
    "non_empty": checked(non_empty),
}

print(rospy.names.TOPIC_ANYTYPE, rospy.names.SERVICE_ANYTYPE, rospy.names.REMAP, rospy.names.SEP, rospy.names.GLOBALNS)
for _ in range(count):
    command_line = [f"{any_name()}:={any_name()}" for _ in range(3)]
    names, node = [any_name() for _ in range(4)], any_node()
    show("load_mappings", rospy.names.load_mappings, command_line)
    show("myargv", rospy.myargv, command_line)
    show("get_ros_namespace", rospy.names.get_ros_namespace, {"ROS_NAMESPACE": names[0] or ""}, [])
    show("get_ros_namespace", rospy.names.get_ros_namespace, {}, [f"__ns:={names[1]}"])
    rospy.names.reload_mappings(command_line)
    show("get_mappings", rospy.names.get_mappings)
    rospy.names._set_caller_id(node)
    show("initialize_mappings", rospy.names.initialize_mappings, node)
    show("get_resolved_mappings", rospy.names.get_resolved_mappings)
    show("get_name", rospy.names.get_name)
    show("get_namespace", rospy.names.get_namespace)
    for name in [*names, *rospy.names.get_mappings()]:
        for what, function in UNARY.items():
            show(what, function, name)
        for what, function in BINARY.items():
            show(what, function, name, node)
        show("ns_join", rospy.names.ns_join, node, name)
        show("scoped_name", rospy.names.scoped_name, node, name)

# --- times ------------------------------------------------------------------------------------------------------------

KINDS = [rospy.Time, rospy.Duration, genpy.Time, genpy.Duration, genpy.rostime.TVal]
OPERATORS = [
    *(operator.add, operator.sub, operator.mul, operator.truediv, operator.floordiv, operator.mod, divmod),
    *(operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge),
]
METHODS = ["is_zero", "to_sec", "to_nsec", "to_time", "canon", "__str__", "__repr__", "__bool__"]


def any_number() -> Any:
    size = draw.choice([1, 10, 10**9, 10**10, 2**31])
    return draw.choice([0, 1, -1, True, draw.randint(-size, size), draw.uniform(-size, size), 0.5])


def any_fields() -> tuple[Any, ...]:
    return draw.choice([(), (any_number(),), (any_number(), any_number()), (draw.randint(0, 9), draw.randint(0, 9))])


def any_value() -> Any:
    """A time, often one whose fields were set by hand, or a plain number or text."""
    if draw.random() < 0.15:
        return draw.choice([any_number(), "1", None])
    kind, fields, by_hand = draw.choice(KINDS), any_fields(), (draw.randint(-3, 3), draw.randint(-(2**31), 2**31))
    try:
        value = kind(*fields)
    except (TypeError, ValueError):
        value = kind()
    if draw.random() < 0.1 and kind is not genpy.rostime.TVal:  # as a program may set them
        value.set(*by_hand)
    return value


def call(name: str) -> Callable[..., Any]:
    return lambda value: getattr(value, name)()


for _ in range(count):
    kind, fields = draw.choice(KINDS), any_fields()
    show(kind.__name__, kind, *fields)
    show("from_sec", kind.from_sec, any_number())
    one, other = any_value(), any_value()
    for function in OPERATORS:
        show(function.__name__, function, copy.copy(one), copy.copy(other))
    for name in METHODS:
        show(name, call(name), copy.copy(one))
    if isinstance(one, genpy.rostime.TVal):
        show("hash", hash, one)
    show("negative", operator.neg, one)
    show("absolute", abs, one)
    show("pickled", lambda value: pickle.loads(pickle.dumps(value)), one)
    show("deep copy", copy.deepcopy, one)

print(genpy.rostime.TVal.__slots__, genpy.rostime.TVal._slot_types)
show("set_rostime", rospy.rostime._set_rostime, 1.0)
rospy.rostime.set_rostime_initialized(True)
for value in (genpy.Time(4, 5), rospy.Time(1)):
    show("set_rostime", rospy.rostime._set_rostime, value)
    print(rospy.rostime.is_wallclock(), rospy.rostime.is_rostime_initialized(), repr(rospy.get_rostime()))
with rospy.rostime.get_rostime_cond():
    rospy.rostime.get_rostime_cond().notify_all()
rospy.rostime.switch_to_wallclock()
print(rospy.rostime.is_wallclock())
