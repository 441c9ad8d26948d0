"""Executors: who calls the callbacks, and in which order (source: rclpy/executors.py, rcl/wait.c)."""

from __future__ import annotations

import inspect
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, TypeVar

from ..clocks.frames import warn
from .context import Context, get_default_context
from .exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    InvalidHandle,
    ShutdownException,
    TimeoutException,
    invalid_context,
)
from .state import Gate
from .task import Future, Task

if TYPE_CHECKING:
    from .node import Node
    from .timer import Timer
    from .topics import Subscription

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "GuardCondition",
    "MultiThreadedExecutor",
    "ShutdownException",
    "SingleThreadedExecutor",
    "TimeoutException",
]

# What it costs (ns) to look in vain with a timeout of 0: else a loop that only looks would keep the time from going on.
_LOOK = 1_000

# So many calls at one time are free; more of them are a loop, such as one that looks whether a coroutine can go on.
# Then each costs (ns) about what it does on a real machine.
_FREE_CALLS = 1_000
_CALL = 100_000

# A MultiThreadedExecutor that is given no number has so many threads: the same everywhere. In rclpy it has as many as
# there are processors.
_THREADS = 4

Entry = tuple[Task, Any, "Node | None"]  # a task, and what of which node it runs
E = TypeVar("E", bound="Executor")


def _never() -> bool:
    return False


class GuardCondition:
    """Lets an executor call ``callback()`` once after each ``trigger``. Made by ``Node.create_guard_condition``."""

    def __init__(self, callback: Callable[[], Any] | None, callback_group: Any, context: Context | None = None) -> None:
        self.callback = callback
        self.callback_group = callback_group
        self.triggered = False
        self.nudge: Callable[[], None] | None = None
        self._executor_event = False
        self._destroyed = False
        self._executor_triggered = False  # an executor has seen it, and not called it yet

    def trigger(self) -> None:
        """Ask for a call. InvalidHandle if it was destroyed."""
        if self._destroyed:
            raise InvalidHandle()
        self.triggered = True
        if self.nudge:
            self.nudge()

    def destroy(self) -> None:
        """Destroy it."""
        self._destroyed = True

    def take(self) -> Any:
        """What is to be called."""
        self._executor_triggered = False
        return self.callback, (), None


