"""C++ nodes of ROS 2 do in simulated time what they did on the real one, as far as that was recorded."""

from __future__ import annotations

import csv
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from benchmarks.rclcpp_nodes import read_ticks
from rosspin import Node, NotSimulated, simulate
from rosspin.results.recordings import load
from rosspin.run.explain import say_error
from tests.helpers.cpp_in_page import scenarios_are_like
from tests.helpers.cpp_probes import differences
from tests.helpers.cpp_scenarios import FOLDER, SECONDS, compared, recorded
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(9)

Write = Callable[[str, str], Path]

EXAMPLES = ROOT / "examples"
PACKAGE = EXAMPLES / "my_robotics_pkg_ros2_cpp" / "src"
PYTHON = EXAMPLES / "my_robotics_pkg_ros2" / "my_robotics_pkg"
RECORDINGS = EXAMPLES / "recordings" / "ros2"

STAMPED = "[INFO] [{}] [mrp.spinner_cpp_node]: [SPINNER CPP NODE] {}\n"
ENDED = "[INFO] [1.200000000] [rclcpp]: signal_handler(signum=2)\n"


@pytest.mark.parametrize("name", ["spinner_cpp_node", "spinner_rate_cpp_node"])
def test_the_listings_of_the_tutorial(name: str) -> None:
    run = simulate(PACKAGE / f"{name}.cpp", 1.2, ["--ros-args", "-r", "__ns:=/mrp"])
    first = 0 if "rate" in name else 1
    lines = [("0.000000000", "namespace of node = /mrp")]
    lines += [(f"{half / 2:.9f}", f"counter = {half + 1 - first}") for half in range(first, 3)]
    assert run.console == "".join(STAMPED.format(*line) for line in lines) + ENDED
    assert run.status == 0
    expected = [half / 2 for half in range(first, 3)]
    assert [(each.expected, each.real) for each in run.ticks] == [(time, time) for time in expected]
    assert {each.source for each in run.ticks} == {"Rate" if first == 0 else "lambda"}


def test_python_hears_cpp_and_cpp_hears_python() -> None:
    run = simulate([str(PACKAGE / "publisher_cpp_node.cpp"), str(PYTHON / "subscriber_py_node.py")], 2.0)
    assert "[SUBSCRIBER PY NODE] counter = 3" in run.console
    assert [(each.topic, each.node, each.message.data) for each in run.messages][:2] == [
        ("/counter", "/publisher_cpp_node", 1),
        ("/counter", "/publisher_cpp_node", 2),
    ]
    run = simulate([str(PYTHON / "publisher_py_node.py"), str(PACKAGE / "subscriber_cpp_node.cpp")], 2.0)
    assert "[SUBSCRIBER CPP NODE] counter = 3" in run.console


LOGS = """\
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("talker");
  auto child = node->get_logger().get_child("motor");
  RCLCPP_INFO(node->get_logger(), "early");
  auto timer = node->create_wall_timer(std::chrono::milliseconds(500), [&] {
    RCLCPP_WARN(node->get_logger(), "hot");
    RCLCPP_ERROR(child, "stuck");
    RCLCPP_DEBUG(child, "too little");
    RCLCPP_INFO(rclcpp::get_logger("talker.other"), "no child");
  });
  rclcpp::spin(node);
  RCLCPP_INFO(node->get_logger(), "late");
}
"""
HEARS_LOGS = """\
import rclpy
from rcl_interfaces.msg import Log
from rclpy.qos import DurabilityPolicy, QoSProfile

rclpy.init()
node = rclpy.create_node("ear")
def hear(log):
    print(log.name, log.level, log.msg, log.stamp.nanosec, log.file[-11:], log.line, log.function)

node.create_subscription(Log, "/rosout", hear, QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL))
rclpy.spin(node)
"""


def test_other_nodes_hear_what_it_logs(write: Write) -> None:
    """What its node's logger says and those below it, from the beginning, until it shuts down."""
    nodes = [write(LOGS, "talker.cpp"), write(HEARS_LOGS, "ear.py")]
    run = simulate([str(node) for node in nodes], 0.6)
    heard = [line for line in run.console.splitlines() if line.startswith("talker")]
    assert heard == [
        "talker 20 early 0 /talker.cpp 7 main",
        "talker 30 hot 500000000 /talker.cpp 9 operator()",
        "talker.motor 40 stuck 500000000 /talker.cpp 10 operator()",
    ]
    run = simulate([Node(str(nodes[0]), ["--ros-args", "--disable-rosout-logs"]), str(nodes[1])], 0.6)
    assert not [line for line in run.console.splitlines() if line.startswith("talker")]


