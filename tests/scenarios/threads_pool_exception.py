"""An exception in a task is raised by its result, and prints nothing by itself; callbacks run when a task is done."""

import threading
from concurrent.futures import ThreadPoolExecutor

from scenario import begin, block, mark, say


def fail(text):
    block(1)
    raise ValueError(text)


def done(future):
    mark("done")
    say("callback", repr(future.exception()), threading.current_thread().name)


begin("threads_pool_exception")
with ThreadPoolExecutor(2, thread_name_prefix="pool") as pool:
    first = pool.submit(fail, "first")
    first.add_done_callback(done)
    block(0.5)
    second = pool.submit(fail, "second")
    try:
        first.result()
    except ValueError as error:
        block(0.5)
        say("result", error)
        mark("result")
    say("exception", repr(second.exception()))
    mark("exception")
    pool.submit(fail, "never seen")
mark("shut_down")
first.add_done_callback(lambda future: say("at once", future is first))
