"""Simulated threads, drawn at random: they do what a plain model does.

Times are in units of 1/8 s, of which sums and differences in seconds are exact.
"""

from __future__ import annotations

import queue
import threading
import time
from collections import deque
from collections.abc import Callable, Generator
from heapq import heappop, heappush
from typing import Any

from hypothesis import given, settings
from hypothesis import strategies as st

from rosspin import simulate

UNIT = 0.125  # s
END = 60  # when the main ends

# A step is what a thread does, with arguments; a timeout of None is none, and "no" says not to wait.
Step = tuple[str, *tuple[Any, ...]]
Program = list[list[Step]]
Log = list[tuple[float, int, str]]

# --- the model --------------------------------------------------------------------------------------------------------

# What a thread does, which yields when it continues by itself (None: never), and is sent whether it was woken before.
Doing = Generator[float | None, bool, Any]


class Worker:
    """A thread of the model."""

    def __init__(self, number: int) -> None:
        self.number = number
        self.doing: Doing
        self.turn = 0  # the number of the only entry in the agenda that counts
        self.waits = False


class Kernel:
    """One thread runs until it waits; the next is the one that is due, of those due at one time the first to be so."""

    def __init__(self) -> None:
        self.now = 0.0
        self._agenda: list[tuple[float, int, Worker]] = []
        self._turns = 0

    def put(self, when: float, worker: Worker) -> None:
        self._turns += 1
        worker.turn = self._turns
        heappush(self._agenda, (when, self._turns, worker))

    def wake(self, worker: Worker) -> None:
        worker.waits = False
        self.put(self.now, worker)

    def run(self, until: float) -> None:
        begun = set()
        while self._agenda and self._agenda[0][0] < until:
            when, turn, worker = heappop(self._agenda)
            if turn != worker.turn:
                continue
            self.now = when
            try:
                if worker in begun:
                    due = worker.doing.send(not worker.waits)
                else:
                    begun.add(worker)
                    due = next(worker.doing)
            except StopIteration:
                continue
            worker.waits = True
            worker.turn = 0
            if due is not None:
                self.put(due, worker)

    def after(self, timeout: float | None) -> float | None:
        return None if timeout is None else self.now + timeout


class ModelLock:
    """Free or not. Who releases it wakes the one that has waited longest, who asks for it again when its turn comes."""

    def __init__(self, kernel: Kernel) -> None:
        self._kernel = kernel
        self._free = True
        self._waiting: deque[Worker] = deque()

    def acquire(self, me: Worker, timeout: float | None) -> Doing:
        until = self._kernel.after(timeout)
        woken = timeout != 0
        while not self._free and woken:
            self._waiting.append(me)
            woken = yield until
            if not woken:
                self._waiting.remove(me)
        got, self._free = self._free, False
        return got

    def release(self, me: Worker) -> None:
        if self._free:
            raise RuntimeError
        self._free = True
        if self._waiting:
            self._kernel.wake(self._waiting.popleft())


class ModelRLock:
    """A lock with an owner, who may take it again."""

    def __init__(self, kernel: Kernel) -> None:
        self._lock = ModelLock(kernel)
        self.owner: Worker | None = None
        self.count = 0

    def acquire(self, me: Worker, timeout: float | None, count: int = 1) -> Doing:
        if self.owner is not me:
            if not (yield from self._lock.acquire(me, timeout)):
                return False
            self.owner, self.count = me, 0
        self.count += count
        return True

    def release(self, me: Worker, count: int = 1) -> None:
        if self.owner is not me:
            raise RuntimeError
        self.count -= count
        if self.count == 0:
            self.owner = None
            self._lock.release(me)


class Place:
    """Where a thread stands in a line; no thread's when it has given up but not yet gone."""

    def __init__(self, worker: Worker) -> None:
        self.worker: Worker | None = worker


class Line:
    """Those who wait to be notified, in the order of their coming."""

    def __init__(self, kernel: Kernel) -> None:
        self._kernel = kernel
        self._places: list[Place] = []

    def wait(self, me: Worker, timeout: float | None, afterwards: Callable[[], Doing] | None = None) -> Doing:
        place = Place(me)
        self._places.append(place)
        notified = timeout != 0 and (yield self._kernel.after(timeout))
        place.worker = None
        if afterwards:
            yield from afterwards()
        if not notified and place in self._places:
            self._places.remove(place)
        return notified

    def notify(self, count: int | None = None) -> None:
        count = len(self._places) if count is None else count
        first, self._places = self._places[:count], self._places[count:]
        for place in first:
            if place.worker:
                self._kernel.wake(place.worker)


class ModelCondition(ModelRLock):
    """Waiting gives the lock back, and takes it again at its end."""

    def __init__(self, kernel: Kernel) -> None:
        super().__init__(kernel)
        self._line = Line(kernel)

    def wait(self, me: Worker, timeout: float | None) -> Doing:
        count = self.count
        self.release(me, count)
        return (yield from self._line.wait(me, timeout, lambda: self.acquire(me, None, count)))

    def notify(self, me: Worker, count: int | None) -> None:
        if self.owner is not me:
            raise RuntimeError
        self._line.notify(count)


