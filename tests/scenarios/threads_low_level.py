"""The module _thread itself: locks, threads without a Thread, exit."""

import _thread

from scenario import attempt, begin, block, mark, say

begin("threads_low_level")
lock = _thread.allocate_lock()
finished = _thread.allocate_lock()


def work(number, periods=1):
    with lock:
        mark("work")
        block(periods)
    if number == 1:
        _thread.exit()
    finished.release()


lock.acquire()
finished.acquire()
idents = [_thread.start_new_thread(work, (1,))]
block(0.5)
idents.append(_thread.start_new_thread(work, (2,), {"periods": 1.5}))
block(0.5)
say(lock.locked(), len({*idents, _thread.get_ident()}), isinstance(lock, _thread.LockType))
lock.release()
finished.acquire()
mark("finished")
attempt("_thread.start_new_thread(1, ())", {"_thread": _thread})
