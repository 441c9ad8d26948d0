from launch import LaunchDescription
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def prints(**more):
    return Node(package="launched", executable="prints", **more)


def generate_launch_description():
    return LaunchDescription(
        [
            prints(),
            prints(output="screen"),
            prints(output="log"),
            prints(output="both"),
            prints(output="own_log"),
            prints(output="full"),
            prints(output={"stdout": "screen", "stderr": "log"}),
            prints(output={"both": ["log", "screen"]}),
            prints(output=LaunchConfiguration("output", default="screen")),
        ]
    )
