"""Actions: goals that take a while, with feedback and a result (sources: rclpy/action, rcl_action).

An action is three services (to send a goal, to cancel it, to get its result) and two topics (feedback and status). An
executor serves all five together, as one entity.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterable
from enum import Enum, IntEnum
from functools import partial
from hashlib import md5
from importlib import import_module
from itertools import count
from typing import TYPE_CHECKING, Any
from weakref import WeakMethod, ref

from ..clocks.frames import format_error
from ..messages.ros2 import Action, Message
from ..world.world import current_world
from .callback_groups import CallbackGroup
from .deadlines import Countdown
from .exceptions import NameValidationException, RCLError, no_type_support
from .handle import Life
from .qos import QoSProfile, qos_profile_action_status_default, qos_profile_services_default
from .services import ClientEndpoint, ServerEndpoint, look_until
from .task import Future, await_or_execute
from .topics import PublisherEndpoint, SubscriptionEndpoint
from .waitable import NumberOfEntities
from .waits import waiting_for

if TYPE_CHECKING:
    from .node import Node

__all__ = [
    "ActionClient",
    "ActionServer",
    "CancelResponse",
    "GoalResponse",
    "get_action_client_names_and_types_by_node",
    "get_action_names_and_types",
    "get_action_server_names_and_types_by_node",
]

_FEEDBACK_QOS = QoSProfile(depth=10)


class GoalResponse(Enum):
    """What a server says to a goal."""

    REJECT = 1
    ACCEPT = 2


class CancelResponse(Enum):
    """What a server says to a request to cancel a goal."""

    REJECT = 1
    ACCEPT = 2


class _Status(IntEnum):
    """What has become of a goal, numbered as in action_msgs/GoalStatus."""

    UNKNOWN = 0
    ACCEPTED = 1
    EXECUTING = 2
    CANCELING = 3
    SUCCEEDED = 4
    CANCELED = 5
    ABORTED = 6

    @property
    def is_active(self) -> bool:
        return self in (_Status.ACCEPTED, _Status.EXECUTING, _Status.CANCELING)


# What an event makes of a goal (source: rcl_action/goal_state_machine.c).
_AFTER = {
    (_Status.ACCEPTED, "EXECUTE"): _Status.EXECUTING,
    (_Status.ACCEPTED, "CANCEL_GOAL"): _Status.CANCELING,
    (_Status.EXECUTING, "CANCEL_GOAL"): _Status.CANCELING,
    (_Status.EXECUTING, "SUCCEED"): _Status.SUCCEEDED,
    (_Status.EXECUTING, "ABORT"): _Status.ABORTED,
    (_Status.CANCELING, "SUCCEED"): _Status.SUCCEEDED,
    (_Status.CANCELING, "ABORT"): _Status.ABORTED,
    (_Status.CANCELING, "CANCELED"): _Status.CANCELED,
}

# What CancelGoal answers.
_UNKNOWN_GOAL = 2
_GOAL_HAS_ENDED = 3


def _weakly(method: Callable[[], object]) -> Callable[[], None]:
    """Return what calls a method as long as its object is there."""
    found = WeakMethod(method)

    def call() -> None:
        if called := found():
            called()

    return call


class GoalIds:
    """Numbers the goals of a run. Their ids are as good as random ones, and the same in each run."""

    def __init__(self) -> None:
        self._numbers = count()

    def new(self) -> list[int]:
        """Return the 16 bytes of a new id."""
        return list(md5(f"goal {next(self._numbers)}".encode(), usedforsecurity=False).digest())


class _ActionEntity:
    """Base of the server and the client: one entity for the executor, with several endpoints."""

    _rosspin_word: str
    _rosspin_entities: NumberOfEntities
    _rosspin: _ActionEndpoints

    def __init__(self, node: Node, action_type: type[Action], action_name: str, group: CallbackGroup | None) -> None:
        if not (isinstance(action_type, type) and issubclass(action_type, Action)):
            raise no_type_support(action_type)
        node._rosspin.check()
        if not node.context.ok():
            raise ValueError(f"Failed to create action {self._rosspin_word}: rcl node's context is invalid")
        self._node = node
        self._action_type = action_type
        self._rosspin_name = action_name
        try:
            self._rosspin_names("send_goal", is_service=True)
        except NameValidationException as error:
            what = f"Failed to create action {self._rosspin_word} due to invalid topic name"
            colons = ": :" if self._rosspin_word == "server" else ":"  # sources: rcl_action's two files
            raise ValueError(f"{what} '{action_name}' {colons} {error.error_msg}") from None
        self.callback_group = group or node.default_callback_group
        self._executor_event = False
        self._futures: list[Future] = []
        self._logger = node.get_logger().get_child(f"action_{self._rosspin_word}")

    def _rosspin_names(self, part: str, is_service: bool) -> str:
        """Return the full name of one of its services, or topics."""
        return self._node._rosspin_resolve(f"{self._rosspin_name}/_action/{part}", is_service=is_service)

    def get_num_entities(self) -> NumberOfEntities:
        """How many things it waits for."""
        return self._rosspin_entities

    def _rosspin_join(self, endpoints: Iterable[Any]) -> None:
        """Let executors look at the endpoints: their order is that in which they are served."""
        self._rosspin = _ActionEndpoints(list(endpoints))
        self._rosspin_life = Life(self._rosspin.destroy)
        for endpoint in self._rosspin.endpoints:
            endpoint.entity = ref(self)
        self.callback_group.add_entity(self)
        self._node.add_waitable(self)

    def _rosspin_take(self) -> Any:
        """Return the call to make: with one message of each endpoint that was ready when the executor looked."""
        own = self._rosspin
        if own.is_destroyed:
            return None
        taken = [(each, *each.messages.popleft()) for each in own.ready if each.messages]
        return self._rosspin_execute, (taken,), None

    async def _rosspin_execute(self, taken: list[tuple[Any, Any, Any]]) -> None:
        for future in self._futures:
            future._set_executor(self._node.executor)
        for endpoint, *message in taken:
            await self._rosspin_serve(endpoint, *message)

    async def _rosspin_serve(self, endpoint: Any, first: Any, second: Any) -> None:
        raise NotImplementedError

    def destroy(self) -> None:
        """Leave the action. Raises ValueError the second time, as the node has it no more."""
        self._rosspin.destroy()
        self._node.remove_waitable(self)


class _ActionEndpoints:
    """The endpoints of an action's server or client, for an executor."""

    def __init__(self, endpoints: list[Any]) -> None:
        self.endpoints = endpoints
        self.ready: list[Any] = []
        self.is_destroyed = False
        self.looks_for_expired = False  # of a server

    @property
    def messages(self) -> bool:
        """Whether there is something to take, or to forget; which of the endpoints have it is noted in ``ready``."""
        self.ready = [endpoint for endpoint in self.endpoints if getattr(endpoint, "messages", None)]
        return bool(self.ready) or self.looks_for_expired

    def destroy(self) -> None:
        """Leave the action."""
        self.is_destroyed = True
        for endpoint in self.endpoints:
            endpoint.destroy()


