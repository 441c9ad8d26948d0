from launch import LaunchDescription
from launch.actions import EmitEvent, LogInfo, RegisterEventHandler, TimerAction
from launch.event_handlers import OnShutdown
from launch.events import Shutdown
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [
            Node(package="launched", executable="waits", name="left", output="screen"),
            Node(package="launched", executable="waits", name="right", output="screen"),
            RegisterEventHandler(
                OnShutdown(on_shutdown=[LogInfo(msg="going"), Node(package="launched", executable="show")])
            ),
            TimerAction(period=8.0, actions=[EmitEvent(event=Shutdown(reason="enough"))]),
            TimerAction(period=60.0, actions=[LogInfo(msg="never")]),
        ]
    )
