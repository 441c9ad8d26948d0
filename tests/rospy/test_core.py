"""A node's log, names, parameters, and how it ends."""

from __future__ import annotations

import io
import os
import re
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

from rosspin import NotSimulated, rospy, simulate
from rosspin.clocks.simulation import Simulation
from rosspin.run.simulate import run_node
from rosspin.run.source import load

LEVELS = ["debug", "info", "warn", "err", "fatal"]


def console(node: Callable[[], Any], *args: str, seconds: float = 10, status: int = 0) -> str:
    """What a node prints; ``rospy.init_node("node")`` has been called for it."""

    def initialised() -> None:
        rospy.init_node("node")
        node()

    run = simulate(initialised, seconds, args)
    assert run.status == status, run.console
    return run.console


def raw(node: Callable[[], Any], *args: str, status: int = 0) -> str:
    """What a node prints that calls ``init_node`` itself."""
    run = simulate(node, 10, args)
    assert run.status == status, run.console
    return run.console


# --- log lines --------------------------------------------------------------------------------------------------------


def test_a_line_has_severity_and_six_digits_of_time_and_debug_is_hidden() -> None:
    def node() -> None:
        rospy.sleep(0.5)
        for level in LEVELS:
            getattr(rospy, f"log{level}")("%s %d", level, 7)

    assert console(node) == (
        "[INFO] [0.500000]: info 7\n[WARN] [0.500000]: warn 7\n[ERROR] [0.500000]: err 7\n[FATAL] [0.500000]: fatal 7\n"
    )


@pytest.mark.parametrize(
    ("level", "shown"),
    [
        (rospy.DEBUG, ["DEBUG", "INFO", "WARN", "ERROR", "FATAL"]),
        (rospy.WARN, ["WARN", "ERROR", "FATAL"]),
        (rospy.FATAL, ["FATAL"]),
    ],
)
def test_log_level(level: int, shown: list[str]) -> None:
    def node() -> None:
        rospy.init_node("node", log_level=level)
        for name in LEVELS:
            getattr(rospy, f"log{name}")("x")

    assert raw(node).splitlines() == [f"[{name}] [0.000000]: x" for name in shown]


def everything() -> None:
    rospy.init_node("node")
    for name in LEVELS:
        getattr(rospy, f"log{name}")(name)


def test_warnings_and_above_go_to_stderr(capsys: pytest.CaptureFixture[str]) -> None:
    run_node(load(everything), 1, (), Simulation())
    captured = capsys.readouterr()
    assert captured.out == "[INFO] [0.000000]: info\n"
    assert [line.split()[0] for line in captured.err.splitlines()] == ["[WARN]", "[ERROR]", "[FATAL]"]


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_colours_on_a_terminal_only(monkeypatch: pytest.MonkeyPatch) -> None:
    out, err = Terminal(), Terminal()
    monkeypatch.setattr(sys, "stdout", out)
    monkeypatch.setattr(sys, "stderr", err)
    run_node(load(everything), 1, (), Simulation())
    assert out.getvalue() == "[INFO] [0.000000]: info\n"
    assert err.getvalue() == (
        "\033[33m[WARN] [0.000000]: warn\n\033[0m"
        "\033[31m[ERROR] [0.000000]: err\n\033[0m"
        "\033[31m[FATAL] [0.000000]: fatal\n\033[0m"
    )


class Talker:
    def speak(self) -> None:
        rospy.loginfo("here")


THIS_LINE = Talker.speak.__code__.co_firstlineno + 1


@pytest.mark.parametrize(
    ("line_format", "line"),
    [
        ("${severity}: ${message}", "INFO: here"),
        ("${time}", "1.500000"),
        ("${walltime}", "1.500000"),
        ("${node}", "/mrp/node"),
        ("${function}", "Talker.speak"),
        ("${line}", str(THIS_LINE)),
        ("${file}", __file__),
        ("${logger}", "rosout"),
        pytest.param("${thread}", str(threading.get_ident()), id="thread"),
        pytest.param("${time:%M:%S}|${walltime:%S}", time.strftime("%M:01|01", time.localtime(1.5)), id="strftime"),
        ("${nonsense} ${message}", "${nonsense} here"),
        ("", ""),
    ],
)
def test_rosconsole_format(monkeypatch: pytest.MonkeyPatch, line_format: str, line: str) -> None:
    def node() -> None:
        rospy.sleep(1.5)
        Talker().speak()

    monkeypatch.setenv("ROSCONSOLE_FORMAT", line_format)
    assert console(node, "__ns:=/mrp") == line + "\n"


