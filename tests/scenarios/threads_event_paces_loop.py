"""A loop paced by Event.wait(timeout) stops as soon as the event is set, not a period later."""

import threading

from scenario import P, begin, mark, until

stop = threading.Event()


def work():
    while not stop.wait(1.5 * P):
        mark("pass")
    mark("stopped")


begin("threads_event_paces_loop")
worker = threading.Thread(target=work)
worker.start()
until(5.25)
stop.set()
worker.join()
mark("joined")
