"""Futures, and the tasks in which executors run callbacks (source: rclpy/task.py)."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable, Coroutine, Generator
from enum import Enum
from types import FunctionType
from typing import TYPE_CHECKING, Any
from weakref import ref

from ..clocks.frames import warn
from ..world.world import World, current, current_world

if TYPE_CHECKING:
    from ..world.watcher import Watcher
    from .executors import Executor

__all__ = ["Future", "FutureState", "Task"]


class FutureState(Enum):
    """What has become of a future."""

    PENDING = "PENDING"
    CANCELLED = "CANCELLED"
    FINISHED = "FINISHED"


_PENDING, _CANCELLED, _FINISHED = FutureState  # looked up at each tick

_NONE: tuple[tuple[Any, ...], dict[str, Any]] = (), {}  # arguments


class Future:
    """A result that is still to come. ``await`` it in a callback that is a coroutine.

    A result wakes no one: a coroutine that awaits it continues in the executor's next round, whenever that comes. Done
    callbacks are run by the future's executor, if it has one, else immediately.
    """

    _state = _PENDING
    _result: Any = None
    _exception: BaseException | None = None
    _rosspin_fetched = False
    _rosspin_world: object = None  # the world of the node that raised its exception

    def __init__(self, *, executor: Executor | None = None) -> None:
        self._callbacks: list[Callable[[Future], Any]] = []
        self._set_executor(executor)

    def _set_executor(self, executor: Executor | None) -> None:
        """Let an executor run the done callbacks from now on."""
        self._executor: Callable[[], Executor | None] = _nobody if executor is None else ref(executor)

    def __del__(self) -> None:
        # A future collected after its run has no one to tell.
        if self._exception is not None and not self._rosspin_fetched and _world_here() is self._rosspin_world:
            sys.stderr.write(f"The following exception was never retrieved: {self._exception}\n")

    def __await__(self) -> Generator[None, None, Any]:
        while self._state is _PENDING:
            yield
        return self.result()

    def cancel(self) -> None:
        """Cancel it, unless it is done."""
        if self._state is _PENDING:
            self._rosspin_settle(_CANCELLED)

    def cancelled(self) -> bool:
        """Whether it was cancelled."""
        return self._state is _CANCELLED

    def done(self) -> bool:
        """Whether it has a result or an exception."""
        return self._state is _FINISHED

    def result(self) -> Any:
        """Return its result, or None if there is none yet. Raises its exception if it has one."""
        if self._exception is not None:
            self._rosspin_fetched = True
            raise self._exception
        return self._result

    def exception(self) -> BaseException | None:
        """Its exception, if it has one."""
        self._rosspin_fetched = True
        return self._exception

    def set_result(self, result: Any) -> None:
        """Set its result: the future is done."""
        self._result = result
        self._rosspin_settle(_FINISHED)

    def set_exception(self, exception: BaseException) -> None:
        """Set its exception: the future is done."""
        self._exception = exception
        self._rosspin_world = _world_here()
        self._rosspin_fetched = False
        self._rosspin_settle(_FINISHED)

    def _rosspin_settle(self, state: FutureState) -> None:
        self._state = state
        executor = self._executor()
        while self._callbacks and (callback := self._rosspin_next_callback()):
            if executor is not None:
                executor.create_task(callback, self)
            else:
                try:
                    callback(self)
                except Exception as error:
                    warn(f"Unhandled exception in done callback: {error}")

    def _rosspin_next_callback(self) -> Callable[[Future], Any] | None:
        """Take the next done callback. Each is taken once, even if several threads settle the future or add to it."""
        try:
            return self._callbacks.pop(0)
        except IndexError:
            return None

    def add_done_callback(self, callback: Callable[[Future], Any]) -> None:
        """Call ``callback(future)`` once it is done or cancelled."""
        self._callbacks.append(callback)
        if self._state is not _PENDING and (found := self._rosspin_next_callback()):
            executor = self._executor()
            if executor is not None:
                executor.create_task(found, self)
            else:
                found(self)

    def remove_done_callback(self, callback: Callable[[Future], Any]) -> bool:
        """Do not call ``callback`` any more. Return whether it was still to be called."""
        try:
            self._callbacks.remove(callback)
        except ValueError:
            return False
        return True


def _nobody() -> None:
    return None


def _world_here() -> World | None:
    """The world of the calling node; None outside a run."""
    try:
        return current_world()
    except RuntimeError:
        return None


def is_coroutine_function(function: Any) -> bool:
    """``inspect.iscoroutinefunction``, which takes long to say no to a plain function or method."""
    plain = getattr(function, "__func__", function)
    if type(plain) is FunctionType and not plain.__dict__:  # nothing marks it as one
        return bool(plain.__code__.co_flags & inspect.CO_COROUTINE)
    return inspect.iscoroutinefunction(function)


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Call a function, or await a coroutine function, and return the result."""
    return await callback(*args) if inspect.iscoroutinefunction(callback) else callback(*args)


class Task(Future):
    """The call of a function or a coroutine. Each call of the task resumes the coroutine."""

    def __init__(
        self,
        handler: Callable[..., Any] | Coroutine[Any, Any, Any],
        args: tuple[Any, ...] = (),
        kwargs: dict[str, Any] | None = None,
        executor: Executor | None = None,
    ) -> None:
        super().__init__(executor=executor)
        self._handler: Any = handler
        self._rosspin_arguments = args, kwargs or _NONE[1]
        # Made only when the task is called: Python warns of a coroutine that never began, perhaps in a later run.
        self._rosspin_coroutine: Coroutine[Any, Any, Any] | None = None
        self._rosspin_is_coroutine = is_coroutine_function(handler) or inspect.iscoroutine(handler)
        self._executing = False
        self._rosspin_turn = [None]  # taken by the thread that runs it
        self._rosspin_stack: Any = None  # on which it runs, or last did
        self._rosspin_watcher: Watcher | None = None  # is told when it begins and ends

    def __call__(self) -> None:
        """Run or resume it, unless another thread is doing so."""
        try:
            self._rosspin_turn.pop()
        except IndexError:
            return
        try:
            if self._state is not _PENDING or self._executing:
                return
            self._executing, self._rosspin_stack = True, current()
            try:
                if self._rosspin_coroutine is None:
                    assert self._handler
                    if self._rosspin_watcher:
                        self._rosspin_watcher.calls(self, self._executor())
                    args, kwargs = self._rosspin_arguments
                    result = self._handler
                    if not inspect.iscoroutine(result):
                        result = result(*args, **kwargs)
                    if self._rosspin_is_coroutine:
                        self._rosspin_coroutine = result
                if self._rosspin_coroutine is not None:
                    self._rosspin_coroutine.send(None)
                    self._executing = False
                    return
            except StopIteration as end:
                if self._rosspin_coroutine is None:
                    self.set_exception(end)
                else:
                    self.set_result(end.value)
            except Exception as error:
                self.set_exception(error)
            else:
                self.set_result(result)
            self._handler = self._rosspin_coroutine = None
            self._rosspin_arguments = _NONE  # of a callback, these hold the executor and the node
            # An exception that ends the program, such as SystemExit, leaves the task executing without end.
            self._executing = False
            if self._rosspin_watcher:
                self._rosspin_watcher.ends(self)
        finally:
            self._rosspin_turn.append(None)

    def executing(self) -> bool:
        """Whether it is running now."""
        return self._executing

    def cancel(self) -> None:
        """Cancel it, and close its coroutine."""
        coroutine = self._rosspin_coroutine or self._handler
        if self._state is _PENDING and inspect.iscoroutine(coroutine):
            coroutine.close()
        super().cancel()
