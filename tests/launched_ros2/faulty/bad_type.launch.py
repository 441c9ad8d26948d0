from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import TextSubstitution
from launch_ros.actions import Node
from launch_ros.parameter_descriptions import ParameterValue


def generate_launch_description():
    perhaps = ["per", TextSubstitution(text="haps")]
    return LaunchDescription(
        [
            LogInfo(msg="first"),
            Node(
                package="launched",
                executable="show",
                parameters=[{"a": ParameterValue(perhaps, value_type=bool)}],
            ),
        ]
    )
