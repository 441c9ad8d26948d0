"""The middlewares that are there, and what RMW_IMPLEMENTATIONS leaves of them."""

import os
import sys

from rclpy.utilities import get_available_rmw_implementations, get_rmw_implementation_identifier
from scenario import attempt, say

os.environ.setdefault("AMENT_PREFIX_PATH", sys.prefix)  # the set-up file of a real ROS sets it, which is not read here
DEFAULT = get_rmw_implementation_identifier()
names = {"available": get_available_rmw_implementations}

say(DEFAULT in get_available_rmw_implementations(), "rmw_implementation" in get_available_rmw_implementations())
for wanted in ("", DEFAULT, os.pathsep.join((DEFAULT, DEFAULT)), "rmw_none_cpp", f"{DEFAULT}{os.pathsep}rmw_none_cpp"):
    os.environ["RMW_IMPLEMENTATIONS"] = wanted
    say(repr(wanted))
    attempt("available()", names)
del os.environ["RMW_IMPLEMENTATIONS"]
attempt("type(available())", names)
