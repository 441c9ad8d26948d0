"""Why something waits without end: who would give it what it waits for, and what keeps that one from it.

A callback, or a thread, waits for a future or a Rate. An executor ends that wait by calling another entity: a service
that has the request, a client that has the answer, the Rate's timer. Another callback may hold that call up, because it
holds the entity's callback group or the executor's thread. If that callback waits, too, perhaps for a lock, the search
continues from there, until it comes round, or to something that no one does.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from ..clocks.frames import Place, node_place, places
from ..world.world import keeper, thread_name
from .action import ActionClient, ActionServer
from .discovery import Participants
from .executors import MultiThreadedExecutor
from .services import ClientEndpoint, ServerEndpoint, Service
from .task import Future, Task
from .timer import Timer
from .topics import Subscription
from .waits import Wait, Waits

if TYPE_CHECKING:
    from ..world.graph import Graph
    from ..world.watcher import Watcher
    from .executors import Executor
    from .node import Node

__all__ = ["explain"]

_DONE = "ask with call_async, or send_goal_async, and continue in a done callback"
_OWN = "put the callback that waits into a callback group of its own"
_THREAD = f"{_DONE.capitalize()}. Or spin with a MultiThreadedExecutor, and {_OWN}."
_GROUP = f"{_OWN.capitalize()}, or {_DONE}."
_MORE = f"Give the executor more threads, or {_DONE}."
_GROUP_OF_AWAIT = "An async callback keeps its group while it awaits: put that callback into a group of its own."
_RING = "No executor or group helps here: one of these callbacks has to answer without asking."
_HOLDING = "Hold no lock while you wait for what needs it."
_SPIN = "Spin the node meanwhile: with rclpy.spin_until_future_complete, or in another thread."
_KEEP = "Keep the node in a variable as long as it is needed."
_SERVE = "Start the node that offers it, and wait for that with a time limit before you ask."
_RATE = "Do the work of the loop in a timer, or run the loop in a thread of its own, next to the one that spins."

# What the services of an action give.
_OF_ACTIONS = {
    "send_goal": "the answer to a goal of {}",
    "get_result": "the result of a goal of {}",
    "cancel_goal": "the answer to a request to cancel a goal of {}",
}


class _Waiter(NamedTuple):
    """What waits: a callback in a task of an executor, or else a thread. If for a lock, its stack is the goal."""

    goal: Any
    task: Task | None
    name: str
    place: Place | None
    is_async: bool = False


class _Step(NamedTuple):
    """A step on the way: the lines that say it, the waiter that comes next (none: a dead end), what to change."""

    lines: list[str]
    next: _Waiter | None
    advice: str


def explain(graph: Graph, watcher: Watcher | None = None) -> str:
    """Say which callbacks and threads of a run wait without end, as lines; nothing if all may continue.

    ``watcher`` is told of each way that is followed, for a picture of it.
    """
    run = _Run(graph)
    lines: list[str] = []
    shown: set[int] = set()
    for waiter in run.waiters:
        if id(waiter.goal) in shown:
            continue
        steps = run.way(waiter)
        if steps:
            shown.update(id(step.next.goal) for step in steps if step.next)
            lines += ["deadlock. This can never continue:", *(f"  {line}" for step in steps for line in step.lines)]
            advice = [step.advice for step in steps if step.advice]
            lines.append(_HOLDING if _HOLDING in advice else (advice or [_RING])[0])
            if watcher:
                watcher.rings(_links(waiter, steps))
        shown.add(id(waiter.goal))
    return "".join(f"rosspin: {line}\n" for line in lines)


def _links(first: _Waiter, steps: list[_Step]) -> dict[str, Any]:
    """A way as a picture shows it: who waits, and for what. ``to`` is the number of the one that the last waits for."""
    waiters = [first, *(step.next for step in steps if step.next)]
    goals = [id(waiter.goal) for waiter in waiters]
    said = []
    for waiter, step in zip(waiters, steps):
        waits, *reasons = [line for line in step.lines if not line.startswith("  ")]
        said.append([waiter.name, "; ".join([waits.removeprefix(waiter.name).strip(), *reasons]).rstrip(":")])
    return {"links": said, "to": goals.index(goals[-1]) if steps[-1].next else -1}


class _Run:
    """The nodes of a run, at an instant at which nothing happens in them."""

    def __init__(self, graph: Graph) -> None:
        self._nodes = [node for each in graph.part(Participants).all_nodes() if (node := each.node())]
        executors = {id(executor): executor for node in self._nodes if (executor := node.executor) is not None}
        self._tasks: dict[Task, tuple[Any, Executor]] = {
            task: (entity, executor) for executor in executors.values() for task, entity, _ in executor._tasks
        }
        self._waits = graph.part(Waits).current
        self.waiters = [self._in_thread(wait) for wait in self._waits]
        self.waiters += [found for task in self._tasks if (found := self._in_coroutine(task))]

    def _in_thread(self, wait: Wait) -> _Waiter:
        task, stack = wait.where()
        name = self._name(task) if task else f"the thread {wait.thread}"
        return _Waiter(wait.goal, task, name, node_place(stack))

    def _in_coroutine(self, task: Task) -> _Waiter | None:
        inner: Any = None if task.executing() else task._rosspin_coroutine
        place = None
        while inner is not None:
            frame = getattr(inner, "cr_frame", None) or getattr(inner, "gi_frame", None)
            if frame is None:
                break
            if frame.f_code is Future.__await__.__code__:
                return _Waiter(frame.f_locals["self"], task, self._name(task), place, is_async=True)
            place = node_place(places([(frame.f_code, frame.f_lasti, frame.f_lineno)])) or place
            inner = getattr(inner, "cr_await", None)
        return None

    def _on(self, stack: Any) -> _Waiter | None:
        """What waits on a stack: for a lock, or what :mod:`rosspin.rclpy.waits` knows of."""
        if keeper(stack):
            task = next((task for task in self._tasks if task.executing() and task._rosspin_stack is stack), None)
            name = self._name(task) if task else thread_name(stack)
            return _Waiter(stack, task, name, node_place(places(stack.trail)))
        return next((self._in_thread(wait) for wait in reversed(self._waits) if wait.stack is stack), None)

    def way(self, waiter: _Waiter) -> list[_Step]:
        """Follow what a waiter waits for; no steps if it may still continue."""
        steps: list[_Step] = []
        passed: list[Any] = []
        following: _Waiter | None = waiter
        while following and following.goal not in passed:
            passed.append(following.goal)
            step = self._step(following)
            if step is None:
                return []
            steps.append(step)
            following = step.next
        return steps

    def _step(self, waiter: _Waiter) -> _Step | None:
        at = [f"  at {waiter.place.shown()}"] if waiter.place else []
        if kept := keeper(waiter.goal):
            return self._blocked(waiter, at, *kept)
        if isinstance(waiter.goal, Timer):
            return self._kept([f"{waiter.name} waits for its Rate", *at, "its timer is due"], waiter.goal, waiter, "it")
        for client, number, entity in self._asked(waiter.goal):
            begin = [f"{waiter.name} waits for {_what(client)}", *at]
            if any(sequence == number and answer is not None for sequence, answer in client.messages):
                return self._kept([*begin, "the answer has come"], entity, waiter, "the client")
            if not client.peers:
                return _Step([*begin, "no node offers that, as far as it knows"], None, _SERVE)
            for service in (peer for peer in client.peers if isinstance(peer, ServerEndpoint)):  # not a test's
                serving = service.entity()
                if any((header.client, header.sequence) == (client, number) for _, header in service.messages):
                    what = "the service" if isinstance(serving, Service) else "the action server"
                    return self._kept([*begin, "the request has come"], serving, waiter, what)
                for task, (other, _) in self._tasks.items():
                    if other is serving or self._executes(task, serving, client, number):
                        return self._after([*begin, f"that has to come from {self._name(task)}"], task, "")
        return None

    def _blocked(self, waiter: _Waiter, at: list[str], holder: object, is_end: bool) -> _Step | None:
        """Say who has the lock, or has not ended; None if that one may continue."""
        if (following := self._on(holder)) is None:
            return None
        what, advice = ("the end of {}", "") if is_end else ("a lock that {} holds", _HOLDING)
        return _Step([f"{waiter.name} waits for {what.format(following.name)}", *at], following, advice)

    def _asked(self, goal: Any) -> Iterator[tuple[ClientEndpoint, int, Any]]:
        """Find who asked for a future: the client, the number of its request, and the entity that takes the answer."""
        for node in self._nodes:
            for client in node._clients:
                yield from (
                    (client._rosspin, number, client)
                    for number, each in client._pending_requests.items()
                    if each is goal
                )
            for waitable in node._rosspin_waitables:
                if isinstance(waitable, ActionClient):
                    pending = waitable._rosspin_pending.items()
                    yield from ((client, number, waitable) for (client, number), (each, _) in pending if each is goal)

    def _kept(self, lines: list[str], entity: Any, waiter: _Waiter, what: str) -> _Step | None:
        """Say what keeps an entity, called ``what``, from being called; None if nothing does."""
        node = next((node for node in self._nodes if entity in (*node._timers, *_receivers(node))), None)
        if node is None:
            line = f"{lines[-1]}, but its node is gone: nothing refers to it any more"
            return _Step([*lines[:-1], line], None, _KEEP)
        executor: Any = node.executor
        threads = executor._executor._max_workers if isinstance(executor, MultiThreadedExecutor) else 1
        advice = _RATE if isinstance(entity, Timer) else _THREAD if threads == 1 else _GROUP
        if not entity.callback_group.can_execute(entity):
            for task, (other, _) in self._tasks.items():
                has_begun = task.executing() or task._rosspin_coroutine is not None
                if other is not None and other.callback_group is entity.callback_group and has_begun:
                    if any(each.task is task and each.is_async for each in self.waiters):
                        advice = _GROUP_OF_AWAIT
                    elif other is entity:
                        advice = _RING
                    line = f"{lines[-1]}, but the callback group of {what} lets one callback run at a time:"
                    return self._after([*lines[:-1], line, f"  {self._name(task)}"], task, advice)
        running = [task for task, (_, its) in self._tasks.items() if its is executor and task.executing()]
        if running and len(running) >= threads:
            whose = "the only thread" if threads == 1 else f"each of the {threads} threads"
            line = f"{lines[-1]}, but {whose} of the executor is in a callback:"
            advice = _MORE if threads > 1 else advice
            return self._after([*lines[:-1], line, f"  {self._name(running[0])}"], running[0], advice)
        if executor is None or not executor._rosspin_waits:
            line = f"{lines[-1]}, but no thread spins {node.get_fully_qualified_name()}"
            return _Step([*lines[:-1], line], None, _SPIN)
        return None

    def _after(self, lines: list[str], task: Task, advice: str) -> _Step | None:
        """Continue with what a task waits for; None if it waits for nothing."""
        following = next((each for each in self.waiters if each.task is task), None) or self._on(task._rosspin_stack)
        return following and _Step(lines, following, advice)

    @staticmethod
    def _executes(task: Task, server: Any, client: ClientEndpoint, number: int) -> bool:
        """Whether a task executes the goal whose result a client has asked for."""
        if not (isinstance(server, ActionServer) and getattr(task._handler, "__self__", None) is server):
            return False
        node = client.node.node()
        goals = (
            goal_id
            for waitable in (node._rosspin_waitables if node else ())
            if isinstance(waitable, ActionClient) and client is waitable._rosspin_results
            for (_, each), (_, goal_id) in waitable._rosspin_pending.items()
            if each == number
        )
        _, handle = task._rosspin_arguments[0]
        return any(bytes(goal.uuid) == bytes(handle.goal_id.uuid) for goal in goals)

    def _name(self, task: Task) -> str:
        entity, _ = self._tasks.get(task, (None, None))
        if isinstance(entity, Timer):
            return f"the timer's callback {_function(entity.callback)}"
        if isinstance(entity, Subscription):
            return f"the callback of {entity._rosspin.entry.topic} ({_function(entity.callback)})"
        if isinstance(entity, Service):
            return f"the callback of the service {entity._rosspin.entry.topic} ({_function(entity.callback)})"
        if isinstance(entity, (ActionServer, ActionClient)):
            return f"the callback of the action {entity._rosspin_name}"
        handler, (args, _) = task._handler, task._rosspin_arguments
        if isinstance(getattr(handler, "__self__", None), ActionServer):
            return f"the execution of a goal ({_function(args[0])})"
        return f"the task {_function(handler)}"


def _receivers(node: Node) -> list[Any]:
    return [*node._clients, *node._services, *node._rosspin_waitables]


def _what(client: ClientEndpoint) -> str:
    action, _, part = client.entry.topic.partition("/_action/")
    return _OF_ACTIONS[part].format(action) if part else f"the answer of {client.entry.topic}"


def _function(callback: Any) -> str:
    name = getattr(callback, "__qualname__", "") or type(callback).__name__
    return str(name).rpartition("<locals>.")[2]
