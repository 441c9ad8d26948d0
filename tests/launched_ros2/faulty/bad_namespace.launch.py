from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.actions import PushROSNamespace


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            PushROSNamespace("a//b"),
        ]
    )
