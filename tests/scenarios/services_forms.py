"""A proxy takes a request, its values in order, or by keyword; other arguments are errors in the caller."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import Empty, SetBool, SetBoolRequest, Trigger, TriggerRequest

begin("services_forms")
rospy.Service("~set", SetBool, lambda request: (request.data, f"{request.data}"))
rospy.Service("~empty", Empty, lambda request: ())
rospy.Service("~trigger", Trigger, lambda request: (True, "pulled"))
names = {
    **{"SetBoolRequest": SetBoolRequest, "TriggerRequest": TriggerRequest},
    **{"set": rospy.ServiceProxy("~set", SetBool), "empty": rospy.ServiceProxy("~empty", Empty)},
    "trigger": rospy.ServiceProxy("~trigger", Trigger),
}
for text in (
    "set(SetBoolRequest(True))",
    "set(SetBoolRequest(data=False))",
    "set(True)",
    "set(data=True)",
    "set.call(True)",
    "set.call(SetBoolRequest(True))",
    "set()",
    "set(1)",
    "set(None)",
    "set(True, False)",
    "set(True, data=False)",
    "set(other=True)",
    "set(TriggerRequest())",
    "set(request=SetBoolRequest(True))",
    "empty()",
    "empty(1)",
    "empty(x=1)",
    "empty(TriggerRequest())",
    "trigger()",
    "trigger(TriggerRequest())",
    "trigger(SetBoolRequest(True))",
    "type(set(True)).__name__",
    "type(empty()).__name__",
):
    attempt(text, names)
