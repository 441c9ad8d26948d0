"""The standard library's scheduler in a thread, with priorities and a cancelled event."""

import sched
import threading
import time

from scenario import P, begin, mark, say


def work():
    scheduler.run()
    mark("all_done")


begin("threads_sched")
scheduler = sched.scheduler(time.monotonic, time.sleep)
for delay, priority, name in ((2, 1, "second"), (1, 1, "first"), (2, 0, "urgent"), (4, 1, "last")):
    scheduler.enter(delay * P, priority, lambda name=name: (mark(name), order.append(name)))
cancelled = scheduler.enter(3 * P, 1, say, ("never",))
order = []
worker = threading.Thread(target=work)
worker.start()
scheduler.cancel(cancelled)
worker.join()
say(order[0], order[-1], sorted(order), scheduler.empty())
