"""The main ends and Python waits neither for a daemon thread nor for a rospy.Timer; they see the shutdown hooks run."""

import threading

import rospy
from scenario import P, begin, block, mark, say, until


def work():
    for time in (1, 2):
        until(time)
        mark("work")
    block(20)
    say("never")


def hook():
    mark("hook")
    say("daemon", worker.is_alive(), "timer", timer.is_alive())


begin("threads_daemon_ends_with_main")
rospy.on_shutdown(hook)
worker = threading.Thread(target=work, daemon=True)
worker.start()
timer = rospy.Timer(rospy.Duration(15 * P), lambda event: say("never"))
until(2.5)
mark("main_ends")
