"""Clients of actions in ROS 1 (sources: actionlib/action_client.py and simple_action_client.py 1.14.0)."""

from __future__ import annotations

import threading
import time
import weakref
from collections.abc import Callable
from importlib import import_module
from typing import Any

from ..world.world import World, current_world
from .client import get_param
from .core import is_shutdown, logdebug, logerr, logwarn
from .names import get_name, remap_name, resolve_name
from .rostime import Duration, Time, get_rostime
from .topics import Publisher, Subscriber

__all__ = [
    "ActionClient",
    "ActionException",
    "ClientGoalHandle",
    "CommState",
    "CommStateMachine",
    "GoalManager",
    "SimpleActionClient",
    "SimpleGoalState",
    "TerminalState",
    "get_name_of_constant",
    "parts_of",
    "statuses",
]

_LOOK = 0.01  # s between two looks for a server
_WAKE = Duration(0.1)  # for how long a client that waits for a result sleeps


class ActionException(Exception):
    """A class is not an action's."""


def get_name_of_constant(C: Any, n: int) -> str:
    """The name of a class's first integer of this value."""
    names = (name for name, value in vars(C).items() if isinstance(value, int) and value == n)
    return next(names, f"NO_SUCH_STATE_{n}")


class _Named:
    @classmethod
    def to_string(cls, n: int) -> str:
        """The name of a state."""
        return get_name_of_constant(cls, n)


class CommState(_Named):
    """What a client knows of a goal."""

    WAITING_FOR_GOAL_ACK = 0
    PENDING = 1
    ACTIVE = 2
    WAITING_FOR_RESULT = 3
    WAITING_FOR_CANCEL_ACK = 4
    RECALLING = 5
    PREEMPTING = 6
    DONE = 7
    LOST = 8


class TerminalState(_Named):
    """How a goal ends; the numbers are actionlib_msgs/GoalStatus's."""

    RECALLED = 8
    REJECTED = 5
    PREEMPTED = 2
    ABORTED = 4
    SUCCEEDED = 3
    LOST = 9


class SimpleGoalState(_Named):
    """What a simple client knows of its goal."""

    PENDING = 0
    ACTIVE = 1
    DONE = 2


def statuses() -> Any:
    """The class of actionlib_msgs/GoalStatus; whoever imports actionlib gives it ``to_string``."""
    status = import_module("actionlib_msgs.msg").GoalStatus
    status.to_string = classmethod(get_name_of_constant)
    return status


def parts_of(spec: Any) -> tuple[Any, Any, Any]:
    """The classes of an action's goal, result and feedback, as they are sent. Raises ActionException."""
    try:
        action = spec()
        return type(action.action_goal), type(action.action_result), type(action.action_feedback)
    except AttributeError:
        raise ActionException(f"Type is not an action spec: {spec}") from None


_ACK, _PENDING, _ACTIVE, _RESULT, _CANCEL, _RECALLING, _PREEMPTING, _DONE, _ = range(9)  # of CommState

# By what is known of a goal and by its new status (its number in GoalStatus): the states to go through. What is not
# here is an error.
_ENDS_LATE = {2: (_PREEMPTING, _RESULT), 3: (_PREEMPTING, _RESULT), 4: (_PREEMPTING, _RESULT)}
_BEGINS = {
    2: (_ACTIVE, _PREEMPTING, _RESULT),
    3: (_ACTIVE, _RESULT),
    4: (_ACTIVE, _RESULT),
    6: (_ACTIVE, _PREEMPTING),
}
_TRANSITIONS: dict[int, dict[int, tuple[int, ...]]] = {
    _ACK: {
        **{0: (_PENDING,), 1: (_ACTIVE,), 5: (_PENDING, _RESULT), 7: (_PENDING, _RECALLING), 8: (_PENDING, _RESULT)},
        **_BEGINS,
    },
    _PENDING: {0: (), 1: (_ACTIVE,), 5: (_RESULT,), 7: (_RECALLING,), 8: (_RECALLING, _RESULT), **_BEGINS},
    _ACTIVE: {1: (), 2: (_PREEMPTING, _RESULT), 3: (_RESULT,), 4: (_RESULT,), 6: (_PREEMPTING,)},
    _RESULT: dict.fromkeys((1, 5, 8, 2, 3, 4), ()),
    _CANCEL: {
        **{0: (), 1: (), 5: (_RESULT,), 7: (_RECALLING,), 8: (_RECALLING, _RESULT), 6: (_PREEMPTING,)},
        **_ENDS_LATE,
    },
    _RECALLING: {5: (_RESULT,), 7: (), 8: (_RESULT,), 6: (_PREEMPTING,), **_ENDS_LATE},
    _PREEMPTING: {2: (_RESULT,), 3: (_RESULT,), 4: (_RESULT,), 6: ()},
    _DONE: dict.fromkeys((5, 8, 2, 3, 4), ()),
}
_LAST_STATUS = 8


