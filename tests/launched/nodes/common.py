"""What the nodes share: each has a copy of its own.

A line begins with the name of the node that prints it; lines of different nodes come in any order.
"""

import sys
import threading
import time

import rospy

used = 0  # how often this module was used


def begin(name, **options):
    """Start the node ``name``, or as the launch file names it; with the argument ``met``, another one has, too."""
    rospy.init_node(name, **options)
    threading.Thread(target=_watch, daemon=True).start()
    if "met" in sys.argv:
        meet(2)


def _watch():
    """Say when this process has not been running for a while: what came late then is no fault of rospy's."""
    while True:
        before = time.monotonic()
        time.sleep(0.05)
        if time.monotonic() - before > 0.1:
            _write("@stall")


def say(*words):
    """Print words, in one go."""
    global used
    used += 1
    _write(f"{rospy.get_name()}: {' '.join(map(str, words))}")


def _write(line):
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def wait_for(condition):
    """Wait until something is true: processes take their time to start."""
    while not condition() and not rospy.is_shutdown():
        time.sleep(0.01)


def meet(count):
    """Wait until so many nodes have come here."""
    rospy.set_param("/met" + rospy.get_name(), True)
    wait_for(lambda: len(rospy.get_param("/met")) >= count)
