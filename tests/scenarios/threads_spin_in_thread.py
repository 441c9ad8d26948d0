"""spin may run in a thread while the main does something else; both see the shutdown."""

import threading

import rospy
from scenario import P, begin, block, mark, say


def spin():
    rospy.spin()
    say("spin has returned")


begin("threads_spin_in_thread")
timer = rospy.Timer(rospy.Duration(P), lambda event: mark("tick"))
spinner = threading.Thread(target=spin)
spinner.start()
block(3.4)
timer.shutdown()
rospy.signal_shutdown("the main has had enough")
spinner.join()
say("alive", spinner.is_alive(), rospy.is_shutdown())
