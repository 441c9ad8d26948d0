"""tf2_ros and tf2_py for nodes of ROS 1 (sources: tf2_ros 0.7.6, tf2_py.cpp). Loaded when a node imports them."""

from __future__ import annotations

import math
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import Any

from ..clocks.clock import NS
from ..tf2 import buffer as buffer_
from ..tf2.buffer import (
    BufferInterface,
    ConvertRegistration,
    NotImplementedException,
    Stamped,
    TransformRegistration,
    TypeException,
    convert,
)
from ..tf2.exceptions import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from ..tf2.noetic import NoeticFrames
from .action_client import SimpleActionClient
from .core import logwarn
from .rostime import Duration, Time
from .service import Service, ServiceException
from .timer import sleep
from .topics import Publisher, Subscriber

__all__ = [
    "Buffer",
    "BufferClient",
    "BufferCore",
    "BufferInterface",
    "ConnectivityException",
    "ConvertRegistration",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "NotImplementedException",
    "Stamped",
    "StaticTransformBroadcaster",
    "TimeoutException",
    "TransformBroadcaster",
    "TransformException",
    "TransformListener",
    "TransformRegistration",
    "TypeException",
    "convert",
]

DEFAULT_CAN_TRANSFORM_POLLING_SCALE = 0.01  # how often a lookup with a timeout looks, as part of that

_JUMP = Duration(3)  # how far time may go back while a lookup waits


