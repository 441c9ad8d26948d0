import os

from launch import LaunchDescription
from launch.actions import LogInfo, OpaqueFunction, RegisterEventHandler, TimerAction, UnregisterEventHandler
from launch.event_handlers import OnProcessExit
from launch.logging import get_logger
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch_ros.actions import Node


def log(context):
    get_logger("mine").info("logged")
    get_logger("mine").warning("%d of %s", 2, "them")
    get_logger("mine").debug("not shown")
    text = context.perform_substitution(TextSubstitution(text="performed"))
    return [LogInfo(msg=[text, " ", LaunchConfiguration("number", default=3)])]


def gone(event, context):
    return LogInfo(msg=f"{context.locals.event.process_name} {event.action is ends} {event.returncode}")


path = os.path.join(os.path.dirname(__file__), "..", "config", "plain.py")
ends = Node(package="launched", executable="ends", arguments=["2", "0"])


def generate_launch_description():
    handler = OnProcessExit(on_exit=[LogInfo(msg="never")])
    return LaunchDescription(
        [
            OpaqueFunction(function=log),
            RegisterEventHandler(handler),
            UnregisterEventHandler(handler),
            RegisterEventHandler(OnProcessExit(on_exit=[LogInfo(msg="once")], handle_once=True)),
            RegisterEventHandler(OnProcessExit(target_action=ends, on_exit=gone)),
            RegisterEventHandler(
                OnProcessExit(target_action=lambda action: action is not ends, on_exit=[LogInfo(msg="another")])
            ),
            ends,
            TimerAction(period=10.0, actions=[Node(executable=path, output="screen", arguments=["one"])]),
            TimerAction(period=0.5, actions=[LogInfo(msg="a"), LogInfo(msg="b")]),
            TimerAction(period=0.5, actions=[LogInfo(msg="c")]),
        ]
    )
