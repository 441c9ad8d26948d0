"""Messages from their definitions: those that rosspin carries, and a package's own."""

from __future__ import annotations

import io
import math
import pickle
import subprocess
import sys
from array import array
from collections.abc import Callable, Iterator
from functools import partial
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from benchmarks import definitions
from rosspin.messages import DefinitionError, MessageFinder, ros1, ros2
from rosspin.messages.definitions import parse
from rosspin.messages.genpy import Duration, Time
from rosspin.messages.library import Library
from tests.helpers.own_packages import WHEEL, write_package
from tests.helpers.tree import ROOT

CARRIED = ROOT / "src" / "rosspin" / "messages"

Package = Callable[..., Path]


@pytest.fixture
def package(tmp_path: Path) -> Package:
    """Writes a package with messages into the workspace; the folder of its nodes."""
    return partial(write_package, tmp_path)


@pytest.fixture
def messages() -> ros1.Messages:
    """The classes of ROS 1."""
    return ros1.Messages(Library(1))


# --- what rosspin carries ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize("file", ["noetic.txt", "jazzy.txt"])
def test_the_definitions_are_those_of_the_pinned_library(file: str) -> None:
    written = definitions.text(file)
    assert (CARRIED / file).read_text(encoding="utf-8") == written, "run `make definitions`"


def test_the_md5_sums_are_the_real_ones(messages: ros1.Messages) -> None:
    assert messages["std_msgs/UInt32"]._md5sum == "304a39449588c7f8ce2df6e8001c5fce"
    assert messages["std_msgs/Header"]._md5sum == "2176decaecbce78abc3b96ef049fabed"
    assert messages["geometry_msgs/Twist"]._md5sum == "9f195f881246fdfa2798d1d3eebca84a"


