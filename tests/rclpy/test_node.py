"""rclpy's nodes: names, parameters, the command line, the console, endings. Texts are as measured on Jazzy."""

from __future__ import annotations

import gc
import os
import re
import signal
import threading
import time
from collections.abc import Callable
from pathlib import Path
from textwrap import dedent
from typing import Any

import pytest

from rosspin import NotSimulated, Run, rclpy, simulate
from rosspin.clocks import ending as endings
from rosspin.clocks.simulation import Simulation
from rosspin.run.simulate import run_node
from rosspin.run.source import load
from tests.helpers.names_of_rclpy import IMPORTS, NAMES, names_of

Error = type[BaseException]


def run(body: Callable[[Any], object], *args: str, seconds: float = 10, name: str = "node") -> Run:
    """A node that does something and ends."""

    def node() -> None:
        rclpy.init()
        body(rclpy.create_node(name))
        rclpy.try_shutdown()

    return simulate(node, seconds, args)


def values(body: Callable[[Any], Any], *args: str, **kwargs: Any) -> Any:
    """What it found there."""
    found: list[Any] = []
    done = run(lambda node: found.append(body(node)), *args, **kwargs)
    assert (done.status, done.console) == (0, "")
    return found[0]


def text(console: str) -> str:
    """A console without its stamps."""
    return re.sub(r"^(\[\w+\]) \[\d+\.\d{9}\] ", r"\1 ", console, flags=re.M)


def refused(error: Error, message: str, body: Callable[[], Any]) -> None:
    with pytest.raises(error) as caught:
        body()
    assert str(caught.value) == message


# --- which ROS --------------------------------------------------------------------------------------------------------

PLAIN = "import rclpy\nrclpy.init()\nrclpy.create_node('n').get_logger().info('hello')\n"


def test_a_file_that_imports_rclpy_is_a_node_of_ros_2(write: Any) -> None:
    assert simulate(write(PLAIN), 1).console == "[INFO] [0.000000000] [n]: hello\n"


def test_so_is_one_whose_neighbour_does(write: Any) -> None:
    write(PLAIN, "neighbour.py")
    assert "hello" in simulate(write("import neighbour\n"), 1).console


def test_messages_are_those_of_its_ros(write: Any) -> None:
    source = "from std_msgs.msg import UInt32\nprint(UInt32(data=3))\nimport {}\n"
    assert simulate(write(source.format("rclpy")), 1).console == "std_msgs.msg.UInt32(data=3)\n"
    assert simulate(write(source.format("rospy")), 1).console == "data: 3\n"


def test_a_node_is_not_for_both(write: Any) -> None:
    run = simulate(write("import rospy, rclpy\n"), 1)
    said = "ImportError: this process has imported ROS 1: a process is one of ROS 1 (rospy) or of ROS 2 (rclpy)\n"
    assert run.status == 1 and run.console.endswith(said)


@pytest.mark.parametrize(
    ("source", "name"),
    [
        ("import cv_bridge", "cv_bridge"),
        ("from control_srvs.srv import Trigger", "control_srvs"),
        ("rclpy.init(); rclpy.create_node('n').add_waitable(1)", "Node.add_waitable"),
        (
            "from rclpy.impl.implementation_singleton import rclpy_implementation as c; c.WaitSet",
            "rclpy._rclpy_pybind11.WaitSet",
        ),
        ("from rclpy.experimental import EventsExecutor", "rclpy.experimental.EventsExecutor"),
    ],
)
def test_what_needs_a_real_ros_says_so(write: Any, source: str, name: str) -> None:
    with pytest.raises(NotSimulated, match=f"^{name} is not simulated; run this node on a real ROS"):
        simulate(write(f"import rclpy\n{source}\n"), 1)


@pytest.mark.parametrize("names", IMPORTS.with_suffix(".txt").read_text().splitlines(keepends=True))
def test_an_import_gives_the_package_the_names_that_it_gives_on_a_real_ros(names: str) -> None:
    assert simulate(IMPORTS, 1, [names.split()[0]]).console == names


def test_what_one_process_imports_is_not_there_in_another(write: Any) -> None:
    told = "print([hasattr(rclpy, name) for name in ('action', 'qos', 'executors')])\n"
    few = write(f"import rclpy, time\n{told}time.sleep(2)\n{told}", "few.py")
    many = write(f"import rclpy.action, time\n{told}time.sleep(2)\n{told}", "many.py")
    for _ in range(2):
        assert simulate(few, 3).console == "[False, False, False]\n" * 2
        assert simulate(many, 3).console == "[True, True, True]\n" * 2
    both = simulate([few, many], 3).console
    assert (both.count("[False, False, False]"), both.count("[True, True, True]")) == (2, 2)