# --- the server -------------------------------------------------------------------------------------------------------


class ServerGoalHandle:
    """A goal that a server has accepted. Two are equal if their ids are."""

    def __init__(self, action_server: ActionServer, goal_info: Any, goal_request: Message) -> None:
        self._action_server = action_server
        self._goal_info = goal_info
        self._goal_request = goal_request
        self._rosspin_status = _Status.ACCEPTED
        self._lock = threading.Lock()
        self._rosspin_ended = 0  # when (ns)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and bool(self.goal_id == other.goal_id)

    __hash__ = None  # type: ignore[assignment]

    @property
    def request(self) -> Any:
        """The goal."""
        return self._goal_request

    @property
    def goal_id(self) -> Any:
        """Its id, a unique_identifier_msgs/UUID."""
        return self._goal_info.goal_id

    @property
    def is_active(self) -> bool:
        """Whether it has not ended."""
        return self._rosspin_status.is_active

    @property
    def is_cancel_requested(self) -> bool:
        """Whether it should be cancelled, and still active."""
        return self._rosspin_status is _Status.CANCELING

    @property
    def status(self) -> int:
        """What has become of it, as in action_msgs/GoalStatus."""
        return int(self._rosspin_status)

    def _update_state(self, event: str) -> None:
        with self._lock:
            if self._rosspin_status is _Status.UNKNOWN:
                return
            after = _AFTER.get((self._rosspin_status, event))
            if after is None:
                raise RCLError(
                    "Failed to update goal state: goal_handle attempted invalid transition from state "
                    f"{self._rosspin_status.name} with event {event}"
                )
            self._rosspin_status = after
            self._action_server._rosspin_publish_status()
            if not after.is_active:
                self._rosspin_ended = self._action_server._rosspin_now()
                self._action_server._rosspin_expire_later()

    def execute(self, execute_callback: Callable[[ServerGoalHandle], Any] | None = None) -> None:
        """Let the executor call the server's function, or this one, with the goal."""
        if not self.is_cancel_requested:
            self._update_state("EXECUTE")
        self._action_server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: Message) -> None:
        """Send feedback to the client. Raises TypeError for what is no feedback of this action."""
        self._action_server._rosspin_publish_feedback(self, feedback)

    def succeed(self) -> None:
        """Say that it has been reached. Raises RCLError if it has ended."""
        self._update_state("SUCCEED")

    def abort(self) -> None:
        """Say that the server has given it up. Raises RCLError if it has ended."""
        self._update_state("ABORT")

    def canceled(self) -> None:
        """Say that it has been cancelled. Raises RCLError unless someone asked for that."""
        self._update_state("CANCELED")

    def destroy(self) -> None:
        """Forget what has become of it."""
        self._rosspin_status = _Status.UNKNOWN


