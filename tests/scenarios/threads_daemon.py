"""Daemon or not: what is asked for, what a thread takes over from the one that makes it, what a rospy.Timer is."""

import threading

import rospy
from scenario import P, attempt, begin, say, until


def make(name):
    threading.Thread(target=lambda: say(f"made by {name}", threading.current_thread().daemon)).start()


begin("threads_daemon")
make("the main")
until(0.5)
threading.Thread(target=make, args=("a daemon",), daemon=True).start()
until(1)
threading.Thread(target=make, args=("a thread",)).start()
until(1.5)
rospy.Timer(rospy.Duration(0.5 * P), lambda event: make("a timer"), oneshot=True)
until(2.5)
thread = threading.Thread(target=print)
thread.daemon = True
timer = threading.Timer(P, print)
say("set", thread.daemon, timer.daemon)
say("rospy.Timer", rospy.Timer(rospy.Duration(P), lambda event: None).daemon)
attempt("setattr(threading.current_thread(), 'daemon', True)", {"threading": threading})
