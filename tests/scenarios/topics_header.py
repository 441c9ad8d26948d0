"""publish() counts in the header's seq, in the sender's own object, and only what it sends."""

import rospy
from scenario import begin, block, say
from sensor_msgs.msg import Imu
from std_msgs.msg import Header

begin("topics_header")
publisher = rospy.Publisher("~a", Imu, queue_size=10)
message = Imu(header=Header(frame_id="base", seq=77))
publisher.publish(message)
say("unconnected", message.header.seq)
rospy.Subscriber("~a", Imu, lambda message: say("got", message.header.seq, message.header.frame_id))
block(1)
for _ in range(3):
    publisher.publish(message)
    block(0.3)
    say("sent", message.header.seq)
say(rospy.Header is Header)
