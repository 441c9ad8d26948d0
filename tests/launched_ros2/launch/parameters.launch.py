import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, TextSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import Parameter, ParameterFile, ParameterValue
from launch_ros.substitutions import FindPackageShare


def show(parameters, **names):
    return Node(package="launched", executable="show", output="screen", parameters=parameters, **names)


def generate_launch_description():
    file = os.path.join(get_package_share_directory("launched"), "config", "show.yaml")
    same = PathJoinSubstitution([FindPackageShare("launched"), "config", "show.yaml"])
    substituted = PathJoinSubstitution([FindPackageShare("launched"), "config", "substituted.yaml"])
    return LaunchDescription(
        [
            DeclareLaunchArgument("word", default_value="given"),
            DeclareLaunchArgument("number", default_value="3"),
            show([{"int": 1, "float": 2.0, "truth": True, "text": "3", "list": [1, 2], "texts": ["a", "b"]}]),
            show([{"outer": {"inner": 1, "deeper": {"deepest": "x"}}, "mixed": [1, 2.5]}]),
            show([{"word": LaunchConfiguration("word"), "number": LaunchConfiguration("number")}]),
            show([{"number": ParameterValue(LaunchConfiguration("number"), value_type=str)}]),
            show([{"number": ParameterValue(LaunchConfiguration("number"), value_type=float)}]),
            show([{"joined": [LaunchConfiguration("word"), " twice ", LaunchConfiguration("word")]}]),
            show([{"listed": [TextSubstitution(text="[1, 2]")]}]),
            show([Parameter("single", 2.5), Parameter("word", LaunchConfiguration("word"), value_type=str)]),
            show([file, {"rate": 6.0}]),
            show([{"rate": 6.0}, file]),
            show([same], name="named"),
            show([same, {"word": "own"}], name="named", namespace="robot"),
            show([ParameterFile(substituted, allow_substs=True)]),
            show(["/nowhere/lost.yaml", {"rate": 1.0}]),
        ]
    )
