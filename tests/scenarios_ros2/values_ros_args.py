"""Arguments for ROS that are none."""

import rclpy
from scenario import attempt

for words in (
    ["--ros-args"],
    ["--ros-args", "--ros-args"],
    ["--ros-args", "-r"],
    ["--ros-args", "-r", "nonsense"],
    ["--ros-args", "-p", "nonsense"],
    ["--ros-args", "--log-level", "nonsense"],
    ["--ros-args", "--nonsense"],
    ["--ros-args", "-r", "a:=b", "--", "plain"],
    ["--ros-args", "--params-file", "/nonsuch.yaml"],
    ["plain", "__ns:=/old"],
):
    context = rclpy.Context()
    attempt(f"rclpy.init(args={words}, context=context)", {"rclpy": rclpy, "context": context})
    context.try_shutdown()
