from launch import LaunchDescription
from launch.substitutions import TextSubstitution
from launch_ros.actions import Node, SetRemap


def generate_launch_description():
    return LaunchDescription(
        [
            Node(
                package="launched",
                executable="show",
                namespace="robot",
                output="screen",
                remappings=[("chatter", "talk"), ("other", [TextSubstitution(text="an"), "other"])],
                arguments=["first", ["two", TextSubstitution(text="fold")], "--flag"],
            ),
            Node(
                package="launched",
                executable="show",
                output="screen",
                arguments=["--ros-args", "-r", "chatter:=words"],
                ros_arguments=["--log-level", "warn"],
            ),
            SetRemap("chatter", "everywhere"),
            Node(package="launched", executable="show", output="screen", remappings=[("chatter", "here")]),
        ]
    )
