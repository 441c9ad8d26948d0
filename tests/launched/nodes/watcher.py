#!/usr/bin/env python3
"""Publishes for as long as there is a listener, and tells of who comes and goes."""

import common
import rospy
from std_msgs.msg import UInt32


class Listener(rospy.SubscribeListener):
    def peer_subscribe(self, topic_name, topic_publish, peer_publish):
        common.say("subscribed", topic_name)
        peer_publish(UInt32(7))

    def peer_unsubscribe(self, topic_name, num_peers):
        common.say("unsubscribed", topic_name, num_peers)


common.begin("watcher")
publisher = rospy.Publisher("chatter", UInt32, subscriber_listener=Listener(), queue_size=10)
rospy.spin()
