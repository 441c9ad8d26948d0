from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            IncludeLaunchDescription("/nowhere/lost.launch.py"),
        ]
    )
