"""Two threads that take two locks in the same order exclude each other and never block for good."""

import threading

from scenario import begin, block, mark

left, right = threading.Lock(), threading.Lock()


def work(name):
    for _ in range(2):
        with left:
            block(0.5)
            with right:
                mark(name)
                block(0.5)
        block(0.5)


begin("threads_lock_order")
first = threading.Thread(target=work, args=("first",))
second = threading.Thread(target=work, args=("second",))
first.start()
block(0.5)
second.start()
first.join()
second.join()
mark("both")
