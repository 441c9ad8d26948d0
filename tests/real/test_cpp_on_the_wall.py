"""C++ nodes on the wall clock: what comes, and in which order, whatever the machine does meanwhile."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from rosspin import measure
from rosspin.clocks.ctrl_c import Ending
from rosspin.run.host import Host
from tests.helpers.shells import ipython_shell
from tests.helpers.tree import EXAMPLES

SPINNERS = [
    EXAMPLES / "my_robotics_pkg" / "src" / "spinner_cpp_node.cpp",
    EXAMPLES / "my_robotics_pkg_ros2_cpp" / "src" / "spinner_cpp_node.cpp",
]
of_both = pytest.mark.parametrize("node", SPINNERS, ids=["ros1", "ros2"])

# It computes for 20 ms in each callback, and a thread of it waits for a lock, which it gets when a callback has ended.
BUSY = """
#include <chrono>
#include <mutex>
#include <thread>
#include "rclcpp/rclcpp.hpp"
using namespace std::chrono_literals;
int main(int argc, char* argv[])
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("busy");
  std::mutex mutex;
  auto timer = node->create_wall_timer(50ms, [&] {
    std::lock_guard lock(mutex);
    auto end = std::chrono::steady_clock::now() + 20ms;
    while (std::chrono::steady_clock::now() < end) {}
    std::puts("computed");
  });
  std::thread thread([&] {
    while (rclcpp::ok()) {
      std::this_thread::sleep_for(30ms);
      std::lock_guard lock(mutex);
      std::puts("locked");
    }
  });
  rclcpp::spin(node);
  thread.join();
}
"""

LOOPS = "#include <ros/ros.h>\nint main() { for (volatile long n = 0;; n = n + 1) {} }\n"


@of_both
def test_a_node_ticks_in_real_time(node: Path) -> None:
    run = measure(node, 2.2)
    assert (run.status, run.runtime, run.seconds) == (0, "wall", 2.2)
    assert run.start > 1.7e9
    counters = re.findall(r"counter = (\d+)", run.console)
    assert counters and counters == [str(number) for number, _ in enumerate(counters, 1)]
    assert len(run.ticks) == len(counters)
    assert all(tick.real >= tick.expected for tick in run.ticks)


def test_what_computes_takes_time_and_threads_take_turns(tmp_path: Path) -> None:
    node = tmp_path / "busy.cpp"
    node.write_text(BUSY)
    run = measure(node, 2.0)
    assert run.status == 0
    assert {"computed", "locked"} <= set(run.console.splitlines())
    assert run.ticks and all(tick.duration >= 0.02 for tick in run.ticks if tick.duration == tick.duration)


@of_both
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["ctrl-c", "sigterm"])
def test_the_user_ends_it(node: Path, number: int) -> None:
    command = [sys.executable, "-m", "rosspin", "run", str(node)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        assert process.stdout
        printed = [next(line for line in process.stdout if "counter = 1" in line)]
        process.send_signal(number)
        printed += process.stdout
    wanted = 128 + number if number == signal.SIGTERM and node is SPINNERS[0] else 0  # roscpp does not handle it
    assert process.returncode == wanted, printed
    assert node is SPINNERS[0] or f"signal_handler(signum={number:d})" in printed[-1]


def test_a_node_that_never_waits_is_killed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(Host, "ending", Ending(((signal.SIGINT, 0.5),)))
    node = tmp_path / "loops.cpp"
    node.write_text(LOOPS)
    run = measure(node, 0.1)
    assert run.status == 128 + signal.SIGKILL
    assert "Ctrl-C at 0.1 s did not end the node; it was killed 0.5 s later" in run.console


def test_a_cell_is_measured(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with ipython_shell(tmp_path) as shell:
        shell.run_cell(f"%%measure 1.2\n{SPINNERS[1].read_text()}")
        run: Any = shell.user_ns["run"]
    assert "counter = 1" in capsys.readouterr().err
    assert (run.status, run.runtime) == (0, "wall")
