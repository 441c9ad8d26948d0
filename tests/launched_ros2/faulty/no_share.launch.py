from launch import LaunchDescription
from launch.actions import LogInfo
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            LogInfo(msg=FindPackageShare("nowhere")),
        ]
    )
