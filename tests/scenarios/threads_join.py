"""Thread.join with and without a timeout, and what is_alive says before, meanwhile and after."""

import threading

from scenario import P, attempt, begin, block, mark, say

begin("threads_join")
worker = threading.Thread(target=block, args=(2,))
say("before", worker.is_alive(), worker.ident)
worker.start()
say("meanwhile", worker.is_alive(), worker.ident is not None)
say("too short", worker.join(P), worker.is_alive())
mark("too_short")
say("joined", worker.join(), worker.is_alive())
mark("joined")
say("again", worker.join(), worker.join(1), worker.is_alive())
attempt("worker.start()", {"worker": worker})
quick = threading.Thread(target=block, args=(1,))
quick.start()
say("long enough", quick.join(timeout=20), quick.is_alive())
mark("long_enough")
