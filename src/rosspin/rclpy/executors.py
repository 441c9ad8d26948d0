"""Executors: who calls the callbacks, and in which order (source: rclpy/executors.py, rcl/wait.c)."""

from __future__ import annotations

import inspect
import time
from collections.abc import Callable, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import chain
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

from ..clocks.frames import warn
from .context import Context, get_default_context
from .event import Event
from .exceptions import (
    ConditionReachedException,
    ExternalShutdownException,
    InvalidHandle,
    ShutdownException,
    TimeoutException,
    invalid_context,
)
from .handle import Held
from .task import Future, Task, await_or_execute, is_coroutine_function
from .topics import Subscription
from .waits import waiting_for

if TYPE_CHECKING:
    from .node import Node
    from .services import Client, Service
    from .timer import Timer

__all__ = [
    "ConditionReachedException",
    "Executor",
    "ExternalShutdownException",
    "GuardCondition",
    "MultiThreadedExecutor",
    "ShutdownException",
    "SingleThreadedExecutor",
    "TimeoutException",
    "await_or_execute",
]

# How long (ns) a look in vain with a timeout of 0 takes. Without it, a loop that only looks would stop the time.
_LOOK = 1_000

# So many calls at one time take no time. More are a loop, such as one that waits for a coroutine to continue: each then
# takes about as long (ns) as on a real machine.
_FREE_CALLS = 1_000
_CALL = 100_000

# The threads of a MultiThreadedExecutor that is given no number. In rclpy it has as many as there are processors; here
# the number is the same on every machine.
_THREADS = 4

Receiver: TypeAlias = "Subscription | Client | Service"
Entry = tuple[Task, Any, "Node | None"]  # a task, the timer (or other entity) that it calls, and its node
E = TypeVar("E", bound="Executor")


def _never() -> bool:
    return False


class GuardCondition(Held):
    """Lets an executor call ``callback()`` once after each ``trigger``. Made by ``Node.create_guard_condition``."""

    def __init__(self, callback: Callable[[], Any] | None, callback_group: Any, context: Context | None = None) -> None:
        self._context = context or get_default_context()
        self.callback = callback
        self.callback_group = callback_group
        self._rosspin_triggered = False
        self._rosspin_nudge: Callable[[], None] | None = None
        self._executor_event = False
        self._executor_triggered = False  # an executor has seen the trigger, and not called yet

    def trigger(self) -> None:
        """Ask for a call. Raises InvalidHandle if it was destroyed."""
        self._rosspin_check()
        self._rosspin_triggered = True
        if self._rosspin_nudge:
            self._rosspin_nudge()

    def destroy(self) -> None:
        """Destroy it."""
        self._rosspin_destroyed = True

    def _rosspin_take(self) -> Any:
        """What should be called."""
        self._executor_triggered = False
        return self.callback, (), None