class ClientGoalHandle:
    """A goal that a client has sent."""

    def __init__(self, comm_state_machine: CommStateMachine) -> None:
        self.comm_state_machine = comm_state_machine

    def __eq__(self, o: Any) -> bool:
        return bool(o) and self.comm_state_machine == o.comm_state_machine

    def __hash__(self) -> int:
        return hash(self.comm_state_machine)

    def cancel(self) -> None:
        """Ask the server to cancel the goal."""
        machine = self.comm_state_machine
        with machine.mutex:
            cancel = import_module("actionlib_msgs.msg").GoalID(stamp=Time(0), id=machine.action_goal.goal_id.id)
            machine.send_cancel_fn(cancel)
            machine.transition_to(CommState.WAITING_FOR_CANCEL_ACK)

    def get_comm_state(self) -> int:
        """What is known of the goal, as in CommState."""
        return self.comm_state_machine.state

    def get_goal_status(self) -> int:
        """The last status that has come, as in GoalStatus."""
        return int(self.comm_state_machine.latest_goal_status.status)

    def get_goal_status_text(self) -> str:
        """The text with it."""
        return str(self.comm_state_machine.latest_goal_status.text)

    def get_result(self) -> Any:
        """The result; None if none has come."""
        latest = self.comm_state_machine.latest_result
        return latest.result if latest else None

    def get_terminal_state(self) -> int:
        """How the goal has ended, as in GoalStatus; LOST if it has not."""
        machine = self.comm_state_machine
        with machine.mutex:
            if machine.state != CommState.DONE:
                logwarn("Asking for the terminal state when we're in [%s]", CommState.to_string(machine.state))
            status = int(machine.latest_goal_status.status)
            if status in vars(TerminalState).values():
                return status
            logerr("Asking for a terminal state, but the goal status is %d", status)
            return TerminalState.LOST


class CommStateMachine:
    """What a client knows of one goal, and whom it tells."""

    def __init__(
        self,
        action_goal: Any,
        transition_cb: Callable[[ClientGoalHandle], Any] | None,
        feedback_cb: Callable[[ClientGoalHandle, Any], Any] | None,
        send_goal_fn: Callable[[Any], Any] | None,
        send_cancel_fn: Callable[[Any], Any],
    ) -> None:
        self.action_goal = action_goal
        self.transition_cb = transition_cb
        self.feedback_cb = feedback_cb
        self.send_goal_fn = send_goal_fn
        self.send_cancel_fn = send_cancel_fn
        self.state = CommState.WAITING_FOR_GOAL_ACK
        self.mutex = threading.RLock()
        status = statuses()
        self.latest_goal_status = status(status=status.PENDING)
        self.latest_result: Any = None

    def __eq__(self, o: Any) -> bool:
        return bool(self.action_goal.goal_id.id == o.action_goal.goal_id.id)

    def __hash__(self) -> int:
        return hash(self.action_goal.goal_id.id)

    def set_state(self, state: int) -> None:
        """Set the state, and tell no one."""
        logdebug("Transitioning CommState from %s to %s", CommState.to_string(self.state), CommState.to_string(state))
        self.state = state

    def update_status(self, status_array: Any) -> None:
        """Take what a server says of its goals."""
        with self.mutex:
            if self.state == CommState.DONE:
                return
            own = self.action_goal.goal_id.id
            status = next((each for each in status_array.status_list if each.goal_id.id == own), None)
            if not status:
                if self.state not in (CommState.WAITING_FOR_GOAL_ACK, CommState.WAITING_FOR_RESULT):
                    self.latest_goal_status.status = statuses().LOST
                    self.transition_to(CommState.DONE)
                return
            self.latest_goal_status = status
            if status.status > _LAST_STATUS:
                logerr(f"Got an unknown status from the ActionServer: {status.status}")
                return
            steps = _TRANSITIONS[self.state].get(status.status)
            if steps is None:
                before, after = CommState.to_string(self.state), statuses().to_string(status.status)
                logerr(f"Invalid goal status transition from {before} to {after}")
            for state in steps or ():
                self.transition_to(state)

    def transition_to(self, state: int) -> None:
        """Set the state, and tell who wants to know."""
        names = CommState.to_string(state), CommState.to_string(self.state), self.action_goal.goal_id.id
        logdebug("Transitioning to %s (from %s, goal: %s)", *names)
        self.state = state
        if self.transition_cb:
            self.transition_cb(ClientGoalHandle(self))

    def update_result(self, action_result: Any) -> None:
        """Take a result, if it is this goal's."""
        if self.action_goal.goal_id.id != action_result.status.goal_id.id:
            return
        with self.mutex:
            self.latest_goal_status = action_result.status
            self.latest_result = action_result
            if self.state == CommState.DONE:
                logerr("Got a result when we were already in the DONE state")
                return
            self.update_status(import_module("actionlib_msgs.msg").GoalStatusArray(status_list=[action_result.status]))
            self.transition_to(CommState.DONE)

    def update_feedback(self, action_feedback: Any) -> None:
        """Take feedback, if it is this goal's."""
        if self.action_goal.goal_id.id != action_feedback.status.goal_id.id:
            return
        if self.feedback_cb and self.state != CommState.DONE:
            self.feedback_cb(ClientGoalHandle(self), action_feedback.feedback)


