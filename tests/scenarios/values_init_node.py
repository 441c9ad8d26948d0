"""What init_node accepts, and what it says otherwise."""

import rospy
from scenario import attempt

for text in ["rospy.get_name()", "rospy.get_namespace()", "rospy.get_caller_id()", "rospy.resolve_name('a')"]:
    attempt(text)
for text in [
    "rospy.init_node('')",
    "rospy.init_node('/a')",
    "rospy.init_node('a/b')",
    "rospy.init_node()",
    "rospy.init_node(None)",
]:
    attempt(text)
rospy.init_node("values_init_node")
attempt("rospy.init_node('values_init_node')")
attempt("rospy.get_name()")
for text in ["rospy.init_node('other')", "rospy.init_node('values_init_node', anonymous=True)"]:
    try:
        exec(text)
    except rospy.ROSException as error:
        print(str(error).split(":")[0])
