"""Random nodes for the stand-in and for the real rclpy's own Python: see rclpy_oracle."""

from __future__ import annotations

import gc
import os
import re
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import strategies as st

from benchmarks.rclpy_oracle import on_the_oracle, real_rclpy
from rosspin import simulate

END = 6.0  # s

# What Python prints when the real Executor.__init__ has raised and __del__ misses an attribute. The stand-in raises the
# same exception and prints nothing.
_HALF_MADE = re.compile(r"Exception ignored in: <function Executor\.__del__ .*\n(?:.*\n)*?AttributeError: .*\n")

_IDS = re.compile(r"Goal ID: \[[^]]*\]")

# Lengths of time in ms: some that fall together often, some that hardly ever do.
lengths = st.one_of(st.sampled_from([100, 200, 250, 300, 500, 700, 1000]), st.integers(50, 1500))
works = st.one_of(st.just(0), st.just(0), lengths)

# What a callback does to which timer, with which number: see ``_act``.
acts = st.tuples(
    st.sampled_from(
        ["nothing"] * 4
        + ["cancel", "reset", "period", "destroy", "make", "task", "guard", "set", "result"]
        + ["ask"] * 4
        + ["call"] * 2
        + ["withdraw"]
        + ["goal"] * 3
        + ["stop"] * 2
    ),
    st.integers(0, 3),
    lengths,
)
timers = st.fixed_dictionaries(
    {
        "period": lengths,
        "group": st.integers(0, 3),
        "works": st.lists(works, min_size=1, max_size=4),
        "acts": st.lists(acts, min_size=1, max_size=4),
        "starts": st.sampled_from([True, True, True, False]),
        "awaits": st.sampled_from([False, False, False, True]),
    }
)
services = st.fixed_dictionaries(
    {
        "groups": st.tuples(st.integers(0, 3), st.integers(0, 3)),  # of the service, and of its client
        "works": st.lists(works, min_size=1, max_size=4),
        "acts": st.lists(acts, min_size=1, max_size=4),
        "awaits": st.sampled_from([False, False, False, True]),
    }
)
actions = st.fixed_dictionaries(
    {
        "groups": st.tuples(st.integers(0, 3), st.integers(0, 3)),  # of the server, and of its client
        "works": st.lists(works, min_size=1, max_size=4),
        "acts": st.lists(acts, min_size=1, max_size=4),
        "awaits": st.sampled_from([False, False, True]),
        "accepts": st.lists(st.booleans(), min_size=2, max_size=4),
        "cancels": st.lists(st.booleans(), min_size=1, max_size=4),
        "ends": st.lists(st.sampled_from(["succeed", "abort", "canceled", "raise", "nothing"]), min_size=1, max_size=4),
    }
)
specs = st.fixed_dictionaries(
    {
        "executor": st.sampled_from(["spin", "single", "multi 2", "multi 3", "multi 4", "once", "once left", "future"]),
        "groups": st.lists(st.sampled_from(["default", "exclusive", "reentrant"]), min_size=4, max_size=4),
        "timers": st.lists(timers, min_size=1, max_size=4),
        "services": st.lists(services, min_size=1, max_size=3),
        "actions": st.lists(actions, max_size=2),
        "rates": st.lists(st.tuples(lengths, st.lists(works, min_size=1, max_size=4)), max_size=2),
        "thread": st.lists(st.tuples(lengths, acts), max_size=3),
        "shutdown": st.sampled_from([False, False, True]),
    }
)


def rclpy_folder(require: Callable[[str], None]) -> Path:
    """The real rclpy's."""
    found = real_rclpy()
    if found is None:
        require("ros2")
        pytest.skip("this ROS 2 was not installed by make ros2")
    return found


