"""Exploring finds what fails in some order, and nothing else; what it finds is run again byte for byte."""

from __future__ import annotations

import dataclasses
import math
import pickle
import random
import re
import sys
from collections.abc import Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from importlib import import_module
from itertools import count
from multiprocessing import get_context
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

import rosspin
from benchmarks.planted_orders import PLANTS
from rosspin.__main__ import main
from rosspin.clocks.explored import Order
from rosspin.faults import Crash, Fault, Slow
from rosspin.orders.strategies import bound_of_pct

pytestmark = pytest.mark.shares(9)

LOST = PLANTS["ros1-lost-update"]


@pytest.fixture
def racing(tmp_path: Path) -> str:
    return LOST.write(tmp_path, mended=False)[0]


@pytest.mark.parametrize("name", PLANTS)
def test_each_planted_fault_is_found_and_not_in_its_mended_twin(name: str, tmp_path: Path) -> None:
    plant = PLANTS[name]
    planted = plant.write(tmp_path, mended=False)
    plant.check(rosspin.simulate(planted, plant.seconds))  # nothing shows in the usual order
    found = rosspin.explore(planted, plant.seconds, plant.check, deep=plant.deep)
    assert found.failure
    assert 1 < found.schedules <= 1000
    again = rosspin.simulate(planted, plant.seconds, schedule=found.token)
    assert found.run is not None
    assert (again.console, again.ticks) == (found.run.console, found.run.ticks)
    twin = rosspin.explore(plant.write(tmp_path, mended=True), plant.seconds, plant.check, deep=plant.deep, schedules=8)
    assert not twin.failure, twin
    assert twin.token == ""


@pytest.mark.parametrize("strategy", ["pct", "random", "all"])
def test_each_strategy_finds_it_and_makes_it_short(strategy: str, racing: str) -> None:
    found = rosspin.explore(racing, 0.5, LOST.check, strategy=strategy, deep=True)
    assert found.failure.startswith("AssertionError")
    assert found.token.count(".") == 1
    assert rosspin.explore(racing, 0.5, LOST.check, strategy=strategy, deep=True) == found


def test_the_answer_shows_both_orders_in_lines_of_the_node(racing: str) -> None:
    answer = str(rosspin.explore(racing, 0.5, LOST.check, deep=True))
    assert "In the shortest order found, which deviates once from the usual one, after " in answer
    assert "the usual order" in answer
    assert re.search(r"\nThread-1 +\d+  self\.count \+= 1 .* \| Thread-1 +\d+  self\.count \+= 1", answer)
    assert re.search(r"\nThread-1 +\d+  print\(.* \* Thread-2 +\d+  self\.count \+= 1", answer)
    assert "the first line in which the consoles differ\n  usually  count" in answer


def test_a_deadlock_is_named_as_the_ring_of_waits(tmp_path: Path) -> None:
    plant = PLANTS["ros1-lock-order"]
    found = rosspin.explore(plant.write(tmp_path, mended=False)[0], plant.seconds, deep=True)
    assert found.failure.startswith("deadlock. This can never continue:\n  the thread Thread-")
    assert "waits for a lock that the thread Thread-" in found.failure
    assert found.failure.endswith("Take the locks in the same order everywhere.")


def test_an_uncaught_exception_is_a_failure_without_any_check(tmp_path: Path) -> None:
    plant = PLANTS["ros2-who-begins"]
    found = rosspin.explore(plant.write(tmp_path, mended=False)[0], plant.seconds)
    assert found.failure.startswith("uncaught: TypeError: unsupported operand")


