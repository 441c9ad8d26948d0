"""A neighbour module with a queue and a worker of its own, made when it is imported."""

import rospy
from robot import motor
from scenario import P, begin, block, mark, say


def callback(event):
    motor.command(len(motor.done) + 1)
    mark("command")


begin("threads_neighbour")
rospy.on_shutdown(motor.stop)
timer = rospy.Timer(rospy.Duration(P), callback)
block(4.6)
timer.shutdown()
rospy.signal_shutdown("enough")
say(motor.done, motor.worker.is_alive())
