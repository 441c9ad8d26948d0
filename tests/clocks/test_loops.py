"""Loops of asyncio on simulated time."""

from __future__ import annotations

import asyncio
import sys
from typing import Any

import pytest

from rosspin import TimeStandsStill, simulate, start

HEAD = "import asyncio, signal, threading, time\nnow = time.monotonic\n"


def said(write: Any, code: str, seconds: float = 10, **options: Any) -> list[str]:
    """The lines that a node prints."""
    run = simulate(write(HEAD + code), seconds, **options)
    assert run.status == 0, run.console
    return run.console.splitlines()


def test_coroutines_sleep_and_time_out(write: Any) -> None:
    code = """
async def work(name, seconds):
    for _ in range(2):
        await asyncio.sleep(seconds)
        print(name, now(), asyncio.get_running_loop().time())
async def main():
    await asyncio.gather(work('a', 0.5), work('b', 0.75))
    try:
        await asyncio.wait_for(asyncio.Event().wait(), 3600)
    except TimeoutError:
        print(now())
asyncio.run(main())
"""
    lines = said(write, code, seconds=4000)
    assert lines == ["a 0.5 0.5", "b 0.75 0.75", "a 1.0 1.0", "b 1.5 1.5", "3601.5"]


def test_threads_and_loops_wait_for_each_other(write: Any) -> None:
    code = """
async def main():
    loop, event = asyncio.get_running_loop(), asyncio.Event()
    threading.Timer(2.5, lambda: loop.call_soon_threadsafe(event.set)).start()
    await event.wait()
    print(now())
    def other():
        time.sleep(1)
        return asyncio.run_coroutine_threadsafe(asyncio.sleep(0.5, 'done'), loop).result()
    print(await asyncio.to_thread(other), now())
asyncio.run(main())
"""
    assert said(write, code) == ["2.5", "done 4.0"]


def test_a_loop_lives_with_a_node_that_is_spun(write: Any) -> None:
    code = """
import rclpy
rclpy.init()
node = rclpy.create_node('node')
node.create_timer(0.5, lambda: print('tick', round(now(), 1)))
async def main(spin):
    task = asyncio.ensure_future(spin())
    await asyncio.sleep(1.2)
    print('slept', round(now(), 1))
    task.cancel()
async def inside():
    while True:
        rclpy.spin_once(node, timeout_sec=0)
        await asyncio.sleep(0.1)
async def beside():
    await asyncio.to_thread(rclpy.spin, node)
asyncio.run(main(inside))
threading.Thread(target=lambda: (time.sleep(1), rclpy.shutdown())).start()
try:
    asyncio.run(main(beside))
except rclpy.executors.ExternalShutdownException:
    pass
"""
    assert said(write, code) == ["tick 0.5", "tick 1.0", "slept 1.2", "tick 1.5", "tick 2.0", "slept 2.4"]


def test_each_thread_may_run_a_loop(write: Any) -> None:
    code = """
async def work(name, seconds):
    loop = asyncio.get_running_loop()
    for _ in range(2):
        await asyncio.sleep(seconds)
        time.sleep(0.1)  # blocks its own loop only
        print(name, now(), asyncio.get_running_loop() is loop)
threading.Thread(target=lambda: asyncio.run(work('thread', 1))).start()
asyncio.run(work('main', 1.5))
"""
    assert said(write, code) == ["thread 1.1 True", "main 1.6 True", "thread 2.2 True", "main 3.2 True"]


def test_a_loop_that_only_looks_lets_time_pass(write: Any) -> None:
    code = """
ready = threading.Event()
threading.Timer(0.1, ready.set).start()
async def main():
    while not ready.is_set():
        await asyncio.sleep(0)
    print(round(now(), 4))
asyncio.run(main())
"""
    assert said(write, code) == ["0.1"]


def test_timers_are_exact_to_what_a_float_can_tell_decades_later(write: Any) -> None:
    code = """
async def main():
    before = now()
    for _ in range(100):
        await asyncio.sleep(0.01)
    print(round(now() - before, 4))
asyncio.run(main())
"""
    assert said(write, code, start=1.7e9) == ["1.0"]


def test_ctrl_c_cancels_what_asyncio_runs(write: Any) -> None:
    code = """
async def main():
    try:
        await asyncio.sleep(100)
    finally:
        print('cancelled', now())
asyncio.run(main())
"""
    run = simulate(write(HEAD + code), 5)
    assert (run.status, run.console.splitlines()[0], run.console.splitlines()[-1]) == (
        *(130, "cancelled 5.0", "KeyboardInterrupt"),
    )


