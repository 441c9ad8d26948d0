"""Methods, lambdas, partials and callable objects can be a timer's callback."""

import functools

import rospy
from scenario import P, begin, end_after, mark


class Node:
    def method(self, event):
        mark("method")

    def __call__(self, event):
        mark("object")


def with_name(name, event):
    mark(name)


begin("callable_callbacks")
node = Node()
rospy.Timer(rospy.Duration(P), node.method)
rospy.Timer(rospy.Duration(P), node)
rospy.Timer(rospy.Duration(P), functools.partial(with_name, "partial"))
rospy.Timer(period=rospy.Duration(P), callback=lambda event: mark("lambda"), oneshot=True, reset=False)
end_after(3.5)
