from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import EnvironmentVariable


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            LogInfo(msg=EnvironmentVariable("ROSSPIN_NOWHERE")),
        ]
    )
