"""C++ nodes in a page beside others: they find each other, and tick, as on a computer."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rosspin import simulate
from tests.helpers.page_python import launch_job, said, together_job
from tests.helpers.tree import EXAMPLES

pytestmark = pytest.mark.shares(3)

ROS1, PY, CPP = (
    EXAMPLES / name
    for name in ("my_robotics_pkg/src", "my_robotics_pkg_ros2/my_robotics_pkg", "my_robotics_pkg_ros2_cpp/src")
)
PAIRS = [
    (ROS1 / "publisher_cpp_node.cpp", ROS1 / "subscriber_cpp_node.cpp"),
    (ROS1 / "publisher_cpp_node.cpp", ROS1 / "subscriber_py_node.py"),
    (ROS1 / "publisher_py_node.py", ROS1 / "subscriber_cpp_node.cpp"),
    (CPP / "publisher_cpp_node.cpp", CPP / "subscriber_cpp_node.cpp"),
    (CPP / "publisher_cpp_node.cpp", PY / "subscriber_py_node.py"),
    (PY / "publisher_py_node.py", CPP / "subscriber_cpp_node.cpp"),
]
COLOURS = re.compile(r"\x1b\[[\d;]*m")


@pytest.mark.parametrize("reverse", [False, True], ids=["publisher first", "subscriber first"])
@pytest.mark.parametrize("pair", PAIRS, ids=lambda pair: f"{pair[0].name} to {pair[1].name}")
def test_a_publisher_and_a_subscriber(pair: tuple[Path, Path], reverse: bool) -> None:
    nodes = pair[::-1] if reverse else pair
    ((batch, end),) = said([together_job(*nodes)])
    run = simulate(list(nodes), 2.0)
    console = "".join(text for _, text, *_ in batch["chunks"])
    assert console == COLOURS.sub("", run.console)
    assert "counter = 4" in console
    result = end["result"]
    assert [tuple(tick[:4]) for tick in result["ticks"]] == [tuple(tick[:4]) for tick in run.ticks]
    assert (result["status"], result["errors"]) == (run.status, 0)


@pytest.mark.parametrize("name", ["spinner", "spinner_rate"])
@pytest.mark.parametrize("folders", [(ROS1, ROS1), (CPP, PY)], ids=["ROS 1", "ROS 2"])
def test_a_tick_has_printed_its_counter(name: str, folders: tuple[Path, Path]) -> None:
    """Of each language, and of a loop, too."""
    in_cpp, in_py = folders
    ((batch, end),) = said([together_job(in_cpp / f"{name}_cpp_node.cpp", in_py / f"{name}_py_node.py")])
    result = end["result"]
    assert len(result["ticks"]) == {"spinner": 8, "spinner_rate": 10}[name]
    texts = {number: text for _, text, number, _ in batch["chunks"]}
    for (source, count, *_), chunks in zip(result["ticks"], result["chunks"], strict=True):
        if "Rate" not in source or count > 1:  # what a first pass has printed has nothing before it
            (printed,) = {texts[number] for number in chunks} - {"\n"}
            node = "CPP" if "cpp" in source else "PY"
            assert f"{node} NODE] counter = {count}" in printed


@pytest.mark.parametrize("launch", [ROS1.parent / "launch/spinner.launch", CPP.parent / "launch/spinner.launch.xml"])
def test_a_launch_file_that_starts_both(launch: Path) -> None:
    ((batch, end),) = said([launch_job(launch)])
    run = simulate(launch, 2.0)
    console = "".join(text for _, text, *_ in batch["chunks"])
    assert console == COLOURS.sub("", run.console)
    assert "[SPINNER CPP NODE] counter = 4" in console and "[SPINNER PY NODE] counter = 4" in console
    result = end["result"]
    assert [tuple(tick[:4]) for tick in result["ticks"]] == [tuple(tick[:4]) for tick in run.ticks]
    assert (result["status"], result["errors"], result["count"]) == (run.status, 0, 8)


@pytest.mark.parametrize(
    ("own", "other"),
    [
        (ROS1 / "subscriber_py_node.py", ROS1 / "publisher_cpp_node.cpp"),
        (ROS1 / "publisher_py_node.py", ROS1 / "subscriber_cpp_node.cpp"),
        (PY / "publisher_py_node.py", CPP / "subscriber_cpp_node.cpp"),
    ],
    ids=lambda path: path.name,
)
def test_the_steps_are_those_of_the_node_in_python(own: Path, other: Path) -> None:
    """Nothing is said of when the other one calls what, which it does not tell."""
    ((_, end), (_, alone)) = said([together_job(own, other), together_job(other, own)])
    scenes = end["result"]["scenes"]
    assert alone["result"]["scenes"] is None
    assert {name.partition(":")[0] for name in scenes["threads"]} == {f"/{own.stem}"}
    assert len(scenes["callbacks"]) == 1
    sentences = [said for _, said, *_ in scenes["steps"]]
    assert any("calls" in said for said in sentences)
    assert sentences[0].startswith("No callback in Python runs until ")
