"""A proxy of another type than the service's is refused."""

import rospy
from nav_msgs.srv import LoadMap
from scenario import attempt, begin
from std_srvs.srv import Empty, SetBool, Trigger

begin("services_mismatch")
rospy.Service("~a", SetBool, lambda request: (True, ""))
names = {
    "trigger": rospy.ServiceProxy("~a", Trigger),
    "empty": rospy.ServiceProxy("~a", Empty, persistent=True),
    "load": rospy.ServiceProxy("~a", LoadMap),
    "right": rospy.ServiceProxy("~a", SetBool),
}
for text in ("trigger()", "empty()", "empty()", "load('a map')", "right(True)", "trigger.wait_for_service(1)"):
    attempt(text, names)
