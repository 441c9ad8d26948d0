from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import NotSubstitution


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            LogInfo(msg=NotSubstitution("perhaps")),
        ]
    )
