"""Three threads meet at a barrier, twice; its action runs once each time, before any of them continues."""

import threading

from scenario import begin, block, mark, say

met = []


def action():
    met.append(threading.current_thread().name)
    mark("action")


def work(number, lengths):
    for periods in lengths:
        block(periods)
        places[number].append(barrier.wait())
        mark(f"past{number}")


barrier = threading.Barrier(3, action)
places = [[], [], []]
begin("threads_barrier")
workers = [
    threading.Thread(target=work, args=(number, lengths), name=f"worker{number}")
    for number, lengths in enumerate([(1, 2), (2, 1.5), (1.5, 1)])
]
for worker in workers:
    worker.start()
for worker in workers:
    worker.join()
mark("all")
say(places, met, barrier.parties, barrier.n_waiting, barrier.broken)
