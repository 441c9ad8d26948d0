"""Read what follows ``--ros-args`` on a command line (sources: rcl/arguments.c, rcl_yaml_param_parser/parse.c)."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

from ..world import yaml_texts
from .exceptions import RCLError, UnknownROSArgsError
from .names import expand_topic_name

__all__ = ["Arguments"]

_TRUE = {"y", "yes", "on", "true"}
_FALSE = {"n", "no", "off", "false"}
_RULE = re.compile(r"(?:(\w+):)?([^\s:=]+):=(.+)", re.DOTALL)
LEVELS = {"unset": 0, "debug": 10, "info": 20, "warn": 30, "error": 40, "fatal": 50}

# Options that have no effect here: there is no log file and no security.
_WITHOUT_VALUE = {"--enable-external-lib-logs", "--disable-external-lib-logs"}
_WITH_VALUE = {"-e", "--enclave", "--log-config-file"}


class _Remapping(NamedTuple):
    node: str | None  # the node's name; None: any node
    source: str
    target: str


class Arguments:
    """Reads the remappings, parameters and log levels of a command line; ``rest`` are the other words.

    A rule "name:source:=target" is only for nodes with that name. Raises RCLError for a faulty option,
    UnknownROSArgsError for an unknown one.
    """

    def __init__(self, argv: list[str]) -> None:
        self.remappings: list[_Remapping] = []
        self.overrides: list[tuple[str, str, Any]] = []  # which nodes, parameter, value
        self.level: int | None = None
        self.levels: dict[str, int] = {}
        self.console = True
        self.rosout = True
        self.deprecated: list[str] = []  # remappings as ROS 1 writes them
        self.rest: list[str] = []
        unknown = []
        words = iter(argv)
        options: dict[str, tuple[Callable[[str], None], str]] = {
            **dict.fromkeys(("-r", "--remap"), (self._remap, "remap rule")),
            **dict.fromkeys(("-p", "--param"), (self._set, "parameter override rule")),
            "--params-file": (self._read, "params file"),
            "--log-level": (self._set_level, "log level"),
            **dict.fromkeys(_WITH_VALUE, (lambda text: None, "value")),
        }
        while (word := next(words, None)) is not None:
            if word != "--ros-args":
                self._user_word(word)
                continue
            for flag in _until_two_dashes(words):
                if flag in options:
                    use, what = options[flag]
                    self._use(flag, next(words, None), use, what)
                elif flag.endswith("able-stdout-logs"):
                    self.console = flag == "--enable-stdout-logs"
                elif flag.endswith("able-rosout-logs"):
                    self.rosout = flag == "--enable-rosout-logs"
                elif flag not in _WITHOUT_VALUE:
                    unknown.append(flag)
        if unknown:
            raise UnknownROSArgsError(str(unknown))

    def _user_word(self, word: str) -> None:
        try:
            if not re.match("_[^_]", word):
                self._remap(word)
                self.deprecated.append(word)
                return
        except ValueError:
            pass
        self.rest.append(word)

    def _use(self, flag: str, text: str | None, use: Callable[[str], None], what: str) -> None:
        failed = "failed to initialize rcl: Couldn't parse"
        if text is None:
            raise RCLError(f"{failed} trailing {flag} flag. No {what} found.")
        try:
            use(text)
        except ValueError as error:
            raise RCLError(f"{failed} {what}: '{flag} {text}'. Error: {error}") from None

    # --- options ------------------------------------------------------------------------------------------------------

    def _remap(self, text: str) -> None:
        match = _RULE.fullmatch(text)
        if not match:
            raise ValueError(f"Expected lexeme type (19) not found, search ended at index {len(text)}")
        node, source, target = match.groups()
        if source == "__ns":
            if not re.fullmatch(r"/|(/[a-zA-Z_]\w*)+", target):
                raise ValueError("Namespace not remapped to a fully qualified name")
        elif source in ("__node", "__name"):
            source = "__node"
            if not re.fullmatch(r"[a-zA-Z_]\w*", target):
                raise ValueError("error not set")
        elif not re.fullmatch(r"~?(/?[a-zA-Z_{][\w{}]*)*", target):
            raise ValueError("error not set")
        self.remappings.append(_Remapping(node, source, target))

    def _set(self, text: str) -> None:
        match = _RULE.fullmatch(text)
        if not match:
            raise ValueError(f"Expected lexeme type (22) not found, search ended at index {len(text)}")
        import yaml  # only needed here, and many nodes do without

        node, name, value = match.groups()
        try:
            if _alias(value):
                raise ValueError("Unknown YAML event")
            tree = yaml_texts.compose(value)
        except yaml.YAMLError:
            tree = None
        self.overrides.append((f"/{node}" if node else "/**", name, _value(tree)))

    def _read(self, path: str) -> None:
        import yaml

        try:
            text = Path(path).read_text(encoding="utf-8")
            if line := _alias(text):
                raise ValueError(f"Will not support aliasing at line {line}")
            tree = yaml_texts.compose(text)
        except OSError:
            raise ValueError("Error opening YAML file") from None
        except yaml.YAMLError as error:
            raise ValueError(str(error)) from None
        self._read_nodes("", tree)

    def _read_nodes(self, node: str, tree: Any) -> None:
        """Look for ``ros__parameters`` in what a file says of a node, or a namespace."""
        for key, value in _items(tree):
            if key == "ros__parameters":
                self.overrides += [(node, name, found) for name, found in _leaves("", value)]
            else:
                self._read_nodes(f"{node}/{key.strip('/')}", value)

    def _set_level(self, text: str) -> None:
        name, _, level = text.rpartition(":=")
        if level.lower() not in LEVELS:
            raise ValueError("Argument does not use a valid severity level")
        if name:
            self.levels[name] = LEVELS[level.lower()]
        else:
            self.level = LEVELS[level.lower()]

    # --- what they give a node ----------------------------------------------------------------------------------------

    def name(self, name: str, namespace: str) -> tuple[str, str]:
        """Return the name and namespace of a node that has these in its code."""

        def remapped(source: str, default: str) -> str:
            rules = (rule for rule in self.remappings if rule.source == source and rule.node in (None, name))
            return next((rule.target for rule in rules), default)

        return remapped("__node", name), remapped("__ns", namespace)

    def topic(self, topic: str, name: str, namespace: str) -> str:
        """Return the full name that replaces a topic's full name in a node."""
        for rule in self.remappings:
            if rule.node in (None, name) and not rule.source.startswith("__"):
                if expand_topic_name(rule.source, name, namespace) == topic:
                    return expand_topic_name(rule.target, name, namespace)
        return topic

    def parameters(self, full_name: str) -> dict[str, Any]:
        """Return the values for the parameters of a node. Of several the last is taken, of the node named last."""
        found: dict[str, Any] = {}
        for node in dict.fromkeys(node for node, _, _ in self.overrides):
            pattern = re.escape(node).replace(r"/\*\*", r"(/\w+)*").replace(r"\*", r"\w+")
            if re.fullmatch(pattern, full_name):
                found |= {name: value for each, name, value in self.overrides if each == node}
        return found


