"""tf2_ros and tf2_py for nodes of ROS 2 (sources: tf2_ros_py/tf2_ros, tf2_py.cpp). Loaded when a node imports them."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
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
from ..tf2.frames import Frames
from ..world.world import refusing
from .callback_groups import ReentrantCallbackGroup
from .clock import Clock
from .duration import Duration
from .executors import SingleThreadedExecutor
from .logging import RcutilsLogger
from .node import Node
from .passed_on import passing_on
from .qos import DurabilityPolicy, QoSProfile
from .task import Future
from .time import Time

__all__ = [
    "Buffer",
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

# How often (s) a lookup with a timeout looks.
_LOOK = 0.02


class BufferCore(buffer_.BufferCore):
    """Keeps transforms, and looks them up. Its times may be Times or messages."""

    def __init__(self, cache_time: Any = None) -> None:
        keep = 10 * NS if cache_time is None else _nanoseconds(cache_time, "duration")
        logger = RcutilsLogger()
        self._frames = Frames(keep, logger.error, logger.warning)

    def _nanoseconds(self, time: Any) -> int:
        return _nanoseconds(time)

    def _time(self, nanoseconds: int) -> Time:
        return Time(nanoseconds=nanoseconds)

    def _stamp(self, nanoseconds: int) -> Any:
        return self._time(nanoseconds).to_msg()

    def _message(self) -> Any:
        return import_module("geometry_msgs.msg").TransformStamped()


def Stamped(obj: Any, stamp: Any, frame_id: str) -> Any:
    """Give an object a header, and return it."""
    obj.header = import_module("std_msgs.msg").Header(frame_id=frame_id, stamp=stamp)
    return obj


class Buffer(BufferCore, BufferInterface):
    """Keeps the transforms of the last ``cache_time`` (10 s), and waits for those to come.

    With a ``node``, the service tf2_frames tells what it knows. It is not cleared when the time jumps back.
    """

    def __init__(self, cache_time: Duration | None = None, node: Node | None = None) -> None:
        BufferCore.__init__(self, cache_time)
        BufferInterface.__init__(self)
        self._new_data_callbacks: list[Callable[[], None]] = []
        if node is not None:
            self.srv = node.create_service(import_module("tf2_msgs.srv").FrameGraph, "tf2_frames", self._tell)

    def _tell(self, request: Any, response: Any) -> Any:
        response.frame_yaml = self.all_frames_as_yaml()
        return response

    def _set(self, stamped: Any, authority: str, is_static: bool) -> None:
        super()._set(stamped, authority, is_static)
        for callback in list(self._new_data_callbacks):
            callback()

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Duration = Duration()) -> Any:
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
        timeout: Duration = Duration(),
    ) -> Any:
        """Wait for a transform between two times for at most ``timeout``, and return it. Raises TransformException."""
        self.can_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        return self.lookup_transform_full_core(target_frame, target_time, source_frame, source_time, fixed_frame)

    def can_transform(
        self,
        target_frame: str,
        source_frame: str,
        time: Any,
        timeout: Duration = Duration(),
        return_debug_tuple: bool = False,
    ) -> Any:
        """Whether a lookup would succeed within ``timeout``; with ``return_debug_tuple`` also why not."""
        can = partial(self.can_transform_core, target_frame, source_frame, time)
        return _within(timeout, can, return_debug_tuple)

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = Duration(),
        return_debug_tuple: bool = False,
    ) -> Any:
        """The same for a transform between two times."""
        can = partial(self.can_transform_full_core, target_frame, target_time, source_frame, source_time, fixed_frame)
        return _within(timeout, can, return_debug_tuple)

    def wait_for_transform_async(self, target_frame: str, source_frame: str, time: Any) -> Future:
        """A future whose result is the transform, as soon as it is known."""
        asked = target_frame, source_frame, time
        return self._future(lambda: self.can_transform_core(*asked), lambda: self.lookup_transform_core(*asked))

    def wait_for_transform_full_async(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Future:
        """The same for a transform between two times."""
        asked = target_frame, target_time, source_frame, source_time, fixed_frame
        return self._future(
            lambda: self.can_transform_full_core(*asked), lambda: self.lookup_transform_full_core(*asked)
        )

    def _future(self, can: Callable[[], tuple[int, str]], look_up: Callable[[], Any]) -> Future:
        future = Future()

        def look() -> None:
            if can()[0]:
                future.set_result(look_up())

        look()
        if not future.done():
            self._new_data_callbacks.append(look)
            future.add_done_callback(lambda _: self._new_data_callbacks.remove(look))
        return future

    async def lookup_transform_async(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """Wait for a transform, and return it."""
        await self.wait_for_transform_async(target_frame, source_frame, time)
        return self.lookup_transform_core(target_frame, source_frame, time)

    async def lookup_transform_full_async(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Any:
        """Wait for a transform between two times, and return it."""
        asked = target_frame, target_time, source_frame, source_time, fixed_frame
        await self.wait_for_transform_full_async(*asked)
        return self.lookup_transform_full_core(*asked)


class TransformListener:
    """Puts into a buffer what is published on /tf and /tf_static, while somebody spins the node.

    With ``spin_thread`` a thread of its own does, on an executor of its own.
    """

    def __init__(
        self,
        buffer: Buffer,
        node: Node,
        *,
        spin_thread: bool = False,
        qos: QoSProfile | int | None = None,
        static_qos: QoSProfile | int | None = None,
    ) -> None:
        message = import_module("tf2_msgs.msg").TFMessage
        self.buffer = buffer
        self.node = node
        self.group = ReentrantCallbackGroup()
        qos = QoSProfile(depth=100) if qos is None else qos
        static_qos = _for_ever(100) if static_qos is None else static_qos
        self.tf_sub = node.create_subscription(message, "/tf", self.callback, qos, callback_group=self.group)
        self.tf_static_sub = node.create_subscription(
            message, "/tf_static", self.static_callback, static_qos, callback_group=self.group
        )
        if spin_thread:
            self.executor = SingleThreadedExecutor()

            def run_func() -> None:  # a traceback shows its name
                self.executor.add_node(self.node)
                self.executor.spin()
                self.executor.remove_node(self.node)

            self.dedicated_listener_thread = threading.Thread(target=run_func)
            self.dedicated_listener_thread.start()

    def unregister(self) -> None:
        """Listen no more."""
        self.node.destroy_subscription(self.tf_sub)
        self.node.destroy_subscription(self.tf_static_sub)

    def callback(self, data: Any) -> None:
        """Take a message from /tf."""
        for transform in data.transforms:
            self.buffer.set_transform(transform, "default_authority")

    def static_callback(self, data: Any) -> None:
        """Take a message from /tf_static."""
        for transform in data.transforms:
            self.buffer.set_transform_static(transform, "default_authority")


class TransformBroadcaster:
    """Publishes transforms on /tf."""

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        qos = QoSProfile(depth=100) if qos is None else qos
        self.pub_tf = node.create_publisher(import_module("tf2_msgs.msg").TFMessage, "/tf", qos)

    def sendTransform(self, transform: Any) -> None:
        """Publish a geometry_msgs/TransformStamped, or several."""
        message: Any = self.pub_tf.msg_type
        self.pub_tf.publish(message(transforms=_listed(transform)))


class StaticTransformBroadcaster:
    """Publishes transforms that do not change on /tf_static, all of them each time, also to who comes later.

    As in tf2_ros_py, only the first transform of a child frame is kept.
    """

    def __init__(self, node: Node, qos: QoSProfile | int | None = None) -> None:
        message = import_module("tf2_msgs.msg").TFMessage
        self.pub_tf = node.create_publisher(message, "/tf_static", _for_ever(1) if qos is None else qos)
        self.net_message = message()
        self._child_frame_ids: set[str] = set()

    def sendTransform(self, transform: Any) -> None:
        """Publish a geometry_msgs/TransformStamped, or several, with those before."""
        for each in _listed(transform):
            if each.child_frame_id not in self._child_frame_ids:
                self._child_frame_ids.add(each.child_frame_id)
                self.net_message.transforms.append(each)
        self.pub_tf.publish(self.net_message)


def _within(timeout: Duration, can: Callable[[], tuple[int, str]], with_why: bool) -> Any:
    clock = Clock()
    if timeout != Duration():
        end = clock.now() + timeout
        while clock.now() < end and not can()[0]:
            time.sleep(_LOOK)
    found = can()
    return found if with_why else found[0]


def _listed(transforms: Any) -> list[Any]:
    return list(transforms) if hasattr(transforms, "__iter__") else [transforms]


def _for_ever(depth: int) -> QoSProfile:
    return QoSProfile(depth=depth, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def _nanoseconds(time: Any, what: str = "time") -> int:
    if hasattr(time, "sec") and hasattr(time, "nanosec"):
        return int(time.sec) * NS + int(time.nanosec)
    if hasattr(time, "nanoseconds"):
        return int(time.nanoseconds)
    raise TypeError(f"{what} must have sec and nanosec, or nanoseconds.")


_refuse = refusing("tf2_ros", {"BufferClient"})
# Names that tf2_ros passes on, as its broadcasters import them; many nodes have them from here.
_PASSED_ON = {"geometry_msgs.msg": "TransformStamped", "tf2_msgs.msg": "TFMessage"}
_pass_on = passing_on("tf2_ros", _PASSED_ON)


def __getattr__(name: str) -> Any:
    return _pass_on(name) if name in _PASSED_ON.values() else _refuse(name)


# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = dict.fromkeys(
    (
        *("tf2_py", "tf2_ros", "tf2_ros.buffer", "tf2_ros.buffer_interface", "tf2_ros.static_transform_broadcaster"),
        *("tf2_ros.transform_broadcaster", "tf2_ros.transform_listener"),
    ),
    sys.modules[__name__],
)
for _name in MODULES:
    globals().setdefault(_name.rpartition(".")[2], sys.modules[__name__])  # so that tf2_ros.buffer is there immediately
