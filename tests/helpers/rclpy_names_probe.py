"""Print the names that rclpy's classes have, of which a node makes classes of its own; mangled ones are a class's own.

Record them in the environment of a real ROS 2:
python tests/helpers/rclpy_names_probe.py > tests/helpers/rclpy_names_probe.txt
"""

import rclpy
from rclpy.executors import Executor, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node

rclpy.init()
for made in (Node("node"), Executor(), SingleThreadedExecutor(), MultiThreadedExecutor(2)):
    kind = type(made).__name__
    names = {name for name in dir(made) if not (name.startswith("__") and name.endswith("__"))}
    print(kind, *sorted(name for name in names if not name.startswith(("_Node__", "_Executor__"))))
rclpy.shutdown()