def test_all_says_so_when_it_has_seen_all(tmp_path: Path) -> None:
    plant = PLANTS["ros1-stale-reading"]
    (planted,) = plant.write(tmp_path, mended=False)
    seen = rosspin.explore(planted, 0.2, strategy="all")
    assert seen.bound == math.inf
    assert str(
        seen
    ) == f"There are {seen.schedules} orders. All were run, and all are well: this is proved for what " + (
        "may differ."
    )
    part = rosspin.explore(planted, 0.2, strategy="all", schedules=seen.schedules - 1)
    assert part.bound < math.inf
    assert f"All that deviate at most {'once' if part.bound == 1 else 'twice'} are among them" in str(part)
    assert "not even all that deviate once" in str(rosspin.explore(planted, 0.2, strategy="all", schedules=2))
    (mended,) = plant.write(tmp_path, mended=True)
    assert str(rosspin.explore(mended, 0.2)) == "There is only one order: nothing is open at any instant. It is well."


def test_what_fails_in_the_usual_order_is_told_at_once() -> None:
    def node() -> None:
        raise ValueError("broken")

    found = rosspin.explore(node, 1.0)
    assert (found.schedules, found.token, found.failure) == (1, "1", "uncaught: ValueError: broken")
    assert str(found).splitlines()[1] == "In the usual order: 1"


