"""Six tasks for a pool of two workers: each begins when a worker is free, the results come in their order."""

from concurrent.futures import ThreadPoolExecutor

from scenario import begin, block, mark, say


def work(number, periods):
    mark(f"begin{number}")
    block(periods)
    mark(f"end{number}")
    return number * number


begin("threads_pool")
with ThreadPoolExecutor(max_workers=2) as pool:
    lengths = (1, 1.5, 2, 1, 0.5, 1)
    futures = [pool.submit(work, number, periods) for number, periods in enumerate(lengths)]
    block(0.5)
    say([future.running() for future in futures], [future.done() for future in futures])
    say([future.result() for future in futures])
    mark("results")
mark("shut_down")
