from launch import LaunchDescription
from launch.actions import GroupAction, LogInfo, SetLaunchConfiguration
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node, PushROSNamespace, PushRosNamespace, SetParameter, SetRemap


def show(**more):
    return Node(package="launched", executable="show", output="screen", **more)


def generate_launch_description():
    return LaunchDescription(
        [
            GroupAction(
                [
                    PushRosNamespace("outer"),
                    SetParameter("rate", 3.0),
                    SetParameter(name="word", value="shared"),
                    SetLaunchConfiguration("colour", "red"),
                    GroupAction([PushROSNamespace("inner"), SetRemap("chatter", "talk"), show(name="first")]),
                    show(namespace="second"),
                    show(namespace="/third", name="third", parameters=[{"rate": 4.0}]),
                    LogInfo(msg=["within ", LaunchConfiguration("colour")]),
                ]
            ),
            GroupAction([SetLaunchConfiguration("shape", "round")], scoped=False),
            GroupAction([LogInfo(msg=LaunchConfiguration("size"))], launch_configurations={"size": "big"}),
            LogInfo(msg=["outside ", LaunchConfiguration("colour", default="none")]),
            LogInfo(msg=["unscoped ", LaunchConfiguration("shape", default="none")]),
            show(),
        ]
    )
