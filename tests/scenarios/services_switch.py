"""The usual node: a service switches off and on what a timer publishes."""

import rospy
from scenario import P, begin, block, end_after, mark, say
from std_msgs.msg import UInt32
from std_srvs.srv import SetBool, SetBoolResponse


class Switched:
    def __init__(self):
        self.on = True
        self.count = 0
        self.publisher = rospy.Publisher("~count", UInt32, queue_size=10)
        self.service = rospy.Service("~switch", SetBool, self.switch)
        self.timer = rospy.Timer(rospy.Duration(P), self.tick)

    def switch(self, request):
        changed = self.on != request.data
        self.on = request.data
        return SetBoolResponse(success=changed, message="on" if self.on else "off")

    def tick(self, event):
        if self.on:
            self.count += 1
            self.publisher.publish(self.count)


begin("services_switch")
node = Switched()
rospy.Subscriber("~count", UInt32, lambda message: mark(f"count_{message.data}"))
rospy.wait_for_service("~switch")
switch = rospy.ServiceProxy("~switch", SetBool)
block(2.5)
say(switch(False).message)
block(2)
say(switch(False).message)
say(switch(True).message)
end_after(2)