class Executor:
    """Base of the executors, which call what is due in the nodes that were added.

    They work in rounds. A round waits until something is due, then hands out all that is due: first the events of
    topics and the actions, then, node by node, the timers, the subscriptions with one message each, the guard
    conditions, the clients with one answer each and the services with one request each, in the order of their creation.
    ``spin_once`` takes the next call of the round. It begins another round when this one is used up, or when it is
    called with another timeout.
    """

    # Here and in Node, names that rclpy's class does not have begin with _rosspin, so that they do not clash with
    # names of a node's own classes.

    def __init__(self, *, context: Context | None = None) -> None:
        self._context = context or get_default_context()
        with self._context.handle:  # type: ignore[union-attr]  # None before init: TypeError, as in rclpy
            pass
        if not self._context.ok():
            raise invalid_context("create guard_condition")
        self._clock = self._context._rosspin.state.clock
        self._rosspin_watcher = self._context._rosspin.state.world.recording.watcher
        faults = self._context._rosspin.state.world.graph.faults
        self._rosspin_slow = faults.call if faults and faults.slows else None
        self._nodes: dict[Node, None] = {}  # in the order of their addition
        self._tasks: list[Entry] = []
        self._is_shutdown = False
        self._rosspin_round: Iterator[Entry] | None = None
        self._rosspin_round_args: tuple[Any, ...] = ()
        self._rosspin_event = Event()
        self._rosspin_waits = False
        self._rosspin_is_triggered = False  # something has changed: look again at what to wait for
        self._rosspin_waited_until = -1
        self._rosspin_deadline: int | None = None  # until when a thread waits in it, at most
        self._rosspin_calls = 0  # calls handed out since the time last passed by itself
        self._rosspin_called_at = 0
        self._context._rosspin.state.executors.add(self)
        self._context._rosspin.state.waiting[self._rosspin_event] = None
        self._context.on_shutdown(self.wake)

    @property
    def context(self) -> Context:
        """Its context."""
        return self._context

    def create_task(self, callback: Callable[..., Any] | Coroutine[Any, Any, Any], *args: Any, **kwargs: Any) -> Task:
        """Let the executor call a function or a coroutine. The newest task goes first."""
        if inspect.iscoroutinefunction(callback):
            callback(*args, **kwargs).close()  # raises TypeError for arguments that it does not take
        task = Task(callback, args, kwargs, executor=self)
        self._tasks.append((task, None, None))
        self._rosspin_check()
        if self._rosspin_watcher:
            task._rosspin_watcher = self._rosspin_watcher
            self._rosspin_watcher.asks(task, callback)
        self.wake()
        return task

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Hand out no more calls. As in rclpy, it does not wait for running ones, whatever the timeout."""
        self._is_shutdown = True
        self.wake()
        self._nodes = {}
        self._rosspin_round = None
        self._context._rosspin.state.waiting.pop(self._rosspin_event, None)
        return True

    def add_node(self, node: Node) -> bool:
        """Call what is due in a node from now on. Return whether the node is new here."""
        if node in self._nodes:
            return False
        self._nodes[node] = None
        node.executor = self
        self._rosspin_check()
        self.wake()
        return True

    def _rosspin_check(self) -> None:
        if self._is_shutdown:
            # What rclpy says, whose guard condition is gone. What was asked for is noted before.
            raise AttributeError("'NoneType' object has no attribute 'trigger'")

    def remove_node(self, node: Node) -> None:
        """Call nothing in a node any more."""
        if node in self._nodes:
            del self._nodes[node]
            self._rosspin_check()
            self.wake()

    def get_nodes(self) -> list[Node]:
        """The nodes that were added."""
        return list(self._nodes)

    def wake(self) -> None:
        """Stop waiting: something has changed."""
        self._rosspin_is_triggered = True
        if self._rosspin_waits:
            self._rosspin_event.set()

    def _rosspin_nudge(self) -> None:
        """Look again: something may have become due."""
        if self._rosspin_waits:
            self._rosspin_event.set()

    def _rosspin_wakes_within(self, ns: int) -> bool:
        """Whether a thread that waits in it is about to continue, or will within a time, as far as is known."""
        if not self._rosspin_waits or not self._context.ok():
            return False
        nodes = list(self._nodes)
        receivers = [each for node in nodes for each in (*node._subscriptions, *node._clients, *node._services)]
        timers = [timer for node in nodes for timer in node._timers if timer._rosspin_is_flowing()]
        return (
            self._rosspin_is_triggered
            or any(each._rosspin.messages for each in receivers)
            or any(timer._rosspin_time_left() <= ns for timer in timers)
            or (self._rosspin_deadline is not None and self._rosspin_deadline - time.monotonic_ns() <= ns)
        )

    # --- spinning -----------------------------------------------------------------------------------------------------

    def spin(self) -> None:
        """Call what is due until the context, or the executor, is shut down.

        Raises what a callback raises, and ExternalShutdownException if a signal shuts the context down while it waits.
        """
        while self._context.ok() and not self._is_shutdown:
            self.spin_once()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one call, for at most ``timeout_sec`` (None, or negative: no limit), and make it."""
        self._rosspin_spin_once(timeout_sec)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: Any = None) -> None:
        """Like ``spin_once``, but wait no more once the future is done."""
        future.add_done_callback(lambda _: self.wake())
        self._rosspin_spin_once(timeout_sec, future.done)

    def _rosspin_spin_once(self, timeout_sec: Any, condition: Callable[[], bool] = _never) -> None:
        raise NotImplementedError()

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Call what is due until a future is done or cancelled, for at most ``timeout_sec``."""
        future.add_done_callback(lambda _: self.wake())
        if timeout_sec is None or timeout_sec < 0:
            with waiting_for(future, self._context._rosspin.state.world):
                while self._context.ok() and not future.done() and not future.cancelled() and not self._is_shutdown:
                    self.spin_once_until_future_complete(future)
            return
        left = _Timeout(timeout_sec)
        end = time.monotonic() + left.seconds
        while self._context.ok() and not future.done() and not future.cancelled() and not self._is_shutdown:
            self.spin_once_until_future_complete(future, left)
            left.seconds = end - time.monotonic()
            if left.seconds <= 0:
                return

    def wait_for_ready_callbacks(
        self, timeout_sec: Any = None, nodes: list[Node] | None = None, condition: Callable[[], bool] = _never
    ) -> Entry:
        """Return the next call of the round: a task, what it calls (None: a task that was asked for), and its node.

        Raises TimeoutException, ShutdownException, ExternalShutdownException, and ConditionReachedException if
        ``condition()`` is true.
        """
        args = (timeout_sec, nodes, condition)
        now = self._clock.now()
        self._rosspin_calls = self._rosspin_calls + 1 if now <= self._rosspin_called_at + _CALL else 1
        self._rosspin_called_at = now
        if self._rosspin_calls > _FREE_CALLS:
            self._clock.sleep(_CALL)
        while True:
            if self._rosspin_round is None or self._rosspin_round_args != args:
                self._rosspin_round_args = args
                self._rosspin_round = self._wait_for_ready_callbacks(*args)
            try:
                return next(self._rosspin_round)
            except StopIteration:
                self._rosspin_round = None

    def _wait_for_ready_callbacks(
        self, timeout_sec: Any = None, nodes: list[Node] | None = None, condition: Callable[[], bool] = _never
    ) -> Iterator[Entry]:
        seconds = timeout_sec.seconds if isinstance(timeout_sec, _Timeout) else timeout_sec
        timeout = -1 if seconds is None or seconds < 0 else int(float(seconds) * 1e9)
        deadline = time.monotonic_ns() + timeout if timeout > 0 else None
        if deadline is not None and not self._context.ok():
            raise invalid_context("create timer")
        self._context._rosspin.state.world.waiting = -1
        works = False
        while not works and not self._is_shutdown and not condition():
            triggered, self._rosspin_is_triggered = self._rosspin_is_triggered, False
            spun = self.get_nodes() if nodes is None else nodes
            for entry in reversed(list(self._tasks)):
                task, _, node = entry
                if not task.executing() and not task.done() and (node is None or node in spun):
                    works = True
                    yield entry
            for entry in list(self._tasks):
                if entry[0].done() or entry[0].cancelled():
                    self._tasks.remove(entry)
            # What has changed before is seen now. Only for tasks, and where another thread may go first, look twice.
            if triggered and (works or self._tasks or self._clock.now() != self._rosspin_waited_until):
                self._rosspin_is_triggered = True

            timers, receivers, guards = self._rosspin_gather(spun)
            ready, is_over = self._rosspin_wait(timers, receivers, guards, timeout, deadline)
            if self._is_shutdown:
                raise ShutdownException()
            if not self._context.ok():
                raise ExternalShutdownException()
            # These lists are not copied: a callback called meanwhile may change them.
            for node in spun:
                for waitable in node._rosspin_waitables:
                    if waitable in ready and waitable.callback_group.can_execute(waitable):
                        works = True
                        yield self._rosspin_make_task(waitable, node)
            for node in spun:
                for timer in node._timers:
                    if timer in ready and timer._rosspin_is_due() and timer.callback_group.can_execute(timer):
                        works = True
                        yield self._rosspin_make_task(timer, node)
                for subscription in node._subscriptions:
                    if subscription in ready and subscription.callback_group.can_execute(subscription):
                        works = True
                        yield self._rosspin_make_task(subscription, node)
                for guard in node._guards:
                    if guard._executor_triggered and guard.callback_group.can_execute(guard):
                        works = True
                        yield self._rosspin_make_task(guard, node)
                if node._clients or node._services:
                    for end in chain(node._clients, node._services):
                        if end in ready and end.callback_group.can_execute(end):
                            works = True
                            yield self._rosspin_make_task(end, node)
            if is_over:
                if timeout == 0 and not works:
                    self._clock.sleep(_LOOK)
                raise TimeoutException()
        if self._is_shutdown:
            raise ShutdownException()
        if condition():
            raise ConditionReachedException()

    def can_execute(self, entity: Any) -> bool:
        """Whether a call may be handed out: it has not been already, and its group allows it."""
        return not entity._executor_event and bool(entity.callback_group.can_execute(entity))

    def _rosspin_gather(self, nodes: list[Node]) -> tuple[list[Timer], list[Receiver], list[GuardCondition]]:
        """Collect what to wait for."""
        for node in nodes:
            for name in node._rosspin_replaced:
                iter(getattr(node, name))
        can_execute = self.can_execute
        receivers: list[Any] = [each for node in nodes for each in node._subscriptions if can_execute(each)]
        timers = [timer for node in nodes for timer in node._timers if can_execute(timer)]
        for node in nodes:
            if node._clients or node._services or node._rosspin_waitables:  # most have none
                receivers += filter(can_execute, (*node._clients, *node._services, *node._rosspin_waitables))
        guards = [guard for node in nodes for guard in node._guards if can_execute(guard)]
        for guard in guards:
            guard._rosspin_triggered = guard._rosspin_triggered or guard._executor_triggered
        return timers, receivers, guards

    def _rosspin_wait(
        self,
        timers: list[Timer],
        receivers: list[Receiver],
        guards: list[GuardCondition],
        timeout: int,
        deadline: int | None,
    ) -> tuple[set[Any], bool]:
        """Wait until something is due or has changed. Return what is due, and whether the timeout (ns) is over."""
        if not self._context.ok():
            raise invalid_context("initialize wait set")
        if self._clock.now() != self._rosspin_waited_until:
            self._clock.sleep(0)  # a message that another thread sends at this time has arrived
        watched = [timer.clock._rosspin_watchers for timer in timers if not timer.clock._rosspin_flows]
        for watchers in watched:
            watchers.append(self._rosspin_event)
        self._rosspin_waits, self._rosspin_deadline = True, deadline
        if self._rosspin_watcher:
            self._rosspin_watcher.looks(self)
        is_last = False
        try:
            while True:
                ready: set[Any] = {timer for timer in timers if timer._rosspin_is_due()}
                ready.update([receiver for receiver in receivers if receiver._rosspin.messages])
                triggered = [guard for guard in guards if guard._rosspin_triggered]
                is_over = deadline is not None and time.monotonic_ns() >= deadline
                if self._rosspin_is_triggered:
                    self._rosspin_is_triggered, is_last = False, True
                if ready or triggered or is_over or is_last or timeout == 0:
                    break
                if self._is_shutdown or not self._context.ok():
                    break
                left = [timer._rosspin_time_left() for timer in timers if timer._rosspin_is_flowing()]
                if deadline is not None:
                    left.append(deadline - time.monotonic_ns())
                is_last = not self._rosspin_event.wait(min(left, default=None))
        finally:
            self._rosspin_waits = False
            for watchers in watched:
                watchers.remove(self._rosspin_event)
        if len(ready) > 1 and self._clock.explores:
            ready -= self._rosspin_not_yet(ready, timers, receivers)
        for guard in triggered:
            guard._rosspin_triggered, guard._executor_triggered = False, True
        if self._rosspin_watcher:
            self._rosspin_watcher.finds(self, {*ready, *triggered})
        self._rosspin_waited_until = self._clock.now()
        return ready, is_over or timeout == 0

    def _rosspin_not_yet(self, ready: set[Any], timers: list[Timer], receivers: list[Receiver]) -> set[Any]:
        """Choose what of all that is due now is not due yet when a real executor looks.

        It looks a little before, or after, a message comes or a timer is due at the same time. What was due before is
        there, and of two timers the one that was made first: the wait set is gone through in this order in any case.
        """
        now = self._clock.now()
        late: set[Any] = {
            timer
            for timer in timers
            if timer in ready and timer._rosspin_time_left() == 0 and timer.clock._rosspin_flows
        }
        fresh = [
            each
            for each in receivers
            if each in ready and isinstance(each, Subscription) and each._rosspin.came_at(now)
        ]
        options: list[tuple[str, set[Any]]] = [("all that is due", set())]
        if late and len(ready) > len(late):
            options.append(("no timer yet", late))
        if len(ready) - len(late) > 1:
            options += [(f"{each.topic_name} first", late | {*fresh} - {each}) for each in fresh]
        if (len(late) > 1 or (late and fresh)) and len(self._nodes) == 1:
            first = next(timer for timer in timers if timer in late)
            options.append(("one timer first", (late | {*fresh}) - {first}))
        return options[self._clock.choose([said for said, _ in options])][1] if len(options) > 1 else set()

    def _rosspin_make_task(self, entity: Any, node: Node) -> Entry:
        """Make a task that calls what is due. Nothing else is handed out for the entity until the task begins."""
        entity._executor_event = True
        task = Task(_call, (entity, self, node), executor=self)
        entry = task, entity, node
        self._tasks.append(entry)
        return entry

    def __enter__(self: E) -> E:
        return self

    def __exit__(self, *error: object) -> None:
        self.shutdown()


async def _call(entity: Any, executor: Executor, node: Node) -> None:
    group = entity.callback_group
    if not group.beginning_execution(entity):
        entity._executor_event = False
        executor.wake()
        return
    try:
        call = entity._rosspin_take()
        entity._executor_event = False
        if executor._is_shutdown:
            raise InvalidHandle()  # as of the guard condition, which is gone
        executor.wake()
        if call is not None:
            callback, args, tick = call
            if executor._rosspin_watcher:
                executor._rosspin_watcher.calls(entity, executor)
            if executor._rosspin_slow:
                executor._rosspin_slow(node._rosspin.full_name, getattr(entity, "callback", callback))
            if is_coroutine_function(callback):
                await callback(*args)
            else:
                callback(*args)
            if tick is not None:
                entity._rosspin_end(tick)
    finally:
        group.ending_execution(entity)
        if executor._rosspin_watcher:
            executor._rosspin_watcher.ends(entity)
        executor.wake()


class _Timeout:
    """A timeout that can get shorter within one round."""

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds


class SingleThreadedExecutor(Executor):
    """Calls in the thread that spins. While a callback runs, all others wait."""

    def _rosspin_spin_once(self, timeout_sec: Any, condition: Callable[[], bool] = _never) -> None:
        try:
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec, None, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        task()
        task.result()


class MultiThreadedExecutor(Executor):
    """Calls in ``num_threads`` threads (default: 4), as the callback groups allow.

    An exception of a callback is raised when the next call is handed out.
    """

    def __init__(self, num_threads: int | None = None, *, context: Context | None = None) -> None:
        super().__init__(context=context)
        if num_threads == 1:
            warn("MultiThreadedExecutor is used with a single thread.\nUse the SingleThreadedExecutor instead.")
        self._futures: list[Task] = []
        self._executor = ThreadPoolExecutor(_THREADS if num_threads is None else num_threads)

    def _rosspin_begin(self, task: Task) -> None:
        self._clock.give_way()  # threads of a pool that are given work at one time begin it in any order
        task()

    def _rosspin_spin_once(self, timeout_sec: Any, condition: Callable[[], bool] = _never) -> None:
        try:
            task, _, _ = self.wait_for_ready_callbacks(timeout_sec, None, condition)
        except (ExternalShutdownException, ShutdownException, TimeoutException, ConditionReachedException):
            return
        self._executor.submit(self._rosspin_begin, task)
        self._futures.append(task)
        for running in list(self._futures):
            if running.done():
                self._futures.remove(running)
                running.result()
