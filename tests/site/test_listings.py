"""The listings: what the pages show is what the files hold, and the marked lines are the ones that a step adds."""

from __future__ import annotations

import difflib
import os
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.helpers.built_pages import parsed
from tests.helpers.lesson import FILES as LESSON
from tests.helpers.tree import ROOT

EXAMPLES = ROOT / "examples"
PACKAGE = EXAMPLES / "my_robotics_pkg"
PACKAGE_ROS2 = EXAMPLES / "my_robotics_pkg_ros2"
PACKAGE_ROS2_CPP = EXAMPLES / "my_robotics_pkg_ros2_cpp"
PAGES = sorted((ROOT / "docs").rglob("*.rst"))
TUTORIAL, PUBLISH = ROOT / "docs/tutorial.rst", ROOT / "docs/publish-build.rst"
TUTORIAL_ROS2, PUBLISH_ROS2 = ROOT / "docs/ros2/tutorial.rst", ROOT / "docs/ros2/publish-build.rst"

# Each step of a tutorial and the listing that it starts from, below examples/.
SPIN_FROM = {
    "steps/1_class.py": "my_robotics_pkg/src/plain_py_node.py",
    "steps/2_callback.py": "steps/1_class.py",
    "my_robotics_pkg/src/spinner_py_node.py": "steps/2_callback.py",
    "steps/2_callback.cpp": "my_robotics_pkg/src/plain_cpp_node.cpp",
    "my_robotics_pkg/src/spinner_cpp_node.cpp": "steps/2_callback.cpp",
}
RATE_FROM = {
    "my_robotics_pkg/src/spinner_rate_py_node.py": "my_robotics_pkg/src/plain_py_node.py",
    "my_robotics_pkg/src/spinner_rate_cpp_node.cpp": "my_robotics_pkg/src/plain_cpp_node.cpp",
}
PUBLISH_FROM = {
    "my_robotics_pkg/src/publisher_cpp_node.cpp": "steps/3_class.cpp",
    "my_robotics_pkg/src/publisher_py_node.py": "my_robotics_pkg/src/spinner_py_node.py",
    "my_robotics_pkg/src/subscriber_cpp_node.cpp": "my_robotics_pkg/src/plain_cpp_node.cpp",
    "my_robotics_pkg/src/subscriber_py_node.py": "my_robotics_pkg/src/plain_py_node.py",
}
PUBSUB_FROM = {
    "steps/3_class.cpp": "my_robotics_pkg/src/spinner_cpp_node.cpp",
    "my_robotics_pkg/src/pubsub_cpp_node.cpp": "my_robotics_pkg/src/publisher_cpp_node.cpp",
    "my_robotics_pkg/src/pubsub_py_node.py": "my_robotics_pkg/src/publisher_py_node.py",
}
_NODES_ROS2 = "my_robotics_pkg_ros2/my_robotics_pkg"
_CPP_ROS2 = "my_robotics_pkg_ros2_cpp/src"
SPIN_FROM_ROS2 = {
    "steps_ros2/1_class.cpp": f"{_CPP_ROS2}/plain_cpp_node.cpp",
    "steps_ros2/2_callback.cpp": "steps_ros2/1_class.cpp",
    f"{_CPP_ROS2}/spinner_cpp_node.cpp": "steps_ros2/2_callback.cpp",
    "steps_ros2/1_class.py": f"{_NODES_ROS2}/plain_py_node.py",
    "steps_ros2/2_callback.py": "steps_ros2/1_class.py",
    f"{_NODES_ROS2}/spinner_py_node.py": "steps_ros2/2_callback.py",
}
RATE_FROM_ROS2 = {f"{_NODES_ROS2}/spinner_rate_py_node.py": f"{_NODES_ROS2}/plain_py_node.py"}
PUBLISH_FROM_ROS2 = {
    f"{_NODES_ROS2}/{new}_py_node.py": f"{_NODES_ROS2}/{old}_py_node.py"
    for new, old in (("publisher", "spinner"), ("subscriber", "plain"))
}
PUBLISH_FROM_ROS2 |= {
    f"{_CPP_ROS2}/{new}_cpp_node.cpp": f"{_CPP_ROS2}/{old}_cpp_node.cpp"
    for new, old in (("publisher", "spinner"), ("subscriber", "plain"))
}
STARTS_FROM = {
    ROOT / "docs/tutorial-timer.rst": SPIN_FROM,
    ROOT / "docs/tutorial-rate.rst": RATE_FROM,
    ROOT / "docs/publish.rst": PUBLISH_FROM,
    PUBLISH: PUBSUB_FROM,
    ROOT / "docs/publish-lost.rst": {},
    ROOT / "docs/ros2/tutorial-timer.rst": SPIN_FROM_ROS2,
    ROOT / "docs/ros2/tutorial-rate.rst": RATE_FROM_ROS2,
    ROOT / "docs/ros2/publish.rst": PUBLISH_FROM_ROS2,
    ROOT / "docs/ros2/publish-qos.rst": {},
    ROOT / "docs/how-to/message-type.rst": {f"{_NODES_ROS2}/stamped_py_node.py": f"{_NODES_ROS2}/publisher_py_node.py"},
}
MANIFESTS = ("CMakeLists.txt", "package.xml")
# Not what pytest and setuptools run, and what students complete.
PYTHON = sorted(path for path in EXAMPLES.rglob("*.py") if not path.name.startswith(("test_", "setup", "__init__")))
PYTHON = [path for path in PYTHON if "grading" not in path.parts]


