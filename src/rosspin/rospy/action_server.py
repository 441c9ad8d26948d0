"""Servers of actions in ROS 1 (sources: actionlib/action_server.py and simple_action_server.py 1.14.0)."""

from __future__ import annotations

import threading
from collections.abc import Callable
from importlib import import_module
from typing import Any

from ..clocks.frames import format_error
from ..world.world import World, current_world
from .action_client import parts_of, statuses
from .client import get_param, has_param, search_param
from .core import is_shutdown, logdebug, logerr, logwarn
from .names import get_name, remap_name
from .rostime import Duration, Time
from .timer import Timer
from .topics import Publisher, Subscriber

__all__ = ["ActionServer", "GoalIDGenerator", "ServerGoalHandle", "SimpleActionServer", "StatusTracker", "nop_cb"]

_ANOTHER = "This goal was canceled because another goal was received by the simple action server"
_TOO_OLD = (
    "This goal handle was canceled by the action server because its timestamp is before the timestamp of the last "
    "cancel request"
)
_WAKE = Duration(0.1)  # for how long the thread of a simple server sleeps


class _Count:
    """Of a node: how many names it has made."""

    ROS = 1

    def __init__(self, world: World) -> None:
        self.names = 0


class GoalIDGenerator:
    """Makes names of goals that no one else has."""

    def __init__(self, name: str | None = None) -> None:
        self.set_name(get_name() if name is None else name)

    def set_name(self, name: str) -> None:
        """Set what the names begin with: the node's."""
        self.name = name

    def generate_ID(self) -> Any:
        """Make an actionlib_msgs/GoalID."""
        count = current_world().part(_Count)
        count.names += 1
        now = Time.now()
        name = f"{self.name}-{count.names}-{now.secs}.{now.nsecs}"
        return import_module("actionlib_msgs.msg").GoalID(id=name, stamp=now)


class StatusTracker:
    """What a server knows of a goal, or of one that was cancelled before it came."""

    def __init__(self, goal_id: Any = None, status: Any = None, goal: Any = None) -> None:
        self.goal = None
        self.handle_tracker: Any = None
        self.status = statuses()()
        self.handle_destruction_time = Time()
        self.id_generator = GoalIDGenerator()
        if goal_id:
            self.status.goal_id = goal_id
            self.status.status = status
            return
        self.goal = goal
        self.status.goal_id = goal.goal_id
        self.status.status = self.status.PENDING
        if self.status.goal_id.id == "":
            self.status.goal_id = self.id_generator.generate_ID()
        if self.status.goal_id.stamp == Time():
            self.status.goal_id.stamp = Time.now()


def _set(past: str, first: str, state: str, states: dict[str, str], needed: str) -> Callable[..., None]:
    """Make a method that ends a goal: by its status, the one that it then has."""

    def end(self: ServerGoalHandle, result: Any = None, text: str = "") -> None:
        if not result:
            result = self.get_default_result()
        self._log(f"Setting status to {past} on goal")
        if not self.goal:
            logerr("Attempt to set status on an uninitialized ServerGoalHandle")
            return
        with self.action_server.lock:
            status = self.status_tracker.status
            for before, after in states.items():
                if status.status == getattr(status, before):
                    status.status = getattr(status, after)
                    status.text = text
                    self.status_tracker.handle_destruction_time = Time.now()
                    self.action_server.publish_result(status, result)
                    return
            what = f"To transition to {first} {state} state, the goal must be in a {needed} state"
            logerr(f"{what}, it is currently in state: %d", status.status)

    end.__doc__ = f"End the goal as {past}, with a result and a text."
    return end


