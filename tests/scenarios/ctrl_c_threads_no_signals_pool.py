"""With disable_signals a KeyboardInterrupt ends Future.result; the pool still waits for its task."""

from concurrent.futures import ThreadPoolExecutor

from scenario import begin, block, mark, say

begin("ctrl_c_threads_no_signals_pool", disable_signals=True)
with ThreadPoolExecutor(1) as pool:
    future = pool.submit(block, 7)
    try:
        future.result()
    except KeyboardInterrupt:
        mark("caught")
        say("done", future.done())
mark("shut_down")
say("done", future.done())