def _until_two_dashes(words: Iterator[str]) -> Iterator[str]:
    for word in words:
        if word == "--":
            return
        if word != "--ros-args":
            yield word


# --- YAML as rcl reads it ---------------------------------------------------------------------------------------------


def _alias(text: str) -> int:
    """Return the line of the first alias in a text, which rcl refuses; 0 if there is none."""
    import yaml

    tokens = yaml.scan(text, yaml.SafeLoader)
    return next((token.start_mark.line + 1 for token in tokens if isinstance(token, yaml.AliasToken)), 0)


def _items(tree: Any) -> Iterator[tuple[str, Any]]:
    if not isinstance(getattr(tree, "value", None), list) or not all(isinstance(pair, tuple) for pair in tree.value):
        raise ValueError("Cannot have a value before ros__parameters")
    return ((key.value, value) for key, value in tree.value)


def _leaves(prefix: str, tree: Any) -> Iterator[tuple[str, Any]]:
    for key, value in _items(tree):
        if value.id == "mapping":
            yield from _leaves(f"{prefix}{key}.", value)
        else:
            yield prefix + key, _value(value)


def _value(node: Any) -> Any:
    """Return a parameter's value. YAML's types do not count: rcl has its own rules for what is a number."""
    if node is None or node.id == "mapping":
        raise ValueError("Unknown YAML event")
    if node.id == "scalar":
        return node.value if node.style else _scalar(node.value)
    values = [_value(item) for item in node.value]
    if len({type(value) for value in values}) > 1:
        raise ValueError("Sequence should be of same type")
    return values or None


def _scalar(text: str) -> Any:
    if text.lower() in _TRUE:
        return True
    if text.lower() in _FALSE:
        return False
    if re.fullmatch(r"[-+]?(0[xX][0-9a-fA-F]+|0[0-7]*|[1-9]\d*)", text):
        number = int(text, 0) if re.match(r"[-+]?(0[xX]|[1-9]|0$)", text) else int(text, 8)
        return number if -(2**63) <= number < 2**63 else float(number)
    if re.fullmatch(r"[-+]?(\d+\.?\d*([eE][-+]?\d+)?|\.\d+([eE][-+]?\d+)?|\.?(inf|nan|Inf|NaN|INF|NAN))", text):
        return float(text.replace(".i", "i").replace(".n", "n").replace(".I", "I").replace(".N", "N"))
    return text
