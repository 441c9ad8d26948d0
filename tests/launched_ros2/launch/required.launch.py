from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler, Shutdown
from launch.event_handlers import OnShutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="launched", executable="waits", output="screen"),
            Node(
                package="launched",
                executable="ends",
                arguments=["8", "1"],
                on_exit=Shutdown(reason="the required one has ended"),
            ),
            RegisterEventHandler(OnShutdown(on_shutdown=lambda event, context: LogInfo(msg=event.reason))),
            RegisterEventHandler(OnShutdown(on_shutdown=[LogInfo(msg="shutting down")])),
        ]
    )