class ServerGoalHandle:
    """A goal that a server has. Two are equal if they are of the same goal."""

    def __init__(self, status_tracker: Any = None, action_server: Any = None, handle_tracker: Any = None) -> None:
        self.status_tracker = status_tracker
        self.action_server = action_server
        self.handle_tracker = handle_tracker
        self.goal = status_tracker.goal if status_tracker else None

    def get_default_result(self) -> Any:
        """An empty message in which a result is sent."""
        return self.action_server.ActionResultType()

    def _log(self, what: str) -> None:
        named = self.get_goal_id()
        logdebug(f"{what}, id: %s, stamp: %.2f", named.id, named.stamp.to_sec())

    def set_accepted(self, text: str = "") -> None:
        """Accept the goal."""
        self._log("Accepting goal")
        if not self.goal:
            logerr("Attempt to set status on an uninitialized ServerGoalHandle")
            return
        with self.action_server.lock:
            status = self.status_tracker.status
            after = {status.PENDING: status.ACTIVE, status.RECALLING: status.PREEMPTING}.get(status.status)
            if after is None:
                logerr(
                    "To transition to an active state, the goal must be in a pending or recalling state, it is "
                    "currently in state: %d",
                    status.status,
                )
                return
            status.status, status.text = after, text
            self.action_server.publish_status()

    set_canceled = _set(
        *("canceled", "a", "cancelled"),
        {"PENDING": "RECALLED", "RECALLING": "RECALLED", "ACTIVE": "PREEMPTED", "PREEMPTING": "PREEMPTED"},
        "pending, recalling, active, or preempting",
    )
    set_rejected = _set(
        *("rejected", "a", "rejected"), {"PENDING": "REJECTED", "RECALLING": "REJECTED"}, "pending or recalling"
    )
    set_aborted = _set(
        *("aborted", "an", "aborted"), {"PREEMPTING": "ABORTED", "ACTIVE": "ABORTED"}, "preempting or active"
    )
    set_succeeded = _set(
        *("succeeded", "a", "succeeded"), {"PREEMPTING": "SUCCEEDED", "ACTIVE": "SUCCEEDED"}, "preempting or active"
    )

    def publish_feedback(self, feedback: Any) -> None:
        """Send feedback."""
        self._log("Publishing feedback for goal")
        if self.goal:
            with self.action_server.lock:
                self.action_server.publish_feedback(self.status_tracker.status, feedback)
        else:
            logerr("Attempt to publish feedback on an uninitialized ServerGoalHandle")

    def get_goal(self) -> Any:
        """What is asked for; None for a goal that has not come."""
        return self.goal.goal if self.goal else None

    def get_goal_id(self) -> Any:
        """Its actionlib_msgs/GoalID."""
        if self.goal:
            with self.action_server.lock:
                return self.status_tracker.status.goal_id
        logerr("Attempt to get a goal id on an uninitialized ServerGoalHandle")
        return import_module("actionlib_msgs.msg").GoalID()

    def get_goal_status(self) -> Any:
        """Its actionlib_msgs/GoalStatus."""
        if self.goal:
            with self.action_server.lock:
                return self.status_tracker.status
        logerr("Attempt to get goal status on an uninitialized ServerGoalHandle")
        return statuses()()

    def __eq__(self, other: Any) -> bool:
        return bool(self.goal and other.goal and self.get_goal_id().id == other.get_goal_id().id)

    def __hash__(self) -> int:
        return hash(self.get_goal_id().id)

    def set_cancel_requested(self) -> bool:
        """Note that a client wants it cancelled. Return whether that is news."""
        self._log("Transisitoning to a cancel requested state on goal")
        if not self.goal:
            return False
        with self.action_server.lock:
            status = self.status_tracker.status
            after = {status.PENDING: status.RECALLING, status.ACTIVE: status.PREEMPTING}.get(status.status)
            if after is None:
                return False
            status.status = after
            self.action_server.publish_status()
            return True


def nop_cb(goal_handle: ServerGoalHandle) -> None:
    """Do nothing."""


