"""The exceptions: their bases, their texts, and that handlers of either base catch them."""

import rospy

for name in sorted(vars(rospy.exceptions)):
    kind = getattr(rospy.exceptions, name)
    if isinstance(kind, type) and issubclass(kind, Exception):
        print(name, [base.__name__ for base in kind.__mro__], hasattr(rospy, name))

error = rospy.ROSTimeMovedBackwardsException(1.5)
print(error, error.time, error.args)
for base in (rospy.ROSException, KeyboardInterrupt, rospy.ROSInterruptException):
    try:
        raise rospy.ROSInterruptException("text")
    except base as caught:
        print(base.__name__, caught)
