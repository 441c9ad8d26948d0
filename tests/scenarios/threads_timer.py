"""threading.Timer calls once after its interval, unless it is cancelled before."""

import threading

from scenario import P, begin, mark, say, until


def call(*args, **kwargs):
    mark("call")
    say(args, kwargs)


begin("threads_timer")
timers = [threading.Timer(P, call), threading.Timer(2 * P, call, (1, 2), {"key": 3}), threading.Timer(3 * P, call)]
for timer in timers:
    timer.start()
say([timer.finished.is_set() for timer in timers], [timer.daemon for timer in timers], timers[0].interval == P)
until(1.5)
say([timer.finished.is_set() for timer in timers], [timer.is_alive() for timer in timers])
timers[2].cancel()
timers[2].join()
mark("cancelled")
timers[1].join()
mark("joined")
say([timer.finished.is_set() for timer in timers], [timer.is_alive() for timer in timers])
unstarted = threading.Timer(P, call)
unstarted.cancel()
unstarted.start()
unstarted.join()
mark("cancelled_before_start")