class _Count:
    """Of a node: how many goals it has sent."""

    ROS = 1

    def __init__(self, world: World) -> None:
        self.goals = 0


class GoalManager:
    """The goals of a client that are still referred to."""

    def __init__(self, ActionSpec: Any) -> None:
        self.list_mutex = threading.RLock()
        self.statuses: list[Any] = []  # weak references to the goals' machines
        self.send_goal_fn: Callable[[Any], Any] | None = None
        self.ActionGoal, self.ActionResult, self.ActionFeedback = parts_of(ActionSpec)
        self.ActionSpec = ActionSpec

    def register_send_goal_fn(self, fn: Callable[[Any], Any]) -> None:
        """Have ``fn`` send goals."""
        self.send_goal_fn = fn

    def register_cancel_fn(self, fn: Callable[[Any], Any]) -> None:
        """Have ``fn`` send what cancels them."""
        self.cancel_fn = fn

    def init_goal(self, goal: Any, transition_cb: Any = None, feedback_cb: Any = None) -> ClientGoalHandle:
        """Send a goal."""
        count = current_world().part(_Count)
        count.goals += 1
        now = Time.now()
        name = f"{get_name()}-{count.goals}-{now.to_sec():.3f}"
        goal_id = import_module("actionlib_msgs.msg").GoalID(id=name, stamp=now)
        header = import_module("std_msgs.msg").Header(stamp=get_rostime())
        action_goal = self.ActionGoal(header=header, goal_id=goal_id, goal=goal)
        machine = CommStateMachine(action_goal, transition_cb, feedback_cb, self.send_goal_fn, self.cancel_fn)
        with self.list_mutex:
            self.statuses.append(weakref.ref(machine))
        assert self.send_goal_fn
        self.send_goal_fn(action_goal)
        return ClientGoalHandle(machine)

    def _live(self) -> list[CommStateMachine]:
        with self.list_mutex:
            return [machine for each in self.statuses if (machine := each())]

    def update_statuses(self, status_array: Any) -> None:
        """Take what a server says of its goals."""
        with self.list_mutex:
            self.statuses = [each for each in self.statuses if each()]
        for machine in self._live():
            machine.update_status(status_array)

    def update_results(self, action_result: Any) -> None:
        """Take a result."""
        for machine in self._live():
            machine.update_result(action_result)

    def update_feedbacks(self, action_feedback: Any) -> None:
        """Take feedback."""
        for machine in self._live():
            machine.update_feedback(action_feedback)


