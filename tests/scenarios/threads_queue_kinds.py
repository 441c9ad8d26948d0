"""Which element comes out of a Queue, a LifoQueue, a PriorityQueue and a SimpleQueue, and when they wait."""

import queue
import threading

from scenario import P, begin, block, mark, say


def fill(kind):
    for element in ((2, "b"), (1, "c"), (3, "a")):
        kind.put(element)
    block(2)
    kind.put((0, "late"))


begin("threads_queue_kinds")
for kind in (queue.Queue(), queue.LifoQueue(), queue.PriorityQueue(), queue.SimpleQueue()):
    name = type(kind).__name__
    filler = threading.Thread(target=fill, args=(kind,))
    filler.start()
    block(0.5)
    say(name, kind.qsize(), [kind.get(), kind.get(timeout=1), kind.get_nowait()], kind.empty())
    try:
        kind.get(timeout=0.5 * P)
    except queue.Empty:
        mark(f"{name}_empty")
    say(kind.get())
    mark(f"{name}_late")
    filler.join()
