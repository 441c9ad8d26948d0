"""A node of a student: a callback that does nothing while another one has the resource."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark

resource = threading.Lock()


def use(event):
    with resource:
        mark("uses")
        block(1.9)


def try_to_use(event):
    if not resource.acquire(blocking=False):
        mark("skips")
        return
    try:
        mark("tries")
    finally:
        resource.release()


begin("threads_node_skips")
rospy.Timer(rospy.Duration(4 * P), use)
block(0.4)
rospy.Timer(rospy.Duration(P), try_to_use)
end_after(9.2)
