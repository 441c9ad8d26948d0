"""What the executors of a run do, step by step: what is ready, who is called, what waits and why."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from pathlib import Path
from types import CodeType
from typing import Any, NamedTuple
from weakref import WeakKeyDictionary

from ..clocks.clock import NS
from ..clocks.stacks import Switched, current
from ..rclpy.callback_groups import ReentrantCallbackGroup
from ..rclpy.executors import Executor, GuardCondition, MultiThreadedExecutor
from ..rclpy.node import Node
from ..rclpy.parameter_service import ParameterService
from ..rclpy.services import Client
from ..rclpy.task import Task
from ..rclpy.timer import Rate, Timer
from .noted_steps import NotedSteps, code_of

__all__ = ["Scenes"]

_OURS = str(Path(__file__).parents[1])  # done callbacks of the stand-in's own are no steps


class _Call(NamedTuple):
    """A call that has begun: of what, by whom, in which thread and task. A task that is not executing awaits."""

    entity: Any
    executor: Executor
    thread: Switched
    task: Task


class _Asked:
    """A function that was handed to an executor, such as a done callback; ``tasks`` are those that have not begun."""

    callback_group = None
    _executor_event = False

    def __init__(self, callback: Any, code: CodeType) -> None:
        self.__name__ = getattr(callback, "__name__", type(callback).__name__)
        self.__code__ = code
        self.tasks: list[Task] = []

    @property
    def is_ready(self) -> bool:
        return any(not task.cancelled() for task in self.tasks)


class Scenes(NotedSteps):
    """The steps of a run of ROS 2, in which a step is noted whenever an executor does something or the time passes.

    Executors and nodes live no longer because they are seen.
    """

    def __init__(self, *args: Any, **more: Any) -> None:
        super().__init__(*args, **more)
        self._callbacks = WeakKeyDictionary()
        self._ready: WeakKeyDictionary[Executor, list[Any]] = WeakKeyDictionary()  # what each has found, and not called
        self._asked: dict[CodeType, _Asked] = {}
        self._asked_by: WeakKeyDictionary[Task, _Asked] = WeakKeyDictionary()
        self._calls: list[_Call] = []  # those that have not ended

    def asks(self, task: Task, callback: Any) -> None:
        here, code = self._here(), code_of(callback)
        if here is not None and code and not code.co_filename.startswith(_OURS):
            asked = self._asked_by[task] = self._asked.setdefault(code, _Asked(callback, code))
            asked.tasks.append(task)
            self._note(f"{here} hands {self._say([asked])} to the executor, which calls it in its next round.")

    def looks(self, executor: Executor) -> None:
        if self._here() is not None:
            self._ready[executor] = []

    def finds(self, executor: Executor, ready: Collection[Any]) -> None:
        if self._here() is None:
            return
        self._say(_entities(executor))  # which gives them numbers in their order
        self._ready[executor] = [entity for entity in _entities(executor) if entity in ready]
        if found := self._ready[executor]:
            whose = self._of(executor.get_nodes())
            self._note(f"The executor{whose} finds what is ready: {self._say(found)}.")

    def calls(self, entity: Any, executor: Any = None, late: int = 0) -> None:
        if (here := self._here()) is None:
            return
        how = ""
        if isinstance(entity, Task):
            if entity not in self._asked_by:
                return
            task, entity = entity, self._asked_by[entity]
            entity.tasks.remove(task)
        else:
            self._ready[executor] = [each for each in self._ready.get(executor, ()) if each is not entity]
            task = next(task for task, each, _ in executor._tasks if each is entity and task.executing())
            late = self.clock.now() - entity._rosspin_expected if isinstance(entity, Timer) else 0
            how = f", {late / NS:g} s late" if late > 0 else ""
            if isinstance(_bound_to(entity), Rate):
                how += ". That sets the event for which the loop sleeps"
        self._calls.append(_Call(entity, executor, current(), task))
        self._note(f"{here} calls {self._say([entity])}{how}.", self._begin(_callback(entity)))

    def ends(self, entity: Any) -> None:
        if self._here() is None:
            return
        entity = self._asked_by.get(entity) if isinstance(entity, Task) else entity
        if calls := [call for call in self._calls if call.entity is entity]:
            # A coroutine may end in another thread than the one in which it began.
            self._calls.remove(min(calls, key=lambda call: call.thread is not current()))
            self._note(f"{self._say([entity])} ends.")

    def wakes(self, goal: Any) -> None:
        if (here := self._here()) is not None:
            why = "the event is set" if isinstance(goal, Timer) else "what it waited for is there"
            self._note(f"{here} continues: {why}.")

    def _running(self) -> list[Any] | None:
        return (
            list(dict.fromkeys(call.entity for call in self._calls if call.task.executing())) if self._ready else None
        )

    def _note(self, said: str, line: int = 0, until: int = 0) -> None:
        """Note a step, after which nothing changes ``until`` then. ``line`` is the calling thread's, if it is known."""
        executors = {entity: executor for executor in self._ready for entity in _entities(executor)}
        self._say(executors)
        handed = [each for each in self._callbacks if each._executor_event and each in executors]
        ready = [each for found in self._ready.values() for each in found if each not in handed]
        ready += [each for each in self._callbacks if isinstance(each, _Asked) and each.is_ready]
        order = [self._callbacks[each] for each in (*handed, *ready)]
        how = [""] * len(self._names)
        for each, number in self._callbacks.items():
            how[number] = self._how(each, executors.get(each), until)
        self._steps.append([self.clock.seconds(), said, order, list(self._where(line)), how])

    def _inside(self, thread: Switched) -> Any:
        calls = (call for call in reversed(self._calls) if call.thread is thread and call.task.executing())
        return next((call.entity for call in calls), None)

    def _group(self, entity: Any) -> tuple[Any, str]:
        group = entity.callback_group
        return group, self._name_group(group)

    def _name_group(self, group: Any) -> str:
        if group is None:
            return "Handed to the executor: in no group"
        nodes = [node for executor in self._ready for node in executor.get_nodes()]
        at_once = "many at a time" if isinstance(group, ReentrantCallbackGroup) else "one at a time"
        for node in nodes:
            if group is node._rate_group:
                return f"Group of Rates{self._of([node])}: {at_once}"
            if group is node.default_callback_group:
                return f"Default group{self._of([node])}: {at_once}"
        own = sum(name.startswith("Own") for _, name in self._groups.values())
        return f"Own group {own + 1}: {at_once}"

    def _of(self, nodes: Iterable[Node]) -> str:
        """Say of what nodes something is, if that could be asked."""
        return f" of {', '.join(node.get_fully_qualified_name() for node in nodes)}" if self._several else ""

    def _name(self, entity: Any) -> str:
        if isinstance(_bound_to(entity), Rate):
            return "the Rate's timer"
        if isinstance(entity, Client):
            return f"the answer of {entity._rosspin.entry.topic}"
        callback = _callback(entity)
        return str(getattr(callback, "__name__", type(callback).__name__))

    def _how(self, entity: Any, executor: Executor | None, until: int) -> str:
        """Say how a callback is if nothing changes ``until`` then: it runs, waits and why, or when it is due."""
        if isinstance(entity, _Asked):
            executor = next((call.executor for call in self._calls if call.entity is entity), None)
        calls = [call.entity for call in self._calls if call.executor is executor and call.task.executing()]
        if isinstance(entity, _Asked) and entity not in calls:
            return "awaits" if executor else "ready" if entity.is_ready else ""
        if entity in calls or executor is None:
            return "runs" if entity in calls else ""
        if any(call.entity is entity for call in self._calls):
            return "awaits, and keeps its group"
        threads = executor._executor._max_workers if isinstance(executor, MultiThreadedExecutor) else 1
        if entity._executor_event:
            return "ready" if len(calls) < threads else "waits for a free thread"
        since = ""
        if not isinstance(entity, Timer):
            is_due = bool(entity._rosspin_triggered if isinstance(entity, GuardCondition) else entity._rosspin.messages)
        elif not (is_due := entity._rosspin_is_due()) and entity._rosspin_is_flowing():
            due = entity._rosspin_time_left() + self.clock.now()
            since, is_due = f"from {due / NS:g} s on ", due < until
            if not is_due:
                return f"due at {due / NS:g} s"
        if not is_due:
            return ""
        if threads == 1 and calls:
            return f"waits {since}for the thread, which is in {self._say(calls)}"
        if not entity.callback_group.can_execute(entity):
            taken = [call.entity for call in self._calls if call.entity.callback_group is entity.callback_group]
            return f"waits {since}for its group, which is taken by {self._say(taken)}"
        return "ready" if entity in self._ready[executor] else "waits for the next round"


def _callback(entity: Any) -> Any:
    return getattr(entity, "callback", None) or entity


def _entities(executor: Executor) -> list[Any]:
    """Return what an executor may call, in its order, but the services for parameters."""
    nodes = executor.get_nodes()
    found = [waitable for node in nodes for waitable in node._rosspin_waitables if waitable not in node._rosspin_events]
    for node in nodes:
        found += [*node._timers, *node._subscriptions, *node._guards, *node._clients]
        found += [each for each in node._services if not isinstance(_bound_to(each), ParameterService)]
    return found


def _bound_to(entity: Any) -> Any:
    """Return what the callback is a method of."""
    return getattr(getattr(entity, "callback", None), "__self__", None)
