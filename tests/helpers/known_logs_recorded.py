"""Record logs whose fault is known on the real ROS 1 and ROS 2, with the nodes in ``tests/look/nodes``.

Clocks are set by set_clock.c there, which is compiled for that.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import time
from pathlib import Path
from typing import Any

from rosspin.real.children import SITECUSTOMIZE, Children
from rosspin.real.ros1 import Workspace
from rosspin.real.ros2 import Nodes, python
from rosspin.results.saving import save_whole

from .known_logs import Case
from .tree import ROOT, TESTS

__all__ = ["recording", "record"]

NODES = TESTS / "look/nodes"


def recording(case: Case, folder: Path = TESTS / "look/recorded") -> Path:
    """The file of a log."""
    return folder / f"{case.name}.{ {'console': 'log', 'echo': 'csv', 'bag': 'bag'}[case.form] }"


def start(case: Case, children: Children, name: str, words: list[str], log: int) -> subprocess.Popen[bytes]:
    more = {}
    if case.jumps:
        library, offset = children.folder / "set_clock.so", children.folder / "offset"
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, NODES / "set_clock.c", "-ldl"], check=True)
        more = {"LD_PRELOAD": str(library), "CLOCK_OFFSET": str(offset)}
    if case.ros == 1:
        return children.start(["python3", str(NODES / "faulty_ros1.py"), name, *words], log, log, more)
    path = os.pathsep.join(filter(None, (str(children.folder), children.environment.get("PYTHONPATH"))))
    command = [python(), str(NODES / "faulty_ros2.py"), name, *words]
    return children.start(command, log, log, {**more, "PYTHONPATH": path})


def record(case: Case, target: Path) -> None:
    """Record a log into a file."""
    with Workspace() if case.ros == 1 else Nodes(meet=True) as children:
        if isinstance(children, Workspace):
            children.start_master()
        (children.folder / "sitecustomize.py").write_text(SITECUSTOMIZE)  # without what tells of ticks
        out = children.folder / "console"
        children.folder.joinpath("offset").write_text("0")
        plans: list[tuple[str, float, Any]] = [
            ("start", after, node) for after, node in zip(case.after or (0,) * len(case.nodes), case.nodes)
        ]
        plans += [("stop", 2 + at, seconds) for at, seconds in case.stops]
        plans += [("jump", 2 + at, seconds) for at, seconds in case.jumps]
        processes, others = [], []
        with open(out, "ab") as log:
            if case.form == "echo":
                with open(target, "wb") as table:
                    others.append(children.start(["rostopic", "echo", "-p", "/heading"], table.fileno()))
            if case.form == "bag":
                others.append(children.start(["rosbag", "record", "-O", str(target), "/heading"], subprocess.DEVNULL))
            if others:
                time.sleep(4)
            began = time.monotonic()
            for what, at, value in sorted(plans, key=lambda plan: plan[1]):
                time.sleep(max(0, began + at - time.monotonic()))
                if what == "start":
                    name, *words = value.split()
                    processes.append(start(case, children, name, words, log.fileno()))
                elif what == "jump":
                    children.folder.joinpath("offset").write_text(str(value))
                else:
                    for process in processes:
                        process.send_signal(signal.SIGSTOP)
                    time.sleep(value)
                    for process in processes:
                        process.send_signal(signal.SIGCONT)
            time.sleep(max(0, began + 2 + case.seconds - time.monotonic()))
            for process in [*others, *processes]:
                process.send_signal(signal.SIGINT)
            for process in [*others, *processes]:
                process.wait(20)
        if case.form == "console":
            text = out.read_text()
            text = re.sub(rf"{re.escape(str(children.folder))}|{re.escape(str(ROOT))}", "/home/you", text)
            save_whole(target, text.encode())
