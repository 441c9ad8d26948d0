"""Messages by their names, and filled from lists and dictionaries."""

import genpy
from genpy.message import fill_message_args, get_printable_message_args, get_service_class
from geometry_msgs.msg import PoseStamped, Twist
from roslib.message import get_message_class
from sensor_msgs.msg import JointState
from std_msgs.msg import ColorRGBA, Empty, Header, String
from trajectory_msgs.msg import JointTrajectory


def attempt(what, call):
    try:
        print(what, "->", call())
    except Exception as error:
        print(what, "->", type(error).__name__, error)


for name in ("std_msgs/String", "Header", "std_msgs/Nothing", "nothing_of_this/Kind", "String", "a/b/c", ""):
    attempt(name, lambda: get_message_class(name))
for name in ("std_srvs/SetBool", "std_srvs/Nothing", "std_msgs/String", "SetBool"):
    attempt(name, lambda: get_service_class(name))
print(get_message_class("std_msgs/String") is String)


def filled(kind, args, keys=None):
    message = kind()
    fill_message_args(message, args, keys or {})
    return str(message).replace("\n", " ; ")


now = {"now": genpy.Time(3, 4), "auto": Header(seq=7)}
for kind, args in [
    (String, ["text"]),
    (String, [{"data": "text"}]),
    (String, {"data": None}),
    (String, [5]),
    (String, []),
    (String, ["a", "b"]),
    (String, [{"date": "text"}]),
    (String, "text"),
    (String, 3),
    (Empty, None),
    (Empty, []),
    (Twist, [[1, 2, 3], {"z": 0.5}]),
    (Twist, [{"linear": {"x": 1.0}, "angular": [0, 0, 1]}]),
    (Twist, [{"linear": {"w": 1.0}}]),
    (Twist, [{"linear": 3}]),
    (Header, [1, 1500000000, "map"]),
    (Header, [1, [2, 3], "map"]),
    (Header, [1, {"secs": 2}, "map"]),
    (Header, [1, "now", "map"]),
    (Header, [1, "later", "map"]),
    (PoseStamped, [{"header": "auto"}]),
    (ColorRGBA, [1, 0, 0, 1]),
    (JointState, [{"name": ["a", "b"], "position": (1, 2)}]),
    (JointState, [{"name": "a"}]),
    (JointTrajectory, [{"points": [{"positions": [1.0], "time_from_start": 500000000}]}]),
    (JointTrajectory, [{"points": [[1.0]]}]),
]:
    attempt(f"{kind.__name__} {args}", lambda: filled(kind, args, now))
attempt("not a message", lambda: fill_message_args(3, []))
print(get_printable_message_args(PoseStamped()), "|", get_printable_message_args(Empty()))
print(genpy.Time(1).__slots__, genpy.Duration(1).__slots__)