def test_fields_in_a_message_are_filled_in_as_on_a_real_ros() -> None:
    assert console(lambda: rospy.loginfo("I am ${node}")) == "[INFO] [0.000000]: I am /node\n"


def test_a_named_logger(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROSCONSOLE_FORMAT", "${logger}")
    assert console(lambda: rospy.loginfo("x", logger_name="arm")) == "rosout.arm\n"


def test_on_ros_time_a_line_has_both_times() -> None:
    def node() -> None:
        rospy.rostime._set_rostime(rospy.Time(100))
        rospy.rostime.wallsleep(2)
        rospy.loginfo("x")

    assert console(node) == "[INFO] [2.000000, 100.000000]: x\n"


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (("100%",), "100%"),
        (("%d%%", 7), "7%"),
        (("%(a)s", {"a": 1}), "1"),
        (({"a": 1},), "{'a': 1}"),
        ((None,), "None"),
        (("é ☃",), "é ☃"),
        (("two\nlines",), "two\nlines"),
    ],
)
def test_messages(arguments: tuple[Any, ...], text: str) -> None:
    assert console(lambda: rospy.loginfo(*arguments)) == f"[INFO] [0.000000]: {text}\n"


def test_a_message_that_does_not_fit_its_arguments_raises() -> None:
    def node() -> None:
        with pytest.raises(TypeError, match="not enough arguments for format string"):
            rospy.loginfo("%s and %s", 1)

    assert console(node) == ""


def test_a_message_with_the_exception() -> None:
    def node() -> None:
        try:
            raise LookupError("lost")
        except LookupError:
            rospy.logerr("oh", exc_info=True)

    text = console(node)
    assert text.startswith("[ERROR] [0.000000]: oh\nTraceback (most recent call last):\n")
    assert text.endswith("LookupError: lost\n")


def test_before_init_node_only_warnings_are_seen_and_plain() -> None:
    def node() -> None:
        rospy.loginfo("unseen")
        rospy.logwarn("seen %d", 1)

    assert raw(node) == "seen 1\n"


def test_throttle_and_once_are_kept_for_each_call_site() -> None:
    def node() -> None:
        for step in range(6):  # at 0.0, 0.5, ..., 2.5
            rospy.loginfo_throttle(1.0, "a%d", step)
            rospy.loginfo_throttle(1.0, "b%d", step)
            rospy.logwarn_once("once %d", step)
            rospy.loginfo_throttle(0, "c%d", step)  # no period: always
            rospy.sleep(0.5)

    # More than a period must have passed: 1.0 after 0.0 is not enough.
    lines = [line.partition("]: ")[2] for line in console(node).splitlines()]
    assert [line for line in lines if line[0] != "c"] == ["a0", "b0", "once 0", "a3", "b3"]
    assert [line for line in lines if line[0] == "c"] == [f"c{n}" for n in range(6)]


def test_throttle_identical_lets_a_changed_message_through() -> None:
    def node() -> None:
        for text in ["x", "x", "y", "y", "y", "y"]:
            rospy.loginfo_throttle_identical(1.2, text)
            rospy.sleep(0.5)
        with pytest.raises(AttributeError, match="'int' object has no attribute 'encode'"):
            rospy.loginfo_throttle_identical(1, 5)

    assert console(node) == "[INFO] [0.000000]: x\n[INFO] [1.000000]: y\n[INFO] [1.500000]: y\n"


@pytest.mark.parametrize("level", LEVELS)
def test_every_level_has_its_variants(level: str) -> None:
    def node() -> None:
        rospy.init_node("node", log_level=rospy.DEBUG)
        for _ in range(2):
            getattr(rospy, f"log{level}")("plain")
            getattr(rospy, f"log{level}_once")("once")
            getattr(rospy, f"log{level}_throttle")(1, "throttle")
            getattr(rospy, f"log{level}_throttle_identical")(1, "identical")

    severity = {"err": "ERROR"}.get(level, level.upper())
    texts = ["plain", "once", "throttle", "identical", "plain"]
    assert raw(node).splitlines() == [f"[{severity}] [0.000000]: {text}" for text in texts]


