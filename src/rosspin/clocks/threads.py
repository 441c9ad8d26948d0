"""Python's own threads, locks and queues on a simulated clock, and which program a thread belongs to.

A few primitives are replaced for the stacks of simulations: the lock, the start of a thread, its ident, and the clock
that ``threading`` and ``queue`` read. Event, Condition, Semaphore, Barrier, Timer, Queue and ThreadPoolExecutor are
plain Python over these and follow by themselves. Whatever runs outside of a simulation is given the real ones.
"""

from __future__ import annotations

import _thread
import _threading_local
import concurrent.futures.thread as pools
import functools
import queue
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from types import SimpleNamespace
from typing import Any

from .clock import NS, nanoseconds
from .ending import Ended, ending_here
from .frames import called_from, format_error
from .patches import Patch, either, patched
from .stacks import Program, Stack, StackExit, current, enter, whose

__all__ = [
    "PATCHES",
    "begin_main",
    "end_main",
    "followed_threads",
    "list_threads",
    "simulated_threads",
    "unlist_threads",
]

_real_lock = _thread.allocate_lock
_real_rlock = _thread.RLock
_real_ident = _thread.get_ident

# What a look in vain costs (ns) in a loop of nothing but looks: at first about as much as on a real machine; soon more,
# or a loop of a second would take a million looks. The first in a row are free, more than other code needs.
_POLL = 1_000
_FREE_POLLS = 1_000


class Lock:
    """A lock whose waiters, if they are stacks, wait in simulated time. For all others it is a plain lock.

    As with CPython's locks, one that is released goes to whoever asks for it first, not to the one that has waited
    longest: a thread that releases a lock and takes it again immediately can keep others out.
    """

    __slots__ = ("__weakref__", "_lock", "_waiting", "holder")

    def __new__(cls) -> Any:
        return object.__new__(cls) if isinstance(current(), Stack) else _real_lock()

    def __init__(self) -> None:
        self._lock = _real_lock()
        self._waiting: deque[Stack] = deque()
        self.holder: Any = None  # the stack that has taken it, or had

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """Like ``threading.Lock.acquire``."""
        if timeout != -1:
            _check_timeout(blocking, timeout)
        if self._lock.acquire(False):
            self.holder = current()
            return True
        if blocking and timeout:
            stack = current()
            if isinstance(stack, Stack):
                return self.wait(stack, None if timeout == -1 else nanoseconds(timeout))
            return self._lock.acquire(True, timeout)
        _poll()
        return False

    __enter__ = acquire

    def wait(self, stack: Stack, ns: int | None) -> bool:
        """Acquire it on a stack once it is released, within ``ns`` nanoseconds; None is without limit."""
        clock = stack.clock
        until = None if ns is None else clock.now() + ns
        stack.lock = self if ns is None else None
        if ns == 0:
            _poll()
        while True:
            self._waiting.append(stack)
            try:
                woken = clock.wait(None if until is None else until - clock.now())
            except BaseException:
                if stack in self._waiting:
                    self._waiting.remove(stack)
                elif not self._lock.locked():
                    self._wake()  # this stack had its turn: pass it on
                raise
            if not woken:
                self._waiting.remove(stack)
            if self._lock.acquire(False):
                self.holder = stack
                return True
            if not woken:
                return False

    def release(self) -> None:
        """Like ``threading.Lock.release``."""
        self._lock.release()
        if self._waiting:
            self._wake()

    def _wake(self) -> None:
        if self._waiting:
            stack = self._waiting.popleft()
            stack.clock.wake(stack)

    def __exit__(self, *error: object) -> None:
        self.release()

    @property  # type: ignore[misc]
    def __class__(self) -> type:  # for isinstance(lock, _thread.LockType)
        return type(self._lock)

    def locked(self) -> bool:
        """Whether someone has it."""
        return self._lock.locked()

    def _at_fork_reinit(self) -> None:
        """In a child of this process, nothing has it or waits for it."""
        self.__init__()  # type: ignore[misc]

    _is_owned = locked  # for Condition, which would else try to acquire it

    def __repr__(self) -> str:
        return repr(self._lock)