def test_importing_no_message_needs_neither_numpy_nor_yaml() -> None:
    code = (
        "import sys; from rosspin.messages import MessageFinder\n"
        "with MessageFinder(1):\n  from sensor_msgs.msg import Imu; Imu()\n"
        "with MessageFinder(2):\n  from std_msgs.msg import Header; Header()\n"
        "print({'numpy', 'yaml', 'rosbags'} & set(sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "set()\n"


def test_numpy_is_there_before_the_first_message_that_needs_it() -> None:
    """On the wall clock a node would have to wait for it in the midst of its run: a goal's first id took 0.2 s."""
    code = (
        "import sys; from rosspin.messages import MessageFinder\n"
        "with MessageFinder(2):\n  from example_interfaces.action import Fibonacci\n"
        "print('numpy' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "True\n"


# --- ROS 1: what a node sees ------------------------------------------------------------------------------------------


def test_a_node_imports_messages_in_each_way() -> None:
    with MessageFinder(1) as finder:
        import std_msgs.msg
        from geometry_msgs.msg import Twist
        from std_msgs.msg import UInt32
        from std_msgs.msg._UInt32 import UInt32 as same

        names: dict[str, Any] = {}
        exec("from sensor_msgs.msg import *", names)
        assert UInt32 is std_msgs.msg.UInt32 is same is finder.messages["std_msgs/UInt32"]
        assert Twist().linear.x == 0.0
        assert names["Imu"]._has_header
        assert "Imu" in dir(sys.modules["sensor_msgs.msg"])
        with pytest.raises(ImportError, match="cannot import name 'UInt33' from 'std_msgs.msg'"):
            from std_msgs.msg import UInt33  # noqa: F401
        with pytest.raises(ModuleNotFoundError, match="No module named 'std_msgs.srv'"):
            import std_msgs.srv  # noqa: F401
    assert not [name for name in sys.modules if name.partition(".")[0] in ("std_msgs", "geometry_msgs")]


def test_what_was_imported_before_comes_back() -> None:
    with MessageFinder(1):
        import std_msgs.msg

        first = std_msgs.msg.UInt32
        with MessageFinder(2):
            import std_msgs.msg

            assert "data=0" in str(std_msgs.msg.UInt32())
        import std_msgs.msg

        assert std_msgs.msg.UInt32 is first


def test_a_message_has_the_attributes_of_a_generated_one(messages: ros1.Messages) -> None:
    status = messages["actionlib_msgs/GoalStatus"]
    assert status._type == "actionlib_msgs/GoalStatus"
    assert status.__slots__ == ["goal_id", "status", "text"]
    assert status._slot_types == ["actionlib_msgs/GoalID", "uint8", "string"]
    assert not status._has_header
    assert status.SUCCEEDED == 3  # type: ignore[attr-defined]
    assert str(status) == "<class 'actionlib_msgs.msg._GoalStatus.GoalStatus'>"
    assert status._full_text.split("\n")[-4:] == ["MSG: actionlib_msgs/GoalID", "time stamp", "string id", ""]
    assert isinstance(status().goal_id.stamp, Time)  # type: ignore[attr-defined]
    with MessageFinder(1) as finder:
        assert pickle.loads(pickle.dumps(finder.messages["std_msgs/UInt32"](7))).data == 7


def test_a_constructor_takes_all_fields_or_some_by_name(messages: ros1.Messages) -> None:
    point: Any = messages["geometry_msgs/Point"]
    assert point(1, 2, 3) == point(x=1, y=2, z=3)
    assert point(None, 2, None) == point(y=2)
    with pytest.raises(
        TypeError, match=r"Invalid number of arguments, args should be \['x', 'y', 'z'\] args are\(1, 2\)"
    ):
        point(1, 2)
    with pytest.raises(AttributeError, match="foo is not an attribute of Point"):
        point(foo=1)
    with pytest.raises(TypeError, match="Message constructor may only use args OR keywords, not both"):
        point(1, y=2)
    with pytest.raises(AttributeError, match="'Point' object has no attribute 'foo'"):
        point().foo = 1
    with pytest.raises(TypeError, match="unhashable type: 'Point'"):
        hash(point())


def test_what_is_sent_arrives_as_a_copy(messages: ros1.Messages) -> None:
    image: Any = messages["sensor_msgs/Image"]
    sent = image(data=[1, 2], encoding="ä")
    got = ros1.transfer(sent, image)
    assert got.data == b"\1\2" and got.encoding == "ä" and got is not sent and got.header is not sent.header
    array32: Any = messages["std_msgs/Float32MultiArray"]
    assert ros1.transfer(array32(data=[0.1]), array32).data == (0.10000000149011612,)


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("UInt32", -1, "field data must be unsigned integer type"),
        ("UInt32", 2**32, r"field data exceeds specified width \[uint32\]"),
        ("Int8", 1.0, "field data must be an integer type"),
        ("Float64", "1", "field data must be float type"),
        ("Bool", "x", "field data is not a bool"),
        ("String", 5, "field data must be of type bytes or an ascii string"),
        ("UInt8MultiArray", 5, r"field data must be a list or tuple type"),
        ("UInt8MultiArray", [256], r"field data\[\] exceeds specified width \[uint8\]"),
        ("Float32MultiArray", "ab", r"field data must be a list or tuple type. Only uint8\[\] can be a string"),
    ],
)
def test_a_wrong_value_is_an_error_in_sending(messages: ros1.Messages, name: str, value: Any, words: str) -> None:
    message = messages[f"std_msgs/{name}"](**{"data": value})
    with pytest.raises(ros1.SerializationError, match=f"^{words}$"):
        ros1.transfer(message, type(message))


def test_too_few_bytes_are_no_message(messages: ros1.Messages) -> None:
    with pytest.raises(ros1.DeserializationError, match="unpack requires a buffer of 4 bytes"):
        messages["std_msgs/UInt32"]().deserialize(b"\0")


# --- ROS 1: a package's own messages ----------------------------------------------------------------------------------


