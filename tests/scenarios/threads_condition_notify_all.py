"""notify_all wakes all that wait, as soon as the one who notifies leaves the condition; who comes later waits on."""

import threading

from scenario import begin, mark, say, until

condition = threading.Condition()


def wait(name, start):
    until(start)
    with condition:
        condition.wait()
        mark(name)


begin("threads_condition_notify_all")
waiters = [threading.Thread(target=wait, args=(f"waiter{start}", start)) for start in (0, 1, 3)]
for waiter in waiters:
    waiter.start()
until(2)
with condition:
    condition.notify_all()
    until(2.5)
until(4)
say("alive", [waiter.is_alive() for waiter in waiters])
with condition:
    condition.notify_all()
for waiter in waiters:
    waiter.join()
mark("all")
