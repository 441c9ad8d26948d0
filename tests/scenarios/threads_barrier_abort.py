"""abort and reset wake those who wait at a barrier, with a BrokenBarrierError; so does an action that fails."""

import threading

from scenario import begin, mark, say, until


def work(name):
    try:
        barrier.wait()
    except threading.BrokenBarrierError:
        mark(name)


def fail():
    raise ValueError("the action fails")


begin("threads_barrier_abort")
barrier = threading.Barrier(2)
first = threading.Thread(target=work, args=("aborted",))
first.start()
until(1)
barrier.abort()
first.join()
say("aborted", barrier.broken)
barrier.reset()
second = threading.Thread(target=work, args=("reset",))
second.start()
until(2)
barrier.reset()
second.join()
say("reset", barrier.broken)
barrier = threading.Barrier(2, fail)
third = threading.Thread(target=work, args=("failed",))
third.start()
until(3)
try:
    barrier.wait()
except ValueError as error:
    say(error, barrier.broken)
third.join()
