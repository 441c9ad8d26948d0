from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, SetLaunchConfiguration, UnsetLaunchConfiguration
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription(
        [
            DeclareLaunchArgument("colour", default_value="red", description="a colour", choices=["red", "green"]),
            DeclareLaunchArgument("needed"),
            DeclareLaunchArgument("made", default_value=[LaunchConfiguration("colour"), "ish"]),
            LogInfo(msg=["colour ", LaunchConfiguration("colour")]),
            LogInfo(msg=["needed ", LaunchConfiguration("needed")]),
            LogInfo(msg=["made ", LaunchConfiguration("made")]),
            LogInfo(msg=["extra ", LaunchConfiguration("extra", default="none")]),
            SetLaunchConfiguration("colour", "blue"),
            LogInfo(msg=LaunchConfiguration("colour")),
            UnsetLaunchConfiguration("colour"),
            LogInfo(msg=LaunchConfiguration("colour", default=["un", "set"])),
        ]
    )
