"""A barrier at which one party never arrives breaks for all of them, until it is reset."""

import threading

from scenario import P, begin, block, mark, say, until


def work(name):
    try:
        barrier.wait(2 * P if name == "first" else None)
    except threading.BrokenBarrierError as error:
        results.append((name, repr(error), barrier.broken))
        mark(name)


results = []
barrier = threading.Barrier(3)
begin("threads_barrier_timeout")
workers = [threading.Thread(target=work, args=(name,)) for name in ("first", "second")]
for worker in workers:
    worker.start()
    block(0.5)
say("waiting", barrier.n_waiting, barrier.broken)
for worker in workers:
    worker.join()
say(sorted(results))
try:
    barrier.wait()
except threading.BrokenBarrierError:
    say("still broken")
barrier.reset()
say("reset", barrier.broken, barrier.n_waiting)
until(4)
friends = [threading.Thread(target=barrier.wait) for _ in range(2)]
for friend in friends:
    friend.start()
block(1)
barrier.wait()
mark("met")
