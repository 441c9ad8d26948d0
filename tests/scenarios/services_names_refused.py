"""Names that the master refuses are told once, and the next name is none the worse. What the classes are called."""

import warnings

import rospy
from scenario import attempt
from std_msgs.msg import String
from std_srvs.srv import Empty

warnings.simplefilter("ignore")  # of the same names; where the line is differs
rospy.init_node("services_names_refused")
for name in ("two words", "a:b", "/", "good", "/good/"):
    names = {"name": name, "Empty": Empty, "String": String}
    for kind in ("Service(name, Empty, print)", "Publisher(name, String, queue_size=1)", "Subscriber(name, String)"):
        attempt(f"rospy.{kind}.resolved_name", names)
for kind in (rospy.Publisher, rospy.Rate, rospy.Service, rospy.ServiceProxy, rospy.Subscriber, rospy.Timer):
    print(kind, flush=True)
