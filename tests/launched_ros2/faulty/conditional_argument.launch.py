from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo
from launch.conditions import IfCondition


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            DeclareLaunchArgument("needed", condition=IfCondition("true")),
        ]
    )
