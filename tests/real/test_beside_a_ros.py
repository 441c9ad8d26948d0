"""A program that has imported messages of a real ROS hands them to a node in simulated time."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from textwrap import dedent

import greenlet
import yaml

from rosspin.real import ros2
from tests.helpers.tree import ROOT

ROS2 = """
    from geometry_msgs.msg import Point, Pose, PoseArray, PoseWithCovarianceStamped, Twist
    from std_msgs.msg import UInt32
    from std_srvs.srv import SetBool
    import rosspin

    def node():
        import rclpy
        from geometry_msgs.msg import PoseArray, PoseWithCovarianceStamped
        from std_msgs.msg import UInt32
        from std_srvs.srv import SetBool

        rclpy.init()
        node = rclpy.create_node("n")
        node.create_subscription(UInt32, "/number", lambda heard: print(heard.data), 10)
        node.create_subscription(PoseArray, "/poses", lambda heard: print([p.position.x for p in heard.poses]), 10)
        node.create_subscription(
            PoseWithCovarianceStamped, "/pose",
            lambda heard: print(heard.header.frame_id, heard.header.stamp.sec, heard.pose.covariance[3]), 10)
        node.create_service(SetBool, "/set", lambda request, response: (print(request.data), response)[1])
        rclpy.spin(node)

    with rosspin.start(node) as node:
        node.publish("/number", UInt32(data=5))
        node.publish("/poses", PoseArray(poses=[Pose(position=Point(x=2.0)), Pose()]))
        pose = PoseWithCovarianceStamped()
        pose.header.frame_id, pose.header.stamp.sec, pose.pose.covariance[3] = "map", 3, 1.5
        node.publish("/pose", pose)
        node.call("/set", SetBool.Request(data=True))
        node.advance(0.1)
        print(node.run.console, end="")
        try:
            node.publish("/number", Twist())
        except TypeError as error:
            print(error)
"""

ROS1 = """
    import sys
    sys.path.append("/usr/lib/python3/dist-packages")
    from geometry_msgs.msg import PoseStamped
    from std_msgs.msg import UInt32
    from std_srvs.srv import SetBoolRequest
    import rosspin

    def node():
        import rospy
        from geometry_msgs.msg import PoseStamped
        from std_msgs.msg import UInt32
        from std_srvs.srv import SetBool, SetBoolResponse

        rospy.init_node("n")
        rospy.Subscriber("/number", UInt32, lambda heard: print(heard.data))
        rospy.Subscriber("/pose", PoseStamped, lambda heard: print(heard.header.frame_id, heard.header.stamp.secs))
        rospy.Service("/set", SetBool, lambda request: (print(request.data), SetBoolResponse(True, ""))[1])
        rospy.spin()

    with rosspin.start(node) as node:
        node.publish("/number", UInt32(data=5))
        pose = PoseStamped()
        pose.header.frame_id, pose.header.stamp.secs = "map", 3
        node.publish("/pose", pose)
        node.call("/set", SetBoolRequest(data=True))
        node.advance(0.1)
        print(node.run.console, end="")
"""


def output_of(python: str, text: str, environment: dict[str, str]) -> str:
    """What a Python prints that can import this package, too."""
    needed = [str(ROOT / "src"), *{str(Path(module.__path__[0]).parent) for module in (greenlet, yaml)}]
    path = os.pathsep.join([*needed, *filter(None, [environment.get("PYTHONPATH")])])
    run = subprocess.run(
        [python, "-c", dedent(text)], env={**environment, "PYTHONPATH": path}, capture_output=True, text=True
    )
    assert run.stderr == ""
    return run.stdout


def test_messages_of_the_real_ros2(require: Callable[[str], None]) -> None:
    require("ros2")
    with ros2.Nodes() as nodes:
        said = output_of(ros2.python(), ROS2, nodes.environment)
    wrong = "Expected <class 'std_msgs.msg._u_int32.UInt32'>, got <class 'geometry_msgs.msg._twist.Twist'>"
    assert said.splitlines() == ["5", "[2.0, 0.0]", "map 3 1.5", "True", wrong]


def test_messages_of_the_real_ros1(require: Callable[[str], None]) -> None:
    require("ros1")
    assert output_of(sys.executable, ROS1, dict(os.environ)).splitlines() == ["5", "map 3", "True"]
