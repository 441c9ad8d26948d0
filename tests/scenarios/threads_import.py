"""Two threads import the same slow module: its body runs once, the second thread waits for it."""

import threading

from scenario import begin, block, mark, say


def load(name):
    from robot import slow

    mark(name)
    values.append(slow.value)


begin("threads_import")
values = []
loaders = [threading.Thread(target=load, args=(name,)) for name in ("first", "second")]
for loader in loaders:
    loader.start()
    block(1)
for loader in loaders:
    loader.join()
mark("all")
say(values)
