"""wait_for_service() waits on the wall clock, even where /clock tells the time; a handler's sleep is on ROS time."""

import threading
import time

import rospy
from rosgraph_msgs.msg import Clock
from scenario import P, attempt, begin, say
from std_srvs.srv import Trigger


def handle(request):
    rospy.sleep(2)
    return True, f"{rospy.get_time()}"


def tell():
    for second in range(1, 9):
        time.sleep(P)
        clock.publish(rospy.Time(second))


rospy.set_param("/use_sim_time", True)
begin("topics_clock_services")
clock = rospy.Publisher("/clock", Clock, queue_size=1)
rospy.Service("~a", Trigger, handle)
attempt("rospy.wait_for_service('~b', 1.1 * P)", {"P": P})
say(rospy.get_time())
threading.Thread(target=tell, daemon=True).start()
time.sleep(1.5 * P)
attempt("proxy()", {"proxy": rospy.ServiceProxy("~a", Trigger)})