@pytest.mark.parametrize(
    ("begins", "names"),
    [
        ("rclpy.create_node('n')", "[False, True, True]"),
        ("rclpy.get_global_executor()", "[False, False, True]"),
        ("import tf2_ros", "[True, True, True]"),
        ("import message_filters", "[False, True, True]"),
        ("import std_msgs.msg, tf_transformations", "[False, False, False]"),
    ],
)
def test_what_rclpy_imports_when_it_is_needed_is_there_from_then_on(write: Any, begins: str, names: str) -> None:
    asked = "print([hasattr(rclpy, name) for name in ('action', 'node', 'executors')])"
    run = simulate(write(f"import rclpy\nrclpy.init()\n{asked}\n{begins}\n{asked}\n"), 1)
    assert run.console.splitlines() == ["[False, False, False]", names]


def test_a_submodule_that_nobody_has_imported_is_not_there(write: Any) -> None:
    run = simulate(write("import rclpy\nprint(rclpy.__name__)\nrclpy.action.ActionClient\n"), 1)
    assert run.console.splitlines()[0] == "rclpy" and run.status == 1
    assert run.console.endswith("AttributeError: module 'rclpy' has no attribute 'action'\n")


@pytest.mark.parametrize("module", sorted(name for name, file in rclpy.MODULES.items() if file.__all__))
def test_what_it_has_can_be_imported_by_its_name(write: Any, module: str) -> None:
    names = [name for name in rclpy.MODULES[module].__all__ if not name.startswith("_")]
    assert names
    assert simulate(write(f"from {module} import {', '.join(names)}\n"), 1).status == 0


@pytest.mark.parametrize(
    ("check", "good", "other"),
    [
        ("node.create_publisher(KIND, 'a', 1)", "message", "service or action"),
        ("node.create_subscription(KIND, 'a', print, 1)", "message", "service or action"),
        ("node.create_client(KIND, 'a')", "service", "message or action"),
        ("check_is_valid_msg_type(KIND)", "message", "service or action"),
        ("check_is_valid_srv_type(KIND)", "service", "message or action"),
    ],
)
def test_what_is_no_message_or_no_service(write: Any, check: str, good: str, other: str) -> None:
    """As recorded with the real rclpy."""
    kinds = {"message": "String", "service": "SetBool", "action": "Fibonacci", "nothing": "int"}
    tries = "".join(
        f"try:\n    {check.replace('KIND', kind)}\nexcept Exception as error:\n    print(type(error).__name__, error)\n"
        for kind in kinds.values()
    )
    source = """
        import rclpy
        from example_interfaces.action import Fibonacci
        from rclpy.type_support import check_is_valid_msg_type, check_is_valid_srv_type
        from std_msgs.msg import String
        from std_srvs.srv import SetBool
        rclpy.init()
        node = rclpy.create_node("node")
    """
    *wrong, last = simulate(write(dedent(source) + tries), 1).console.splitlines()
    names = [name for kind, name in kinds.items() if kind not in (good, "nothing")]
    assert [line.partition(" (")[0] for line in wrong] == [f"RuntimeError The {good} type provided is not valid"] * 2
    assert all(f".{name}'>), this might be a {other}" in line for name, line in zip(names, wrong, strict=True))
    assert last.startswith("AttributeError type object 'type' has no attribute '_TYPE_SUPPORT' This might be a ROS 1")


# --- names ------------------------------------------------------------------------------------------------------------


def test_names_and_namespaces() -> None:
    def names(node: Any) -> list[str]:
        return [node.get_name(), node.get_namespace(), node.get_fully_qualified_name(), node.get_logger().name]

    assert values(names) == ["node", "/", "/node", "node"]
    ns = ("--ros-args", "-r", "__ns:=/mrp")
    assert values(names, *ns) == ["node", "/mrp", "/mrp/node", "mrp.node"]
    assert values(names, *ns, "-r", "__node:=other") == ["other", "/mrp", "/mrp/other", "mrp.other"]
    assert values(names, *ns, "--remap", "another:__node:=other")[0] == "node"


def test_topics_are_resolved_and_remapped() -> None:
    def topics(node: Any) -> list[str]:
        return [node.resolve_topic_name(topic) for topic in ("a", "/a", "~/a", "{node}/a", "b")]

    ns = ("--ros-args", "-r", "__ns:=/mrp")
    assert values(topics, *ns) == ["/mrp/a", "/a", "/mrp/node/a", "/mrp/node/a", "/mrp/b"]
    assert values(topics, *ns, "-r", "a:=c", "-r", "/a:=/d", "-r", "other:b:=e") == [
        *("/mrp/c", "/d", "/mrp/node/a", "/mrp/node/a", "/mrp/b")
    ]


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("", "node name must not be empty:\n  ''\n   ^"),
        ("a b", "node name must not contain characters other than alphanumerics or '_':\n  'a b'\n    ^"),
        ("1a", "node name must not start with a number:\n  '1a'\n   ^"),
    ],
)
def test_invalid_node_names(name: str, said: str) -> None:
    exceptions = rclpy.exceptions
    values(
        lambda _: refused(
            exceptions.InvalidNodeNameException, f"Invalid node name: {said}", lambda: rclpy.create_node(name)
        )
    )


