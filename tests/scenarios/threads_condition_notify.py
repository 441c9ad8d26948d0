"""notify wakes the waiters one by one, those first that waited longest."""

import threading

from scenario import begin, mark, say, until

condition = threading.Condition()


def wait(name):
    with condition:
        say(name, condition.wait())
        mark(name)


begin("threads_condition_notify")
waiters = [threading.Thread(target=wait, args=(name,)) for name in ("first", "second", "third")]
for number, waiter in enumerate(waiters):
    until(0.5 * number)
    waiter.start()
for time in (2, 3, 4):
    until(time)
    with condition:
        condition.notify()
for waiter in waiters:
    waiter.join()
mark("all")
