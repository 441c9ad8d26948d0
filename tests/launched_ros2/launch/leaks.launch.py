from launch import LaunchDescription
from launch.actions import GroupAction
from launch_ros.actions import Node, SetParameter


def generate_launch_description():
    return LaunchDescription(
        [
            SetParameter("outer", 1),
            GroupAction([SetParameter("inner", 2)]),
            Node(package="launched", executable="show", output="screen"),
        ]
    )
