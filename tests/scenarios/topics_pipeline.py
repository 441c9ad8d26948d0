"""Callbacks that publish: a message goes through three stages of one node."""

import rospy
from scenario import begin, block, mark, say
from std_msgs.msg import UInt32


def stage(number):
    def callback(message):
        say("stage", number, message.data)
        block(0.5)
        publishers[number + 1].publish(message.data + 1)

    return callback


def last(message):
    say("end", message.data)
    mark("end_of_line")


begin("topics_pipeline")
publishers = [rospy.Publisher("~stage" + str(number), UInt32, queue_size=10) for number in range(4)]
for number in range(3):
    rospy.Subscriber("~stage" + str(number), UInt32, stage(number))
rospy.Subscriber("~stage3", UInt32, last)
block(1)
publishers[0].publish(10)
block(0.7)
publishers[0].publish(20)
block(3)
