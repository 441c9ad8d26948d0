"""What an exercise is, and the list of them on one page."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple

from .feedback import Finding
from .judging import Answer

__all__ = ["Exercise", "Exercises"]

Find = Callable[[Answer], Iterator[Finding]]


class Exercise(NamedTuple):
    """An exercise of the site.

    ``part`` is the heading below which it stands, such as "Predict"; ``needs`` are the pages that one should have read,
    by their paths without ending; ``reveals`` is the misconception that a wrong answer gives away, as its holder would
    put it. ``find`` judges an answer; ``hint`` is for answers of which nothing more can be said. ``ros`` is 1 or 2:
    each has a page of exercises.
    """

    number: int
    part: str
    title: str
    needs: tuple[str, ...]
    reveals: str
    hint: str
    find: Find
    ros: int


class Exercises(list[Exercise]):
    """The exercises on one ROS, numbered from ``first`` on."""

    def __init__(self, ros: int, first: int) -> None:
        super().__init__()
        self._ros = ros
        self._first = first

    def add(self, part: str, title: str, needs: tuple[str, ...], reveals: str, hint: str) -> Callable[[Find], Find]:
        """Decorate the function that judges the answers to one more."""

        def decorate(find: Find) -> Find:
            number = self._first + len(self)
            self.append(Exercise(number, part, title, needs, reveals, hint, find, self._ros))
            return find

        return decorate
