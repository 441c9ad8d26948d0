from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node


def generate_launch_description():
    node = Node(package="launched", executable="show")
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            node,
            node,
        ]
    )
