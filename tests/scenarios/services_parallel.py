"""Each call is handled in a thread of its own: the handlers of several callers overlap."""

import threading

import rospy
from scenario import P, begin, block, end_after, mark
from std_srvs.srv import SetBool


def handle(request):
    mark("begin")
    block(2)
    mark("finish")
    return request.data, ""


def call(number):
    service(number % 2 == 0)
    mark("answered")


begin("services_parallel")
rospy.Service("~a", SetBool, handle)
service = rospy.ServiceProxy("~a", SetBool)
for number in range(3):
    threading.Thread(target=call, args=(number,), daemon=True).start()
    rospy.sleep(0.6 * P)
end_after(4)
