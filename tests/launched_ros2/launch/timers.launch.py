from launch import LaunchDescription
from launch.actions import LogInfo, OpaqueFunction, TimerAction
from launch.substitutions import LaunchConfiguration, ThisLaunchFileDir
from launch_ros.actions import Node


def generate_launch_description():
    cancelled = TimerAction(period=1.5, actions=[LogInfo(msg="never")])
    return LaunchDescription(
        [
            TimerAction(period=1.0, actions=[LogInfo(msg="second"), LogInfo(msg=ThisLaunchFileDir())]),
            TimerAction(period=0.5, actions=[LogInfo(msg="first")]),
            TimerAction(
                period=LaunchConfiguration("period", default="2.0"),
                actions=[
                    Node(package="launched", executable="show", output="screen"),
                    TimerAction(period=3.0, actions=[LogInfo(msg="last")]),
                ],
            ),
            cancelled,
            TimerAction(period=0.75, actions=[OpaqueFunction(function=lambda context: cancelled.cancel())]),
            LogInfo(msg="at once"),
        ]
    )
