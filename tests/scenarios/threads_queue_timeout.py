"""Queue.get and put with timeouts and without waiting: Empty and Full, and what comes in time."""

import queue
import threading

from scenario import P, attempt, begin, block, mark, say


def fill():
    block(2)
    places.put("in time")
    block(2)
    got = places.get()
    block(0.5)
    say("made room", got)


begin("threads_queue_timeout")
places = queue.Queue(maxsize=1)
names = {"places": places, "P": P}
threading.Thread(target=fill).start()
attempt("places.get(False)", names)
attempt("places.get_nowait()", names)
attempt("places.get(timeout=P)", names)
mark("too_short")
attempt("places.get(timeout=5 * P)", names)
mark("in_time")
attempt("places.put(1), places.full()", names)
attempt("places.put(2, block=False)", names)
attempt("places.put_nowait(2)", names)
attempt("places.put(2, timeout=P)", names)
mark("full")
attempt("places.put(3, True, 5 * P)", names)
mark("room")
attempt("places.get(), places.empty()", names)
attempt("places.get(timeout=-1)", names)
