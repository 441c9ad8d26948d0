"""A language, other than Python, that nodes are written in."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import ClassVar, Protocol

from .ros import Words

__all__ = ["Language", "Program"]


class Program(Protocol):
    """A node that can be run: of which ROS it is, which file it was made from, and what its compiler warns of."""

    @property
    def ros(self) -> int: ...

    @property
    def path(self) -> str: ...

    @property
    def warnings(self) -> str: ...

    def __call__(self) -> object: ...


class Language(ABC):
    name: ClassVar[str]  # as Pygments has it
    suffixes: ClassVar[tuple[str, ...]]  # of its files
    words: ClassVar[Mapping[int, Words]]  # by the number of a ROS

    @abstractmethod
    def recognises(self, text: str) -> bool:
        """Whether a text is a node in this language."""

    @abstractmethod
    def named_in(self, text: str) -> set[int]:
        """Return the numbers of the ROSes that a text names."""

    @abstractmethod
    def program(
        self, path: str, waiting: Callable[[], object], text: str | None = None, closed: bool = False
    ) -> Program:
        """Make a program of a file, or of a text if one is given. ``waiting()`` is called again and again meanwhile.

        A text that is ``closed`` includes nothing but what its ROS has.

        Raises OSError if the file cannot be read, and ValueError if it is no such node.
        """
