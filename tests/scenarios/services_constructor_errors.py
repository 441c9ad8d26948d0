"""Names and classes that no Service or ServiceProxy takes."""

import warnings

from scenario import attempt, begin
from std_msgs.msg import String
from std_srvs.srv import Trigger, TriggerRequest

begin("services_constructor_errors")
warnings.simplefilter("error", UserWarning)
for text in (
    "rospy.Service('', Trigger, print)",
    "rospy.Service(None, Trigger, print)",
    "rospy.Service(5, Trigger, print)",
    "rospy.Service('~a b', Trigger, print)",
    "rospy.Service('~a', None, print)",
    "rospy.Service('~a', String, print)",
    "rospy.Service('~a', TriggerRequest, print)",
    "rospy.Service('~a', 'std_srvs/Trigger', print)",
    "rospy.Service('~a', Trigger)",
    "rospy.Service('~ok', Trigger, None).handler",
    "rospy.Service('~size', Trigger, print, buff_size=10).buff_size",
    "rospy.ServiceProxy('', Trigger).resolved_name",
    "rospy.ServiceProxy(None, Trigger).resolved_name",
    "rospy.ServiceProxy(5, Trigger).resolved_name",
    "rospy.ServiceProxy('~a b', Trigger).resolved_name",
    "rospy.ServiceProxy('~a', None)",
    "rospy.ServiceProxy('~a', String)",
    "rospy.ServiceProxy('~a', 'std_srvs/Trigger')",
    "rospy.ServiceProxy('~a')",
    "rospy.ServiceProxy('~ok', Trigger)()",
    "rospy.ServiceProxy('', Trigger)()",
    "rospy.ServiceProxy('~a', Trigger).service_class is Trigger",
    "rospy.ServiceProxy('~a', Trigger).request_class.__name__",
    "rospy.ServiceProxy('~a', Trigger).response_class.__name__",
):
    attempt(text, {"Trigger": Trigger, "TriggerRequest": TriggerRequest, "String": String})
