"""threading.excepthook of the node's own is told of exceptions in threads and timers."""

import threading

import rospy
from scenario import P, begin, say, until


def hook(args):
    say(args.exc_type.__name__, args.exc_value, args.thread is threading.current_thread(), args.thread.name)
    say(args.exc_traceback.tb_next is not None)


def fail(event=None):
    raise LookupError("nothing found")


begin("threads_excepthook")
threading.excepthook = hook
threading.Thread(target=fail, name="failing thread").start()
until(1)
timer = rospy.Timer(rospy.Duration(P), fail)
timer.name = "failing timer"
until(3)
threading.excepthook = threading.__excepthook__
threading.Thread(target=fail, name="failing again").start()
until(4)
say("alive", timer.is_alive())
