from launch import LaunchDescription
from launch.actions import LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch_ros.actions import Node


def ends(*arguments, **more):
    return Node(package="launched", executable="ends", arguments=arguments, **more)


def report(event, context):
    return LogInfo(msg=f"{event.process_name} has ended with {event.returncode}")


def generate_launch_description():
    first, second = ends("0.5", "0"), ends("0.5", "3")
    return LaunchDescription(
        [
            first,
            RegisterEventHandler(OnProcessStart(target_action=first, on_start=[LogInfo(msg="first has started")])),
            RegisterEventHandler(OnProcessExit(target_action=first, on_exit=[LogInfo(msg="now the second"), second])),
            RegisterEventHandler(OnProcessExit(target_action=second, on_exit=report)),
            RegisterEventHandler(OnProcessExit(on_exit=LogInfo(msg="one has ended"))),
        ]
    )
