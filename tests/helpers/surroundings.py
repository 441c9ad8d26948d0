"""What the tests find around them, however pytest was started: what make does about it is read from the Makefile."""

from __future__ import annotations

import re
import signal
import sys
import time
from collections.abc import MutableMapping
from fnmatch import fnmatchcase

from .tree import ROOT

# pytest's own, and others of which a Python that has started has already made what it will.
_BY_HAND = ["PYTEST_%", "PYTHONPATH", "PYTHONHASHSEED"]


def heed_ctrl_c() -> None:
    """A shell that starts something in the background has it, and all that it starts, ignore Ctrl-C."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def clean(environment: MutableMapping[str, str]) -> None:
    """Take out what make would not give to the tests; where a ROS lies that was sourced stays."""
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8").replace("\\\n", "")
    lists = re.findall(r"^(?:KEPT|SOURCED) := (.*)", makefile, re.MULTILINE)
    exported = re.findall(r"^export (\w+)", makefile, re.MULTILINE)
    kept = [*" ".join(lists).split(), *exported, *_BY_HAND]
    for name in list(environment):
        if not any(fnmatchcase(name, pattern.replace("%", "*")) for pattern in kept):
            del environment[name]
    environment["LC_CTYPE"] = "UTF-8" if sys.platform == "darwin" else "C.UTF-8"  # as Python does without a language
    time.tzset()