def name_of(page: Path) -> str:
    return page.relative_to(ROOT).with_suffix("").as_posix()


class Listing(NamedTuple):
    """A literalinclude: the file that it shows, and its options."""

    path: Path
    options: dict[str, str]

    @property
    def name(self) -> str:
        return self.path.relative_to(EXAMPLES).as_posix()

    @property
    def shown(self) -> list[str]:
        """The lines that the page shows."""
        lines = self.path.read_text().splitlines()
        if "start-at" in self.options:
            lines = lines[next(i for i, line in enumerate(lines) if self.options["start-at"] in line) :]
        if "end-at" in self.options:
            lines = lines[: next(i for i, line in enumerate(lines) if self.options["end-at"] in line) + 1]
        if "lines" in self.options:
            lines = lines[: int(self.options["lines"])]  # "1" is all that the pages use
        return lines


def listings(page: Path) -> list[Listing]:
    found = []
    for match in re.finditer(r"^( *)\.\. literalinclude:: (.+)\n((?:\1 +:.+\n)*)", page.read_text(), re.MULTILINE):
        options = dict(re.findall(r":([a-z-]+): *(.*)", match[3]))
        found.append(Listing((page.parent / match[2]).resolve(), options))
    return found


def added(old: Path, new: Path) -> set[int]:
    """Numbers of the lines of `new` that `old` has not, or has otherwise."""
    matcher = difflib.SequenceMatcher(None, old.read_text().splitlines(), new.read_text().splitlines(), autojunk=False)
    return {line for tag, _, _, j1, j2 in matcher.get_opcodes() if tag != "equal" for line in range(j1 + 1, j2 + 1)}


@pytest.mark.parametrize("page", STARTS_FROM, ids=name_of)
def test_each_step_names_the_listing_that_it_starts_from(page: Path) -> None:
    named = {
        listing.name: (page.parent / listing.options["changed-from"]).resolve().relative_to(EXAMPLES).as_posix()
        for listing in listings(page)
        if "changed-from" in listing.options
    }
    assert named == STARTS_FROM[page]
    # By number only in listings that are no step.
    numbered = {listing.name for listing in listings(page) if "emphasize-lines" in listing.options}
    assert all(name.startswith("topics/") for name in numbered)


