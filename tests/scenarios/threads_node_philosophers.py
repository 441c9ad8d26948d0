"""Four philosophers who all take the fork of the lower number first: all eat, none starves."""

import threading

from scenario import begin, block, mark, until

COUNT = 4
forks = [threading.Lock() for _ in range(COUNT)]


def dine(number):
    low, high = sorted((number, (number + 1) % COUNT))
    with forks[low], forks[high]:
        mark(f"eats{number}")
        block(1.25)


begin("threads_node_philosophers")
philosophers = [threading.Thread(target=dine, args=(number,)) for number in range(COUNT)]
for number, philosopher in enumerate(philosophers):
    until(0.5 * number)
    philosopher.start()
for philosopher in philosophers:
    philosopher.join()
mark("all")
