"""A lock goes to the thread that has waited longest."""

import threading

from scenario import begin, block, mark, until

lock = threading.Lock()


def work(name):
    with lock:
        mark(name)
        block(0.5)


begin("threads_lock_in_turn")
workers = [threading.Thread(target=work, args=(name,)) for name in ("first", "second", "third")]
with lock:
    for number, worker in enumerate(workers):
        until(0.5 * number)
        worker.start()
    until(2)
for worker in workers:
    worker.join()
mark("all")
