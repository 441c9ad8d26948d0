import os

from launch import LaunchDescription
from launch.actions import (
    GroupAction,
    LogInfo,
    SetEnvironmentVariable,
    UnsetEnvironmentVariable,
)
from launch.substitutions import EnvironmentVariable
from launch_ros.actions import Node


def show(**more):
    return Node(package="launched", executable="show", output="screen", **more)


def generate_launch_description():
    os.environ["SHAPE"] = "round"
    return LaunchDescription(
        [
            SetEnvironmentVariable("COLOUR", "red"),
            show(),
            GroupAction([SetEnvironmentVariable("COLOUR", "green"), UnsetEnvironmentVariable("SHAPE"), show()]),
            show(additional_env={"COLOUR": "blue"}),
            LogInfo(msg=EnvironmentVariable("COLOUR")),
            LogInfo(msg=EnvironmentVariable("ROSSPIN_NOWHERE", default_value="nowhere")),
        ]
    )
