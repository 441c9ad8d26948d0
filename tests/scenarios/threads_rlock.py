"""A thread may take an RLock again; another one gets it when it has been released as often."""

import threading

from scenario import attempt, begin, mark, say, until

lock = threading.RLock()


def work():
    say("without waiting", lock.acquire(blocking=False))
    say("with a timeout", lock.acquire(timeout=0.2))
    attempt("lock.release()", {"lock": lock})
    with lock:
        mark("in")


begin("threads_rlock")
with lock:
    with lock:
        worker = threading.Thread(target=work)
        worker.start()
        until(2)
    say("released once", lock.acquire(False))
    lock.release()
    until(3)
worker.join()
mark("all")
