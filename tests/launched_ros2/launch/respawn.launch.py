from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(
                package="launched",
                executable="ends",
                arguments=["0.2", "2"],
                respawn=True,
                respawn_delay=0.5,
                respawn_max_retries=2,
            ),
            RegisterEventHandler(OnProcessExit(on_exit=[LogInfo(msg="gone")])),
        ]
    )