@pytest.mark.parametrize(
    ("namespace", "said"),
    [
        ("/a/", "namespace must not end with a '/', unless only a '/':\n  '/a/'\n     ^"),
        ("//a", "namespace must not contain repeated '/':\n  '//a'\n    ^"),
        ("/1", "namespace must not have a token that starts with a number:\n  '/1'\n    ^"),
    ],
)
def test_invalid_namespaces(namespace: str, said: str) -> None:
    make = lambda: rclpy.create_node("n", namespace=namespace)  # noqa: E731
    values(lambda _: refused(rclpy.exceptions.InvalidNamespaceException, f"Invalid namespace: {said}", make))


@pytest.mark.parametrize(
    ("topic", "said"),
    [
        ("", "topic name must not be empty string:\n  ''\n   ^"),
        ("a/", "topic name must not end with a forward slash:\n  'a/'\n    ^"),
        ("a~b", "topic name must not have tilde '~' unless it is the first character:\n  'a~b'\n    ^"),
        ("{node", "topic name must not have unmatched (unbalanced) curly braces '{}':\n  '{node'\n   ^"),
        ("a//b", "topic name must not contain repeated '/':\n  '/a//b'\n      ^"),
    ],
)
def test_invalid_topic_names(topic: str, said: str) -> None:
    def body(node: Any) -> None:
        from std_msgs.msg import UInt32

        error = rclpy.exceptions.InvalidTopicNameException
        refused(error, f"Invalid topic name: {said}", lambda: node.create_publisher(UInt32, topic, 1))

    values(body)


def test_before_init_and_after_shutdown() -> None:
    def node() -> None:
        error = rclpy.exceptions.NotInitializedException
        refused(error, "rclpy.init() has not been called. msg:cannot create node", lambda: rclpy.create_node("n"))
        refused(RuntimeError, "Context must be initialized before it can be shutdown", rclpy.shutdown)
        assert not rclpy.ok()
        rclpy.init()
        refused(RuntimeError, "Context.init() must only be called once", rclpy.init)
        node = rclpy.create_node("n")
        rclpy.shutdown()
        rclpy.try_shutdown()
        refused(error, "rclpy.init() has not been called. msg:cannot create node", lambda: rclpy.create_node("n"))
        with pytest.raises(TypeError, match="^'NoneType' object does not support the context manager protocol"):
            rclpy.spin(node)  # Python 3.14 adds what is missing
        with pytest.raises(rclpy.exceptions.RCLError, match="the given context is not valid"):
            node.create_timer(1, print)
        rclpy.init()
        assert rclpy.create_node("n").get_name() == "n"

    assert simulate(node, 1).status == 0


# --- the command line -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("word", "value"),
    [
        *(("10", 10), ("0x10", 16), ("010", 8), ("-3", -3), ("1.5", 1.5), (".5", 0.5), ("1e3", 1000.0)),
        *((".inf", float("inf")), ("true", True), ("yes", True), ("off", False), ("text", "text"), ("'10'", "10")),
        *(
            ("1_000", "1_000"),
            ("2020-01-01", "2020-01-01"),
            ("null", "null"),
            ("[1, 2]", [1, 2]),
            ("[a, b]", ["a", "b"]),
        ),
        ("[]", None),
        *(("9223372036854775807", 2**63 - 1), ("9223372036854775808", 2.0**63), ("-9223372036854775809", -(2.0**63))),
    ],
)
def test_values_on_the_command_line(word: str, value: Any) -> None:
    overrides = values(lambda node: node._parameter_overrides, "--ros-args", "-p", f"x:={word}")
    found = overrides["x"].value
    assert (found, type(found)) == (value, type(value))


@pytest.mark.parametrize(
    ("words", "error", "message"),
    [
        (["-r", "bad"], "RCLError", "Couldn't parse remap rule: '-r bad'. Error: Expected lexeme type (19) not found"),
        (["-p", "x:=[1.0, 2]"], "RCLError", "Error: Sequence should be of same type"),
        (["-p", "x:={"], "RCLError", "Error: Unknown YAML event"),
        (["-r"], "RCLError", "Couldn't parse trailing -r flag. No remap rule found."),
        (["--log-level", "loud"], "RCLError", "Error: Argument does not use a valid severity level"),
        (["--params-file", "nonsuch"], "RCLError", "Error: Error opening YAML file"),
        (["--nonsense"], "UnknownROSArgsError", "['--nonsense']"),
    ],
)
def test_a_faulty_command_line(words: list[str], error: str, message: str) -> None:
    done = run(lambda node: None, "--ros-args", *words)
    assert done.status == 1
    assert f"rclpy._rclpy_pybind11.{error}: " in done.console
    assert message in done.console


