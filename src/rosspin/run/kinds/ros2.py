"""Nodes of ROS 2."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .ros import Ros, Words

if TYPE_CHECKING:
    from ...clocks.frames import Place
    from ...world.graph import Graph
    from ...world.watcher import Watcher

__all__ = ["Ros2"]


class Ros2(Ros):
    number = 2
    roots = ("rclpy",)
    beside = {
        "ament_index_python": "rclpy.ament_index",
        "message_filters": "rclpy.message_filters",
        "rosidl_parser": "messages.rosidl_parser",
        "rosidl_runtime_py": "rclpy.rosidl_runtime_py",
        "tf2_geometry_msgs": "rclpy.tf2_geometry_msgs",
        "tf2_py": "rclpy.tf2_ros",
        "tf2_ros": "rclpy.tf2_ros",
        "tf_transformations": "rclpy.tf_transformations",
    }
    needed = frozenset(
        {"builtin_interfaces", "rcl_interfaces", "rclpy", "rosgraph_msgs", "rosidl_runtime_py", "rpyutils", "yaml"}
    )
    name_key = "__node"
    flag = "--ros-args"
    raises = True
    in_terminals = True
    timers_are_threads = False
    words = Words("rclpy.ok()", "time.sleep(0.1)", "rclpy.spin(node)")
    _steps = "scenes.Scenes"

    @property
    def rate(self) -> Any:
        return self.stand_in.timer.Rate

    def explain_waits(self, graph: Graph, watcher: Watcher | None) -> str:
        return str(self.stand_in.explain_waits(graph, watcher))

    def is_asleep_on_a_rate(self, places: Iterable[Place]) -> bool:
        return bool(self.stand_in.timer.is_asleep_on_a_rate(places))
