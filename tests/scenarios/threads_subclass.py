"""A subclass of Thread with a run of its own, and a result that the main reads when it has ended."""

import threading

from scenario import begin, block, mark


class Measurement(threading.Thread):
    def __init__(self, count):
        super().__init__(name=f"measurement of {count}", daemon=True)
        self.count = count
        self.values = []

    def run(self):
        for number in range(self.count):
            block(0.5)
            self.values.append(number * number)
        mark(f"ends{self.count}")


begin("threads_subclass")
measurements = [Measurement(count) for count in (2, 4)]
for measurement in measurements:
    measurement.start()
for measurement in measurements:
    measurement.join()
    mark("joined")
    print(measurement.name, measurement.values, measurement.is_alive())
Measurement(0).run()