def default_handle_accepted_callback(goal_handle: ServerGoalHandle) -> None:
    """Execute the goal."""
    goal_handle.execute()


def default_goal_callback(goal_request: Message) -> GoalResponse:
    """Accept each goal."""
    return GoalResponse.ACCEPT


def default_cancel_callback(cancel_request: ServerGoalHandle) -> CancelResponse:
    """Cancel none."""
    return CancelResponse.REJECT


class ActionServer(_ActionEntity):
    """Lets an executor call ``execute_callback(goal_handle)`` for each goal; what it returns is the result.

    ``goal_callback(goal)`` decides which goals are accepted, ``cancel_callback(goal_handle)`` which are cancelled, and
    ``handle_accepted_callback(goal_handle)`` when they are executed. A result is kept for ``result_timeout`` s. Only
    requests are served in the callback group: each goal is executed in a task of its own.
    """

    _rosspin_word = "server"
    _rosspin_entities = NumberOfEntities(num_timers=1, num_services=3)

    def __init__(
        self,
        node: Node,
        action_type: type[Action],
        action_name: str,
        execute_callback: Callable[[ServerGoalHandle], Any],
        *,
        callback_group: CallbackGroup | None = None,
        goal_callback: Callable[[Any], Any] | None = default_goal_callback,
        handle_accepted_callback: Callable[[ServerGoalHandle], Any] | None = default_handle_accepted_callback,
        cancel_callback: Callable[[ServerGoalHandle], Any] | None = default_cancel_callback,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_pub_qos_profile: QoSProfile = _FEEDBACK_QOS,
        status_pub_qos_profile: QoSProfile = qos_profile_action_status_default,
        result_timeout: float = 900,
    ) -> None:
        self.register_handle_accepted_callback(handle_accepted_callback)
        self.register_goal_callback(goal_callback)
        self.register_cancel_callback(cancel_callback)
        self.register_execute_callback(execute_callback)
        super().__init__(node, action_type, action_name, callback_group)
        if result_timeout < 0:
            raise ValueError("Failed to create action server: timer period must be non-negative")
        impl = action_type.Impl

        def serve(srv_type: Any, part: str, qos: QoSProfile) -> ServerEndpoint:
            return ServerEndpoint(node._rosspin, srv_type, self._rosspin_names(part, True), qos)

        def publish(msg_type: Any, part: str, qos: QoSProfile) -> PublisherEndpoint:
            return PublisherEndpoint(node._rosspin, msg_type, self._rosspin_names(part, False), qos).begin()

        self._rosspin_goals_asked = serve(impl.SendGoalService, "send_goal", goal_service_qos_profile)
        self._rosspin_cancels_asked = serve(impl.CancelGoalService, "cancel_goal", cancel_service_qos_profile)
        self._rosspin_results_asked = serve(impl.GetResultService, "get_result", result_service_qos_profile)
        self._rosspin_feedback = publish(impl.FeedbackMessage, "feedback", feedback_pub_qos_profile)
        self._rosspin_status = publish(impl.GoalStatusMessage, "status", status_pub_qos_profile)
        self._goal_handles: dict[bytes, ServerGoalHandle] = {}
        self._result_futures: dict[bytes, Future] = {}
        self._rosspin_result_timeout = int(result_timeout * 1e9)
        self._rosspin_expiry = Countdown(
            node._rosspin.context.state.world, self._rosspin_result_timeout, _weakly(self._rosspin_look_for_expired)
        )
        self._rosspin_join(
            [
                self._rosspin_goals_asked,
                self._rosspin_cancels_asked,
                self._rosspin_results_asked,
                self._rosspin_feedback,
                self._rosspin_status,
            ]
        )

    @property
    def action_type(self) -> type[Action]:
        """The class of the action."""
        return self._action_type

    def register_goal_callback(self, goal_callback: Callable[[Any], Any] | None) -> None:
        """Replace the function that decides which goals are accepted; None: all are."""
        self._goal_callback = goal_callback or default_goal_callback

    def register_handle_accepted_callback(
        self, handle_accepted_callback: Callable[[ServerGoalHandle], Any] | None
    ) -> None:
        """Replace the function that is told of accepted goals; None: each is executed immediately."""
        self._handle_accepted_callback = handle_accepted_callback or default_handle_accepted_callback

    def register_cancel_callback(self, cancel_callback: Callable[[ServerGoalHandle], Any] | None) -> None:
        """Replace the function that decides which goals are cancelled; None: none is."""
        self._cancel_callback = cancel_callback or default_cancel_callback

    def register_execute_callback(self, execute_callback: Callable[[ServerGoalHandle], Any]) -> None:
        """Replace the function that executes goals. Raises TypeError if it cannot be called."""
        if not callable(execute_callback):
            raise TypeError("Failed to register goal execution callback: not callable")
        self._execute_callback = execute_callback

    def _rosspin_now(self) -> int:
        return self._node._rosspin.context.state.clock.now()

    async def _rosspin_execute(self, taken: list[tuple[Any, Any, Any]]) -> None:
        await super()._rosspin_execute(taken)
        if self._rosspin.looks_for_expired:
            self._rosspin.looks_for_expired = False
            self._rosspin_drop_expired()

    async def _rosspin_serve(self, endpoint: Any, request: Any, header: Any) -> None:
        if endpoint is self._rosspin_goals_asked:
            await self._rosspin_take_goal(request, header)
        elif endpoint is self._rosspin_cancels_asked:
            await self._rosspin_cancel(request, header)
        else:
            self._rosspin_give_result(request, header)

    def _rosspin_look_for_expired(self) -> None:
        self._rosspin.looks_for_expired = True
        self._node._rosspin_nudge()

    def _rosspin_drop_expired(self) -> None:
        now = self._rosspin_now()
        for uuid, handle in list(self._goal_handles.items()):
            if not handle.is_active and now >= handle._rosspin_ended + self._rosspin_result_timeout:
                handle.destroy()
                del self._goal_handles[uuid]
                self._futures.remove(self._result_futures.pop(uuid))
        self._rosspin_expire_later()

    def _rosspin_expire_later(self) -> None:
        """Look for expired goals later (source: _recalculate_expire_timer in rcl_action/action_server.c).

        As there, the timer begins again with its old period, so that each goal that ends puts the look off.
        """
        ended = [handle._rosspin_ended for handle in self._goal_handles.values() if not handle.is_active]
        if ended:
            self._rosspin_expiry.restart()
            self._rosspin_expiry.period = max(0, min(ended) + self._rosspin_result_timeout - self._rosspin_now())

    async def _rosspin_take_goal(self, request: Any, header: Any) -> None:
        uuid, impl = bytes(request.goal_id.uuid), self._action_type.Impl
        accepted = False
        if uuid not in self._goal_handles:
            response = await await_or_execute(self._goal_callback, request.goal)
            accepted = response is GoalResponse.ACCEPT
            if not isinstance(response, GoalResponse):
                self._logger.warning("Goal request callback did not return a GoalResponse type. Rejecting goal.")
        info = impl.CancelGoalService.Request().goal_info
        info.goal_id = request.goal_id
        answer = impl.SendGoalService.Response(accepted=accepted)
        if accepted:
            info.stamp = answer.stamp = self._node.get_clock().now().to_msg()
            handle = self._goal_handles[uuid] = ServerGoalHandle(self, info, request.goal)
            self._result_futures[uuid] = Future()
            self._futures.append(self._result_futures[uuid])
        self._rosspin_goals_asked.send_response(answer, header)
        if accepted:
            self._rosspin_publish_status()
            await await_or_execute(self._handle_accepted_callback, handle)

    def notify_execute(
        self, goal_handle: ServerGoalHandle, execute_callback: Callable[[ServerGoalHandle], Any] | None
    ) -> None:
        executor: Any = self._node.executor
        executor.create_task(self._execute_goal, execute_callback or self._execute_callback, goal_handle)

    async def _execute_goal(
        self, execute_callback: Callable[[ServerGoalHandle], Any], handle: ServerGoalHandle
    ) -> None:
        try:
            result = await await_or_execute(execute_callback, handle)
        except Exception as error:
            result = self._action_type.Result()
            self._logger.error(f"Error raised in execute callback: {error}")
            sys.stderr.write(format_error(error))
        if handle.is_active:
            self._logger.warning(f"Goal state not set, assuming aborted. Goal ID: {handle.goal_id.uuid}")
            handle.abort()
        response = self._action_type.Impl.GetResultService.Response()
        response.status = handle.status
        response.result = result
        self._result_futures[bytes(handle.goal_id.uuid)].set_result(response)

    async def _rosspin_cancel(self, request: Any, header: Any) -> None:
        answer = self._action_type.Impl.CancelGoalService.Response()
        found, answer.return_code = self._rosspin_cancelable(request.goal_info)
        answer.goals_canceling = [handle._goal_info for handle in found]
        # As on the real one, the goal after one that is not cancelled is passed over, and said to be cancelled.
        for info in answer.goals_canceling:
            handle = self._goal_handles[bytes(info.goal_id.uuid)]
            accepted = await await_or_execute(self._cancel_callback, handle) is CancelResponse.ACCEPT
            try:
                if accepted:
                    handle._update_state("CANCEL_GOAL")
            except RCLError:
                accepted = False  # it has ended meanwhile
            if not accepted:
                answer.goals_canceling.remove(info)
        self._rosspin_cancels_asked.send_response(answer, header)

    def _rosspin_cancelable(self, info: Any) -> tuple[list[ServerGoalHandle], int]:
        """Return the goals that a request names, and a code (source: rcl_action_process_cancel_request)."""
        uuid, stamp = bytes(info.goal_id.uuid), (info.stamp.sec, info.stamp.nanosec)
        cancelable = [
            handle for handle in self._goal_handles.values() if (handle._rosspin_status, "CANCEL_GOAL") in _AFTER
        ]
        one = self._goal_handles.get(uuid)
        if any(uuid) and stamp == (0, 0):
            if one is None:
                return [], _UNKNOWN_GOAL
            return ([one], 0) if one in cancelable else ([], _GOAL_HAS_ENDED)
        until = stamp if stamp != (0, 0) else (sys.maxsize, 0)

        def accepted(handle: ServerGoalHandle) -> tuple[int, int]:
            return handle._goal_info.stamp.sec, handle._goal_info.stamp.nanosec

        return [handle for handle in cancelable if handle is one or accepted(handle) <= until], 0

    def _rosspin_give_result(self, request: Any, header: Any) -> None:
        future = self._result_futures.get(bytes(request.goal_id.uuid))
        if future is None:
            self._rosspin_results_asked.send_response(self._action_type.Impl.GetResultService.Response(), header)
        else:
            future.add_done_callback(partial(self._rosspin_send_result, header))

    def _rosspin_send_result(self, header: Any, future: Future) -> None:
        if not self._rosspin.is_destroyed:
            self._rosspin_results_asked.send_response(future.result(), header)

    def _rosspin_check(self, failed: str) -> None:
        """Raise RCLError once the context has ended (source: rcl_action/action_server.c)."""
        if not self._node.context.ok():
            raise RCLError(f"{failed}: feedback publisher is invalid")

    def _rosspin_publish_status(self) -> None:
        self._rosspin_check("Failed get goal status array")
        kind = import_module("action_msgs.msg").GoalStatus
        found = [kind(goal_info=each._goal_info, status=each.status) for each in self._goal_handles.values()]
        self._rosspin_status.publish(self._action_type.Impl.GoalStatusMessage(status_list=found))

    def _rosspin_publish_feedback(self, handle: ServerGoalHandle, feedback: Message) -> None:
        if not isinstance(feedback, self._action_type.Feedback):
            raise TypeError()
        if handle._rosspin_status is not _Status.UNKNOWN:
            self._rosspin_check("Failed to publish feedback with an action server")
            kind = self._action_type.Impl.FeedbackMessage
            self._rosspin_feedback.publish(kind(goal_id=handle.goal_id, feedback=feedback))

    def destroy(self) -> None:
        """Leave the action, and forget its goals."""
        for handle in self._goal_handles.values():
            handle.destroy()
        self._futures.clear()
        self._rosspin_expiry.stop()
        super().destroy()


