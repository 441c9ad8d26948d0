"""Texts of Python itself that differ from version to version, made the same."""

from __future__ import annotations

import re

__all__ = ["of_any_python"]

# What earlier versions say, and what the newest says, or as much of it as all say.
_DIFFER = {
    "float division by zero": "division by zero",  # up to 3.13
    " and no __dict__ for setting new attributes": "",  # from 3.13 on
}


# An OrderedDict shows pairs up to 3.11, and a dict from 3.12 on: what is in it, and the order, is the same.
_ORDERED = re.compile(r"OrderedDict\(.*")
_MARKS = str.maketrans("", "", "()[]{}:, ")


def of_any_python(text: str) -> str:
    """A text, or a part of one, as it would be on any Python."""
    for one, other in _DIFFER.items():
        text = text.replace(one, other)
    return _ORDERED.sub(lambda shown: shown[0].translate(_MARKS), text)
