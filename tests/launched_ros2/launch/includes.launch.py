import os

from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription, LogInfo
from launch.launch_description_sources import AnyLaunchDescriptionSource, PythonLaunchDescriptionSource
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution, ThisLaunchFile, ThisLaunchFileDir
from launch_ros.substitutions import FindPackageShare
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource
from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource


def generate_launch_description():
    here = os.path.dirname(__file__)
    return LaunchDescription(
        [
            IncludeLaunchDescription(
                PythonLaunchDescriptionSource([ThisLaunchFileDir(), "/arguments.launch.py"]),
                launch_arguments={"needed": "from above", "colour": "green"}.items(),
            ),
            LogInfo(msg=["leaked ", LaunchConfiguration("needed")]),
            IncludeLaunchDescription(
                XMLLaunchDescriptionSource(os.path.join(here, "small.launch.xml")), launch_arguments=[("word", "xml")]
            ),
            IncludeLaunchDescription(
                YAMLLaunchDescriptionSource(
                    PathJoinSubstitution([FindPackageShare("launched"), "launch", "small.launch.yaml"])
                )
            ),
            IncludeLaunchDescription(
                AnyLaunchDescriptionSource(os.path.join(here, "small.launch.yaml")),
                launch_arguments={"word": "any"}.items(),
            ),
            LogInfo(msg=PathJoinSubstitution([ThisLaunchFile(), "end"])),
        ]
    )
