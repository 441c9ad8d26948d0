"""The thread of a handler ends without an answer: its caller waits until the node accepts another connection."""

import gc
import sys
import threading

import rospy
from scenario import attempt, begin, block, mark
from std_srvs.srv import Trigger


def fail(request):
    raise ValueError("no value")


def handle_badly(error, kind, value, trace):
    raise RuntimeError("in the error handler")


def call(name):
    attempt(f"{name}()", {name: rospy.ServiceProxy(f"~{name}", Trigger)})
    mark(name)


begin("services_handler_exits")
rospy.Service("~exits", Trigger, lambda request: sys.exit(3))
rospy.Service("~fails", Trigger, fail, error_handler=handle_badly)
rospy.Service("~works", Trigger, lambda request: (True, ""))
gc.freeze()  # what is collected below is little
for name in ("exits", "fails"):
    threading.Thread(target=call, args=(name,)).start()
    block(1)
    mark(f"before_{name}")
    rospy.wait_for_service("~works")
    gc.collect()  # or else the traceback would keep the connection
    block(0.5)
call("works")
