"""A node of a student: a timer of its own, a thread that waits for an Event until the next time on its grid."""

import threading
import time

from scenario import P, begin, block, mark


class Repeater(threading.Thread):
    def __init__(self, period, call):
        super().__init__(daemon=True)
        self._period = period
        self._call = call
        self._stop_request = threading.Event()

    def run(self):
        due = time.monotonic() + self._period
        while not self._stop_request.wait(max(0, due - time.monotonic())):
            self._call()
            due += self._period

    def stop(self):
        self._stop_request.set()
        self.join()


def call():
    mark("call")
    block(0.5 if len(calls) != 1 else 1.6)
    calls.append(None)


begin("threads_node_own_timer")
calls = []
repeater = Repeater(P, call)
repeater.start()
block(6.4)
repeater.stop()
mark("stopped")
