"""Values that no message of the type can have: each is an error, and breaks its connection."""

import rospy
from geometry_msgs.msg import Point, Twist
from scenario import attempt, begin, block
from std_msgs.msg import Bool, Float64, Float64MultiArray, String, UInt8MultiArray, UInt32  # noqa: F401, by their names

VALUES = (
    ("UInt32", ("3.0", "-1", "'a'", "b'a'", "[1]", "2**32")),
    ("Float64", ("'1'", "[]")),
    ("Bool", ("'x'",)),
    ("String", ("5", "b'a'")),
    ("Twist", ("Point(), Point()", "Twist(linear=Point('a', 0, 0))")),
    ("Float64MultiArray", ("None, 5", "None, 'ab'", "None, ['a']")),
    ("UInt8MultiArray", ("None, [256]",)),
)

begin("topics_publish_values")
made = []
for name, texts in VALUES:
    for text in texts:
        topic = "~" + "abcdefghijklmnopqrstuvw"[len(made)]
        publisher = rospy.Publisher(topic, globals()[name], queue_size=10)
        rospy.Subscriber(topic, globals()[name])
        made.append((publisher, name, text))
block(2)
for publisher, name, text in made:
    attempt("publisher.publish(" + text + ")", {"publisher": publisher, "Point": Point, "Twist": Twist})
    print(name, flush=True)
