from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    same = {"package": "launched", "executable": "show", "name": "same", "namespace": "robot", "output": "screen"}
    return LaunchDescription([Node(**same), Node(**same)])
