"""tf2_ros in nodes of ROS 2. What a buffer answers is judged in tests/tf2."""

from __future__ import annotations

import subprocess
import sys
from typing import Any

import pytest

from rosspin import rclpy, simulate, start
from rosspin.rclpy import tf2_ros as stand_in

HEAD = """
import rclpy
from rclpy.duration import Duration
from rclpy.time import Time
from geometry_msgs.msg import TransformStamped
from tf2_ros import Buffer, TransformException, TransformListener
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tf2_ros.transform_broadcaster import TransformBroadcaster

rclpy.init()
node = rclpy.create_node('node')

def transform(parent, child, x, stamp=None):
    made = TransformStamped(child_frame_id=child)
    made.header.frame_id = parent
    made.header.stamp = (stamp or node.get_clock().now()).to_msg()
    made.transform.translation.x = x
    return made

def seconds():
    return node.get_clock().now().nanoseconds / 1e9
"""
# Where base is: x is the time in seconds, told ten times a second.
MOVES = "mover = TransformBroadcaster(node)\n"
MOVES += "node.create_timer(0.1, lambda: mover.sendTransform(transform('map', 'base', seconds())))\n"
LISTENS = "buffer = Buffer()\nlistener = TransformListener(buffer, node{})\n"
SPINS = "try:\n    rclpy.spin(node)\nexcept KeyboardInterrupt:\n    pass\n"


def said(write: Any, *parts: str, seconds: float = 1.05) -> list[str]:
    """The lines that a node of these parts prints."""
    run = simulate(write(HEAD + "".join(parts)), seconds)
    assert run.status == 0, run.console
    return run.console.splitlines()


def test_a_listener_puts_into_its_buffer_what_broadcasters_send(write: Any) -> None:
    look = """
def look():
    found = buffer.lookup_transform('world', 'base', Time(seconds=0.35))
    print(found.header.frame_id, found.child_frame_id, found.header.stamp.nanosec, found.transform.translation.x)
StaticTransformBroadcaster(node).sendTransform([transform('world', 'map', 10.0)])
node.create_timer(0.75, look)
"""
    assert said(write, MOVES, LISTENS.format(""), look, SPINS) == ["world base 350000000 10.35"]


def test_what_cannot_be_looked_up_is_an_exception_of_tf2(write: Any) -> None:
    look = """
def look(target, source, time):
    try:
        buffer.lookup_transform(target, source, time)
    except TransformException as error:
        print(error)
def ask():
    look('map', 'nowhere', Time())
    look('map', 'base', node.get_clock().now())
    look('map', 'base', Time(seconds=0.05).to_msg())
node.create_timer(0.75, ask)
"""
    between = ", when looking up transform from frame [base] to frame [map]"
    assert said(write, MOVES, LISTENS.format(""), look, SPINS) == [
        '"nowhere" passed to lookupTransform argument source_frame does not exist. ',
        "Lookup would require extrapolation into the future.  Requested time 0.750000 "
        f"but the latest data is at time 0.700000{between}",
        "Lookup would require extrapolation into the past.  Requested time 0.050000 "
        f"but the earliest data is at time 0.100000{between}",
    ]


def test_tracebacks_name_the_exceptions_as_tf2_py_does(write: Any) -> None:
    run = simulate(write(f"{HEAD}Buffer().lookup_transform('a', 'b', Time())\n"), 1)
    last = 'tf2.LookupException: "a" passed to lookupTransform argument target_frame does not exist. '
    assert (run.status, run.console.splitlines()[-1]) == (1, last)


def test_a_lookup_with_a_timeout_looks_every_20_ms(write: Any) -> None:
    look = """
def ask():
    time.sleep(0.01)
    found = buffer.lookup_transform('map', 'base', Time(seconds=0.4), timeout=Duration(seconds=5))
    print(seconds(), found.transform.translation.x)
    print(buffer.can_transform('map', 'nowhere', Time(), Duration(seconds=0.05)), seconds())
    print(buffer.can_transform('map', 'nowhere', Time(), return_debug_tuple=True))
import threading, time
threading.Thread(target=ask).start()
"""
    assert said(write, MOVES, LISTENS.format(""), look, SPINS) == [
        "0.41 0.4",
        "0 0.47",
        "(0, 'Invalid frame ID \"nowhere\" passed to canTransform argument source_frame - frame does not exist')",
    ]


