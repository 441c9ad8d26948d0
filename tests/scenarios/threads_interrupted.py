"""A KeyboardInterrupt or a ROSInterruptException in a thread is an exception like another: with a traceback."""

import threading

import rospy
from scenario import begin, say, until


def fail(error, when):
    until(when)
    raise error


begin("threads_interrupted")
errors = (rospy.ROSInterruptException("ROS shutdown request"), KeyboardInterrupt(), GeneratorExit())
for when, error in enumerate(errors):
    threading.Thread(target=fail, args=(error, when)).start()
until(4)
say("is_shutdown", rospy.is_shutdown())
