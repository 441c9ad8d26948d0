"""An exception in a thread: a traceback with its name on stderr; the others and the node continue, the status is 0."""

import threading

from scenario import begin, mark, say, until


def fail(when):
    until(when)
    raise ValueError(f"fails at {when}")


def chain():
    until(3)
    try:
        {}["missing"]
    except KeyError as error:
        raise RuntimeError("another one") from error


begin("threads_exception")
workers = [
    threading.Thread(target=fail, args=(1,)),
    threading.Thread(target=fail, args=(2,), name="my thread"),
    threading.Thread(target=chain),
    threading.Timer(1.6, fail, (4,)),
]
for worker in workers:
    worker.start()
for worker in workers:
    worker.join()
    say("alive", worker.is_alive())
mark("end")
