"""With disable_signals a KeyboardInterrupt ends Lock.acquire, with and without a timeout; the lock is not taken."""

import threading

from scenario import P, begin, mark, say

lock = threading.Lock()
lock.acquire()
begin("ctrl_c_threads_no_signals_lock", disable_signals=True)
try:
    lock.acquire(timeout=20 * P)
except KeyboardInterrupt:
    mark("caught")
lock.release()
say("locked", lock.locked())
with lock:
    say("usable")
