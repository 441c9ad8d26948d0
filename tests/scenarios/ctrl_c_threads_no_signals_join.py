"""With disable_signals Ctrl-C raises a KeyboardInterrupt in the main, in the middle of a join."""

import threading

import rospy
from scenario import P, begin, block, mark, say


def loop():
    rate = rospy.Rate(1 / P)
    while not rospy.is_shutdown():
        mark("pass")
        rate.sleep()
    say("the loop has ended")


begin("ctrl_c_threads_no_signals_join", disable_signals=True)
rospy.on_shutdown(lambda: say("hook"))
worker = threading.Thread(target=loop)
worker.start()
try:
    worker.join()
except KeyboardInterrupt:
    mark("caught")
    say("caught", rospy.is_shutdown())
    rospy.signal_shutdown("Ctrl-C")
    block(1)
