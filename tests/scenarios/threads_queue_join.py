"""Queue.join waits until each task is done, and task_done must not be called more often."""

import queue
import threading

from scenario import attempt, begin, block, mark, say

tasks = queue.Queue()


def work(name):
    while True:
        periods = tasks.get()
        block(periods)
        mark(name)
        tasks.task_done()


begin("threads_queue_join")
tasks.join()
mark("nothing_to_do")
threading.Thread(target=work, args=("first",), daemon=True).start()
block(0.5)
threading.Thread(target=work, args=("second",), daemon=True).start()
block(0.5)
for periods in (2, 1):
    tasks.put(periods)
    block(0.5)
for periods in (1.5, 2):
    tasks.put(periods)
say("unfinished", tasks.unfinished_tasks)
tasks.join()
mark("joined")
attempt("tasks.task_done()", {"tasks": tasks})
