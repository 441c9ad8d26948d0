"""A node of a student: the main waits until three sensors are ready, or some time is over."""

import threading

from scenario import P, begin, block, mark, say


class Latch:
    def __init__(self, count):
        self._count = count
        self._zero = threading.Condition()

    def count_down(self):
        with self._zero:
            self._count -= 1
            if self._count == 0:
                self._zero.notify_all()

    def wait(self, timeout=None):
        with self._zero:
            return self._zero.wait_for(lambda: self._count == 0, timeout)


def start(name, periods):
    block(periods)
    mark(name)
    latch.count_down()


begin("threads_node_latch")
latch = Latch(3)
for name, periods in (("camera", 3), ("lidar", 1), ("imu", 2)):
    threading.Thread(target=start, args=(name, periods)).start()
say("ready", latch.wait(1.5 * P))
mark("not_yet")
say("ready", latch.wait())
mark("ready")
