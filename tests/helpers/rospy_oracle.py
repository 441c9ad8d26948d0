"""The real rospy's own Python on a simulated clock: its times, Rates, timers and its shutdown, without a network.

So what the stand-in does can be compared with what they do, exactly. Used are the ``.py`` files of Debian's packages
python3-rospy and python3-genpy, as they are. Replaced is what they need of a master, of topics and of log files, and
the clock's seconds: floats are too coarse for whole nanoseconds.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import patch

from benchmarks.oracles import stub, without


def real_rospy() -> Path | None:
    """The folder that the real rospy is in, if it is installed."""
    folder = Path("/usr/lib/python3/dist-packages")
    return folder if all((folder / name / "rostime.py").exists() for name in ("rospy", "genpy")) else None


def _exact_time() -> Fraction:
    return Fraction(time.time_ns(), 10**9)


def _public(module: str) -> dict[str, Any]:
    return {name: each for name, each in vars(import_module(module)).items() if not name.startswith("_")}


@contextmanager
def oracle(folder: Path) -> Iterator[None]:
    """Within this context ``import rospy`` imports the parts of the real one that have to do with time."""
    with without(1, "genpy", "rosgraph", "rosgraph_msgs", "rospkg", "rospy"):
        stub("rospkg")
        stub("rosgraph")
        stub("rosgraph.roslogging")
        stub("rosgraph_msgs")
        stub("rosgraph_msgs.msg", Log=None)
        genpy = stub("genpy", __path__=[str(folder / "genpy")])
        vars(genpy).update(_public("genpy.rostime"))
        rospy = stub("rospy", __path__=[str(folder / "rospy")])
        stub("rospy.names")
        stub("rospy.impl")
        stub("rospy.impl.validators", ParameterInvalid=None)
        with patch("atexit.register", lambda function: None):  # which belongs to the process that tests
            for name in ("exceptions", "rostime", "timer", "core"):
                vars(rospy).update(_public(f"rospy.{name}"))
        rospy.rostime.time = rospy.timer.time = SimpleNamespace(time=_exact_time, sleep=time.sleep)
        vars(rospy).update(
            init_node=lambda name: rospy.rostime.set_rostime_initialized(True),
            on_shutdown=rospy.core.add_client_shutdown_hook,
        )
        yield


def on_the_oracle(node: Callable[[], object], folder: Path) -> Callable[[], None]:
    """The same node, but what it imports as rospy is the real one's Python."""

    def real_node() -> None:
        with oracle(folder):
            node()

    return real_node
