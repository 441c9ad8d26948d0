"""Launch files in XML and YAML (sources: launch/frontend, launch_xml, launch_yaml and the actions' parse methods)."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from typing import Any

from ..tags import Tag, parse
from . import actions
from .parameters import ParameterFile, ParameterValue
from .substitutions import TextSubstitution, coerce, parse_substitution

__all__ = ["read_xml", "read_yaml"]

_TYPES: dict[str, Any] = {"int": int, "float": float, "bool": bool, "str": str}
_TYPES |= {"list_of_ints": list[int], "list_of_floats": list[float]}
_TYPES |= {"list_of_bools": list[bool], "list_of_strs": list[str]}


def read_xml(path: str) -> actions.LaunchDescription:
    """Read a file in XML. Raises OSError, and ValueError, with file and line, for anything that is faulty."""
    return _description(parse(path))


def read_yaml(path: str) -> actions.LaunchDescription:
    """Read a file in YAML. Raises OSError, and ValueError, with file and line, for anything that is faulty."""
    import yaml

    with open(path, encoding="utf-8") as file:
        try:
            root = yaml.compose(file, yaml.SafeLoader)
            if not isinstance(root, yaml.MappingNode) or len(root.value) != 1:
                raise ValueError(f"{path}:1: Expected only one root")
            return _description(_YamlTag.made(path, *root.value[0]))
        except yaml.YAMLError as error:
            mark = getattr(error, "problem_mark", None)
            raise ValueError(f"{path}:{mark.line + 1 if mark else 1}: {error}") from None


class _YamlTag(Tag):
    """An entity in YAML, whose attributes have types of their own."""

    @classmethod
    def made(cls, path: str, key: Any, node: Any) -> _YamlTag:
        import yaml

        def plain(each: Any) -> Any:
            return yaml.constructor.SafeConstructor().construct_object(each, deep=True)

        tag = cls(key.value, {}, path, key.start_mark.line + 1)
        pairs = node.value if node.id == "mapping" else [(yaml.ScalarNode("", "children"), node)]
        for name, value in pairs:
            entities = value.value if value.id == "sequence" else []
            if name.value == "children":
                if not all(each.id == "mapping" and len(each.value) == 1 for each in entities):
                    raise tag.fault("Subentities must be a dictionary with only one key, which is the entity type")
                tag.children += [cls.made(path, *each.value[0]) for each in entities]
            elif entities and entities[0].id == "mapping":
                tag.children += [cls.made(path, name, each) for each in entities]
            else:
                tag.attributes[name.value] = plain(value)
        return tag


class _Entity:
    """Gives what a tag says. When all has been taken that means something, :meth:`end` finds what is left."""

    def __init__(self, tag: Tag) -> None:
        self.tag = tag
        self._left = dict(tag.attributes)
        self._children = list(tag.children)

    def take(self, name: str, kind: Any = str, optional: bool = True) -> Any:
        """An attribute, which is a text or of the type ``kind``; if that is None, of any type."""
        tag, in_yaml = self.tag, isinstance(self.tag, _YamlTag)
        if name not in self._left:
            if optional:
                return None
            lacks = f"Attribute '{name}' of type '{kind}' not found in Entity '{tag.name}'"
            raise tag.fault(f"Can not find attribute '{name}' in Entity '{tag.name}'" if in_yaml else lacks)
        value = self._left.pop(name)
        if in_yaml:
            if kind is not None and not isinstance(value, (str, kind)):
                expected = f"Attribute '{name}' of Entity '{tag.name}' expected to be of type '{kind}'"
                raise tag.fault(f"{expected}, got '{type(value)}'")
            return value
        separator = self._left.pop(f"{name}-sep", None)
        return [_read(each, kind) for each in value.split(separator)] if separator else _read(value, kind)

    def text(self, name: str, optional: bool = True) -> Any:
        """An attribute in which substitutions are made."""
        value = self.take(name, optional=optional)
        return None if value is None else parse_substitution(value)

    def texts(self, *names: str) -> list[Any]:
        """Attributes that must be there, in which substitutions are made."""
        return [self.text(name, optional=False) for name in names]

    def nested(self, *names: str) -> Iterator[_Entity]:
        """The tags of these names within it; any, if none is given."""
        for child in self._children[:]:
            if not names or child.name in names:
                self._children.remove(child)
                entity = _Entity(child)
                yield entity
                if names:
                    entity.end()

    def end(self) -> None:
        """Raise ValueError if something has not been taken."""
        in_yaml, name = isinstance(self.tag, _YamlTag), self.tag.name
        if self._children:
            raise self.tag.fault(f"Unexpected nested tag(s) found in `{name}`: {{'{self._children[0].name}'}}")
        for each in self._left:
            what = "key" if in_yaml else "attribute"
            raise self.tag.fault(f"Unexpected {what}(s) found in `{name}`: {{'{each}'}}")


def _read(text: str, kind: Any) -> Any:
    if kind is str:
        return text
    try:
        return coerce(text, kind)
    except ValueError:
        return text  # there may be substitutions in it


def _typed(value: Any) -> Any:
    """A value that is there, or the substitutions that make it."""
    if isinstance(value, list):
        return [_typed(each) for each in value]
    if not isinstance(value, str):
        return value
    parts = parse_substitution(value)
    return parts[0].text if len(parts) == 1 and isinstance(parts[0], TextSubstitution) else parts


# --- what tags mean ---------------------------------------------------------------------------------------------------


def _description(root: Tag) -> actions.LaunchDescription:
    if root.name != "launch":
        raise root.fault("Expected 'launch' as root tag")
    return actions.LaunchDescription(_actions(_Entity(root)))


def _actions(entity: _Entity) -> list[Any]:
    return [_action(child) for child in entity.nested()]


def _action(entity: _Entity) -> Any:
    tag = entity.tag
    if tag.name not in _READERS:
        raise tag.fault(f"Unrecognized entity of the type: {tag.name}")
    conditions = {"if": actions.IfCondition, "unless": actions.UnlessCondition}
    given = {name: entity.text(name) for name in conditions if name in tag.attributes}
    if len(given) == 2:
        raise tag.fault("if and unless conditions can't be used simultaneously")
    try:
        action = _READERS[tag.name](entity)
    except (TypeError, RuntimeError) as error:
        raise tag.fault(str(error)) from None
    if not isinstance(action, actions.Refused):
        entity.end()
    action.place = f"{tag.file}:{tag.line}"
    action.condition = next((conditions[name](text) for name, text in given.items()), None)
    return action


def _arg(entity: _Entity) -> Any:
    name = entity.take("name", optional=False)
    choices = [child.take("value", optional=False) for child in entity.nested("choice")] or None
    description = entity.take("description") or "no description given"
    default = entity.text("default")
    return actions.DeclareLaunchArgument(name, default_value=default, description=description, choices=choices)


def _include(entity: _Entity) -> Any:
    arguments = [child.texts("name", "value") for child in entity.nested("arg")]
    return actions.IncludeLaunchDescription(entity.text("file", optional=False), launch_arguments=arguments)


def _group(entity: _Entity) -> Any:
    scoped = entity.take("scoped", bool)
    return actions.GroupAction(_actions(entity), scoped=scoped is not False)


def _timer(entity: _Entity) -> Any:
    period = _typed(entity.take("period", float, optional=False))
    return actions.TimerAction(period=period, actions=_actions(entity))


def _process(entity: _Entity) -> dict[str, Any]:
    """What <node> and <executable> have in common."""
    on_exit = entity.take("on_exit")
    if on_exit not in (None, "shutdown"):
        raise entity.tag.fault(f"Attribute on_exit of Entity node expected to be shutdown but got `{on_exit}`")
    found = {name: entity.text(name) for name in ("cwd", "output", "respawn")}
    found |= {name: entity.take(name, float) for name in ("respawn_delay", "sigterm_timeout", "sigkill_timeout")}
    found["respawn_max_retries"] = entity.take("respawn_max_retries", int)
    found["emulate_tty"], found["prefix"] = entity.take("emulate_tty", bool), entity.text("launch-prefix")
    found["shell"] = entity.take("shell", bool)
    found["on_exit"] = on_exit and [actions.Shutdown()]
    environment = [child.texts("name", "value") for child in entity.nested("env")]
    found["additional_env"] = {tuple(name): value for name, value in environment}
    return {name: value for name, value in found.items() if value is not None}


def _executable(entity: _Entity) -> Any:
    command = _words(entity.take("cmd", optional=False))
    return actions.ExecuteProcess(cmd=command, name=entity.text("name"), **_process(entity))


def _node(entity: _Entity) -> Any:
    arguments, ros_arguments = entity.take("args"), entity.take("ros_args")
    return actions.Node(
        executable=entity.text("exec", optional=False),
        package=entity.text("pkg"),
        name=entity.text("name"),
        namespace=entity.text("namespace"),
        exec_name=entity.text("exec_name"),
        arguments=arguments and _words(arguments),
        ros_arguments=ros_arguments and _words(ros_arguments),
        remappings=[tuple(child.texts("from", "to")) for child in entity.nested("remap")],
        parameters=[_param(child) for child in entity.nested("param")],
        **_process(entity),
    )


def _param(entity: _Entity) -> Any:
    file, allows = entity.text("from"), entity.take("allow_substs", bool)
    if file is None:
        return dict([_pair(entity)])
    if "name" in entity.tag.attributes:
        raise entity.tag.fault("name and from attributes are mutually exclusive")
    return ParameterFile(file, allow_substs=_typed(allows) if allows else False)


def _pair(entity: _Entity) -> tuple[Any, Any]:
    """The name and the value of a parameter, or of several whose names begin with its own."""
    name, type_name = tuple(entity.text("name", optional=False)), entity.take("type")
    kind = None if type_name is None else _TYPES[type_name]
    value = entity.take("value", kind)
    nested = dict(_pair(child) for child in entity.nested("param"))
    if (value is None) == (not nested):
        raise entity.tag.fault("either a value attribute or nested params are needed")
    return name, nested or ParameterValue(_typed(value), value_type=kind)


def _words(text: str) -> list[list[Any]]:
    """Split a command line into words, some of which are substitutions."""
    words: list[list[Any]] = [[]]
    for part in parse_substitution(text):
        if not isinstance(part, TextSubstitution):
            words[-1].append(part)
            continue
        for number, token in enumerate(shlex.split(part.text)):
            if number or part.text[0].isspace():
                words.append([])
            words[-1].append(TextSubstitution(text=token))
        if part.text[-1].isspace():
            words.append([])
    return [word for word in words if word]


def _simple(kind: Callable[..., Any], *names: str) -> Callable[[_Entity], Any]:
    return lambda entity: kind(*entity.texts(*names))


def _refused(name: str) -> Callable[[_Entity], Any]:
    return lambda entity: type(name, (actions.Refused,), {"name": f"<{name}>", "is_cpp": "composable" in name})()


_READERS: dict[str, Callable[[_Entity], Any]] = {
    "arg": _arg,
    "executable": _executable,
    "group": _group,
    "include": _include,
    "node": _node,
    "timer": _timer,
    "let": _simple(actions.SetLaunchConfiguration, "name", "value"),
    "set_env": _simple(actions.SetEnvironmentVariable, "name", "value"),
    "unset_env": _simple(actions.UnsetEnvironmentVariable, "name"),
    "append_env": _simple(actions.AppendEnvironmentVariable, "name", "value"),
    "push_ros_namespace": _simple(actions.PushROSNamespace, "namespace"),
    "push-ros-namespace": _simple(actions.PushROSNamespace, "namespace"),
    "set_parameter": _simple(actions.SetParameter, "name", "value"),
    "set_parameters_from_file": _simple(actions.SetParametersFromFile, "filename"),
    "set_use_sim_time": _simple(actions.SetUseSimTime, "value"),
    "set_remap": _simple(actions.SetRemap, "from", "to"),
    "log": lambda entity: actions.LogInfo(msg=entity.text("message", optional=False)),
    "shutdown": lambda entity: actions.Shutdown(reason=entity.text("reason") or "reason not given"),
    **{name: _refused(name) for name in ("node_container", "load_composable_node", "lifecycle_node", "ros_timer")},
}
