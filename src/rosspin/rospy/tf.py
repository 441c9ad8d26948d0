"""tf for nodes of ROS 1, on tf2_ros (source: tf/listener.py, broadcaster.py 1.13.2). Loaded when a node imports it."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib import import_module
from types import ModuleType
from typing import Any

from ..tf2 import transformations as core
from ..world.world import refusing
from . import tf2_ros, transformations
from .rostime import Time
from .tf2_ros import ConnectivityException, ExtrapolationException, LookupException, TransformException

__all__ = [
    "ConnectivityException",
    "Exception",
    "ExtrapolationException",
    "LookupException",
    "TransformBroadcaster",
    "TransformListener",
    "Transformer",
    "TransformerROS",
]

Exception = TransformException

numpy: Any = core.numpy


class Transformer:
    """Keeps transforms for ``cache_time`` (10 s), and looks them up."""

    def __init__(self, interpolate: bool = True, cache_time: Any = None) -> None:
        self._buffer = tf2_ros.Buffer(cache_time, debug=False)
        self._using_dedicated_thread = False

    def allFramesAsString(self) -> str:
        """The tree, a line for each frame with a parent."""
        return self._buffer.all_frames_as_string()

    def setTransform(self, transform: Any, authority: str = "default_authority") -> None:
        """Add a geometry_msgs/TransformStamped."""
        self._buffer.set_transform(transform, authority)

    def canTransform(self, target_frame: str, source_frame: str, time: Any) -> Any:
        """Whether a lookup would succeed now."""
        return self._buffer.can_transform(_bare(target_frame), _bare(source_frame), time)

    def canTransformFull(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> Any:
        """The same for a transform between two times."""
        frames = _bare(target_frame), target_time, _bare(source_frame), source_time, _bare(fixed_frame)
        return self._buffer.can_transform_full(*frames)

    def waitForTransform(
        self, target_frame: str, source_frame: str, time: Any, timeout: Any, polling_sleep_duration: Any = None
    ) -> None:
        """Wait for a transform for at most ``timeout``. Raises tf.Exception if it does not come."""
        self._wait(self._buffer.can_transform, (_bare(target_frame), _bare(source_frame), time, timeout))

    def waitForTransformFull(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Any,
        polling_sleep_duration: Any = None,
    ) -> None:
        """The same for a transform between two times."""
        frames = _bare(target_frame), target_time, _bare(source_frame), source_time, _bare(fixed_frame)
        self._wait(self._buffer.can_transform_full, (*frames, timeout))

    def _wait(self, can: Any, asked: tuple[Any, ...]) -> None:
        if not self._using_dedicated_thread:
            raise TransformException(
                "cannot wait for transform without a dedicated thread that listens to incoming TF messages"
            )
        found, why = can(*asked, return_debug_tuple=True)
        if not found:
            raise TransformException(why or "no such transformation")

    def clear(self) -> None:
        """Forget all but static transforms."""
        self._buffer.clear()

    def frameExists(self, frame_id: str) -> bool:
        """Whether a frame is known that has a parent."""
        return frame_id in self.getFrameStrings()

    def getFrameStrings(self) -> list[str]:
        """The frames that have a parent."""
        frames = import_module("yaml").safe_load(self._buffer.all_frames_as_yaml())
        return list(frames or {})

    def getLatestCommonTime(self, source_frame: str, dest_frame: str) -> Any:
        """The latest time for which the transform is known. Raises tf.Exception."""
        return self._buffer.get_latest_common_time(_bare(source_frame), _bare(dest_frame))

    def lookupTransform(self, target_frame: str, source_frame: str, time: Any) -> tuple[list[float], list[float]]:
        """The transform: a translation and a quaternion. Raises tf.Exception."""
        return _parts(self._buffer.lookup_transform(_bare(target_frame), _bare(source_frame), time))

    def lookupTransformFull(
        self, target_frame: str, target_time: Any, source_frame: str, source_time: Any, fixed_frame: str
    ) -> tuple[list[float], list[float]]:
        """The transform between two times."""
        frames = _bare(target_frame), target_time, _bare(source_frame), source_time, _bare(fixed_frame)
        return _parts(self._buffer.lookup_transform_full(*frames))

    def setUsingDedicatedThread(self, value: bool) -> None:
        """Say whether something fills the buffer by itself."""
        self._using_dedicated_thread = value

    def getTFPrefix(self) -> str:
        """The prefix of frames: there is none."""
        return ""

    def __getattr__(self, name: str) -> Any:
        return refusing("tf.Transformer", {"allFramesAsDot", "chain", "lookupTwist", "lookupTwistFull"})(name)


class TransformerROS(Transformer):
    """Transforms messages, too. Its methods raise tf.Exception."""

    def asMatrix(self, target_frame: str, hdr: Any) -> Any:
        """The transform from a header's frame, at its time, as a matrix (4 x 4)."""
        return self.fromTranslationRotation(*self.lookupTransform(target_frame, hdr.frame_id, hdr.stamp))

    def fromTranslationRotation(self, translation: Sequence[float], rotation: Sequence[float]) -> Any:
        """A translation and a quaternion as a matrix."""
        turn = core.quaternion_matrix(rotation)
        return numpy.dot(core.translation_matrix(translation), turn)

    def transformPoint(self, target_frame: str, ps: Any) -> Any:
        """Transform a geometry_msgs/PointStamped."""
        made = self._made("PointStamped", target_frame, ps)
        made.point = _moved(self.asMatrix(target_frame, ps.header), ps.point, "Point")
        return made

    def transformVector3(self, target_frame: str, v3s: Any) -> Any:
        """Transform a geometry_msgs/Vector3Stamped."""
        matrix = self.asMatrix(target_frame, v3s.header)
        matrix[:3, 3] = 0.0
        made = self._made("Vector3Stamped", target_frame, v3s)
        made.vector = _moved(matrix, v3s.vector, "Vector3")
        return made

    def transformQuaternion(self, target_frame: str, ps: Any) -> Any:
        """Transform a geometry_msgs/QuaternionStamped."""
        matrix = numpy.dot(self.asMatrix(target_frame, ps.header), _turn(ps.quaternion))
        made = self._made("QuaternionStamped", target_frame, ps)
        made.quaternion = _quaternion(matrix)
        return made

    def transformPose(self, target_frame: str, ps: Any) -> Any:
        """Transform a geometry_msgs/PoseStamped."""
        place = ps.pose.position
        own = numpy.dot(core.translation_matrix((place.x, place.y, place.z)), _turn(ps.pose.orientation))
        matrix = numpy.dot(self.asMatrix(target_frame, ps.header), own)
        geometry = import_module("geometry_msgs.msg")
        made = self._made("PoseStamped", target_frame, ps)
        made.pose = geometry.Pose(geometry.Point(*matrix[:3, 3]), _quaternion(matrix))
        return made

    def transformPointCloud(self, target_frame: str, point_cloud: Any) -> Any:
        """Transform a sensor_msgs/PointCloud."""
        made = import_module("sensor_msgs.msg").PointCloud(channels=point_cloud.channels)
        made.header.stamp, made.header.frame_id = point_cloud.header.stamp, target_frame
        matrix = self.asMatrix(target_frame, point_cloud.header)
        made.points = [_moved(matrix, point, "Point") for point in point_cloud.points]
        return made

    def _made(self, kind: str, frame: str, given: Any) -> Any:
        made = getattr(import_module("geometry_msgs.msg"), kind)()
        made.header.stamp, made.header.frame_id = given.header.stamp, frame
        return made