def until_true(kernel: Kernel, line: Line, me: Worker, timeout: float | None, holds: Callable[[], bool]) -> Doing:
    """Wait in a line, each time that it is in vain, until something holds; whether it does."""
    until = kernel.after(timeout)
    if timeout == 0:
        return holds()
    while not holds():
        left = None if until is None else until - kernel.now
        if left is not None and left <= 0:
            return False
        yield from line.wait(me, left)
    return True


class ModelSemaphore:
    def __init__(self, kernel: Kernel, value: int) -> None:
        self._kernel = kernel
        self._value = value
        self._line = Line(kernel)

    def acquire(self, me: Worker, timeout: float | None) -> Doing:
        got = yield from until_true(self._kernel, self._line, me, timeout, lambda: self._value > 0)
        self._value -= got
        return got

    def release(self, me: Worker) -> None:
        self._value += 1
        self._line.notify(1)


class ModelEvent:
    def __init__(self, kernel: Kernel) -> None:
        self._set = False
        self._line = Line(kernel)

    def wait(self, me: Worker, timeout: float | None) -> Doing:
        return self._set or (yield from self._line.wait(me, timeout))

    def set(self) -> None:
        self._set = True
        self._line.notify()

    def clear(self) -> None:
        self._set = False


class ModelQueue:
    def __init__(self, kernel: Kernel, size: int) -> None:
        self._kernel = kernel
        self._size = size
        self._values: deque[object] = deque()
        self._not_empty, self._not_full = Line(kernel), Line(kernel)

    def put(self, me: Worker, value: object, timeout: float | None) -> Doing:
        room = lambda: len(self._values) < self._size  # noqa: E731
        if not (yield from until_true(self._kernel, self._not_full, me, timeout, room)):
            return "Full"
        self._values.append(value)
        self._not_empty.notify(1)
        return None

    def get(self, me: Worker, timeout: float | None) -> Doing:
        if not (yield from until_true(self._kernel, self._not_empty, me, timeout, lambda: bool(self._values))):
            return "Empty"
        self._not_full.notify(1)
        return self._values.popleft()


def modelled(program: Program) -> Log:
    """What the model does."""
    kernel = Kernel()
    log: Log = []
    locks: dict[str, Any] = {
        "lock a": ModelLock(kernel),
        "lock b": ModelLock(kernel),
        "rlock": ModelRLock(kernel),
        "condition": ModelCondition(kernel),
        "semaphore": ModelSemaphore(kernel, 1),
    }
    condition = locks["condition"]
    event = ModelEvent(kernel)
    values = ModelQueue(kernel, 2)
    ends = [ModelLock(kernel) for _ in program]  # each is held until the thread's end

    def do(me: Worker, name: str, *args: Any) -> Doing:
        match name, *args:
            case "sleep", length:
                yield kernel.now + length
            case "acquire", lock, timeout:
                return (yield from locks[lock].acquire(me, 0 if timeout == "no" else timeout))
            case "release", lock:
                locks[lock].release(me)
            case "wait", timeout:
                if condition.owner is not me:
                    raise RuntimeError
                return (yield from condition.wait(me, timeout))
            case "notify", count:
                condition.notify(me, count)
            case "wait for event", timeout:
                return (yield from event.wait(me, timeout))
            case ("set",):
                event.set()
            case ("clear",):
                event.clear()
            case "put", value, timeout:
                return (yield from values.put(me, value, 0 if timeout == "no" else timeout))
            case "get", timeout:
                return (yield from values.get(me, 0 if timeout == "no" else timeout))
            case "join", number, timeout:
                if (yield from ends[number].acquire(me, timeout)):
                    ends[number].release(me)
        return None

    def work(me: Worker, steps: list[Step]) -> Doing:
        yield from ends[me.number].acquire(me, None)
        yield 1.0
        for step in steps:
            try:
                result = yield from do(me, *step)
            except RuntimeError:
                result = "RuntimeError"
            log.append((kernel.now, me.number, f"{step}: {result}"))
        ends[me.number].release(me)

    for number, steps in enumerate(program):
        worker = Worker(number)
        worker.doing = work(worker, steps)
        kernel.put(0, worker)
    kernel.run(END)
    return log


# --- the real thing, simulated ----------------------------------------------------------------------------------------


