import os
import sys

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import TextSubstitution
from launch_ros.substitutions import ExecutableInPackage, FindPackageShare


def generate_launch_description():
    plain = os.path.join(FindPackageShare("launched").find("launched"), "config", "plain.py")
    return LaunchDescription(
        [
            ExecuteProcess(cmd=["python3", plain, "one", ["t", TextSubstitution(text="wo")]], output="screen"),
            ExecuteProcess(cmd=[sys.executable, plain], name="named", output="screen"),
            ExecuteProcess(cmd=[ExecutableInPackage("ends", "launched"), "0.2", "0"]),
        ]
    )
