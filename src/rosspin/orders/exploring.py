"""Explore: run a node, or a test, in many orders of events, and find the shortest one in which it fails."""

from __future__ import annotations

import dataclasses
import functools
import inspect
import linecache
import math
import pickle
import signal
import sys
import traceback
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from typing import Any, NamedTuple

from ..clocks.explored import ExploredSimulation, Order
from ..faults import Fault
from ..results.orders import Orders
from ..results.ticks import Run
from ..run.explain import TimeStandsStill
from ..run.host import duration
from ..run.roslaunch.launch import Node
from ..run.saved_state import one_at_a_time
from ..run.simulate import Prepared, prepare, run_prepared
from ..run.source import NodeLike
from ..run.streams import capture
from ..world.graph import TickLog
from ..world.world import NotSimulated
from .beside import instants, side_by_side
from .strategies import STRATEGIES, bound_of_pct

__all__ = ["Exploration", "compare_orders", "explore", "explored"]

# So many runs at most make a failing order shorter.
_SHRINKING = 500

# A failing order that deviates more than once is followed by a look at all that deviate once, if they are not more.
_ONCE = 300

# How a node may end: by itself, or by Ctrl-C, caught or not, or not at all.
_WELL = (0, 128 + signal.SIGINT, -signal.SIGINT, None)

# What becomes of one that does not end.
_KILLED = (128 + signal.SIGKILL, -signal.SIGKILL)

Try = Callable[[Order], object]
"""Runs something in an order. Returns how it fails; None, or something else that is false, if it does not."""


class Tried(NamedTuple):
    """An order that was run: how it failed, as of :data:`Try`, and how many things there were to choose among."""

    order: Order
    failure: Any
    threads: int


TryAll = Callable[[Iterable[Order]], Iterator[Tried]]
"""Runs something in several orders, of which each has noted what was chosen when it is yielded, one after the other."""


@dataclasses.dataclass(frozen=True)
class Exploration:
    """What came of exploring. As a text it is the answer to read.

    ``schedules`` is how many orders were run until one failed, the usual one included. ``failure`` says how that fails;
    it is empty if none does. ``token`` is the shortest order found that fails, for ``simulate(..., schedule=token)``,
    and ``run`` its run. ``usual`` is the run in the usual order; None if time stands still in it.

    ``bound`` is how often an order may deviate from the usual one so that all such orders were run: with the strategy
    "all", and if no order fails, the property holds for these. It is infinite if there are no others at all.

    ``orders`` are what the usual order and the one that fails do, for :func:`rosspin.plots.both_orders`: an
    :class:`~rosspin.results.orders.Orders`; None if none fails.
    """

    failure: str
    token: str
    schedules: int
    bound: float
    run: Run | None
    usual: Run | None
    orders: Orders | None
    text: str

    def __str__(self) -> str:
        return self.text


