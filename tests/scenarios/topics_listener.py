"""A SubscribeListener is told who comes, can greet it, and is told who goes."""

import rospy
from scenario import begin, block, say
from std_msgs.msg import String


class Listener(rospy.SubscribeListener):
    def peer_subscribe(self, topic_name, topic_publish, peer_publish):
        say("comes", topic_name)
        peer_publish(String("welcome"))
        topic_publish(String("somebody has come"))

    def peer_unsubscribe(self, topic_name, num_peers):
        say("goes", topic_name, num_peers)


begin("topics_listener")
publisher = rospy.Publisher("~a", String, Listener(), queue_size=10)
block(1)
rospy.Subscriber("~a", String, lambda message: say("got", message.data))
block(1)
publisher.publish("word")
block(0.5)
publisher.unregister()
block(0.5)
say("end")
