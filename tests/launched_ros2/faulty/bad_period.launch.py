from launch import LaunchDescription
from launch.actions import LogInfo, TimerAction


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            TimerAction(period=1, actions=[]),
        ]
    )
