"""The real rclpy's own Python, on a simulated clock: its C module is replaced by this one.

So what the stand-in does can be compared with what rclpy's executors, tasks, timers, Rates and parameters do, exactly
and without a network. Here are, in Python, the parts of rcl that they call: its timers, guard conditions, clients,
services, actions and wait sets. There are no other topics than those of actions.

What is used of the real one is its ``.py`` files, which ``make ros2`` installs; no library is loaded.
"""

from __future__ import annotations

import enum
import signal
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from .oracles import stub, without


def real_rclpy() -> Path | None:
    """The folder of the real rclpy, if it is installed."""
    return next(iter(sorted((Path(__file__).parents[1]).glob("build/ros2/lib/python3*/site-packages/rclpy"))), None)


# --- rcl --------------------------------------------------------------------------------------------------------------


class InvalidHandle(RuntimeError):
    pass


class RCLError(RuntimeError):
    __module__ = "rclpy._rclpy_pybind11"  # as tracebacks name it


class Handle:
    """What C code holds; in a ``with`` it is checked."""

    gone = False

    def __enter__(self) -> Any:
        if self.gone:
            raise InvalidHandle("cannot use Destroyable because destruction was requested")
        return self

    def __exit__(self, *error: object) -> None:
        pass

    def destroy_when_not_in_use(self) -> None:
        with self:
            self.gone = True

    @property
    def pointer(self) -> int:
        return id(self)


class Wakes(Handle):
    """What wait sets wait for."""

    def __init__(self) -> None:
        self.waiting: list[WaitSet] = []

    def wake(self) -> None:
        for wait_set in self.waiting:
            wait_set.open()


class GuardCondition(Wakes):
    def __init__(self, context: Any) -> None:
        super().__init__()
        if not context.valid:
            raise RCLError("the given context is not valid")
        self.triggered = False

    def trigger_guard_condition(self) -> None:
        self.triggered = True
        self.wake()


class ClockType(enum.IntEnum):
    UNINITIALIZED = 0
    ROS_TIME = 1
    SYSTEM_TIME = 2
    STEADY_TIME = 3


class Clock(Handle):
    def __init__(self, clock_type: Any) -> None:
        self.clock_type = clock_type

    def now(self) -> int:
        return time.time_ns()

    def get_now(self) -> Any:
        return SimpleNamespace(nanoseconds=self.now())

    def get_ros_time_override_is_enabled(self) -> bool:
        return False

    def set_ros_time_override_is_enabled(self, enabled: bool) -> None:
        assert not enabled

    def set_ros_time_override(self, told: Any) -> None:
        pass

    def add_clock_callback(self, *args: Any) -> None:
        pass

    def remove_clock_callback(self, *args: Any) -> None:
        pass


class Timer(Wakes):
    """rcl/timer.c."""

    def __init__(self, clock: Clock, context: Any, period: int, autostart: bool) -> None:
        super().__init__()
        if period < 0:
            raise RCLError("failed to create timer: timer period must be non-negative")
        if not context.valid:
            raise RCLError("failed to create timer: the given context is not valid")
        self.clock, self.period, self.canceled = clock, period, not autostart
        self.last_call = clock.now()
        self.next_call = self.last_call + period

    def call_timer(self) -> None:
        if self.canceled:
            raise RCLError("failed to call timer: timer is canceled")
        now = self.last_call = self.clock.now()
        self.next_call += self.period
        while self.period > 0 and self.next_call <= now:
            self.next_call += self.period

    def is_timer_ready(self) -> bool:
        return not self.canceled and self.next_call <= self.clock.now()

    def is_timer_canceled(self) -> bool:
        return self.canceled

    def cancel_timer(self) -> None:
        self.canceled = True

    def reset_timer(self) -> None:
        self.next_call = self.clock.now() + self.period
        self.canceled = False
        self.wake()

    def get_timer_period(self) -> int:
        return self.period

    def change_timer_period(self, period: int) -> None:
        self.period = period

    def time_since_last_call(self) -> int:
        return self.clock.now() - self.last_call

    def time_until_next_call(self) -> int | None:
        return None if self.canceled else self.next_call - self.clock.now()


class Header(SimpleNamespace):
    """Whose request it is, and its number; ``request_id`` is the header itself."""

    client: Client
    sequence_number: int

    @property
    def request_id(self) -> Header:
        return self