class BufferCore(buffer_.BufferCore):
    """Keeps transforms for ``cache_time`` (10 s), and looks them up."""

    def __init__(self, cache_time: Any = None) -> None:
        keep = 10 * NS if cache_time is None else _nanoseconds(cache_time, "duration")
        self._frames = NoeticFrames(keep, partial(_tell, "Error:   "), partial(_tell, "Warning: "))

    def _nanoseconds(self, time: Any) -> int:
        return _nanoseconds(time)

    def _time(self, nanoseconds: int) -> Time:
        return Time(nanoseconds // NS, nanoseconds % NS)


class Buffer(BufferCore, buffer_.Buffer):
    """Keeps the transforms of the last ``cache_time`` (10 s), and waits for those to come.

    Unless ``debug`` is false, the service ~tf2_frames of the first one tells what it knows.
    """

    def __init__(self, cache_time: Any = None, debug: bool = True) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self.CAN_TRANSFORM_POLLING_SCALE = DEFAULT_CAN_TRANSFORM_POLLING_SCALE
        if debug:
            services = import_module("tf2_msgs.srv")

            def tell(_: Any) -> Any:
                return services.FrameGraphResponse(self.all_frames_as_yaml())

            with suppress(ServiceException):  # another buffer of this node has it
                self.frame_server = Service("~tf2_frames", services.FrameGraph, tell)

    def _wait(self, timeout: Duration, can: Callable[[], tuple[int, str]]) -> None:
        if timeout != Duration(0.0):
            begin = Time.now()
            interval = timeout * self.CAN_TRANSFORM_POLLING_SCALE
            while Time.now() < begin + timeout and not can()[0] and Time.now() + _JUMP >= begin:
                sleep(interval)


class BufferClient(buffer_.BufferClient):
    """Asks the buffer server whose action is ``ns``, and waits for ``timeout_padding`` longer than the server may.

    ``check_frequency`` has no effect.
    """

    def __init__(self, ns: str, check_frequency: Any = None, timeout_padding: Duration = Duration(2)) -> None:
        super().__init__()
        self.client = SimpleActionClient(ns, import_module("tf2_msgs.msg").LookupTransformAction)
        self.timeout_padding = timeout_padding
        if check_frequency is not None:
            logwarn("Argument check_frequency is deprecated and should not be used.")

    def wait_for_server(self, timeout: Duration = Duration()) -> bool:
        """Wait until the server is connected, for at most ``timeout`` (0: no limit). Return whether it is."""
        return self.client.wait_for_server(timeout)

    def _ask(self, **goal: Any) -> Any:
        goal["timeout"] = goal["timeout"] or Duration()
        self.client.send_goal(import_module("tf2_msgs.msg").LookupTransformGoal(**goal))
        if not self.client.wait_for_result(goal["timeout"] + self.timeout_padding):
            raise TimeoutException(f"{_SENT} in the specified time. Something is likely wrong with the server")
        if self.client.get_state() != _SUCCEEDED:
            raise TimeoutException(f"{_SENT} with SUCCEEDED status. Something is likely wrong with the server.")
        return self.client.get_result()


_SENT = "The LookupTransform goal sent to the BufferServer did not come back"
_SUCCEEDED = 3


class TransformListener:
    """Puts into a buffer what is published on /tf and /tf_static. Time that jumps back clears the buffer."""

    def __init__(
        self, buffer: Any, queue_size: int | None = None, buff_size: int = 65536, tcp_nodelay: bool = False
    ) -> None:
        message = import_module("tf2_msgs.msg").TFMessage
        self.buffer = buffer
        self.last_update = Time.now()
        self.last_update_lock = threading.Lock()
        options: dict[str, Any] = {"queue_size": queue_size, "buff_size": buff_size, "tcp_nodelay": tcp_nodelay}
        self.tf_sub = Subscriber("/tf", message, self.callback, **options)
        self.tf_static_sub = Subscriber("/tf_static", message, self.static_callback, **options)

    def unregister(self) -> None:
        """Listen no more."""
        self.tf_sub.unregister()
        self.tf_static_sub.unregister()

    def check_for_reset(self) -> None:
        """Clear the buffer if the time has jumped back."""
        with self.last_update_lock:
            now = Time.now()
            if now < self.last_update:
                back = (self.last_update - now).to_sec()
                logwarn(f"Detected jump back in time of {back:f}s. Clearing TF buffer.")
                self.buffer.clear()
            self.last_update = now

    def callback(self, data: Any) -> None:
        """Take a message from /tf."""
        self._take(data, self.buffer.set_transform)

    def static_callback(self, data: Any) -> None:
        """Take a message from /tf_static."""
        self._take(data, self.buffer.set_transform_static)

    def _take(self, data: Any, put: Callable[[Any, str], None]) -> None:
        self.check_for_reset()
        who = data._connection_header.get("callerid", "default_authority")
        for transform in data.transforms:
            put(transform, who)


class TransformBroadcaster:
    """Publishes transforms on /tf."""

    def __init__(self) -> None:
        self.pub_tf = Publisher("/tf", import_module("tf2_msgs.msg").TFMessage, queue_size=100)

    def sendTransform(self, transform: Any) -> None:
        """Publish a geometry_msgs/TransformStamped, or a list of them."""
        _send(self.pub_tf, transform)


class StaticTransformBroadcaster:
    """Publishes transforms that do not change on /tf_static; who comes later gets the last call's alone."""

    def __init__(self) -> None:
        self.pub_tf = Publisher("/tf_static", import_module("tf2_msgs.msg").TFMessage, queue_size=100, latch=True)

    def sendTransform(self, transform: Any) -> None:
        """Publish a geometry_msgs/TransformStamped, or a list of them."""
        _send(self.pub_tf, transform)


def _send(publisher: Any, transform: Any) -> None:
    transforms = transform if isinstance(transform, list) else [transform]
    publisher.publish(import_module("tf2_msgs.msg").TFMessage(transforms))


def _tell(kind: str, text: str) -> None:
    sys.stderr.write(f"{kind}{text}\n")


def _nanoseconds(time: Any, what: str = "time") -> int:
    """Return a time in ns. tf2_py takes it as a float of seconds, which costs some 100 ns of today's time."""
    if not hasattr(time, "to_sec"):
        raise TypeError(f"{what} must have a to_sec method, e.g. rospy.Time or rospy.Duration")
    fraction, seconds = math.modf(time.to_sec())
    return int(seconds) * NS + math.floor(fraction * NS + 0.5)


def __getattr__(name: str) -> Any:
    if name in _PASSED_ON:
        return getattr(import_module(_PASSED_ON[name]), name)
    raise AttributeError(f"module 'tf2_ros' has no attribute '{name}'", name=name)


# Names that tf2_ros passes on, as its broadcasters import them.
_PASSED_ON = {"TransformStamped": "geometry_msgs.msg", "TFMessage": "tf2_msgs.msg"}

# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = dict.fromkeys(buffer_.MODULES, sys.modules[__name__])
for _name in MODULES:
    globals().setdefault(_name.rpartition(".")[2], sys.modules[__name__])  # so that tf2_ros.buffer is there immediately