def test_what_is_not_for_ros_is_left() -> None:
    rest = values(lambda _: rclpy.utilities.remove_ros_args(), "a", "--ros-args", "-p", "x:=1", "--", "--flag", "b")
    assert rest[1:] == ["a", "--flag", "b"]


def test_remappings_as_ros_1_writes_them() -> None:
    done = run(lambda node: node.get_logger().info("x"), "__ns:=/mrp")
    assert text(done.console) == (
        "[WARN] [rcl]: Found remap rule '__ns:=/mrp'. This syntax is deprecated. "
        "Use '--ros-args --remap __ns:=/mrp' instead.\n[INFO] [mrp.node]: x\n"
    )


def test_a_file_of_parameters(tmp_path: Path) -> None:
    file = tmp_path / "params.yaml"
    file.write_text(
        "node:\n  ros__parameters:\n    rate: 5\n    sub:\n      x: [1, 2]\n"
        "/**:\n  ros__parameters:\n    all: 'hi'\nother:\n  ros__parameters:\n    no: 1\n"
    )
    found = values(lambda node: node._parameter_overrides, "--ros-args", "--params-file", str(file), "-p", "rate:=7")
    assert {name: parameter.value for name, parameter in found.items()} == {"rate": 7, "sub.x": [1, 2], "all": "hi"}


ALIASES = "a: &a [1]\n" + "".join(f"{name}: &{name} [*a, *a]\n" for name in "bcd")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (
            ["--params-file", "FILE"],
            "Couldn't parse params file: '--params-file FILE'. Error: Will not support aliasing at line 2",
        ),
        (
            ["-p", "a:=[&x 1, *x]"],
            "Couldn't parse parameter override rule: '-p a:=[&x 1, *x]'. Error: Unknown YAML event",
        ),
        (["-p", "a:=*x"], "Couldn't parse parameter override rule: '-p a:=*x'. Error: Unknown YAML event"),
    ],
)
def test_rcl_takes_no_aliases(tmp_path: Path, words: list[str], says: str) -> None:
    """As the real one says it: rcl_yaml_param_parser/parse.c. So there are no bombs of them."""
    file = tmp_path / "params.yaml"
    file.write_text(ALIASES)
    done = run(lambda node: None, "--ros-args", *(word.replace("FILE", str(file)) for word in words))
    assert done.status == 1 and says.replace("FILE", str(file)) in done.console


# --- warnings ---------------------------------------------------------------------------------------------------------

WARNS = """import rclpy
from rclpy.executors import MultiThreadedExecutor
from rclpy.qos import QoSProfile
rclpy.init()
node = rclpy.create_node("node")
def declare():
    node.declare_parameter("y")
def set_parameters(names):
    node.set_parameters([rclpy.Parameter(name, value=1) for name in names])
def lazy(parameters):
    pass
def done(future):
    raise ValueError("x")
node.declare_parameter("x")
declare()
node.declare_parameters("", [("z",)])
node.add_on_set_parameters_callback(lazy)
set_parameters("x")
node.set_parameters_atomically([rclpy.Parameter("x", value=1)])
profile = QoSProfile(depth=0)
profile.depth = 0
MultiThreadedExecutor(1)
future = rclpy.Future()
future.add_done_callback(done)
future.set_result(1)
"""


def test_warnings_name_the_line_of_the_node(write: Any, recwarn: pytest.WarningsRecorder) -> None:
    path = write(WARNS)
    assert simulate(path, 1).status == 0
    assert {each.filename for each in recwarn} == {str(path)}
    assert [(each.lineno, str(each.message).partition(" ")[0]) for each in recwarn] == [
        # A text comes once, as all of its warnings come from one line of rclpy.
        *((14, "when"), (7, "when"), (16, "when"), (9, "Callback")),
        *((20, "A"), (22, "MultiThreadedExecutor"), (25, "Unhandled")),
    ]


# --- parameters -------------------------------------------------------------------------------------------------------


