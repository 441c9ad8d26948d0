from launch import LaunchDescription
from launch.actions import LogInfo, OpaqueFunction


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            OpaqueFunction(function=lambda context: 1 / 0),
        ]
    )
