"""C++ nodes in a page, without Python: what its worker says of them is what they do in simulated time elsewhere."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from rosspin import simulate
from rosspin.cpp import build, lean
from rosspin.cpp.building import node_command
from rosspin.measures import by_source, describe_timeline, lost_by_source
from tests.helpers.cpp_in_page import in_page, is_like
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(3)

EXAMPLES = ROOT / "examples"

NODES = [
    *("my_robotics_pkg/src/spinner_cpp_node.cpp", "my_robotics_pkg/src/spinner_rate_cpp_node.cpp"),
    *("my_robotics_pkg/src/publisher_cpp_node.cpp", "my_robotics_pkg/src/pubsub_cpp_node.cpp"),
    *("my_robotics_pkg/src/subscriber_cpp_node.cpp", "steps/2_callback.cpp", "steps/3_class.cpp"),
    "topics/eager_cpp_node.cpp",
    *(f"my_robotics_pkg_ros2_cpp/src/{name}_cpp_node.cpp" for name in ("plain", "spinner", "spinner_rate")),
    *(f"my_robotics_pkg_ros2_cpp/src/{name}_cpp_node.cpp" for name in ("publisher", "subscriber")),
    *("steps_ros2/1_class.cpp", "steps_ros2/2_callback.cpp"),
]


@pytest.mark.parametrize("name", NODES)
def test_the_listings_of_pages(name: str, tmp_path: Path) -> None:
    ((console, result),) = in_page(EXAMPLES / name, [(2.2, "")], tmp_path)
    run = simulate(EXAMPLES / name, 2.2)
    is_like((console, result), run)
    said = " ".join(describe_timeline(source, group) for source, group in by_source(run.ticks).items())
    assert result["alternative"] == said
    assert result["lost"] == []


IN_THREADS = """\
#include <mutex>
#include <ros/ros.h>
#include <thread>
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  std::mutex one, two;
  auto lock = [](std::mutex& first, std::mutex& second)
  {
    first.lock();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    SECOND;
  };
  std::thread other(lock, std::ref(one), std::ref(two));
  lock(two, one);
  other.join();
}
"""


@pytest.mark.parametrize(("second", "names"), [("second.lock()", [["thread 1", "main"]]), ("first.unlock()", [])])
def test_of_threads_nothing_but_a_deadlock_is_drawn(tmp_path: Path, second: str, names: list[list[str]]) -> None:
    file = tmp_path / "threads.cpp"
    file.write_text(IN_THREADS.replace("SECOND", second), encoding="utf-8")
    ((_, result),) = in_page(file, [(1.0, "")], tmp_path)
    scenes = result["scenes"]
    assert (scenes is None) is (not names)
    assert names == [[name for name, _ in ring["links"]] for ring in (scenes or {"rings": []})["rings"]]


@pytest.mark.parametrize("length", [20, 300])
def test_a_run_in_one_thread_can_be_gone_through_however_its_callback_is_called(tmp_path: Path, length: int) -> None:
    name = "x" * length
    file = tmp_path / "named.cpp"
    file.write_text(
        (EXAMPLES / "my_robotics_pkg/src/spinner_cpp_node.cpp")
        .read_text(encoding="utf-8")
        .replace("timerCallback", name)
    )
    ((_, result),) = in_page(file, [(1.0, "")], tmp_path)
    assert result["scenes"]["callbacks"] == [[name[:200], 0]]
    assert all(len(said) <= 500 for _, said, *_ in result["scenes"]["steps"])


READS = """\
#include "ros/ros.h"
int main()
{
  std::istringstream words("12 0.5 0x1f");
  int whole = 0, other = 0;
  double number = 0.0;
  words >> whole >> number >> std::hex >> other;
  std::printf("%d %.2f %d\\n", whole, number, other);
  std::sscanf("7 2.5", "%d %lf", &whole, &number);
  std::printf("%d %.2f %.2f\\n", whole, number, std::stod("1.25"));
}
"""


def test_a_node_that_reads_numbers_has_what_reads_them(tmp_path: Path) -> None:
    """Programs of others are without it, as it is long."""
    file = tmp_path / "reads.cpp"
    file.write_text(READS, encoding="utf-8")
    ((console, _),) = in_page(file, [(1.0, "")], tmp_path)
    assert console == "12 0.50 31\n7 2.50 1.25\n"
    program = build(file).program.read_bytes()
    assert len(lean(program, "")) < len(lean(program, READS)) - 10_000


@pytest.mark.parametrize(
    "line",
    [
        'std::printf("%g", std::stod("0x1.8p3"));',
        'std::printf("%g", std::strtod("0x1.8p3", nullptr));',
        'std::printf("%g", std::atof("0x1.8p3"));',
        'std::time_t day = 86400 * 40; char text[40]; std::strftime(text, 40, "%V %W %a %j", std::gmtime(&day)); '
        "std::puts(text);",
        "std::puts(std::strerror(ENOENT));",
    ],
)
def test_what_few_nodes_call_is_there_for_them(tmp_path: Path, line: str) -> None:
    file = tmp_path / "calls.cpp"
    file.write_text(f'#include "ros/ros.h"\n#include <cstring>\nint main()\n{{\n  {line}\n}}\n', encoding="utf-8")
    ((console, _),) = in_page(file, [(1.0, "")], tmp_path)
    assert console == simulate(file, 1.0).console


EAR = """\
#include "rcl_interfaces/msg/log.hpp"
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("ear");
  auto ear = node->create_subscription<rcl_interfaces::msg::Log>("/rosout", 10, [](const rcl_interfaces::msg::Log&) {});
  rclcpp::spin(node);
}
"""


def test_a_node_that_runs_alone_is_told_that_it_hears_no_logs(tmp_path: Path) -> None:
    file = tmp_path / "ear.cpp"
    file.write_text(EAR, encoding="utf-8")
    ((console, result),) = in_page(file, [(1.0, "")], tmp_path)
    assert console == "in a page, /rosout for a node that runs alone is not simulated; run this node on a real ROS\n"
    assert result["status"] == 1


def test_a_browser_without_jspi_says_that_it_has_no_threads(tmp_path: Path) -> None:
    file = EXAMPLES / "topics/slow_cpp_node.cpp"
    ((console, result),) = in_page(file, [(2.0, "")], tmp_path, node_command()[:1])
    assert console == (
        "a thread where WebAssembly has no JSPI (as before Chrome 137, Firefox 153 and Safari 27) is not simulated; "
        "run this node on a real ROS\n"
    )
    assert result["status"] == 1


@pytest.mark.parametrize(
    ("name", "args", "status"),
    [
        ("spinner", "--ros-args -p frequency:=[1,", 1),
        ("spinner", "--ros-args --no-such-flag", 1),
        ("spinner", "--ros-args -r __node:=2fast", 1),
        ("spinner", "--ros-args -r __node:=fast -r __ns:=/mrp", 0),
        ("spinner", "__ns:=/mrp", 0),
        ("publisher", "--ros-args -r counter:=/other/counter --log-level debug", 0),
    ],
)
def test_a_command_line_is_read_alike(name: str, args: str, status: int, tmp_path: Path) -> None:
    file = EXAMPLES / f"my_robotics_pkg_ros2_cpp/src/{name}_cpp_node.cpp"
    ((console, result),) = in_page(file, [(1.2, args)], tmp_path)
    run = simulate(file, 1.2, args.split())
    is_like((console, result), run)
    assert (run.status == 0) == (status == 0)


@pytest.mark.parametrize(
    "blocks", ["[1.7]", "[0.2, 0.0, 12.0]", "[0.2, 0.0, 3.1, 0.4, 1.25]", "[0.6, 0.6, 0.6, 0.6, 0.6]"]
)
def test_what_late_and_lost_ticks_come_to(blocks: str, tmp_path: Path) -> None:
    file = EXAMPLES / "ros2/timer_probe.cpp"
    for period in (0.5, 0.0625):
        args = ["--ros-args", "-p", f"period:={period}", "-p", f"blocks:={blocks}"]
        run = simulate(file, 10.0, args)
        ((console, result),) = in_page(file, [(10.0, shlex.join(args))], tmp_path)
        is_like((console, result), run)
        (source,) = {tick.source for tick in run.ticks}
        lost = lost_by_source(run.ticks, {source: period}, run.coming)
        assert result["lost"] == [[name, round(time, 6)] for name, times in lost.items() for time in times]
        said = describe_timeline(source, run.ticks)
        assert result["alternative"] == said + (f" Lost ticks: {len(lost[source])}." if lost else "")