def simulated(program: Program) -> Log:
    """What Python's own threads do in simulated time."""
    log: Log = []

    def node() -> None:
        locks: dict[str, Any] = {
            "lock a": threading.Lock(),
            "lock b": threading.Lock(),
            "rlock": threading.RLock(),
            "condition": threading.Condition(),
            "semaphore": threading.Semaphore(1),
        }
        condition = locks["condition"]
        event = threading.Event()
        values: queue.Queue[object] = queue.Queue(2)

        def seconds(timeout: float | None) -> float | None:
            return None if timeout is None else timeout * UNIT

        def acquire(lock: str, timeout: float | str | None) -> bool:
            if timeout == "no":
                return bool(locks[lock].acquire(False))
            if isinstance(timeout, int):
                return bool(locks[lock].acquire(timeout=timeout * UNIT))
            return bool(locks[lock].acquire())

        def put(value: object, timeout: Any) -> None:
            values.put_nowait(value) if timeout == "no" else values.put(value, timeout=seconds(timeout))

        def get(timeout: Any) -> object:
            return values.get_nowait() if timeout == "no" else values.get(timeout=seconds(timeout))

        does: dict[str, Callable[..., Any]] = {
            "sleep": lambda length: time.sleep(length * UNIT),
            "acquire": acquire,
            "release": lambda lock: locks[lock].release(),
            "wait": lambda timeout: condition.wait(seconds(timeout)),
            "notify": lambda count: condition.notify_all() if count is None else condition.notify(count),
            "wait for event": lambda timeout: event.wait(seconds(timeout)),
            "set": event.set,
            "clear": event.clear,
            "put": put,
            "get": get,
            "join": lambda number, timeout: threads[number].join(seconds(timeout)),
        }

        def work(number: int, steps: list[Step]) -> None:
            time.sleep(UNIT)
            for step in steps:
                try:
                    result = does[step[0]](*step[1:])
                except (RuntimeError, queue.Empty, queue.Full) as error:
                    result = type(error).__name__
                log.append((time.monotonic_ns() / (UNIT * 1e9), number, f"{step}: {result}"))

        threads = [
            threading.Thread(target=work, args=(number, steps), daemon=True) for number, steps in enumerate(program)
        ]
        for thread in threads:
            thread.start()
        time.sleep((END - 0.5) * UNIT)

    run = simulate(node, END * UNIT)
    assert (run.status, run.console) == (0, "")
    return log


lengths = st.integers(0, 4)
timeouts = st.one_of(st.none(), st.integers(0, 4))
timeouts_or_no = st.one_of(timeouts, st.just("no"))
locks = st.sampled_from(("lock a", "lock b", "rlock", "condition", "semaphore"))
sleeps = st.tuples(st.just("sleep"), lengths)
waits = st.tuples(st.just("wait"), timeouts)
notifies = st.tuples(st.just("notify"), st.sampled_from((None, 1, 2)))
steps = st.one_of(
    sleeps,
    st.tuples(st.just("acquire"), locks, timeouts_or_no),
    st.tuples(st.just("release"), locks),
    st.tuples(st.just("wait for event"), timeouts),
    st.sampled_from((("set",), ("clear",))),
    st.tuples(st.just("put"), st.integers(0, 9), timeouts_or_no),
    st.tuples(st.just("get"), timeouts_or_no),
    st.tuples(st.just("join"), st.integers(0, 4), timeouts),
    st.sampled_from((("wait", None), ("notify", 1))),  # mostly without the condition's lock
)


def held(locks: Any, timeouts: Any, inner: Any) -> Any:
    """A few steps with a lock in hand, if it was free."""
    return st.builds(
        lambda lock, timeout, inner: [("acquire", lock, timeout), *inner, ("release", lock)],
        locks,
        timeouts,
        st.lists(inner, min_size=1, max_size=3),
    )


parts = st.one_of(
    steps.map(lambda step: [step]),
    held(locks, timeouts_or_no, st.one_of(sleeps, steps)),
    held(locks, timeouts, sleeps),
    held(st.just("condition"), st.none(), st.one_of(sleeps, waits, notifies)),
)


@st.composite
def programs(draw: Any) -> Program:
    """Up to five threads; none joins itself, or one that is not there."""
    program: Program = draw(
        st.lists(st.lists(parts, min_size=1, max_size=6).map(lambda parts: sum(parts, [])), min_size=2, max_size=5)
    )
    for number, steps in enumerate(program):
        steps[:] = [step for step in steps if step[0] != "join" or step[1] < len(program) and step[1] != number]
    return program


@settings(max_examples=100, deadline=None)
@given(programs())
def test_threads_do_what_a_plain_model_does(program: Program) -> None:
    assert simulated(program) == modelled(program)


def test_who_has_waited_longest_is_next() -> None:
    def holding(begin: int, length: int) -> list[Step]:
        return [("sleep", begin), ("acquire", "lock a", None), ("sleep", length), ("release", "lock a")]

    program: Program = [holding(1, 5), holding(2, 1), holding(3, 1), holding(4, 1)]
    assert simulated(program) == modelled(program)


def test_the_model_knows_who_is_next() -> None:
    """By hand: three threads and one lock."""
    hold: list[Step] = [("acquire", "lock a", None), ("sleep", 2), ("release", "lock a")]
    program: Program = [hold, hold, [("sleep", 1), ("acquire", "lock a", 2), ("acquire", "lock a", "no")]]
    assert modelled(program) == [
        (1, 0, "('acquire', 'lock a', None): True"),
        (2, 2, "('sleep', 1): None"),
        (3, 0, "('sleep', 2): None"),
        (3, 0, "('release', 'lock a'): None"),
        (3, 1, "('acquire', 'lock a', None): True"),
        (4, 2, "('acquire', 'lock a', 2): False"),
        (4, 2, "('acquire', 'lock a', 'no'): False"),
        (5, 1, "('sleep', 2): None"),
        (5, 1, "('release', 'lock a'): None"),
    ]