# --- init_node and names ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "text"), [("", "name must not be empty"), ("a/b", "namespaces are not allowed in node names")]
)
def test_names_that_init_node_refuses(name: str, text: str) -> None:
    def node() -> None:
        with pytest.raises(ValueError, match=f"^{text}$"):
            rospy.init_node(name)

    assert raw(node) == ""


def test_init_node_twice() -> None:
    def node() -> None:
        rospy.init_node("node")
        rospy.init_node("node")
        with pytest.raises(rospy.ROSException) as caught:
            rospy.init_node("other")
        expected = "rospy.init_node() has already been called with different arguments: ('node', ['node'], "
        assert str(caught.value) == expected + "False, None, False, False)"

    assert raw(node) == ""


def test_an_illegal_name_is_warned_of() -> None:
    with pytest.warns(UserWarning, match="'2fast' is not a legal ROS base name. This may cause problems"):
        raw(lambda: rospy.init_node("2fast"))


@pytest.mark.parametrize(
    ("args", "name", "namespace"),
    [
        ([], "/node", "/"),
        (["__ns:=/mrp"], "/mrp/node", "/mrp/"),
        (["__ns:=a/b"], "/a/b/node", "/a/b/"),
        (["__name:=other"], "/other", "/"),
        (["__name:=other", "__ns:=mrp/"], "/mrp/other", "/mrp/"),
    ],
)
def test_name_and_namespace(args: list[str], name: str, namespace: str) -> None:
    def node() -> None:
        assert (rospy.get_name(), rospy.get_caller_id(), rospy.get_namespace()) == (name, name, namespace)

    console(node, *args)


def test_ros_namespace_from_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_NAMESPACE", "env")
    assert console(lambda: print(rospy.get_name())) == "/env/node\n"
    assert console(lambda: print(rospy.get_name()), "__ns:=/arg") == "/arg/node\n"


def test_before_init_node_it_is_unnamed() -> None:
    assert raw(lambda: print(rospy.get_name(), rospy.get_namespace()), "__ns:=/mrp") == "/mrp/unnamed /mrp/\n"


def test_an_anonymous_name_is_unique_unless_it_is_given() -> None:
    def node() -> None:
        rospy.init_node("node", anonymous=True)
        print(rospy.get_name())

    assert re.fullmatch(rf"/node_{os.getpid()}_\d+\n", raw(node))
    assert raw(node, "__name:=me") == "/me\n"


@pytest.mark.parametrize(
    ("name", "resolved"),
    [
        ("", "/mrp/"),
        ("rate", "/mrp/rate"),
        ("a//b/", "/mrp/a/b"),
        ("/rate", "/rate"),
        ("~rate", "/mrp/node/rate"),
        ("~/rate", "/rate"),  # surprising, and so on a real ROS
        ("~", "/mrp/node/"),
        ("topic", "/mrp/other"),
        ("/mrp/topic", "/mrp/other"),
    ],
)
def test_resolve_name(name: str, resolved: str) -> None:
    assert console(lambda: print(rospy.resolve_name(name)), "__ns:=/mrp", "topic:=other") == resolved + "\n"


def test_remappings() -> None:
    def node() -> None:
        assert rospy.remap_name("topic") == "/other"
        assert rospy.remap_name("unmapped") == "unmapped"
        assert rospy.myargv(["node", "a:=b", "_c:=d", "__ns:=/e", "--flag", "2:=3"]) == ["node", "--flag", "2:=3"]
        assert rospy.myargv()[1:] == ["left"]

    assert console(node, "topic:=other", "left") == ""


# --- parameters -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arg", "value"),
    [
        ("_p:=10", 10),
        ("_p:=0.5", 0.5),
        ("_p:=true", True),
        ("_p:=text", "text"),
        ("_p:='10'", "10"),
        ("_p:=[1, 2]", [1, 2]),
        ("_p:={a: 1}", {"a": 1}),
    ],
)
def test_private_parameters_are_read_as_yaml(arg: str, value: Any) -> None:
    def node() -> None:
        assert rospy.get_param("~p") == value
        assert type(rospy.get_param("~p")) is type(value)

    console(node, arg)


