"""Suspend one Python call stack and go on with another.

The only module that knows how this is done: with greenlet, so that every stack lives in one thread and gives way only
where it asks to. In a web page there is no greenlet; there it is done by :mod:`rosspin.jspi`.
"""

from __future__ import annotations

import contextvars
import sys
from collections.abc import Callable
from typing import Any, cast

__all__ = ["Stack", "StackExit", "current"]


class StackExit(BaseException):
    """Thrown into a stack that is to end now; nothing but its own ``finally`` blocks should see it."""


if sys.platform == "emscripten":
    from .jspi import Stack, current
else:
    from greenlet import getcurrent, greenlet

    class Stack(greenlet):
        """A call stack that can be suspended; it begins at its first ``switch()``.

        ``switch()`` suspends the caller and goes on with this stack; ``throw(exception)`` likewise, but raises there.
        When ``function`` has returned, or raised, the stack ``home`` goes on (or raises). ``dead`` says that it has. A
        stack is true from its beginning to its end.
        """

        def __init__(self, function: Callable[[], Any], home: Stack) -> None:
            super().__init__(function, home)
            # A thread would begin with an empty context; a stack is a continuation of what started it.
            self.gr_context = contextvars.copy_context()

    current = cast(Callable[[], Stack], getcurrent)
    """The stack that is running; what was not made as a Stack can at least be switched to."""
