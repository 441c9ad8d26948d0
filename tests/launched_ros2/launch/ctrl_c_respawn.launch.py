from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="launched", executable="waits", output="screen", respawn=True),
            Node(package="launched", executable="ends", arguments=["0", "0"], respawn=True, respawn_delay=60.0),
        ]
    )