class ActionServer:
    """Receives goals for the action ``ns``, whose type is ``ActionSpec``, such as FibonacciAction.

    ``goal_cb(handle)`` is called for each goal, ``cancel_cb(handle)`` for each that should be cancelled. Raises
    ActionException for a class that is not an action's.
    """

    def __init__(
        self,
        ns: str,
        ActionSpec: Any,
        goal_cb: Any,
        cancel_cb: Callable[[ServerGoalHandle], Any] = nop_cb,
        auto_start: bool = True,
    ) -> None:
        self.ns = ns
        self.ActionGoal, self.ActionResult, self.ActionFeedback = parts_of(ActionSpec)
        self.ActionSpec = ActionSpec
        self.ActionResultType = type(self.ActionResult().result)
        self.goal_sub: Any = None
        self.cancel_sub: Any = None
        self.status_pub: Any = None
        self.result_pub: Any = None
        self.feedback_pub: Any = None
        self.lock = threading.RLock()
        self.status_timer: Any = None
        self.status_list: list[StatusTracker] = []
        self.last_cancel = Time()
        self.status_list_timeout = Duration()
        self.id_generator = GoalIDGenerator()
        assert goal_cb
        self.goal_callback: Callable[[ServerGoalHandle], Any] = goal_cb
        self.cancel_callback = cancel_cb
        self.auto_start = auto_start
        self.started = False
        if auto_start:
            logwarn(
                "You've passed in true for auto_start to the python action server, you should always pass in false to "
                "avoid race conditions."
            )
            self.start()

    def register_goal_callback(self, cb: Callable[[ServerGoalHandle], Any]) -> None:
        """Have another function called for each goal."""
        self.goal_callback = cb

    def register_cancel_callback(self, cancel_cb: Callable[[ServerGoalHandle], Any]) -> None:
        """Have another function called for each goal that should be cancelled."""
        self.cancel_callback = cancel_cb

    def start(self) -> None:
        """Begin to take goals, and to say how they are."""
        with self.lock:
            self.initialize()
            self.started = True
            self.publish_status()

    def stop(self) -> None:
        """Take no more goals."""
        with self.lock:
            self.started = False
            self.status_timer.shutdown()
            for each in (self.goal_sub, self.cancel_sub, self.status_pub, self.feedback_pub, self.result_pub):
                each.unregister()

    def initialize(self) -> None:
        """Make the topics and the timer."""
        messages = import_module("actionlib_msgs.msg")
        base = remap_name(self.ns)
        size = get_param("actionlib_server_pub_queue_size", 50)
        self.pub_queue_size = size if size >= 0 else 50
        more: dict[str, Any] = {"queue_size": self.pub_queue_size}
        self.status_pub = Publisher(f"{base}/status", messages.GoalStatusArray, latch=True, **more)
        self.result_pub = Publisher(f"{base}/result", self.ActionResult, **more)
        self.feedback_pub = Publisher(f"{base}/feedback", self.ActionFeedback, **more)
        size = get_param("actionlib_server_sub_queue_size", -1)
        self.sub_queue_size = size if size >= 0 else None
        more = {"queue_size": self.sub_queue_size}
        self.goal_sub = Subscriber(f"{base}/goal", self.ActionGoal, callback=self.internal_goal_callback, **more)
        self.cancel_sub = Subscriber(f"{base}/cancel", messages.GoalID, callback=self.internal_cancel_callback, **more)
        if has_param(f"{base}/status_frequency"):
            self.status_frequency = get_param(f"{base}/status_frequency", 5.0)
            logwarn(
                "You're using the deprecated status_frequency parameter, please switch to actionlib_status_frequency."
            )
        else:
            name = search_param("actionlib_status_frequency")
            self.status_frequency = 5.0 if name is None else get_param(name, 5.0)
        self.status_list_timeout = Duration(get_param(f"{base}/status_list_timeout", 5.0))
        if self.status_frequency > 0.0:
            self.status_timer = Timer(Duration(1.0 / self.status_frequency), self.publish_status_async)

    def publish_result(self, status: Any, result: Any) -> None:
        """Send a result."""
        with self.lock:
            message = self.ActionResult(status=status, result=result)
            message.header.stamp = Time.now()
            if not is_shutdown():
                self.result_pub.publish(message)
            self.publish_status()

    def publish_feedback(self, status: Any, feedback: Any) -> None:
        """Send feedback."""
        with self.lock:
            message = self.ActionFeedback(status=status, feedback=feedback)
            message.header.stamp = Time.now()
            if not is_shutdown():
                self.feedback_pub.publish(message)

    def internal_cancel_callback(self, goal_id: Any) -> None:
        """Take a request to cancel: one goal by its name, all up to a time, or all."""
        with self.lock:
            if not self.started:
                return
            logdebug("The action server has received a new cancel request")
            found = False
            for tracker in self.status_list[:]:
                named = tracker.status.goal_id
                everything = goal_id.id == "" and goal_id.stamp == Time()
                before = goal_id.stamp != Time() and named.stamp <= goal_id.stamp
                if everything or before or goal_id.id == named.id:
                    found = found or goal_id.id == named.id
                    if tracker.handle_tracker is None:
                        tracker.handle_tracker = object()
                        tracker.handle_destruction_time = Time.now()
                    handle = ServerGoalHandle(tracker, self, tracker.handle_tracker)
                    if handle.set_cancel_requested():
                        self.cancel_callback(handle)
            if goal_id.id != "" and not found:
                tracker = StatusTracker(goal_id, statuses().RECALLING)
                self.status_list.append(tracker)
                tracker.handle_destruction_time = Time.now()
            if goal_id.stamp > self.last_cancel:
                self.last_cancel = goal_id.stamp

    def internal_goal_callback(self, goal: Any) -> None:
        """Take a goal."""
        with self.lock:
            if not self.started:
                return
            logdebug("The action server has received a new goal request")
            for tracker in self.status_list[:]:
                status = tracker.status
                if goal.goal_id.id == status.goal_id.id:
                    logdebug(f"Goal {goal.goal_id.id} was already in the status list with status {status.status}")
                    if status.status == status.RECALLING:
                        status.status = status.RECALLED
                        self.publish_result(status, self.ActionResultType())
                    if tracker.handle_tracker is None:
                        tracker.handle_destruction_time = Time.now()
                    return
            tracker = StatusTracker(None, None, goal)
            self.status_list.append(tracker)
            tracker.handle_tracker = object()
            handle = ServerGoalHandle(tracker, self, tracker.handle_tracker)
            if goal.goal_id.stamp != Time() and goal.goal_id.stamp <= self.last_cancel:
                handle.set_canceled(None, _TOO_OLD)
            else:
                self.goal_callback(handle)

    def publish_status_async(self, event: Any) -> None:
        """Say how the goals are, when the timer wants it."""
        with self.lock:
            if self.started:
                self.publish_status()

    def publish_status(self) -> None:
        """Say how the goals are; forget those that ended long ago."""
        with self.lock:
            now = Time.now()
            for tracker in self.status_list[:]:
                ended = tracker.handle_destruction_time
                if ended != Time() and ended + self.status_list_timeout < now:
                    what = f"Item {tracker.status.goal_id} with destruction time of {ended.to_sec():.3f}"
                    logdebug(f"{what} being removed from list.  Now = {now.to_sec():.3f}")
                    self.status_list.remove(tracker)
            message = import_module("actionlib_msgs.msg").GoalStatusArray()
            message.status_list = [tracker.status for tracker in self.status_list]
            message.header.stamp = now
            if not is_shutdown():
                self.status_pub.publish(message)


