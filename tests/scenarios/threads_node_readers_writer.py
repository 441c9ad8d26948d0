"""A node of a student: a lock for many readers or one writer."""

import threading

from scenario import begin, block, mark, until


class SharedLock:
    def __init__(self):
        self._free = threading.Condition()
        self._readers = 0

    def read(self, name):
        with self._free:
            self._readers += 1
        mark(f"{name}_in")
        block(1.5)
        mark(f"{name}_out")
        with self._free:
            self._readers -= 1
            self._free.notify_all()

    def write(self, name):
        with self._free:
            self._free.wait_for(lambda: self._readers == 0)
            mark(f"{name}_in")
            block(1.5)
        mark(f"{name}_out")


begin("threads_node_readers_writer")
lock = SharedLock()
jobs = [(lock.read, "reader1"), (lock.read, "reader2"), (lock.write, "writer"), (lock.read, "reader3")]
threads = [threading.Thread(target=job, args=(name,)) for job, name in jobs]
for thread, time in zip(threads, (0, 0.5, 1, 2.5)):
    until(time)
    thread.start()
for thread in threads:
    thread.join()
mark("all")
