import warnings

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, LogInfo
from launch.conditions import (
    IfCondition,
    LaunchConfigurationEquals,
    LaunchConfigurationNotEquals,
    UnlessCondition,
)
from launch.substitutions import (
    AndSubstitution,
    EqualsSubstitution,
    IfElseSubstitution,
    LaunchConfiguration,
    NotEqualsSubstitution,
    NotSubstitution,
    OrSubstitution,
    PythonExpression,
)

warnings.simplefilter("ignore")


def generate_launch_description():
    flag, number = LaunchConfiguration("flag"), LaunchConfiguration("number")
    return LaunchDescription(
        [
            DeclareLaunchArgument("flag", default_value="True"),
            DeclareLaunchArgument("number", default_value="2"),
            LogInfo(msg="if", condition=IfCondition(flag)),
            LogInfo(msg="unless", condition=UnlessCondition(flag)),
            LogInfo(msg="equals", condition=LaunchConfigurationEquals("number", "2")),
            LogInfo(msg="not equals", condition=LaunchConfigurationNotEquals("number", "2")),
            LogInfo(msg="python", condition=IfCondition(PythonExpression([number, " > 1"]))),
            LogInfo(msg=PythonExpression(["'", number, "' * 3"])),
            LogInfo(msg=PythonExpression(["round(pi, ", number, ")"])),
            LogInfo(msg="and", condition=IfCondition(AndSubstitution(flag, NotSubstitution(flag)))),
            LogInfo(msg="or", condition=IfCondition(OrSubstitution(flag, NotSubstitution(flag)))),
            LogInfo(msg=["equal ", EqualsSubstitution(number, 2.0), " ", NotEqualsSubstitution(number, "two")]),
            LogInfo(msg=IfElseSubstitution(flag, if_value="yes", else_value="no")),
            GroupAction([LogInfo(msg="in a group")], condition=UnlessCondition("0")),
            GroupAction([LogInfo(msg="in no group")], condition=IfCondition(" FALSE ")),
        ]
    )
