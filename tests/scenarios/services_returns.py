"""What a handler may return: a response, its values as a list, a tuple or a dict, or the only value alone."""

import rospy
from scenario import attempt, begin
from std_msgs.msg import Bool
from std_srvs.srv import Empty, EmptyResponse, SetBool, SetBoolRequest, SetBoolResponse, Trigger, TriggerResponse

VALUES = [
    SetBoolResponse(True, "whole"),
    SetBoolResponse(message="a part"),
    (True, "a tuple"),
    [False, "a list"],
    {"success": True, "message": "a dict"},
    {"message": "a part of a dict"},
    {},
    {"wrong": 1},
    {"success": "true", "message": "a text for a bool"},
    None,
    (),
    (True,),
    (True, "one", "too many"),
    (True, 5),
    (True, None),
    (2, "two is true"),
    True,
    False,
    "a text",
    5,
    Bool(True),
    SetBoolRequest(True),
    TriggerResponse(True, "of another service"),
    SetBoolResponse(True, 5),
    SetBoolResponse,
]

EMPTY = [EmptyResponse(), (), [], {}, None, True, (1,), {"wrong": 1}]

begin("services_returns")
for number, value in enumerate(VALUES):
    rospy.Service(f"~set{number}", SetBool, lambda request, value=value: value)
    attempt(f"proxy(True)  # {number}", {"proxy": rospy.ServiceProxy(f"~set{number}", SetBool)})
for number, value in enumerate(EMPTY):
    rospy.Service(f"~empty{number}", Empty, lambda request, value=value: value)
    attempt(f"proxy()  # {number}", {"proxy": rospy.ServiceProxy(f"~empty{number}", Empty)})
rospy.Service("~trigger", Trigger, lambda request: "only one of two")
attempt("proxy()", {"proxy": rospy.ServiceProxy("~trigger", Trigger)})