AS_WITH_GCC = """\
#include <fstream>
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node");
  std::int64_t three = 3, four = 4;
  std::uint8_t small = 200;
  std::int16_t below = -5;
  char text[40];
  std::printf("%ld + %ld = %ld of %s, %p\\n", three, four, three + four, "ten", nullptr);
  std::snprintf(text, 12, "%6.2f|%-4s|%03d", 3.14159, "ab", 7);
  std::printf("%s %d\\n", text, snprintf(nullptr, 0, "%lu", 12345ul));
  RCLCPP_INFO(node->get_logger(), "%d %d %02x", small, below, small);
  std::cout << rand() << " " << std::rand() << " " << random();
  srand(42);
  std::cout << " " << rand() % 100 << std::endl;
  errno = 0;
  std::ofstream file("log.csv");
  std::ifstream other("other.csv");
  std::cout << file.is_open() << other.is_open() << " " << std::strerror(errno) << std::endl;
  std::chrono::time_point<std::chrono::system_clock> begun = std::chrono::high_resolution_clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  std::cout << (std::chrono::system_clock::now() - begun).count() << std::endl;
}
"""


def test_the_library_does_what_that_of_gcc_does_on_a_computer(write: Write) -> None:
    """What it printed there, but for the files."""
    run = simulate(write(AS_WITH_GCC, "node.cpp"), 2.0)
    assert run.console.splitlines() == [
        "3 + 4 = 7 of ten, (nil)",
        "  3.14|ab   5",
        "[INFO] [0.000000000] [node]: 200 -5 c8",
        "1804289383 846930886 1681692777 66",
        "rosspin: files are not simulated, so this one was not opened: log.csv",
        "00 No such file or directory",
        "1500000000",
    ]


OTHERWISE = """\
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  std::cout << sizeof(long) << sizeof(std::size_t) << " " << std::default_random_engine()() << std::endl;
}
"""


def test_what_is_said_to_be_otherwise_than_with_gcc_is(write: Write) -> None:
    """There it is 88 16807."""
    assert simulate(write(OTHERWISE, "node.cpp"), 1.0).console == "44 48271\n"


HOLDS = """\
#include "rclcpp/rclcpp.hpp"
int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("holder");
  node->declare_parameter("whole", 5);
  auto change = [&] { node->set_parameter(rclcpp::Parameter("whole", 6)); };
  auto timer = node->create_wall_timer(std::chrono::seconds(1), change);
  rclcpp::spin(node);
}
"""

ASKS = """\
import rclpy
from rcl_interfaces.msg import ParameterEvent
from rclpy.parameter_client import AsyncParameterClient

def heard(event):
    print(event.node, [(each.name, each.value.integer_value) for each in event.changed_parameters])

rclpy.init()
node = rclpy.create_node("asks")
node.create_subscription(ParameterEvent, "/parameter_events", heard, 10)
client = AsyncParameterClient(node, "/holder")
client.wait_for_services()
future = client.get_parameters(["use_sim_time", "whole"])
rclpy.spin_until_future_complete(node, future)
print([each.integer_value for each in future.result().values])
rclpy.spin(node)
"""


WAITS = """
  auto node = std::make_shared<rclcpp::Node>("waits");
  rclcpp::SyncParametersClient client(node, "holder");
  bool found = client.wait_for_service(std::chrono::seconds(2));
  std::printf("%d %d %d\\n", found, client.get_parameter<int>("whole"), node->now().seconds() < 0.3);
"""


def test_cpp_finds_the_parameters_of_another_process_soon(write: Write) -> None:
    """It waits for them as long as to find them takes, not for the whole of its timeout."""
    run = simulate([str(write(HOLDS, "holds.cpp")), str(write(main(WAITS), "waits.cpp"))], 3.0)
    assert run.console.splitlines()[0] == "1 5 1"


HEARS_BEST_EFFORT = """\
import rclpy
from rclpy.qos import QoSProfile
from std_msgs.msg import UInt32
rclpy.init()
node = rclpy.create_node("hears", namespace="lab")
node.create_subscription(UInt32, "/topic", print, QoSProfile(depth=3, reliability=2, durability=2))
rclpy.spin(node)
"""