@pytest.mark.parametrize("page", STARTS_FROM, ids=name_of)
def test_marked_lines_are_the_ones_that_the_step_adds(site: Path, page: Path) -> None:
    html = parsed(site / f"{name_of(page)}.html")
    marked = [[line.get_text().rstrip() for line in pre.select(".hll")] for pre in html.select("pre:has(.hll)")]
    steps = [listing for listing in listings(page) if {"changed-from", "emphasize-lines"} & listing.options.keys()]
    for step, lines in zip(steps, marked, strict=True):
        if "changed-from" in step.options:
            text = step.path.read_text().splitlines()
            old = EXAMPLES / STARTS_FROM[page][step.name]
            assert lines == [text[number - 1] for number in sorted(added(old, step.path))]


def test_every_step_and_node_is_shown() -> None:
    shown = {listing.path for page in PAGES for listing in listings(page)}
    files = {*EXAMPLES.glob("steps/*"), *EXAMPLES.glob("how-to/**/*.py"), *EXAMPLES.glob("threads/**/*.*")}
    files |= {*EXAMPLES.glob("topics/*.*"), *EXAMPLES.glob("my_robotics_pkg_ros2/[clt]*/*.*")}
    files |= set(EXAMPLES.glob("my_robotics_interfaces/**/*.*"))
    files |= set(EXAMPLES.glob("hangs/*.*"))
    files |= {path for folder in ("src", "launch", "test") for path in PACKAGE.glob(f"{folder}/*.*")}
    files |= {*EXAMPLES.glob("steps_ros2/*"), *PACKAGE_ROS2.glob("*.*"), *PACKAGE_ROS2.glob("*/*_node*.py")}
    files |= {path for path in PACKAGE_ROS2_CPP.rglob("*.*") if path.is_file()}
    assert files - shown == set()


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_code_on_pages_comes_from_files(page: Path) -> None:
    inline = re.findall(
        r"^ *\.\. (?:code|code-block|sourcecode):: *(?:cpp|c\+\+|python|cmake|xml)\b.*", page.read_text(), re.M
    )
    # The files of this page are what its reader writes; tests/real/test_lesson.py does so, and runs them.
    assert len(inline) == (sum(name.endswith(".py") for name in LESSON) if page.stem == "add-a-lesson" else 0)
    assert all(listing.path.is_file() or page.stem == "add-a-lesson" for listing in listings(page))


def cmake_lines(node: str) -> list[str]:
    return [
        f"add_executable({node} src/{node}.cpp)",
        f"add_dependencies({node} ${{catkin_EXPORTED_TARGETS}})",
        f"target_link_libraries({node} ${{catkin_LIBRARIES}})",
    ]


def test_cmake_lines() -> None:
    pages = TUTORIAL, ROOT / "docs/tutorial-launch.rst"
    cmake = [each.shown for page in pages for each in listings(page) if each.path.name == "CMakeLists.txt"]
    lines = cmake_lines("spinner_cpp_node")
    assert cmake == [lines, lines]  # the TL;DR, and the step


def test_cmake_and_package_lines_of_the_second_tutorial() -> None:
    shown = {name: [each.shown for each in listings(PUBLISH) if each.path.name == name] for name in MANIFESTS}
    nodes = [cmake_lines(f"{name}_cpp_node") for name in ("publisher", "pubsub", "subscriber")]
    lines = [*nodes[0], "", *nodes[1], "", *nodes[2]]
    needs = "find_package(catkin REQUIRED COMPONENTS roscpp rospy std_msgs)"
    assert shown["CMakeLists.txt"] == [[needs], lines]
    assert shown["package.xml"] == [["  <depend>std_msgs</depend>"]]


def cmake_lines_of_ros_2(node: str, needs: str = "") -> list[str]:
    return [f"add_executable({node} src/{node}.cpp)", f"target_link_libraries({node} rclcpp::rclcpp{needs})"]


def test_cmake_lines_of_ros_2() -> None:
    shown = [
        [each.shown for each in listings(page) if each.path.name == "CMakeLists.txt" and "start-at" in each.options]
        for page in (TUTORIAL_ROS2, ROOT / "docs/reference/launch-files.rst", PUBLISH_ROS2)
    ]
    launch = ["install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})"]
    nodes = [cmake_lines_of_ros_2(f"{name}_cpp_node", " ${std_msgs_TARGETS}") for name in ("publisher", "subscriber")]
    assert shown[:2] == [[cmake_lines_of_ros_2("spinner_cpp_node")], [launch]]
    assert shown[2] == [["find_package(std_msgs REQUIRED)"], [*nodes[0], "", *nodes[1]]]


