"""A service that has shut down still answers those who are connected."""

import rospy
from scenario import attempt, begin
from std_srvs.srv import Trigger

begin("services_persistent_gone")
service = rospy.Service("~a", Trigger, lambda request: (True, "the first"))
names = {
    "early": rospy.ServiceProxy("~a", Trigger, persistent=True),
    "late": rospy.ServiceProxy("~a", Trigger, persistent=True),
}
attempt("early().message", names)
service.shutdown("enough")
attempt("early().message", names)
attempt("late().message", names)
rospy.Service("~a", Trigger, lambda request: (True, "the second"))
attempt("early().message", names)
attempt("late().message", names)
rospy.signal_shutdown("enough")
attempt("early().message", names)
attempt("late().message", names)