# --- the client -------------------------------------------------------------------------------------------------------


class ClientGoalHandle:
    """A goal that a client has sent, once the server has answered. Two are equal if their ids are."""

    def __init__(self, action_client: ActionClient, goal_id: Any, goal_response: Any) -> None:
        self._action_client = action_client
        self._goal_id = goal_id
        self._goal_response = goal_response
        self._status = 0

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ClientGoalHandle) and bool(self._goal_id == other.goal_id)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"ClientGoalHandle <id={self.goal_id.uuid}, accepted={self.accepted}, status={self.status}>"

    @property
    def goal_id(self) -> Any:
        """Its id, a unique_identifier_msgs/UUID."""
        return self._goal_id

    @property
    def stamp(self) -> Any:
        """When it was accepted, by the server's clock."""
        return self._goal_response.stamp

    @property
    def accepted(self) -> bool:
        """Whether the server has accepted it."""
        return bool(self._goal_response.accepted)

    @property
    def status(self) -> int:
        """What has become of it as far as the client has heard, as in action_msgs/GoalStatus."""
        return self._status

    def cancel_goal(self) -> Any:
        """Ask the server to cancel it, and wait for the answer, while another thread spins."""
        return _wait_for(self.cancel_goal_async())

    def cancel_goal_async(self) -> Future:
        """Ask the server to cancel it. Return a future of the answer."""
        return self._action_client._cancel_goal_async(self)

    def get_result(self) -> Any:
        """Ask for the result, and wait for it, while another thread spins."""
        return _wait_for(self.get_result_async())

    def get_result_async(self) -> Future:
        """Ask for the result. Return a future of the response, which has a ``status`` and a ``result``."""
        return self._action_client._get_result_async(self)