def test_every_cpp_node_of_ros_2_is_built_and_installed() -> None:
    cmake = (PACKAGE_ROS2_CPP / "CMakeLists.txt").read_text()
    for node in PACKAGE_ROS2_CPP.glob("src/*.cpp"):
        assert f"add_executable({node.stem} src/{node.name})" in cmake
        assert re.search(rf"install\(TARGETS [^)]*\b{node.stem}\b", cmake)


def test_every_cpp_node_is_built_and_every_node_installed() -> None:
    cmake = (PACKAGE / "CMakeLists.txt").read_text()
    for node in PACKAGE.glob("src/*.cpp"):
        assert f"add_executable({node.stem} src/{node.name})" in cmake
        assert re.search(rf"install\(TARGETS [^)]*\b{node.stem}\b", cmake)
    for node in PACKAGE.glob("src/*.py"):
        assert re.search(rf"catkin_install_python\([^)]*\bsrc/{node.name}\b", cmake)


@pytest.mark.parametrize("path", PYTHON, ids=lambda path: path.name)
def test_python_listing(path: Path) -> None:
    text = path.read_text()
    compile(text, path, "exec")
    assert text.startswith("#!/usr/bin/env python3\n")
    assert os.access(path, os.X_OK)
    assert ">>>" not in text
    assert not re.search(r";\s*$|\t", text, re.MULTILINE)


@pytest.mark.parametrize("kind", ["plain", "spinner"])
def test_launch_file(kind: str) -> None:
    launch = ElementTree.parse(PACKAGE / "launch" / f"{kind}.launch").getroot()
    assert launch.tag == "launch"
    (group,) = launch
    assert (group.tag, group.attrib) == ("group", {"ns": "mrp"})
    assert [(node.tag, node.attrib) for node in group] == [
        ("node", {"name": name, "pkg": "my_robotics_pkg", "type": file, "output": "screen"})
        for name, file in [(f"{kind}_cpp_node", f"{kind}_cpp_node"), (f"{kind}_py_node", f"{kind}_py_node.py")]
    ]


def test_launch_file_of_the_second_tutorial() -> None:
    argument, group = ElementTree.parse(PACKAGE / "launch/publish.launch").getroot()
    assert (argument.tag, argument.attrib) == ("arg", {"name": "publisher", "default": "publisher_py_node.py"})
    assert group.attrib == {"ns": "mrp"}
    nodes = {node.attrib["name"]: node.attrib["type"] for node in group}
    assert nodes.pop("publisher_node") == "$(arg publisher)"
    assert nodes == {"subscriber_cpp_node": "subscriber_cpp_node", "subscriber_py_node": "subscriber_py_node.py"}


