"""A controller that stops when its sensor is silent for more than a period and three quarters."""

import rospy
from geometry_msgs.msg import Twist
from scenario import P, begin, block, end_after, mark, say
from sensor_msgs.msg import Range


class Controller:
    def __init__(self):
        self.last = None
        self.command = rospy.Publisher("~command", Twist, queue_size=1)
        rospy.Subscriber("~range", Range, self.heard, queue_size=1)
        rospy.Timer(rospy.Duration(P), self.control)

    def heard(self, message):
        self.last = rospy.Time.now()

    def control(self, event):
        command = Twist()
        if self.last is not None and rospy.Time.now() - self.last < rospy.Duration(1.75 * P):
            command.linear.x = 0.5
        self.command.publish(command)


begin("topics_silent_sensor")
rospy.Subscriber("~command", Twist, lambda message: (say("speed", message.linear.x), mark("command")))
Controller()
sensor = rospy.Publisher("~range", Range, queue_size=1)
block(1.6)
for _ in range(3):
    sensor.publish(Range(range=1.0))
    block(1)
end_after(3)
