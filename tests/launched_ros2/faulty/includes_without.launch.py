from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo
from launch.substitutions import ThisLaunchFileDir


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            IncludeLaunchDescription(
                [ThisLaunchFileDir(), "/../launch/arguments.launch.py"], launch_arguments={"colour": "red"}.items()
            ),
        ]
    )