class ActionClient:
    """Sends goals to the action ``ns``, whose type is ``ActionSpec``, such as FibonacciAction.

    Raises ActionException for a class that is not an action's.
    """

    def __init__(self, ns: str, ActionSpec: Any) -> None:
        self.ns = ns
        self.last_status_msg: Any = None
        self.ActionGoal, self.ActionResult, self.ActionFeedback = parts_of(ActionSpec)
        self.ActionSpec = ActionSpec
        messages = import_module("actionlib_msgs.msg")
        statuses()
        size = get_param("actionlib_client_pub_queue_size", 10)
        self.pub_queue_size = size if size >= 0 else 10
        base = remap_name(ns)
        self.pub_goal = Publisher(f"{base}/goal", self.ActionGoal, queue_size=self.pub_queue_size)
        self.pub_cancel = Publisher(f"{base}/cancel", messages.GoalID, queue_size=self.pub_queue_size)
        self.manager = GoalManager(ActionSpec)
        self.manager.register_send_goal_fn(self.pub_goal.publish)
        self.manager.register_cancel_fn(self.pub_cancel.publish)
        size = get_param("actionlib_client_sub_queue_size", -1)
        self.sub_queue_size = size if size >= 0 else None
        more: dict[str, Any] = {"queue_size": self.sub_queue_size}
        self.status_sub = Subscriber(f"{base}/status", messages.GoalStatusArray, callback=self._status_cb, **more)
        self.result_sub = Subscriber(f"{base}/result", self.ActionResult, callback=self._result_cb, **more)
        self.feedback_sub = Subscriber(f"{base}/feedback", self.ActionFeedback, callback=self._feedback_cb, **more)

    def stop(self) -> None:
        """Send and hear no more."""
        for each in (self.pub_goal, self.pub_cancel, self.status_sub, self.result_sub, self.feedback_sub):
            each.unregister()

    def send_goal(self, goal: Any, transition_cb: Any = None, feedback_cb: Any = None) -> ClientGoalHandle:
        """Send a goal.

        ``transition_cb(handle)`` is told of each state, ``feedback_cb(handle, feedback)`` of feedback.
        """
        return self.manager.init_goal(goal, transition_cb, feedback_cb)

    def cancel_all_goals(self) -> None:
        """Ask the server to cancel all of its goals."""
        self.cancel_goals_at_and_before_time(Time.from_sec(0.0))

    def cancel_goals_at_and_before_time(self, time: Any) -> None:
        """Ask the server to cancel all goals that are not later than ``time``."""
        self.pub_cancel.publish(import_module("actionlib_msgs.msg").GoalID(stamp=time, id=""))

    def wait_for_server(self, timeout: Duration = Duration(0.0)) -> bool:
        """Wait until a server is connected, for at most ``timeout`` (0: no limit). Return whether one is."""
        end = get_rostime() + timeout
        while not is_shutdown():
            if self.last_status_msg and self._is_connected(self.last_status_msg._connection_header["callerid"]):
                return True
            if timeout != Duration(0.0) and get_rostime() >= end:
                return False
            time.sleep(_LOOK)
        return False

    def wait_for_action_server_to_start(self, timeout: Duration = Duration(0.0)) -> bool:
        """The old name of ``wait_for_server``."""
        return self.wait_for_server(timeout)

    def _is_connected(self, server: str) -> bool:
        hears = [[each.subscription.node.name for each in _of(end)] for end in (self.pub_goal, self.pub_cancel)]
        tells = [[each.publication.node.name for each in _of(end)] for end in (self.result_sub, self.feedback_sub)]
        return all(server in names for names in (*hears, *tells))

    def _status_cb(self, msg: Any) -> None:
        self.last_status_msg = msg
        self.manager.update_statuses(msg)

    def _result_cb(self, msg: Any) -> None:
        self.manager.update_results(msg)

    def _feedback_cb(self, msg: Any) -> None:
        self.manager.update_feedbacks(msg)


def _of(end: Any) -> Any:
    """The connections of a publisher or subscriber."""
    return end.impl.connections


