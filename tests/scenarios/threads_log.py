"""Log lines of several threads: each appears once, with the level's sign, and throttling is by call site for all."""

import threading

import rospy
from scenario import P, begin, until


def work(name, start):
    until(start)
    rospy.loginfo("%s begins", name)
    rospy.logdebug("hidden")
    for _ in range(2):
        rospy.logwarn_once("once for all")
        rospy.loginfo_throttle(3.5 * P, "throttled in " + name)
    rospy.logerr("%s ends", threading.current_thread().name)


begin("threads_log")
workers = [threading.Thread(target=work, args=(name, start), name=name) for start, name in enumerate("abcdef")]
for worker in workers:
    worker.start()
for worker in workers:
    worker.join()
rospy.loginfo("all")