def test_a_lookup_with_a_timeout_in_a_callback_keeps_the_listener_from_hearing(write: Any) -> None:
    look = """
def ask():
    print(buffer.can_transform('map', 'base', node.get_clock().now(), Duration(seconds=0.2)), seconds())
    timer.cancel()
timer = node.create_timer(0.35, ask)
"""
    assert said(write, MOVES, LISTENS.format(""), look, SPINS) == ["0 0.55"]


def test_a_thread_of_the_listener_spins_the_node(write: Any) -> None:
    look = "import time\ntime.sleep(0.55)\nprint(buffer.lookup_transform('map', 'base', Time()).header.stamp.nanosec)\n"
    lines = said(write, MOVES, LISTENS.format(", spin_thread=True"), look, "rclpy.shutdown()\n")
    assert lines[:2] == ["500000000", "Exception in thread Thread-1 (run_func):"]
    assert lines[-1] == "rclpy.executors.ExternalShutdownException"


def test_a_coroutine_awaits_a_transform(write: Any) -> None:
    look = """
async def ask():
    timer.cancel()
    found = await buffer.lookup_transform_async('map', 'base', Time(seconds=0.45))
    print(round(found.transform.translation.x, 9), seconds())
    late = await buffer.lookup_transform_full_async('base', Time(seconds=0.6), 'base', Time(seconds=0.5), 'map')
    print(round(late.transform.translation.x, 9), seconds())
timer = node.create_timer(0.15, ask, callback_group=rclpy.callback_groups.ReentrantCallbackGroup())
"""
    assert said(write, MOVES, LISTENS.format(""), look, SPINS) == ["0.45 0.5", "-0.1 0.6"]


def test_static_transforms_reach_who_comes_late_and_each_child_keeps_its_first(write: Any) -> None:
    look = """
fixed = StaticTransformBroadcaster(node)
fixed.sendTransform(transform('map', 'door', 1.0))
fixed.sendTransform((transform('map', 'door', 2.0), transform('map', 'wall', 3.0)))
"""
    ask = """
def ask():
    found = [buffer.lookup_transform('map', child, Time(seconds=9)) for child in ('door', 'wall')]
    print([each.transform.translation.x for each in found])
    buffer.clear()
    print(buffer.can_transform('map', 'wall', Time()))
node.create_timer(0.75, ask)
"""
    assert said(write, look, LISTENS.format(""), ask, SPINS) == ["[1.0, 3.0]", "1"]


def test_a_buffer_forgets(write: Any) -> None:
    look = """
buffer = Buffer(cache_time=Duration(seconds=2))
for at in range(6):
    buffer.set_transform(transform('map', 'base', float(at), Time(seconds=at)), 'me')
print([buffer.can_transform('map', 'base', Time(seconds=at)) for at in range(1, 6)])
print(buffer.get_latest_common_time('map', 'base'))
buffer.clear()
print(buffer.can_transform('map', 'base', Time()))
buffer.set_transform(transform('map', 'map', 1.0), 'me')
"""
    assert said(write, look) == [
        "[0, 1, 1, 1, 1]",
        "Time(nanoseconds=5000000000, clock_type=SYSTEM_TIME)",
        "0",
        '[ERROR] [0.000000000] []: TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  '
        'child_frame_id "map" because they are the same',
    ]


def test_a_service_tells_what_a_buffer_knows(write: Any) -> None:
    ask = """
from tf2_msgs.srv import FrameGraph
buffer = Buffer(node=node)
buffer.set_transform_static(transform('map', 'door', 1.0), 'me')
asked = node.create_client(FrameGraph, 'tf2_frames').call_async(FrameGraph.Request())
rclpy.spin_until_future_complete(node, asked)
print(asked.result().frame_yaml.splitlines()[:3])
"""
    assert said(write, ask) == [repr(["door: ", "  parent: 'map'", "  broadcaster: 'me'"])]


