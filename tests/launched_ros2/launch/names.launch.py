from launch import LaunchDescription
from launch_ros.actions import Node


def show(**names):
    return Node(package="launched", executable="show", output="screen", **names)


def generate_launch_description():
    description = LaunchDescription()
    description.add_action(show(name="named"))
    description.add_action(show(namespace=""))
    description.add_action(show(name="named", namespace="robot"))
    description.add_action(show(name="named", namespace="/robot/arm/"))
    description.add_entity(show(exec_name="shown"))
    return description
