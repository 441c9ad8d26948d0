"""Threads that wait for one another, and two that wait for the same one."""

import threading

from scenario import begin, block, mark, until


def work(name, before, periods):
    if before is not None:
        before.join()
    mark(name)
    block(periods)


begin("threads_join_chain")
first = threading.Thread(target=work, args=("first", None, 2))
second = threading.Thread(target=work, args=("second", first, 1))
third = threading.Thread(target=work, args=("third", first, 2))
for number, thread in enumerate((first, second, third)):
    until(0.5 * number)
    thread.start()
second.join()
mark("second_joined")
third.join()
mark("third_joined")
