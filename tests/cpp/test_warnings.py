"""What the compiler warns of is shown where it is of a fault, and only there."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

from rosspin.__main__ import main
from rosspin.cpp import build, building
from rosspin.cpp.faults import advice, shown
from tests.helpers.answers import IN_CPP
from tests.helpers.cpp_scenarios import FOLDER
from tests.helpers.tree import EXAMPLES

NODES = {
    1: """\
#include "ros/ros.h"
int cubed(int number) { if (number < 100) return number * number * number; }
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle node;
  int counter = 5;
  std::int64_t ns = 7;
  std::size_t size = 3;
  ROS_INFO("%s", counter);
  ROS_INFO_THROTTLE(1.0, "%d", 0.5);
  ROS_INFO("%ld %lld %lu %zu %d", ns, ns, ns, size, cubed(counter));
  std::string text = "counter: " + counter;
  while (ros::ok)
    break;
}
""",
    2: """\
#include "rclcpp/rclcpp.hpp"
int cubed(int number) { if (number < 100) return number * number * number; }
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node");
  int counter = 5;
  std::int64_t ns = 7;
  std::size_t size = 3;
  RCLCPP_INFO(node->get_logger(), "%s", counter);
  RCLCPP_INFO_THROTTLE(node->get_logger(), *node->get_clock(), 1000, "%d", 0.5);
  RCLCPP_INFO(node->get_logger(), "%ld %lld %lu %zu %d", ns, ns, ns, size, cubed(counter));
  std::string text = "counter: " + counter;
  if (counter = 3)
    counter == 4;
}
""",
}
GROUPS = {
    1: [(2, "return-type"), (10, "format"), (11, "format"), (13, "string-plus-int"), (14, "pointer-bool-conversion")],
    2: [
        *((2, "return-type"), (10, "format"), (11, "format"), (13, "string-plus-int")),
        *((14, "parentheses"), (15, "unused-comparison")),
    ],
}


def warned(said: str, file: str) -> list[tuple[int, str]]:
    found = re.findall(rf"^{re.escape(file)}:(\d+):\d+: warning: .* \[-W([\w-]+)\]$", said, re.MULTILINE)
    return [(int(line), group) for line, group in found]


@pytest.mark.parametrize("ros", NODES)
def test_faults_are_told_before_the_run_and_again_without_a_compiler(
    ros: int, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "node.cpp"
    file.write_text(NODES[ros], encoding="utf-8")
    consoles = []
    for _ in range(2):
        assert main(["run", str(file), "--simulated", "--seconds", "1"]) == 0
        consoles.append("".join(reversed(capsys.readouterr())))
        monkeypatch.setattr(building, "_compile", None)
    assert consoles[0] == consoles[1]
    assert warned(consoles[0], str(file)) == GROUPS[ros]
    assert "Each way through this function has to end in return and a value;" in consoles[0]
    assert "include/" not in consoles[0] and "silence" not in consoles[0]
    assert "7 7 7 3 125" in consoles[0]


def test_what_does_not_compile_is_told_with_its_warnings_and_explained_before_them() -> None:
    with pytest.raises(building.CompileError) as told:
        build("node.cpp", text=NODES[1].replace("counter = 5;", "counter = 5").replace("ros::ok", "ros::okay()"))
    assert warned(str(told.value), "node.cpp") == GROUPS[1][:4]
    assert "error: expected ';'" in str(told.value) and "warnings" not in str(told.value)
    assert advice(str(told.value)).startswith("A ; is missing")


def test_a_header_of_the_nodes_own_is_looked_at_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "half.hpp").write_text("inline int half() { int whole = 0.5; return whole; }\n", encoding="utf-8")
    file = tmp_path / "node.cpp"
    file.write_text('#include "ros/ros.h"\n#include "half.hpp"\nint main() { return half(); }\n', encoding="utf-8")
    assert "own/half.hpp:1:33: warning: implicit conversion from 'double' to 'int'" in build(file).warnings


def test_a_long_of_another_size_and_what_need_not_be_a_fault_are_left_out() -> None:
    said = """\
a.cpp:1:2: warning: format specifies type 'long' but the argument has type 'int64_t' (aka 'long long') [-Wformat]
    1 | text
a.cpp:2:2: warning: unused variable 'text' [-Wunused-variable]
a.cpp:3:2: warning: format specifies type 'int' but the argument has type 'long long' [-Wformat]
a.cpp:4:2: warning: format specifies type 'int' but the argument has type 'uint8_t' (aka 'unsigned char') [-Wformat]
4 warnings generated.
"""
    assert shown(said) == "".join(said.splitlines(keepends=True)[3:4])
    of_linker = "wasm-ld: error: 0.o: undefined symbol: system\n"
    assert shown(said + of_linker) == "".join([said.splitlines(keepends=True)[3], of_linker])


SCENARIOS = sorted(FOLDER.glob("*.cpp"))
LISTINGS = sorted(EXAMPLES.rglob("*.cpp"))
ANSWERS: list[tuple[str, Any]] = [(name, answer) for name, lesson in IN_CPP.items() for answer in (None, *lesson.right)]


@pytest.mark.shares(27)
@pytest.mark.parametrize("file", [*LISTINGS, *SCENARIOS], ids=lambda file: file.stem)
def test_no_node_of_a_page_and_no_scenario_is_warned_of(file: Path) -> None:
    """But for one that passes a function in place of a truth value, and tells what comes of that."""
    assert bool(build(file).warnings) == (file.stem == "ros1_graph")


@pytest.mark.shares(27)
@pytest.mark.parametrize(("name", "answer"), ANSWERS)
def test_no_right_answer_is_warned_of(name: str, answer: Any) -> None:
    lesson = IN_CPP[name]
    text = lesson.node if answer is None else lesson.written(answer)
    assert build("answer.cpp", text=text, closed=True).warnings == ""


@pytest.mark.parametrize(
    ("bound", "said"),
    [
        ("std::bind(&Counter::tick, this)", "The method takes other parameters than it is given: a timer of ROS 2"),
        ("std::bind(&Counter::tick)", "A method is called on an object, which is missing here"),
    ],
)
def test_what_is_wrong_with_a_bound_method_is_said(tmp_path: Path, bound: str, said: str) -> None:
    node = tmp_path / "node.cpp"
    node.write_text(
        '#include "rclcpp/rclcpp.hpp"\nstruct Counter : rclcpp::Node\n{\n  Counter() : Node("counter")\n  {\n'
        f"    timer = create_wall_timer(std::chrono::seconds(1), {bound});\n  }}\n"
        "  void tick(int) {}\n  rclcpp::TimerBase::SharedPtr timer;\n};\nint main() { Counter counter; }\n"
    )
    with pytest.raises(building.CompileError) as told:
        build(node)
    assert advice(str(told.value)).startswith(said)