class ActionClient(_ActionEntity):
    """Sends goals to a server. An executor has to spin its node, which takes what the server sends."""

    _rosspin_word = "client"
    _rosspin_entities = NumberOfEntities(num_subs=2, num_clients=3)

    def __init__(
        self,
        node: Node,
        action_type: type[Action],
        action_name: str,
        *,
        callback_group: CallbackGroup | None = None,
        goal_service_qos_profile: QoSProfile = qos_profile_services_default,
        result_service_qos_profile: QoSProfile = qos_profile_services_default,
        cancel_service_qos_profile: QoSProfile = qos_profile_services_default,
        feedback_sub_qos_profile: QoSProfile = _FEEDBACK_QOS,
        status_sub_qos_profile: QoSProfile = qos_profile_action_status_default,
    ) -> None:
        super().__init__(node, action_type, action_name, callback_group)
        impl = action_type.Impl

        def ask(srv_type: Any, part: str, qos: QoSProfile) -> ClientEndpoint:
            return ClientEndpoint(node._rosspin, srv_type, self._rosspin_names(part, True), qos)

        def hear(msg_type: Any, part: str, qos: QoSProfile) -> SubscriptionEndpoint:
            return SubscriptionEndpoint(node._rosspin, msg_type, self._rosspin_names(part, False), qos).begin()

        self._rosspin_goals = ask(impl.SendGoalService, "send_goal", goal_service_qos_profile)
        self._rosspin_cancels = ask(impl.CancelGoalService, "cancel_goal", cancel_service_qos_profile)
        self._rosspin_results = ask(impl.GetResultService, "get_result", result_service_qos_profile)
        self._rosspin_feedback = hear(impl.FeedbackMessage, "feedback", feedback_sub_qos_profile)
        self._rosspin_status = hear(impl.GoalStatusMessage, "status", status_sub_qos_profile)
        self._goal_handles: dict[bytes, ref[ClientGoalHandle]] = {}
        self._feedback_callbacks: dict[bytes, Callable[[Any], Any]] = {}
        self._action_name = action_name
        self._rosspin_lock = threading.Lock()
        # By client and number of the request: the future of the answer, and the goal that it is about.
        self._rosspin_pending: dict[tuple[ClientEndpoint, int], tuple[Future, Any]] = {}
        self._rosspin_join(
            [
                self._rosspin_goals,
                self._rosspin_cancels,
                self._rosspin_results,
                self._rosspin_feedback,
                self._rosspin_status,
            ]
        )

    def send_goal(self, goal: Message, **kwargs: Any) -> Any:
        """Send a goal, and wait for its result, while another thread spins. Arguments as of ``send_goal_async``."""
        return _wait_for(self._get_result_async(_wait_for(self.send_goal_async(goal, **kwargs))))

    def send_goal_async(
        self, goal: Message, feedback_callback: Callable[[Any], Any] | None = None, goal_uuid: Any = None
    ) -> Future:
        """Send a goal. Return a future of its handle, which is done when the server has accepted or rejected it.

        ``feedback_callback(message)`` is called with feedback, until the result is there. Raises TypeError for what is
        no goal of this action.
        """
        if not isinstance(goal, self._action_type.Goal):
            raise TypeError()
        request = self._action_type.Impl.SendGoalService.Request(goal=goal)
        if goal_uuid is None:
            request.goal_id.uuid = self._node._rosspin.context.state.world.graph.part(GoalIds).new()
        else:
            request.goal_id = goal_uuid
        if feedback_callback is not None:
            self._feedback_callbacks[bytes(request.goal_id.uuid)] = feedback_callback
        return self._rosspin_ask(self._rosspin_goals, request, request.goal_id, "send goal")

    def _cancel_goal_async(self, goal_handle: ClientGoalHandle) -> Future:
        _check_handle(goal_handle)
        request = self._action_type.Impl.CancelGoalService.Request()
        request.goal_info.goal_id = goal_handle.goal_id
        return self._rosspin_ask(self._rosspin_cancels, request, goal_handle.goal_id, "send cancel")

    def _get_result_async(self, goal_handle: ClientGoalHandle) -> Future:
        _check_handle(goal_handle)
        request = self._action_type.Impl.GetResultService.Request(goal_id=goal_handle.goal_id)
        return self._rosspin_ask(self._rosspin_results, request, goal_handle.goal_id, "send result")

    def _get_result(self, goal_handle: ClientGoalHandle) -> Any:
        return _wait_for(self._get_result_async(goal_handle))

    def _rosspin_ask(self, client: ClientEndpoint, request: Message, goal_id: Any, what: str) -> Future:
        if self._rosspin.is_destroyed:
            raise RCLError(f"Failed to {what} request: action client pointer is invalid")
        future = Future()
        future.add_done_callback(self._rosspin_forget)
        self._futures.append(future)
        # In one go: the answer may come to another thread immediately.
        with self._rosspin_lock:
            self._rosspin_pending[client, client.send_request(request)] = future, goal_id
        return future

    def _rosspin_forget(self, future: Future) -> None:
        for (client, number), (pending, goal_id) in list(self._rosspin_pending.items()):
            if pending is future:
                del self._rosspin_pending[client, number]
                self._futures.remove(future)
                if client is self._rosspin_results:
                    self._feedback_callbacks.pop(bytes(goal_id.uuid), None)

    async def _rosspin_serve(self, endpoint: Any, first: Any, second: Any) -> None:
        if endpoint is self._rosspin_feedback:
            if callback := self._feedback_callbacks.get(bytes(first.goal_id.uuid)):
                await await_or_execute(callback, first)
        elif endpoint is self._rosspin_status:
            self._rosspin_note(first)
        elif second is not None:  # else it is the answer to another client
            self._rosspin_settle(endpoint, first, second)

    def _rosspin_settle(self, client: ClientEndpoint, number: int, response: Any) -> None:
        with self._rosspin_lock:
            asked = self._rosspin_pending.get((client, number))
        if asked is None:
            what = {self._rosspin_goals: "goal", self._rosspin_cancels: "cancel", self._rosspin_results: "result"}[
                client
            ]
            self._logger.warning(
                f"Ignoring unexpected {what} response. There may be more than "
                f"one action server for the action '{self._rosspin_name}'"
            )
            return
        future, goal_id = asked
        if client is self._rosspin_goals:
            handle = ClientGoalHandle(self, goal_id, response)
            if handle.accepted:
                uuid = bytes(goal_id.uuid)
                if uuid in self._goal_handles:
                    raise RuntimeError(f"Two goals were accepted with the same ID ({handle})")
                self._goal_handles[uuid] = ref(handle)
            future.set_result(handle)
        else:
            future.set_result(response)

    def _rosspin_note(self, message: Any) -> None:
        for each in message.status_list:
            uuid = bytes(each.goal_info.goal_id.uuid)
            if uuid in self._goal_handles:
                if handle := self._goal_handles[uuid]():
                    handle._status = each.status
                if handle is None or not _Status(each.status).is_active:
                    del self._goal_handles[uuid]

    def server_is_ready(self) -> bool:
        """Whether a server is known, with all of its endpoints."""
        self._node._rosspin.check()
        if self._rosspin.is_destroyed:
            raise RCLError("Failed to check if action server is available: rcl node pointer is invalid")
        clients, heard = (
            (self._rosspin_goals, self._rosspin_cancels, self._rosspin_results),
            (self._rosspin_feedback, self._rosspin_status),
        )
        return all(client.is_served() for client in clients) and all(each.peers for each in heard)

    def wait_for_server(self, timeout_sec: float | None = None) -> bool:
        """Look for a server every 0.25 s, until these pauses add up to ``timeout_sec`` (default: no limit)."""
        return look_until(self.server_is_ready, self._node.context, timeout_sec)


