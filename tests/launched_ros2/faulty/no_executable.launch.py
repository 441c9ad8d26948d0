from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            Node(package="launched", executable="lost"),
        ]
    )
