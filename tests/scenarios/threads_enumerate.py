"""threading.enumerate and active_count: a thread is there from its start to its end."""

import threading

import rospy
from scenario import P, begin, say, until


def own():
    return sorted(thread.name for thread in threading.enumerate() if thread.name in ("one", "two", "timer"))


begin("threads_enumerate")
before = threading.active_count()
one = threading.Thread(target=until, args=(1,), name="one")
two = threading.Thread(target=until, args=(2,), name="two", daemon=True)
say(own(), threading.active_count() - before)
one.start()
two.start()
timer = rospy.Timer(rospy.Duration(2.5 * P), lambda event: say(own()), oneshot=True)
timer.name = "timer"
say(own(), threading.active_count() - before)
until(1.5)
say(own(), threading.active_count() - before)
until(3)
say(own(), threading.active_count() - before)
say(threading.current_thread() in threading.enumerate())
