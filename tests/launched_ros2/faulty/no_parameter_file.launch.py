from launch import LaunchDescription
from launch_ros.actions import Node, SetParametersFromFile


def generate_launch_description():
    return LaunchDescription([SetParametersFromFile("lost.yaml"), Node(package="launched", executable="show")])
