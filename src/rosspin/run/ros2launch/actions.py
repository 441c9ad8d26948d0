"""What a launch file can do (sources: launch/actions, launch/conditions, launch_ros/actions)."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable
from dataclasses import KW_ONLY, dataclass, field
from typing import TYPE_CHECKING, Any

from ...clocks.frames import called_from
from ...rclpy.exceptions import InvalidNamespaceException
from ...rclpy.names import validate_namespace, validate_node_name
from ..tags import Fault
from . import events
from .parameters import evaluate, words_for
from .substitutions import Substitution, SubstitutionFailure, perform, perform_typed

if TYPE_CHECKING:
    from .context import LaunchContext

__all__ = [
    *("Action", "AppendEnvironmentVariable", "DeclareLaunchArgument", "EmitEvent"),
    *("ExecuteProcess", "GroupAction", "IfCondition", "IncludeLaunchDescription"),
    *("LaunchConfigurationEquals", "LaunchConfigurationNotEquals", "LaunchDescription", "LaunchDescriptionSource"),
    *("LogInfo", "Node", "OpaqueFunction", "PushROSNamespace"),
    *("Refused", "RegisterEventHandler", "SetEnvironmentVariable", "SetLaunchConfiguration"),
    *("SetParameter", "SetParametersFromFile", "SetRemap", "SetUseSimTime"),
    *("Shutdown", "TimerAction", "UnlessCondition", "UnregisterEventHandler"),
    *("UnsetEnvironmentVariable", "UnsetLaunchConfiguration"),
]


# --- conditions -------------------------------------------------------------------------------------------------------


@dataclass(eq=False)
class IfCondition:
    predicate_expression: Any
    _wanted = True

    def evaluate(self, context: LaunchContext) -> bool:
        text = perform(context, self.predicate_expression).strip().lower()
        if text not in ("true", "1", "false", "0"):
            raise ValueError(f"invalid condition expression, expected one of [true, 1, false, 0] but got '{text}'")
        return (text in ("true", "1")) == self._wanted


class UnlessCondition(IfCondition):
    _wanted = False


@dataclass(eq=False)
class LaunchConfigurationEquals:
    launch_configuration_name: str
    expected_value: Any
    _wanted = True

    def evaluate(self, context: LaunchContext) -> bool:
        expected = None if self.expected_value is None else perform(context, self.expected_value)
        return (context.launch_configurations.get(self.launch_configuration_name) == expected) == self._wanted


class LaunchConfigurationNotEquals(LaunchConfigurationEquals):
    _wanted = False


# --- actions ----------------------------------------------------------------------------------------------------------


@dataclass(eq=False)
class Action:
    """Something that a launch file does. ``place`` is the file and line that say so."""

    _: KW_ONLY
    condition: Any = None

    def __post_init__(self) -> None:
        frame = called_from(sys._getframe(1))
        self.place = f"{frame.f_code.co_filename}:{frame.f_lineno}"

    def visit(self, context: LaunchContext) -> Iterable[Any] | None:
        """Do it if its condition holds, and return what should be done next."""
        if self.condition is None or self.condition.evaluate(context):
            return self.execute(context)
        return None

    def execute(self, context: LaunchContext) -> Iterable[Any] | None:
        return None


class LaunchDescription:
    """The actions of a launch file."""

    def __init__(self, initial_entities: Iterable[Any] | None = None) -> None:
        self.entities = list(initial_entities or ())

    def add_action(self, action: Any) -> None:
        self.entities.append(action)

    add_entity = add_action

    def visit(self, context: LaunchContext) -> Iterable[Any]:
        return self.entities


@dataclass(eq=False)
class DeclareLaunchArgument(Action):
    name: str
    _: KW_ONLY
    default_value: Any = None
    description: str = "no description given"
    choices: list[str] | None = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.choices is not None and not self.choices:
            raise RuntimeError("Provided choices arg is empty. Use None to ignore the choice list.")
        if self.choices and isinstance(self.default_value, str) and self.default_value not in self.choices:
            raise RuntimeError(
                f'Provided default_value "{self.default_value}" is not in provided choices "{self.choices}".'
            )

    def execute(self, context: LaunchContext) -> None:
        values = context.launch_configurations
        if self.name not in values:
            if self.default_value is None:
                raise RuntimeError(f'Required launch argument "{self.name}" was not provided.')
            values[self.name] = perform(context, self.default_value)
        if self.choices is not None and values[self.name] not in self.choices:
            raise RuntimeError(
                f'Argument "{self.name}" provided value "{values[self.name]}" is not valid. '
                f"Valid options are: {self.choices}"
            )


@dataclass(eq=False)
class SetLaunchConfiguration(Action):
    name: Any
    value: Any

    def execute(self, context: LaunchContext) -> None:
        context.launch_configurations[perform(context, self.name)] = perform(context, self.value)


@dataclass(eq=False)
class UnsetLaunchConfiguration(Action):
    name: Any

    def execute(self, context: LaunchContext) -> None:
        context.launch_configurations.pop(perform(context, self.name), None)


class SetEnvironmentVariable(SetLaunchConfiguration):
    def execute(self, context: LaunchContext) -> None:
        context.environment[perform(context, self.name)] = perform(context, self.value)


@dataclass(eq=False)
class AppendEnvironmentVariable(Action):
    name: Any
    value: Any
    prepend: Any = False
    separator: Any = os.pathsep

    def execute(self, context: LaunchContext) -> None:
        name, value = perform(context, self.name), perform(context, self.value)
        parts = [context.environment[name], value] if name in context.environment else [value]
        if perform_typed(context, self.prepend, bool):
            parts.reverse()
        context.environment[name] = perform(context, self.separator).join(parts)


class UnsetEnvironmentVariable(UnsetLaunchConfiguration):
    def execute(self, context: LaunchContext) -> None:
        context.environment.pop(perform(context, self.name), None)


@dataclass(eq=False)
class GroupAction(Action):
    actions: Iterable[Any]
    _: KW_ONLY
    scoped: bool = True
    forwarding: bool = True
    launch_configurations: Any = None

    def execute(self, context: LaunchContext) -> Iterable[Any]:
        if not self.forwarding:
            raise NotImplementedError("GroupAction(forwarding=False) is not simulated")
        if self.scoped:
            context.push()
        for name, value in (self.launch_configurations or {}).items():
            context.launch_configurations[perform(context, name)] = perform(context, value)
        end = [OpaqueFunction(function=lambda context: context.pop())] if self.scoped else []
        return [*self.actions, *end]


@dataclass(eq=False)
class LaunchDescriptionSource:
    """A file with a launch description, in Python, XML or YAML."""

    location: Any


@dataclass(eq=False)
class IncludeLaunchDescription(Action):
    launch_description_source: Any
    _: KW_ONLY
    launch_arguments: Any = None

    def execute(self, context: LaunchContext) -> Iterable[Any]:
        source = self.launch_description_source
        source = source.location if isinstance(source, LaunchDescriptionSource) else source
        path = os.path.abspath(source if isinstance(source, os.PathLike) else perform(context, source))
        description = context.service.load(path)
        folder = os.path.dirname(path)
        context.known.update({"current_launch_file_path": path, "current_launch_file_directory": folder})
        arguments = tuple(self.launch_arguments or ())
        given = [perform(context, name) for name, _ in arguments]
        for action in description.entities:
            if isinstance(action, DeclareLaunchArgument) and action.condition is None and action.default_value is None:
                if action.name not in given:
                    raise Fault(
                        f"{self.place or action.place}: Included launch description missing required argument "
                        f"'{action.name}' (description: '{action.description}'), given: [{', '.join(given)}]"
                    )
        return [*(SetLaunchConfiguration(*each) for each in arguments), description]


@dataclass(eq=False)
class TimerAction(Action):
    _: KW_ONLY
    period: Any
    actions: Iterable[Any]
    cancel_on_shutdown: Any = True
    cancelled = False

    def __post_init__(self) -> None:
        super().__post_init__()
        if isinstance(self.period, int):
            raise TypeError(
                "'TimerAction' expected 'period' to be a float or a substitution, "
                f"but got '{self.period}' of type '{type(self.period)}'"
            )

    def execute(self, context: LaunchContext) -> None:
        if self.cancelled:
            return
        event = events.TimerEvent(timer_action=self, locals=dict(context.known))
        period = float(self.period) if isinstance(self.period, str) else self.period
        self.timer = context.service.after(
            perform_typed(context, period, float), lambda: context.emit_event_sync(event)
        )
        if perform_typed(context, self.cancel_on_shutdown, bool):
            context.register_event_handler(events.OnShutdown(on_shutdown=lambda event, context: self.cancel()))

    def cancel(self) -> None:
        """Forget it, unless its time has come."""
        self.cancelled = True
        if hasattr(self, "timer"):
            self.timer.cancel()


@dataclass(eq=False)
class OpaqueFunction(Action):
    _: KW_ONLY
    function: Any
    args: Any = ()
    kwargs: Any = field(default_factory=dict)

    def execute(self, context: LaunchContext) -> Any:
        return self.function(context, *(self.args or ()), **(self.kwargs or {}))


@dataclass(eq=False)
class LogInfo(Action):
    _: KW_ONLY
    msg: Any

    def execute(self, context: LaunchContext) -> None:
        context.service.log("INFO", "launch.user", perform(context, self.msg))


@dataclass(eq=False)
class RegisterEventHandler(Action):
    event_handler: Any

    def execute(self, context: LaunchContext) -> None:
        if isinstance(self.event_handler, Refused):
            self.event_handler.execute(context)
        context.register_event_handler(self.event_handler)


class UnregisterEventHandler(RegisterEventHandler):
    def execute(self, context: LaunchContext) -> None:
        context.event_handlers.remove(self.event_handler)


@dataclass(eq=False)
class EmitEvent(Action):
    _: KW_ONLY
    event: Any

    def execute(self, context: LaunchContext) -> None:
        context.emit_event_sync(self.event)


@dataclass(eq=False)
class Shutdown(Action):
    _: KW_ONLY
    reason: Any = "reason not given"

    def execute(self, context: LaunchContext) -> None:
        event = context.known.get("event")
        if isinstance(event, events.ProcessExited):
            text = f"process[{event.process_name}] was required: shutting down launched system"
            context.service.log("INFO", "launch", text)
        context.emit_event_sync(events.Shutdown(reason=perform(context, self.reason)))


class Refused(Action, Substitution):
    """Something that is not simulated, which matters as soon as it should be done."""

    name = ""
    is_cpp = False  # whether it runs nodes in C++

    def __init__(self, *args: Any, condition: Any = None, **kwargs: Any) -> None:
        super().__init__(condition=condition)

    def execute(self, context: LaunchContext) -> None:
        if not self.is_cpp or not context.service.leaves_out(self.place, self.name):
            raise NotImplementedError(f"{self.name} is not simulated")

    def perform(self, context: LaunchContext) -> str:
        self.execute(context)
        return ""


# --- processes --------------------------------------------------------------------------------------------------------


@dataclass(eq=False, kw_only=True)
class ExecuteProcess(Action):
    cmd: Iterable[Any]
    name: Any = None
    cwd: Any = None
    env: Any = None
    additional_env: Any = None
    prefix: Any = None
    shell: bool = False
    output: Any = "log"
    on_exit: Any = None
    respawn: Any = False
    respawn_delay: float | None = None
    respawn_max_retries: int = -1
    sigterm_timeout: Any = None
    sigkill_timeout: Any = None
    emulate_tty: bool = False
    cached_output: bool = False

    def execute(self, context: LaunchContext) -> None:
        words = [perform(context, word) for word in self.cmd]
        code, args = context.service.command(self.place, words)
        if code:
            name = perform(context, self.name) if self.name else os.path.basename(words[0])
            context.service.start(self, name, code, args)


@dataclass(eq=False, kw_only=True)
class Node(ExecuteProcess):
    cmd: Iterable[Any] = ()
    executable: Any
    package: Any = None
    namespace: Any = None
    exec_name: Any = None
    parameters: Any = None
    remappings: Any = None
    ros_arguments: Any = None
    arguments: Any = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if not isinstance(self.parameters, (list, type(None))):
            raise TypeError(
                "'Node' expected 'parameters' to be one of [<class 'list'>], but got "
                f"'{self.parameters}' of type '{type(self.parameters)}'"
            )

    def execute(self, context: LaunchContext) -> None:
        name = perform(context, self.executable)
        if self.package is None:
            code, args = context.service.command(self.place, [name])
        else:
            code, args = context.service.node(self.place, perform(context, self.package), name), []
        if code:
            words = [*(self.arguments or ()), *(["--ros-args", *self.ros_arguments] if self.ros_arguments else [])]
            args = [*args, *(perform(context, word) for word in words), "--ros-args", *self._ros_words(context)]
            shown = perform(context, self.exec_name) if self.exec_name else os.path.basename(name)
            context.service.start(self, shown, code, args)
            if self._full_name:
                context.service.note_node(self._full_name)

    def _ros_words(self, context: LaunchContext) -> Iterable[str]:
        values = context.launch_configurations
        name = None if self.name is None else perform(context, self.name)
        own = None if self.namespace is None else perform(context, self.namespace)
        namespace = _joined(values.get("ros_namespace"), own)
        if name is not None:
            validate_node_name(name)
            yield from ("-r", f"__node:={name}")
        if namespace is not None:
            validate_namespace(namespace)
            yield from ("-r", f"__ns:={namespace}")
        for each in values.get("global_params", ()):
            if isinstance(each, tuple):
                yield from ("-p", "{}:={}".format(*each))
            elif os.path.isfile(each):
                yield from ("--params-file", os.path.abspath(each))
            else:
                raise FileNotFoundError(f"there is no parameter file {each}")
        self._full_name = f"{namespace.rstrip('/')}/{name}" if name and namespace is not None else ""
        yield from words_for(context, self.parameters or (), self._full_name or "/**")
        for source, target in (*values.get("ros_remaps", ()), *(self.remappings or ())):
            yield from ("-r", f"{perform(context, source)}:={perform(context, target)}")


def _joined(base: str | None, name: str | None) -> str | None:
    """Return an absolute namespace of an outer one and one in it; None if there is none."""
    if base is None and name is None:
        return None
    joined = name or "" if not base or (name or "").startswith("/") else f"{base.rstrip('/')}/{name or ''}"
    return f"/{joined.rstrip('/').removeprefix('/')}"


@dataclass(eq=False)
class PushROSNamespace(Action):
    namespace: Any

    def execute(self, context: LaunchContext) -> None:
        before, pushed = context.launch_configurations.get("ros_namespace"), perform(context, self.namespace)
        namespace = _joined(before, pushed)
        try:
            validate_namespace(namespace or "")
        except InvalidNamespaceException:
            raise SubstitutionFailure(
                f"The resulting namespace is invalid: [previous_namespace='{before}', pushed_namespace='{pushed}']"
            ) from None
        context.launch_configurations["ros_namespace"] = namespace


@dataclass(eq=False)
class SetParameter(Action):
    name: Any
    value: Any

    def execute(self, context: LaunchContext) -> None:
        found = evaluate(context, {perform(context, self.name): self.value})
        context.launch_configurations.setdefault("global_params", []).extend(found)


@dataclass(eq=False)
class SetParametersFromFile(Action):
    filename: Any

    def execute(self, context: LaunchContext) -> None:
        context.launch_configurations.setdefault("global_params", []).append(perform(context, self.filename))


@dataclass(eq=False)
class SetUseSimTime(Action):
    """Sets the parameter of the node that ros2 launch has itself, which no other node sees."""

    value: Any

    def execute(self, context: LaunchContext) -> None:
        if type(self.value) is not bool:
            raise ValueError(f"Type 'Type.BOOL' and value '{self.value}' do not agree")
        if not self.value:
            raise RuntimeError("Failed to set use_sim_time parameter")


@dataclass(eq=False)
class SetRemap(Action):
    src: Any
    dst: Any

    def execute(self, context: LaunchContext) -> None:
        remap = (perform(context, self.src), perform(context, self.dst))
        context.launch_configurations.setdefault("ros_remaps", []).append(remap)
