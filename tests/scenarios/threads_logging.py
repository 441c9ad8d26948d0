"""Python's own logging from threads names them, and a handler that is slow makes the others wait."""

import logging
import threading

import rospy
from scenario import P, begin, block, mark, say, until


class SlowHandler(logging.Handler):
    def emit(self, record):
        mark(f"{record.threadName}_in")
        block(1)
        lines.append(self.format(record))


def work(start):
    until(start)
    logger.info("at %s", start)
    mark(f"{threading.current_thread().name}_out")


begin("threads_logging")
lines = []
handler = SlowHandler()
handler.setFormatter(logging.Formatter("%(levelname)s %(threadName)s %(message)s"))
logger = logging.Logger("own", logging.INFO)
logger.addHandler(handler)
workers = [threading.Thread(target=work, args=(start,), name=f"worker{number}") for number, start in ((1, 0), (2, 0.5))]
for worker in workers:
    worker.start()
timer = rospy.Timer(rospy.Duration(0.75 * P), lambda event: work(0.75), oneshot=True)
timer.name = "timer"
for worker in (*workers, timer):
    worker.join()
say(lines)