class Service(Wakes):
    """A service with its requests. Its answers come to all clients of its name, as in rmw_fastrtps."""

    def __init__(self, node: Node, kind: Any, name: str, qos: Any) -> None:
        super().__init__()
        self.name, self.came = name, deque[Any](maxlen=10)
        _ends.append(self)

    def service_take_request(self, kind: Any) -> Any:
        return self.came.popleft() if self.came else (None, None)

    def service_send_response(self, response: Any, header: Header) -> None:
        for client in _others(self, Client):
            client.take_in((header, response) if client is header.client else (None, None))

    def take_in(self, what: Any) -> None:
        self.came.append(what)
        self.wake()


class Client(Wakes):
    """A client with the answers that came."""

    take_in = Service.take_in

    def __init__(self, node: Node, kind: Any, name: str, qos: Any) -> None:
        super().__init__()
        self.name, self.sent, self.came = name, 0, deque[Any](maxlen=10)
        _ends.append(self)

    def send_request(self, request: Any) -> int:
        self.sent += 1
        for service in _others(self, Service):
            service.take_in((request, Header(client=self, sequence_number=self.sent)))
        return self.sent

    def take_response(self, kind: Any) -> Any:
        return self.came.popleft() if self.came else (None, None)

    def service_server_is_available(self) -> bool:
        return bool(_others(self, Service))


def _others(end: Client | Service, kind: type) -> list[Any]:
    return [other for other in _ends if isinstance(other, kind) and other.name == end.name and not other.gone]


class Heard(Wakes):
    """An action client's end of a topic, with the messages that came."""

    def __init__(self, depth: int) -> None:
        super().__init__()
        self.came = deque[Any](maxlen=depth)

    def take_in(self, message: Any) -> None:
        self.came.append(message)
        self.wake()

    def take(self, kind: Any) -> Any:
        return self.came.popleft() if self.came else None


GoalEvent = enum.IntEnum("GoalEvent", "EXECUTE CANCEL_GOAL SUCCEED ABORT CANCELED", start=0)

# rcl_action/goal_state_machine.c; the states are numbered as in action_msgs/GoalStatus.
_AFTER = {
    **{(1, GoalEvent.EXECUTE): 2, (1, GoalEvent.CANCEL_GOAL): 3, (2, GoalEvent.CANCEL_GOAL): 3},
    **{(2, GoalEvent.SUCCEED): 4, (2, GoalEvent.ABORT): 6, (3, GoalEvent.SUCCEED): 4},
    **{(3, GoalEvent.ABORT): 6, (3, GoalEvent.CANCELED): 5},
}


