"""What a launch file imports: ``launch``, ``launch_ros`` and ``ament_index_python``, found only while it is read."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import ModuleType, SimpleNamespace
from typing import TYPE_CHECKING, Any

from . import actions, context, events, parameters, substitutions

if TYPE_CHECKING:
    from .service import LaunchService

__all__ = ["PackageNotFoundError", "modules", "within"]

_SOURCES = "{}LaunchDescriptionSource=LaunchDescriptionSource"
_PARAMETERS = "Parameter ParameterFile ParameterValue"

# The names in each module; "name=another" is one that is called otherwise here.
_NAMES = {
    "launch": "Action Event EventHandler LaunchContext LaunchDescription LaunchDescriptionSource Substitution",
    "launch.actions": "DeclareLaunchArgument EmitEvent ExecuteProcess GroupAction "
    "IncludeLaunchDescription LogInfo OpaqueFunction RegisterEventHandler SetEnvironmentVariable "
    "SetLaunchConfiguration Shutdown TimerAction UnregisterEventHandler UnsetEnvironmentVariable "
    "UnsetLaunchConfiguration",
    "launch.conditions": "IfCondition LaunchConfigurationEquals LaunchConfigurationNotEquals UnlessCondition",
    "launch.event_handlers": "OnProcessExit OnProcessStart OnShutdown",
    "launch.events": "Shutdown matches_action",
    "launch.events.process": "ProcessExited ProcessStarted ShutdownProcess SignalProcess",
    "launch.frontend": "",
    "launch.launch_context": "LaunchContext",
    "launch.launch_description": "LaunchDescription",
    "launch.launch_description_sources": " ".join(map(_SOURCES.format, ("Any", "Frontend", "Python", "XML", "YAML"))),
    "launch.logging": "",
    "launch.substitutions": " ".join(name for name in substitutions.__all__ if name[0].isupper()),
    "launch.utilities": "normalize_to_list_of_substitutions=listed perform_substitutions=perform",
    "launch_ros": "",
    "launch_ros.actions": "Node PushROSNamespace PushRosNamespace=PushROSNamespace RosTimer=TimerAction "
    "SetParameter SetRemap ROSTimer=TimerAction",
    "launch_ros.descriptions": _PARAMETERS,
    "launch_ros.parameter_descriptions": _PARAMETERS,
    "launch_ros.substitutions": "FindPackage=FindPackageShare FindPackageShare",
    "launch_xml": "",
    "launch_xml.launch_description_sources": _SOURCES.format("XML"),
    "launch_yaml": "",
    "launch_yaml.launch_description_sources": _SOURCES.format("YAML"),
    "ament_index_python": "PackageNotFoundError get_package_prefix",
    "ament_index_python.packages": "PackageNotFoundError get_package_prefix",
}

# Those that are refused when they are used; a + is before what runs nodes in C++.
_REFUSED = {
    "launch": "LaunchService",
    "launch.actions": "AppendEnvironmentVariable ExecuteLocal OpaqueCoroutine PopEnvironment "
    "PopLaunchConfigurations PushEnvironment PushLaunchConfigurations ResetEnvironment ResetLaunchConfigurations",
    "launch.event_handlers": "OnExecutionComplete OnProcessIO",
    "launch.substitutions": "AllSubstitution AnonName AnySubstitution Command FileContent FindExecutable "
    "LaunchLogDir LocalSubstitution",
    "launch_ros.actions": "+ComposableNodeContainer LifecycleNode LifecycleTransition +LoadComposableNodes "
    "SetParametersFromFile SetROSLogDir SetUseSimTime",
    "launch_ros.descriptions": "ComposableNode",
    "launch_ros.event_handlers": "OnStateTransition",
    "launch_ros.events.lifecycle": "ChangeState",
    "launch_ros.substitutions": "ExecutableInPackage FindPackagePrefix Parameter",
}


class PackageNotFoundError(KeyError):
    """There is no such package around the launch file."""

    def __str__(self) -> str:
        return str(self.args[0])


def get_package_prefix(package_name: str) -> str:
    raise NotImplementedError("get_package_prefix is not simulated")


def modules(service: LaunchService) -> dict[str, ModuleType]:
    """Make the modules for one launch, by their names."""

    def get_logger(name: str = "") -> SimpleNamespace:
        def logs(level: str) -> Any:
            return lambda text, *args: service.log(level, name or "root", text % args if args else str(text))

        levels = {"info": "INFO", "warning": "WARNING", "warn": "WARNING", "error": "ERROR"}
        return SimpleNamespace(debug=lambda *args: None, **{name: logs(level) for name, level in levels.items()})

    made: dict[str, ModuleType] = {}
    for name in sorted({*_NAMES, *_REFUSED}):
        module = made[name] = ModuleType(name)
        module.__path__ = []
        for each in _NAMES.get(name, "").split():
            alias, _, own = each.partition("=")
            setattr(module, alias, _named(name, own or alias))
        for each in _REFUSED.get(name, "").split():
            members = {"name": f"{name}.{each.lstrip('+')}", "is_cpp": each.startswith("+")}
            setattr(module, each.lstrip("+"), type(each.lstrip("+"), (actions.Refused,), members))
        parent, _, child = name.rpartition(".")
        if parent:
            setattr(made.setdefault(parent, ModuleType(parent)), child, module)
    made["launch"].SomeSubstitutionsType = made["launch"].LaunchDescriptionEntity = object  # type: ignore[attr-defined]
    made["launch.logging"].get_logger = get_logger  # type: ignore[attr-defined]
    for name in ("ament_index_python", "ament_index_python.packages"):
        made[name].get_package_share_directory = lambda package_name: str(service.package(package_name))  # type: ignore[attr-defined]
    return made


def _named(module: str, name: str) -> Any:
    places: list[Any] = [actions, events, substitutions, parameters, context, sys.modules[__name__]]
    if module.startswith("launch.events"):
        places.insert(0, events)
    return next(getattr(place, name) for place in places if hasattr(place, name))


@contextmanager
def within(modules: dict[str, ModuleType]) -> Iterator[None]:
    """Within this context these modules are imported, and none of a real ROS with such a name."""
    roots = {name.partition(".")[0] for name in modules}
    hidden = {name: sys.modules.pop(name) for name in list(sys.modules) if name.partition(".")[0] in roots}
    sys.modules.update(modules)
    try:
        yield
    finally:
        for name in list(sys.modules):
            if name.partition(".")[0] in roots:
                del sys.modules[name]
        sys.modules.update(hidden)