def test_parameters_have_the_type_with_which_they_are_declared() -> None:
    def body(node: Any) -> None:
        Parameter, exceptions = rclpy.parameter.Parameter, rclpy.exceptions
        assert node.declare_parameter("rate", 2.0).value == 4.5
        assert node.get_parameter("rate").type_ is Parameter.Type.DOUBLE
        refused(
            exceptions.InvalidParameterTypeException,
            "Trying to set parameter 'count' to '3' of type 'INTEGER', expecting type 'DOUBLE': count",
            lambda: node.declare_parameter("count", 1.0),
        )
        refused(
            exceptions.ParameterAlreadyDeclaredException,
            "Parameter(s) already declared: ['rate']",
            lambda: node.declare_parameter("rate", 2.0),
        )
        refused(
            exceptions.ParameterNotDeclaredException,
            "Invalid access to undeclared parameter(s): nope",
            lambda: node.get_parameter("nope"),
        )
        assert node.get_parameter_or("nope", Parameter("nope", value=9)).value == 9
        (result,) = node.set_parameters([Parameter("rate", value=3)])
        assert (result.successful, result.reason) == (
            False,
            "Wrong parameter type, expected 'Type.DOUBLE' got 'Type.INTEGER'",
        )
        (result,) = node.set_parameters([Parameter("rate", value=3.0)])
        assert result.successful
        assert node.get_parameter("rate").get_parameter_value().double_value == 3.0
        node.declare_parameter("typed", Parameter.Type.STRING)
        refused(
            exceptions.ParameterUninitializedException,
            "The parameter 'typed' is not initialized: typed",
            lambda: node.get_parameter("typed"),
        )
        refused(
            TypeError,
            "The given value is not a list of one of the allowed types '[1, 'a']'.",
            lambda: node.declare_parameter("y", [1, "a"]),
        )

    values(body, "--ros-args", "-p", "rate:=4.5", "-p", "count:=3")


def test_descriptors_limit_parameters() -> None:
    def body(node: Any) -> None:
        from rcl_interfaces.msg import IntegerRange, ParameterDescriptor

        Parameter = rclpy.parameter.Parameter
        span = IntegerRange(from_value=0, to_value=10, step=2)
        node.declare_parameter("even", 4, ParameterDescriptor(integer_range=[span]))
        node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
        node.declare_parameter("any", None, ParameterDescriptor(dynamic_typing=True))
        results = node.set_parameters([Parameter("even", value=value) for value in (6, 5, 12)])
        results += node.set_parameters([Parameter("fixed", value=2), Parameter("any", value="x")])
        assert [result.reason for result in results] == [
            "",
            "The parameter value for even is not a valid step. Min: 0, max: 10, value: 5, step: 2",
            "Parameter even out of range. Min: 0, Max: 10, value: 12",
            "Trying to set a read-only parameter: fixed.",
            "",
        ]
        assert node.describe_parameter("even").type == 2
        with pytest.raises(rclpy.exceptions.ParameterImmutableException):
            node.undeclare_parameter("fixed")

    values(body)


def test_callbacks_refuse_parameters() -> None:
    def body(node: Any) -> list[Any]:
        from rcl_interfaces.msg import SetParametersResult

        Parameter, set_to = rclpy.parameter.Parameter, []
        node.declare_parameter("rate", 1)
        node.add_on_set_parameters_callback(
            lambda parameters: SetParametersResult(successful=parameters[0].value != 13, reason="unlucky")
        )
        node.add_post_set_parameters_callback(lambda parameters: set_to.append(parameters[0].value))
        results = node.set_parameters([Parameter("rate", value=value) for value in (12, 13)])
        return [result.reason for result in results] + set_to + [node.get_parameter("rate").value]

    assert values(body) == ["", "unlucky", 12, 12]


# --- the console ------------------------------------------------------------------------------------------------------


def test_a_line_has_nanoseconds_and_the_loggers_name_and_goes_to_stderr() -> None:
    def body(node: Any) -> None:
        time.sleep(1.25)
        log = node.get_logger()
        log.debug("debug"), log.info("info"), log.warning("warning"), log.error("error"), log.fatal("fatal")
        node.get_logger().get_child("child").info("a\nb")

    assert run(body, "--ros-args", "-r", "__ns:=/mrp").console == (
        "[INFO] [1.250000000] [mrp.node]: info\n[WARN] [1.250000000] [mrp.node]: warning\n"
        "[ERROR] [1.250000000] [mrp.node]: error\n[FATAL] [1.250000000] [mrp.node]: fatal\n"
        "[INFO] [1.250000000] [mrp.node.child]: a\nb\n"
    )


FORM = "{message}|{name}|{severity}|{function_name}|{line_number}|{nonsuch}"