def _check_handle(goal_handle: Any) -> None:
    if not isinstance(goal_handle, ClientGoalHandle):
        raise TypeError(f"Expected type ClientGoalHandle but received {type(goal_handle)}")


def _wait_for(future: Future) -> Any:
    """Wait until a future is done, and return its result."""
    done = threading.Event()
    future.add_done_callback(lambda _: done.set())
    with waiting_for(future, current_world()):
        done.wait()
    return future.result()


# --- who has which ----------------------------------------------------------------------------------------------------


_FEEDBACK = "/_action/feedback"


def get_action_names_and_types(node: Node) -> list[tuple[str, list[str]]]:
    """Return the known actions, sorted, and their types."""
    return _actions(node.get_topic_names_and_types())


def get_action_server_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> list[tuple[str, list[str]]]:
    """Return the actions that a node serves, and their types. Raises NodeNameNonExistentError if unknown."""
    return _actions(node.get_publisher_names_and_types_by_node(remote_node_name, remote_node_namespace))


def get_action_client_names_and_types_by_node(
    node: Node, remote_node_name: str, remote_node_namespace: str
) -> list[tuple[str, list[str]]]:
    """Return the actions of which a node is a client, and their types. Raises NodeNameNonExistentError if unknown."""
    return _actions(node.get_subscriber_names_and_types_by_node(remote_node_name, remote_node_namespace))


def _actions(topics: list[tuple[str, list[str]]]) -> list[tuple[str, list[str]]]:
    """Return the actions to which topics belong."""
    return [
        (topic.removesuffix(_FEEDBACK), [each.removesuffix("_FeedbackMessage") for each in types])
        for topic, types in topics
        if topic.endswith(_FEEDBACK)
    ]


for _each in [name for name in __all__ if name.startswith("get_")]:
    globals()[_each].__module__ = "rclpy.action.graph"
