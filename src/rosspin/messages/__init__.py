"""Message classes, made from their definitions when a node imports them.

From the bottom up: ``definitions`` reads the text of a definition, ``library`` knows where definitions are, ``ros1``
and ``ros2`` make the classes that genpy and rosidl would generate, ``finder`` lets a node import them.
"""

from .definitions import DefinitionError
from .finder import MessageFinder

__all__ = ["DefinitionError", "MessageFinder"]