LOOKS = """
  auto node = std::make_shared<rclcpp::Node>("looks");
  auto publisher = node->create_publisher<std_msgs::msg::UInt32>("topic", 10);
  rclcpp::sleep_for(std::chrono::seconds(1));
  for (const auto& each : node->get_subscriptions_info_by_topic("/topic"))
    std::printf("%s %s %s %d %d\\n", each.node_name().c_str(), each.node_namespace().c_str(), each.topic_type().c_str(),
        each.endpoint_type() == rclcpp::EndpointType::Subscription,
        each.qos_profile().reliability() == rclcpp::ReliabilityPolicy::BestEffort);
  for (const auto& each : node->get_publishers_info_by_topic("/topic"))
    std::printf("%s %d\\n", each.node_name().c_str(),
        each.qos_profile().reliability() == rclcpp::ReliabilityPolicy::Reliable);
"""


def test_cpp_sees_the_ends_of_a_topic(write: Write) -> None:
    text = main(LOOKS, '"std_msgs/msg/u_int32.hpp"')
    run = simulate([str(write(text, "looks.cpp")), str(write(HEARS_BEST_EFFORT, "hears.py"))], 1.5)
    assert run.console.splitlines()[:2] == ["hears /lab std_msgs/msg/UInt32 1 1", "looks 1"]


def test_python_asks_for_parameters_of_cpp(write: Write) -> None:
    run = simulate([str(write(HOLDS, "holds.cpp")), str(write(ASKS, "asks.py"))], 1.5)
    assert run.console.splitlines()[:2] == ["[0, 5]", "/holder [('whole', 6)]"]


SCENARIOS = {file: recorded(f"{file}.txt") for file in ("ros2", "ros2_filters", "ros2_topics", "ros2_threads")}


@pytest.mark.parametrize(("file", "name"), [(file, name) for file, names in SCENARIOS.items() for name in names])
def test_a_scenario_gives_what_rclcpp_would(file: str, name: str) -> None:
    run = simulate(FOLDER / f"{file}.cpp", SECONDS, [name, "--ros-args", "-r", "from:=to"], start=100.0)
    assert compared(run.console, run.status) == SCENARIOS[file][name]


def test_timers_follow_jumps_as_those_of_rclpy() -> None:
    """What that did on a real ROS was recorded: both leave it to rcl."""
    real = (ROOT / "tests/scenarios_ros2/recorded/sim_time_jumps.txt").read_text(encoding="utf-8").splitlines()
    ours = [line.partition(" ")[2] for line in SCENARIOS["ros2_topics"]["sim_time_jumps"].splitlines()]
    assert ours[:-1] == [line.removesuffix(".0") for line in real[1:]]


def test_what_is_approximate_is_as_in_ros_1() -> None:
    """There it was recorded. Only the warnings are other ones."""
    real = recorded("ros1_filters.txt")
    names = [name for name in SCENARIOS["ros2_filters"] if name.startswith("approximate")]
    assert len(names) == 5
    for name in names:
        found, wanted = (
            [line for line in text.splitlines() if "WARN" not in line]
            for text in (SCENARIOS["ros2_filters"][name], real[name])
        )
        assert found == wanted


@pytest.mark.parametrize("file", SCENARIOS)
def test_a_page_says_the_same_of_each_scenario(file: str, tmp_path: Path) -> None:
    scenarios_are_like(file, tmp_path)


@pytest.mark.parametrize(
    ("file", "most"), [("ros2", 36), ("ros2_topics", 32), ("ros2_threads", 20), ("ros2_filters", 7)]
)
def test_each_scenario_has_its_lines(file: str, most: int) -> None:
    assert simulate(FOLDER / f"{file}.cpp", 1.0).console.split() == list(SCENARIOS[file])
    assert len(SCENARIOS[file]) >= most


def recordings(is_of_threads: bool) -> list[Path]:
    """The recordings of the probes in one thread, or several."""
    files = sorted(RECORDINGS.glob("*_cpp_*.csv"))
    return [file for file in files if ("executor:=multi" in load(file).provenance["command"]) == is_of_threads]


@pytest.mark.parametrize("file", recordings(True), ids=lambda file: file.stem)
def test_the_probes_tick_in_threads_as_they_did(file: Path) -> None:
    """Those due at the same time in no order. A timer whose callback takes too long may never be called again."""
    real = load(file)
    run = simulate(EXAMPLES / "ros2/timer_probe.cpp", real.seconds, real.provenance["command"].split()[1:])
    ours, theirs = (
        sorted(ticks, key=lambda tick: (tick.source, tick.number)) for ticks in (read_ticks(run.console), real.ticks)
    )
    assert differences(ours, theirs) == []