def program(spec: dict[str, Any]) -> Callable[[], None]:
    """A node as a specification has it, which prints the time (ns) of all that it does."""

    def node() -> None:
        import rclpy  # type: ignore[import-not-found]
        from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse  # type: ignore[import-not-found]
        from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup  # type: ignore[import-not-found]
        from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor  # type: ignore[import-not-found]
        from rclpy.parameter import Parameter  # type: ignore[import-not-found]
        from rclpy.task import Future  # type: ignore[import-not-found]
        from test_msgs.action import Fibonacci  # type: ignore[import-not-found]
        from test_msgs.srv import BasicTypes  # type: ignore[import-not-found]

        def say(*words: object) -> None:
            sys.stdout.write(" ".join([str(time.time_ns()), *map(str, words)]) + "\n")

        def nap(ms: int) -> None:
            if ms:
                time.sleep(ms / 1000)

        def make(number: int, timer: dict[str, Any]) -> None:
            calls = 0

            def begin() -> tuple[int, Any]:
                nonlocal calls
                calls += 1
                say("timer", number, "begins", calls, node.get_parameter("value").value)
                nap(timer["works"][calls % len(timer["works"])])
                return calls, timer["acts"][calls % len(timer["acts"])]

            def callback() -> None:
                call, what = begin()
                act(*what)
                say("timer", number, "ends", call)

            async def awaits() -> None:
                call, what = begin()
                say("timer", number, "has", await futures[what[1]], call)
                act(*what)

            kind = groups[timer["group"]]
            # A loop over spin_once never waits while a coroutine does, which only takes time on a real machine.
            called = awaits if timer["awaits"] and "once" not in spec["executor"] else callback
            made.append(node.create_timer(timer["period"] / 1000, called, kind, autostart=timer["starts"]))

        def serve(number: int, service: dict[str, Any]) -> None:
            asked = 0

            def begin(request: Any) -> Any:
                nonlocal asked
                asked += 1
                say("service", number, "is asked", request.int32_value)
                nap(service["works"][asked % len(service["works"])])
                return service["acts"][asked % len(service["acts"])]

            def callback(request: Any, response: Any) -> Any:
                act(*begin(request))
                response.int32_value = request.int32_value
                return response

            async def awaits(request: Any, response: Any) -> Any:
                what = begin(request)
                response.int32_value = await futures[what[1]]
                return response

            of_service, of_client = (groups[group] for group in service["groups"])
            called = awaits if service["awaits"] and "once" not in spec["executor"] else callback
            name = f"service{number}"
            offered.append(node.create_service(BasicTypes, name, called, callback_group=of_service))
            clients.append(node.create_client(BasicTypes, name, callback_group=of_client))

        def ask(client: Any, ms: int, waits: bool) -> None:
            if len(asks) == 20:  # a service that asks itself would never end, at one time
                return
            asks.append(ms)
            request = BasicTypes.Request(int32_value=ms)
            if waits:
                response = client.call(request, timeout_sec=ms / 1000)
                say("called", response and response.int32_value)
            else:
                client.call_async(request).add_done_callback(lambda done: say("answered", done.result().int32_value))

        def offer(number: int, action: dict[str, Any]) -> None:
            counts = {"goal": 0, "cancel": 0, "execute": 0}

            def next_of(what: str, values: list[Any]) -> Any:
                counts[what] += 1
                return values[counts[what] % len(values)]

            def accept(goal: Any) -> Any:
                say("action", number, "is asked", goal.order)
                return GoalResponse.ACCEPT if next_of("goal", action["accepts"]) else GoalResponse.REJECT

            def cancel(goal: Any) -> Any:
                say("action", number, "is to cancel", goal.request.order)
                return CancelResponse.ACCEPT if next_of("cancel", action["cancels"]) else CancelResponse.REJECT

            def end(goal: Any, count: int) -> Any:
                how = action["ends"][count % len(action["ends"])]
                act(*action["acts"][count % len(action["acts"])])
                say("action", number, "ends", goal.request.order, how, goal.status)
                if how == "raise":
                    raise ValueError(how)
                if how != "nothing":
                    getattr(goal, how)()
                return Fibonacci.Result(sequence=[count])

            def begin(goal: Any) -> int:
                counts["execute"] += 1
                say("action", number, "executes", goal.request.order, counts["execute"])
                goal.publish_feedback(Fibonacci.Feedback(sequence=[counts["execute"]]))
                return counts["execute"]

            def execute(goal: Any) -> Any:
                count = begin(goal)
                nap(action["works"][count % len(action["works"])])
                return end(goal, count)

            async def awaits(goal: Any) -> Any:
                count = begin(goal)
                await futures[count % 4]
                return end(goal, count)

            of_server, of_client = (groups[group] for group in action["groups"])
            called = awaits if action["awaits"] and "once" not in spec["executor"] else execute
            more = {"goal_callback": accept, "cancel_callback": cancel, "callback_group": of_server}
            name = f"action{number}"
            servers.append(ActionServer(node, Fibonacci, name, called, **more))
            senders.append(ActionClient(node, Fibonacci, name, callback_group=of_client))

        def send(sender: Any, ms: int) -> None:
            if len(asks) == 20:
                return
            asks.append(ms)

            def told(message: Any) -> None:
                say("feedback", ms, list(message.feedback.sequence))

            def answered(done: Any) -> None:
                handle = done.result()
                say("goal", ms, handle.accepted)
                if handle.accepted:
                    goals.append(handle)
                    handle.get_result_async().add_done_callback(
                        lambda done: say("result", ms, done.result().status, list(done.result().result.sequence))
                    )

            sender.send_goal_async(Fibonacci.Goal(order=ms), told).add_done_callback(answered)

        def stop(handle: Any) -> None:
            def answered(done: Any) -> None:
                say("stopped", done.result().return_code, len(done.result().goals_canceling))

            say("stops", handle.status)
            handle.cancel_goal_async().add_done_callback(answered)

        def act(what: str, which: int, ms: int) -> None:
            timer = made[which % len(made)]
            try:
                if what in ("cancel", "reset"):
                    getattr(timer, what)()
                elif what == "period":
                    timer.timer_period_ns = ms * 1_000_000
                elif what == "destroy":
                    say("destroyed", node.destroy_timer(timer))
                elif what == "make" and len(made) < 8:
                    make(len(made), spec["timers"][which % len(spec["timers"])])
                elif what == "task" and executor is not None:
                    executor.create_task(say, "task", ms)
                elif what == "guard":
                    guard.trigger()
                elif what == "set":
                    (result,) = node.set_parameters([Parameter("value", value=ms)])
                    say("set", result.successful)
                elif what == "result":
                    futures[which].set_result(ms)
                elif what in ("ask", "call") and clients:
                    ask(clients[which % len(clients)], ms, what == "call")
                elif what == "goal" and senders:
                    send(senders[which % len(senders)], ms)
                elif what == "stop" and goals:
                    stop(goals[which % len(goals)])
                elif what == "withdraw" and offered:
                    say("withdrawn", node.destroy_service(offered[which % len(offered)]))
            except Exception as error:
                say("error", type(error).__name__)

        def from_outside() -> None:
            for ms, what in spec["thread"]:
                nap(ms)
                act(*what)

        def loop(number: int, rate: Any, lengths: list[int]) -> None:
            for count in range(20):
                nap(lengths[count % len(lengths)])
                try:
                    rate.sleep()
                except Exception as error:
                    say("rate", number, type(error).__name__)
                    return
                say("rate", number)

        def spin() -> None:
            kind, _, number = spec["executor"].partition(" ")
            if kind == "spin":
                rclpy.spin(node)
            elif kind == "future":
                say("future", rclpy.spin_until_future_complete(node, futures[0], executor, 2.5))
                rclpy.spin(node)
            elif kind == "once":
                while rclpy.ok():
                    rclpy.spin_once(node, executor=executor, timeout_sec=END - time.time() + 1 if number else 0.3)
            else:
                rclpy.spin(node, executor)

        rclpy.init()
        node = rclpy.create_node("node")
        node.declare_parameter("value", 0)
        executor: Any = None
        if spec["executor"].startswith("multi"):
            executor = MultiThreadedExecutor(int(spec["executor"][-1]))
        elif spec["executor"] in ("single", "once left"):
            executor = SingleThreadedExecutor()
        makers: dict[str, Any] = {"exclusive": MutuallyExclusiveCallbackGroup, "reentrant": ReentrantCallbackGroup}
        groups = [makers[name]() if name in makers else None for name in spec["groups"]]
        futures = [Future() for _ in range(4)]
        guard = node.create_guard_condition(lambda: say("guard"))
        made: list[Any] = []
        offered: list[Any] = []
        clients: list[Any] = []
        asks: list[int] = []
        servers: list[Any] = []
        senders: list[Any] = []
        goals: list[Any] = []
        for number, service in enumerate(spec["services"]):
            serve(number, service)
        for number, action in enumerate(spec["actions"]):
            offer(number, action)
        for number, timer in enumerate(spec["timers"]):
            make(number, timer)
        for number, (ms, lengths) in enumerate(spec["rates"]):
            rate = node.create_rate(1000 / ms)
            threading.Thread(target=loop, args=(number, rate, lengths), daemon=True).start()
        threading.Thread(target=from_outside, daemon=True).start()
        if spec["shutdown"]:
            threading.Timer(3.1234, rclpy.shutdown).start()
        try:
            spin()
        except BaseException as error:
            say("ends with", type(error).__name__)
        if not spec["executor"].startswith("multi"):  # what a pool would still do is another question
            time.sleep(1e-6)  # other threads may be due at this instant, before or after this one
        os._exit(0)

    return node


def lines(console: str, pooled: bool) -> list[list[str]]:
    """The node's lines, sorted within an instant: which of them comes first is not promised.

    Without the ids of goals, which are random, and the frames of tracebacks; and without what the threads of a pool, if
    callbacks were called by one, still did at the instant in which an exception ended the node.
    """
    said = _IDS.sub("Goal ID", console).splitlines()
    found = sorted(line.split() for line in said if not line.startswith(("rosspin: ", "  ")))
    end = next((line[0] for line in found if line[1:3] == ["ends", "with"]), "")
    return [line for line in found if line[0] != end or "ends" in line[1:2]] if pooled else found


def do_the_same(folder: Path, spec: dict[str, Any]) -> None:
    """Such a node does the same on the stand-in and on the oracle, to the nanosecond."""
    node = program(spec)
    gc.disable()  # what Python would say of a method that it collects meanwhile does not belong on the console
    try:
        ours, theirs = simulate(node, END), simulate(on_the_oracle(node, folder), END)
    finally:
        gc.enable()
    theirs_said = _HALF_MADE.sub("", theirs.console)
    pooled = spec["executor"].startswith("multi")
    assert (ours.status, lines(ours.console, pooled)) == (theirs.status, lines(theirs_said, pooled))
