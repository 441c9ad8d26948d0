"""tf2_ros and tf2_py for nodes of ROS 2 (sources: tf2_ros_py/tf2_ros, tf2_py.cpp). Loaded when a node imports them."""

from __future__ import annotations

import sys
import threading
import time
import warnings
from collections.abc import Callable
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
from ..tf2.frames import Frames
from .action import ActionClient
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


class Buffer(BufferCore, buffer_.Buffer):
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

    def _wait(self, timeout: Duration, can: Callable[[], tuple[int, str]]) -> None:
        clock = Clock()
        if timeout != Duration():
            end = clock.now() + timeout
            while clock.now() < end and not can()[0]:
                time.sleep(_LOOK)

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


class BufferClient(buffer_.BufferClient):
    """Asks the buffer server whose action is ``ns``, while another thread spins the node.

    Looks ``check_frequency`` times a second whether the server takes too long to accept: longer than it may look up,
    and ``timeout_padding``.
    """

    def __init__(
        self, node: Node, ns: str, check_frequency: float = 10.0, timeout_padding: Duration = Duration(seconds=2.0)
    ) -> None:
        super().__init__()
        self.node = node
        self.action_client = ActionClient(node, import_module("tf2_msgs.action").LookupTransform, action_name=ns)
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Any = None) -> Any:
        """Ask for a transform, for which the server waits for at most ``timeout``. Raises TransformException."""
        if isinstance(time, import_module("builtin_interfaces.msg").Time):
            time = Time.from_msg(time)
            warnings.warn(
                "Passing a builtin_interfaces.msg.Time argument is deprecated, and will be removed in the near future. "
                "Use rclpy.time.Time instead.",
                stacklevel=2,
            )
        elif not isinstance(time, Time):
            raise TypeError("Must pass a rclpy.time.Time object.")
        return super().lookup_transform(target_frame, source_frame, time, timeout)

    def _ask(self, **goal: Any) -> Any:
        limit = goal.pop("timeout") or Duration()
        if not self.action_client.server_is_ready():
            raise TimeoutException("The BufferServer is not ready.")
        fields = {name: value.to_msg() if isinstance(value, Time) else value for name, value in goal.items()}
        accepted = self.action_client.send_goal_async(
            import_module("tf2_msgs.action").LookupTransform.Goal(**fields, timeout=limit.to_msg())
        )
        done = threading.Event()
        accepted.add_done_callback(lambda _: done.set())

        def watch() -> None:
            clock = Clock()
            begin = clock.now()
            while not done.is_set() and clock.now() <= begin + limit + self.timeout_padding:
                time.sleep(1.0 / self.check_frequency)
            done.set()

        threading.Thread(target=watch).start()
        done.wait()
        if not accepted.done():
            raise TimeoutException(f"{_SENT} in the specified time. Something is likely wrong with the server.")
        handle = accepted.result()
        if not handle.accepted:
            raise TimeoutException(f"{_SENT} with accepted status. Something is likely wrong with the server.")
        return self.action_client._get_result(handle).result


_SENT = "The LookupTransform goal sent to the BufferServer did not come back"


class TransformListener:
    """Puts into a buffer what is published on /tf and /tf_static, while someone spins the node.

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


# Names that tf2_ros passes on, as its broadcasters import them; many nodes have them from here.
_PASSED_ON = {"geometry_msgs.msg": "TransformStamped", "tf2_msgs.msg": "TFMessage"}
__getattr__ = passing_on("tf2_ros", _PASSED_ON)


# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = dict.fromkeys(buffer_.MODULES, sys.modules[__name__])
for _name in MODULES:
    globals().setdefault(_name.rpartition(".")[2], sys.modules[__name__])  # so that tf2_ros.buffer is there immediately
