"""C++ nodes of ROS 1 do in simulated time what they did on the real one."""

from __future__ import annotations

import csv
import re
import signal
from collections.abc import Callable
from pathlib import Path

import pytest

from rosspin import NotSimulated, TimeStandsStill, simulate
from rosspin.cpp import nodejs
from rosspin.faults import Service
from rosspin.results.recordings import load
from tests.helpers.cpp_in_page import scenarios_are_like
from tests.helpers.cpp_probes import differences
from tests.helpers.cpp_scenarios import FOLDER, SECONDS, compared, recorded, words
from tests.helpers.tree import ROOT

pytestmark = pytest.mark.shares(9)

Write = Callable[[str, str], Path]

SCENARIOS = {file: recorded(f"{file}.txt") for file in ("ros1", "ros1_filters", "ros1_graph", "ros1_threads")}
PACKAGE = ROOT / "examples" / "my_robotics_pkg" / "src"
PROBE = ROOT / "examples" / "timing_probes" / "src" / "timer_probe.cpp"


@pytest.mark.parametrize(("file", "name"), [(file, name) for file, names in SCENARIOS.items() for name in names])
def test_a_scenario_gives_what_it_gave_on_the_real_one(file: str, name: str) -> None:
    run = simulate(FOLDER / f"{file}.cpp", SECONDS, words(name), start=1_000.0)
    assert compared(run.console, run.status) == SCENARIOS[file][name]


@pytest.mark.parametrize("file", SCENARIOS)
def test_a_page_says_the_same_of_each_scenario(file: str, tmp_path: Path) -> None:
    scenarios_are_like(file, tmp_path)


# Made by timers in a node that spins at once in one thread.
RECORDINGS = sorted(ROOT.glob("examples/recordings/t*_cpp_[2bs]*.csv"))


def test_there_are_recordings_of_random_lengths() -> None:
    assert sum("_random_" in file.name for file in RECORDINGS) == 3
    assert len(RECORDINGS) == 11


@pytest.mark.parametrize("file", RECORDINGS, ids=lambda file: file.stem)
def test_the_probe_ticks_as_it_did(file: Path) -> None:
    real = load(file)
    args = re.findall(r"_\w+:=\S+", real.provenance["command"])
    assert differences(simulate(PROBE, real.seconds, args).ticks, real.ticks) == []


def test_another_rule_would_be_noticed() -> None:
    """rospy's, with its limit of 3 periods in place of 2."""
    real = load(ROOT / "examples/recordings/timer_cpp_blocks_random_1.csv")
    args = re.findall(r"_\w+:=\S+", real.provenance["command"])
    assert differences(simulate(PROBE.with_suffix(".py"), real.seconds, args).ticks, real.ticks)


@pytest.mark.parametrize(
    ("length", "wanted"),
    [
        (0.7, [1.5, 2.2, 2.5, 3.0]),
        (1.0, [1.5, 2.5, 2.5, 3.0]),  # the limit itself: the grid is kept
        (1.001, [1.5, 2.501, 3.001, 3.501]),
        (2.2, [1.5, 3.7, 4.2]),
    ],
)
def test_after_a_third_call_of_a_length(length: float, wanted: list[float]) -> None:
    """Source: ros/timer_manager.h, ``updateNext``."""
    ticks = simulate(PROBE, 4.2, [f"_block:={length}", "_block_call:=3"]).ticks
    assert [tick.real for tick in ticks][2:6] == wanted
    assert [tick.duration for tick in ticks][2:4] == pytest.approx([length, 0.0])


def claims() -> list[dict[str, str]]:
    """What the real roscpp told last in each of these runs."""
    with open(ROOT / "examples/recordings/claims.csv", newline="", encoding="utf-8") as file:
        last = {row["run"]: row for row in csv.DictReader(file) if row["language"] == "roscpp"}
    return [row for run, row in last.items() if not run.startswith("period")]  # with no pause, by jitter alone


@pytest.mark.parametrize("row", claims(), ids=lambda row: row["run"])
def test_an_odd_timer_does_what_it_did(row: dict[str, str]) -> None:
    run = simulate(PROBE.with_name("claims_probe.cpp"), float(row["ended_after"]), row["parameters"].split())
    told = [line.split(",")[2] for line in run.console.splitlines() if line.startswith("said,")]
    assert str(run.status) == row["status"]
    # A call that is due as spinOnce() is called came just too late on the real one.
    assert told[-1] == ("calls: 4" if row["run"] == "rate_spin_once" else row["what"])


