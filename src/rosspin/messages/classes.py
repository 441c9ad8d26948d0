"""Make the message classes of a library, each when it is first asked for: what both ROSes have in common."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Generic, TypeVar

from .definitions import BUILTIN, Definition, unknown
from .library import Library

__all__ = ["Messages"]

T = TypeVar("T")


class Messages(ABC, Generic[T]):
    """Classes by name: ``messages["std_msgs/Header"]``. KeyError and DefinitionError as in Library.definition."""

    def __init__(self, library: Library) -> None:
        self.library = library
        self._classes: dict[str, type[T]] = {}

    def __getitem__(self, name: str) -> type[T]:
        return self._find(name, ())

    def _find(self, name: str, around: tuple[str, ...]) -> type[T]:
        """A class, made after those of its fields; ``around`` are the messages that hold it."""
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

    @abstractmethod
    def _make(self, definition: Definition) -> type[T]:
        """Make the class of a definition; the classes of its fields exist already."""
