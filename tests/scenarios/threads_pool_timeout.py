"""Future.result with a timeout; a task that waits can be cancelled, one that runs cannot."""

import concurrent.futures

from scenario import P, begin, block, mark, say

begin("threads_pool_timeout")
with concurrent.futures.ThreadPoolExecutor(1) as pool:
    running = pool.submit(block, 2)
    waiting = pool.submit(print, "never")
    block(0.5)
    for timeout in (0, P):
        try:
            running.result(timeout)
        except concurrent.futures.TimeoutError as error:
            say("timeout", type(error) is TimeoutError)
            mark("timeout")
    say("cancel", running.cancel(), waiting.cancel(), waiting.cancelled(), waiting.done(), running.done())
    try:
        waiting.result()
    except concurrent.futures.CancelledError:
        say("cancelled")
    say("result", running.result(timeout=5 * P))
    mark("result")
