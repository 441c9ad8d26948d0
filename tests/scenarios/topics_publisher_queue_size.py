"""A publisher's queue_size drops nothing of what does not come in bursts, however slow the callback is."""

import rospy
from scenario import P, begin, block, end_after, mark, say
from std_msgs.msg import UInt32


def slow(message):
    say("got", message.data)
    mark("called")
    block(1.6)


begin("topics_publisher_queue_size")
publisher = rospy.Publisher("~a", UInt32, queue_size=rospy.get_param("~queue_size"))
rospy.Subscriber("~a", UInt32, slow)
block(1)
for number in range(5):
    publisher.publish(number)
    rospy.sleep(P / 2)
say("published")
end_after(7)