def test_a_private_parameter_that_is_no_yaml() -> None:
    text = raw(lambda: rospy.init_node("node"), "_p:=[1,", status=1)
    assert "rospy.exceptions.ROSInitException: invalid command-line parameters: " in text


def test_parameters() -> None:
    def node() -> None:
        rospy.set_param("~list", (1, 2))
        assert rospy.get_param("~list") == [1, 2]
        rospy.get_param("~list").append(3)
        assert rospy.get_param("~list") == [1, 2]  # what is returned is a copy
        rospy.set_param("/robot", {"arm": {"length": 2.5}})
        assert rospy.get_param("robot/arm/length") == 2.5
        assert rospy.get_param("/robot") == {"arm": {"length": 2.5}}
        assert rospy.get_param("/missing", 7) == 7
        assert rospy.get_param_names() == ["/node/list", "/robot/arm/length"]
        assert rospy.search_param("list") == "/node/list"
        assert rospy.search_param("robot") == "/robot"
        assert rospy.search_param("missing") is None
        assert rospy.has_param("~list") and not rospy.has_param("~missing")
        rospy.delete_param("~list")
        assert not rospy.has_param("~list")

    assert console(node) == ""


@pytest.mark.parametrize(
    ("wrong", "error", "text"),
    [
        (lambda: rospy.get_param("~missing"), KeyError, "'~missing'"),
        (lambda: rospy.get_param_cached("~missing"), KeyError, "'~missing'"),
        (lambda: rospy.delete_param("~missing"), KeyError, "'~missing'"),
        (lambda: rospy.set_param("~p", None), TypeError, "cannot marshal None unless allow_none is enabled"),
        (lambda: rospy.set_param("~p", 2**40), OverflowError, "int exceeds XML-RPC limits"),
        (
            lambda: rospy.search_param("~p"),
            rospy.ROSException,
            "cannot search for parameter: Internal failure: invalid key",
        ),
    ],
)
def test_what_is_no_parameter(wrong: Callable[[], Any], error: type[Exception], text: str) -> None:
    def node() -> None:
        with pytest.raises(error) as caught:
            wrong()
        assert str(caught.value) == text

    assert console(node) == ""


def test_an_illegal_parameter_name_is_warned_of() -> None:
    with pytest.warns(UserWarning, match="'a b' is not a legal ROS graph resource name. This may cause problems"):
        console(lambda: rospy.set_param("a b", 1))


# --- the end ----------------------------------------------------------------------------------------------------------


def test_spin_waits_for_ctrl_c() -> None:
    def node() -> None:
        rospy.spin()
        print("over", rospy.is_shutdown())

    assert console(node, seconds=2) == "over True\n"


def test_spin_needs_init_node() -> None:
    text = raw(rospy.spin, status=1)
    assert text.endswith("rospy.exceptions.ROSInitException: client code must call rospy.init_node() first\n")


def test_a_loop_ends_after_the_sleep_in_which_ctrl_c_came() -> None:
    def node() -> None:
        while not rospy.is_shutdown():
            rospy.sleep(1)
        print("left at", rospy.get_time())

    assert console(node, seconds=2.5) == "left at 3.0\n"


def test_hooks_run_in_order_before_is_shutdown_is_true() -> None:
    def node() -> None:
        def last() -> None:
            print("last")

        rospy.on_shutdown(lambda: print("first", rospy.is_shutdown(), rospy.core.is_shutdown_requested()))
        rospy.on_shutdown(lambda: 1 / 0)
        rospy.on_shutdown(lambda: rospy.on_shutdown(last))  # still in time
        rospy.signal_shutdown("enough")
        rospy.signal_shutdown("once only")
        assert rospy.is_shutdown()
        rospy.on_shutdown(lambda: print("too late: at once"))

    lines = console(node).splitlines()
    assert lines[0] == "first False True"
    assert lines[1] == "Traceback (most recent call last):"
    assert lines[-3:] == ["ZeroDivisionError: division by zero", "last", "too late: at once"]


