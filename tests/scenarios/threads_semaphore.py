"""A semaphore lets two of four threads in at a time."""

import threading

from scenario import begin, block, mark, until

semaphore = threading.Semaphore(2)


def work(name):
    with semaphore:
        mark(f"{name}_in")
        block(2)
        mark(f"{name}_out")


begin("threads_semaphore")
workers = [threading.Thread(target=work, args=(name,)) for name in "abcd"]
for number, worker in enumerate(workers):
    until(0.5 * number)
    worker.start()
for worker in workers:
    worker.join()
mark("all")