class Executor:
    """Base of the executors, which call what is due in the nodes that were added.

    They work in rounds. A round waits until something is due, then hands out all that is: node by node the timers, then
    the subscriptions, one message each, each in the order of their creation. ``spin_once`` takes the next call of the
    round, and begins another round when it is used up, or when it is called with another timeout.
    """

    # Names that rclpy's class does not have are mangled or begin with _rosspin, here and in Node: a node's own classes
    # may have them, too.

    def __init__(self, *, context: Context | None = None) -> None:
        self._context = context or get_default_context()
        if self._context.arguments is None:
            # What rclpy says of a context that was not initialised.
            raise TypeError("'NoneType' object does not support the context manager protocol")
        if not self._context.ok():
            raise invalid_context("create guard_condition")
        self._clock = self._context.state.clock
        self._nodes: dict[Node, None] = {}  # in the order of their addition
        self._tasks: list[Entry] = []
        self._is_shutdown = False
        self.__round: Iterator[Task] | None = None
        self.__round_args: tuple[Any, ...] = ()
        self.__gate = Gate()
        self.__waits = False
        self.__triggered = False  # something has changed: wait for other things than before
        self.__waited_until = -1
        self.__calls = 0  # how many were handed out one after the other, as time did not go on by itself
        self.__called_at = 0
        self._context.state.waiting[self.__gate] = None
        self._context.on_shutdown(self.wake)

    @property
    def context(self) -> Context:
        """Its context."""
        return self._context

    def create_task(self, callback: Callable[..., Any], *args: Any, **kwargs: Any) -> Task:
        """Let it call a function or a coroutine; the newest task goes first."""
        task = Task(callback, args, kwargs, executor=self)
        self._tasks.append((task, None, None))
        self.wake()
        return task

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Hand out no more calls. It does not wait for those that run, nor does rclpy's, whatever the timeout."""
        self._is_shutdown = True
        self.wake()
        self._nodes = {}
        self.__round = None
        self._context.state.waiting.pop(self.__gate, None)
        return True

    def add_node(self, node: Node) -> bool:
        """Call what is due in a node; whether it was not there."""
        if node in self._nodes:
            return False
        self._nodes[node] = None
        node.executor = self
        self.wake()
        return True

    def remove_node(self, node: Node) -> None:
        """Call nothing of a node any more."""
        if node in self._nodes:
            del self._nodes[node]
            self.wake()

    def get_nodes(self) -> list[Node]:
        """The nodes that were added."""
        return list(self._nodes)

    def wake(self) -> None:
        """Something has changed: do not go on waiting."""
        self.__triggered = True
        if self.__waits:
            self.__gate.open()

    def _rosspin_nudge(self) -> None:
        """Something may have become due."""
        if self.__waits:
            self.__gate.open()

    # --- spinning -----------------------------------------------------------------------------------------------------

    def spin(self) -> None:
        """Call what is due until the context, or the executor, is shut down.

        Raises what a callback raises, and ExternalShutdownException if it waits when a signal shuts the context down.
        """
        while self._context.ok() and not self._is_shutdown:
            self.spin_once()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one call, for at most ``timeout_sec`` (None, or negative: for ever), and make it."""
        self._rosspin_spin_once(timeout_sec)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: Any = None) -> None:
        """Like ``spin_once``, but wait no more once the future is done."""
        future.add_done_callback(lambda _: self.wake())
        self._rosspin_spin_once(timeout_sec, future.done)

    def _rosspin_spin_once(self, timeout_sec: Any, condition: Callable[[], bool] = _never) -> None:
        raise NotImplementedError()

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Call what is due until a future is done or given up, for at most ``timeout_sec``."""
        future.add_done_callback(lambda _: self.wake())
        left = None if timeout_sec is None or timeout_sec < 0 else _Timeout(timeout_sec)
        end = 0.0 if left is None else time.monotonic() + left.seconds
        while self._context.ok() and not future.done() and not future.cancelled() and not self._is_shutdown:
            self.spin_once_until_future_complete(future, left)
            if left is not None:
                left.seconds = end - time.monotonic()
                if left.seconds <= 0:
                    return

    def wait_for_ready_callbacks(
        self, timeout_sec: Any = None, nodes: list[Node] | None = None, condition: Callable[[], bool] = _never
    ) -> Task:
        """The next call of the round. Raises TimeoutException, ShutdownException and ExternalShutdownException, and
        ConditionReachedException if ``condition()`` is true.
        """
        args = (timeout_sec, nodes, condition)
        now = self._clock.now()
        self.__calls = self.__calls + 1 if now <= self.__called_at + _CALL else 1
        self.__called_at = now
        if self.__calls > _FREE_CALLS:
            self._clock.sleep(_CALL)
        while True:
            if self.__round is None or self.__round_args != args:
                self.__round_args = args
                self.__round = self.__new_round(*args)
            try:
                return next(self.__round)
            except StopIteration:
                self.__round = None

    def __new_round(self, timeout_sec: Any, nodes: list[Node] | None, condition: Callable[[], bool]) -> Iterator[Task]:
        seconds = timeout_sec.seconds if isinstance(timeout_sec, _Timeout) else timeout_sec
        timeout = -1 if seconds is None or seconds < 0 else int(float(seconds) * 1e9)
        deadline = time.monotonic_ns() + timeout if timeout > 0 else None
        works = False
        while not works and not self._is_shutdown and not condition():
            spun = self.get_nodes() if nodes is None else nodes
            for entry in reversed(list(self._tasks)):
                task, _, node = entry
                if not task.executing() and not task.done() and (node is None or node in spun):
                    works = True
                    yield task
            for entry in list(self._tasks):
                if entry[0].done() or entry[0].cancelled():
                    self._tasks.remove(entry)

            timers, subscriptions, guards = self.__gather(spun)
            ready, is_over = self.__wait(timers, subscriptions, guards, timeout, deadline)
            if self._is_shutdown:
                raise ShutdownException()
            if not self._context.ok():
                raise ExternalShutdownException()
            # The lists are gone through as they are: a callback that was called meanwhile may have changed them.
            for node in spun:
                for timer in node._timers:
                    if timer in ready and timer.is_due() and timer.callback_group.can_execute(timer):
                        works = True
                        yield self.__task(timer, node)
                for subscription in node._subscriptions:
                    if subscription in ready and subscription.callback_group.can_execute(subscription):
                        works = True
                        yield self.__task(subscription, node)
                for guard in node._guards:
                    if guard._executor_triggered and guard.callback_group.can_execute(guard):
                        works = True
                        yield self.__task(guard, node)
            if is_over:
                if timeout == 0 and not works:
                    self._clock.sleep(_LOOK)
                raise TimeoutException()
        if self._is_shutdown:
            raise ShutdownException()
        if condition():
            raise ConditionReachedException()

    def can_execute(self, entity: Any) -> bool:
        """Whether a call may be handed out: it is not already, and its group lets it."""
        return not entity._executor_event and bool(entity.callback_group.can_execute(entity))

    def __gather(self, nodes: list[Node]) -> tuple[list[Timer], list[Subscription], list[GuardCondition]]:
        """What to wait for."""
        can_execute = self.can_execute
        timers = [timer for node in nodes for timer in node._timers if can_execute(timer)]
        subscriptions = [each for node in nodes for each in node._subscriptions if can_execute(each)]
        guards = [guard for node in nodes for guard in node._guards if can_execute(guard)]
        for guard in guards:
            guard.triggered = guard.triggered or guard._executor_triggered
        return timers, subscriptions, guards

    def __wait(
        self,
        timers: list[Timer],
        subscriptions: list[Subscription],
        guards: list[GuardCondition],
        timeout: int,
        deadline: int | None,
    ) -> tuple[set[Any], bool]:
        """Wait until something is due, or has changed; what is due, and whether the timeout (ns) is over."""
        if not self._context.ok():
            raise invalid_context("initialize wait set" if deadline is None else "create timer")
        if self._clock.now() != self.__waited_until:
            self._clock.sleep(0)  # a message that another thread sends at this time has arrived
        watched = [timer.clock.watchers for timer in timers if not timer.clock.flows]
        for watchers in watched:
            watchers.append(self.__gate)
        self.__waits = True
        is_last = False
        try:
            while True:
                ready: set[Any] = {timer for timer in timers if timer.is_due()}
                ready.update(subscription for subscription in subscriptions if subscription.messages)
                triggered = [guard for guard in guards if guard.triggered]
                is_over = deadline is not None and time.monotonic_ns() >= deadline
                if self.__triggered:
                    self.__triggered, is_last = False, True
                if ready or triggered or is_over or is_last or timeout == 0:
                    break
                if self._is_shutdown or not self._context.ok():
                    break
                left = [timer.time_left() for timer in timers if timer.is_flowing()]
                if deadline is not None:
                    left.append(deadline - time.monotonic_ns())
                is_last = not self.__gate.wait(min(left, default=None))
        finally:
            self.__waits = False
            for watchers in watched:
                watchers.remove(self.__gate)
        for guard in triggered:
            guard.triggered, guard._executor_triggered = False, True
        self.__waited_until = self._clock.now()
        return ready, is_over or timeout == 0

    def __task(self, entity: Any, node: Node) -> Task:
        """The task of calling what is due; until it is taken, it is not handed out once more."""
        entity._executor_event = True
        task = Task(_call, (entity, self), executor=self)
        self._tasks.append((task, entity, node))
        return task

    def __enter__(self: E) -> E:
        return self

    def __exit__(self, *error: object) -> None:
        self.shutdown()


