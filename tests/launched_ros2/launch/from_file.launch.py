from launch import LaunchDescription
from launch.substitutions import PathJoinSubstitution
from launch_ros.actions import Node, SetParametersFromFile, SetUseSimTime
from launch_ros.substitutions import FindPackageShare


def generate_launch_description():
    return LaunchDescription(
        [
            SetParametersFromFile(PathJoinSubstitution([FindPackageShare("launched"), "config", "show.yaml"])),
            SetUseSimTime(False),
            Node(package="launched", executable="show", output="screen", parameters=[{"rate": 9.0}]),
        ]
    )
