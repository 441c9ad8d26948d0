"""Executor.map gives results in the order of its arguments, each when it is there, with one timeout for all."""

from concurrent.futures import ThreadPoolExecutor

from scenario import P, begin, block, mark, say


def work(periods):
    block(periods)
    return periods


begin("threads_pool_map")
with ThreadPoolExecutor(2) as pool:
    for result in pool.map(work, (2, 1, 2, 0.5)):
        say(result)
        mark("result")
    say(list(pool.map(pow, (1, 2, 3), (4, 5, 6))))
with ThreadPoolExecutor(2) as pool:
    results = pool.map(work, (0.5, 2), timeout=P)
    say(next(results))
    mark("in_time")
    try:
        next(results)
    except TimeoutError:
        mark("too_late")
mark("shut_down")
