from pathlib import Path

from launch import LaunchDescription
from launch.actions import (
    AppendEnvironmentVariable,
    GroupAction,
    LogInfo,
    SetEnvironmentVariable,
)
from launch.substitutions import EnvironmentVariable
from launch_ros.actions import Node, SetParametersFromFile, SetUseSimTime

FILE = str(Path(__file__).parents[1] / "config" / "show.yaml")


def show(**more):
    return Node(package="launched", executable="show", output="screen", **more)


def generate_launch_description():
    return LaunchDescription(
        [
            SetUseSimTime(True),
            SetEnvironmentVariable("COLOUR", "red"),
            AppendEnvironmentVariable("COLOUR", "green"),
            AppendEnvironmentVariable("COLOUR", "blue", prepend=True, separator="-"),
            AppendEnvironmentVariable("SHAPE", "round", separator="+"),
            LogInfo(msg=EnvironmentVariable("COLOUR")),
            show(),
            GroupAction(
                [
                    AppendEnvironmentVariable("SHAPE", "flat", separator="+"),
                    SetParametersFromFile(FILE),
                    show(),
                    show(name="named", parameters=[{"rate": 2.0}]),
                ]
            ),
            show(parameters=[{"word": "own"}]),
        ]
    )
