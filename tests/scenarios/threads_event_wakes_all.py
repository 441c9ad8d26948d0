"""All that wait for an event continue when it is set; who comes later does not wait."""

import threading

from scenario import begin, mark, say, until

event = threading.Event()


def wait(name, start):
    until(start)
    event.wait()
    mark(name)


begin("threads_event_wakes_all")
waiters = [threading.Thread(target=wait, args=(f"waiter{start}", start)) for start in (0, 1, 3)]
for waiter in waiters:
    waiter.start()
until(2)
event.set()
for waiter in waiters:
    waiter.join()
mark("all")
say("set", event.is_set())
