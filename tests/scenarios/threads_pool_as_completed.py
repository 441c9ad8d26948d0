"""as_completed gives futures as they end, and wait those that ended first, failed first, or in time."""

from concurrent import futures

from scenario import P, begin, block, mark, say


def work(periods):
    block(periods)
    if periods == 2:
        raise ArithmeticError("two")
    return periods


begin("threads_pool_as_completed")
with futures.ThreadPoolExecutor() as pool:
    names = {pool.submit(work, periods): periods for periods in (3, 1, 2)}
    for future in futures.as_completed(names):
        say(names[future], repr(future.exception()))
        mark("completed")
    for condition in (futures.FIRST_COMPLETED, futures.FIRST_EXCEPTION, futures.ALL_COMPLETED):
        names = {pool.submit(work, periods): periods for periods in (3, 1, 2)}
        done, not_done = futures.wait(names, return_when=condition)
        mark(condition)
        say(condition, sorted(names[future] for future in done), sorted(names[future] for future in not_done))
        futures.wait(names)
    names = {pool.submit(work, periods): periods for periods in (1, 3)}
    done, not_done = futures.wait(names, timeout=2 * P)
    say("in time", [names[future] for future in done], [names[future] for future in not_done])
    try:
        for future in futures.as_completed(names, timeout=0.5 * P):
            say("completed", names[future])
    except TimeoutError as error:
        say(error)
        mark("timeout")
