"""The kinds of nodes: a ROS, and a language.

A new ROS, or a language, is a module here and a word in one of the lists below.
"""

from __future__ import annotations

from .cpp import Cpp
from .language import Language
from .ros import Ros, Words
from .ros1 import Ros1
from .ros2 import Ros2

__all__ = ["LANGUAGES", "ROS", "Language", "Ros", "is_of_a_ros", "language_of", "ros_of"]
__all__ += ["words_in", "words_of", "written_in"]

# By their numbers.
ROS: dict[int, Ros] = {each.number: each for each in (Ros1(), Ros2())}

# Besides Python.
LANGUAGES: list[Language] = [Cpp()]


def ros_of(module: str) -> Ros | None:
    """Return the ROS to which a module such as rclpy.node belongs by its name; None for any other module."""
    root = module.partition(".")[0]
    return next((ros for ros in ROS.values() if root in ros.roots), None)


def is_of_a_ros(module: str) -> bool:
    """Whether a module is, by its name, one that only a ROS has."""
    root = module.partition(".")[0]
    known = {name for ros in ROS.values() for name in (*ros.roots, *ros.beside, *ros.needed)} - {"yaml"}
    return root in known or root.endswith(("_msgs", "_srvs", "_interfaces"))


def language_of(path: str) -> Language | None:
    """Return the language of a file by its name; None for Python, and for anything else."""
    return next((each for each in LANGUAGES if path.endswith(each.suffixes)), None)


def written_in(text: str) -> Language | None:
    """Return the language that a node's text is written in; None for Python, and for anything else."""
    return next((each for each in LANGUAGES if each.recognises(text)), None)


def words_in(path: str, ros: int) -> Words:
    """Return the words for a node of a ROS, in the language of its file."""
    return words_of(language_of(path), ros)


def words_of(language: Language | None, ros: int) -> Words:
    """Return the words for a node of a ROS, in a language, or in Python."""
    return language.words[ros] if language else ROS[ros].words
