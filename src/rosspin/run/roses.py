"""What runs need to know of ROS 1 and ROS 2."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from importlib import import_module
from types import ModuleType
from typing import Any, NamedTuple

__all__ = ["ROSES", "Ros", "is_of_a_ros", "ros_of"]


class Ros(NamedTuple):
    """One of the ROSes, by its number.

    Importing one of the packages ``roots`` makes a process one of this ROS; the first root is the stand-in's own.
    ``beside`` are packages that its nodes may import, too, and the modules here that stand in for them.
    ``needed`` are the modules that its nodes need besides Python's own. ``naming`` is what names a node on its command
    line, and ``sets`` the option before what is set there, if there is one. ``raises`` says whether Ctrl-C raises
    KeyboardInterrupt in a node, which ends it if no one catches that. ``steps`` is the class that notes its steps. The
    rest completes sentences about a node: what kills it if it does not end, what its loops should check, what its main
    part ends with, what else is a thread, how its loops should sleep; and of these, in C++, the second and the last.
    """

    number: int
    roots: tuple[str, ...]
    beside: Mapping[str, str]
    needed: frozenset[str]
    naming: str
    sets: str
    raises: bool
    steps: str
    kills: str
    goes_on: str
    spins: str
    also_threads: str
    sleep: str
    goes_on_cpp: str
    sleep_cpp: str

    @property
    def stand_in(self) -> ModuleType:
        """The package that stands in for this ROS, loaded only for nodes that may need it, as rclpy is large."""
        return import_module(self.home(self.roots[0]))

    def home(self, package: str) -> str:
        """Return the name of the module here that stands in for one of its packages, or has what does."""
        return f"rosspin.{self.beside.get(package, self.roots[0])}"

    def words(self, flag: str, settings: Iterable[str]) -> list[str]:
        """Return the words of a command line that set parameters (``flag`` is -p) or names (-r), as in ``a:=b``."""
        return [self.sets, *(word for each in settings for word in (flag, each))] if self.sets else list(settings)

    @property
    def tester(self) -> Any:
        """The module of the node that a test plays."""
        return import_module(f"rosspin.{self.roots[0]}.tester")

    @property
    def steps_seen(self) -> Any:
        """The class of the steps of its nodes, as a page shows them. ROS 2's loads rclpy."""
        module, _, name = self.steps.partition(".")
        return getattr(import_module(f"rosspin.run.{module}"), name)


ROSES = {
    1: Ros(
        1,
        ("rospy", "genpy"),
        {
            "actionlib": "rospy.actionlib",
            "message_filters": "rospy.message_filters",
            "rosgraph": "rospy.graph",
            "roslib": "rospy.rospkg",
            "rospkg": "rospy.rospkg",
            "tf": "rospy.tf",
            "tf2_geometry_msgs": "rospy.tf2_geometry_msgs",
            "tf2_py": "rospy.tf2_ros",
            "tf2_ros": "rospy.tf2_ros",
        },
        frozenset({"genpy", "rosgraph", "rosgraph_msgs", "roslib", "rospkg", "rospy", "std_msgs", "yaml"}),
        "__name",
        "",
        False,
        "steps_seen.ThreadsSeen",
        ", as roslaunch does",
        "rospy.is_shutdown()",
        "rospy.spin()",
        " (a rospy.Timer is one, too)",
        "rospy.sleep(0.1)",
        "ros::ok()",
        "ros::Duration(0.1).sleep()",
    ),
    2: Ros(
        2,
        ("rclpy",),
        {
            "ament_index_python": "rclpy.ament_index",
            "message_filters": "rclpy.message_filters",
            "rosidl_parser": "messages.rosidl_parser",
            "rosidl_runtime_py": "rclpy.rosidl_runtime_py",
            "tf2_geometry_msgs": "rclpy.tf2_geometry_msgs",
            "tf2_py": "rclpy.tf2_ros",
            "tf2_ros": "rclpy.tf2_ros",
            "tf_transformations": "rclpy.tf_transformations",
        },
        frozenset(
            {"builtin_interfaces", "rcl_interfaces", "rclpy", "rosgraph_msgs", "rosidl_runtime_py", "rpyutils", "yaml"}
        ),
        "__node",
        "--ros-args",
        True,
        "scenes.Scenes",
        "",
        "rclpy.ok()",
        "rclpy.spin(node)",
        "",
        "time.sleep(0.1)",
        "rclcpp::ok()",
        "rclcpp::sleep_for(100ms)",
    ),
}

_OF_ROOTS = {root: ros for ros in ROSES.values() for root in ros.roots}


def ros_of(module: str) -> Ros | None:
    """Return the ROS to which a module such as rclpy.node belongs by its name; None for any other module."""
    return _OF_ROOTS.get(module.partition(".")[0])


def is_of_a_ros(module: str) -> bool:
    """Whether a module is, by its name, one that only a ROS has."""
    root = module.partition(".")[0]
    known = {name for ros in ROSES.values() for name in (*ros.roots, *ros.beside, *ros.needed)} - {"yaml"}
    return root in known or root.endswith(("_msgs", "_srvs", "_interfaces"))
