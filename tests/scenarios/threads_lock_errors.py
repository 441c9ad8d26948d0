"""Releasing what is not held, waiting without holding, and other mistakes with locks."""

import threading

from scenario import attempt, begin

begin("threads_lock_errors")
names = {"threading": threading, "lock": threading.Lock(), "condition": threading.Condition()}
names |= {"rlock": threading.RLock(), "semaphore": threading.Semaphore(), "bounded": threading.BoundedSemaphore(2)}
attempt("lock.release()", names)
attempt("lock.__exit__(None, None, None)", names)
attempt("rlock.release()", names)
attempt("condition.wait()", names)
attempt("condition.wait(0.1)", names)
attempt("condition.notify()", names)
attempt("condition.notify_all()", names)
attempt("condition.release()", names)
attempt("bounded.release()", names)
attempt("semaphore.release(0)", names)
attempt("semaphore.acquire(False, 1)", names)
attempt("threading.Semaphore(-1)", names)
attempt("threading.Thread(1)", names)
attempt("threading.Thread(target=print).join()", names)
attempt("threading.current_thread().join()", names)
attempt("threading.current_thread().start()", names)
attempt("setattr(threading.current_thread(), 'daemon', True)", names)
