"""What is warned of: no queue_size, and a name that is none."""

import warnings

import rospy
from scenario import begin, say
from std_msgs.msg import UInt32

begin("topics_warnings")
for name, options in (("~a", {}), ("~b", {"queue_size": None}), ("~c-d", {"queue_size": 1}), ("~e", {"queue_size": 0})):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        rospy.Publisher(name, UInt32, **options)
    for warning in caught:
        say(name, warning.category.__name__, warning.message)
