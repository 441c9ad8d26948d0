from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnShutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="launched", executable="waits", output="screen"),
            Node(package="launched", executable="waits", name="other", output="screen"),
            Node(package="launched", executable="ends", arguments=["60", "0"], output="screen"),
            RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: [LogInfo(msg=event.reason)])),
        ]
    )
