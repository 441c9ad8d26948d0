from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            LogInfo(msg=5),
        ]
    )
