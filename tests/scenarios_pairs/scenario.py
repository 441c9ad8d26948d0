"""What the scenarios of several processes share.

The files of a scenario are its processes: SCENARIO_NAME.py. Each line begins with the name of its process, so that one
console can be told apart again. A line whose text begins with @ holds times (s), which the test compares with a
tolerance; every other one must be the same on each runtime, byte for byte.
"""

import sys
import time
from pathlib import Path

import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import Empty

NAME = Path(sys.argv[0]).stem.rpartition("_")[2]  # of this process
LONGEST = 60.0  # s that anything may take; on a real ROS two processes may need some to see each other

_zero = [time.monotonic()]


def say(*words):
    """Print words in one go, so that the lines of several processes do not mix."""
    sys.stdout.write(f"{NAME}: {' '.join(str(word) for word in words)}\n")
    sys.stdout.flush()


def begin():
    """Times count from here."""
    _zero[0] = time.monotonic()


def mark(label, *times):
    """Print times (now, if none is given)."""
    say(f"@{label}", *[f"{each:.4f}" for each in times or (time.monotonic() - _zero[0],)])


def spin_until(node, condition):
    """Spin until a condition holds; whether it does."""
    deadline = time.monotonic() + LONGEST
    while not condition() and time.monotonic() < deadline:
        rclpy.spin_once(node, timeout_sec=0.01)
    return condition()


def spin_for(node, seconds):
    """Spin for so long."""
    deadline = time.monotonic() + seconds
    while (left := deadline - time.monotonic()) > 0:
        rclpy.spin_once(node, timeout_sec=left)


_KEPT = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def invite(node, guests=1):
    """Wake those who wait for an invitation, and see that they have got it."""
    publisher = node.create_publisher(Empty, "/invitation", _KEPT)
    spin_until(node, lambda: publisher.get_subscription_count() == guests)
    publisher.publish(Empty())
    spin_until(node, lambda: publisher.get_subscription_count() == 0)


def wait_for_invitation(node):
    """Spin until the other process invites to continue."""
    came = []
    subscription = node.create_subscription(Empty, "/invitation", came.append, _KEPT)
    spin_until(node, lambda: came)
    node.destroy_subscription(subscription)


def _say_error(kind, error, frames):
    say(f"{kind.__name__}: {error}")


sys.excepthook = _say_error
