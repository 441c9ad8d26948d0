"""Nodes of Python packages, by path, by the name of their function, and by their command; and modules in many runs."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

import rosspin
from rosspin import rospy
from rosspin.__main__ import main

NODE = """
    import sys
    import rclpy
    from rclpy.node import Node
    from .law import GAIN

    class Spinner(Node):
        def __init__(self):
            super().__init__("spinner")
            self.create_timer(0.5, lambda: print(GAIN, __name__, __package__))

    def main():
        rclpy.init()
        try:
            rclpy.spin(Spinner())
        except KeyboardInterrupt:
            pass

    class Held:
        @staticmethod
        def main():
            main()

    if __name__ == "__main__":
        main()
"""


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A package of ROS 2 in the working directory; its node imports from it by a relative name."""
    folder = tmp_path / "spinning"
    folder.mkdir()
    (folder / "__init__.py").touch()
    (folder / "law.py").write_text("GAIN = 2\n")
    (folder / "node.py").write_text(dedent(NODE))
    monkeypatch.chdir(tmp_path)
    return folder


def test_a_file_of_a_package_runs_as_its_module(package: Path) -> None:
    run = rosspin.simulate(package / "node.py", 1.0)
    assert (run.status, run.console) == (0, "2 __main__ spinning\n" * 2)


def test_a_package_may_be_in_another(package: Path) -> None:
    (package / "parts").mkdir()
    (package / "parts" / "__init__.py").touch()
    (package / "node.py").rename(package / "parts" / "node.py")
    (package / "law.py").rename(package / "parts" / "law.py")
    assert rosspin.simulate("spinning/parts/node.py", 0.5).console == "2 __main__ spinning.parts\n"
    assert rosspin.simulate("spinning.parts.node:main", 0.5).console == "2 spinning.parts.node spinning.parts\n"


@pytest.mark.parametrize("name", ["spinning.node:main", "spinning.node:Held.main"])
def test_a_function_of_a_module_is_a_node(package: Path, name: str) -> None:
    run = rosspin.simulate(name, 1.0)
    assert (run.status, run.console) == (0, "2 spinning.node spinning\n" * 2)
    assert not [name for name in sys.modules if name.startswith("spinning")]
    with rosspin.start(name) as node:
        assert node.advance(0.5).console == "2 spinning.node spinning\n"
    assert not rosspin.explore(name, 1.0, deep=True, schedules=3).failure


def test_the_command_line_takes_both(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for file in ("spinning/node.py", "spinning.node:main"):
        assert main(["run", file, "--simulated", "--seconds", "0.5"]) == 0
    assert capsys.readouterr().out == "2 __main__ spinning\n2 spinning.node spinning\n"


@pytest.mark.parametrize("name", ["spinning.nod:main", "spinnin.node:main", "spinning.node.deeper:main"])
def test_a_module_that_is_not_there_is_named(package: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["run", name, "--simulated", "--seconds", "1"]) == 1
    module = name.partition(":")[0]
    said = f"rosspin: {name}: there is no module {module}, neither in this folder nor installed\n"
    assert capsys.readouterr().err == said


def test_a_function_that_is_not_there_fails_in_the_run(package: Path) -> None:
    run = rosspin.simulate("spinning.node:there_is_none", 1.0)
    assert run.status == 1
    assert run.console.endswith("AttributeError: module 'spinning.node' has no attribute 'there_is_none'\n")


def test_a_command_of_an_installed_package_is_a_node(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    info = package.parent / "spinning-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: spinning\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text("[console_scripts]\nspin-it = spinning.node:main\n")
    monkeypatch.syspath_prepend(package.parent)
    assert rosspin.simulate("spin-it", 0.5).console == "2 spinning.node spinning\n"
    with pytest.raises(FileNotFoundError):
        rosspin.simulate("spin-that", 0.5)


def test_deep_explores_the_files_among_several_nodes(package: Path) -> None:
    found = rosspin.explore(["spinning/node.py", lambda: None], 0.6, deep=True, schedules=5)
    assert str(found).endswith(" Only files were explored deep, not <lambda>.")
    assert "deep" not in str(rosspin.explore(["spinning/node.py", lambda: None], 0.6, schedules=5))
    with pytest.raises(ValueError, match="a function cannot be shaken"):
        rosspin.explore([of_ros1, lambda: None], 0.6, deep=True)


# --- ten runs in a row ------------------------------------------------------------------------------------------------

HELPER = """
    from std_msgs.msg import UInt32
    from std_srvs.srv import SetBool

    count = 0

    def more():
        global count
        count += 1
        return UInt32(data=count)

    def answer(request, response=None):
        return SetBool.Response(success=True) if response else SetBool._response_class(success=True)
"""


def of_ros1() -> None:
    run_helper = import_module("run_helper")
    rospy.init_node("n")
    publisher = rospy.Publisher("/x", run_helper.UInt32, queue_size=1)
    rospy.Service("/s", run_helper.SetBool, run_helper.answer)
    rospy.Timer(rospy.Duration(0.5), lambda event: publisher.publish(run_helper.more()))
    rospy.spin()


def of_ros2() -> None:
    rclpy, run_helper = import_module("rclpy"), import_module("run_helper")
    rclpy.init()
    node = rclpy.create_node("n")
    publisher = node.create_publisher(run_helper.UInt32, "/x", 10)
    node.create_service(run_helper.SetBool, "/s", run_helper.answer)
    node.create_timer(0.5, lambda: publisher.publish(run_helper.more()))
    rclpy.spin(node)


@pytest.mark.parametrize("node", [of_ros1, of_ros2])
@pytest.mark.parametrize("installed", [False, True])
def test_ten_runs_in_a_row_are_alike(
    node: Callable[[], None], installed: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What a run imports that holds messages, or anything of its ROS, is loaded again in the next run."""
    folder = tmp_path / "site-packages" if installed else tmp_path
    folder.mkdir(exist_ok=True)
    (folder / "run_helper.py").write_text(dedent(HELPER))
    monkeypatch.syspath_prepend(folder)
    for _ in range(10):
        assert [message.message.data for message in rosspin.simulate(node, 2.0).messages] == [1, 2, 3, 4]
        with rosspin.start(node) as started:
            started.call("/s", data=True)
            step = started.advance(1.0)
            assert [call.response.success for call in step.calls] == [True]
            assert [message.message.data for message in step.messages] == [1, 2]
    assert "run_helper" not in sys.modules


def test_what_holds_nothing_of_a_run_is_loaded_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "kept_helper.py").write_text("import math, threading, time\nfrom dataclasses import dataclass\n")
    monkeypatch.syspath_prepend(tmp_path)

    def node() -> None:
        kept_helper: Any = import_module("kept_helper")
        kept_helper.count = getattr(kept_helper, "count", 0) + 1
        rospy.init_node("n")
        print(kept_helper.count)

    try:
        assert [rosspin.simulate(node, 1.0).console for _ in range(2)] == ["1\n", "2\n"]
    finally:
        sys.modules.pop("kept_helper", None)