def test_time_that_stands_still_is_a_failure(watchful: None, tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text("import time\nwhile True:\n    time.sleep(0)\n")
    found = rosspin.explore(str(path), 1.0)
    assert "simulated time stands still" in found.failure
    assert found.run is None


def test_what_a_fault_does_is_no_failure(tmp_path: Path) -> None:
    """Of a node that it kills the status counts for nothing, and a name may be there later than usual."""
    talker, listener = tmp_path / "talker.py", tmp_path / "listener.py"
    begin = "import rclpy\nfrom std_msgs.msg import UInt32\nrclpy.init()\nnode = rclpy.create_node({!r})\n"
    publish = "publisher = node.create_publisher(UInt32, 'number', 10)\nsend = lambda: publisher.publish(UInt32())\n"
    spin = "try:\n    rclpy.spin(node)\nexcept KeyboardInterrupt:\n    pass\n"
    talker.write_text(begin.format("talker") + publish + "node.create_timer(0.1, send)\n" + spin)
    hear = "def hear(number):\n    print('heard')\nnode.create_subscription(UInt32, 'number', hear, 10)\n"
    listener.write_text(begin.format("listener") + hear + spin)

    def explore(*faults: Fault, check: Any = None) -> rosspin.Exploration:
        return rosspin.explore([str(talker), str(listener)], 0.9, check, faults=faults, schedules=20)

    assert explore(Crash("/talker", at=0.5)).failure == ""
    assert explore(Slow("/listener", "hear", 0.05)).failure == ""
    with pytest.raises(ValueError, match="called no heard; it called hear"):
        explore(Slow("/listener", "heard", 0.05))

    def breaks(run: rosspin.Run) -> None:
        assert run.console.splitlines()[0] == "heard"

    assert "IndexError" in explore(check=breaks).failure  # where they find each other too late


def test_a_node_that_does_not_do_the_same_twice_has_no_order_that_fails(tmp_path: Path, racing: str) -> None:
    runs = count()

    def check(run: rosspin.Run) -> None:
        assert next(runs) != 2

    found = rosspin.explore(racing, 0.5, check, deep=True)
    assert "does not do the same in each run" in str(found)


@pytest.mark.parametrize("ros", [1, 2])
def test_of_several_nodes_the_answer_says_whose_turn_it_is(tmp_path: Path, ros: int) -> None:
    """Even before they have names."""
    begin = ("import rospy\nrospy.init_node({!r})\n", "import rclpy\nrclpy.init()\nrclpy.create_node({!r})\n")[ros - 1]
    nodes = [tmp_path / f"{name}.py" for name in ("one", "two")]
    for node in nodes:
        node.write_text(f"{begin.format(node.stem)}print({node.stem!r})\n")

    def one_is_first(run: rosspin.Run) -> None:
        assert run.console.startswith("one")

    found = rosspin.explore(nodes, 0.1, one_is_first, strategy="all")
    assert "  at 0 s usually one.py, here two.py\n" in str(found)


def test_the_bound_of_pct_is_told(racing: str) -> None:
    said = str(rosspin.explore(racing, 0.5, schedules=30))
    assert "30 orders were run" in said
    assert re.search(r"a fault of depth 1, 2 or 3 would have been found with a probability of at least 9\d, ", said)


def test_the_usual_order_of_an_explored_run_is_that_of_any_other(tmp_path: Path) -> None:
    for plant in PLANTS.values():
        nodes = plant.write(tmp_path, mended=True)
        usual = rosspin.simulate(nodes, plant.seconds)
        for token in ("1", "1d"):
            explored = rosspin.simulate(nodes, plant.seconds, schedule=token)
            assert (explored.console, explored.ticks) == (usual.console, usual.ticks)
            assert str(explored.messages) == str(usual.messages)


def test_the_usual_order_is_no_run_of_pct() -> None:
    assert bound_of_pct(2, 4, 3, depth=3) == 0 < bound_of_pct(2, 4, 3, depth=2)
    assert bound_of_pct(2, 4, 4, depth=3) == 1 / 32


# --- tokens -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("token", ["1", "1d", "1-0.1", "1d-3.2-40.1"])
def test_a_token_is_read_as_it_was_written(token: str) -> None:
    order = Order.of(token)
    order.made = order.planned
    assert order.token == token


@pytest.mark.parametrize("token", ["x", "1-", "1-1", "1d-1.x", "-1.1", "1 ", 7])
def test_what_is_no_token(token: str) -> None:
    with pytest.raises(ValueError, match=r"is no schedule: one looks like 1-12\.1"):
        Order.of(token)


@pytest.mark.parametrize(
    ("token", "said"),
    [
        ("1-999.1", r"from 999\.1 on: the run has only \d+ points at which the order is open"),
        ("1-0.9", r"from 0\.9 on: 2 things can happen next"),
        ("9-0.1", "another version of rosspin"),
    ],
)
def test_a_token_of_another_node(token: str, said: str, racing: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(ValueError, match=said):
        rosspin.simulate(racing, 0.5, schedule=token)
    assert main(["run", racing, "--simulated", "--seconds", "0.5", "--schedule", token]) == 1
    assert capsys.readouterr().err.startswith("rosspin: ")


def test_the_command_line_replays_a_token(racing: str, capsys: pytest.CaptureFixture[str]) -> None:
    found = rosspin.explore(racing, 0.5, LOST.check, deep=True)
    assert found.run is not None
    assert main(["run", racing, "--simulated", "--seconds", "0.5", "--schedule", found.token]) == 0
    assert capsys.readouterr().out == found.run.console
    assert main(["run", racing, "--schedule", found.token]) == 1
    assert capsys.readouterr().err == "rosspin: --schedule is for simulated time: --simulated\n"


@pytest.mark.parametrize(
    ("wrong", "said"),
    [
        ({"strategy": "luck"}, "strategy is one of 'all', 'pct', 'random', not 'luck'"),
        ({"strategy": ["pct"]}, r"strategy is one of 'all', 'pct', 'random', not \['pct'\]"),
        ({"schedules": 0}, "schedules must be a whole number of at least 1, not 0"),
        ({"schedules": True}, "schedules must be a whole number of at least 1, not True"),
        ({"seed": None}, "seed must be a whole number, not None"),
        ({"seed": 1.5}, "seed must be a whole number, not 1.5"),
        ({"deep": True}, "deep is for node files; a function cannot be shaken"),
    ],
)
def test_wrong_calls(wrong: dict[str, object], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        rosspin.explore(random.random, 1.0, **wrong)  # type: ignore[arg-type]
    if "deep" not in wrong:
        with pytest.raises(ValueError, match=said):
            rosspin.explored(**wrong)  # type: ignore[arg-type]


def test_what_is_no_node_and_no_check() -> None:
    with pytest.raises(TypeError, match="check is a function of the run, not 'x'"):
        rosspin.explore(random.random, 1.0, "x")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="there is no node to run: the list is empty"):
        rosspin.explore([], 1.0)
    with pytest.raises(TypeError, match=r"a node is the path of a file, or a function, not b'node\.py'"):
        rosspin.explore(b"node.py", 1.0)  # type: ignore[arg-type]


# --- what is not open -------------------------------------------------------------------------------------------------


def test_what_ros_settles_is_never_in_another_order(tmp_path: Path) -> None:
    """One publisher's messages, an executor's round, one thread."""
    listener = tmp_path / "listener.py"
    listener.write_text(
        dedent("""
        import rclpy
        from rclpy.node import Node
        from std_msgs.msg import UInt32
        class Listener(Node):
            def __init__(self):
                super().__init__("listener")
                self.seen, self.ticks = [], []
                self.create_subscription(UInt32, "/count", self.hear, 10)
                for name in "ab":
                    self.create_timer(0.5, lambda name=name: self.tick(name))
            def hear(self, message):
                self.seen.append(message.data)
                assert self.seen == sorted(self.seen)
            def tick(self, name):
                self.ticks.append(name)
                assert self.ticks == (["a", "b"] * 9)[:len(self.ticks)]
        rclpy.init()
        rclpy.spin(Listener())
        """)
    )
    talker = tmp_path / "talker.py"
    talker.write_text(
        dedent("""
        import rclpy
        from rclpy.node import Node
        from std_msgs.msg import UInt32
        class Talker(Node):
            def __init__(self):
                super().__init__("talker")
                self.publisher = self.create_publisher(UInt32, "/count", 10)
                self.count = 0
                self.create_timer(0.5, self.tick)
            def tick(self):
                for _ in range(3):
                    self.count += 1
                    self.publisher.publish(UInt32(data=self.count))
        rclpy.init()
        rclpy.spin(Talker())
        """)
    )
    for strategy in ("random", "all"):
        seen = rosspin.explore([str(listener), str(talker)], 2.0, strategy=strategy, schedules=60)
        assert not seen.failure, seen
        assert seen.schedules == 60


def test_nothing_is_chosen_after_ctrl_c(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(
        dedent("""
        import rospy, threading
        rospy.init_node("node")
        said = []
        def work(name):
            try:
                rospy.spin()
            finally:
                said.append(name)
        for name in "abc":
            threading.Thread(target=work, args=name).start()
        rospy.on_shutdown(lambda: rospy.sleep(0.1))
        """)
    )
    seen = rosspin.explore(str(path), 0.0, strategy="all", schedules=50)
    usual = len(Order().options)
    assert not seen.failure
    assert usual == 0


def test_a_thread_that_only_looks_again_does_not_keep_others_for_ever(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(
        dedent("""
        import threading, time
        done = []
        def work():
            time.sleep(0.1)
            done.append(1)
        threading.Thread(target=work).start()
        time.sleep(0.1)
        while not done:
            time.sleep(0)
        """)
    )
    for strategy in ("pct", "random", "all"):
        assert not rosspin.explore(str(path), 1.0, strategy=strategy, schedules=20).failure


def test_a_status_is_a_failure_under_roslaunch_too(tmp_path: Path) -> None:
    for name, ros in (("one", "rospy"), ("two", "rospy")):
        (tmp_path / f"{name}.py").write_text(f"import sys, {ros}\nsys.exit({3 * (name == 'two')})\n")
    found = rosspin.explore([str(tmp_path / "one.py"), str(tmp_path / "two.py")], 1.0)
    assert found.failure == "two ended with status 3"


def test_each_ros_loses_turns_where_its_python_does(tmp_path: Path) -> None:
    """CPython 3.8 between any two instructions, from 3.10 on not within ``+= 1``."""
    for ros, is_found in ((1, True), (2, False)):
        path = tmp_path / f"ros{ros}.py"
        path.write_text(
            dedent(f"""
            import threading, {"rospy" if ros == 1 else "rclpy"}
            class Count:
                number = 0
            def count():
                Count.number += 1
            threads = [threading.Thread(target=count) for _ in range(2)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            print(Count.number)
            """)
        )

        def counts_both(run: rosspin.Run) -> None:
            assert run.console == "2\n"

        found = rosspin.explore(str(path), 1.0, counts_both, deep=True, schedules=100, strategy="random")
        assert bool(found.failure) is is_found


def test_a_loop_of_asyncio_stays_on_its_thread(tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(
        dedent("""
        import asyncio, threading
        async def work(number):
            for _ in range(3):
                await asyncio.sleep(0.1)
            return number
        async def main():
            print(sum(await asyncio.gather(*(work(number) for number in range(3)))))
        for _ in range(2):
            threading.Thread(target=lambda: asyncio.run(main())).start()
        """)
    )

    def says_all(run: rosspin.Run) -> None:
        assert run.console == "3\n3\n"

    found = rosspin.explore(str(path), 1.0, says_all, deep=True, schedules=40, strategy="random")
    assert not found.failure, found


@contextmanager
def while_nodes_run() -> Iterator[None]:
    """Within this context ``random`` is a node's own, as a thread of Dask's finds it that unpickles the next job."""
    shared = sys.modules.pop("random")
    import_module("random")
    try:
        yield
    finally:
        sys.modules["random"] = shared


class Backwards(Executor):
    """Runs the last first of what it was given, as if it came back from another process."""

    def __init__(self) -> None:
        self.left: list[tuple[Future[Any], bytes]] = []

    def submit(self, function: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future = _Asked(self)
        with while_nodes_run():
            self.left.append((future, pickle.dumps((function, args, kwargs))))
        return future

    def run(self) -> None:
        while self.left:
            future, job = self.left.pop()
            with while_nodes_run():
                function, args, kwargs = pickle.loads(job)
            future.set_result(pickle.loads(pickle.dumps(function(*args, **kwargs))))


class _Asked(Future[Any]):
    def __init__(self, executor: Backwards) -> None:
        super().__init__()
        self.executor = executor

    def result(self, timeout: float | None = None) -> Any:
        self.executor.run()
        return super().result(timeout)


@pytest.mark.parametrize("strategy", ["pct", "random", "all"])
def test_an_executor_finds_what_is_found_without(strategy: str, tmp_path: Path) -> None:
    for mended in (False, True):
        (planted,) = LOST.write(tmp_path, mended=mended)
        arguments: dict[str, Any] = {"schedules": 40, "strategy": strategy, "seed": 3, "deep": True}
        alone = rosspin.explore(planted, 0.5, LOST.check, **arguments)
        assert bool(alone.failure) is not mended
        backwards = rosspin.explore(planted, 0.5, LOST.check, executor=Backwards(), **arguments)
        with ProcessPoolExecutor(2, get_context("spawn")) as pool:  # tests have threads, which bear no fork
            pooled = rosspin.explore(planted, 0.5, LOST.check, executor=pool, **arguments)
        for found in (backwards, pooled):
            assert dataclasses.replace(found, orders=None) == dataclasses.replace(alone, orders=None)


def test_what_cannot_be_sent_to_an_executor_is_refused(racing: str) -> None:
    with pytest.raises(TypeError, match=r"^executor is a concurrent.futures.Executor, not 2$"):
        rosspin.explore(racing, 0.5, executor=2)  # type: ignore[arg-type]
    with ProcessPoolExecutor(1) as pool, pytest.raises(TypeError, match=r"^this cannot be sent to another process: "):
        rosspin.explore(racing, 0.5, lambda run: None, deep=True, executor=pool)
