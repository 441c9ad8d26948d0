"""What identifies a package's message, or a service, is what ROS's own tools give: MD5 sums, fields, constants."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

from rosspin.messages import MessageFinder, ros2
from rosspin.messages.library import Library
from rosspin.real import ros2 as real_ros2
from tests.helpers.own_packages import WHEEL, write_package


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


def test_the_md5_sums_of_services_are_genpys(require: Callable[[str], None]) -> None:
    require("ros1")
    names = ["std_srvs/Empty", "std_srvs/SetBool", "std_srvs/Trigger", "nav_msgs/GetMap", "nav_msgs/GetPlan"]
    with MessageFinder(1) as finder:
        ours = [finder.messages.whole("srv", name)._md5sum for name in names]
    code = (
        "import importlib\n"
        f"for name in {names!r}:\n"
        "  package, _, short = name.partition('/')\n"
        "  print(getattr(importlib.import_module(package + '.srv'), short)._md5sum)"
    )
    real = subprocess.run(["/usr/bin/python3", "-c", code], capture_output=True, text=True, check=True)
    assert real.stdout.split() == ours


_OF_INTERFACES = """
import importlib, json
found = {}
for package in PACKAGES:
    for folder in ("msg", "srv", "action"):
        try:
            module = importlib.import_module(package + "." + folder)
        except ImportError:
            continue
        for name, kind in vars(module).items():
            if hasattr(kind, "get_fields_and_field_types"):
                constants = {c: str(getattr(kind, c)) for c in dir(type(kind)) if c.isupper() and c[0] != "_"}
                found[f"{package}/{name}"] = [kind.get_fields_and_field_types(), constants]
print(json.dumps(found))
"""


def test_services_and_actions_have_the_real_fields(require: Callable[[str], None]) -> None:
    require("ros2")
    packages = ["std_srvs", "action_msgs", "lifecycle_msgs", "rcl_interfaces", "service_msgs", "unique_identifier_msgs"]
    code = f"PACKAGES = {packages!r}{_OF_INTERFACES}"
    real = subprocess.run([real_ros2.python(), "-c", code], capture_output=True, text=True, check=True)
    messages, compared = ros2.Messages(Library(2)), 0
    for name, (fields, constants) in json.loads(real.stdout).items():
        if "_Event" in name:
            continue  # rosidl bounds the two sequences in words of its own
        ours = messages[name]
        assert ours.get_fields_and_field_types() == fields, name
        assert {constant: str(getattr(ours, constant)) for constant in constants} == constants, name
        compared += 1
    assert compared > 50
