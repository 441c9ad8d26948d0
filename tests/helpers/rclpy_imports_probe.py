"""Print which names rclpy has after ``import rclpy.X`` alone, for the module X that its argument names.

Without an argument it prints this for all modules of rclpy, each in a Python of its own. Record them in the environment
of a real ROS 2: python tests/helpers/rclpy_imports_probe.py > tests/helpers/rclpy_imports_probe.txt
"""

import importlib
import sys


def told(module):
    importlib.import_module(module)
    rclpy = sys.modules["rclpy"]
    return " ".join([module, *sorted(name for name in dir(rclpy) if not name.startswith("__"))])


def all_modules():
    import pkgutil

    import rclpy

    found = [module.name for module in pkgutil.walk_packages(rclpy.__path__, "rclpy.")]
    return ["rclpy", *(name for name in found if not name.endswith("._dummy"))]


if sys.argv[1:]:
    print(told(sys.argv[1]))
else:
    import subprocess

    for each in all_modules():
        subprocess.run([sys.executable, "-W", "ignore", __file__, each], check=True)