STAMPED = "\x1b[0m[ INFO] [{}]: [SPINNER CPP NODE] {}\x1b[0m\n"


@pytest.mark.parametrize("name", ["spinner_cpp_node", "spinner_rate_cpp_node"])
def test_the_listings_of_the_tutorial(name: str) -> None:
    run = simulate(PACKAGE / f"{name}.cpp", 1.0, ["__ns:=/mrp"])
    first = 0 if "rate" in name else 1
    lines = [("0.000000000", "namespace of nh = /mrp/spinner_cpp_node")]
    lines += [(f"{half / 2:.9f}", f"counter = {half + 1 - first}") for half in range(first, 3)]
    assert run.console == "".join(STAMPED.format(*line) for line in lines)
    assert run.status == 0
    expected = [half / 2 for half in range(first, 3)]
    assert [(each.expected, each.real) for each in run.ticks] == [(time, time) for time in expected]
    assert {each.source for each in run.ticks} == {"Rate" if first == 0 else "timerCallback"}


@pytest.mark.parametrize(("place", "status"), [("", 134), ("main", 0)])
def test_a_global_timer_outlives_its_manager(write: Write, place: str, status: int) -> None:
    """As on the real one, whose manager of timers is made after it."""
    text = (PACKAGE / "spinner_cpp_node.cpp").read_text(encoding="utf-8")
    if not place:
        text = text.replace("  ros::Timer timer_for", "  timer_for", 1)
        text = text.replace('#include "ros/ros.h"', '#include "ros/ros.h"\nros::Timer timer_for_counting;', 1)
    run = simulate(write(text, "node.cpp"), 1.0)
    assert run.status == status
    said = "terminate called after throwing an instance of 'boost::wrapexcept<boost::lock_error>'\n"
    said += "  what():  boost: mutex lock failed in pthread_mutex_lock: Invalid argument\n"
    assert run.console.partition("counter = 2\x1b[0m\n")[2] == said * bool(status)


def test_python_hears_cpp_and_cpp_hears_python() -> None:
    run = simulate([str(PACKAGE / "publisher_cpp_node.cpp"), str(PACKAGE / "subscriber_py_node.py")], 2.0)
    assert "[SUBSCRIBER PY NODE] counter = 3" in run.console
    assert [(each.topic, each.node, each.message.data) for each in run.messages][:2] == [
        ("/counter", "/publisher_cpp_node", 1),
        ("/counter", "/publisher_cpp_node", 2),
    ]
    run = simulate([str(PACKAGE / "publisher_py_node.py"), str(PACKAGE / "subscriber_cpp_node.cpp")], 2.0)
    assert "[SUBSCRIBER CPP NODE] counter = 3" in run.console


TELLS_THE_TIME = """\
import rospy
from rosgraph_msgs.msg import Clock
rospy.set_param("/use_sim_time", True)
rospy.init_node("tells", disable_rostime=True)
publisher = rospy.Publisher("/clock", Clock, queue_size=10)
for second in range(100, 104):
    rospy.sleep(0.25)
    publisher.publish(rospy.Time(second))
rospy.spin()
"""


