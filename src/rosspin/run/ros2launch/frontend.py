"""Launch files in XML and YAML (sources: launch/frontend, launch_xml, launch_yaml and the actions' parse methods)."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterator
from contextlib import suppress
from typing import Any

from ...world import yaml_texts
from ..tags import Fault, Tag, parse
from . import actions
from .parameters import ParameterFile, ParameterValue
from .substitutions import TextSubstitution, coerce, is_of, parse_substitution

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
            root = yaml_texts.compose(file)
            if not isinstance(root, yaml.MappingNode) or len(root.value) != 1:
                raise Fault(f"{path}:1: Expected only one root")
            return _description(_YamlTag.made(path, *root.value[0]))
        except yaml.YAMLError as error:
            mark = getattr(error, "problem_mark", None)
            raise Fault(f"{path}:{mark.line + 1 if mark else 1}: {error}") from None


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
                for each in entities:
                    if each.id != "mapping" or len(each.value) != 1:
                        what = "Subentities must be a dictionary with only one key, which is the entity type"
                        raise Fault(f"{path}:{each.start_mark.line + 1}: {what}")
                    tag.children.append(cls.made(path, *each.value[0]))
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
        """Return an attribute, which is a text or of the type ``kind``; if that is None, of any type."""
        tag, in_yaml = self.tag, isinstance(self.tag, _YamlTag)
        if name not in self._left:
            if optional:
                return None
            lacks = f"Attribute '{name}' of type '{kind}' not found in Entity '{tag.name}'"
            raise tag.fault(f"Can not find attribute '{name}' in Entity '{tag.name}'" if in_yaml else lacks)
        value = self._left.pop(name)
        if in_yaml:
            if not (isinstance(value, str) or is_of(value, kind)):
                expected = f"Attribute '{name}' of Entity '{tag.name}' expected to be of type '{kind}'"
                raise tag.fault(f"{expected}, got '{type(value)}'")
            return value
        separator = self._left.pop(f"{name}-sep", None)
        values = [value] if separator is None else value.split(separator)
        for number, each in enumerate(values):
            with suppress(ValueError):  # there may be substitutions in it
                values[number] = coerce(each, kind)
        return values[0] if separator is None else values

    def text(self, name: str, optional: bool = True) -> Any:
        """Return an attribute in which substitutions are made."""
        value = self.take(name, optional=optional)
        return None if value is None else parse_substitution(value)

    def texts(self, *names: str) -> list[Any]:
        """Return attributes that must be there, in which substitutions are made."""
        return [self.text(name, optional=False) for name in names]

    def typed(self, name: str, kind: Any, optional: bool = True) -> Any:
        """Return an attribute of a type, or the substitutions that make it."""
        return _typed(self.take(name, kind, optional))

    def words(self, name: str) -> list[Any]:
        """Return a command line, some of whose words are substitutions."""
        return _words(self.take(name) or "")

    def pairs(self, nested: str, *names: str) -> list[tuple[Any, ...]]:
        """Return the attributes of nested tags."""
        return [tuple(child.texts(*names)) for child in self.nested(nested)]

    def nested(self, *names: str) -> Iterator[_Entity]:
        """Yield the tags of these names within it; any, if none is given."""
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
        if self._left:
            what = "key" if in_yaml else "attribute"
            raise self.tag.fault(f"Unexpected {what}(s) found in `{name}`: {{'{next(iter(self._left))}'}}")


def _typed(value: Any) -> Any:
    if isinstance(value, list):
        return [_typed(each) for each in value]
    if not isinstance(value, str):
        return value
    parts = parse_substitution(value)
    return parts[0].text if len(parts) == 1 and isinstance(parts[0], TextSubstitution) else parts


def _words(text: str) -> list[Any]:
    words: list[list[Any]] = [[]]
    for part in parse_substitution(text):
        if not isinstance(part, TextSubstitution):
            words[-1].append(part)
            continue
        for number, token in enumerate(shlex.split(part.text)):
            if number or part.text[0].isspace():
                words.append([])
            words[-1].append(TextSubstitution(text=token))
        if part.text[-1:].isspace():
            words.append([])
    return [word for word in words if word]


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
    try:
        given = [kind(text) for name, kind in conditions.items() if (text := entity.text(name))]
        if len(given) == 2:
            raise RuntimeError("if and unless conditions can't be used simultaneously")
        action = _READERS[tag.name](entity)
    except Fault:
        raise
    except (TypeError, RuntimeError, ValueError) as error:
        raise tag.fault(str(error)) from None
    entity.end()
    action.place = f"{tag.file}:{tag.line}"
    action.condition = given[0] if given else None
    return action


def _arg(entity: _Entity) -> Any:
    given = {"choices": [child.take("value", optional=False) for child in entity.nested("choice")] or None}
    given |= {"default_value": entity.text("default"), "description": entity.take("description")}
    return actions.DeclareLaunchArgument(entity.take("name", optional=False), **_without_none(given))


def _include(entity: _Entity) -> Any:
    arguments = [child.texts("name", "value") for child in entity.nested("arg")]
    return actions.IncludeLaunchDescription(entity.text("file", optional=False), launch_arguments=arguments)


def _group(entity: _Entity) -> Any:
    return actions.GroupAction(scoped=entity.take("scoped", bool) is not False, actions=_actions(entity))


def _timer(entity: _Entity) -> Any:
    return actions.TimerAction(period=entity.typed("period", float, optional=False), actions=_actions(entity))


def _process(entity: _Entity) -> dict[str, Any]:
    """Return what <node> and <executable> have in common."""
    given = {name: entity.text(name) for name in ("cwd", "output", "respawn", "sigterm_timeout", "sigkill_timeout")}
    given["respawn_delay"] = entity.take("respawn_delay", float)
    given["respawn_max_retries"] = entity.take("respawn_max_retries", int)
    given["emulate_tty"], given["prefix"] = entity.take("emulate_tty", bool), entity.text("launch-prefix")
    given["additional_env"] = {tuple(name): value for name, value in entity.pairs("env", "name", "value")}
    on_exit = entity.take("on_exit")
    if on_exit not in (None, "shutdown"):
        raise RuntimeError(f"Attribute on_exit of Entity node expected to be shutdown but got `{on_exit}`")
    given["on_exit"] = on_exit and [actions.Shutdown()]
    return _without_none(given)


def _executable(entity: _Entity) -> Any:
    command = _words(entity.take("cmd", optional=False))
    return actions.ExecuteProcess(cmd=command, name=entity.text("name"), **_process(entity))


def _node(entity: _Entity) -> Any:
    return actions.Node(
        executable=entity.text("exec", optional=False),
        package=entity.text("pkg"),
        name=entity.text("name"),
        namespace=entity.text("namespace"),
        exec_name=entity.text("exec_name"),
        arguments=entity.words("args"),
        ros_arguments=entity.words("ros_args") or None,
        remappings=entity.pairs("remap", "from", "to"),
        parameters=[_param(child) for child in entity.nested("param")],
        **_process(entity),
    )


def _param(entity: _Entity) -> Any:
    if (file := entity.text("from")) is None:
        return dict([_pair(entity)])
    return ParameterFile(file, allow_substs=entity.typed("allow_substs", bool) or False)


def _pair(entity: _Entity) -> tuple[Any, Any]:
    """Return the name of a parameter with its value, or with those whose names begin with it."""
    type_name = entity.take("type")
    if type_name is not None and type_name not in _TYPES:
        raise ValueError(f"{type_name!r} is no type of a parameter: {', '.join(_TYPES)}")
    kind = None if type_name is None else _TYPES[type_name]
    value, nested = entity.typed("value", kind), dict(_pair(child) for child in entity.nested("param"))
    if (value is None) == (not nested):
        raise RuntimeError("either a value attribute or nested params are needed")
    return tuple(entity.text("name", optional=False)), nested or ParameterValue(value, value_type=kind)


def _without_none(given: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in given.items() if value is not None}


def _simple(kind: Callable[..., Any], *names: str) -> Callable[[_Entity], Any]:
    return lambda entity: kind(*entity.texts(*names))


def _append_env(entity: _Entity) -> Any:
    given = {"prepend": entity.typed("prepend", bool), "separator": entity.text("separator")}
    return actions.AppendEnvironmentVariable(*entity.texts("name", "value"), **_without_none(given))


_READERS: dict[str, Callable[[_Entity], Any]] = {
    "arg": _arg,
    "executable": _executable,
    "group": _group,
    "include": _include,
    "node": _node,
    "timer": _timer,
    "let": _simple(actions.SetLaunchConfiguration, "name", "value"),
    "append_env": _append_env,
    "set_env": _simple(actions.SetEnvironmentVariable, "name", "value"),
    "unset_env": _simple(actions.UnsetEnvironmentVariable, "name"),
    "push_ros_namespace": _simple(actions.PushROSNamespace, "namespace"),
    "push-ros-namespace": _simple(actions.PushROSNamespace, "namespace"),
    "set_parameter": _simple(actions.SetParameter, "name", "value"),
    "set_parameters_from_file": _simple(actions.SetParametersFromFile, "filename"),
    "set_remap": _simple(actions.SetRemap, "from", "to"),
    "log": lambda entity: actions.LogInfo(msg=entity.text("message", optional=False)),
    "shutdown": lambda entity: actions.Shutdown(reason=entity.text("reason") or "reason not given"),
}
