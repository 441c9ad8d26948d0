"""A request that cannot be sent is an error in the caller; its service waited for it, and says so."""

import gc

import rospy
from nav_msgs.srv import GetPlan, LoadMap
from scenario import begin, block, say
from std_srvs.srv import SetBool

begin("services_bad_requests")
rospy.Service("~plan", GetPlan, print)
rospy.Service("~load", LoadMap, print)
rospy.Service("~set", SetBool, lambda request: (True, ""))
names = {
    "plan": rospy.ServiceProxy("~plan", GetPlan),
    "load": rospy.ServiceProxy("~load", LoadMap),
    "set_to": rospy.ServiceProxy("~set", SetBool),
    "nobody": rospy.ServiceProxy("~nobody", SetBool),
}
gc.freeze()  # what is collected below is little
for text in (
    "set_to('')",
    "set_to([])",
    "set_to([True])",
    "load(5)",
    "plan(tolerance='a')",
    "plan(1, 2, 3)",
    "nobody('')",
    "set_to(True)",
):
    try:
        result = eval(text, names)
    except Exception as error:
        result = f"{type(error).__name__}: {error}"
    gc.collect()  # which closes the connection
    block(0.2)
    say(text, "->", result)
