"""A pool that is shut down takes no task; what waits in it can be cancelled; its threads begin with an initializer."""

import threading
from concurrent.futures import ThreadPoolExecutor

from scenario import attempt, begin, block, mark, say

own = threading.local()


def initialize(value):
    own.value = value


def work(periods):
    block(periods)
    return own.value, threading.current_thread().name


begin("threads_pool_shutdown")
pool = ThreadPoolExecutor(1, "pool", initialize, ("initial",))
futures = [pool.submit(work, periods) for periods in (1, 1, 1)]
block(0.5)
pool.shutdown(wait=False)
mark("not_waited")
attempt("pool.submit(print)", {"pool": pool})
block(1)
pool.shutdown(cancel_futures=True)
mark("shut_down")
say([future.cancelled() for future in futures], futures[0].result(), futures[1].result())
