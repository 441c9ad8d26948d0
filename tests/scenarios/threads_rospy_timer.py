"""A rospy.Timer is a thread: it can be named, joined and recognised, and tells its callback who runs it."""

import threading

import rospy
from scenario import P, attempt, begin, mark, say, until


def callback(event):
    mark("tick")
    seen.append(threading.current_thread() is timer)
    seen.append(threading.current_thread().name)


begin("threads_rospy_timer")
seen = []
timer = rospy.Timer(rospy.Duration(P), callback)
timer.name = "my timer"
say(isinstance(timer, threading.Thread), issubclass(rospy.Timer, threading.Thread), timer.daemon, timer.is_alive())
say(timer in threading.enumerate(), timer.ident == threading.get_ident())
until(2.5)
timer.shutdown()
say("still alive", timer.is_alive())
timer.join()
mark("joined")
say("alive", timer.is_alive(), timer in threading.enumerate())
attempt("timer.start()", {"timer": timer})
once = rospy.Timer(rospy.Duration(P), lambda event: mark("once"), oneshot=True)
say(once.join(0.2), once.is_alive(), once.join(), once.is_alive())
mark("once_joined")
say(seen)
