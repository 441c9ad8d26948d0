"""Names, classes and sizes that no Publisher or Subscriber takes."""

from scenario import attempt, begin
from std_msgs.msg import UInt32

begin("topics_constructor_errors")
for text in (
    "rospy.Publisher('', UInt32, queue_size=1)",
    "rospy.Publisher(5, UInt32, queue_size=1)",
    "rospy.Publisher('a', None, queue_size=1)",
    "rospy.Publisher('a', UInt32(), queue_size=1)",
    "rospy.Publisher('a', 'UInt32', queue_size=1)",
    "rospy.Publisher('a', str, queue_size=1)",
    "rospy.Subscriber('~b', UInt32, queue_size=0)",
    "rospy.Subscriber('~b', UInt32, queue_size='a')",
    "rospy.Subscriber('~b', UInt32, queue_size=1.5)",
    "rospy.Subscriber('~b', UInt32, queue_size=-1).impl.queue_size",
    "rospy.AnyMsg(1)",
):
    attempt(text, {"UInt32": UInt32})
