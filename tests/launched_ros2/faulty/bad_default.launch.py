from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            DeclareLaunchArgument("size", default_value="huge", choices=["small", "big"]),
        ]
    )
