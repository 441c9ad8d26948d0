"""The helpers of rospy's modules, compared with the real ones by random values, and what rospy's own tests ask of them.

rospy's unit tests that need no master are in ros_comm's ``test/test_rospy/test/unit``, genpy's in its ``test``. They
are in no package that can be installed, so each has a test here that is named after it and checks what it does. What
cannot be checked is on the page of rospy's names, with the reason.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import pytest

from rosspin import rospy, simulate
from rosspin.messages import genpy
from rosspin.rospy import client, core, names, rosgraph, rostime
from rosspin.rospy.validators import ParameterInvalid, non_empty
from tests.helpers.tree import HELPERS

PROBE = HELPERS / "names_probe.py"
COUNT = 300


def in_a_node(check: Callable[[], None], *args: str) -> None:
    """Run a check as a node that has not called init_node, with node args."""
    run = simulate(check, 10.0, args)
    assert run.status == 0, run.console


# --- test_rospy_names -------------------------------------------------------------------------------------------------


def test_any_type_is_a_star() -> None:
    """test_rospy_names: test_ANYTYPE"""
    assert names.TOPIC_ANYTYPE == names.SERVICE_ANYTYPE == "*"


@pytest.mark.parametrize(
    ("caller", "name", "scoped"),
    [
        ("/", "/a", "a"),
        ("/", "/x/a", "x/a"),
        ("/x", "/x/a", "x/a"),  # a node's name, not a namespace
        ("/x/node", "/x/a", "a"),
        ("/x/y/", "/x//a/", "a"),
    ],
)
def test_a_scoped_name_leaves_out_the_namespace(caller: str, name: str, scoped: str) -> None:
    """test_rospy_names: test_scoped_name"""
    assert names.scoped_name(caller, name) == scoped


@pytest.mark.parametrize("caller", ["node", "~node", ""])
def test_a_name_is_scoped_by_a_global_one_only(caller: str) -> None:
    """test_rospy_names: test_scoped_name"""
    with pytest.raises(rospy.ROSException, match="^caller_id must be global$"):
        names.scoped_name(caller, "/a")


def test_remappings_are_resolved_for_a_node() -> None:
    """test_rospy_names: test_mappings"""
    written = {"__name": "other", "a": "b", "/c": "d/e", "~f": "g"}

    def check() -> None:
        assert names.get_resolved_mappings() == {}
        assert names.get_mappings() == written
        names.initialize_mappings("/node")
        assert names.get_mappings() == written
        assert names.get_resolved_mappings() == {"__name": "other", "/a": "/b", "/c": "/d/e", "/node/f": "/g"}
        names.initialize_mappings("/x/node")
        assert names.get_resolved_mappings() == {"__name": "other", "/x/a": "/x/b", "/c": "/x/d/e", "/x/node/f": "/x/g"}
        names.reload_mappings(["h:=i"])
        assert names.get_mappings() == {"h": "i"}

    in_a_node(check, *(f"{source}:={target}" for source, target in written.items()), "_parameter:=1")


@pytest.mark.parametrize(
    ("name", "canonical"),
    [("", ""), ("/", "/"), ("//", "/"), ("a", "a"), ("/a/", "/a"), ("//a//b//", "/a/b"), ("a//b/", "a/b")],
)
def test_a_canonical_name_has_no_needless_slashes(name: str, canonical: str) -> None:
    """test_rospy_names: test_canonicalize_name"""
    assert rosgraph.canonicalize_name(name) == canonical


@pytest.mark.parametrize(
    ("name", "caller", "full"),
    [
        ("", "/", "/"),
        ("", None, "/"),
        ("", "/x/node", "/x/"),
        ("a", None, "/a"),
        ("a/", "", "/a"),
        ("a//b/", "/x/y/", "/x/a/b"),
        ("/a/", "/x/node", "/a"),
        ("~a", "/", "/a"),
        ("~a", None, "/unnamed/a"),
        ("~a/b/", "/x/node", "/x/node/a/b"),
        ("~/a", "/x/node", "/a"),
        ("~", "/node", "/node/"),
    ],
)
def test_a_name_is_resolved_for_a_node(name: str, caller: str | None, full: str) -> None:
    """test_rospy_names: test_resolve_name"""

    def check() -> None:
        assert names.resolve_name(name, caller) == rospy.resolve_name(name, caller) == full

    in_a_node(check)


def test_a_name_is_resolved_before_the_node_has_one() -> None:
    def check() -> None:
        assert names.resolve_name_without_node_name("a") == "/x/a"
        assert names.resolve_name_without_node_name("/x/b") == "/x/c"
        with pytest.raises(ValueError, match="^~name topics cannot be created before init_node"):
            names.resolve_name_without_node_name("~a")

    in_a_node(check, "__ns:=/x", "b:=c")


@pytest.mark.parametrize("wrong", [None, 1, True, "", "a:1", "http:", "a b", " "])
def test_a_valid_name_is_a_text_without_colon_and_space(wrong: Any) -> None:
    """test_rospy_names: test_valid_name; test_rospy_core: test_valid_name"""
    for resolve, full in ((True, "/node/a"), (False, "~a")):
        check = names.valid_name("parameter", resolve)
        assert check("~a", "/node") == full
        with pytest.raises(ParameterInvalid, match=r"^ERROR: parameter \[parameter\] (must be|contains)"):
            check(wrong, "/node")
    assert names.valid_name("parameter")("a", "/x/node") == "/x/a"


@pytest.mark.parametrize("wrong", [None, 1, "", "a", "~a"])
def test_a_global_name_begins_with_a_slash(wrong: Any) -> None:
    """test_rospy_names: test_global_name"""
    check = names.global_name("parameter")
    assert [check("/", "/node"), check("/a", "/node")] == ["/", "/a"]
    with pytest.raises(ParameterInvalid, match=r"\[parameter\] must be a"):
        check(wrong, "/node")


def test_a_node_can_be_given_a_name() -> None:
    """test_rospy_names: test_caller_id"""

    def check() -> None:
        assert (names.get_name(), names.get_caller_id(), names.get_namespace()) == ("/unnamed", "/unnamed", "/")
        for name, namespace in (("/a", "/"), ("/a/b", "/a/")):
            names._set_caller_id(name)
            assert (names.get_name(), names.get_caller_id(), names.get_namespace()) == (name, name, namespace)

    in_a_node(check)


# --- test_rospy_core, test_rospy_client, test_rospy_validators, test_rospy_exceptions ---------------------------------


@pytest.mark.parametrize("wrong", ["/", None, 1, "", "a:1", "a b"])
def test_a_topic_is_a_valid_name_below_the_global_namespace(wrong: Any) -> None:
    """test_rospy_core: test_is_topic"""
    check = core.is_topic("parameter")
    assert [check("a", "/x/node"), check("~a", "/x/node"), check("/a/b", "/x/node")] == ["/x/a", "/x/node/a", "/a/b"]
    with pytest.raises(ParameterInvalid):
        check(wrong, "/node")


def test_a_node_can_be_called_initialised() -> None:
    """test_rospy_core: test_initialized"""

    def check() -> None:
        assert not core.is_initialized()
        core.set_initialized(True)
        assert core.is_initialized()

    in_a_node(check)


@pytest.mark.parametrize(
    ("args", "parameters"),
    [
        ([], {}),
        (["a", "b:=c", "__name:=d"], {}),
        (["_a:=b", "word", "_c:=1", "_d:=[1, x]"], {"a": "b", "c": 1, "d": [1, "x"]}),
    ],
)
def test_private_parameters_on_the_command_line_are_yaml(args: list[str], parameters: dict[str, Any]) -> None:
    """test_rospy_client: test_load_command_line_node_params"""
    assert client.load_command_line_node_params(args) == parameters


def test_a_bad_private_parameter_is_an_error() -> None:
    """test_rospy_client: test_load_command_line_node_params"""
    with pytest.raises(rospy.ROSInitException, match="^invalid command-line parameters: "):
        client.load_command_line_node_params(["_a:=b:=c"])


def test_the_command_line_without_remappings() -> None:
    """test_rospy_client: test_myargv"""
    assert rospy.myargv(["node", "a:=b", "-c:=d", "_e:=f", "g"]) == ["node", "-c:=d", "g"]


@pytest.mark.parametrize(("name", "error"), [("a/b", ValueError), ("", ValueError), (None, ValueError)])
def test_a_node_needs_a_name_without_slashes(name: Any, error: type[Exception]) -> None:
    """test_rospy_client: test_init_node"""

    def check() -> None:
        with pytest.raises(error):
            rospy.init_node(name)
        with pytest.raises(rospy.ROSInitException):  # test_spin
            rospy.spin()

    in_a_node(check)


def test_a_parameter_that_must_not_be_empty() -> None:
    """test_rospy_validators: test_validators, test_ParameterInvalid"""
    assert non_empty("parameter")([1], "/node") == [1]
    wrongs: list[object] = ["", 0, []]
    for wrong in wrongs:
        with pytest.raises(ParameterInvalid, match=r"\[parameter\] must be specified and non-empty"):
            non_empty("parameter")(wrong, "/node")


def test_errors_are_kinds_of_each_other() -> None:
    """test_rospy_exceptions"""
    for error in (rospy.ROSInitException, rospy.ROSSerializationException, rospy.ROSInterruptException):
        assert issubclass(error, rospy.ROSException)
    for internal in (rospy.TransportException, rospy.TransportTerminated, rospy.TransportInitError):
        assert issubclass(internal, rospy.ROSInternalException)
    assert issubclass(rospy.ROSInterruptException, KeyboardInterrupt)
    moved = rospy.exceptions.ROSTimeMovedBackwardsException(1.5)
    assert isinstance(moved, rospy.ROSInterruptException)
    assert (str(moved), moved.time) == ("ROS time moved backwards", 1.5)


# --- test_rospy_rostime, test_genpy_rostime ---------------------------------------------------------------------------


def test_ros_time_can_be_set_and_waited_for() -> None:
    """test_rospy_rostime: test_set_rostime, test_get_rostime, test_switch_to_wallclock"""

    def check() -> None:
        rostime.set_rostime_initialized(True)
        assert rostime.is_rostime_initialized() and rostime.is_wallclock()
        condition = rostime.get_rostime_cond()
        rospy.Timer(rospy.Duration(1), lambda event: None)  # whose thread waits on the same condition
        for time in (genpy.Time(4, 5), rospy.Time(1)):
            rostime._set_rostime(time)
            assert not rostime.is_wallclock()
            assert rospy.get_rostime() == rospy.Time(time.secs, time.nsecs)
            assert rospy.get_time() == time.to_sec()
        with condition:
            condition.notify_all()
        with pytest.raises(ValueError, match="^must be Time instance: <class 'float'>$"):
            rostime._set_rostime(1.0)  # type: ignore[arg-type]
        rostime.switch_to_wallclock()
        assert rostime.is_wallclock() and rospy.get_time() == 0.0
        rospy.signal_shutdown("done")

    in_a_node(check)


class Other:
    """Something that is no time."""


def test_the_base_of_times_compares_with_its_kind() -> None:
    """test_genpy_rostime: test_TVal"""
    value = genpy.rostime.TVal(1, 10**9 + 1)
    assert (value.secs, value.nsecs, repr(value), str(value)) == (2, 1, "genpy.TVal[2000000001]", "2000000001")
    assert genpy.TVal(-2, 10**9) == genpy.TVal(-1) < genpy.TVal() <= genpy.TVal(0, 0) < value
    assert hash(genpy.TVal(1)) == hash(genpy.TVal(0, 10**9)) != hash(genpy.TVal(1, 1))
    assert value != Other() and not value == 2.000000001
    for compare in (value.__lt__, value.__le__, value.__gt__, value.__ge__):
        assert compare(Other()) is compare(0) is NotImplemented


def test_the_base_is_no_time_and_no_duration() -> None:
    assert genpy.TVal(1) != genpy.Time(1) and genpy.TVal(1) != genpy.Duration(1)
    assert genpy.TVal(1) < genpy.Time(2) and genpy.TVal(3) > genpy.Duration(2)


def test_a_float_of_seconds_gives_whole_fields() -> None:
    """test_genpy_rostime: test_Time, test_Duration; test_genpy_rostime_truediv"""
    for kind in (genpy.Time, genpy.Duration):
        value = kind(0.5)
        assert (type(value.secs), value.secs, value.nsecs) == (int, 0, 500_000_000)
        assert value == kind.from_sec(0.5)
        with pytest.raises(ValueError, match="nsecs cannot be set"):
            kind(0.5, 0.5)
    assert genpy.Duration(9) // 2 == genpy.Duration(4) == genpy.Duration(8) / 2.0
    assert genpy.Duration(8, 4) / 2 == genpy.Duration(4, 2)


def test_the_namespace_of_a_name() -> None:
    assert [rosgraph.namespace(name) for name in ("", "/", "/a", "/a/", "/a/b/")] == ["/", "/", "/", "/", "/a/"]
    for wrong, error in ((None, ValueError), (1, TypeError)):
        with pytest.raises(error):
            rosgraph.namespace(wrong)  # type: ignore[arg-type]


def test_a_name_that_the_master_does_not_take_is_told_and_connects_nothing() -> None:
    def node() -> None:
        from std_msgs.msg import String

        rospy.init_node("my node")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            publisher = rospy.Publisher("a:b", String, queue_size=1, latch=True)
            rospy.Subscriber("a:b", String, print)
        publisher.publish("lost")
        rospy.sleep(1)
        print(publisher.get_num_connections())

    with pytest.warns(UserWarning, match="not a legal ROS base name"):
        done = simulate(node, 3)
    why = "with master: ERROR: parameter [{}] contains illegal chars"
    assert [line.partition("unable to register ")[2] for line in done.console.splitlines()[:-1]] == [
        f"service [/my node/get_loggers] {why.format('service')}",
        f"service [/my node/set_logger_level] {why.format('service')}",
        f"publication [/a:b] {why.format('topic')}",
        f"subscription [/a:b] {why.format('topic')}",
    ]
    assert done.console.splitlines()[-1] == "0"