def test_a_time_is_a_time_or_a_message(write: Any) -> None:
    ask = """
for time in (0, None, 1.5):
    try:
        Buffer().lookup_transform('a', 'a', time)
    except TypeError as error:
        print(error)
"""
    assert said(write, ask) == ["time must have sec and nanosec, or nanoseconds."] * 3


def test_a_test_hears_what_a_node_broadcasts(write: Any) -> None:
    with start(write(HEAD + MOVES + SPINS)) as node:
        node.advance(0.25)
        sent = [message.message.transforms[0] for message in node.messages("/tf")]
        assert [each.transform.translation.x for each in sent] == [0.1, 0.2]


def test_processes_have_buffers_of_their_own(write: Any) -> None:
    sends = write(HEAD + MOVES + SPINS, "sends.py")
    look = (
        "node.create_timer(0.95, lambda: print(buffer.lookup_transform('map', 'base', Time()).header.stamp.nanosec))\n"
    )
    hears = write(HEAD + LISTENS.format("") + look + SPINS, "hears.py")
    deaf = write(HEAD + "print(Buffer().all_frames_as_string() == '')\n", "deaf.py")
    console = simulate([sends, hears, deaf], 1.0).console.splitlines()
    assert sorted(line.rpartition(" ")[2] for line in console) == ["900000000", "True"]


# --- importing --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("module", sorted(stand_in.MODULES))
def test_it_can_be_imported_before_rclpy(write: Any, module: str) -> None:
    assert simulate(write(f"from {module} import Buffer\nimport {module}, rclpy\nrclpy.init()\n"), 1).status == 0


def test_all_its_names_can_be_imported(write: Any) -> None:
    node = write(
        "import rclpy, tf2_ros\nfrom tf2_ros import *\nprint(TransformListener is tf2_ros.buffer.TransformListener)"
    )
    assert simulate(node, 1).console == "True\n"


def test_it_passes_on_the_messages_that_many_nodes_import_from_it(write: Any) -> None:
    node = write(
        "import rclpy, geometry_msgs.msg, tf2_msgs.msg\nfrom tf2_ros import TFMessage, TransformStamped\n"
        "print(TransformStamped is geometry_msgs.msg.TransformStamped, TFMessage is tf2_msgs.msg.TFMessage)"
    )
    assert simulate(node, 1).console == "True True\n"


SERVES = """
import threading
from rclpy.action import ActionServer, GoalResponse
from tf2_msgs.action import LookupTransform
from tf2_ros import BufferClient

def serve(handle):
    asked, result = handle.request, LookupTransform.Result()
    result.transform = transform(asked.target_frame, asked.source_frame, asked.timeout.nanosec / 1e9)
    if asked.source_frame.isdigit():
        result.error.error = int(asked.source_frame)
        result.error.error_string = f'error {asked.source_frame}'
    handle.succeed()
    return result

def accept(goal):
    return GoalResponse.REJECT if goal.source_frame == 'no' else GoalResponse.ACCEPT

def attempt(call, *words):
    try:
        found = getattr(client, call)(*words)
        print(found if isinstance(found, bool) else (found.child_frame_id, found.transform.translation.x))
    except Exception as error:
        print(type(error).__name__, error)

client = BufferClient(node, 'tf2_buffer_server')
attempt('lookup_transform', 'map', 'base', Time())
server = ActionServer(node, LookupTransform, 'tf2_buffer_server', serve, goal_callback=accept)
"""