class SimpleActionServer:
    """Has one goal at a time: a later one preempts it, and so does a request to cancel.

    ``execute_cb(goal)`` is called in a thread of its own. Without it, use ``register_goal_callback`` and
    ``accept_new_goal``.
    """

    def __init__(self, name: str, ActionSpec: Any, execute_cb: Any = None, auto_start: bool = True) -> None:
        self.new_goal = False
        self.preempt_request = False
        self.new_goal_preempt_request = False
        self.execute_callback = execute_cb
        self.goal_callback: Any = None
        self.preempt_callback: Any = None
        self.need_to_terminate = False
        self.terminate_mutex = threading.RLock()
        self.lock = threading.RLock()
        self.execute_condition = threading.Condition(self.lock)
        self.current_goal = ServerGoalHandle()
        self.next_goal = ServerGoalHandle()
        self.execute_thread: threading.Thread | None = None
        if execute_cb:
            self.execute_thread = threading.Thread(None, self.executeLoop)
            self.execute_thread.start()
        given = self.internal_goal_callback, self.internal_preempt_callback
        self.action_server = ActionServer(name, ActionSpec, *given, auto_start)

    def start(self) -> None:
        """Begin to take goals."""
        self.action_server.start()

    def accept_new_goal(self) -> Any:
        """Accept the goal that waits, and cancel the one that is active. Return it; None if none waits."""
        with self.action_server.lock, self.lock:
            if not self.new_goal or not self.next_goal.get_goal():
                logerr("Attempting to accept the next goal when a new goal is not available")
                return None
            if self.is_active() and self.current_goal.get_goal() and self.current_goal != self.next_goal:
                self.current_goal.set_canceled(None, _ANOTHER)
            logdebug("Accepting a new goal")
            self.current_goal = self.next_goal
            self.new_goal = False
            self.preempt_request = self.new_goal_preempt_request
            self.new_goal_preempt_request = False
            self.current_goal.set_accepted("This goal has been accepted by the simple action server")
            return self.current_goal.get_goal()

    def is_new_goal_available(self) -> bool:
        """Whether a goal waits to be accepted."""
        return self.new_goal

    def is_preempt_requested(self) -> bool:
        """Whether the goal should end early."""
        return self.preempt_request

    def is_active(self) -> bool:
        """Whether there is a goal that has not ended."""
        if not self.current_goal.get_goal():
            return False
        status = self.current_goal.get_goal_status()
        return status.status in (status.ACTIVE, status.PREEMPTING)

    def set_succeeded(self, result: Any = None, text: str = "") -> None:
        """End the goal as succeeded."""
        with self.action_server.lock, self.lock:
            self.current_goal.set_succeeded(result or self.get_default_result(), text)

    def set_aborted(self, result: Any = None, text: str = "") -> None:
        """End the goal as aborted."""
        with self.action_server.lock, self.lock:
            self.current_goal.set_aborted(result or self.get_default_result(), text)

    def set_preempted(self, result: Any = None, text: str = "") -> None:
        """End the goal as preempted."""
        with self.action_server.lock, self.lock:
            logdebug("Setting the current goal as canceled")
            self.current_goal.set_canceled(result or self.get_default_result(), text)

    def publish_feedback(self, feedback: Any) -> None:
        """Send feedback."""
        self.current_goal.publish_feedback(feedback)

    def get_default_result(self) -> Any:
        """An empty result."""
        return self.action_server.ActionResultType()

    def register_goal_callback(self, cb: Callable[[], Any]) -> None:
        """Have ``cb()`` called for each goal, if there is no ``execute_cb``."""
        if self.execute_callback:
            logwarn(
                "Cannot call SimpleActionServer.register_goal_callback() because an executeCallback exists. Not going "
                "to register it."
            )
        else:
            self.goal_callback = cb

    def register_preempt_callback(self, cb: Callable[[], Any]) -> None:
        """Have ``cb()`` called when the goal should end early."""
        self.preempt_callback = cb

    def internal_goal_callback(self, goal: ServerGoalHandle) -> None:
        """Take a goal: it waits, unless it is older than what there is."""
        with self.execute_condition:
            try:
                self._take(goal)
            except Exception as error:
                logerr("SimpleActionServer.internal_goal_callback - exception %s", str(error))

    def _take(self, goal: ServerGoalHandle) -> None:
        logdebug("A new goal %s has been received by the single goal action server", goal.get_goal_id().id)
        current, waiting = self.current_goal, self.next_goal
        stamp = goal.get_goal_id().stamp
        if any(each.get_goal() and stamp < each.get_goal_id().stamp for each in (current, waiting)):
            goal.set_canceled(None, _ANOTHER)
            return
        if waiting.get_goal() and (not current.get_goal() or waiting != current):
            waiting.set_canceled(None, _ANOTHER)
        self.next_goal = goal
        self.new_goal = True
        self.new_goal_preempt_request = False
        if self.is_active():
            self.preempt_request = True
            if self.preempt_callback:
                self.preempt_callback()
        if self.goal_callback:
            self.goal_callback()
        self.execute_condition.notify()

    def internal_preempt_callback(self, preempt: ServerGoalHandle) -> None:
        """Take a request to cancel."""
        with self.lock:
            logdebug("A preempt has been received by the SimpleActionServer")
            if preempt == self.current_goal:
                logdebug("Setting preempt_request bit for the current goal to TRUE and invoking callback")
                self.preempt_request = True
                if self.preempt_callback:
                    self.preempt_callback()
            elif preempt == self.next_goal:
                logdebug("Setting preempt request bit for the next goal to TRUE")
                self.new_goal_preempt_request = True

    def executeLoop(self) -> None:
        """Call ``execute_cb`` for each goal."""
        while not is_shutdown():
            with self.terminate_mutex:
                if self.need_to_terminate:
                    break
            if self.is_active():
                logerr("Should never reach this code with an active goal")
                return
            if self.is_new_goal_available():
                goal = self.accept_new_goal()
                try:
                    self.execute_callback(goal)
                    if self.is_active():
                        logwarn(
                            "Your executeCallback did not set the goal to a terminal status.  This is a bug in your "
                            "ActionServer implementation. Fix your code!  For now, the ActionServer will set this goal "
                            "to aborted"
                        )
                        self.set_aborted(None, "No terminal state was set.")
                except Exception as error:
                    logerr("Exception in your execute callback: %s\n%s", str(error), format_error(error))
                    self.set_aborted(None, f"Exception in execute callback: {error}")
            with self.execute_condition:
                self.execute_condition.wait(_WAKE.to_sec())