@pytest.mark.parametrize("file", recordings(False), ids=lambda file: file.stem)
def test_the_probes_tick_as_they_did(file: Path) -> None:
    real = load(file)
    program, *args = real.provenance["command"].split()
    run = simulate(EXAMPLES / "ros2" / f"{program}.cpp", real.seconds, args, start=100.0)
    told = read_ticks(run.console)  # a node that has found no /clock calls nothing
    assert differences(told, real.ticks) == differences(run.ticks, real.ticks) == []


def test_there_are_recordings_of_random_lengths() -> None:
    assert sum("_random_" in file.name for file in recordings(False)) == 4


def test_another_rule_of_the_rate_would_be_noticed() -> None:
    """rclpy's, which always keeps the grid."""
    real = load(RECORDINGS / "rate_cpp_blocks_once_2.4.csv")
    args = real.provenance["command"].split()[1:]
    assert differences(simulate(EXAMPLES / "ros2" / "rate_probe.py", real.seconds, args).ticks, real.ticks)


@pytest.mark.parametrize(
    ("program", "args", "wanted"),
    [
        ("timer_probe", "block:=0.7", [1.0, 1.5, 2.2, 2.5, 3.0]),
        ("timer_probe", "block:=1.7", [1.0, 1.5, 3.2, 3.5, 4.0]),
        ("rate_probe", "block:=0.7", [0.5, 1.0, 1.7, 2.0, 2.5]),
        ("rate_probe", "block:=1.0", [0.5, 1.0, 2.0, 2.0, 2.5]),  # the limit itself: the grid is kept
        ("rate_probe", "block:=1.001", [0.5, 1.0, 2.001, 2.501, 3.001]),
        # Until the clock has caught up with the mark.
        ("rate_probe", "blocks:=[0.2,0.2,1.7] block:=0.2 block_call:=0", [0.5, 1.0, 2.7, 3.4, 4.1, 4.7]),
    ],
)
def test_after_a_third_call_or_pass_of_a_length(program: str, args: str, wanted: list[float]) -> None:
    """Sources: rcl/timer.c, ``rcl_timer_call``; rclcpp/rate.cpp, ``Rate::sleep``."""
    words = ["--ros-args", *(word for each in ("block_call:=3", *args.split()) for word in ("-p", each))]
    ticks = simulate(EXAMPLES / "ros2" / f"{program}.cpp", 9.0, words).ticks
    assert [tick.real for tick in ticks][1 : 1 + len(wanted)] == pytest.approx(wanted)


def endings() -> list[tuple[str, int]]:
    """How each of the nodes that end in their own ways ended at Ctrl-C, or by itself."""
    with open(RECORDINGS / "endings_cpp.csv", newline="", encoding="utf-8") as file:
        return [(row["node"], int(row["status"])) for row in csv.DictReader(file) if row["signal"] != "SIGTERM"]


SAID = {
    "exception": "terminate called after throwing an instance of 'std::runtime_error'\n  what():  in a callback",
    "rate_working": "context cannot be slept with because it's invalid",
    "rate_working_spin_some": "instance of 'rclcpp::exceptions::RCLError'\n"
    "  what():  failed to create guard condition: the given context is not valid",
}


@pytest.mark.parametrize(("name", "status"), endings())
def test_a_node_ends_as_it_did(name: str, status: int) -> None:
    run = simulate(EXAMPLES / "ros2" / "endings" / f"{name}.cpp", 1.2)
    assert run.status == status
    assert SAID.get(name, "") in run.console
    assert ("signal_handler(signum=2)" in run.console) == (name not in ("exception", "shutdown_in_callback"))


COMPONENT = """\
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"

namespace parts
{
class Part : public rclcpp::Node
{
public:
  explicit Part(const rclcpp::NodeOptions& options) : Node("part", options)
  {
    timer_ = create_wall_timer(std::chrono::milliseconds(300), std::bind(&Part::onTimer, this));
  }

private:
  void onTimer() { RCLCPP_INFO(get_logger(), "part %ld", static_cast<std::int64_t>(++count_)); }
  int count_ = 0;
  rclcpp::TimerBase::SharedPtr timer_;
};
}  // namespace parts
RCLCPP_COMPONENTS_REGISTER_NODE(parts::Part)
"""


def test_a_component_runs_without_a_main(write: Write) -> None:
    run = simulate(write(COMPONENT, "part.cpp"), 1.0, ["--ros-args", "-r", "__node:=other"])
    assert re.findall(r"\[other\]: (.*)", run.console) == ["part 1", "part 2", "part 3"]
    assert [each.source for each in run.ticks] == ["onTimer"] * 3
    assert run.status == 0


