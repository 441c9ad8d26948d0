"""The main ends with tasks in a pool: Python waits for them before the shutdown hooks run."""

from concurrent.futures import ThreadPoolExecutor

import rospy
from scenario import begin, block, mark, say


def work(number):
    block(1)
    mark(f"done{number}")
    say(number, rospy.is_shutdown())


begin("threads_pool_outlives_main")
rospy.on_shutdown(lambda: mark("hook"))
pool = ThreadPoolExecutor(1)
for number in range(3):
    pool.submit(work, number)
mark("main_ends")
