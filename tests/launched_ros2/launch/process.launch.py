import os
import sys

from launch import LaunchDescription
from launch.actions import ExecuteProcess
from launch.substitutions import TextSubstitution


def generate_launch_description():
    plain = os.path.join(os.path.dirname(__file__), "..", "config", "plain.py")
    return LaunchDescription(
        [
            ExecuteProcess(cmd=["python3", plain, "one", ["t", TextSubstitution(text="wo")]], output="screen"),
            ExecuteProcess(cmd=[sys.executable, plain], name="named", output="screen"),
        ]
    )