def explore(
    node: NodeLike | Sequence[NodeLike | Node],
    seconds: float,
    check: Callable[[Run], object] | None = None,
    *,
    args: Sequence[str] = (),
    schedules: int = 1000,
    strategy: str = "pct",
    seed: int = 0,
    deep: bool = False,
    faults: Sequence[Fault] = (),
    executor: Executor | None = None,
) -> Exploration:
    """Run a node, or several, in many orders of events, and return the shortest order found in which it fails.

    ``node``, ``seconds``, ``args`` and ``faults`` are as for :func:`simulate`. A run fails if ``check(run)`` raises an
    exception, if an exception is uncaught in any thread, if a node that no fault has killed ends with a status other
    than 0 (or 130, after Ctrl-C), if a node does not end at Ctrl-C, if time stands still, or in a deadlock.
    Exploring ends with the first that fails, or after so many ``schedules``, of which the first is the usual
    order.

    What may happen in another order is what ROS leaves open:

    * which of the threads and processes that are due at one instant continues, where another waits or ends. In rospy
      that is also in which order callbacks of several topics, publishers or timers are called;
    * of messages that come, and timers that are due, at the instant at which an executor of rclpy looks: which it sees.
      What it sees it calls in the order of rclpy: timers, subscriptions, ..., each in the order of their creation;
    * in which order the threads of a MultiThreadedExecutor begin with what they were given;
    * whether two processes of rclpy, or a publisher and a subscriber of rospy, are connected when they usually are or
      one second later.

    With ``deep`` it is also where Python takes its turn from a thread in the node's own code, for another one of its
    process; its own are the modules next to the node's file, and in its package, too. In ROS 1 (Python 3.8) that may be
    between any two statements, and after any value that was looked up or calculated; in ROS 2 (from 3.10 on) where a
    function begins, a call has returned, or a loop goes round.

    Not open are the order of the messages of one publisher on a topic, of the calls of one executor in one round, of
    what one thread does, and all that comes after Ctrl-C. Not tried: that code takes time, that messages do, or get
    lost, changes of thread in modules that are not the node's own, signals, other random numbers than those that the
    node draws in the usual order.

    ``strategy`` is "pct" (random priorities), "random", or "all" (those that deviate once from the usual order, then
    twice, ...). ``seed`` is for the first two.

    With an ``executor``, its processes run the orders, on one machine or on several: a ProcessPoolExecutor of Python's,
    or one of Dask's, MPI's or joblib's. What is found, its token and ``schedules`` are the same, however many processes
    there are. They need the node's files in the same places, and ``node`` and ``check`` are sent to them: with Python's
    own pool, a function has to be one of a module. The order that fails is made shorter here.

    Raises what :func:`simulate` raises but TimeStandsStill; TypeError for a ``check`` that cannot be called, for what
    is no executor, and for what cannot be sent to its processes; ValueError for an unknown strategy, for ``schedules``
    below 1, for a ``seed`` that is no whole number, and for a function, or a launch file of ROS 2, that should be
    explored ``deep``. Among several nodes, functions are explored as without it.
    """
    _refuse(schedules, strategy, seed)
    if check is not None and not callable(check):
        raise TypeError(f"check is a function of the run, not {check!r}")
    if isinstance(node, (list, tuple)) and not node:
        raise ValueError("there is no node to run: the list is empty")
    if executor is not None and not isinstance(executor, Executor):
        raise TypeError(f"executor is a concurrent.futures.Executor, not {executor!r}")
    prepared = prepare(node, args, False, deep, faults)
    runs: dict[str, Run | None] = {}

    def attempt(order: Order) -> str:
        failure, run = _run(prepared, seconds, check, order)
        if failure or not order.made:
            runs[order.token] = run
        return failure

    trying = one_by_one(attempt)
    if executor is not None:
        trying = functools.partial(_elsewhere, executor, _Job(node, seconds, check, args, deep, faults))
    found = search(attempt, schedules, strategy, seed, deep, trying)
    functions = [code.name for code in prepared.codes if deep and code.source is None]
    left_out = [f"Only files were explored deep, not {', '.join(functions)}."] if functions else []
    order = found.order
    if order is None:
        text = " ".join([found.said, *left_out])
        return Exploration("", "", found.schedules, found.bound, None, runs.get(_USUAL[deep]), None, text)
    orders = compare_orders(node, seconds, order, args, faults=faults)
    lines = [found.failure, f"In {found.said}: {order.token}", *side_by_side(orders), *left_out]
    return Exploration(
        found.failure,
        order.token,
        found.schedules,
        found.bound,
        runs.get(order.token),
        runs.get(_USUAL[deep]),
        orders,
        "\n".join(lines),
    )


class _Job(NamedTuple):
    """What another process needs to know to run an order."""

    node: NodeLike | Sequence[NodeLike | Node]
    seconds: float
    check: Callable[[Run], object] | None
    args: Sequence[str]
    deep: bool
    faults: Sequence[Fault]


def _elsewhere(executor: Executor, job: _Job, orders: Iterable[Order]) -> Iterator[Tried]:
    """Have an executor run orders, and yield what came of them, in their order."""
    pools = sys.modules.get("concurrent.futures.process")  # which is not everywhere
    if pools and isinstance(executor, pools.ProcessPoolExecutor):
        # Given several that it cannot send, it may never shut down (an old fault of Python).
        try:
            pickle.dumps(job)
        except (AttributeError, TypeError, pickle.PicklingError) as error:
            raise TypeError(f"this cannot be sent to another process: {error}") from error
    waiting = [(order, executor.submit(_run_here, job, order)) for order in orders]
    try:
        for order, future in waiting:
            try:
                done = future.result()
            except (AttributeError, TypeError, pickle.PicklingError) as error:
                if "pickle" not in str(error).lower():
                    raise
                raise TypeError(f"this cannot be sent to another process: {error}") from error
            vars(order).update(vars(done.order))  # which is a copy
            yield done._replace(order=order)
    finally:
        for _, future in waiting:
            future.cancel()


def _run_here(job: _Job, order: Order) -> Tried:
    """Run an order in a process of an executor."""
    with one_at_a_time():  # its threads share one console
        failure, _ = _run(prepare(job.node, job.args, False, job.deep, job.faults), job.seconds, job.check, order)
    return Tried(order, failure, order.forget())


_USUAL = {deep: Order(deep=deep).token for deep in (False, True)}


