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
    "launch.actions": "AppendEnvironmentVariable DeclareLaunchArgument EmitEvent ExecuteProcess GroupAction "
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
    "launch.launch_description_sources": " ".join(map(_SOURCES.format, ("Any", "Frontend", "Python"))),
    "launch.logging": "",
    "launch.substitutions": "AndSubstitution EnvironmentVariable EqualsSubstitution IfElseSubstitution "
    "LaunchConfiguration NotEqualsSubstitution NotSubstitution OrSubstitution PathJoinSubstitution PythonExpression "
    "SubstitutionFailure TextSubstitution ThisLaunchFile ThisLaunchFileDir",
    "launch.utilities": "normalize_to_list_of_substitutions=listed perform_substitutions=perform",
    "launch_ros": "",
    "launch_ros.actions": "Node PushROSNamespace PushRosNamespace=PushROSNamespace RosTimer=TimerAction "
    "SetParameter SetParametersFromFile SetRemap SetUseSimTime ROSTimer=TimerAction",
    "launch_ros.descriptions": _PARAMETERS,
    "launch_ros.parameter_descriptions": _PARAMETERS,
    "launch_ros.substitutions": "ExecutableInPackage",
    "launch_xml": "",
    "launch_xml.launch_description_sources": _SOURCES.format("XML"),
    "launch_yaml": "",
    "launch_yaml.launch_description_sources": _SOURCES.format("YAML"),
    "ament_index_python": "PackageNotFoundError",
    "ament_index_python.packages": "PackageNotFoundError",
}

# Those that are refused when they are used; a + is before what runs nodes in C++.
_REFUSED = {
    "launch": "LaunchService",
    "launch.actions": "ExecuteLocal OpaqueCoroutine PopEnvironment "
    "PopLaunchConfigurations PushEnvironment PushLaunchConfigurations ResetEnvironment ResetLaunchConfigurations",
    "launch.event_handlers": "OnExecutionComplete OnProcessIO",
    "launch.substitutions": "AllSubstitution AnonName AnySubstitution Command FileContent FindExecutable "
    "LaunchLogDir LocalSubstitution",
    "launch_ros.actions": "+ComposableNodeContainer LifecycleNode LifecycleTransition +LoadComposableNodes "
    "SetROSLogDir",
    "launch_ros.descriptions": "ComposableNode",
    "launch_ros.event_handlers": "OnStateTransition",
    "launch_ros.events.lifecycle": "ChangeState",
    "launch_ros.substitutions": "Parameter",
}


class PackageNotFoundError(KeyError):
    """There is no such package around the launch file."""

    def __str__(self) -> str:
        return str(self.args[0])


def modules(service: LaunchService) -> dict[str, ModuleType]:
    """Make the modules for one launch, by their names."""

    def get_logger(name: str = "") -> SimpleNamespace:
        def logs(level: str) -> Any:
            return lambda text, *args: service.log(level, name or "root", text)  # the arguments are lost there, too

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

    def share(package_name: str) -> str:
        return str(service.package(package_name))

    # A package has one folder here, which stands for all that are installed.
    folders: dict[str, Any] = {"get_package_share_directory": share, "get_package_prefix": share}
    folders["get_package_share_path"] = service.package
    vars(made["launch"]).update(SomeSubstitutionsType=object, LaunchDescriptionEntity=object)
    vars(made["launch.logging"]).update(get_logger=get_logger)
    vars(made["ament_index_python"]).update(folders)
    vars(made["ament_index_python.packages"]).update(folders)
    finds = {"find": lambda self, package_name: share(package_name)}
    found = type("FindPackageShare", (substitutions.FindPackageShare,), finds)
    vars(made["launch_ros.substitutions"]).update(FindPackageShare=found, FindPackagePrefix=found, FindPackage=found)
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
