"""What acquire answers, with and without a timeout, while another thread holds the lock."""

import threading

from scenario import attempt, begin, block, mark, say, until

lock = threading.Lock()


def hold():
    with lock:
        block(2)


begin("threads_lock_timeout")
holder = threading.Thread(target=hold)
holder.start()
until(0.5)
say("without waiting", lock.acquire(False), lock.acquire(blocking=False), lock.acquire(timeout=0), lock.locked())
say("too short", lock.acquire(timeout=0.2))
mark("too_short")
say("long enough", lock.acquire(True, 2.0))
mark("long_enough")
say("locked", lock.locked())
lock.release()
say("free", lock.locked(), lock.acquire(timeout=-1), lock.locked())
attempt("lock.acquire(False, 1)", {"lock": lock})
for timeout in (-2, 1e300, "1"):
    try:
        lock.acquire(timeout=timeout)
    except (OverflowError, TypeError, ValueError) as error:
        say(timeout, type(error).__name__)
