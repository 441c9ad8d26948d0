"""The reference: what it lists is what the real rospy and the real rclpy have."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from rosspin import rclpy, rospy
from rosspin.real import ros2
from tests.helpers.names_of_rclpy import names_on_page
from tests.helpers.tree import ROOT


def test_every_name_of_the_real_rospy_is_known(require: Callable[[str], None]) -> None:
    require("ros1")
    code = "import json, rospy; print(json.dumps([n for n in dir(rospy) if n[0] != '_']))"
    real = json.loads(subprocess.run(["/usr/bin/python3", "-c", code], check=True, capture_output=True).stdout)
    unknown = [name for name in real if name not in rospy.NOT_SIMULATED and not hasattr(rospy, name)]
    assert unknown == []
    assert rospy.NOT_SIMULATED <= set(real)


@pytest.fixture(scope="module")
def real_rclpy(require: Callable[[str], None]) -> dict[str, list[str]]:
    """The public names of the modules that the stand-in has, of the package itself, and of a Node."""
    require("ros2")
    code = (
        "import importlib, json, pkgutil, sys\n"
        "names = {name: dir(importlib.import_module(name)) for name in sys.argv[1:]}\n"
        "import rclpy, rclpy.node\n"
        "names[''] = [module.name for module in pkgutil.walk_packages(rclpy.__path__, 'rclpy.')]\n"
        "names['Node'] = dir(rclpy.node.Node)\n"
        "print(json.dumps({key: [n for n in found if n[0] != '_'] for key, found in names.items()}))\n"
    )
    with ros2.Nodes() as nodes:
        real: dict[str, list[str]] = json.loads(
            nodes.run([ros2.python(), "-W", "ignore", "-c", code, *rclpy.MODULES], 60).console
        )
    return real


def test_the_real_rclpy_has_the_names_that_are_listed(site: Path, real_rclpy: dict[str, list[str]]) -> None:
    listed = {(module, name) for module, names in names_on_page(site).items() for name in names}
    lacking = {(module, name) for module, name in listed if name not in real_rclpy[module]}
    assert lacking == {("rclpy.timer", "TimerInfo")}  # which Kilted has


def test_every_module_of_the_real_rclpy_and_every_name_of_its_node_is_known(
    real_rclpy: dict[str, list[str]],
) -> None:
    real = {name.removeprefix("rclpy.") for name in real_rclpy[""] if "._" not in name}
    ours = {name.removeprefix("rclpy.") for name in rclpy.MODULES if "._" not in name} - {"rclpy"}
    assert ours == real
    assert all(names <= set(real_rclpy[module]) for module, names in rclpy.LACKING.items())
    assert [name for name in real_rclpy["Node"] if not hasattr(rclpy.node.Node, name)] == []


def test_the_releases_that_were_checked_are_the_newest_that_can_be_installed(require: Callable[[str], None]) -> None:
    """If this fails, a newer wheel is there: check the site on it, and say so on the page of rclpy's names."""
    require("ros2")
    page = " ".join((ROOT / "docs/reference/rclpy-names.rst").read_text(encoding="utf-8").split())
    checked = re.search(r"\*\*Jazzy\*\*, with (rclpy ([\d.]+)), and \*\*Kilted\*\*, with rclpy ([\d.]+)\.", page)
    assert checked
    assert ros2.version() == f"Jazzy, {checked[1]}"
    for wheel, version in {"jazzy": checked[2], "kilted": checked[3], "lyrical": ""}.items():
        command = [ros2.python(), "-m", "pip", "index", "versions", f"ros-{wheel}-rclpy"]
        run = subprocess.run(command, capture_output=True, text=True)
        if run.returncode and version:
            pytest.skip("pip can reach no package index")
        assert run.stdout.partition("\n")[0] == (f"ros-{wheel}-rclpy ({version})" if version else "")
