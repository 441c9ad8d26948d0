"""Two timers call services that call each other, under a lock each: neither ends, but the node does at Ctrl-C."""

import threading

import rospy
from scenario import P, begin, block, mark, say
from std_srvs.srv import Trigger

locks = {name: threading.Lock() for name in "ab"}


def serve(name):
    def handle(request):
        mark(f"asked_{name}")
        with locks[name]:
            return True, "free"

    rospy.Service(f"~{name}", Trigger, handle)


def ask(name, other):
    def call(event):
        with locks[name]:
            mark(f"locked_{name}")
            block(0.5)
            rospy.ServiceProxy(f"~{other}", Trigger)()
            mark("never")

    rospy.Timer(rospy.Duration(P), call)


begin("ctrl_c_services_deadlock_each_other")
rospy.on_shutdown(lambda: mark("hook"))
serve("a")
serve("b")
ask("a", "b")
ask("b", "a")
rospy.spin()
say("spun")
