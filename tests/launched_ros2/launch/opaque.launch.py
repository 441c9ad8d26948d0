from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, OpaqueFunction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def make(context, *words, ending=""):
    count = int(LaunchConfiguration("count").perform(context))
    context.launch_configurations["count"] = "changed"
    return [
        LogInfo(msg=" ".join(words) + ending),
        *(Node(package="launched", executable="show", name=f"show_{n}", output="screen") for n in range(count)),
    ]


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("count", default_value="2"),
            OpaqueFunction(function=make, args=["two", "words"], kwargs={"ending": "!"}),
            OpaqueFunction(function=lambda context: None),
            LogInfo(msg=LaunchConfiguration("count")),
        ]
    )
