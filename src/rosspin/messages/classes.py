"""Make the classes of a library's messages, services and actions, each when it is first asked for, for both ROSes."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Generic, TypeVar

from .definitions import BUILTIN, Definition, unknown
from .library import PARTS, Library

__all__ = ["Messages"]

T = TypeVar("T")


class Messages(ABC, Generic[T]):
    """Classes by name: ``messages["std_msgs/Header"]``, and of a service ``messages["std_srvs/SetBool_Request"]``.

    Raises KeyError and DefinitionError as Library.definition does.
    """

    def __init__(self, library: Library) -> None:
        self.library = library
        self._classes: dict[str, type[T]] = {}
        self._whole: dict[tuple[str, str], type[Any]] = {}

    def __getitem__(self, name: str) -> type[T]:
        return self._find(name, ())

    def whole(self, folder: str, name: str) -> type[Any]:
        """The class of a service (``folder`` srv) or an action, as in std_srvs/SetBool."""
        key = folder, name
        if key not in self._whole:
            parts = {suffix: self[name + suffix] for suffix in PARTS[self.library.ros][folder]}
            self._whole[key] = self._assemble(folder, name, parts)
        return self._whole[key]

    def _find(self, name: str, around: tuple[str, ...]) -> type[T]:
        """A class, made after its fields' classes; ``around`` are the messages that hold it."""
        if name not in self._classes:
            definition = self.library.definition(name)
            for field in definition.fields:
                base = field.kind.base
                if base in BUILTIN[self.library.ros]:
                    continue
                if base in (*around, name):
                    definition.fault(field.line, f"{base} holds itself")
                try:
                    self._find(base, (*around, name))
                except KeyError:
                    definition.fault(field.line, unknown(base, self.library.ros))
            self._classes[name] = self._make(definition)
        return self._classes[name]

    @staticmethod
    @abstractmethod
    def module(name: str) -> str:
        """The module in which this ROS puts the class of this name."""

    def home(self, definition: Definition) -> str:
        """The full name of the module in which this ROS puts the class of a definition."""
        package, _, short = definition.name.partition("/")
        folder, _, name = (definition.part_of or f"msg/{short}").partition("/")
        return f"{package}.{folder}.{self.module(name)}"

    @abstractmethod
    def _assemble(self, folder: str, name: str, parts: dict[str, type[T]]) -> type[Any]:
        """Make the class of a service or action, of whose parts these are the classes."""

    @abstractmethod
    def _make(self, definition: Definition) -> type[T]:
        """Make the class of a definition; the classes of its fields exist already."""
