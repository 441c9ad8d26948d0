"""What the other nodes do, as words of the command line say: ``KIND,LABEL,RATE[,OPTION=NUMBER]...``."""

import gc
import random
import time


class Activity:
    """One of the things that a node does again and again, with the faults that its options ask for.

    ``work`` and ``spread``: each pass takes so long, in s, and at random up to so much more. ``slow``: the pass number
    ``at``, or each one that ``every`` divides, takes so much longer; with ``lines`` it logs its beginning. ``jitter``:
    each line comes at random so much later.
    """

    def __init__(self, word, log):
        self.kind, self.label, rate, *options = word.split(",")
        self.rate = float(rate)
        self.options = {name: float(value) for name, _, value in (option.partition("=") for option in options)}
        self.log = log
        self.count = 0
        self.random = random.Random(word)

    def get(self, name):
        return self.options.get(name, 0.0)

    def __call__(self, said=None):
        """Make a pass: log its line, which ends in ``said`` or in a count, and do the work."""
        self.count += 1
        if self.get("jitter"):
            time.sleep(min(self.random.expovariate(1 / self.get("jitter")), 20 * self.get("jitter")))
        if not self.get("silent"):
            self.log(f"{self.label}: {self.count if said is None else said}".replace("_", " "))
        work = self.get("work") + self.random.random() * self.get("spread")
        every = self.get("every")
        if self.count == self.get("at") or (every and self.count % every == 0):
            if self.get("lines"):
                self.log(f"{self.label} works for long".replace("_", " "))
            work += self.get("slow")
        if work:
            time.sleep(work)

    def burst(self, *_):
        """Make as many passes as ``size`` says, at random fewer by up to ``fewer``, one right after the other."""
        for _ in range(int(self.get("size")) - self.random.randint(0, int(self.get("fewer")))):
            self()

    def collect_garbage(self):
        """Let Python look through as many objects as ``objects`` says, in vain, during which no thread runs."""
        self.heap = [[] for _ in range(int(self.get("objects")))]
        gc.collect()  # the first one takes longest
        while True:
            time.sleep(1 / self.rate)
            gc.collect()

    def loop(self, sleep):
        """Make passes without end, each followed by ``sleep``."""
        while True:
            self()
            sleep()
