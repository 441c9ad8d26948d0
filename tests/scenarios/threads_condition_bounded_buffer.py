"""Two conditions on one lock: a buffer of two places, a quick producer and a slow consumer."""

import collections
import threading

from scenario import begin, block, mark

lock = threading.Lock()
not_full, not_empty = threading.Condition(lock), threading.Condition(lock)
buffer = collections.deque()


def produce():
    for number in range(5):
        with not_full:
            not_full.wait_for(lambda: len(buffer) < 2)
            buffer.append(number)
            mark("put")
            not_empty.notify()


begin("threads_condition_bounded_buffer")
producer = threading.Thread(target=produce)
producer.start()
taken = []
for _ in range(5):
    block(1)
    with not_empty:
        not_empty.wait_for(lambda: buffer)
        taken.append(buffer.popleft())
        mark("take")
        not_full.notify()
producer.join()
print(taken)
