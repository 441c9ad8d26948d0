"""The message classes of one library, each made when it is first asked for: what both ROSes' have in common."""

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
        self._making: list[str] = []

    def __getitem__(self, name: str) -> type[T]:
        if name not in self._classes:
            definition = self.library.definition(name)
            self._making.append(name)
            try:
                self._make_nested(definition)
                self._classes[name] = self._make(definition)
            finally:
                self._making.pop()
        return self._classes[name]

    @staticmethod
    @abstractmethod
    def module(name: str) -> str:
        """The module in which this ROS puts the class of this name."""

    @abstractmethod
    def _make(self, definition: Definition) -> type[T]:
        """The class of a definition; those of its fields are there."""

    def _make_nested(self, definition: Definition) -> None:
        """The classes of a definition's fields. DefinitionError: one is not there, or the message holds itself."""
        for field in definition.fields:
            base = field.kind.base
            if base in self._making:
                definition.fault(field.line, f"{base} holds itself")
            if base not in BUILTIN[self.library.ros]:
                try:
                    self[base]
                except KeyError:
                    definition.fault(field.line, unknown(base, self.library.ros))
