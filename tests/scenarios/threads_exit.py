"""sys.exit in a thread ends that thread alone, in silence; so does a SystemExit of its own."""

import sys
import threading

from scenario import begin, block, mark, say


def leave(how):
    block(1)
    mark("leaves")
    how()
    say("never")


def raise_exit():
    raise SystemExit("not seen")


begin("threads_exit")
for how in (sys.exit, lambda: sys.exit(3), raise_exit):
    worker = threading.Thread(target=leave, args=(how,))
    worker.start()
    worker.join()
    say("alive", worker.is_alive())
mark("goes_on")