def test_hooks_run_when_the_node_just_ends() -> None:
    assert console(lambda: rospy.on_shutdown(lambda: print("bye"))) == "bye\n"


def test_a_hook_must_be_callable() -> None:
    def node() -> None:
        with pytest.raises(TypeError) as caught:
            rospy.on_shutdown(3)  # type: ignore[arg-type]
        assert str(caught.value) == "shutdown hook [3] must be a function or callable object: <class 'int'>"

    assert console(node) == ""


def test_signal_shutdown_from_a_timer_ends_spin() -> None:
    def node() -> None:
        rospy.Timer(rospy.Duration(0.7), lambda event: rospy.signal_shutdown("done"))
        rospy.spin()
        print("over at", rospy.get_time())

    assert console(node) == "over at 1.0\n"  # spin looks every 0.5 s


def test_without_signals_ctrl_c_is_python_s_own() -> None:
    def node() -> None:
        rospy.init_node("node", disable_signals=True)
        rospy.on_shutdown(lambda: print("hook"))
        try:
            rospy.sleep(100)
        except KeyboardInterrupt:
            print("interrupted at", rospy.get_time(), rospy.is_shutdown())

    assert raw(node) == "interrupted at 10.0 False\nhook\n"


# --- exceptions and names ---------------------------------------------------------------------------------------------


def test_exceptions_have_rospy_s_bases() -> None:
    bases = {
        "ROSException": (Exception,),
        "ROSInitException": (rospy.ROSException,),
        "ROSSerializationException": (rospy.ROSException,),
        "ROSInterruptException": (rospy.ROSException, KeyboardInterrupt),
        "ROSTimeMovedBackwardsException": (rospy.ROSInterruptException,),
        "ROSInternalException": (Exception,),
        "TransportException": (rospy.ROSInternalException,),
        "TransportInitError": (rospy.TransportException,),
        "TransportTerminated": (rospy.TransportException,),
    }
    assert {name: getattr(rospy, name).__bases__ for name in bases} == bases
    error = rospy.ROSTimeMovedBackwardsException(1.5)
    assert (str(error), error.time) == ("ROS time moved backwards", 1.5)


@pytest.mark.parametrize(
    "name",
    ["MasterProxy", "get_ros_root", "msproxy", "parse_rosrpc_uri"],
)
def test_what_needs_a_real_ros_says_so(name: str) -> None:
    with pytest.raises(NotSimulated) as caught:
        getattr(rospy, name)
    assert str(caught.value) == f"rospy.{name} is not simulated; run this node on a real ROS"


def test_what_rospy_has_not_either_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="^module 'rospy' has no attribute 'Timr'$"):
        rospy.Timr


def test_every_public_name_is_there() -> None:
    for name in rospy.__all__:
        assert getattr(rospy, name).__doc__ or isinstance(getattr(rospy, name), int)


def test_the_master_tells_of_the_nodes_of_all_processes_as_long_as_they_live() -> None:
    def short() -> None:
        from std_srvs.srv import Empty  # type: ignore[import-not-found]

        rospy.init_node("short")
        rospy.Publisher("chat", rospy.Header, queue_size=1)
        rospy.Service("serve", Empty, lambda request: ())
        rospy.sleep(1.0)

    def asks() -> None:
        from std_msgs.msg import Header

        rospy.init_node("asks")
        rospy.Subscriber("chat", Header)
        master = rospy.get_master()
        for _ in range(2):
            rospy.sleep(0.75)
            published, subscribed, services = master.getSystemState()[2]
            print(dict(published), dict(subscribed), [name for name, _ in services if "logger" not in name])
            print(master.lookupNode("short")[0], master.lookupService("serve")[::2], rospy.get_node_uri())

    lines = simulate([short, asks], 2.0).console.splitlines()
    assert [line for line in lines if line[0] in "{-1"] == [  # without what the supervisor says
        "{'/rosout': ['/short', '/asks'], '/chat': ['/short']} {'/chat': ['/asks']} ['/serve']",
        "1 [1, 'rosrpc://localhost:40001'] http://localhost:40002/",
        "{'/rosout': ['/asks']} {'/chat': ['/asks']} []",
        "-1 [-1, ''] http://localhost:40002/",
    ]