# The names and messages of the original page.
@pytest.mark.parametrize(
    ("name", "parts"),
    [
        (
            "my_robotics_pkg/src/spinner_cpp_node.cpp",
            [
                'ros::init(argc, argv, "spinner_cpp_node")',
                'ros::NodeHandle nh("~")',
                '"[SPINNER CPP NODE] namespace of nh = " << nh.getNamespace()',
                "void timerCallback(const ros::TimerEvent&)",
                '"[SPINNER CPP NODE] counter = " << counter',
                "timer_delta_t_in_seconds = 0.5;",
                "timer_is_one_shot = false;",
            ],
        ),
        (
            "my_robotics_pkg/src/spinner_py_node.py",
            [
                "class SpinnerPyNode:",
                'rospy.init_node("spinner_py_node")',
                '"[SPINNER PY NODE] namespace of node = " + rospy.get_namespace()',
                "def timerCallback(self, event):",
                '"[SPINNER PY NODE] counter = " + str(self.counter)',
                "timer_delta_t_in_seconds = 0.5\n",
                "spinner_py_node = SpinnerPyNode()",
            ],
        ),
        (
            "my_robotics_pkg/src/spinner_rate_cpp_node.cpp",
            [
                'ros::init(argc, argv, "spinner_cpp_node")',
                "loop_frequency_in_hz = 2.0;",
                "ros::Rate loop_rate(loop_frequency_in_hz)",
                "while (ros::ok())",
                '"[SPINNER CPP NODE] counter = " << counter',
                "ros::spinOnce();",
                "loop_rate.sleep();",
            ],
        ),
        (
            "my_robotics_pkg/src/spinner_rate_py_node.py",
            [
                'rospy.init_node("spinner_py_node")',
                "loop_frequency_in_hz = 2.0\n",
                "loop_rate = rospy.Rate(loop_frequency_in_hz)",
                "while not rospy.is_shutdown():",
                '"[SPINNER PY NODE] counter = " + str(counter)',
                "loop_rate.sleep()",
            ],
        ),
        (
            "my_robotics_pkg_ros2/my_robotics_pkg/spinner_py_node.py",
            [
                "class SpinnerPyNode(Node):",
                'super().__init__("spinner_py_node")',
                '"[SPINNER PY NODE] namespace of node = " + self.get_namespace()',
                "def timer_callback(self):",
                '"[SPINNER PY NODE] counter = " + str(self.counter)',
                "timer_delta_t_in_seconds = 0.5\n",
                "spinner_py_node = SpinnerPyNode()",
            ],
        ),
        (
            "my_robotics_pkg_ros2/my_robotics_pkg/spinner_rate_py_node.py",
            [
                'super().__init__("spinner_py_node")',
                "loop_frequency_in_hz = 2.0\n",
                "loop_rate = self.create_rate(loop_frequency_in_hz)",
                '"[SPINNER PY NODE] counter = " + str(self.counter)',
                "loop_rate.sleep()",
            ],
        ),
        (
            "my_robotics_pkg_ros2_cpp/src/spinner_cpp_node.cpp",
            [
                "class SpinnerCppNode : public rclcpp::Node",
                'Node("spinner_cpp_node")',
                '"[SPINNER CPP NODE] namespace of node = " << get_namespace()',
                "void timerCallback()",
                '"[SPINNER CPP NODE] counter = " << counter_',
                "timer_delta_t_in_seconds(0.5);",
                "timer_for_counting_ = create_timer(",
            ],
        ),
        (
            "my_robotics_pkg_ros2_cpp/src/spinner_rate_cpp_node.cpp",
            [
                "loop_frequency_in_hz = 2.0;",
                "rclcpp::Rate loop_rate(loop_frequency_in_hz)",
                "while (rclcpp::ok())",
                '"[SPINNER CPP NODE] counter = " << counter',
                "rclcpp::spin_some(node);",
                "loop_rate.sleep();",
            ],
        ),
    ],
)
def test_names_and_messages_are_those_of_the_original(name: str, parts: list[str]) -> None:
    text = (EXAMPLES / name).read_text()
    assert [part for part in parts if part not in text] == []


def test_a_ros_timer_is_never_global() -> None:
    """A global ros::Timer aborts the process at Ctrl-C, and `ros::ok` without brackets never ends it."""
    for path in EXAMPLES.rglob("*.cpp"):
        text = path.read_text()
        assert not re.search(r"^(static )?ros::Timer ", text, re.MULTILINE)
        assert not re.search(r"ros::ok\b(?!\()", text)
        assert "ros/package.h" not in text


def test_every_node_of_ros_2_ends_in_the_same_way() -> None:
    """As the tutorial says: without a traceback."""
    texts = [path.read_text() for path in [*EXAMPLES.glob("steps_ros2/*.py"), *PACKAGE_ROS2.glob("*/*_node.py")]]
    (ending,) = {re.sub(r"(?<=rclpy\.spin\()\w+", "node", text[text.index("    try:\n") :]) for text in texts}
    assert "    except (KeyboardInterrupt, ExternalShutdownException):\n        pass\n" in ending
