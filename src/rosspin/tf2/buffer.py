"""What tf2_py and tf2_ros have in both ROSes (sources: tf2_py.cpp, tf2_ros/buffer_interface.py).

Each ROS adds what its times are, and its messages.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from copy import deepcopy
from functools import partial
from importlib import import_module
from typing import Any

from .exceptions import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from .frames import Frames
from .geometry import Transform

__all__ = [
    "MODULES",
    "Buffer",
    "BufferClient",
    "BufferCore",
    "BufferInterface",
    "ConvertRegistration",
    "NotImplementedException",
    "Stamped",
    "TransformRegistration",
    "TypeException",
    "convert",
]

# The modules of both packages, which all have the same names here.
MODULES = (
    *("tf2_py", "tf2_ros", "tf2_ros.buffer", "tf2_ros.buffer_client", "tf2_ros.buffer_interface"),
    *("tf2_ros.static_transform_broadcaster", "tf2_ros.transform_broadcaster", "tf2_ros.transform_listener"),
)


class BufferCore:
    """Keeps transforms, and looks them up."""

    _frames: Frames

    def set_transform(self, transform: Any, authority: str) -> None:
        """Add a geometry_msgs/TransformStamped that ``authority`` has sent. One that is faulty is only logged."""
        self._set(transform, authority, False)

    def set_transform_static(self, transform: Any, authority: str) -> None:
        """Add one that holds forever."""
        self._set(transform, authority, True)

    def _set(self, stamped: Any, authority: str, is_static: bool) -> None:
        header, move, turn = stamped.header, stamped.transform.translation, stamped.transform.rotation
        x, y, z, a, b, c, d = map(float, (move.x, move.y, move.z, turn.x, turn.y, turn.z, turn.w))
        transform = Transform((x, y, z), (a, b, c, d))
        stamp = self._nanoseconds(header.stamp)
        self._frames.add(header.frame_id, stamped.child_frame_id, stamp, transform, authority, is_static)

    def lookup_transform_core(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """The transform from ``source_frame`` to ``target_frame``, as a message. Raises TransformException."""
        found = self._frames.find(target_frame, source_frame, self._nanoseconds(time))
        return self._stamped(target_frame, source_frame, *found)

    def lookup_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Any:
        """The transform from a frame at one time to another at another time; ``fixed_frame`` has not moved between."""
        times = self._nanoseconds(target_time), self._nanoseconds(source_time)
        found = self._frames.find_full(target_frame, times[0], source_frame, times[1], fixed_frame)
        return self._stamped(target_frame, source_frame, *found)

    def can_transform_core(self, target_frame: str, source_frame: str, time: Any) -> tuple[int, str]:
        """Whether the lookup would succeed, and why not."""
        why = self._frames.why_not(target_frame, source_frame, self._nanoseconds(time))
        return int(why == ""), why or ""

    def can_transform_full_core(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[int, str]:
        """Whether the lookup would succeed, and why not."""
        times = self._nanoseconds(target_time), self._nanoseconds(source_time)
        why = self._frames.why_not_full(target_frame, times[0], source_frame, times[1], fixed_frame)
        return int(why == ""), why or ""

    def get_latest_common_time(self, target_frame: str, source_frame: str) -> Any:
        """The latest time for which the transform is known. Raises TransformException."""
        for frame in (target_frame, source_frame):
            self._frames.check(frame, "get_latest_common_time")
        try:
            return self._time(self._frames.latest_common_time(target_frame, source_frame))
        except TransformException as error:
            raise TransformException(*error.args) from None

    def clear(self) -> None:
        """Forget all but static transforms."""
        self._frames.clear()

    def all_frames_as_string(self) -> str:
        """The tree, a line for each frame with a parent."""
        return self._frames.as_string()

    def all_frames_as_yaml(self) -> str:
        """The tree in YAML."""
        return self._frames.as_yaml()

    def _frameExists(self, frame: str) -> bool:
        return frame in self._frames

    def _getFrameStrings(self) -> list[str]:
        return list(self._frames)

    def _nanoseconds(self, time: Any) -> int:
        """Return a time of this ROS in ns. Raises an error for what is none."""
        raise NotImplementedError

    def _time(self, nanoseconds: int) -> Any:
        """Return a time of this ROS."""
        raise NotImplementedError

    def _stamped(self, target: str, source: str, transform: Transform, time: int) -> Any:
        """Return a geometry_msgs/TransformStamped of this ROS."""
        message = self._message()
        message.child_frame_id = source
        message.header.frame_id = target
        message.header.stamp = self._stamp(time)
        move, turn = message.transform.translation, message.transform.rotation
        move.x, move.y, move.z = transform.translation
        turn.x, turn.y, turn.z, turn.w = transform.rotation
        return message

    def _message(self) -> Any:
        return import_module("geometry_msgs.msg").TransformStamped()

    def _stamp(self, nanoseconds: int) -> Any:
        """Return a time as a message has it."""
        return self._time(nanoseconds)


class TypeException(Exception):
    """It is not known how to transform, or convert, what has this type."""

    def __init__(self, errstr: str) -> None:
        self.errstr = errstr


class NotImplementedException(Exception):
    """A buffer cannot look up."""

    def __init__(self) -> None:
        self.errstr = "CanTransform or LookupTransform not implemented"


for _class in (NotImplementedException, TypeException):
    _class.__module__ = "tf2_ros.buffer_interface"  # which tracebacks show


class _Registration:
    """Functions by what they are for. All of one kind have the same ones.

    tf2_geometry_msgs's are there if the node has imported it, for its own messages.
    """

    def _get(self, functions: dict[Any, Callable[..., Any]], key: Any, beside: str = "") -> Callable[..., Any]:
        if key in functions:
            return functions[key]
        known = getattr(sys.modules.get("tf2_geometry_msgs"), beside, {})
        if getattr(key, "__module__", "").startswith("geometry_msgs.msg.") and key.__name__ in known:
            return known[key.__name__]  # type: ignore[no-any-return]
        raise TypeException(f"Type {key} is not loaded or supported")


class TransformRegistration(_Registration):
    """How objects of a type are transformed."""

    _functions: dict[Any, Callable[..., Any]] = {}

    def print_me(self) -> None:
        """Print what is known."""
        print(self._functions)

    def add(self, key: Any, callback: Callable[..., Any]) -> None:
        """Have ``callback(object, transform)`` transform objects of this type."""
        self._functions[key] = callback

    def get(self, key: Any) -> Callable[..., Any]:
        """What transforms objects of this type. Raises TypeException."""
        return self._get(self._functions, key, "TRANSFORMS")


class ConvertRegistration(_Registration):
    """How objects of a type become messages, and others."""

    _to_msg: dict[Any, Callable[..., Any]] = {}
    _from_msg: dict[Any, Callable[..., Any]] = {}
    _convert: dict[Any, Callable[..., Any]] = {}

    def add_from_msg(self, key: Any, callback: Callable[..., Any]) -> None:
        """Have ``callback(message)`` make an object of this type."""
        self._from_msg[key] = callback

    def add_to_msg(self, key: Any, callback: Callable[..., Any]) -> None:
        """Have ``callback(object)`` make a message of an object of this type."""
        self._to_msg[key] = callback

    def add_convert(self, key: Any, callback: Callable[..., Any]) -> None:
        """Have ``callback(object)`` convert for this pair of types."""
        self._convert[key] = callback

    def get_from_msg(self, key: Any) -> Callable[..., Any]:
        """What makes an object of this type of a message. Raises TypeException."""
        return self._get(self._from_msg, key, "CONVERTS")

    def get_to_msg(self, key: Any) -> Callable[..., Any]:
        """What makes a message of an object of this type. Raises TypeException."""
        return self._get(self._to_msg, key, "CONVERTS")

    def get_convert(self, key: Any) -> Callable[..., Any]:
        """What converts for this pair of types. Raises TypeException."""
        return self._get(self._convert, key)


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:
    """Give an object a header, and return it."""
    obj.header = import_module("std_msgs.msg").Header(frame_id=frame_id, stamp=stamp)
    return obj


def convert(a: Any, b_type: Any) -> Any:
    """Convert an object to a type, directly or by way of a message. Raises TypeException."""
    known = ConvertRegistration()
    try:
        return known.get_convert((type(a), b_type))(a)
    except TypeException:
        if type(a) is b_type:
            return deepcopy(a)
        to_message, from_message = known.get_to_msg(type(a)), known.get_from_msg(b_type)
        return from_message(to_message(a))


class BufferInterface:
    """Transforms what has a stamp, by a lookup that a subclass has."""

    def __init__(self) -> None:
        self.registration = TransformRegistration()

    def transform(self, object_stamped: Any, target_frame: str, timeout: Any = None, new_type: Any = None) -> Any:
        """Transform an object into a frame, waiting for at most ``timeout``; convert it to ``new_type``, if given.

        Raises TypeException for an object that nothing is known of: import what transforms it, such as
        tf2_geometry_msgs. Raises what a lookup raises.
        """
        do_transform = self.registration.get(type(object_stamped))
        header = object_stamped.header
        wait = () if timeout is None else (timeout,)
        found = do_transform(object_stamped, self.lookup_transform(target_frame, header.frame_id, header.stamp, *wait))
        return convert(found, new_type) if new_type else found

    def transform_full(
        self,
        object_stamped: Any,
        target_frame: str,
        target_time: Any,
        fixed_frame: str,
        timeout: Any = None,
        new_type: Any = None,
    ) -> Any:
        """The same into a frame at another time."""
        do_transform = self.registration.get(type(object_stamped))
        asked = target_frame, target_time, object_stamped.header.frame_id, object_stamped.header.stamp, fixed_frame
        wait = () if timeout is None else (timeout,)
        found = do_transform(object_stamped, self.lookup_transform_full(*asked, *wait))
        return convert(found, new_type) if new_type else found

    def lookup_transform(self, *args: Any, **kwargs: Any) -> Any:
        """Raises NotImplementedException."""
        raise NotImplementedException

    lookup_transform_full = can_transform = can_transform_full = lookup_transform


class Buffer(BufferCore, BufferInterface):
    """Waits for transforms to come. A ROS says how, in ``_wait``."""

    def _wait(self, timeout: Any, can: Callable[[], tuple[int, str]]) -> None:
        """Wait until a lookup ``can`` succeed, for at most ``timeout``, a duration of this ROS."""
        raise NotImplementedError

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Any = None) -> Any:
        """Wait for a transform for at most ``timeout``, and return it. Raises TransformException."""
        self.can_transform(target_frame, source_frame, time, timeout)
        return self.lookup_transform_core(target_frame, source_frame, time)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = None,
    ) -> Any:
        """Wait for a transform between two times for at most ``timeout``, and return it. Raises TransformException."""
        self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def can_transform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Any = None, return_debug_tuple: bool = False
    ) -> Any:
        """Whether a lookup would succeed within ``timeout``; with ``return_debug_tuple`` also why not."""
        can = partial(self.can_transform_core, target_frame, source_frame, time)
        return self._within(timeout, can, return_debug_tuple)

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = None,
        return_debug_tuple: bool = False,
    ) -> Any:
        """The same for a transform between two times."""
        can = partial(self.can_transform_full_core, target_frame, target_time, source_frame, source_time, fixed_frame)
        return self._within(timeout, can, return_debug_tuple)

    def _within(self, timeout: Any, can: Callable[[], tuple[int, str]], with_why: bool) -> Any:
        if timeout is not None:
            self._wait(timeout, can)
        found = can()
        return found if with_why else found[0]


class BufferClient(BufferInterface):
    """Asks the action of a buffer server for transforms. A ROS says how, in ``_ask``."""

    def _ask(self, **goal: Any) -> Any:
        """Send a goal of tf2_msgs/LookupTransform with these fields, and return the result. Raises TimeoutException."""
        raise NotImplementedError

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Any = None) -> Any:
        """Ask for a transform, for which the server waits for at most ``timeout``. Raises TransformException."""
        asked = {"target_frame": target_frame, "source_frame": source_frame, "source_time": time}
        return _answer(self._ask(**asked, timeout=timeout, advanced=False))

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any = None,
    ) -> Any:
        """The same for a transform between two times."""
        asked = {"target_frame": target_frame, "source_frame": source_frame, "source_time": source_time}
        full = {"target_time": target_time, "fixed_frame": fixed_frame}
        return _answer(self._ask(**asked, **full, timeout=timeout, advanced=True))

    def can_transform(self, *args: Any, **kwargs: Any) -> bool:
        """Whether ``lookup_transform`` with these arguments succeeds."""
        return _succeeds(self.lookup_transform, *args, **kwargs)

    def can_transform_full(self, *args: Any, **kwargs: Any) -> bool:
        """The same for a transform between two times."""
        return _succeeds(self.lookup_transform_full, *args, **kwargs)


def _succeeds(look_up: Callable[..., Any], *args: Any, **kwargs: Any) -> bool:
    try:
        look_up(*args, **kwargs)
    except TransformException:
        return False
    return True


# By the numbers of tf2_msgs/TF2Error.
_ERRORS = {
    1: LookupException,
    2: ConnectivityException,
    3: ExtrapolationException,
    4: InvalidArgumentException,
    5: TimeoutException,
}


def _answer(result: Any) -> Any:
    error = result.error
    if error.error != error.NO_ERROR:
        raise _ERRORS.get(error.error, TransformException)(error.error_string)
    return result.transform