def test_a_package_has_messages_of_its_own(package: Package) -> None:
    package("parts", Wheel=WHEEL)
    folder = package(
        Robot="time built\nparts/Wheel[] wheels\nPose[2] poses\nuint8[] raw\n", Pose="float64 x\nbool from"
    )
    with MessageFinder(1, folder):
        from my_robotics_pkg.msg import Pose, Robot
        from parts.msg import Wheel

        assert (Wheel.MAX_SPEED, Wheel.NAME, Wheel.FIRST, Wheel.YES) == (1.5, "front # left", -1, True)
        assert Wheel._has_header and Wheel._slot_types == ["std_msgs/Header", "float32", "int16[3]", "duration"]
        assert Wheel._full_text.startswith(WHEEL + "\n" + "=" * 80 + "\nMSG: std_msgs/Header\n")
        assert Robot._slot_types == ["time", "parts/Wheel[]", "my_robotics_pkg/Pose[2]", "uint8[]"]
        assert Pose.__slots__ == ["x", "from_"]  # a word of Python's own
        robot = Robot(built=Time(1, 5), wheels=[Wheel(speed=0.5, since=Duration(-1))], raw=[7])
        got = ros1.transfer(robot, Robot)
        assert got.wheels[0].counts == (0, 0, 0) and got.wheels[0].since == Duration(-1) and got.raw == b"\7"
        assert str(got).startswith(
            "built: \n  secs: 1\n  nsecs:         5\nwheels: \n  - \n    header: \n      seq: 0\n"
        )
        assert str(got).endswith(
            "poses: \n  - \n    x: 0.0\n    from_: False\n  - \n    x: 0.0\n    from_: False\nraw: [7]"
        )


def test_a_package_keeps_its_python_modules(package: Package) -> None:
    folder = package(Speed="float64 data\n")
    code = folder.parent / "src" / "my_robotics_pkg"
    code.mkdir(parents=True)
    (code / "__init__.py").touch()
    (code / "helper.py").write_text("from my_robotics_pkg.msg import Speed\n")
    with MessageFinder(1, folder):
        from my_robotics_pkg.helper import Speed

        assert Speed(1.5).data == 1.5


