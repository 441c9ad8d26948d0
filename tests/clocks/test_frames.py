"""Places in a node's code: which code is installed, and what a message shows of a line."""

from __future__ import annotations

import os
import sys
import sysconfig
from pathlib import Path
from typing import Any

import numpy
import pytest

from rosspin.clocks.frames import places, trail
from rosspin.clocks.installed import is_installed_file, note_own
from tests.helpers.places import SITE, looking_for_packages_in


class Context:
    """Notes what its caller's line shows when it is made, entered and left."""

    def __init__(self) -> None:
        self.seen = [self._shown()]

    def _shown(self) -> str:
        return places(trail(sys._getframe(2)))[0].call

    def __enter__(self) -> Context:
        self.seen.append(self._shown())
        return self

    def __exit__(self, *error: object) -> None:
        self.seen.append(self._shown())


CASES = {
    "with Context() as it: pass": ["Context()", "with Context() as it: pass", "with Context() as it: pass"],
    "with Context() as it:  # said\n    pass": ["Context()", *["with Context() as it:  # said ..."] * 2],
    "it = Context()\nwith it:\n    pass": ["Context()", *["with it: ..."] * 2],
    "it = Context()\nit.__enter__()": ["Context()", "it.__enter__()"],
}


@pytest.mark.parametrize("code", CASES)
def test_the_text_of_a_with_statement_is_the_same_on_every_python(code: str, tmp_path: Path) -> None:
    path = tmp_path / "node.py"
    path.write_text(code)
    names: dict[str, Any] = {"Context": Context}
    exec(compile(code, str(path), "exec"), names)
    assert names["it"].seen == CASES[code]


INSTALLED = [
    "<frozen os>",
    os.__file__,
    numpy.__file__,
    os.path.join(sysconfig.get_paths()["stdlib"], "asyncio", "events.py"),
    "/usr/lib/python3/dist-packages/rospy/__init__.py",
    "/opt/ros/noetic/lib/python3/dist-packages/tf/__init__.py",
    "/opt/ros/jazzy/lib/python3.12/site-packages/rclpy/node.py",
]
NOT_INSTALLED = [
    "node.py",
    "<string>",
    "/home/me/ws/src/robots/robots/node.py",
    "/home/me/ws/install/robots/lib/python3.12/site-packages/robots/node.py",
    "/home/me/ws/install/lib/python3.12/site-packages/robots/node.py",
    "/home/me/ws/devel/lib/python3/dist-packages/robots/__init__.py",
    "/home/me/my-site-packages/node.py",
    "/opt/ros_ws/install/robots/lib/python3.12/site-packages/robots/node.py",
]


@pytest.mark.parametrize("path", [*INSTALLED, *NOT_INSTALLED])
def test_what_is_installed(path: str) -> None:
    assert is_installed_file(path) is (path in INSTALLED)


def test_beside_a_node_a_virtual_environment_is_installed(tmp_path: Path) -> None:
    """And in it, the package of a node that lies there, with what was installed with it."""
    library = tmp_path.resolve() / ".venv" / SITE
    with looking_for_packages_in(library):
        note_own(str(tmp_path / "node.py"), [str(tmp_path)])
        assert not is_installed_file(str(tmp_path / "helper.py"))
        assert is_installed_file(f"{library}/robots/node.py")
        assert is_installed_file(f"{library}/helper.py")
        record = library / "robots-1.0.dist-info" / "RECORD"
        record.parent.mkdir(parents=True)
        record.write_text("../../../bin/node,,\nrobots/node.py,,\nhelper.py,,\n")
        (library / "robots").mkdir()
        for file in ("robots/node.py", "helper.py"):  # newer Pythons list only what is there
            (library / file).touch()
        note_own(f"{library}/robots/node.py", [f"{library}/robots/", f"{library}/"])
        assert not is_installed_file(f"{library}/robots/parts/arm.py")
        assert not is_installed_file(f"{library}/helper.py")
        assert is_installed_file(f"{library}/robots_of_others/node.py")
        assert is_installed_file(f"{library}/numpy/__init__.py")