class ActionGoalHandle(Handle):
    def __init__(self, server: ActionServer, info: Any) -> None:
        self.info, self.status = info, 1
        server.goals.append(self)

    def is_active(self) -> bool:
        return self.status < 4

    def get_status(self) -> int:
        return self.status

    def update_goal_state(self, event: Any) -> None:
        if (self.status, event) not in _AFTER:
            state = ("", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")[self.status]
            text = f"invalid transition from state {state} with event {event.name}"
            raise RCLError(f"Failed to update goal state: goal_handle attempted {text}")
        self.status = _AFTER[self.status, event]


class _ActionEnd(Handle):
    """rcl_action: three services, or clients of these, which are ready if the wait set has found them so."""

    def __init__(self, node: Node, name: str, kind: Callable[..., Any]) -> None:
        self.name, self.context = name, node.context
        self.endpoints = [kind(node, None, f"{name}/_action/{part}", None) for part in ("goal", "cancel", "result")]
        self.heard: list[Heard] = []
        _actions.append(self)

    def is_ready(self, wait_set: WaitSet) -> list[bool]:
        return [each.pointer in wait_set.found for each in (*self.heard, *self.endpoints)]

    def add_to_waitset(self, wait_set: WaitSet) -> None:
        wait_set.others += [*self.heard, *self.endpoints]

    def get_num_entities(self) -> tuple[int, ...]:
        return (0, 0, 0, 0, 0)

    def destroy_when_not_in_use(self) -> None:
        super().destroy_when_not_in_use()
        for endpoint in self.endpoints:
            endpoint.gone = True


class ActionServer(_ActionEnd):
    """rcl_action/action_server.c. No goal lives long enough to expire."""

    def __init__(self, node: Node, clock: Clock, kind: Any, name: str, *more: Any) -> None:
        super().__init__(node, name, Service)
        self.goals: list[ActionGoalHandle] = []

    def is_ready(self, wait_set: WaitSet) -> list[bool]:
        return [*super().is_ready(wait_set), False]

    def take_goal_request(self, kind: Any, which: int = 0) -> Any:
        request, header = self.endpoints[which].service_take_request(kind)
        return header, request

    def take_cancel_request(self, kind: Any) -> Any:
        return self.take_goal_request(kind, 1)

    def take_result_request(self, kind: Any) -> Any:
        return self.take_goal_request(kind, 2)

    def send_goal_response(self, header: Header, response: Any) -> None:
        self.endpoints[0].service_send_response(response, header)

    def send_cancel_response(self, header: Header, response: Any) -> None:
        self.endpoints[1].service_send_response(response, header)

    def send_result_response(self, header: Header, response: Any) -> None:
        self.endpoints[2].service_send_response(response, header)

    def goal_exists(self, info: Any) -> bool:
        return any(goal.info.goal_id == info.goal_id for goal in self.goals)

    def process_cancel_request(self, request: Any, kind: Any) -> Any:
        response, wanted = kind(), request.goal_info.goal_id
        can = [goal for goal in self.goals if (goal.status, GoalEvent.CANCEL_GOAL) in _AFTER]
        if any(wanted.uuid):
            if not self.goal_exists(request.goal_info):
                response.return_code = 2
            else:
                can = [goal for goal in can if goal.info.goal_id == wanted]
                response.return_code = 0 if can else 3
        if not response.return_code:
            response.goals_canceling = [goal.info for goal in can]
        return response

    def publish_feedback(self, message: Any) -> None:
        self._check("Failed to publish feedback with an action server")
        self._tell(0, message)

    def _check(self, failed: str) -> None:
        if not self.context.valid:
            raise RCLError(f"{failed}: feedback publisher is invalid")

    def publish_status(self) -> None:
        self._check("Failed get goal status array")
        types = import_module("action_msgs.msg")
        found = [types.GoalStatus(goal_info=goal.info, status=goal.status) for goal in self.goals]
        self._tell(1, types.GoalStatusArray(status_list=found))

    def _tell(self, which: int, message: Any) -> None:
        for client in _actions:
            if isinstance(client, ActionClient) and client.name == self.name and not client.gone:
                client.heard[which].take_in(message)

    def notify_goal_done(self) -> None:
        pass


class ActionClient(_ActionEnd):
    """rcl_action/action_client.c."""

    def __init__(self, node: Node, kind: Any, name: str, *more: Any) -> None:
        super().__init__(node, name, Client)
        self.heard = [Heard(10), Heard(1)]

    def send_goal_request(self, request: Any) -> int:
        return int(self.endpoints[0].send_request(request))

    def send_cancel_request(self, request: Any) -> int:
        return int(self.endpoints[1].send_request(request))

    def send_result_request(self, request: Any) -> int:
        return int(self.endpoints[2].send_request(request))

    def take_goal_response(self, kind: Any, which: int = 0) -> Any:
        header, response = self.endpoints[which].take_response(kind)
        return header and header.sequence_number, response

    def take_cancel_response(self, kind: Any) -> Any:
        return self.take_goal_response(kind, 1)

    def take_result_response(self, kind: Any) -> Any:
        return self.take_goal_response(kind, 2)

    def take_feedback(self, kind: Any) -> Any:
        return self.heard[0].take(kind)

    def take_status(self, kind: Any) -> Any:
        return self.heard[1].take(kind)

    def is_action_server_available(self) -> bool:
        return any(isinstance(each, ActionServer) and each.name == self.name and not each.gone for each in _actions)


class WaitSet:
    """rcl/wait.c."""

    def __init__(self, *numbers: Any) -> None:
        if not numbers[-1].valid:
            raise RCLError("failed to initialize wait set: the given context is not valid")
        self.timers: list[Timer] = []
        self.clients: list[Client] = []
        self.services: list[Service] = []
        self.guards: list[GuardCondition] = []
        self.others: list[Any] = []  # the ends of actions
        self.found: set[int] = set()  # which of them are ready
        self.ready: dict[str, list[int]] = {}
        self.gate = threading.Lock()
        self.gate.acquire()

    def clear_entities(self) -> None:
        pass

    def add_timer(self, timer: Timer) -> None:
        self.timers.append(timer)

    def add_guard_condition(self, guard: GuardCondition) -> None:
        self.guards.append(guard)

    def add_client(self, client: Client) -> None:
        self.clients.append(client)

    def add_service(self, service: Service) -> None:
        self.services.append(service)

    def open(self) -> None:
        if self.gate.locked():
            self.gate.release()

    def wait(self, timeout: int) -> None:
        until = time.time_ns() + timeout if timeout >= 0 else None
        members: list[Wakes] = [*self.timers, *self.guards, *self.clients, *self.services, *self.others]
        for member in members:
            member.waiting.append(self)
        try:
            over = False
            while True:
                timers = [timer for timer in self.timers if timer.is_timer_ready()]
                guards = [guard for guard in self.guards if guard.triggered]
                clients, services = ([end for end in ends if end.came] for ends in (self.clients, self.services))
                others = [end for end in self.others if end.came]
                if timers or guards or clients or services or others or over:
                    break
                times = [timer.next_call for timer in self.timers if not timer.canceled]
                if until is not None:
                    times.append(until)
                left = (min(times) - time.time_ns()) / 1e9 if times else -1
                over = not self.gate.acquire(True, max(left, 0) if times else -1)
        finally:
            for member in members:
                member.waiting.remove(self)
        for guard in guards:
            guard.triggered = False
        self.found = {end.pointer for end in others}
        self.ready = {
            "timer": [timer.pointer for timer in timers],
            "guard_condition": [guard.pointer for guard in guards],
            "client": [client.pointer for client in clients],
            "service": [service.pointer for service in services],
        }

    def get_ready_entities(self, kind: str) -> list[int]:
        return self.ready.get(kind, [])


class Context(Handle):
    def __init__(self, args: list[str], domain_id: int) -> None:
        self.valid = True
        _contexts.append(self)

    def ok(self) -> bool:
        return self.valid

    def get_domain_id(self) -> int:
        return 0

    def shutdown(self) -> None:
        if not self.valid:
            raise RCLError("failed to shutdown: rcl_shutdown already called on the given context")
        self.valid = False


class Node(Handle):
    def __init__(self, name: str, namespace: str, context: Context, *more: Any) -> None:
        self.name, self.namespace, self.context = name, namespace or "/", context

    def logger_name(self) -> str:
        return self.name

    def get_node_name(self) -> str:
        return self.name

    def get_namespace(self) -> str:
        return self.namespace

    def get_parameters(self, kind: Any) -> dict[str, Any]:
        return {}


class Publisher(Handle):
    """Of /parameter_events, to which no one listens."""

    def __init__(self, node: Node, *args: Any) -> None:
        self.context = node.context

    def publish(self, message: Any) -> None:
        if not self.context.valid:
            raise RCLError("Failed to publish: publisher's context is invalid")


class ClockEvent:
    def __init__(self) -> None:
        self.gate = threading.Lock()
        self.gate.acquire()

    def set(self) -> None:
        if self.gate.locked():
            self.gate.release()

    def wait_until(self, clock: Clock, until: Any) -> None:
        left = until.nanoseconds - clock.now()
        if left > 0:
            self.gate.acquire(True, left / 1e9)

    wait_until_system = wait_until_steady = wait_until_ros = wait_until


class QoS:
    """A profile of rmw; which one does not matter here."""

    def __init__(self, *policies: Any) -> None:
        pass

    @classmethod
    def predefined(cls, name: str) -> QoS:
        return cls()

    def to_dict(self) -> dict[str, Any]:
        none = import_module("rclpy.duration").Duration()
        lengths = dict.fromkeys(("lifespan", "deadline", "liveliness_lease_duration"), none)
        names = {"history": 1, "depth": 10, "reliability": 1, "durability": 2, "liveliness": 0}
        return {**names, **lengths, "avoid_ros_namespace_conventions": False}


_contexts: list[Context] = []
_ends: list[Client | Service] = []
_actions: list[_ActionEnd] = []
_sigint: dict[GuardCondition, None] = {}


def _install_signal_handlers(options: Any) -> None:
    before = signal.getsignal(signal.SIGINT)

    def handle(number: int, frame: Any) -> None:
        for context in _contexts:
            context.valid = False
        for guard in _sigint:
            guard.trigger_guard_condition()
        time.sleep(0)
        if callable(before):
            before(number, frame)

    signal.signal(signal.SIGINT, handle)


def _log(severity: int, name: str, message: str, *caller: Any) -> None:
    now = time.time_ns()
    word = {20: "INFO", 30: "WARN", 40: "ERROR"}[severity]
    sys.stderr.write(f"[{word}] [{now // 10**9}.{now % 10**9:09d}] [{name}]: {message}\n")


def _names(prefix: str, *names: str) -> Any:
    return enum.IntEnum(prefix, {name: number for number, name in enumerate(names)})


def c_module() -> SimpleNamespace:
    """What stands in for ``rclpy._rclpy_pybind11``."""
    levels = {"UNSET": 0, "DEBUG": 10, "INFO": 20, "WARN": 30, "ERROR": 40, "FATAL": 50}
    changes = ("NONE", "ROS_TIME_NO_CHANGE", "ROS_TIME_ACTIVATED", "ROS_TIME_DEACTIVATED", "SYSTEM_TIME_NO_CHANGE")
    return SimpleNamespace(
        **{each.__name__: each for each in (Client, Clock, ClockEvent, ClockType, Context, GuardCondition)},
        **{each.__name__: each for each in (ActionClient, ActionGoalHandle, ActionServer, GoalEvent)},
        **{each.__name__: each for each in (InvalidHandle, Node, Publisher, RCLError, Service, Timer, WaitSet)},
        ClockChange=_names("ClockChange", *changes),
        NodeNameNonExistentError=RCLError,
        QoSCompatibility=None,
        RCL_DEFAULT_DOMAIN_ID=0,
        RCUTILS_LOG_SEVERITY=SimpleNamespace(
            **{f"RCUTILS_LOG_SEVERITY_{name}": level for name, level in levels.items()}
        ),
        RMW_DURATION_INFINITE=2**63 - 1,
        RMW_QOS_DEADLINE_BEST_AVAILABLE=2**63 - 2,
        RMW_QOS_LIVELINESS_LEASE_DURATION_BEST_AVAILABLE=2**63 - 2,
        SignalHandlerOptions=_names("SignalHandlerOptions", "NO", "SIGINT", "SIGTERM", "ALL"),
        Subscription=Handle,
        install_signal_handlers=_install_signal_handlers,
        rcl_duration_t=lambda ns: SimpleNamespace(nanoseconds=ns),
        rcl_time_point_t=lambda ns, kind: SimpleNamespace(nanoseconds=ns, clock_type=kind),
        rclpy_action_get_rmw_qos_profile=lambda name: QoS().to_dict(),
        rclpy_logging_configure=lambda context: None,
        rclpy_logging_fini=lambda: None,
        rclpy_logging_get_separator_string=lambda: ".",
        rclpy_logging_logger_is_enabled_for=lambda name, severity: severity >= 20,
        rclpy_logging_rcutils_log=_log,
        rclpy_logging_rosout_add_sublogger=lambda name, child: False,
        rclpy_resolve_name=lambda node, topic, only_expand, is_service: topic,
        register_sigint_guard_condition=lambda guard: _sigint.update({guard: None}),
        rmw_qos_profile_t=QoS,
        rmw_request_id_t=Header,
        rmw_service_info_t=Header,
        service_introspection=SimpleNamespace(ServiceIntrospectionState=None),
        uninstall_signal_handlers=lambda: None,
        unregister_sigint_guard_condition=lambda guard: _sigint.pop(guard, None),
    )


# --- rclpy on it ------------------------------------------------------------------------------------------------------


class _Nothing:
    """In place of what a node has for others, and of events."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        pass

    def create_event_handlers(self, *args: Any) -> list[Any]:
        return []

    def destroy(self) -> None:
        pass


@contextmanager
def oracle(folder: Path) -> Iterator[None]:
    """Within this context ``import rclpy`` imports the real one's Python from its folder, over the C module above."""
    _contexts.clear()
    _sigint.clear()
    _ends.clear()
    _actions.clear()
    with without(2, "rclpy", "ament_index_python", "rcl_interfaces.srv"):
        spec = spec_from_file_location("rclpy", folder / "__init__.py", submodule_search_locations=[str(folder)])
        assert spec and spec.loader
        package = sys.modules["rclpy"] = module_from_spec(spec)
        stub("rclpy.impl", __path__=[str(folder / "impl")])
        stub("rclpy.impl.implementation_singleton", rclpy_implementation=c_module())
        events = ("EventHandler", "PublisherEventCallbacks", "SubscriptionEventCallbacks")
        stub("rclpy.event_handler", **dict.fromkeys(events, _Nothing))
        stub("rclpy.parameter_service", ParameterService=_Nothing)
        stub("rclpy.logging_service", LoggingService=_Nothing)
        stub("rclpy.type_description_service", TypeDescriptionService=_Nothing)
        names = ("check_for_type_support", "check_is_valid_msg_type", "check_is_valid_srv_type")
        checks = dict.fromkeys(names, lambda kind: None)
        stub("rclpy.type_support", **checks)
        stub("ament_index_python")
        stub("rcl_interfaces.srv", ListParameters=None)
        spec.loader.exec_module(package)
        yield


def on_the_oracle(node: Callable[[], object], folder: Path) -> Callable[[], None]:
    """The same node, but what it imports as rclpy is the real one's Python."""

    def real_node() -> None:
        import rclpy  # type: ignore[import-not-found]  # noqa: F401  # so that it is taken for a node of ROS 2

        with oracle(folder):
            node()

    return real_node