def _run(
    prepared: Prepared, seconds: float, check: Callable[[Run], object] | None, order: Order, start: float = 0.0
) -> tuple[str, Run | None]:
    """Run in an order. Return how that fails (empty if it does not), and the run."""
    try:
        with capture() as console:
            clock = ExploredSimulation(order, duration(start, "start"))
            result = run_prepared(prepared, seconds, clock, TickLog())
    except NotSimulated:
        raise
    except TimeStandsStill as error:
        return str(error), None
    run, host = result.run(console.text(), "simulated", seconds), result.host
    if host.failed:
        return f"uncaught: {_say(host.failed[0])}", run
    if host.waits:
        return host.waits.replace("rosspin: ", "").rstrip(), run
    survivors = [each for each in host.processes if not each.world.crashed]  # by no fault
    ends = [(each.world.exit_status, each.node.name) for each in survivors]
    if len(survivors) == len(host.processes):
        ends.insert(0, (run.status, "the run"))
    for status, name in ends:
        if status in _KILLED:
            return f"{name} did not end at Ctrl-C", run
        if status not in _WELL:
            return f"{name} ended with status {status}", run
    try:
        if check:
            check(run)
    except Exception as error:
        return _say(error), run
    return "", run


def _say(error: BaseException) -> str:
    said = str(error)
    if not said and error.__traceback__:  # an assert without words: its line
        frame, line = list(traceback.walk_tb(error.__traceback__))[-1]
        said = linecache.getline(frame.f_code.co_filename, line).strip()
    return f"{type(error).__name__}: {said}" if said else type(error).__name__


def compare_orders(
    node: NodeLike | Sequence[NodeLike | Node],
    seconds: float,
    order: Order,
    args: Sequence[str] = (),
    skip_cpp: bool = False,
    *,
    start: float = 0.0,
    faults: Sequence[Fault] = (),
) -> Orders:
    """Compare an order with the usual one, by one run in each. Raises what :func:`simulate` raises for the rest."""
    try:
        prepared = prepare(node, args, skip_cpp, True, faults)
    except ValueError:  # functions, and files of ROS 2's launch, are shown without their lines
        prepared = prepare(node, args, skip_cpp, False, faults)
    again, runs = [], []
    for deviations in ({}, order.made or order.planned):
        again.append(Order(deviations, deep=order.deep))
        again[-1].turns = []
        runs.append(_run(prepared, seconds, None, again[-1], start)[1])
    return Orders(runs[0], runs[1], tuple(instants(again[0], again[1], duration(start, "start"))))


# --- searching --------------------------------------------------------------------------------------------------------


@dataclasses.dataclass
class SearchResult:
    """What a search has found: the ``order`` that fails, if any does."""

    order: Order | None
    failure: Any
    schedules: int
    bound: float
    said: str


def _refuse(schedules: int, strategy: str, seed: int) -> None:
    """Raise ValueError for arguments with which nothing can be searched."""
    if strategy not in list(STRATEGIES):
        raise ValueError(f"strategy is one of {', '.join(map(repr, STRATEGIES))}, not {strategy!r}")
    if type(schedules) is not int or schedules < 1:
        raise ValueError(f"schedules must be a whole number of at least 1, not {schedules!r}")
    if type(seed) is not int:
        raise ValueError(f"seed must be a whole number, not {seed!r}")


def one_by_one(attempt: Try) -> TryAll:
    """Make what tries several orders of what tries one."""
    return lambda orders: (Tried(order, attempt(order), order.forget()) for order in orders)


def search(attempt: Try, schedules: int, strategy: str, seed: int, deep: bool, trying: TryAll) -> SearchResult:
    """Try orders until one fails, and make that one shorter."""
    usual = Order(deep=deep)
    if failure := attempt(usual):
        return SearchResult(usual, failure, 1, 0, "the usual order")
    if not (usual.options or usual.test_points):
        return SearchResult(
            None, failure, 1, math.inf, "There is only one order: nothing is open at any instant. It is well."
        )
    different, points, threads, tried, bound = {_USUAL[deep]}, len(usual.options), 0, 1, 0.0
    for batch in STRATEGIES[strategy](usual, seed, deep):
        left = schedules - tried
        for order, failure, known in trying(batch[:left]):
            tried += 1
            if failure:
                shortest, failure = _shorten(attempt, order, failure, usual)
                if not (shortest.made and attempt(Order(shortest.made, deep=deep))):
                    said = "the usual order, but not each time: the node, or the test, does not do the same in each run"
                    return SearchResult(shortest, failure, tried, 0, said)
                times = f"which deviates {_times(len(shortest.made))} from the usual one"
                said = f"the shortest order found, {times}, after {tried} orders"
                return SearchResult(shortest, failure, tried, 0, said)
            different.add(order.token)
            points, threads = max(points, len(order.options)), max(threads, known)
        if len(batch) > left:
            if strategy == "all":
                bound = len(batch[left].made or batch[left].planned) - 1
            break
    else:
        bound = math.inf
    return SearchResult(None, failure, tried, bound, _all_well(strategy, tried, len(different), bound, threads, points))


