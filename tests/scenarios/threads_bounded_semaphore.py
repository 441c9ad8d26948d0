"""A BoundedSemaphore refuses to be released more often than it was acquired."""

import threading

from scenario import attempt, begin, block, mark, until

places = threading.BoundedSemaphore(2)


def park(name, periods):
    with places:
        mark(name)
        block(periods)


begin("threads_bounded_semaphore")
cars = [threading.Thread(target=park, args=car) for car in (("red", 3), ("green", 1), ("blue", 1))]
for number, car in enumerate(cars):
    until(0.5 * number)
    car.start()
for car in cars:
    car.join()
mark("all")
attempt("places.release()", {"places": places})
attempt("places.acquire(), places.acquire(), places.acquire(blocking=False)", {"places": places})
attempt("places.release(2)", {"places": places})
attempt("places.release()", {"places": places})