def test_a_loop_handles_signals(write: Any) -> None:
    code = """
async def main():
    loop, stop = asyncio.get_running_loop(), asyncio.Event()
    loop.add_signal_handler(signal.SIGINT, stop.set)
    loop.add_signal_handler(signal.SIGTERM, print, 'asked to end')
    threading.Timer(1, signal.raise_signal, [signal.SIGTERM]).start()
    await stop.wait()
    print(now(), loop.remove_signal_handler(signal.SIGINT))
asyncio.run(main())
print(signal.getsignal(signal.SIGTERM) is signal.SIG_DFL)
"""
    assert said(write, code, seconds=5) == ["asked to end", "5.0 True", "True"]


def test_a_loop_in_a_thread_ends_with_its_node(write: Any) -> None:
    code = """
async def main():
    while True:
        try:
            await asyncio.sleep(1)
        finally:
            await asyncio.sleep(1)
threading.Thread(target=lambda: asyncio.run(main()), daemon=True).start()
time.sleep(2.5)
print('ends')
"""
    assert said(write, code) == ["ends"]


@pytest.mark.parametrize("then", ["", "    except BaseException:\n        await asyncio.sleep(1)\n"])
def test_a_coroutine_that_keeps_time_from_going_on_is_named(impatient: None, write: Any, then: str) -> None:
    code = "import asyncio\nasync def main():\n    try:\n        while True:\n            pass\n"
    path = write(f"{code}{then or '    finally: pass'}\nasyncio.run(main())\n")
    with pytest.raises(TimeStandsStill, match=rf"^{path}:[45]: simulated time stands still at 0.0 s, because the node"):
        simulate(path, 5)


def test_a_loop_goes_on_from_step_to_step(write: Any) -> None:
    code = """
async def main():
    while True:
        time.sleep(0.5)
        await asyncio.sleep(0.5)
        print(now(), asyncio.get_running_loop().is_running())
try:
    asyncio.run(main())
except KeyboardInterrupt:
    pass
"""
    with start(write(HEAD + code)) as node:
        for _ in range(5):
            node.advance(0.25)
            assert asyncio._get_running_loop() is None
        assert node.run.console == "1.0 True\n"


def test_a_coroutine_that_blocks_keeps_no_other_thread_from_its_loop(write: Any) -> None:
    """Each thread has its own running loop, and the task in it."""
    code = """
async def blocks(name):
    for _ in range(2):
        time.sleep(0.5)
        await asyncio.sleep(0.1)
    print(name, now(), asyncio.current_task().get_name())
def later():
    time.sleep(0.25)
    asyncio.run(blocks('later'))
threading.Thread(target=later).start()
asyncio.run(blocks('main'))
"""
    lines = said(write, code)
    assert [line.rsplit(maxsplit=1)[0] for line in lines] == ["main 1.2", "later 1.45"]


def test_a_run_within_a_loop_is_not_in_it(write: Any) -> None:
    async def outside() -> None:
        loop = asyncio.get_running_loop()
        assert said(write, "asyncio.run(asyncio.sleep(1))\nprint(now())\n") == ["1.0"]
        assert asyncio.get_running_loop() is loop

    asyncio.run(outside())


def test_a_run_finds_no_loop_of_an_earlier_one(write: Any) -> None:
    code = """
loop = asyncio.get_event_loop()
loop.call_later(5, print, 'late')
loop.run_until_complete(asyncio.sleep(1))
"""
    policy: Any = getattr(asyncio.events, "_event_loop_policy")  # noqa: B009
    for _ in range(2):
        run = simulate(write(HEAD + code), 10)
        assert "late" not in run.console
    assert getattr(asyncio.events, "_event_loop_policy") is policy  # noqa: B009
    assert simulate(write(f"{HEAD}asyncio.run(asyncio.sleep(100))\n"), 1).status == 130


@pytest.mark.skipif(sys.version_info < (3, 12), reason="eager tasks came with Python 3.12")
def test_eager_tasks(write: Any) -> None:
    code = """
async def main():
    asyncio.get_running_loop().set_task_factory(asyncio.eager_task_factory)
    await asyncio.gather(asyncio.sleep(1), asyncio.sleep(2))
    print(now())
asyncio.run(main())
"""
    assert said(write, code) == ["2.0"]