def _all_well(strategy: str, tried: int, different: int, bound: float, threads: int, points: int) -> str:
    if bound == math.inf:
        return f"There are {tried:,} orders. All were run, and all are well: this is proved for what may differ."
    said = f"{tried:,} orders were run, of which {different:,} were different, and all are well."
    if strategy == "all":
        if not bound:
            return f"{said} They are not even all that deviate once from the usual one: give it more schedules."
        return f"{said} All that deviate at most {_times(int(bound))} are among them: for those this is proved."
    if strategy == "pct":
        chances = [min(99, int(100 * bound_of_pct(threads, points, tried, depth))) for depth in (1, 2, 3)]
        return (
            f"{said} There were up to {points} points, and {threads} things to choose among: a fault of depth 1, 2 or "
            f"3 would have been found with a probability of at least {chances[0]}, {chances[1]} or {chances[2]} %."
        )
    return said


def _shorten(attempt: Try, order: Order, failure: object, usual: Order) -> tuple[Order, object]:
    """Leave out deviations as long as it fails without them.

    Source: Zeller and Hildebrandt, "Simplifying and isolating failure-inducing input" (TSE 2002), algorithm ddmin.
    """
    best, left = (order, failure), _SHRINKING

    def fails(deviations: dict[int, int]) -> bool:
        nonlocal best, left
        left -= 1
        shorter = Order(deviations, deep=order.deep)
        failure = attempt(shorter)
        if failure and len(shorter.made) < len(best[0].made):
            best = shorter, failure
            return True
        return False

    parts = 2
    while left > 0 and best[0].made:
        made = list(best[0].made.items())
        size = math.ceil(len(made) / parts)
        # The last first: what comes after the failure is of no use, and what is left out late moves no point before.
        for start in reversed(range(0, len(made), size)):
            if left > 0 and fails(dict(made[:start] + made[start + size :])):
                parts = max(parts - 1, 2)
                break
        else:
            if size == 1:
                break
            parts = min(2 * parts, len(made))
    if len(best[0].made) > 1 and sum(usual.options) - len(usual.options) <= _ONCE:
        for point, options in enumerate(usual.options):
            if any(fails({point: choice}) for choice in range(1, options)):
                break
        else:
            any(fails({point: 1}) for point in usual.test_points)
    return best


def _times(number: int) -> str:
    return {1: "once", 2: "twice"}.get(number, f"{number} times")


# --- tests ------------------------------------------------------------------------------------------------------------


def explored(
    *, schedules: int = 1000, strategy: str = "pct", seed: int = 0, deep: bool = False, schedule: str = ""
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Run a test of pytest once for each of many orders of events in the nodes that it starts.

    The test takes the fixture ``start_node``, which is as new each time; its other fixtures are made once. It is run in
    the usual order first. If it fails in another one, the shortest such order is looked for, and the failure is that
    one's; its last lines name the order. With that as ``schedule`` the test is run in this order alone.

    The arguments are as for :func:`explore`, which also says what may differ. Besides, what the test publishes, calls
    or sends as a goal, right after a step whose result it does not use, may come before what is due at that instant.
    Raises TypeError for a test without
    ``start_node``, and ValueError as :func:`explore` does, or if the ``schedule`` is none of this test.
    """
    _refuse(schedules, strategy, seed)
    if schedule:
        deep = Order.of(schedule).deep

    def decorate(test: Callable[..., None]) -> Callable[..., None]:
        if "start_node" not in inspect.signature(test).parameters:
            raise TypeError(f"{getattr(test, '__name__', 'an explored test')} has to take the fixture start_node")
        if inspect.iscoroutinefunction(test) or inspect.isgeneratorfunction(test):
            raise TypeError(f"{test.__name__} is a coroutine or a generator, which pytest does not run as a test")

        @functools.wraps(test)
        def run(*args: Any, start_node: Any, **fixtures: Any) -> None:
            __tracebackhide__ = True

            acts: set[int] | None = None  # as in the usual order, which comes first

            def attempt(order: Order) -> BaseException | None:
                nonlocal acts
                order.acts = acts
                try:
                    with start_node.in_order(order):
                        test(*args, start_node=start_node, **fixtures)
                except start_node.failures as error:
                    return error  # type: ignore[no-any-return]
                finally:
                    acts = order.acted if acts is None else acts
                return None

            said = "the order of its schedule"
            if schedule:
                order = Order.of(schedule)
            else:
                found = search(attempt, schedules, strategy, seed, deep, one_by_one(attempt))
                if found.order is None:
                    return
                order, said = Order(found.order.made, deep=deep), found.said
            start_node.order = order
            try:
                test(*args, start_node=start_node, **fixtures)
                start_node.end()
            except start_node.failures as error:
                error.add_note(
                    f'in {said}; to run the test in this order alone: @rosspin.explored(schedule="{order.token}")'
                )
                raise
            order.has_to_fit()

        return run

    return decorate