def test_clock_of_a_node_in_python(write: Write) -> None:
    """A second of it takes 0.25 s, which the ticks are told in."""
    run = simulate([str(write(TELLS_THE_TIME, "tells.py")), str(PACKAGE / "spinner_cpp_node.cpp")], 2.0)
    told = re.findall(r", (\d+)\..*counter = (\d)", run.console)
    assert told == [(str(100 + each // 2), str(each + 1)) for each in range(8)]
    assert [tick.real for tick in run.ticks] == [0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0]


TELLS = """\
#include "ros/ros.h"
#include "std_msgs/UInt32.h"
int main(int argc, char** argv)
{
  ros::init(argc, argv, "tells");
  ros::NodeHandle nh;
  auto tell = [](const char* what)
  {
    return [=](const ros::SingleSubscriberPublisher& to)
    {
      std::printf("%s %s at %.1f\\n", what, to.getSubscriberName().c_str(), ros::Time::now().toSec());
      std_msgs::UInt32 message;
      message.data = 7;
      to.publish(message);
    };
  };
  ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 1, tell("greets"), tell("misses"));
  ros::Timer timer = nh.createTimer(ros::Duration(1.5), [&](const ros::TimerEvent&)
      {
        std::printf("%u %d\\n", publisher.getNumSubscribers(), publisher.isLatched());
        ros::V_string nodes;
        ros::master::getNodes(nodes);
        for (const std::string& node : nodes)
          std::puts(node.c_str());
      }, true);
  ros::spin();
}
"""

HEARS_FOR_A_SECOND = """\
import rospy
from std_msgs.msg import UInt32
rospy.init_node("hears")
rospy.Subscriber("topic", UInt32, lambda message: print("heard", message.data))
rospy.sleep(1.0)
"""


def test_a_publisher_is_told_of_nodes_in_python(write: Write) -> None:
    """It greets whoever comes, and no other, and is told when it goes."""
    hears = str(write(HEARS_FOR_A_SECOND, "hears.py"))
    also = str(write(HEARS_FOR_A_SECOND.replace('"hears"', '"also"'), "also.py"))
    run = simulate([str(write(TELLS, "tells.cpp")), hears, also], 2.0)
    lines = [line for line in run.console.splitlines() if not line.startswith("[")]
    assert sorted(lines[:6]) == [
        *("greets /also at 0.0", "greets /hears at 0.0", "heard 7", "heard 7"),
        *("misses /also at 1.0", "misses /hears at 1.0"),
    ]
    assert lines[6:] == ["0 0", "/tells"]


SERVES = """\
#include "ros/ros.h"
#include "std_srvs/SetBool.h"
bool set(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response)
{
  response.message = request.data ? "on" : "off";
  return request.data;
}
int main(int argc, char** argv)
{
  ros::init(argc, argv, "serves");
  ros::NodeHandle nh;
  ros::ServiceServer server = nh.advertiseService("set", set);
  ros::spin();
}
"""

CALLS = """\
#include "ros/ros.h"
#include "std_srvs/SetBool.h"
int main(int argc, char** argv)
{
  ros::init(argc, argv, "calls");
  ros::NodeHandle nh;
  ros::ServiceClient client = nh.serviceClient<std_srvs::SetBool>("set");
  client.waitForExistence();
  std_srvs::SetBool service;
  for (bool value : {true, false})
  {
    service.request.data = value;
    bool ok = client.call(service);
    std::printf("%d %s\\n", ok, service.response.message.c_str());
  }
}
"""

SERVES_PY = """\
import rospy
from std_srvs.srv import SetBool

rospy.init_node("serves")
rospy.Service("set", SetBool, lambda request: (True, "on") if request.data else None)
rospy.spin()
"""

CALLS_PY = """\
import rospy
from std_srvs.srv import SetBool

rospy.init_node("calls")
rospy.wait_for_service("set")
call = rospy.ServiceProxy("set", SetBool)
print(call(True).message)
try:
    call(False)
except rospy.ServiceException as error:
    print(error)
"""


@pytest.mark.parametrize(
    ("serves", "calls", "said"),
    [
        (SERVES, CALLS, ["1 on", "0 on"]),
        (SERVES, CALLS_PY, ["on", "service [/set] responded with an error: b''"]),
        (SERVES_PY, CALLS, ["1 on", "0 on"]),
    ],
    ids=["cpp", "python_calls", "python_serves"],
)
def test_a_service_of_another_node(write: Write, serves: str, calls: str, said: list[str]) -> None:
    """As run on Debian's roscpp and rospy where C++ serves; where Python does, it was run here only."""
    files = [
        write(text, f"{name}.{'py' if 'rospy' in text else 'cpp'}")
        for name, text in (("serves", serves), ("calls", calls))
    ]
    lines = simulate(list(map(str, files)), 2.0).console.splitlines()
    assert [line for line in lines if "[ERROR]" not in line][:2] == said


def test_a_fault_delays_a_call(write: Write) -> None:
    pair = [str(write(SERVES, "serves.cpp")), str(write(CALLS, "calls.cpp"))]
    run = simulate(pair, 3.0, faults=[Service("/set", request_delay=0.5)])
    assert [(each.asked, each.answered) for each in run.calls] == [(0.003, 0.503), (0.506, 1.006)]


DEEP = "struct Deep { static int down(int n) { return n ? down(n + 1) + down(n + 2) : 0; } };"

# Where a program is told the place of its fault, and might write anything.
PLACE, NOWHERE = "rosspin_shared.fault", "(const RosspinPlace*)-9"


@pytest.mark.parametrize(
    ("body", "status", "said"),
    [
        ("int* none = nullptr; *none = argc;", 139, "node.cpp:4: it has used a null pointer\n"),
        ("return *std::shared_ptr<int>();", 139, "node.cpp:4: it has used a null pointer\n"),
        ("return std::vector<int>().front();", 139, "node.cpp:4: it has used a null pointer\n"),
        ("ros::Timer* none = nullptr;\n  none->stop();", 139, "node.cpp:5: it has used a null pointer\n"),
        ("auto& none = *std::unique_ptr<ros::Timer>();", 139, "node.cpp:4: it has used a null pointer\n"),
        ("void (*volatile none)() = nullptr;\n  none();", 139, "node.cpp: it has called a null pointer, or"),
        (f"{PLACE} = {NOWHERE};\n  __builtin_trap();", 139, "node.cpp: it has used a null pointer"),
        (
            f"{PLACE} = new RosspinPlace{{(char*)-9, 5}};\n  __builtin_trap();",
            139,
            "node.cpp: it has used a null pointer",
        ),
        (
            f"{DEEP} return Deep::down(argc);",
            139,
            "its stack has overflowed: a function may call itself without an end, in ",
        ),
        ("return 7 / (argc - 1);", 136, "node.cpp:4: it has divided by zero\n"),
        ("return 7 % (argc - 1);", 136, "node.cpp:4: it has divided by zero\n"),
        ("throw 5;", 134, "terminate called after throwing an instance of 'int'"),
        ("std::vector<int> few(1); few.at(argc);", 134, "instance of 'std::out_of_range'"),
        ("return 7;", 7, ""),
        ("std::exit(3);", 3, ""),
        ("struct Loud { ~Loud() { std::abort(); } } loud; std::exit(3);", 3, ""),
    ],
)
def test_how_a_node_may_end(write: Write, body: str, status: int, said: str) -> None:
    node = write(f'#include "ros/ros.h"\nint main(int argc, char** argv)\n{{\n  {body}\n}}\n', "node.cpp")
    run = simulate(node, 1.0)
    assert run.status == status
    assert said in run.console


def main(body: str) -> str:
    return f'#include "ros/ros.h"\n#include <csignal>\nint main(int argc, char** argv)\n{{\n{body}}}\n'


@pytest.mark.parametrize(("words", "name"), [([], r"/node_\d+"), (["__name:=given"], "/given")])
def test_a_name_that_is_given_is_not_made_anonymous(write: Write, words: list[str], name: str) -> None:
    body = """\
  ros::init(argc, argv, "node", ros::init_options::AnonymousName);
  std::puts(ros::this_node::getName().c_str());
"""
    assert re.fullmatch(f"{name}\n", simulate(write(main(body), "node.cpp"), 1.0, words).console)


def test_a_node_may_have_a_handler_of_its_own(write: Write) -> None:
    body = """\
  std::signal(SIGINT, [](int) { std::puts("own"); ros::shutdown(); });
  ros::init(argc, argv, "node", ros::init_options::NoSigintHandler);
  ros::NodeHandle nh;
  ros::spin();
"""
    run = simulate(write(main(body), "node.cpp"), 1.0)
    assert (run.console, run.status) == ("own\n", 0)


def test_ctrl_c_kills_a_node_without_a_handle(write: Write) -> None:
    """As run on Debian's roscpp: its handler is set by the first one (source: init.cpp, ``start``)."""
    body = """\
  ros::init(argc, argv, "node");
  ros::Time::init();
  while (ros::ok())
    ros::WallDuration(0.1).sleep();
  std::puts("left");
"""
    run = simulate(write(main(body), "node.cpp"), 1.0)
    assert (run.console, run.status) == ("", 128 + signal.SIGINT)


def test_a_node_ends_with_its_last_handle(write: Write) -> None:
    """As run on Debian's roscpp."""
    body = """\
  ros::init(argc, argv, "node");
  {
    ros::NodeHandle one;
    ros::NodeHandle other(one, "other");
    one = other;
    std::printf("%d %d\\n", ros::ok(), ros::isStarted());
  }
  std::printf("%d %d %d\\n", ros::ok(), ros::isStarted(), ros::isShuttingDown());
"""
    assert simulate(write(main(body), "node.cpp"), 1.0).console == "1 1\n0 0 1\n"


def test_a_throttled_line_comes_again_after_its_period(write: Write) -> None:
    """Exactly then, too (source: ros/console.h, ``ROSCONSOLE_THROTTLE_CHECK``)."""
    body = """\
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Timer timer = nh.createTimer(ros::Duration(0.5), [](const ros::TimerEvent&) { ROS_INFO_THROTTLE(0.5, "tick"); });
  ros::spin();
"""
    assert simulate(write(main(body), "node.cpp"), 2.2).console.count("tick") == 4


def test_what_is_printed_comes_before_what_is_logged_next(write: Write) -> None:
    body = """\
  ros::init(argc, argv, "node");
  ros::Time::init();
  std::printf("printed ");
  ROS_INFO("logged");
  std::printf("printed again\\n");
"""
    console = simulate(write(main(body), "node.cpp"), 1.0).console
    assert re.findall("printed again|printed|logged", console) == ["printed", "logged", "printed again"]


def test_what_is_thrown_again_lives_until_it_is_caught(write: Write) -> None:
    body = """\
  struct Loud : std::runtime_error
  {
    Loud() : std::runtime_error("thrown") {}
    ~Loud() { std::puts("gone"); }
  };
  try
  {
    try
    {
      throw Loud();
    }
    catch (const std::exception&)
    {
      std::puts("caught");
      throw;
    }
  }
  catch (const std::exception& error)
  {
    std::printf("%s again\\n", error.what());
  }
"""
    assert simulate(write(main(body), "node.cpp"), 1.0).console == "caught\nthrown again\ngone\n"


NAMED = """\
#include "ros/ros.h"
#include "std_msgs/UInt32.h"
struct Listener
{
  void hear(const std_msgs::UInt32::ConstPtr& message) { std::printf("member %u\\n", message->data); }
  void see(const std_msgs::UInt32ConstPtr& message) const { std::printf("constant %u\\n", message->data); }
};
void hear(const std_msgs::UInt32::ConstPtr& message) { std::printf("free %u\\n", message->data); }
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Listener listener;
  ros::Subscriber one = nh.subscribe<std_msgs::UInt32>("topic", 1, &Listener::hear, &listener);
  ros::Subscriber two = nh.subscribe<std_msgs::UInt32>("topic", 1, &Listener::see, &listener);
  ros::Subscriber three = nh.subscribe<std_msgs::UInt32>("topic", 1, hear);
  ros::Subscriber four = nh.subscribe("topic", 1, &Listener::hear, &listener);
  ros::Publisher publisher = nh.advertise<std_msgs::UInt32>("topic", 1);
  std_msgs::UInt32 message;
  message.data = 5;
  publisher.publish(message);
  ros::spin();
}
"""


def test_a_subscriber_may_name_its_message(write: Write) -> None:
    """As roscpp's overloads of NodeHandle::subscribe do (source: node_handle.h)."""
    console = simulate(write(NAMED, "node.cpp"), 1.0).console
    assert console.splitlines() == ["member 5", "constant 5", "free 5", "member 5"]


def test_a_process_that_has_run_a_node_runs_the_next_one() -> None:
    runs = []
    used = []
    for period in (0.5, 0.25, 0.5):
        runs.append(simulate(PROBE, 2.0, [f"_period:={period}"]))
        used.append(nodejs.IDLE[-1])
    child = used[0]
    assert used == [child] * 3
    child.kill()
    child.wait()
    runs.append(simulate(PROBE, 2.0, ["_period:=0.5"]))
    assert [len(run.ticks) for run in runs] == [4, 8, 4, 4]
    assert runs[0] == runs[2] == runs[3] and child not in nodejs.IDLE


@pytest.mark.parametrize("work", ["", "count = ros::Time::now().toSec();", "ros::WallDuration(0.0).sleep();"])
def test_a_loop_that_never_sleeps_passes_the_time(write: Write, work: str) -> None:
    """On a computer it keeps a core busy, and is told its messages nevertheless: here to look takes time."""
    text = NAMED.replace("ros::spin();", f"double count;\n  while (ros::ok()) {{ ros::spinOnce(); {work} }}")
    run = simulate(write(text, "node.cpp"), 2.0)
    assert run.console.splitlines() == ["member 5", "constant 5", "free 5", "member 5"]
    assert run.status == 0


def test_the_clock_is_read_until_a_time(write: Write) -> None:
    """A wait by looking ends late by a thousandth of its length at most, and by 1 ms."""
    body = """\
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  for (double length : {0.005, 0.5, 5.0})
  {
    ros::Time begun = ros::Time::now();
    while (ros::Time::now() < begun + ros::Duration(length)) {}
    std::printf("%.9f\\n", (ros::Time::now() - begun).toSec() / length - 1);
    ros::Duration(0.1).sleep();
  }
"""
    node = write(f'#include "ros/ros.h"\nint main(int argc, char** argv)\n{{\n{body}}}\n', "node.cpp")
    late = [float(line) for line in simulate(node, 8.0).console.splitlines()]
    assert len(late) == 3 and all(0 <= each <= 2e-3 for each in late)


GXX = """\
#include <bits/stdc++.h>
#include <ros/ros.h>
bool asked(uint number)
{
  std::printf("asked %u\\n", number);
}
int main(int argc, char** argv)
{
  double wide = argc;
  float narrow[] = {wide, 2 * wide};
  register int count = 3;
  asked(count);
  assert(narrow[1] > 0);
  std::printf("%.1f\\n", narrow[1]);
}
"""


def test_what_gxx_lets_pass_is_let_pass(write: Write) -> None:
    """It warns of what narrows, of a register and of a lacking return; the real headers bring assert.

    Run on Debian, built by catkin_make.
    """
    assert simulate(write(GXX, "node.cpp"), 1.0).console == "asked 3\n2.0\n"


SMALL = """\
#include <boost/thread.hpp>
#include <ros/package.h>
#include <ros/ros.h>
struct Filter : ros::console::FilterBase
{
  bool passes;
  explicit Filter(bool passes) : passes(passes) {}
  bool isEnabled() override { return passes; }
};
boost::mutex guard;
boost::recursive_mutex again;
int main(int argc, char** argv)
{
  ROSCONSOLE_AUTOINIT;
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  Filter yes(true), no(false);
  ROS_INFO_FILTER(&yes, "passes %d", 1);
  ROS_INFO_STREAM_FILTER(&no, "does " << "not");
  ROS_WARN_STREAM_FILTER_NAMED(&yes, "name", "passes " << 2);
  boost::mutex::scoped_lock lock(guard);
  boost::recursive_mutex::scoped_lock one(again), two(again);
  boost::this_thread::sleep(boost::posix_time::milliseconds(250));
  boost::this_thread::sleep_for(boost::chrono::seconds(1));
  ROS_INFO("slept");
}
"""


def test_filters_and_locks_of_boost(write: Write) -> None:
    """As run on Debian's roscpp and Boost 1.74."""
    said = re.sub("\x1b\\[\\d+m", "", simulate(write(SMALL, "node.cpp"), 2.0).console)
    assert said.splitlines() == [
        "[ INFO] [0.000000000]: passes 1",
        "[ WARN] [0.000000000]: passes 2",
        "[ INFO] [1.250000000]: slept",
    ]


TALKS = """\
#include "ros/ros.h"
#include "std_msgs/UInt32.h"
int main(int argc, char** argv)
{
  ros::init(argc, argv, "talks");
  ros::NodeHandle node;
  ros::Publisher publisher = node.advertise<std_msgs::UInt32>("counter", 10);
  ros::spin();
}
"""
HEARS = """\
#include "ros/ros.h"
#include "std_msgs/String.h"
void heard(const std_msgs::String& message) { ROS_INFO("heard"); }
int main(int argc, char** argv)
{
  ros::init(argc, argv, "hears");
  ros::NodeHandle node;
  ros::Subscriber subscriber = node.subscribe("counter", 10, heard);
  ros::spin();
}
"""
TALKS_PY = """\
import rospy
from std_msgs.msg import UInt32
rospy.init_node("talks")
publisher = rospy.Publisher("counter", UInt32, queue_size=10)
rospy.spin()
"""
HEARS_PY = """\
import rospy
from std_msgs.msg import String
rospy.init_node("hears")
rospy.Subscriber("counter", String, print)
rospy.spin()
"""
REFUSED = (
    "[ERROR] Client [/hears] wants topic /counter to have datatype/md5sum "
    "[std_msgs/String/992ce8a1687cec8c8bd883ec73ca41d1], but our version has "
    "[std_msgs/UInt32/304a39449588c7f8ce2df6e8001c5fce]. Dropping connection."
)
REFUSED_PY = (
    "[WARN] Could not process inbound connection: topic types do not match: [std_msgs/String] vs. [std_msgs/UInt32]"
    "{'callerid': '/hears', 'md5sum': '992ce8a1687cec8c8bd883ec73ca41d1', 'tcp_nodelay': '0', 'topic': '/counter', "
    "'type': 'std_msgs/String'}"
)
REFUSED_WITHIN = [
    "[ERROR] md5sum mismatch making local subscription to topic /counter.",
    "[ERROR] Subscriber expects type std_msgs/String, md5sum 992ce8a1687cec8c8bd883ec73ca41d1",
    "[ERROR] Publisher provides type std_msgs/UInt32, md5sum 304a39449588c7f8ce2df6e8001c5fce",
    "[ WARN] couldn't register subscriber on topic [/counter]",
]
HEARD = '#include "std_msgs/String.h"\nvoid heard(const std_msgs::String&) {}\n'
HEARS_ITSELF = TALKS.replace("int main", f"{HEARD}int main")
HEARS_ITSELF = HEARS_ITSELF.replace("  ros::spin", '  auto hears = node.subscribe("counter", 10, heard);\n  ros::spin')


@pytest.mark.parametrize(
    ("nodes", "said"),
    [
        ({"talks.cpp": TALKS, "hears.cpp": HEARS}, [REFUSED]),
        ({"talks.cpp": TALKS, "hears.py": HEARS_PY}, [REFUSED]),
        ({"talks.py": TALKS_PY, "hears.cpp": HEARS}, [REFUSED_PY]),
        ({"both.cpp": HEARS_ITSELF}, REFUSED_WITHIN),
    ],
)
def test_a_subscriber_of_another_type_is_refused(write: Write, nodes: dict[str, str], said: list[str]) -> None:
    """In the words of who publishes, as run on Debian's roscpp 1.15.15 and rospy 1.15.15."""
    console = simulate([str(write(text, name)) for name, text in nodes.items()], 1.0).console
    lines = re.sub(r"\x1b\[\d+m", "", console).splitlines()
    assert [re.sub(r" \[[\d.]+\]:", "", line) for line in lines if "killing on exit" not in line] == said


def test_a_loop_that_only_names_ros_ok_does_not_end(write: Write) -> None:
    text = (PACKAGE / "spinner_rate_cpp_node.cpp").read_text(encoding="utf-8")
    run = simulate(write(text.replace("ros::ok()", "ros::ok"), "node.cpp"), 1.0)
    assert run.status == 128 + signal.SIGKILL
    assert "Ctrl-C at 1 s did not end the node" in run.console
    assert "MainThread" not in run.console


LOOP = """\
#include "ros/ros.h"
#include <thread>
void hang(int seconds)
{
  ros::Duration(seconds).sleep();
  LOOP
}
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle node;
  CALL
}
"""


@pytest.mark.parametrize("call", ["hang(argc);", "std::thread(hang, argc).join();"])
@pytest.mark.parametrize("loop", ["for (volatile int i = 0;; i++) {}", "bool done = false;\n  while (!done) {}"])
def test_a_loop_without_an_end_ends_the_run(
    write: Write, monkeypatch: pytest.MonkeyPatch, loop: str, call: str
) -> None:
    """Even one that does nothing, which C++ lets a compiler leave out."""
    monkeypatch.setattr("rosspin.cpp.nodejs._ASKED", 0.5)
    node = write(LOOP.replace("LOOP", loop).replace("CALL", call), "node.cpp")
    said = (
        r"node\.cpp: simulated time stands still at 1\.0 s, because the .* running without sleeping, in hang\(int\)\."
    )
    with pytest.raises(TimeStandsStill, match=said):
        simulate(node, 2.0)


def test_a_loop_that_cannot_be_asked_where_it_is_ends_the_run(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosspin.cpp.nodejs._ENDED", 0.5)
    node = write(LOOP.replace("LOOP", "for (;;) {}").replace("CALL", "hang(argc);"), "node.cpp")
    with pytest.raises(TimeStandsStill, match=r"because the node keeps running without sleeping\."):
        simulate(node, 2.0)


IMPORTS = """\
#include "ros/ros.h"
extern "C" __attribute__((import_module("MODULE"), import_name("NAME"))) int imported(int);
int main()
{
  return imported(1);
}
"""


@pytest.mark.parametrize("module", ["rosspin", "hasOwnProperty", "__proto__"])
def test_a_program_imports_only_what_nodes_have(write: Write, module: str) -> None:
    """Each object of JavaScript has a constructor, by which functions are made: it is none of them."""
    text = IMPORTS.replace("MODULE", module).replace("NAME", "constructor")
    run = simulate(write(text, "node.cpp"), 1.0)
    assert f"it calls constructor of {module}, which there is not" in run.console


# Two mutexes, each held by a thread that asks for the other.
LOCKED = """\
#include <mutex>
#include <ros/ros.h>
#include <thread>
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  std::mutex one, two;
  auto lock = [](std::mutex& first, std::mutex& second)
  {
    std::lock_guard<std::mutex> holds(first);
    ros::Duration(0.5).sleep();
    std::puts("asks");
    second.lock();
    std::puts("has both");
  };
  std::thread other(lock, std::ref(one), std::ref(two));
  lock(two, one);
}
"""


RING = """\
rosspin: deadlock. This can never continue:
rosspin:   thread 1 waits for a lock that main holds
rosspin:   main waits for a lock that thread 1 holds
rosspin: Lock them in the same order everywhere.
"""


def test_threads_that_wait_for_each_other_are_told_so_and_killed_after_ctrl_c(write: Write) -> None:
    run = simulate(write(LOCKED, "node.cpp"), 1.0)
    assert run.status == 128 + signal.SIGKILL
    before, said, after = run.console.partition(RING)
    assert before == "asks\nasks\n" and said
    assert after.startswith("rosspin: Ctrl-C at 1 s did not end the node; it was killed 17 s later")


TWICE = """\
#include <mutex>
#include <ros/ros.h>
#include <thread>
int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  std::thread([] {}).join();
  std::MUTEX one;
  one.lock();
  one.lock();
  std::puts("has it twice");
}
"""


def test_a_thread_that_locks_a_mutex_twice_is_told_so(write: Write) -> None:
    console = simulate(write(TWICE.replace("MUTEX", "mutex"), "node.cpp"), 1.0).console
    assert "rosspin:   main waits for a lock that it holds\nrosspin: A std::mutex cannot be locked twice" in console
    assert simulate(write(TWICE.replace("MUTEX", "recursive_mutex"), "node.cpp"), 1.0).console == "has it twice\n"


def test_a_run_with_threads_is_the_same_each_time() -> None:
    runs = [simulate(FOLDER / "ros1_threads.cpp", SECONDS, words("async_spinner_of_two")) for _ in range(3)]
    assert len(runs[0].ticks) == 8
    assert runs[0] == runs[1] == runs[2]


@pytest.mark.parametrize(
    ("include", "body", "name"),
    [
        ('"tf/transform_listener.h"', "", "tf/transform_listener.h"),
        ("<ros/package.h>", 'ros::package::getPath("roscpp");', "ros::package::getPath"),
        ("<sched.h>", "cpu_set_t set;", "cpu_set_t"),
        ("<sched.h>", "sched_setscheduler(0, SCHED_FIFO, nullptr);", "SCHED_FIFO"),
        ("<sys/mman.h>", "mlockall(MCL_CURRENT);", "sys/mman.h"),
        ("<semaphore.h>", "sem_t one; sem_init(&one, 0, 1);", "sem_init"),
        ("<unistd.h>", "if (fork()) return 0;", "fork"),
    ],
)
def test_what_has_no_stand_in_is_named(write: Write, include: str, body: str, name: str) -> None:
    text = f'#include "ros/ros.h"\n#include {include}\nint main(int argc, char** argv)\n{{\n  {body}\n}}\n'
    with pytest.raises(NotSimulated) as raised:
        simulate(write(text, "node.cpp"), 1.0)
    assert str(raised.value) == f"{name} is not simulated; run this node on a real ROS"


def test_what_does_not_compile_is_said_in_the_compilers_words(write: Write) -> None:
    node: Path = write('#include "ros/ros.h"\nint main()\n{\n  ros::spinn();\n}\n', "node.cpp")
    with pytest.raises(ValueError, match=r"node\.cpp:4:8: error: no member named 'spinn' in namespace 'ros'"):
        simulate(node, 1.0)
