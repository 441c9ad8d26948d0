"""Ctrl-C while a pool works: tasks that look at is_shutdown end, and so does the pool."""

from concurrent.futures import ThreadPoolExecutor

import rospy
from scenario import begin, block, mark, say


def work(number):
    mark("begin")
    while not rospy.is_shutdown():
        block(0.8)
    return number


begin("ctrl_c_threads_pool")
with ThreadPoolExecutor(2) as pool:
    say(list(pool.map(work, range(2))))
say("is_shutdown", rospy.is_shutdown())
