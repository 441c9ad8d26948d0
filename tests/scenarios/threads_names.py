"""Threads without a name of their own are numbered, rospy.Timers too; a number is never given twice."""

import re
import threading

import rospy
from scenario import P, begin, say, until


def callback(event):
    say("in a callback", named(threading.current_thread()))


def named(thread):
    """The thread's name, its number counted from the first thread's."""
    return re.sub(r"\d+", lambda number: f"<{int(number[0]) - first}>", thread.name, count=1)


begin("threads_names")
threads = [threading.Thread(target=until, args=(1,)), threading.Thread(), threading.Thread(name="own name")]
first = int(threads[0].name.split("-")[1].split()[0])
say([named(thread) for thread in threads])
timer = rospy.Timer(rospy.Duration(P), callback, oneshot=True)
threads = [threading.Timer(1, print), threading.Thread(target=lambda: None), threading.Thread(target=callback)]
say([named(thread) for thread in (timer, *threads)])
say(threading.current_thread().name, threading.main_thread().name)
threads[1].name = "new name"
say(threads[1].name, threading.Thread(name=7).name == "7")
until(2)
