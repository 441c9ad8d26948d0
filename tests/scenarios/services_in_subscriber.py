"""A subscriber's callback calls a service of the same node; messages wait meanwhile."""

import rospy
from scenario import P, begin, block, end_after, mark, say
from std_msgs.msg import UInt32
from std_srvs.srv import SetBool


def handle(request):
    block(1.5)
    return request.data, "odd" if request.data else "even"


def receive(message):
    mark(f"receive_{message.data}")
    answer = service(message.data % 2 == 1)
    mark(f"answered_{message.data}")
    say(answer.success, answer.message)


begin("services_in_subscriber")
rospy.Service("~is_odd", SetBool, handle)
service = rospy.ServiceProxy("~is_odd", SetBool)
publisher = rospy.Publisher("~a", UInt32, queue_size=10)
rospy.Subscriber("~a", UInt32, receive)
block(1)
for number in range(3):
    publisher.publish(number)
    rospy.sleep(P)
end_after(4)