@pytest.mark.parametrize(("ros", "source"), [(1, "src/tools"), (2, "tools")])
def test_a_node_imports_modules_of_other_packages(
    package: Package, ros: int, source: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The packages of its workspace, without messages; what is installed under such a name goes first."""
    folder = package()
    for name in ("tools", "yaml"):
        code = package(name).parent / source.replace("tools", name)
        code.mkdir(parents=True)
        (code / "__init__.py").touch()
        (code / "helper.py").write_text("answer = 42\n")
    monkeypatch.syspath_prepend(folder.parent.parent)  # where any folder would be a package, without what is in it
    with MessageFinder(ros, folder):
        assert import_module("tools.helper").answer == 42
        with pytest.raises(ModuleNotFoundError):
            import_module("yaml.helper")
    assert "tools" not in sys.modules and "yaml" in sys.modules


def test_a_file_without_a_package_has_none_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "msg").mkdir()
    (tmp_path / "msg" / "X.msg").write_text("int8 x\n")
    with MessageFinder(1, tmp_path), pytest.raises(ModuleNotFoundError):
        import my_robotics_pkg.msg  # noqa: F401


@pytest.mark.parametrize(
    ("ros", "text", "line", "words"),
    [
        (1, "uint32", 1, "expected a type, a space and a name, as in: uint32 counter"),
        (1, "# ok\nint8 a\nunit8 b", 3, "there is no message my_robotics_pkg/unit8; did you mean uint8?"),
        (1, "int8 a\nint16 a", 2, "the name a is there twice"),
        (1, "int8 A=200", 1, "200 is not a value of int8: -128 to 127"),
        (1, "int8 A=x", 1, "'x' is not a value of int8"),
        (1, "bool A=yes", 1, "'yes' is not a bool: True or False"),
        (1, "time A=1", 1, "a constant is a number, a bool or a string, not time"),
        (1, "string<=3 a", 1, "only ROS 2 has bounds (<=)"),
        (1, "int8[<=3] a", 1, "only ROS 2 has bounds (<=)"),
        (1, "float64 a 1.0", 1, "'1.0' is too much after the name"),
        (1, "a/b/c d", 1, "a type is written package/Name, not a/b/c"),
        (1, "X x", 1, "my_robotics_pkg/X holds itself"),
        (2, "time a", 1, "ROS 2 has no type time: write builtin_interfaces/Time"),
        (2, "Header header", 1, "in ROS 2 a header is written std_msgs/Header"),
        (2, "int8 maxSpeed", 1, "ROS 2 wants fields in lower case, as in max_speed, not maxSpeed"),
        (2, "int8 max=1", 1, "ROS 2 wants constants in upper case, as in MAX_SPEED, not max"),
        (2, "int8<=3 a", 1, "only a string or an array has a bound, not int8"),
        (2, "int8[2] a [1]", 1, "1 values are not right for int8[2]"),
        (2, "int8[] a 1", 1, "an array's default is written as in [1, 2], not 1"),
    ],
)
def test_a_faulty_definition_says_where_and_what(package: Package, ros: int, text: str, line: int, words: str) -> None:
    folder = package(X=text)
    with MessageFinder(ros, folder), pytest.raises(DefinitionError) as caught:
        from my_robotics_pkg.msg import X  # noqa: F401
    error = caught.value
    assert (error.filename, error.lineno, error.msg) == (str(folder.parent / "msg" / "X.msg"), line, words)
    assert error.text == text.split("\n")[line - 1]


# --- ROS 2 ------------------------------------------------------------------------------------------------------------


@pytest.fixture
def two() -> Iterator[Any]:
    """The classes of ROS 2."""
    with MessageFinder(2) as finder:
        yield finder.messages


def test_ros2_messages_take_keywords_and_print_in_one_line(two: Any) -> None:
    number = two["std_msgs/UInt32"]
    assert str(number(data=5)) == "std_msgs.msg.UInt32(data=5)"
    assert str(number) == "<class 'std_msgs.msg._u_int32.UInt32'>"
    assert number.get_fields_and_field_types() == {"data": "uint32"}
    assert str(two["std_msgs/Int8MultiArray"](data=[1, 2]).data) == "array('b', [1, 2])"
    assert two["geometry_msgs/Quaternion"]().w == two["geometry_msgs/Quaternion"].W__DEFAULT == 1.0
    assert two["diagnostic_msgs/DiagnosticStatus"].ERROR == b"\2"
    with pytest.raises(TypeError, match=r"^UInt32.__init__\(\) takes 1 positional argument but 2 were given$"):
        number(3)


@pytest.mark.parametrize(
    ("name", "field", "value", "words"),
    [
        ("std_msgs/UInt32", "data", "a", "The 'data' field must be of type 'int'"),
        ("std_msgs/UInt32", "data", 2**32, "The 'data' field must be an unsigned integer in [0, 4294967295]"),
        ("std_msgs/Float64", "data", 1, "The 'data' field must be of type 'float'"),
        ("geometry_msgs/Twist", "linear", 1, "The 'linear' field must be a sub message of type 'Vector3'"),
        (
            "rcl_interfaces/ParameterDescriptor",
            "integer_range",
            [1],
            "The 'integer_range' field must be a set or sequence with length <= 1"
            " and each value of type 'IntegerRange'",
        ),
    ],
)
def test_ros2_fields_are_checked_when_they_are_set(two: Any, name: str, field: str, value: Any, words: str) -> None:
    message = two[name]()
    for do in (lambda: setattr(message, field, value), lambda: two[name](**{field: value})):
        with pytest.raises(AssertionError) as caught:
            do()
        assert str(caught.value) == words
    with pytest.raises(AssertionError, match="^Invalid arguments passed to constructor: foo$"):
        two[name](foo=1)


def test_ros2_messages_arrive_as_copies(two: Any) -> None:
    point, path = two["geometry_msgs/Point32"], two["nav_msgs/Path"]
    assert ros2.transfer(point(x=0.1), point).x == 0.10000000149011612
    assert ros2.transfer(point(x=-math.inf), point).x == -math.inf
    sent = path(poses=[two["geometry_msgs/PoseStamped"]()])
    got = ros2.transfer(sent, path)
    assert got == sent and got.poses is not sent.poses and got.poses[0] is not sent.poses[0]
    sent.poses.append(3)
    with pytest.raises(AssertionError, match="The 'poses' field must be a set or sequence and each value of type"):
        ros2.transfer(sent, path)


def test_ros2_does_without_numpy(two: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ros2, "_numpy", lambda: None)
    pose = two["geometry_msgs/PoseWithCovariance"]
    message = pose(covariance=[1.0] * 36)
    assert message.covariance == array("d", [1.0] * 36) and ros2.transfer(message, pose) == message != pose()
    with pytest.raises(AssertionError, match="with length 36 and each value of type 'float'"):
        message.covariance = [1.0]


def test_ros2_definitions_have_defaults_and_bounds(package: Package) -> None:
    folder = package(
        X='uint8[<=3] few [1, 2]\nstring<=5 name "a, b"\nfloat64[2] pair [1, 2.5]\nstring[] words ["a, b", c]\n'
        "bool on true  # a comment\nstring GREETING='it\\'s'\nbyte B=0x10\nY y\n",
        Y="builtin_interfaces/Time stamp\n",
    )
    with MessageFinder(2, folder):
        from my_robotics_pkg.msg import X

        x = X()
        assert (x.few.tolist(), x.name, list(x.pair), x.words, x.on) == (
            [1, 2],
            "a, b",
            [1.0, 2.5],
            ["a, b", "c"],
            True,
        )
        assert (X.GREETING, X.B, x.y.stamp.sec) == ("it's", b"\x10", 0)
        assert X.get_fields_and_field_types() == {
            "few": "sequence<uint8, 3>",
            "name": "string<5>",
            "pair": "double[2]",
            "words": "sequence<string>",
            "on": "boolean",
            "y": "my_robotics_pkg/Y",
        }
        with pytest.raises(AssertionError, match="The 'name' field must be string value not longer than 5"):
            x.name = "longer"
        assert X().words is not x.words


def test_a_line_of_a_carried_definition_is_read_as_written() -> None:
    definition = parse("float64[36] covariance\n", "a/B", "B.msg", 1)
    assert str(definition.fields[0].kind) == "float64[36]"
    buffer = io.BytesIO()
    ros1.Messages(Library(1))["std_msgs/String"]("hi").serialize(buffer)
    assert buffer.getvalue() == b"\2\0\0\0hi"


# --- services and actions ---------------------------------------------------------------------------------------------

ADD = "int64 a\nint64 b\n---\nint64 sum  # of both\n"
COUNT = "uint32 LIMIT=10\nuint32 goal\n---\nuint32[] reached\n---\nuint32 at 1\n"
CARRIED_PACKAGES = (
    *("std_srvs", "nav_msgs", "turtlesim", "example_interfaces", "action_msgs", "nav2_msgs", "test_msgs"),
    *("action_tutorials_interfaces", "control_msgs", "tf2_msgs"),
)


@pytest.mark.parametrize("ros", [1, 2])
def test_every_carried_service_and_action_can_be_made(ros: int) -> None:
    kind = ros1.Messages if ros == 1 else ros2.Messages
    library = Library(ros)
    messages: Any = kind(library)
    found = [
        messages.whole(folder, f"{package}/{name}").__module__
        for folder in ("srv", "action")[:ros]
        for package in CARRIED_PACKAGES
        for name in library.names(package, folder)
    ]
    assert len(found) > (10 if ros == 1 else 30)
    assert ("std_srvs.srv._SetBool" if ros == 1 else "std_srvs.srv._set_bool") in found


def test_a_node_of_ros1_imports_services() -> None:
    with MessageFinder(1):
        from std_srvs.srv import SetBool, SetBoolRequest, SetBoolResponse  # type: ignore[import-not-found]
        from std_srvs.srv._SetBool import SetBool as Same  # type: ignore[import-not-found]

        assert Same is SetBool
        assert (SetBool._request_class, SetBool._response_class) == (SetBoolRequest, SetBoolResponse)
        assert (SetBool._type, SetBool._md5sum) == ("std_srvs/SetBool", "09fb03525b03e7ea1fd3992bafd87e16")
        assert (SetBoolRequest._type, SetBoolRequest.__module__) == ("std_srvs/SetBoolRequest", "std_srvs.srv._SetBool")
        assert repr(SetBoolResponse(True, "on")) == 'success: True\nmessage: "on"'
        with pytest.raises(ImportError):
            from std_srvs.srv import Fly  # noqa: F401
        with pytest.raises(ImportError):
            import std_srvs.msg  # type: ignore[import-not-found] # noqa: F401


def test_a_node_of_ros2_imports_services_and_actions() -> None:
    with MessageFinder(2):
        from example_interfaces.action import Fibonacci  # type: ignore[import-not-found]
        from std_srvs.srv import SetBool, SetBool_Request

        assert SetBool.Request is SetBool_Request
        assert repr(SetBool.Request(data=True)) == "std_srvs.srv.SetBool_Request(data=True)"
        assert SetBool.Event().request == []
        assert Fibonacci.Feedback(sequence=[1]).sequence.tolist() == [1]
        impl = Fibonacci.Impl
        assert impl.SendGoalService.Request().goal == Fibonacci.Goal(order=0)
        assert impl.FeedbackMessage().feedback == Fibonacci.Feedback()
        for kind in (SetBool, Fibonacci):
            with pytest.raises(NotImplementedError):
                kind()


def test_a_package_has_services_and_actions_of_its_own(package: Package) -> None:
    folder = package(kind="srv", AddTwoInts=ADD)
    with MessageFinder(1, folder) as finder:
        from my_robotics_pkg.srv import AddTwoInts

        assert AddTwoInts._request_class(1, 2).b == 2
        assert finder.messages["my_robotics_pkg/AddTwoIntsResponse"] is AddTwoInts._response_class
    package(kind="action", Count=COUNT)
    with MessageFinder(2, folder):
        from my_robotics_pkg.action import Count
        from my_robotics_pkg.srv import AddTwoInts as Two

        assert Two.Response(sum=3).sum == 3
        assert (Count.Goal.LIMIT, Count.Feedback().at) == (10, 1)


def test_an_action_of_ros1_is_seven_messages(package: Package) -> None:
    folder = package(kind="action", Count="uint32 LIMIT=10\nuint32 goal\n---\nuint32[] reached\n---\nuint32 at\n")
    with MessageFinder(1, folder):
        from actionlib_tutorials.msg import FibonacciAction
        from move_base_msgs.msg import MoveBaseAction
        from my_robotics_pkg import msg
        from my_robotics_pkg.msg import CountAction

        parts = "Action ActionFeedback ActionGoal ActionResult Feedback Goal Result"
        assert msg.__all__ == [f"Count{each}" for each in parts.split()]
        assert (CountAction().action_goal.goal.LIMIT, CountAction().action_feedback.feedback.at) == (10, 0)
        assert CountAction.__module__ == "my_robotics_pkg.msg._CountAction"
        # as genpy has them
        assert FibonacciAction._md5sum == "f59df5767bf7634684781c92598b2406"
        assert MoveBaseAction._md5sum == "70b6aca7c7f7746d8d1609ad94c80bb8"
        with pytest.raises(ImportError):
            import my_robotics_pkg.action  # noqa: F401


def test_a_faulty_action_of_ros1_says_where(package: Package) -> None:
    folder = package(kind="action", Count="uint32 goal\n---\nhuge reached\n---\n")
    with MessageFinder(1, folder), pytest.raises(DefinitionError, match="there is no message") as caught:
        from my_robotics_pkg.msg import CountResult  # noqa: F401
    assert caught.value.lineno == 3


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("int64 a\n", 2, "a line --- is missing between request and response"),
        ("int64 a\n---\nint64 b\n---\n", 4, "one line --- too many, after 2 parts"),
        ("int64 a\n---\nint64 b\n\nhuge c\n", 5, "there is no message my_robotics_pkg/huge"),
        ("int64 a\n---\nint64 2b\n", 3, "expected a type, a space and a name"),
    ],
)
def test_a_faulty_service_says_where_and_what(package: Package, text: str, line: int, words: str) -> None:
    folder = package(kind="srv", Faulty=text)
    with MessageFinder(2, folder), pytest.raises(DefinitionError, match=words) as caught:
        from my_robotics_pkg.srv import Faulty  # noqa: F401
    assert caught.value.lineno == line
    assert str(caught.value.filename).endswith("Faulty.srv")