def main(body: str, include: str = '"rclcpp/rclcpp.hpp"') -> str:
    text = f"{{\n  rclcpp::init(argc, argv);\n  {body}\n}}\n"
    return f'#include "rclcpp/rclcpp.hpp"\n#include {include}\nint main(int argc, char** argv)\n{text}'


@pytest.mark.parametrize(
    ("include", "body", "name"),
    [
        ('"rclcpp_lifecycle/lifecycle_node.hpp"', "", "rclcpp_lifecycle/lifecycle_node.hpp"),
        ('"rclcpp_action/rclcpp_action.hpp"', "", "rclcpp_action/rclcpp_action.hpp"),
        ('"tf2_ros/buffer.h"', "", "tf2_ros/buffer.h"),
        (
            '"rclcpp/parameter_client.hpp"',
            'rclcpp::AsyncParametersClient(std::make_shared<rclcpp::Node>("node")).load_parameters("file.yaml");',
            "rclcpp::AsyncParametersClient::load_parameters",
        ),
        (
            "<memory>",
            'rclcpp::SubscriptionOptions().content_filter_options.filter_expression = "data > 1";',
            "rclcpp::SubscriptionOptions::content_filter_options",
        ),
        (
            "<memory>",
            "rclcpp::SubscriptionOptions().topic_stats_options.state = 1;",
            "rclcpp::SubscriptionOptions::topic_stats_options",
        ),
        (
            "<memory>",
            "rclcpp::PublisherOptions().require_unique_network_flow_endpoints = 1;",
            "rclcpp::PublisherOptions::require_unique_network_flow_endpoints",
        ),
    ],
)
def test_what_has_no_stand_in_is_named(write: Write, include: str, body: str, name: str) -> None:
    with pytest.raises(NotSimulated) as raised:
        simulate(write(main(body, include), "node.cpp"), 1.0)
    assert str(raised.value) == f"{name} is not simulated; run this node on a real ROS"


@pytest.mark.parametrize(
    ("include", "body", "line", "name"),
    [
        ("<termios.h>", "", ":2", "termios.h"),
        ("<unistd.h>", "fork();", ":6", "fork"),
        ("<cstdlib>", 'system("clear");', "", "system"),
    ],
)
def test_what_has_no_stand_in_has_its_place(write: Write, include: str, body: str, line: str, name: str) -> None:
    """As far as the compiler knows it."""
    file = write(main(body, include), "node.cpp")
    with pytest.raises(NotSimulated) as raised:
        simulate(file, 1.0)
    assert say_error(raised.value) == f"{file}{line}: {name} is not simulated; run this node on a real ROS"


def test_a_throttled_line_comes_again_after_its_period(write: Write) -> None:
    """Exactly then, too (source: rcutils/logging_macros.h, ``RCUTILS_LOG_CONDITION_THROTTLE_BEFORE``)."""
    body = """
  auto node = std::make_shared<rclcpp::Node>("node");
  auto tick = [&] { RCLCPP_INFO_THROTTLE(node->get_logger(), *node->get_clock(), 500, "tick"); };
  auto timer = node->create_wall_timer(std::chrono::milliseconds(500), tick);
  rclcpp::spin(node);
"""
    assert simulate(write(main(body), "node.cpp"), 2.2).console.count("tick") == 4


MOVES = """
  auto options = rclcpp::NodeOptions().use_intra_process_comms(std::string(argv[1]) == "moves");
  auto node = std::make_shared<rclcpp::Node>("node", options);
  typedef std_msgs::msg::UInt32 UInt32;
  std::map<const void*, std::string> sent;
  auto hear = [&](UInt32::UniquePtr message)
  {
    RCLCPP_INFO(node->get_logger(), "%u%s", message->data, sent[message.get()].c_str());
    if (message->data == 3)
      rclcpp::shutdown();
  };
  auto subscription = node->create_subscription<UInt32>("topic", 2, hear);
  auto publisher = node->create_publisher<UInt32>("topic", 2);
  for (unsigned count = 1; count < 4; count++)  // the first finds no room
  {
    auto message = std::make_unique<UInt32>();
    message->data = count;
    sent[message.get()] = " as it is";
    publisher->publish(std::move(message));
  }
  std::printf("within the process: %zu\\n", publisher->get_intra_process_subscription_count());
  rclcpp::spin(node);
"""