def _poll() -> None:
    """Count a look in vain. The first ones in a row are free; more are a loop, in which each costs ever more time."""
    stack = current()
    if isinstance(stack, Stack):
        clock = stack.clock
        stack.polls = stack.polls + 1 if stack.polled == clock.now() else 1
        if stack.polls > _FREE_POLLS:
            clock.sleep(_POLL * (stack.polls // _FREE_POLLS))
        stack.polled = clock.now()


def _check_timeout(blocking: bool, timeout: float) -> None:
    if not blocking:
        raise ValueError("can't specify a timeout for a non-blocking call")
    if timeout < 0:
        raise ValueError("timeout value must be a non-negative number")
    if timeout > threading.TIMEOUT_MAX:
        raise OverflowError("timeout value is too large")


class RLock(threading._PyRLock):  # type: ignore[name-defined,misc]
    """The RLock that the standard library has in Python, over :class:`Lock`."""

    _owner: int | None
    _count: int

    def __new__(cls) -> Any:
        return object.__new__(cls) if isinstance(current(), Stack) else _real_rlock()

    def acquire(self, blocking: bool = True, timeout: float = -1) -> bool:
        """Like ``threading.RLock.acquire``."""
        me = threading.get_ident()
        if self._owner == me:
            self._count += 1
            return True
        if not self._block.acquire(blocking, timeout):
            return False
        self._owner, self._count = me, 1
        return True

    __enter__ = acquire


class _Handle:
    """What Python 3.13 and newer keep of a thread (``_thread._ThreadHandle``)."""

    def __new__(cls) -> Any:
        return object.__new__(cls) if isinstance(current(), Stack) else _real_handle()

    def __init__(self) -> None:
        self.ident = 0
        self._ended = Lock()
        self._ended.acquire()

    def is_done(self) -> bool:
        done = not self._ended.locked()
        if not done:
            _poll()
        return done

    def join(self, timeout: float | None = None) -> None:
        if self._ended.acquire(True, -1 if timeout is None or timeout < 0 else timeout):
            self._ended.release()

    def _set_done(self) -> None:
        if self._ended.locked():
            self._ended.release()


_real_handle: Callable[[], Any] = getattr(_thread, "_ThreadHandle", _Handle)


# --- starting threads -------------------------------------------------------------------------------------------------


def _start(real: Callable[..., Any]) -> Callable[..., Any]:
    """``_thread.start_new_thread``: a stack starts a stack; a thread starts a thread of the program it belongs to."""

    def start_new_thread(function: Callable[..., Any], args: Any, kwargs: Any = {}) -> int:
        stack = current()
        if isinstance(stack, Stack):
            if not callable(function):
                raise TypeError("first arg must be callable")
            return _start_stack(stack, lambda: _run(function, args, kwargs)).ident
        program = whose()
        if program is not None and callable(function):
            function = _follow(program, function)
        return int(real(function, args, kwargs))

    return start_new_thread


def _start_joinable(real: Callable[..., Any]) -> Callable[..., Any]:
    """``_thread.start_joinable_thread`` (Python 3.13 and newer): does the same."""

    def start_joinable_thread(function: Callable[[], Any], handle: Any = None, daemon: bool = True) -> Any:
        stack = current()
        if not isinstance(stack, Stack):
            program = whose()
            return real(function if program is None else _follow(program, function), handle=handle, daemon=daemon)
        if not isinstance(handle, _Handle):  # the thread was made outside of the run
            handle = _Handle()
            function.__self__._handle = function.__self__._os_thread_handle = handle  # type: ignore[attr-defined]

        started = handle._ended.holder = _start_stack(stack, lambda: _run(function, (), {}))
        started.ended, handle.ident = handle._ended, started.ident
        return handle

    return start_joinable_thread


def _set_tstate_lock(thread: Any) -> None:
    """``Thread._set_tstate_lock`` (Python 3.12 and older): the lock that is released when the thread has ended.

    Unlike the real one, it is in no list that all threads share: that list is searched whenever a thread starts.
    """
    stack = current()
    assert isinstance(stack, Stack)
    thread._tstate_lock = stack.ended = Lock()
    thread._tstate_lock.acquire()


def _start_stack(starter: Stack, function: Callable[[], None]) -> Stack:
    program = starter.program

    def run() -> None:
        try:
            function()
        finally:
            program.idents.discard(stack.ident)
            if stack.ended is not None and stack.ended.locked():  # an interrupted join() releases it, too
                stack.ended.release()

    caller = called_from(sys._getframe())
    stack = starter.clock.start(run, program, f"{caller.f_code.co_filename}:{caller.f_lineno}")
    program.idents.add(stack.ident)
    return stack


def _run(function: Callable[..., Any], args: Any, kwargs: Any) -> None:
    """Do what the interpreter does with the function of a thread."""
    _report_no(StackExit, function)
    try:
        if args or kwargs:
            function(*args, **kwargs)
        else:
            function()  # this takes less of the C stack, which is copied at every switch
    except (SystemExit, StackExit):
        pass
    except Ended:
        raise
    except BaseException as error:
        if sys.unraisablehook is sys.__unraisablehook__:
            sys.stderr.write(f"Exception ignored in thread started by: {function!r}\n{format_error(error)}")
        else:
            hook_args: Any = SimpleNamespace(exc_type=type(error), exc_value=error, exc_traceback=error.__traceback__)
            hook_args.err_msg, hook_args.object = "Exception ignored in thread started by", function
            sys.unraisablehook(hook_args)


def _report_no(end: type[BaseException], function: Callable[..., Any]) -> None:
    """Keep a thread that is ended so from calling ``threading.excepthook``, which a node may have replaced."""
    thread = getattr(function, "__self__", None)
    if isinstance(thread, threading.Thread):
        report = thread._invoke_excepthook  # type: ignore[attr-defined]
        thread._invoke_excepthook = lambda *args: isinstance(sys.exception(), end) or report(*args)  # type: ignore[attr-defined]


def _follow(program: Program, function: Callable[..., Any]) -> Callable[..., Any]:
    """Wrap the function of a thread on the wall clock, so that the thread belongs to a program and ends with it."""
    _report_no(Ended, function)

    @wraps(function)
    def run(*args: Any, **kwargs: Any) -> None:
        enter(program)
        ident = _real_ident()
        program.idents.add(ident)
        try:
            with ending_here():
                _run(function, args, kwargs)
        except Ended:
            pass
        finally:
            program.idents.discard(ident)

    return run


def begin_main(program: Program) -> None:
    """Begin a program: to be called in its main thread, before its own code."""
    program.main_ended = threading.Lock()
    program.main_ended.acquire()


def end_main(program: Program) -> None:
    """Do what Python does at the end of a program: wait for its pools, then for its threads that are not daemons."""
    program.ending = True
    program.main_ended.release()
    workers = [entry for entry in pools._threads_queues.items() if entry[0].ident in program.idents]
    for _, work in workers:
        work.put(None)
    for worker, _ in workers:
        worker.join()
    while waited_for := [
        thread
        for thread in threading.enumerate()
        if thread.ident in program.idents and thread.is_alive() and not thread.daemon
    ]:
        for thread in waited_for:
            thread.join()


@contextmanager
def _listed(program: Program) -> Iterator[None]:
    """Within this context a simulated program's threads are on the lists that all threads of the process share.

    Outside of it they are not, because Python waits at its exit for the threads on these lists.
    """
    list_threads(program)
    try:
        yield
    finally:
        unlist_threads(program)


def list_threads(program: Program) -> None:
    """Put a simulated program's threads on the lists that all threads of the process share."""
    active: Any = threading._active  # type: ignore[attr-defined]
    working: Any = pools._threads_queues
    active.update(program.active)
    working.update(program.working)


def unlist_threads(program: Program) -> None:
    """Take a simulated program's threads off those lists."""
    active: Any = threading._active  # type: ignore[attr-defined]
    working: Any = pools._threads_queues
    program.active = {ident: active.pop(ident) for ident in program.idents if ident in active}
    program.working = {thread: working.pop(thread) for thread in list(working) if thread.ident in program.idents}


class SimpleQueue(queue._PySimpleQueue):  # type: ignore[name-defined,misc]
    """The SimpleQueue that the standard library has in Python."""


class _NoLock:
    """In place of ``concurrent.futures.thread._global_shutdown_lock``, which is held while a thread is started.

    Stacks take turns and do without it: to wait for one that another stack holds would block them all.
    """

    def __init__(self, real: Any) -> None:
        self._real = real

    def __enter__(self) -> None:
        if not isinstance(current(), Stack):
            self._real.acquire()

    def __exit__(self, *error: object) -> None:
        if not isinstance(current(), Stack):
            self._real.release()


class _Ending:
    """In place of ``concurrent.futures.thread._shutdown``: whether the caller's program takes no more work."""

    def __init__(self, real: bool) -> None:
        self._real = real

    def __bool__(self) -> bool:
        program = whose()
        return self._real if program is None else program.ending


# --- what is replaced -------------------------------------------------------------------------------------------------


@functools.cache
def _get_ident(real: Callable[[], int]) -> Callable[[], int]:
    @wraps(real)
    def get_ident() -> int:
        stack = current()
        return stack.ident if isinstance(stack, Stack) else real()

    return get_ident


class _Moment:
    """A time by which ``threading`` and ``queue`` compute deadlines: exact, so that a wait to a deadline reaches it."""

    __slots__ = ("ns",)

    def __init__(self, ns: int) -> None:
        self.ns = ns

    def __add__(self, seconds: float) -> _Moment:
        return _Moment(self.ns + nanoseconds(seconds))

    def __sub__(self, other: _Moment) -> float:
        return (self.ns - other.ns) / NS


def _moment(stack: Stack) -> _Moment:
    return _Moment(stack.clock.now())


def _is_alive(real: Callable[[Any], bool]) -> Callable[[Any], bool]:
    def is_alive(thread: threading.Thread) -> bool:
        program = whose()
        return real(thread) if program is None or thread is not threading.main_thread() else not program.ending

    return is_alive


def _join(real: Callable[..., None]) -> Callable[..., None]:
    def join(thread: threading.Thread, timeout: float | None = None) -> None:
        program = whose()
        if program is None or thread is not threading.main_thread() or thread is threading.current_thread():
            real(thread, timeout)
        elif program.main_ended.acquire(timeout=-1 if timeout is None else max(timeout, 0)):
            program.main_ended.release()

    return join


def _enumerate(stack: Stack) -> list[threading.Thread]:
    threads = list(threading._active.values()) + list(threading._limbo)  # type: ignore[attr-defined]
    return [thread for thread in threads if thread is threading.main_thread() or thread.ident in stack.program.idents]


def _active_count(stack: Stack) -> int:
    return len(_enumerate(stack))


_FOLLOWED: list[Patch] = [
    (_thread, "start_new_thread", _start),
    (_thread, "start_new", _start),
    (_thread, "start_joinable_thread", _start_joinable),
    (threading, "_start_new_thread", _start),
    (threading, "_start_joinable_thread", _start_joinable),
    (threading.Thread, "is_alive", _is_alive),
    (threading.Thread, "join", _join),
    (pools, "_shutdown", _Ending),
]

PATCHES: list[Patch] = [
    *_FOLLOWED,
    (_thread, "allocate_lock", lambda real: Lock),
    (_thread, "allocate", lambda real: Lock),
    (_thread, "RLock", lambda real: RLock),
    (_thread, "get_ident", _get_ident),
    (threading, "Lock", lambda real: Lock),
    (threading, "_allocate_lock", lambda real: Lock),
    (threading, "_CRLock", lambda real: RLock),
    (threading, "_ThreadHandle", lambda real: _Handle),
    (threading.Thread, "_set_tstate_lock", either(lambda stack, thread: _set_tstate_lock(thread))),
    (threading, "get_ident", _get_ident),
    (threading, "_set_name", either(lambda stack, name: None)),  # of a thread of the operating system
    (threading, "_time", either(_moment)),
    (threading, "enumerate", either(_enumerate)),
    (threading, "active_count", either(_active_count)),
    (threading, "_counter", either(lambda stack: next(stack.program.thread_numbers))),
    (threading, "local", lambda real: _threading_local.local),
    (queue, "time", either(_moment)),
    (functools, "RLock", lambda real: RLock),
    (pools, "_global_shutdown_lock", _NoLock),
    (queue, "SimpleQueue", lambda real: SimpleQueue),
    (
        pools.ThreadPoolExecutor,
        "_counter",
        lambda real: staticmethod(either(lambda stack: next(stack.program.pool_numbers))(real)),
    ),
]


@contextmanager
def followed_threads() -> Iterator[None]:
    """Within this context, threads that a thread of a program starts belong to the program, too."""
    with patched(_FOLLOWED):
        yield


@contextmanager
def simulated_threads(program: Program) -> Iterator[None]:
    """Within this context the threads, locks and queues that stacks make are simulated; ``program``'s continue."""
    with patched(PATCHES), _listed(program):
        yield
