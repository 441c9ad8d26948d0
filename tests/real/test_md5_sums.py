"""The MD5 sum of a package's own message is the one that ROS's own tools give."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

from own_packages import WHEEL, write_package

from rosspin.messages import MessageFinder


def test_the_md5_sum_of_an_own_message_is_genmsgs(require: Callable[[str], None], tmp_path: Path) -> None:
    require("ros1")
    folder = write_package(tmp_path, Wheel=WHEEL, Two="Wheel left\nWheel right\n")
    with MessageFinder(1, folder) as finder:
        ours = [finder.messages[f"my_robotics_pkg/{name}"]._md5sum for name in ("Wheel", "Two")]
        header = finder.library.definition("std_msgs/Header").text
    code = (
        "import sys, genmsg; from genmsg import msg_loader as l; c = l.MsgContext.create_default()\n"
        f"l.load_msg_from_string(c, {header!r}, 'std_msgs/Header')\n"
        f"path = {{'my_robotics_pkg': [{str(folder.parent / 'msg')!r}]}}\n"
        "for name in ('Wheel', 'Two'):\n"
        "  spec = l.load_msg_by_type(c, 'my_robotics_pkg/' + name, path); l.load_depends(c, spec, path)\n"
        "  print(genmsg.compute_md5(c, spec))"
    )
    real = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=True)
    assert real.stdout.split() == ours
