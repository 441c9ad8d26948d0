"""A thread shuts the node down: the main's Rate loop and another thread see it, the hook runs in the first."""

import threading

import rospy
from scenario import P, begin, block, mark, say


def end():
    block(3.5)
    rospy.signal_shutdown("enough")


def loop():
    while not rospy.is_shutdown():
        mark("loop")
        block(1)
    mark("loop_ends")


def hook():
    mark("hook")
    say("hook in", threading.current_thread().name, rospy.is_shutdown())


begin("threads_signal_shutdown")
rospy.on_shutdown(hook)
threading.Thread(target=end, name="ender").start()
threading.Thread(target=loop).start()
rate = rospy.Rate(1 / P)
while not rospy.is_shutdown():
    mark("pass")
    rate.sleep()
mark("main_ends")
