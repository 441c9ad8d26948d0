from launch import LaunchDescription
from launch.actions import Shutdown, TimerAction
from launch_ros.actions import Node


def waits(*signals, **more):
    return Node(package="launched", executable="waits", arguments=signals, output="screen", **more)


def generate_launch_description():
    return LaunchDescription(
        [
            waits("SIGINT"),
            waits("SIGINT", "SIGTERM", sigterm_timeout="1", sigkill_timeout="0.5"),
            TimerAction(period=8.0, actions=[Shutdown(reason="long enough")]),
        ]
    )
