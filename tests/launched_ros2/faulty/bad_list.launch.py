from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import SetParameter


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            SetParameter("a", [LaunchConfiguration("lost", default="{x: 1}")]),
        ]
    )
