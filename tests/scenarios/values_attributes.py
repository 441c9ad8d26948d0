"""What a node keeps on its publishers, subscribers, services and timers, under names of its own."""

import rospy
from scenario import say
from std_msgs.msg import String
from std_srvs.srv import Trigger, TriggerResponse

NAMES = "node name end ends made world topics services peers messages count queue last state pending clock".split()

rospy.init_node("values_attributes")
for name in NAMES:
    publisher = rospy.Publisher("chatter", String, queue_size=1)
    subscriber = rospy.Subscriber("chatter", String, lambda message: None)
    service = rospy.Service("do_" + name, Trigger, lambda request: TriggerResponse(True, "done"))
    proxy = rospy.ServiceProxy("do_" + name, Trigger)
    timer = rospy.Timer(rospy.Duration(0.01), lambda event: None)
    for part in (publisher, subscriber, service, proxy, timer):
        try:
            setattr(part, name, 5)
        except Exception as error:
            say(name, type(part).__name__, type(error).__name__, error)
    try:
        publisher.publish("x")
        say(name, proxy().message)
        rospy.sleep(0.05)
        say(name, timer.is_alive())
        timer.shutdown()
        service.shutdown()
        subscriber.unregister()
        publisher.unregister()
    except Exception as error:
        say(name, type(error).__name__, error)