@pytest.mark.parametrize(
    ("environment", "out", "err"),
    [
        ({}, "", "[INFO] [0.000000000] [n]: hello\n"),
        ({"RCUTILS_LOGGING_USE_STDOUT": "1"}, "[INFO] [0.000000000] [n]: hello\n", ""),
        ({"RCUTILS_COLORIZED_OUTPUT": "1"}, "", "\033[0m[INFO] [0.000000000] [n]: hello\033[0m\n"),
        ({"RCUTILS_CONSOLE_OUTPUT_FORMAT": FORM}, "", "hello|n|INFO|<module>|3|{nonsuch}\n"),
    ],
)
def test_the_environment_says_what_a_line_is_like(
    environment: dict[str, str],
    out: str,
    err: str,
    write: Any,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """As on the real Jazzy."""
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    run_node(load(write(PLAIN)), 1, (), Simulation())
    assert capsys.readouterr() == (out, err)


def test_once_throttle_and_skip_first() -> None:
    def body(node: Any) -> None:
        log = node.get_logger().info
        for count in range(6):
            log(f"once {count}", once=True)
            log(f"skip {count}", skip_first=True)
            log(f"throttled {count}", throttle_duration_sec=0.9)
            time.sleep(0.5)

    assert re.findall(r": (\w+ \d)\n", run(body).console) == [
        *("once 0", "throttled 0", "skip 1", "skip 2", "throttled 2", "skip 3", "skip 4", "throttled 4", "skip 5"),
    ]


def test_levels_are_those_of_the_nearest_logger_above() -> None:
    def body(node: Any) -> list[bool]:
        logger, child = node.get_logger(), node.get_logger().get_child("child")
        found = [logger.debug("x"), child.debug("x")]
        logger.set_level(rclpy.logging.LoggingSeverity.WARN)
        return [*found, child.info("x"), rclpy.logging.get_logger("other").info("x")]

    done: list[Any] = []
    console = run(lambda node: done.append(body(node)), "--ros-args", "--log-level", "node.child:=debug").console
    assert done == [[False, True, True, True]]
    assert text(console) == "[DEBUG] [node.child]: x\n[INFO] [node.child]: x\n[INFO] [other]: x\n"


def test_what_a_logger_refuses() -> None:
    def body(node: Any) -> None:
        log = node.get_logger()
        options = "['throttle_duration_sec', 'throttle_time_source_type', 'skip_first', 'once']"
        message = f'parameter "foo" is not one of the recognized logging options "{options}"'
        refused(TypeError, message, lambda: log.info("x", foo=1))
        with pytest.raises(TypeError, match=r"rclpy_logging_rcutils_log\(\): incompatible function arguments"):
            log.info(5)
        for level, said in ((20, ""), (30, "Logger severity cannot be changed between calls.")):
            try:
                log.log("x", level)
            except ValueError as error:
                assert str(error) == said
        refused(ValueError, "7 is not a valid LoggingSeverity", lambda: log.log("x", 7))

    assert text(run(body).console) == "[INFO] [node]: x\n"


# --- endings ----------------------------------------------------------------------------------------------------------

SPIN = """
import rclpy, time
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
rclpy.init()
node = rclpy.create_node('node')
node.create_timer(0.5, lambda: {callback})
{spin}
"""


def ending(write: Any, spin: str = "rclpy.spin(node)", callback: str = "None", seconds: float = 1.2) -> Run:
    return simulate(write(SPIN.format(spin=spin, callback=callback)), seconds)


def last(done: Run) -> tuple[int, str]:
    return done.status, done.console.splitlines()[-1] if done.console else ""


CAUGHT = "try:\n    rclpy.spin(node)\nexcept (KeyboardInterrupt, ExternalShutdownException):\n    pass\n"
AT = "import os, signal, threading\nthreading.Timer(1, os.kill, (os.getpid(), signal.{})).start()\n"


def test_ctrl_c(write: Any) -> None:
    assert last(ending(write)) == (130, "KeyboardInterrupt")
    assert last(ending(write, CAUGHT)) == (0, "")
    assert last(ending(write, callback="time.sleep(0.9)")) == (130, "KeyboardInterrupt")
    assert "line 6, in <lambda>" in ending(write, callback="time.sleep(0.9)").console
    assert last(ending(write, "executor = MultiThreadedExecutor(2)\nrclpy.spin(node, executor)")) == (
        130,
        "KeyboardInterrupt",
    )


def test_sigterm(write: Any) -> None:
    term = AT.format("SIGTERM")
    assert last(ending(write, term + "rclpy.spin(node)")) == (1, "rclpy.executors.ExternalShutdownException")
    assert last(ending(write, term + CAUGHT)) == (0, "")
    # While a callback runs: it ends, and spin returns.
    assert last(ending(write, term + "rclpy.spin(node)\nprint(time.time())", "time.sleep(0.6)")) == (0, "1.1")
    multi = "rclpy.spin(node, MultiThreadedExecutor(2))\nprint(time.time())"
    assert last(ending(write, term + multi)) == (0, "1.0")


def test_after_ctrl_c_shutdown_fails_and_try_shutdown_does_not(write: Any) -> None:
    caught = "try:\n    rclpy.spin(node)\nexcept KeyboardInterrupt:\n    rclpy.{}()\n"
    assert last(ending(write, caught.format("shutdown"))) == (
        1,
        "rclpy._rclpy_pybind11.RCLError: failed to shutdown: rcl_shutdown already called on the given context",
    )
    assert last(ending(write, caught.format("try_shutdown"))) == (0, "")


def test_hooks_run_at_shutdown_and_not_at_ctrl_c(write: Any) -> None:
    hook = "node.context.on_shutdown(lambda: print('hook', rclpy.ok()))\n"
    assert last(ending(write, hook + "rclpy.shutdown()")) == (0, "hook False")
    assert last(ending(write, hook + CAUGHT + "rclpy.try_shutdown()")) == (0, "")


def test_shutdown_in_a_callback(write: Any) -> None:
    two = "node.create_timer(0.5, lambda: print('not called'))\n"
    assert last(ending(write, two + "rclpy.spin(node)\nprint(rclpy.ok())", "rclpy.shutdown()")) == (0, "False")


@pytest.mark.parametrize(
    ("callback", "status", "said"), [("1 / 0", 1, "ZeroDivisionError: division by zero"), ("exit(3)", 3, "")]
)
def test_an_exception_in_a_callback_ends_the_node(write: Any, callback: str, status: int, said: str) -> None:
    assert last(ending(write, callback=callback)) == (status, said)


def test_many_threads_notice_an_exception_when_the_next_call_is_handed_out() -> None:
    when = []

    def node() -> None:
        rclpy.init()
        node = rclpy.create_node("node")

        def raises() -> None:
            time.sleep(0.7)
            when.append(time.time())
            raise ZeroDivisionError

        node.create_timer(2.0, raises)
        try:
            rclpy.spin(node, rclpy.executors.MultiThreadedExecutor(2))
        except ZeroDivisionError:
            when.append(time.time())

    simulate(node, 10)
    assert when[:2] == [2.7, 4.0]


def test_a_thread_that_spins_meets_ctrl_c(write: Any) -> None:
    thread = "import threading\nthreading.Thread(target=rclpy.spin, args=(node,), daemon=True).start()\ntime.sleep(5)"
    done = ending(write, thread)
    assert done.status == 130
    assert re.findall(r"^(?:\w+\.)*\w+(?:Exception|Interrupt)$", done.console, re.M) == [
        "rclpy.executors.ExternalShutdownException",
        "KeyboardInterrupt",
    ]


# --- futures and coroutines -------------------------------------------------------------------------------------------


def test_coroutines_await_futures() -> None:
    order: list[tuple[Any, float]] = []

    def body(node: Any) -> None:
        Future, Group = rclpy.task.Future, rclpy.callback_groups.ReentrantCallbackGroup
        future, group = Future(), Group()

        async def callback() -> None:
            order.append(("begins", time.time()))
            order.append((await future, time.time()))
            timer.cancel()

        timer = node.create_timer(0.5, callback, group)
        node.create_timer(1.2, lambda: future.set_result("result"), group)
        rclpy.spin_until_future_complete(node, Future(), timeout_sec=2)
        order.append(("over", time.time()))

    run(body)
    assert order[:1] == [("begins", 0.5)]
    assert order[-1] == ("over", 2.0)
    assert ("result", 1.2) in order


def test_a_task_goes_before_an_older_one() -> None:
    order: list[str] = []

    def body(node: Any) -> None:
        executor = rclpy.executors.SingleThreadedExecutor()
        tasks = [executor.create_task(order.append, name) for name in "ab"]
        executor.spin_once()
        assert [task.done() for task in tasks] == [False, True]
        executor.spin_until_future_complete(tasks[0])
        assert tasks[0].result() is None

    assert run(body).status == 0
    assert order == ["b", "a"]


def test_futures() -> None:
    def body(node: Any) -> None:
        Future = rclpy.task.Future
        called: list[Any] = []
        future = Future()
        future.add_done_callback(called.append)
        future.set_result(5)
        future.add_done_callback(called.append)
        assert (called, future.result(), future.done()) == ([future, future], 5, True)
        cancelled = Future()
        cancelled.cancel()
        assert (cancelled.cancelled(), cancelled.done()) == (True, False)
        failed = Future()
        failed.set_exception(ValueError("x"))
        refused(ValueError, "x", failed.result)
        Future().set_exception(ValueError("lost"))

    assert run(body).console == "The following exception was never retrieved: lost\n"


def test_a_guard_condition_wakes_the_executor() -> None:
    def body(node: Any) -> None:
        guard = node.create_guard_condition(lambda: print("called", time.time()))
        threading.Timer(0.7, guard.trigger).start()
        rclpy.spin_once(node)

    assert run(body).console == "called 0.7\n"


def test_handlers_of_the_node_go_first_if_they_come_later() -> None:
    def body(node: Any) -> None:
        signal.signal(signal.SIGINT, lambda *_: print("own", rclpy.ok()))
        os.kill(os.getpid(), signal.SIGINT)

    assert run(body).console == "own True\n"


# --- a node's own names -----------------------------------------------------------------------------------------------


def test_what_rclpy_does_not_have_is_out_of_the_way_of_a_nodes_own_names() -> None:
    """A class of a node's may call its own methods and attributes as it likes, if it may on a real ROS."""
    real = names_of(NAMES.with_suffix(".txt").read_text())
    done = simulate(NAMES, 1)
    assert done.status == 0
    for kind, names in names_of(done.console).items():
        ours = {name for name in names - real[kind] if not name.startswith("_rosspin")}
        assert ours == set(), kind


@pytest.mark.parametrize(
    "call",
    [
        lambda node, kind: node.create_publisher("chatter", kind, 10),
        lambda node, kind: node.create_subscription("chatter", kind, print, 10),
        lambda node, kind: node.resolve_topic_name(kind),
    ],
)
def test_a_topic_that_is_no_text(call: Callable[[Any, Any], Any]) -> None:
    def body(node: Any) -> None:
        from std_msgs.msg import String

        with pytest.raises(TypeError) as caught:
            call(node, String)
        assert re.sub("0x[0-9a-f]+", "0x0", str(caught.value)) == (
            "rclpy_resolve_name(): incompatible function arguments. The following argument types are supported:\n"
            "    1. (arg0: rclpy::Node, arg1: str, arg2: bool, arg3: bool) -> str\n\n"
            "Invoked with: <rclpy._rclpy_pybind11.Node object at 0x0>, <class 'std_msgs.msg._string.String'>, "
            "False, False"
        )

    values(body)


@pytest.mark.parametrize(
    ("call", "lacks"),
    [
        (lambda node: node.create_timer(1, print), "_default_callback_group"),
        (lambda node: node.get_logger(), "_logger"),
        (lambda node: node.declare_parameter("x", 1), "_parameter_overrides"),
        (lambda node: node.nothing, "nothing"),
    ],
)
def test_a_node_that_forgets_its_base_s_init(call: Callable[[Any], Any], lacks: str) -> None:
    class Forgetful(rclpy.node.Node):
        def __init__(self) -> None:
            call(self)

    values(lambda _: refused(AttributeError, f"'Forgetful' object has no attribute '{lacks}'", Forgetful))


def test_nothing_is_counted_after_shutdown() -> None:
    def body(node: Any) -> None:
        rclpy.shutdown()
        for what in ("publishers", "subscribers"):
            count = getattr(node, f"count_{what}")
            message = f"Error in rcl_count_{what}: rcl node's context is invalid"
            refused(rclpy.exceptions.RCLError, message, lambda: count("x"))

    values(body)


def test_steps_count_from_the_lower_end_of_the_range() -> None:
    def body(node: Any) -> list[bool]:
        from rcl_interfaces.msg import IntegerRange, ParameterDescriptor

        span = IntegerRange(from_value=1, to_value=10, step=3)
        node.declare_parameter("third", 1, ParameterDescriptor(integer_range=[span]))
        values = [rclpy.parameter.Parameter("third", value=value) for value in (4, 7, 6, 10)]
        return [result.successful for result in node.set_parameters(values)]

    assert values(body) == [True, True, False, True]


def test_what_a_node_itself_is_given_goes_before_the_command_line() -> None:
    def body(_: Any) -> int:
        node = rclpy.create_node("other", cli_args=["--ros-args", "-p", "rate:=2"])
        rate: int = node.declare_parameter("rate", 1).value
        return rate

    assert values(body, "--ros-args", "-p", "rate:=3") == 2


def test_a_throttled_line_comes_again_after_just_its_period() -> None:
    def body(node: Any) -> None:
        for count in range(4):
            node.get_logger().info(f"line {count}", throttle_duration_sec=0.5)
            time.sleep(0.25)

    assert re.findall(r": line (\d)\n", run(body).console) == ["0", "2"]


def test_a_coroutine_that_a_run_has_left_is_not_heard_of_in_a_later_run(
    write: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Python may collect it at any time, also while code of the later run is being ended."""
    leaves = """
        import rclpy

        async def waits():
            try:
                await rclpy.task.Future()
            finally:
                len("tidied up")

        rclpy.init()
        node = rclpy.create_node("leaves")
        node.create_timer(0.5, waits)
        rclpy.spin(node)
    """
    ends = """
        import os, threading, time
        import rclpy

        def end():
            time.sleep(0.5)
            os._exit(0)

        rclpy.init()
        threading.Thread(target=end).start()
        time.sleep(9)
    """

    traced = endings._trace
    gc.collect()
    gc.disable()
    try:
        simulate(write(leaves, "leaves.py"), 1)
        monkeypatch.setattr(endings, "_trace", lambda: (traced(), gc.collect()))
        assert simulate(write(ends), 2).console == ""
    finally:
        gc.enable()


def test_a_destroyed_context_refuses_what_is_asked_by_keyword_too() -> None:
    def node() -> None:
        context = rclpy.context.Context()
        context.init()
        context.destroy()
        for ask in (lambda: context.on_shutdown(callback=print), context.ok):
            with pytest.raises(rclpy.exceptions.InvalidHandle):
                ask()
        print("asked")

    assert simulate(node, 1).console == "asked\n"