class TransformListener(TransformerROS):
    """A transformer that hears what is published on /tf and /tf_static."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._listener = tf2_ros.TransformListener(self._buffer)
        self.setUsingDedicatedThread(True)


class TransformBroadcaster:
    """Publishes transforms on /tf."""

    def __init__(self, queue_size: int = 100) -> None:
        self.tf2_broadcaster = tf2_ros.TransformBroadcaster()

    def sendTransform(
        self, translation: Sequence[float], rotation: Sequence[float], time: Time, child: str, parent: str
    ) -> None:
        """Publish where ``child`` is in ``parent``: a translation and a quaternion."""
        made = import_module("geometry_msgs.msg").TransformStamped(child_frame_id=child)
        made.header.frame_id, made.header.stamp = parent, time
        move, turn = made.transform.translation, made.transform.rotation
        move.x, move.y, move.z = translation[:3]
        turn.x, turn.y, turn.z, turn.w = rotation[:4]
        self.sendTransformMessage(made)

    def sendTransformMessage(self, transform: Any) -> None:
        """Publish a geometry_msgs/TransformStamped."""
        self.tf2_broadcaster.sendTransform([transform])


def _bare(frame: str) -> str:
    return frame.removeprefix("/")


def _parts(message: Any) -> tuple[list[float], list[float]]:
    move, turn = message.transform.translation, message.transform.rotation
    return [move.x, move.y, move.z], [turn.x, turn.y, turn.z, turn.w]


def _moved(matrix: Any, vector: Any, kind: str) -> Any:
    moved = numpy.dot(matrix, (vector.x, vector.y, vector.z, 1.0))
    return getattr(import_module("geometry_msgs.msg"), kind)(*moved[:3])


def _turn(quaternion: Any) -> Any:
    return core.quaternion_matrix((quaternion.x, quaternion.y, quaternion.z, quaternion.w))


def _quaternion(matrix: Any) -> Any:
    return import_module("geometry_msgs.msg").Quaternion(*core.quaternion_from_matrix(matrix))


# What a node may import, by its name on a real ROS.
MODULES: dict[str, ModuleType] = {
    **dict.fromkeys(("tf", "tf.broadcaster", "tf.listener"), sys.modules[__name__]),
    "tf.transformations": transformations,
}
broadcaster = listener = sys.modules[__name__]