def test_a_client_asks_a_buffer_server(write: Any) -> None:
    asks = """
spins = threading.Thread(target=rclpy.spin, args=(node,))
spins.start()
attempt('lookup_transform', 'map', 'base', Time(), Duration(seconds=0.5))
attempt('lookup_transform', 'map', 'base', Time().to_msg())
attempt('lookup_transform', 'map', 'base', 3)
attempt('lookup_transform_full', 'map', Time(), 'base', Time(), 'odom')
for source in ('1', '2', '3', '4', '5', '6', 'no'):
    attempt('lookup_transform', 'map', source, Time())
attempt('can_transform', 'map', 'base', Time())
attempt('can_transform_full', 'map', Time(), '3', Time(), 'odom')
rclpy.shutdown()
"""
    errors = ("Lookup", "Connectivity", "Extrapolation", "InvalidArgument", "Timeout", "Transform")
    with pytest.warns(UserWarning, match=r"^Passing a builtin_interfaces\.msg\.Time argument is deprecated"):
        found = said(write, SERVES, asks)
    assert found == [
        "TimeoutException The BufferServer is not ready.",
        *("('base', 0.5)", "('base', 0.0)", "TypeError Must pass a rclpy.time.Time object.", "('base', 0.0)"),
        *(f"{name}Exception error {number}" for number, name in enumerate(errors, 1)),
        "TimeoutException The LookupTransform goal sent to the BufferServer did not come back with accepted status. "
        "Something is likely wrong with the server.",
        *("True", "False"),
    ]


def test_a_client_that_nobody_spins_gives_up(write: Any) -> None:
    asks = "attempt('lookup_transform', 'map', 'base', Time(), Duration(seconds=0.5))\nprint(seconds())\n"
    late, when = said(write, SERVES, asks, seconds=4.0)[1:]
    assert late == (
        "TimeoutException The LookupTransform goal sent to the BufferServer did not come back in the specified time. "
        "Something is likely wrong with the server."
    )
    assert float(when) == pytest.approx(2.6, abs=0.01)  # it looks ten times a second


def test_a_buffer_transforms_what_it_is_told_how_to(write: Any) -> None:
    ask = """
import tf2_ros
buffer = Buffer()
buffer.set_transform_static(transform('map', 'door', 1.0), 'me')
asked = tf2_ros.Stamped(transform('', '', 0.0), Time().to_msg(), 'door')
try:
    buffer.transform(asked, 'map')
except tf2_ros.TypeException as error:
    print(error)
tf2_ros.TransformRegistration().add(TransformStamped, lambda what, by: by.transform.translation.x)
print(buffer.transform(asked, 'map'), buffer.transform(asked, 'map', Duration(seconds=1)))
print(buffer.transform_full(asked, 'map', Time(), 'map'), tf2_ros.convert([1], list))
"""
    assert said(write, ask) == [
        "Type <class 'geometry_msgs.msg._transform_stamped.TransformStamped'> is not loaded or supported",
        "1.0 1.0",
        "1.0 [1]",
    ]


def test_messages_are_transformed_once_tf2_geometry_msgs_is_imported(write: Any) -> None:
    asks = """
from geometry_msgs.msg import Point, PointStamped
buffer = Buffer()
buffer.set_transform_static(transform('map', 'door', 3.0), 'me')
asked = PointStamped(point=Point(x=1.0))
asked.header.frame_id = 'door'
try:
    print(buffer.transform(asked, 'map').point.x)
except Exception as error:
    print(type(error).__name__, error.errstr)
"""
    known, unknown = "4.0", "TypeException Type <class 'geometry_msgs.msg._point_stamped.PointStamped'>"
    for _ in range(2):  # and no run knows what another has imported
        assert said(write, "import tf2_geometry_msgs", asks) == [known]
        assert said(write, asks) == [f"{unknown} is not loaded or supported"]


def test_nothing_of_it_is_left_after_a_run(write: Any) -> None:
    simulate(write("import rclpy, tf2_ros\ntf2_ros.Buffer = tf2_ros.BufferCore.clear = None\n"), 1)
    assert not any(name.startswith("tf2_") for name in sys.modules)
    assert simulate(write("import rclpy, tf2_ros\nrclpy.init()\ntf2_ros.Buffer().clear()\n"), 1).status == 0


def test_a_node_without_transforms_does_not_load_them() -> None:
    code = "import sys; from rosspin import rclpy; print([name for name in sys.modules if 'tf2' in name])"
    assert rclpy and subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "[]\n"
