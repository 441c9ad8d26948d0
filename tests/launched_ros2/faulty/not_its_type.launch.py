from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            Node(package="launched", executable="show", parameters=[{"a": ParameterValue("2.0", value_type=float)}]),
        ]
    )