async def _call(entity: Any, executor: Executor) -> None:
    group = entity.callback_group
    if not group.beginning_execution(entity):
        entity._executor_event = False
        executor.wake()
        return
    try:
        call = entity.take()
        entity._executor_event = False
        executor.wake()
        if call is not None:
            callback, args, tick = call
            if inspect.iscoroutinefunction(callback):
                await callback(*args)
            else:
                callback(*args)
            if tick is not None:
                entity.end(tick)
    finally:
        group.ending_execution(entity)
        executor.wake()


class _Timeout:
    """A timeout that gets shorter while the same round goes on."""

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds


class SingleThreadedExecutor(Executor):
    """Calls in the thread that spins. While a callback runs, all others wait."""

    def _rosspin_spin_once(self, timeout_sec: Any, condition: Callable[[], bool] = _never) -> None:
        try:
            task = self.wait_for_ready_callbacks(timeout_sec, None, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        task()
        task.result()


class MultiThreadedExecutor(Executor):
    """Calls in ``num_threads`` threads (default: 4), as the callback groups allow.

    What a callback raises is noticed when the next call is handed out.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        if num_threads == 1:
            warn("MultiThreadedExecutor is used with a single thread.\nUse the SingleThreadedExecutor instead.")
        self._futures: list[Task] = []
        self._executor = ThreadPoolExecutor(num_threads or _THREADS)

    def _rosspin_spin_once(self, timeout_sec: Any, condition: Callable[[], bool] = _never) -> None:
        try:
            task = self.wait_for_ready_callbacks(timeout_sec, None, condition)
        except (ExternalShutdownException, ShutdownException, TimeoutException, ConditionReachedException):
            return
        self._executor.submit(task)
        self._futures.append(task)
        for running in list(self._futures):
            if running.done():
                self._futures.remove(running)
                running.result()