def test_within_a_process_a_message_is_moved_if_the_node_asks_for_it(write: Write) -> None:
    node = write(main(MOVES, '"std_msgs/msg/u_int32.hpp"'), "node.cpp")
    for how, heard in (("moves", ["2 as it is", "3 as it is"]), ("copies", ["2", "3"])):
        console = simulate(node, 1.0, [how]).console
        assert re.findall(r"\[node\]: (.*)", console) == heard
        assert f"within the process: {how == 'moves':d}\n" in console


CLIENT = """
  auto node = std::make_shared<rclcpp::Node>("node");
  auto client = node->create_client<std_srvs::srv::Trigger>("absent");
  auto ask = [&] { return client->async_send_request(std::make_shared<std_srvs::srv::Trigger::Request>()); };
  ask();
  rclcpp::sleep_for(std::chrono::seconds(2));
  ask();
  std::vector<std::int64_t> pruned;
  auto old = client->prune_requests_older_than(std::chrono::system_clock::now() - std::chrono::seconds(1), &pruned);
  std::printf("%zu %zu %zu\\n", old, pruned.size(), client->prune_pending_requests());
  rclcpp::PublisherOptions options;
  options.event_callbacks.matched_callback = [](rclcpp::MatchedInfo& info)
  { std::printf("matched %lu %d\\n", info.current_count, info.current_count_change); };
  auto publisher = node->create_publisher<std_msgs::msg::UInt32>("topic", 1, options);
  auto subscription = node->create_subscription<std_msgs::msg::UInt32>("topic", 1, [](std_msgs::msg::UInt32) {});
  rclcpp::spin_some(node);
  rclcpp::shutdown();
  auto answered = ask().wait_for(std::chrono::seconds(1)) == std::future_status::ready;
  std::printf("answered %d\\n", answered);
  node->create_publisher<std_msgs::msg::UInt32>("topic", 1);
"""


def test_requests_are_given_up_and_after_shutdown_none_is_answered(write: Write) -> None:
    includes = '"std_msgs/msg/u_int32.hpp"\n#include "std_srvs/srv/trigger.hpp"'
    run = simulate(write(main(CLIENT, includes), "node.cpp"), 9.0)
    said = "  what():  could not create publisher: rcl node's context is invalid"
    assert run.console.splitlines()[:3] == ["1 1 1", "matched 1 1", "answered 0"]
    assert run.console.splitlines()[-1] == said


EVENTS = """
  auto node = std::make_shared<rclcpp::Node>("node");
  int count = 0;
  auto timer = node->create_wall_timer(std::chrono::milliseconds(500), [&]
  {
    if (++count == 3)
      std::this_thread::sleep_for(std::chrono::milliseconds(1700));
  });
  rclcpp::experimental::executors::EventsExecutor executor;
  executor.add_node(node);
  executor.spin();
"""


def test_the_executor_of_events_makes_each_call_that_became_due(write: Write) -> None:
    """Measured on rclcpp 28.1.6: after a third call of 1.7 s, all three that were due meanwhile."""
    include = '"rclcpp/experimental/executors/events_executor/events_executor.hpp"'
    run = simulate(write(main(EVENTS, include), "node.cpp"), 4.0)
    assert [tick.real for tick in run.ticks] == [0.5, 1.0, 1.5, 3.2, 3.2, 3.2, 3.5, 4.0]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("--ros-args --unknown", "found unknown ROS arguments: '--unknown'"),
        ("--ros-args -r a", "failed to initialize rcl: Couldn't parse remap rule: '-r a'"),
        (
            "--ros-args -p count:=true",
            "parameter 'count' has invalid type: Wrong parameter type, parameter {count} is of",
        ),
    ],
)
def test_a_command_line_that_does_not_fit(write: Write, words: str, said: str) -> None:
    body = 'rclcpp::Node node("node");\n  node.declare_parameter("count", 1);'
    run = simulate(write(main(body), "node.cpp"), 1.0, words.split())
    assert run.status == 134
    assert said in run.console


def test_a_name_that_is_not_valid(write: Write) -> None:
    run = simulate(write(main('rclcpp::Node node("a b");'), "node.cpp"), 1.0)
    assert run.status == 134
    assert (
        "terminate called after throwing an instance of 'rclcpp::exceptions::InvalidNodeNameError'\n"
        "  what():  Invalid node name: node name must not contain characters other than alphanumerics or '_':\n"
        "  'a b'\n    ^\n"
    ) in run.console