class SimpleActionClient:
    """Sends goals to the action ``ns``, and follows the last one."""

    def __init__(self, ns: str, ActionSpec: Any) -> None:
        self.action_client = ActionClient(ns, ActionSpec)
        self.simple_state = SimpleGoalState.DONE
        self.gh: ClientGoalHandle | None = None
        self.done_condition = threading.Condition()

    def wait_for_server(self, timeout: Duration = Duration()) -> bool:
        """Wait until a server is connected, for at most ``timeout`` (0: no limit). Return whether one is."""
        return self.action_client.wait_for_server(timeout)

    def send_goal(self, goal: Any, done_cb: Any = None, active_cb: Any = None, feedback_cb: Any = None) -> None:
        """Send a goal, and forget the one before, which continues.

        ``done_cb(status, result)``, ``active_cb()`` and ``feedback_cb(feedback)`` are told of it.
        """
        self.stop_tracking_goal()
        self.done_cb = done_cb
        self.active_cb = active_cb
        self.feedback_cb = feedback_cb
        self.simple_state = SimpleGoalState.PENDING
        self.gh = self.action_client.send_goal(goal, self._handle_transition, self._handle_feedback)

    def send_goal_and_wait(
        self, goal: Any, execute_timeout: Duration = Duration(), preempt_timeout: Duration = Duration()
    ) -> int:
        """Send a goal and wait; cancel it after ``execute_timeout``, and wait again. Return its status."""
        self.send_goal(goal)
        if not self.wait_for_result(execute_timeout):
            logdebug("Canceling goal")
            self.cancel_goal()
            finished = "finished within" if self.wait_for_result(preempt_timeout) else "didn't finish"
            logdebug(f"Preempt {finished} specified preempt_timeout [%.2f]", preempt_timeout.to_sec())
        return self.get_state()

    def wait_for_result(self, timeout: Duration = Duration()) -> bool:
        """Wait until the goal is done, for at most ``timeout`` (0: no limit). Return whether it is."""
        if not self.gh:
            logerr("Called wait_for_result when no goal exists")
            return False
        end = get_rostime() + timeout
        with self.done_condition:
            while not is_shutdown() and self.simple_state != SimpleGoalState.DONE:
                left = end - get_rostime()
                if timeout > Duration(0.0) and left <= Duration(0.0):
                    break
                if left > _WAKE or timeout == Duration():
                    left = _WAKE
                self.done_condition.wait(left.to_sec())
        return self.simple_state == SimpleGoalState.DONE

    def get_result(self) -> Any:
        """The goal's result; None if none has come."""
        if not self.gh:
            logerr("Called get_result when no goal is running")
            return None
        return self.gh.get_result()

    def get_state(self) -> int:
        """The goal's status, as in GoalStatus: RECALLING as PENDING, PREEMPTING as ACTIVE, LOST without a goal."""
        status = statuses()
        if not self.gh:
            return int(status.LOST)
        state = self.gh.get_goal_status()
        return int({status.RECALLING: status.PENDING, status.PREEMPTING: status.ACTIVE}.get(state, state))

    def get_goal_status_text(self) -> str:
        """The text that the server has sent with the status."""
        if not self.gh:
            logerr("Called get_goal_status_text when no goal is running")
            return "ERROR: Called get_goal_status_text when no goal is running"
        return self.gh.get_goal_status_text()

    def cancel_all_goals(self) -> None:
        """Ask the server to cancel all of its goals."""
        self.action_client.cancel_all_goals()

    def cancel_goals_at_and_before_time(self, time: Any) -> None:
        """Ask the server to cancel all goals that are not later than ``time``."""
        self.action_client.cancel_goals_at_and_before_time(time)

    def cancel_goal(self) -> None:
        """Ask the server to cancel the goal."""
        if self.gh:
            self.gh.cancel()

    def stop_tracking_goal(self) -> None:
        """Forget the goal, which continues."""
        self.gh = None

    def _handle_transition(self, gh: ClientGoalHandle) -> None:
        if gh != self.gh:
            logerr("Got a transition callback on a goal handle that we're not tracking")
            return
        state, simple = gh.get_comm_state(), self.simple_state
        error = (
            f"Received comm state {CommState.to_string(state)} when in simple state "
            f"{SimpleGoalState.to_string(simple)} with SimpleActionClient in NS {resolve_name(self.action_client.ns)}"
        )
        if state in (CommState.ACTIVE, CommState.PREEMPTING):
            if simple == SimpleGoalState.PENDING:
                self._set_simple_state(SimpleGoalState.ACTIVE)
                if self.active_cb:
                    self.active_cb()
            elif simple == SimpleGoalState.DONE:
                logerr(error)
        elif state == CommState.RECALLING and simple != SimpleGoalState.PENDING:
            logerr(error)
        elif state == CommState.DONE:
            if simple == SimpleGoalState.DONE:
                logerr("SimpleActionClient received DONE twice")
                return
            if self.done_cb:
                self.done_cb(gh.get_goal_status(), gh.get_result())
            with self.done_condition:
                self._set_simple_state(SimpleGoalState.DONE)
                self.done_condition.notify_all()

    def _handle_feedback(self, gh: ClientGoalHandle, feedback: Any) -> None:
        if not self.gh:
            return
        if gh != self.gh:
            own, other = (each.comm_state_machine.action_goal.goal_id.id for each in (self.gh, gh))
            logerr(f"Got a feedback callback on a goal handle that we're not tracking. {own} vs {other}")
            return
        if self.feedback_cb:
            self.feedback_cb(feedback)

    def _set_simple_state(self, state: int) -> None:
        self.simple_state = state
